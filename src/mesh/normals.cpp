// Face normals, groups, weighted sums, unit vectors: four passes over flat arrays.
#include "mesh/normals.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "math/trig.hpp"
#include "mesh/polygon.hpp"
#include "mesh/triangle_normals.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

struct FacePlanes {
  std::vector<Vec3d> normals;
  std::vector<double> areas;
  std::vector<std::uint8_t> is_sliver;
};

FacePlanes planes_of(const Faces& faces, int threads) {
  FacePlanes planes;
  resize_big(planes.normals, faces.size());
  resize_big(planes.areas, faces.size());
  resize_big(planes.is_sliver, faces.size());
  parallel_slices(faces.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      const std::uint32_t begin = faces.begin[f];
      const PolygonPlane plane =
          plane_of(faces.begin[f + 1] - begin, [&](std::size_t i) { return faces.positions[faces.corner_position[begin + i]]; });
      planes.normals[f] = plane.normal;
      planes.areas[f] = plane.area;
      planes.is_sliver[f] = plane.is_sliver ? 1 : 0;
    }
  });
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

struct Sum {
  Vec3d normal;
  double weight = 0;  ///< of all summands; negative where they are slivers, which nothing but slivers may join

  /// The unit normal, or 0 where the faces cancel.
  [[nodiscard]] Vec3f unit() const {
    const double size = length(normal);
    if (size > kCancelled * std::abs(weight)) {
      return vec_cast<float>(Vec3d{normal.x / size, normal.y / size, normal.z / size});
    }
    return {};
  }
};

/// The sums of a range of groups: as in triangle_normals.cpp every thread has one, and looks at all faces in their order.
class NormalSums {
 public:
  NormalSums(const Faces& faces, const FacePlanes& planes, const SmoothingGroups& groups, VertexNormals weights, std::uint32_t begin,
             std::uint32_t end)
      : faces_(faces), planes_(planes), groups_(groups), weights_(weights), begin_(begin), sums_(end - begin), last_face_(end - begin, kNone) {
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

  [[nodiscard]] const std::vector<Sum>& sums() const { return sums_; }

 private:
  void add(std::uint32_t f, bool as_sliver) {
    const Vec3d& normal = planes_.normals[f];
    for (std::uint32_t c = faces_.begin[f]; c < faces_.begin[f + 1]; ++c) {
      const std::uint32_t group = groups_.of_corner[c] - begin_;
      if (group >= sums_.size()) {
        continue;
      }
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
  std::uint32_t begin_;
  std::vector<Sum> sums_;
  std::vector<std::uint32_t> last_face_;
};

/// The triangles of faces that are nothing else, or nothing.
std::span<const std::array<std::uint32_t, 3>> as_triangles(std::span<const std::uint32_t> corners) {
  static_assert(sizeof(std::array<std::uint32_t, 3>) == 3 * sizeof(std::uint32_t));
  return {reinterpret_cast<const std::array<std::uint32_t, 3>*>(corners.data()), corners.size() / 3};
}

bool has_only_triangles(const Faces& faces) {
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    if (faces.begin[f + 1] - faces.begin[f] != 3) {
      return false;
    }
  }
  return true;
}

std::vector<Vec3f> group_normals(const Faces& faces, const FacePlanes& planes, const SmoothingGroups& groups, VertexNormals weights,
                                 int threads) {
  if (has_only_triangles(faces)) {
    return make_triangle_normals({faces.positions, as_triangles(faces.corner_position), as_triangles(groups.of_corner), groups.count}, weights,
                                 threads)
        .normals;
  }
  std::vector<Vec3f> normals;
  resize_big(normals, groups.count);
  const std::size_t ranges = faces.corner_position.size() < kSmallestSlice ? 1 : thread_count(threads);
  parallel_for(ranges, threads, [&](std::size_t r) {
    const auto begin = static_cast<std::uint32_t>(std::size_t{groups.count} * r / ranges);
    const auto end = static_cast<std::uint32_t>(std::size_t{groups.count} * (r + 1) / ranges);
    const NormalSums range(faces, planes, groups, weights, begin, end);
    std::transform(range.sums().begin(), range.sums().end(), normals.data() + begin, [](const Sum& sum) { return sum.unit(); });
  });
  return normals;
}

}  // namespace

CornerNormals make_normals(const Faces& faces, const NormalOptions& options, int threads) {
  const FacePlanes planes = planes_of(faces, threads);
  SmoothingGroups groups = smoothing_groups(faces, planes.normals, planes.is_sliver, options.crease_deg, threads);
  CornerNormals result;
  result.normals = group_normals(faces, planes, groups, options.weights, threads);
  result.corner_normal = std::move(groups.of_corner);
  std::atomic<bool> has_zero = false;
  parallel_slices(result.corner_normal.size(), threads, [&](std::size_t begin, std::size_t end) {
    bool found = false;
    for (std::size_t c = begin; c < end; ++c) {
      found |= result.normals[result.corner_normal[c]] == Vec3f{};
    }
    if (found) {
      has_zero = true;
    }
  });
  for (std::uint32_t f = 0; has_zero && f < faces.size(); ++f) {
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
