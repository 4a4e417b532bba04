// Subdivision by passes over all triangles, then one pass that moves vertices. Everything is summed in the order of triangles.
#include "mesh/displace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/srgb.hpp"
#include "mesh/index_table.hpp"
#include "mesh/weld.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = 0xFFFFFFFFU;

// Edges by their two ends, and a number for each.
class EdgeTable {
 public:
  std::uint32_t find(std::uint32_t a, std::uint32_t b) const {
    const Edge edge{std::min(a, b), std::max(a, b)};
    const std::uint32_t i = table_.find(hash(edge), [&](std::uint32_t j) { return edges_[j] == edge; });
    return i == IndexTable::kNone ? kNone : i;
  }
  // The edge's number: 0, 1, ... in the order in which they came.
  std::uint32_t insert(std::uint32_t a, std::uint32_t b) {
    const Edge edge{std::min(a, b), std::max(a, b)};
    const auto next = static_cast<std::uint32_t>(edges_.size());
    const std::uint32_t i = table_.find_or_insert(hash(edge), next, [&](std::uint32_t j) { return edges_[j] == edge; });
    if (i == next) {
      edges_.push_back(edge);
    }
    return i;
  }
  [[nodiscard]] std::size_t size() const { return edges_.size(); }

 private:
  using Edge = std::array<std::uint32_t, 2>;
  static std::uint64_t hash(const Edge& edge) { return mix(0, std::uint64_t{edge[0]} << 32U | edge[1]); }
  IndexTable table_;
  std::vector<Edge> edges_;
};

float encoded_middle(float a, float b) {
  return a == b ? a : srgb_encode((srgb_decode(a) + srgb_decode(b)) * 0.5F);
}

class Subdivision {
 public:
  Subdivision(const Mesh& mesh, std::span<const DisplacementMap> maps, const DisplacementOptions& options)
      : mesh_(mesh), maps_(maps), options_(options), points_(weld_positions(mesh.positions, 0, options.threads)) {
    point_count_ = mesh.positions.size();
  }

  // Returns the longest edge that is left, texels.
  float run() {
    constexpr int kMostPasses = 64;
    float longest = longest_edge();
    for (int pass = 0; pass < kMostPasses && longest > options_.texels_an_edge; ++pass) {
      if (!halve_edges_above(std::max(options_.texels_an_edge, longest * 0.5F))) {
        break;
      }
      longest = longest_edge();
    }
    return longest;
  }

  Mesh& mesh() { return mesh_; }
  [[nodiscard]] const std::vector<std::uint32_t>& points() const { return points_; }  // of each vertex: equal where positions were equal
  [[nodiscard]] std::size_t point_count() const { return point_count_; }
  [[nodiscard]] const DisplacementMap* map_of(std::size_t triangle) const {
    const std::size_t material = mesh_.triangle_material.empty() ? 0 : mesh_.triangle_material[triangle];
    return material < maps_.size() && maps_[material].height ? &maps_[material] : nullptr;
  }

 private:
  // The length of a triangle's edge i to i + 1, texels; 0 where it has no map, or is a point.
  [[nodiscard]] float edge_length(std::size_t triangle, std::size_t i) const {
    const DisplacementMap* map = map_of(triangle);
    const std::uint32_t a = mesh_.triangles[triangle][i], b = mesh_.triangles[triangle][(i + 1) % 3];
    if (map == nullptr || points_[a] == points_[b]) {
      return 0;
    }
    const std::vector<Vec2f>& uvs = map->uv_set == 0 ? mesh_.uvs : mesh_.uvs1;
    const float u = uvs[b].x - uvs[a].x, v = uvs[b].y - uvs[a].y;
    const std::array<float, 4>& m = map->texels_from_uv;
    const float x = m[0] * u + m[1] * v, y = m[2] * u + m[3] * v;
    const float length2 = x * x + y * y;
    return std::isfinite(length2) ? std::sqrt(length2) : 0;
  }

  [[nodiscard]] float longest_edge() const {
    float longest = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        longest = std::max(longest, edge_length(t, i));
      }
    }
    return longest;
  }

  bool halve_edges_above(float length) {
    EdgeTable halved;  // between points
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (edge_length(t, i) > length) {
          halved.insert(points_[mesh_.triangles[t][i]], points_[mesh_.triangles[t][(i + 1) % 3]]);
        }
      }
    }
    std::size_t count = mesh_.triangles.size();
    for (const auto& t : mesh_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        count += halved.find(points_[t[i]], points_[t[(i + 1) % 3]]) != kNone ? 1U : 0U;
      }
    }
    if (halved.size() == 0 || count > options_.most_triangles) {
      return false;
    }
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::uint32_t> materials;
    triangles.reserve(count);
    materials.reserve(mesh_.triangle_material.empty() ? 0 : count);
    EdgeTable middles;  // between vertices
    const std::size_t first_vertex = mesh_.positions.size();
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      const std::array<std::uint32_t, 3> corner = mesh_.triangles[t];
      std::array<std::uint32_t, 3> middle{kNone, kNone, kNone};  // of edge i to i + 1
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = corner[i], b = corner[(i + 1) % 3];
        const std::uint32_t edge = halved.find(points_[a], points_[b]);
        if (edge != kNone) {
          const std::size_t vertex = first_vertex + middles.insert(a, b);
          middle[i] = static_cast<std::uint32_t>(vertex);
          if (vertex == mesh_.positions.size()) {
            add_middle(a, b);
            points_.push_back(static_cast<std::uint32_t>(point_count_ + edge));
          }
        }
      }
      split(corner, middle, triangles);
      if (!mesh_.triangle_material.empty()) {
        materials.resize(triangles.size(), mesh_.triangle_material[t]);
      }
    }
    point_count_ += halved.size();
    mesh_.triangles = std::move(triangles);
    mesh_.triangle_material = std::move(materials);
    return true;
  }

  // A triangle of which any edges are halved, as two, three or four; all wound as it was.
  void split(const std::array<std::uint32_t, 3>& c, const std::array<std::uint32_t, 3>& m,
             std::vector<std::array<std::uint32_t, 3>>& out) const {
    const auto is_halved = [&](std::size_t i) { return m[i] != kNone; };
    const int halved = (is_halved(0) ? 1 : 0) + (is_halved(1) ? 1 : 0) + (is_halved(2) ? 1 : 0);
    if (halved == 0) {
      out.push_back(c);
    } else if (halved == 3) {
      out.insert(out.end(), {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}});
    } else if (halved == 1) {
      const std::size_t i = is_halved(0) ? 0 : (is_halved(1) ? 1 : 2);
      out.insert(out.end(), {{c[i], m[i], c[(i + 2) % 3]}, {m[i], c[(i + 1) % 3], c[(i + 2) % 3]}});
    } else {  // the corner between the halved edges is cut off, the rest is cut along its shorter diagonal
      const std::size_t whole = !is_halved(0) ? 0 : (!is_halved(1) ? 1 : 2);
      const std::uint32_t a = c[whole], b = c[(whole + 1) % 3], top = c[(whole + 2) % 3];
      const std::uint32_t right = m[(whole + 1) % 3], left = m[(whole + 2) % 3];  // of b to top, of top to a
      out.push_back({right, top, left});
      const auto length2 = [&](std::uint32_t p, std::uint32_t q) {
        const Vec3d d = vec_cast<double>(mesh_.positions[p]) - vec_cast<double>(mesh_.positions[q]);
        return dot(d, d);
      };
      if (length2(a, right) <= length2(b, left)) {
        out.insert(out.end(), {{a, b, right}, {a, right, left}});
      } else {
        out.insert(out.end(), {{a, b, left}, {b, right, left}});
      }
    }
  }

  void add_middle(std::uint32_t a, std::uint32_t b) {
    const auto middle = [](const auto& p, const auto& q) { return (p + q) * 0.5F; };
    const auto middle2 = [](const Vec2f& p, const Vec2f& q) { return Vec2f{(p.x + q.x) * 0.5F, (p.y + q.y) * 0.5F}; };
    const auto unit = [](const Vec3f& sum, const Vec3f& otherwise) { return dot(sum, sum) > 1e-12F ? normalize(sum) : otherwise; };
    mesh_.positions.push_back(mesh_.positions[a] * 0.5F + mesh_.positions[b] * 0.5F);  // halves first: no sum overflows
    mesh_.normals.push_back(unit(mesh_.normals[a] + mesh_.normals[b], mesh_.normals[std::min(a, b)]));
    if (!mesh_.uvs.empty()) {
      mesh_.uvs.push_back(middle2(mesh_.uvs[a], mesh_.uvs[b]));
    }
    if (!mesh_.uvs1.empty()) {
      mesh_.uvs1.push_back(middle2(mesh_.uvs1[a], mesh_.uvs1[b]));
    }
    if (!mesh_.tangents.empty()) {
      const std::array<float, 4>&p = mesh_.tangents[a], &q = mesh_.tangents[b];
      const std::array<float, 4> first = mesh_.tangents[std::min(a, b)];
      const Vec3f t = unit({p[0] + q[0], p[1] + q[1], p[2] + q[2]}, {first[0], first[1], first[2]});
      mesh_.tangents.push_back({t.x, t.y, t.z, first[3]});
    }
    if (!mesh_.colors.empty()) {
      const Vec3f p = mesh_.colors[a], q = mesh_.colors[b];
      mesh_.colors.push_back(options_.encoded_colors ? Vec3f{encoded_middle(p.x, q.x), encoded_middle(p.y, q.y), encoded_middle(p.z, q.z)}
                                                     : middle(p, q));
    }
    if (!mesh_.alphas.empty()) {
      mesh_.alphas.push_back(middle(mesh_.alphas[a], mesh_.alphas[b]));
    }
  }

  Mesh mesh_;
  std::span<const DisplacementMap> maps_;
  const DisplacementOptions& options_;
  std::vector<std::uint32_t> points_;
  std::size_t point_count_ = 0;
};

// Moves the vertices.
void move(Subdivision& surface, float spacing, int threads) {
  struct Ask {  // a vertex in a triangle with a map: usually one a vertex
    std::uint32_t vertex;
    const DisplacementMap* map;
    Vec3d offset{};
  };
  Mesh& mesh = surface.mesh();
  std::vector<Ask> asks;
  std::vector<const DisplacementMap*> asked(mesh.positions.size(), nullptr);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const DisplacementMap* map = surface.map_of(t);
    for (const std::uint32_t v : mesh.triangles[t]) {
      if (map != nullptr && asked[v] != map) {  // of several materials at one vertex each asks where it comes again, which weights it alike
        asked[v] = map;
        asks.push_back({v, map});
      }
    }
  }
  parallel_slices(
      asks.size(), threads,
      [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          Ask& ask = asks[i];
          const float height = ask.map->height((ask.map->uv_set == 0 ? mesh.uvs : mesh.uvs1)[ask.vertex], spacing);
          ask.offset = vec_cast<double>(mesh.normals[ask.vertex]) * (std::isfinite(height) ? static_cast<double>(height) : 0);
        }
      },
      1024);
  std::vector<Vec3d> offset(surface.point_count());
  std::vector<std::uint32_t> count(surface.point_count());
  for (const Ask& ask : asks) {
    const std::uint32_t point = surface.points()[ask.vertex];
    offset[point] += ask.offset;
    ++count[point];
  }
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const std::uint32_t point = surface.points()[v];
    if (count[point] != 0) {
      const Vec3f moved = vec_cast<float>(vec_cast<double>(mesh.positions[v]) + offset[point] * (1.0 / count[point]));
      mesh.positions[v] = is_finite(moved) ? moved : mesh.positions[v];
    }
  }
}

// Vertices of one point that share a normal, as one.
std::vector<std::uint32_t> smooth_groups(const Mesh& mesh, const std::vector<std::uint32_t>& points, std::size_t& count) {
  IndexTable table(mesh.positions.size());
  std::vector<std::uint32_t> groups(mesh.positions.size());
  std::vector<std::uint32_t> first;
  for (std::uint32_t v = 0; v < groups.size(); ++v) {
    const auto is_same = [&](std::uint32_t g) { return points[first[g]] == points[v] && mesh.normals[first[g]] == mesh.normals[v]; };
    const auto next = static_cast<std::uint32_t>(first.size());
    groups[v] = table.find_or_insert(mix(mix(0, points[v]), mesh.normals[v]), next, is_same);
    if (groups[v] == next) {
      first.push_back(v);
    }
  }
  count = first.size();
  return groups;
}

// The sum of the areas' normals around each group.
std::vector<Vec3d> normals_around(const Mesh& mesh, const std::vector<std::uint32_t>& groups, std::size_t count) {
  std::vector<Vec3d> sums(count);
  for (const auto& t : mesh.triangles) {
    const Vec3d a = vec_cast<double>(mesh.positions[t[0]]);
    const Vec3d area = cross(vec_cast<double>(mesh.positions[t[1]]) - a, vec_cast<double>(mesh.positions[t[2]]) - a);
    for (const std::uint32_t v : t) {
      sums[groups[v]] += area;
    }
  }
  return sums;
}

// The smallest rotation that turns `from` to `to`, of v; all unit.
Vec3d turned(const Vec3d& v, const Vec3d& from, const Vec3d& to) {
  const double cosine = dot(from, to);
  if (cosine < -0.999) {
    return to;  // turned over: no smallest rotation
  }
  const Vec3d sum = from + to;
  return (v - sum * (dot(sum, v) / (1 + cosine))) + to * (2 * dot(from, v));
}

void turn_normals(Mesh& mesh, const std::vector<std::uint32_t>& groups, const std::vector<Vec3d>& before, const std::vector<Vec3d>& after) {
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    const Vec3d& from = before[groups[v]];
    const Vec3d& to = after[groups[v]];
    if (from == to || !(dot(from, from) > 0) || !(dot(to, to) > 0)) {
      continue;
    }
    const Vec3d n = turned(vec_cast<double>(mesh.normals[v]), normalize(from), normalize(to));
    if (dot(n, n) > 0.25) {
      mesh.normals[v] = vec_cast<float>(normalize(n));
    }
  }
}

}  // namespace

DisplacedMesh displaced(const Mesh& mesh, std::span<const DisplacementMap> maps, const DisplacementOptions& options) {
  Subdivision surface(mesh, maps, options);
  const float longest = surface.run();
  DisplacedMesh result;
  if (longest > options.texels_an_edge) {
    result.note = fmt::format("its displacement map is followed by edges of {:.3g} texels: finer ones would take more than {} triangles",
                              longest, options.most_triangles);
  }
  std::size_t group_count = 0;
  const std::vector<std::uint32_t> groups = smooth_groups(surface.mesh(), surface.points(), group_count);
  const std::vector<Vec3d> before = normals_around(surface.mesh(), groups, group_count);
  move(surface, std::max(longest * 0.5F, 1.0F), options.threads);
  result.mesh = std::move(surface.mesh());
  turn_normals(result.mesh, groups, before, normals_around(result.mesh, groups, group_count));
  return result;
}

}  // namespace lustro
