// MikkTSpace in its own steps: weld corners of equal position, normal and texture coordinates; give each triangle its directions of u and v;
// gather, around each welded vertex, triangles that are joined by edges and agree in orientation; average by angle in the vertex's plane.
#include "mesh/tangents.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "math/trig.hpp"
#include "mesh/index_table.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;
constexpr double kSmallest = 0x1p-126;  // the smallest normal float: MikkTSpace's own idea of zero

using Tangent = std::array<float, 4>;
constexpr Tangent kNoTangent{1, 0, 0, 1};

Vec3d unit_or_zero(const Vec3d& v) {
  const double size = length(v);
  return size > kSmallest ? v * (1 / size) : Vec3d{};
}

// The part of v in the plane of the unit normal n, unit.
Vec3d in_plane(const Vec3d& v, const Vec3d& n) {
  return unit_or_zero(v - n * dot(n, v));
}

struct Triangle {
  Vec3d along_u{};                                             // where u grows, unit; 0 where there is none
  std::array<std::uint32_t, 3> neighbor{kNone, kNone, kNone};  // across the edge from corner i to the next
  std::array<std::uint32_t, 3> group{kNone, kNone, kNone};     // of corner i
  bool is_preserving = false;                                  // u, v turn as the triangle does
  bool joins_any = true;                                       // has no area in texture coordinates: joins groups of either orientation
  bool is_degenerate = false;                                  // two corners at one place: no part of any group
};

class TangentMaker {
 public:
  TangentMaker(const Mesh& mesh, const TangentOptions& options)
      : mesh_(mesh), uvs_(options.uv_set == 0 ? mesh.uvs : mesh.uvs1), matrix_(options.uv_matrix), triangles_(mesh.triangles.size()) {}

  Mesh make() {
    weld();
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      measure(t);
    }
    find_neighbors();
    corner_tangents_.assign(triangles_.size(), {kNoTangent, kNoTangent, kNoTangent});
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (!triangles_[t].is_degenerate && !triangles_[t].joins_any && triangles_[t].group[i] == kNone) {
          gather_group(t, i);
          average_group();
        }
      }
    }
    lend_to_degenerates();
    return split();
  }

 private:
  // Vertices that nothing but colour tells apart are one.
  void weld() {
    welded_.resize(mesh_.positions.size());
    IndexTable table(mesh_.positions.size());
    const auto same = [](const Vec3f& a, const Vec3f& b) {
      return value_bits(a.x) == value_bits(b.x) && value_bits(a.y) == value_bits(b.y) && value_bits(a.z) == value_bits(b.z);
    };
    for (std::uint32_t v = 0; v < welded_.size(); ++v) {
      const std::uint64_t uv = std::uint64_t{value_bits(uvs_[v].x)} << 32U | value_bits(uvs_[v].y);
      const std::uint64_t hash = mix(mix(mix(0, mesh_.positions[v]), mesh_.normals[v]), uv);
      welded_[v] = table.find_or_insert(hash, v, [&](std::uint32_t other) {
        return same(mesh_.positions[v], mesh_.positions[other]) && same(mesh_.normals[v], mesh_.normals[other]) &&
               value_bits(uvs_[v].x) == value_bits(uvs_[other].x) && value_bits(uvs_[v].y) == value_bits(uvs_[other].y);
      });
    }
  }

  [[nodiscard]] std::uint32_t corner(std::uint32_t t, std::size_t i) const { return welded_[mesh_.triangles[t][i]]; }
  [[nodiscard]] Vec3d position(std::uint32_t t, std::size_t i) const { return vec_cast<double>(mesh_.positions[mesh_.triangles[t][i]]); }
  // In the picture, both axes as mathematics has them: s to the right, t up.
  [[nodiscard]] Vec2<double> picture_uv(std::uint32_t t, std::size_t i) const {
    const Vec2f& uv = uvs_[mesh_.triangles[t][i]];
    const auto u = static_cast<double>(uv.x);
    const auto v = static_cast<double>(uv.y);
    return {static_cast<double>(matrix_[0]) * u + static_cast<double>(matrix_[1]) * v,
            -(static_cast<double>(matrix_[2]) * u + static_cast<double>(matrix_[3]) * v)};
  }

  void measure(std::uint32_t t) {
    Triangle& triangle = triangles_[t];
    const auto& p = mesh_.positions;
    const auto& [a, b, c] = mesh_.triangles[t];
    triangle.is_degenerate = p[a] == p[b] || p[b] == p[c] || p[c] == p[a];
    const Vec3d d1 = position(t, 1) - position(t, 0), d2 = position(t, 2) - position(t, 0);
    const Vec2<double> uv0 = picture_uv(t, 0), uv1 = picture_uv(t, 1), uv2 = picture_uv(t, 2);
    const double s1 = uv1.x - uv0.x, t1 = uv1.y - uv0.y;
    const double s2 = uv2.x - uv0.x, t2 = uv2.y - uv0.y;
    const double area2 = s1 * t2 - t1 * s2;
    triangle.is_preserving = area2 > 0;
    if (!(std::abs(area2) > kSmallest) || !std::isfinite(area2)) {
      return;
    }
    const double sign = triangle.is_preserving ? 1 : -1;
    const Vec3d along_u = (d1 * t2 - d2 * t1) * sign;
    const Vec3d along_v = (d2 * s1 - d1 * s2) * sign;
    triangle.along_u = unit_or_zero(along_u);
    triangle.joins_any = !(length(along_u) / std::abs(area2) > kSmallest && length(along_v) / std::abs(area2) > kSmallest);
  }

  // Triangles that pass a welded edge in opposite directions are neighbours; of more than two on one edge the first with the first.
  void find_neighbors() {
    struct Edge {
      std::uint32_t low, high;
      bool is_forward;
      std::uint32_t triangle, edge;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3 && !triangles_[t].is_degenerate; ++i) {
        const std::uint32_t a = corner(t, i), b = corner(t, (i + 1) % 3);
        edges.push_back({std::min(a, b), std::max(a, b), a < b, t, i});
      }
    }
    const auto key = [](const Edge& e) { return std::tuple(e.low, e.high, e.is_forward, e.triangle, e.edge); };
    std::sort(edges.begin(), edges.end(), [&](const Edge& a, const Edge& b) { return key(a) < key(b); });
    for (std::size_t begin = 0; begin < edges.size();) {
      const auto is_other = [&](const Edge& e) { return e.low != edges[begin].low || e.high != edges[begin].high; };
      const auto first = edges.begin() + static_cast<std::ptrdiff_t>(begin);
      const auto end = std::find_if(first, edges.end(), is_other);
      auto backward = first;
      auto forward = std::find_if(first, end, [](const Edge& e) { return e.is_forward; });
      for (const auto middle = forward; backward != middle && forward != end; ++backward, ++forward) {
        triangles_[backward->triangle].neighbor[backward->edge] = forward->triangle;
        triangles_[forward->triangle].neighbor[forward->edge] = backward->triangle;
      }
      begin = static_cast<std::size_t>(end - edges.begin());
    }
  }

  // All triangles around the corner's vertex that can be reached over edges without a change of orientation.
  void gather_group(std::uint32_t first, std::size_t first_corner) {
    const std::uint32_t vertex = corner(first, first_corner);
    const bool is_preserving = triangles_[first].is_preserving;
    const std::uint32_t group = group_count_++;
    members_.clear();
    reached_.assign(1, first);
    while (!reached_.empty()) {
      const std::uint32_t t = reached_.back();
      reached_.pop_back();
      Triangle& triangle = triangles_[t];
      const std::size_t i = corner(t, 0) == vertex ? 0 : (corner(t, 1) == vertex ? 1 : 2);
      if (triangle.group[i] != kNone) {
        continue;
      }
      if (triangle.joins_any && triangle.group == std::array{kNone, kNone, kNone}) {
        triangle.is_preserving = is_preserving;
      }
      if (triangle.is_preserving != is_preserving) {
        continue;
      }
      triangle.group[i] = group;
      members_.push_back({t, i});
      for (const std::uint32_t next : {triangle.neighbor[(i + 2) % 3], triangle.neighbor[i]}) {
        if (next != kNone) {
          reached_.push_back(next);
        }
      }
    }
  }

  // The members' directions of u in the vertex's plane, each weighted by its angle there.
  void average_group() {
    const Member& first = members_.front();
    const Vec3d n = vec_cast<double>(mesh_.normals[mesh_.triangles[first.triangle][first.corner]]);
    parts_.clear();
    for (const Member& m : members_) {
      const Triangle& triangle = triangles_[m.triangle];
      if (triangle.joins_any) {
        continue;
      }
      const Vec3d p = position(m.triangle, m.corner);
      const Vec3d before = in_plane(position(m.triangle, (m.corner + 2) % 3) - p, n);
      const Vec3d after = in_plane(position(m.triangle, (m.corner + 1) % 3) - p, n);
      const Vec3d part = in_plane(triangle.along_u, n) * angle_between(before, after);
      if (is_finite(part)) {
        parts_.push_back(part);
      }
    }
    std::sort(parts_.begin(), parts_.end(), [](const Vec3d& a, const Vec3d& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    Vec3d sum{};
    for (const Vec3d& part : parts_) {
      sum += part;
    }
    const Vec3d tangent = unit_or_zero(sum);
    if (tangent == Vec3d{}) {
      return;
    }
    const float sign = triangles_[first.triangle].is_preserving ? 1.0F : -1.0F;
    for (const Member& m : members_) {
      corner_tangents_[m.triangle][m.corner] = {static_cast<float>(tangent.x), static_cast<float>(tangent.y), static_cast<float>(tangent.z),
                                                sign};
    }
  }

  // A triangle with two corners at one place takes, corner by corner, what the first sound triangle there has.
  void lend_to_degenerates() {
    std::vector<std::uint32_t> lender(mesh_.positions.size(), kNone);  // 3 t + i
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3 && !triangles_[t].is_degenerate; ++i) {
        if (triangles_[t].group[i] != kNone && lender[corner(t, i)] == kNone) {
          lender[corner(t, i)] = 3 * t + i;
        }
      }
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (std::uint32_t i = 0; i < 3 && triangles_[t].is_degenerate; ++i) {
        if (const std::uint32_t from = lender[corner(t, i)]; from != kNone) {
          corner_tangents_[t][i] = corner_tangents_[from / 3][from % 3];
        }
      }
    }
  }

  // One vertex for each tangent that its corners have.
  [[nodiscard]] Mesh split() const {
    Mesh result = mesh_;
    const std::size_t stated = mesh_.positions.size();
    result.tangents.assign(stated, kNoTangent);
    std::vector<bool> is_used(stated, false);
    std::vector<std::uint32_t> origin(stated);
    IndexTable copies;
    for (std::size_t t = 0; t < result.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::uint32_t& v = result.triangles[t][i];
        const Tangent& tangent = corner_tangents_[t][i];
        if (!is_used[v]) {
          is_used[v] = true;
          result.tangents[v] = tangent;
          continue;
        }
        if (result.tangents[v] == tangent) {
          continue;
        }
        const std::uint64_t hash = mix(mix(mix(v, Vec3f{tangent[0], tangent[1], tangent[2]}), value_bits(tangent[3])), 0);
        const auto fresh = static_cast<std::uint32_t>(result.positions.size());
        const std::uint32_t stated_vertex = v;
        v = copies.find_or_insert(hash, fresh,
                                  [&](std::uint32_t copy) { return origin[copy] == stated_vertex && result.tangents[copy] == tangent; });
        if (v == fresh) {
          origin.push_back(stated_vertex);
          copy_vertex(stated_vertex, tangent, result);
        }
      }
    }
    return result;
  }

  static void copy_vertex(std::uint32_t v, const Tangent& tangent, Mesh& mesh) {
    const auto again = [v](auto& list) {
      if (!list.empty()) {
        const auto value = list[v];
        list.push_back(value);
      }
    };
    again(mesh.positions);
    again(mesh.normals);
    again(mesh.uvs);
    again(mesh.uvs1);
    again(mesh.colors);
    again(mesh.alphas);
    mesh.tangents.push_back(tangent);
  }

  struct Member {
    std::uint32_t triangle;
    std::size_t corner;
  };

  const Mesh& mesh_;
  const std::vector<Vec2f>& uvs_;
  std::array<float, 4> matrix_;
  std::vector<std::uint32_t> welded_;  // the first vertex that is the same
  std::vector<Triangle> triangles_;
  std::vector<std::array<Tangent, 3>> corner_tangents_;
  std::uint32_t group_count_ = 0;
  std::vector<Member> members_;  // of the group at hand
  std::vector<std::uint32_t> reached_;
  std::vector<Vec3d> parts_;
};

}  // namespace

Mesh with_tangents(const Mesh& mesh, const TangentOptions& options) {
  if (mesh.normals.empty() || (options.uv_set == 0 ? mesh.uvs : mesh.uvs1).empty()) {
    return mesh;
  }
  return TangentMaker(mesh, options).make();
}

}  // namespace lustro
