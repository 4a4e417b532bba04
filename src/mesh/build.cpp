// From a source to what is drawn: the table of contents of this folder, and the last step, in which corners become vertices.
#include "mesh/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "mesh/index_table.hpp"
#include "mesh/materials.hpp"
#include "mesh/normals.hpp"
#include "mesh/plain_mesh.hpp"
#include "mesh/polygon.hpp"
#include "mesh/triangulate.hpp"
#include "mesh/validate.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;

/// Unit normals for all corners: the file's, where it has them and they are wanted, else those made from the faces.
CornerNormals normals_for(const SourceMesh& source, const NormalOptions& options, int threads) {
  const bool use_file = !options.recompute && !source.corner_normal.empty();
  const auto is_missing = [](std::uint32_t normal) { return normal == kNone; };
  const bool make = !use_file || std::any_of(source.corner_normal.begin(), source.corner_normal.end(), is_missing);
  if (!make) {
    return {source.normals, source.corner_normal};
  }
  CornerNormals normals = make_normals({source.positions, source.face_begin, source.corner_position, source.face_smoothing}, options, threads);
  if (use_file) {
    const auto made = static_cast<std::uint32_t>(normals.normals.size());
    normals.normals.insert(normals.normals.end(), source.normals.begin(), source.normals.end());
    for (std::size_t c = 0; c < source.corner_normal.size(); ++c) {
      if (source.corner_normal[c] != kNone) {
        normals.corner_normal[c] = made + source.corner_normal[c];
      }
    }
  }
  return normals;
}

bool has_area(const SourceMesh& source, const std::array<std::uint32_t, 3>& corners) {
  const auto position = [&](std::size_t k) { return vec_cast<double>(source.positions[source.corner_position[corners[k]]]); };
  return cross(position(1) - position(0), position(2) - position(0)) != Vec3d{};
}

/// Drops the triangles without area, in place.
std::size_t drop_degenerate(const SourceMesh& source, Triangles& triangles, int threads) {
  std::atomic<bool> is_clean = true;
  parallel_slices(triangles.corners.size(), threads, [&](std::size_t begin, std::size_t end) {
    bool clean = true;
    for (std::size_t t = begin; t < end; ++t) {
      clean &= has_area(source, triangles.corners[t]);
    }
    if (!clean) {
      is_clean = false;
    }
  });
  if (is_clean) {
    return 0;
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < triangles.corners.size(); ++t) {
    if (has_area(source, triangles.corners[t])) {
      triangles.corners[kept] = triangles.corners[t];
      triangles.face[kept] = triangles.face[t];
      ++kept;
    }
  }
  const std::size_t dropped = triangles.corners.size() - kept;
  triangles.corners.resize(kept);
  triangles.face.resize(kept);
  return dropped;
}

/// Turns corners into vertices: equal corners, in their order, become one. A corner equals another one with the same position (by index), uv,
/// normal and colour (by value).
class Unifier {
 public:
  Unifier(const ValidMesh& valid, const CornerNormals& normals) : valid_(valid), source_(valid.source), normals_(normals) {
    has_uvs_ = !source_.corner_uv.empty();
    has_colors_ = !source_.face_colors.empty() || !source_.colors.empty();
    first_.assign(source_.positions.size(), kNone);
  }

  void unify(Triangles triangles, Mesh& mesh) {
    std::vector<std::uint32_t> vertex(source_.corner_position.size(), kNone);
    for (const auto& triangle : triangles.corners) {
      for (const std::uint32_t corner : triangle) {
        vertex[corner] = 0;
      }
    }
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      for (std::uint32_t c = source_.face_begin[f]; c < source_.face_begin[f + 1]; ++c) {
        if (vertex[c] != kNone) {
          vertex[c] = vertex_of(f, c, mesh);
        }
      }
    }
    mesh.triangles = std::move(triangles.corners);
    for (auto& triangle : mesh.triangles) {
      for (std::uint32_t& corner : triangle) {
        corner = vertex[corner];
      }
    }
    gather(source_.uvs1, mesh.uvs1);
    gather(source_.tangents, mesh.tangents);
    gather(source_.alphas, mesh.alphas);
  }

 private:
  [[nodiscard]] Vec2f uv_of(std::uint32_t c) const {
    return has_uvs_ && source_.corner_uv[c] != kNone ? source_.uvs[source_.corner_uv[c]] : Vec2f{};
  }

  [[nodiscard]] Vec3f color_of(std::uint32_t f, std::uint32_t c) const {
    if (!source_.face_colors.empty()) {
      return source_.face_colors[f];
    }
    return source_.colors[valid_.corner_color.empty() ? source_.corner_position[c] : valid_.corner_color[c]];
  }

  /// What a vertex has from its position.
  template <class T>
  void gather(const std::vector<T>& from, std::vector<T>& to) const {
    to.reserve(from.empty() ? 0 : position_of_.size());
    for (std::size_t v = 0; v < position_of_.size() && !from.empty(); ++v) {
      to.push_back(from[position_of_[v]]);
    }
  }

  std::uint32_t vertex_of(std::uint32_t f, std::uint32_t c, Mesh& mesh) {
    const std::uint32_t position = source_.corner_position[c];
    const Vec3f normal = normals_.normals[normals_.corner_normal[c]];
    const Vec2f uv = uv_of(c);
    const Vec3f color = has_colors_ ? color_of(f, c) : Vec3f{};
    const auto equal = [&](std::uint32_t v) {
      return position_of_[v] == position && mesh.normals[v] == normal && (!has_uvs_ || mesh.uvs[v] == uv) &&
             (!has_colors_ || mesh.colors[v] == color);
    };
    const auto fresh = static_cast<std::uint32_t>(mesh.positions.size());
    std::uint32_t found = first_[position];  // most positions have one vertex: only others go into the table
    if (found == kNone) {
      found = first_[position] = fresh;
    } else if (!equal(found)) {
      const std::uint64_t hash = mix(mix(mix(mix(position, normal), std::uint64_t{value_bits(uv.x)} << 32U | value_bits(uv.y)), color), 0);
      found = others_.find_or_insert(hash, fresh, equal);
    }
    if (found == fresh) {
      position_of_.push_back(position);
      mesh.positions.push_back(source_.positions[position]);
      mesh.normals.push_back(normal);
      if (has_uvs_) {
        mesh.uvs.push_back(uv);
      }
      if (has_colors_) {
        mesh.colors.push_back(color);
      }
    }
    return found;
  }

  const ValidMesh& valid_;
  const SourceMesh& source_;
  const CornerNormals& normals_;
  bool has_uvs_ = false;
  bool has_colors_ = false;
  std::vector<std::uint32_t> first_;        ///< of a position: its first vertex
  std::vector<std::uint32_t> position_of_;  ///< of a vertex
  IndexTable others_;
};

}  // namespace

Result<BuiltMesh> build_general(SourceMesh&& source, const NormalOptions& options, int threads) {
  const bool has_both_colors = !source.colors.empty() && !source.face_colors.empty();
  std::vector<Material> materials = source.materials;
  Result<ValidMesh> valid = validate(std::move(source), threads);
  if (!valid) {
    return tl::unexpected<Error>(std::move(valid.error()));
  }
  BuiltMesh built;
  const CornerNormals normals = normals_for(valid->source, options, threads);
  Triangles triangles = triangulate(valid->source, threads);
  const std::size_t degenerate = drop_degenerate(valid->source, triangles, threads);
  const std::vector<std::uint32_t>& face_material = valid->source.face_material;
  if (std::any_of(face_material.begin(), face_material.end(), [](std::uint32_t material) { return material != kNone; })) {
    assign_materials(
        std::move(materials), triangles.face.size(), [&](std::size_t t) { return face_material[triangles.face[t]]; }, built.mesh);
  }

  built.notes = std::move(valid->notes);
  if (triangles.crossing_polygons > 0) {
    built.notes.push_back({{},
                           fmt::format("{} cut into triangles that overlap", counted(triangles.crossing_polygons, "polygon that crosses itself:",
                                                                                     "polygons that cross themselves:"))});
  }
  if (degenerate > 0) {
    built.notes.push_back({{}, fmt::format("{} without area: dropped", counted(degenerate, "triangle", "triangles"))});
  }
  if (has_both_colors) {
    built.notes.push_back({{}, "both vertices and faces have colours: those of the faces are used"});
  }
  Unifier(*valid, normals).unify(std::move(triangles), built.mesh);
  return built;
}

Result<BuiltMesh> build_mesh(SourceMesh&& source, const NormalOptions& options, int threads) {
  if (!(options.crease_deg >= 0 && options.crease_deg <= 180)) {
    return fail(ErrorKind::usage, {}, fmt::format("the crease angle {} is outside 0..180", options.crease_deg));
  }
  if (Result<void> checked = check_source(source, threads); !checked) {
    return tl::unexpected<Error>(std::move(checked.error()));
  }
  if (std::optional<PlainMesh> plain = to_plain(source, options, threads)) {
    return build_plain(*std::move(plain), options, threads);
  }
  return build_general(std::move(source), options, threads);
}

Result<BuiltMesh> build_mesh(const SourceMesh& source, const NormalOptions& options) {
  return build_mesh(SourceMesh(source), options, 0);
}

}  // namespace lustro
