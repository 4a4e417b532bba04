// build_mesh() for plain triangles: the same steps with the same notes, each of them one parallel pass over flat arrays.
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <utility>

#include "mesh/index_table.hpp"
#include "mesh/materials.hpp"
#include "mesh/plain_mesh.hpp"
#include "mesh/repair.hpp"
#include "mesh/triangle_normals.hpp"
#include "mesh/validate.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

using Triangle = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = SourceMesh::kNone;

bool all_finite(const std::vector<Vec3f>& points, int threads) {
  std::atomic<bool> is_good = true;
  parallel_slices(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    bool good = true;
    for (std::size_t i = begin; i < end; ++i) {
      good &= is_finite(points[i]);
    }
    if (!good) {
      is_good = false;
    }
  });
  return is_good;
}

bool has_area(const std::vector<Vec3f>& positions, const Triangle& t) {
  const Vec3d origin = vec_cast<double>(positions[t[0]]);
  return cross(vec_cast<double>(positions[t[1]]) - origin, vec_cast<double>(positions[t[2]]) - origin) != Vec3d{};
}

bool all_have_area(const PlainMesh& mesh, int threads) {
  std::atomic<bool> is_good = true;
  parallel_slices(mesh.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
    bool good = true;
    for (std::size_t t = begin; t < end; ++t) {
      good &= has_area(mesh.positions, mesh.triangles[t]);
    }
    if (!good) {
      is_good = false;
    }
  });
  return is_good;
}

/// Keeps the triangles, and what belongs to them, for which keep(triangle) holds.
template <class Keep>
std::size_t drop_triangles(PlainMesh& mesh, const Keep& keep) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (keep(mesh.triangles[t])) {
      mesh.triangles[kept] = mesh.triangles[t];
      if (!mesh.materials_of.empty()) {
        mesh.materials_of[kept] = mesh.materials_of[t];
      }
      ++kept;
    }
  }
  const std::size_t dropped = mesh.triangles.size() - kept;
  mesh.triangles.resize(kept);
  mesh.materials_of.resize(std::min(kept, mesh.materials_of.size()));
  return dropped;
}

struct DroppedTriangles {
  std::size_t infinite = 0;
  std::size_t thin = 0;
};

/// What validate() drops: triangles with a position that is not finite, or with two corners at one place.
DroppedTriangles drop_unusable(PlainMesh& mesh) {
  DroppedTriangles dropped;
  const std::vector<Vec3f>& p = mesh.positions;
  drop_triangles(mesh, [&](const Triangle& t) {
    if (!is_finite(p[t[0]]) || !is_finite(p[t[1]]) || !is_finite(p[t[2]])) {
      ++dropped.infinite;
      return false;
    }
    if (p[t[0]] == p[t[1]] || p[t[1]] == p[t[2]] || p[t[2]] == p[t[0]]) {
      ++dropped.thin;
      return false;
    }
    return true;
  });
  return dropped;
}

/// number_by_first_use() where some vertices have no normal: their triangles do not share one, so each corner asks for a vertex with the normal
/// of its own. The normals of the new vertices come out beside the old vertices' numbers.
std::vector<std::uint32_t> number_with_own_normals(PlainMesh& mesh, std::vector<Vec3f>& new_normals) {
  constexpr std::uint32_t kParted = kNone - 1;
  std::vector<std::uint32_t> new_of_old(mesh.positions.size(), kNone);
  for (std::size_t v = 0; v < new_of_old.size(); ++v) {
    if (mesh.normals[v] == Vec3f{}) {
      new_of_old[v] = kParted;
    }
  }
  std::vector<std::uint32_t> old_of_new;
  IndexTable parted;
  for (Triangle& triangle : mesh.triangles) {
    const Triangle stated = triangle;
    for (std::uint32_t& corner : triangle) {
      const std::uint32_t v = corner;
      const auto fresh = static_cast<std::uint32_t>(old_of_new.size());
      corner = new_of_old[v];
      Vec3f normal = mesh.normals[v];
      if (corner == kParted) {
        normal = own_normal(mesh.positions, stated);
        corner = parted.find_or_insert(mix(mix(0, v), normal), fresh,
                                       [&](std::uint32_t n) { return old_of_new[n] == v && new_normals[n] == normal; });
      } else if (corner == kNone) {
        corner = new_of_old[v] = fresh;
      }
      if (corner == fresh) {
        old_of_new.push_back(v);
        new_normals.push_back(normal);
      }
    }
  }
  return old_of_new;
}

template <class T>
void gather(std::vector<T>& list, const std::vector<std::uint32_t>& old_of_new) {
  if (list.empty()) {
    return;
  }
  std::vector<T> gathered(old_of_new.size());
  for (std::size_t i = 0; i < old_of_new.size(); ++i) {
    gathered[i] = list[old_of_new[i]];
  }
  list = std::move(gathered);
}

}  // namespace

BuiltMesh build_plain(PlainMesh mesh, const NormalOptions& options, int threads) {
  BuiltMesh built;
  const auto note = [&](std::size_t count, const char* singular, const char* plural, const char* what) {
    if (count > 0) {
      built.notes.push_back({{}, fmt::format("{} {}", counted(count, singular, plural), what)});
    }
  };
  note(whiten(mesh.colors, threads), "colour", "colours", "not finite: white instead");
  note(replace_uvs(mesh.uvs, threads), "texture coordinate", "texture coordinates", "not finite: (0, 0) instead");
  if (!mesh.used) {
    sort_by_first_use(mesh, threads);
  }
  std::vector<Vec3f> file_normals = std::move(mesh.normals);
  const std::size_t unusable = normalize_normals(file_normals, threads);  // those are (0, 0, 0) now
  note(unusable, "normal", "normals", "zero or not finite: made from the faces instead");

  DroppedTriangles dropped;
  bool has_flat = false;
  const bool use_file = !file_normals.empty() && !options.recompute;
  if (!all_finite(mesh.positions, threads)) {
    dropped = drop_unusable(mesh);
  }
  bool has_zero = false;
  if (use_file && unusable == 0) {
    has_flat = !all_have_area(mesh, threads);
    if (has_flat && dropped.infinite + dropped.thin == 0) {
      dropped = drop_unusable(mesh);
    }
    mesh.normals = std::move(file_normals);
  } else {
    TriangleNormals made =
        make_triangle_normals({mesh.positions, mesh.triangles, mesh.triangles, mesh.positions.size()}, options.weights, threads);
    if (made.has_thin) {
      dropped = drop_unusable(mesh);
    }
    has_flat = made.has_flat;
    has_zero = made.has_zero;
    mesh.normals = std::move(made.normals);
    for (std::size_t v = 0; use_file && v < file_normals.size(); ++v) {
      if (file_normals[v] != Vec3f{}) {
        mesh.normals[v] = file_normals[v];
      }
    }
    file_normals = {};
    has_zero = has_zero && std::any_of(mesh.normals.begin(), mesh.normals.begin() + static_cast<std::ptrdiff_t>(*mesh.used),
                                       [](const Vec3f& n) { return n == Vec3f{}; });
  }
  note(dropped.infinite, "face", "faces", "with a position that is not finite: dropped");
  note(dropped.thin, "face", "faces", "with fewer than three distinct corners: dropped");

  const bool has_materials = std::any_of(mesh.materials_of.begin(), mesh.materials_of.end(), [](std::uint32_t m) { return m != kNone; });
  std::size_t flat = 0;
  if (has_flat) {
    flat = drop_triangles(mesh, [&](const Triangle& t) { return has_area(mesh.positions, t); });
    note(flat, "triangle", "triangles", "without area: dropped");
  }
  if (has_materials) {
    assign_materials(
        std::move(mesh.materials), mesh.triangles.size(), [&](std::size_t t) { return mesh.materials_of[t]; }, built.mesh);
  }

  if (has_zero) {
    std::vector<Vec3f> normals;
    const std::vector<std::uint32_t> old_of_new = number_with_own_normals(mesh, normals);
    gather(mesh.positions, old_of_new);
    gather(mesh.uvs, old_of_new);
    gather(mesh.colors, old_of_new);
    mesh.normals = std::move(normals);
  } else {
    if (dropped.infinite + dropped.thin + flat != 0) {
      sort_by_first_use(mesh, threads);
    }
    const auto forget_unused = [&](auto& list) { list.resize(std::min(list.size(), *mesh.used)); };
    forget_unused(mesh.positions);
    forget_unused(mesh.normals);
    forget_unused(mesh.uvs);
    forget_unused(mesh.colors);
  }
  built.mesh.positions = std::move(mesh.positions);
  built.mesh.normals = std::move(mesh.normals);
  built.mesh.uvs = std::move(mesh.uvs);
  built.mesh.colors = std::move(mesh.colors);
  built.mesh.triangles = std::move(mesh.triangles);
  return built;
}

}  // namespace lustro
