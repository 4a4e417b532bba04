// Face normals, groups, weighted sums, unit vectors: four passes over flat arrays.
#include "mesh/normals.hpp"

#include <cmath>
#include <numeric>

#include "math/trig.hpp"
#include "mesh/polygon.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

struct FacePlanes {
  std::vector<Vec3d> normals;
  std::vector<double> areas;
  std::vector<std::uint8_t> is_sliver;
};

FacePlanes planes_of(const Faces& faces) {
  FacePlanes planes;
  planes.normals.reserve(faces.size());
  planes.areas.reserve(faces.size());
  planes.is_sliver.reserve(faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const std::uint32_t begin = faces.begin[f];
    const PolygonPlane plane =
        plane_of(faces.begin[f + 1] - begin, [&](std::size_t i) { return faces.positions[faces.corner_position[begin + i]]; });
    planes.normals.push_back(plane.normal);
    planes.areas.push_back(plane.area);
    planes.is_sliver.push_back(plane.is_sliver ? 1 : 0);
  }
  return planes;
}

/// The angle at corner c inside its face, 0..2 pi: more than pi where the outline turns inwards.
double inner_angle(const Faces& faces, std::uint32_t f, std::uint32_t c, const Vec3d& face_normal) {
  const std::uint32_t begin = faces.begin[f];
  const std::uint32_t end = faces.begin[f + 1];
  const auto position = [&](std::uint32_t i) { return vec_cast<double>(faces.positions[faces.corner_position[i]]); };
  const Vec3d here = position(c);
  const Vec3d ahead = position(c + 1 < end ? c + 1 : begin) - here;
  const Vec3d back = position(c > begin ? c - 1 : end - 1) - here;
  const Vec3d turn = cross(ahead, back);
  if (end - begin == 3) {
    return arctangent2(length(turn), dot(ahead, back));
  }
  const double angle = arctangent2(dot(turn, face_normal), dot(ahead, back));
  return angle < 0 ? angle + 2 * kPi : angle;
}

class NormalSums {
 public:
  NormalSums(const Faces& faces, const FacePlanes& planes, const SmoothingGroups& groups, VertexNormals weights)
      : faces_(faces), planes_(planes), groups_(groups), weights_(weights), sums_(groups.count), last_face_(groups.count, kNone) {
    bool has_slivers = false;
    for (std::uint32_t f = 0; f < faces.size(); ++f) {
      if (planes.is_sliver[f] == 0) {
        add(f, false);
      } else {
        has_slivers = true;
      }
    }
    for (std::uint32_t f = 0; has_slivers && f < faces.size(); ++f) {
      if (planes.is_sliver[f] != 0) {
        add(f, true);
      }
    }
  }

  /// The unit normal of a group, or 0 where its faces cancel.
  [[nodiscard]] Vec3f unit(std::uint32_t group) const {
    const Sum& sum = sums_[group];
    const double size = length(sum.normal);
    if (size > kCancelled * std::abs(sum.weight)) {
      return vec_cast<float>(Vec3d{sum.normal.x / size, sum.normal.y / size, sum.normal.z / size});
    }
    return {};
  }

 private:
  struct Sum {
    Vec3d normal;
    double weight = 0;  ///< of all summands; negative where they are slivers, which nothing but slivers may join
  };

  void add(std::uint32_t f, bool as_sliver) {
    const Vec3d& normal = planes_.normals[f];
    for (std::uint32_t c = faces_.begin[f]; c < faces_.begin[f + 1]; ++c) {
      const std::uint32_t group = groups_.of_corner[c];
      Sum& sum = sums_[group];
      if (as_sliver && sum.weight > 0) {
        continue;
      }
      double weight = 0;
      if (weights_ == VertexNormals::angle) {
        weight = inner_angle(faces_, f, c, normal);
      } else if (last_face_[group] != f) {  // a face that touches a position twice counts once
        weight = weights_ == VertexNormals::area ? planes_.areas[f] : 1;
      }
      last_face_[group] = f;
      sum.normal += normal * weight;
      sum.weight += as_sliver ? -weight : weight;
    }
  }

  const Faces& faces_;
  const FacePlanes& planes_;
  const SmoothingGroups& groups_;
  VertexNormals weights_;
  std::vector<Sum> sums_;
  std::vector<std::uint32_t> last_face_;
};

}  // namespace

CornerNormals make_normals(const Faces& faces, const NormalOptions& options) {
  const FacePlanes planes = planes_of(faces);
  SmoothingGroups groups = smoothing_groups(faces, planes.normals, planes.is_sliver, options.crease_deg);
  CornerNormals result;
  result.normals.resize(groups.count);
  {
    const NormalSums sums(faces, planes, groups, options.weights);
    for (std::uint32_t g = 0; g < groups.count; ++g) {
      result.normals[g] = sums.unit(g);
    }
  }
  result.corner_normal = std::move(groups.of_corner);
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t c = faces.begin[f]; c < faces.begin[f + 1]; ++c) {
      if (result.normals[result.corner_normal[c]] == Vec3f{}) {
        const Vec3f own = vec_cast<float>(planes.normals[f]);
        result.corner_normal[c] = static_cast<std::uint32_t>(result.normals.size());
        result.normals.push_back(own == Vec3f{} ? Vec3f{0, 0, 1} : own);
      }
    }
  }
  return result;
}

Mesh with_vertex_normals(const Mesh& mesh, const NormalOptions& options) {
  Mesh result = mesh;
  if (!mesh.normals.empty() && !options.recompute) {
    return result;
  }
  std::vector<std::uint32_t> begin(mesh.triangles.size() + 1);
  std::vector<std::uint32_t> corner_position;
  corner_position.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    corner_position.insert(corner_position.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    begin[t + 1] = static_cast<std::uint32_t>(corner_position.size());
  }
  const CornerNormals made = make_normals({mesh.positions, begin, corner_position, {}}, options);

  // The first normal that a vertex meets stays with it; every other one gets a copy of the vertex.
  std::vector<std::uint32_t> normal_of(mesh.positions.size(), kNone);  // V, then the copies
  std::vector<std::uint32_t> vertex_with(made.normals.size(), kNone);  // no normal is shared by two vertices
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = mesh.triangles[t][k];
      const std::uint32_t normal = made.corner_normal[3 * t + k];
      if (vertex_with[normal] == kNone && normal_of[v] == kNone) {
        vertex_with[normal] = v;
        normal_of[v] = normal;
      } else if (vertex_with[normal] == kNone) {
        vertex_with[normal] = static_cast<std::uint32_t>(normal_of.size());
        normal_of.push_back(normal);
        result.positions.push_back(mesh.positions[v]);
        if (!mesh.uvs.empty()) {
          result.uvs.push_back(mesh.uvs[v]);
        }
        if (!mesh.colors.empty()) {
          result.colors.push_back(mesh.colors[v]);
        }
      }
      result.triangles[t][k] = vertex_with[normal];
    }
  }
  result.normals.resize(normal_of.size());
  for (std::size_t v = 0; v < normal_of.size(); ++v) {
    result.normals[v] = normal_of[v] == kNone ? Vec3f{0, 0, 1} : made.normals[normal_of[v]];
  }
  return result;
}

}  // namespace lustro
