// Triangle meshes. An importer makes a SourceMesh, faithful to its file; build_mesh() makes the Mesh that is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "lustro/material.hpp"
#include "lustro/options.hpp"
#include "lustro/result.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// An axis-aligned box. Empty while lower > upper.
struct Bounds {
  Vec3d lower{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec3d upper{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

  [[nodiscard]] bool is_empty() const { return lower.x > upper.x || lower.y > upper.y || lower.z > upper.z; }
  [[nodiscard]] Vec3d center() const { return (lower + upper) * 0.5; }
  void include(const Vec3d& p);
};

/// A mesh as its file states it: polygons, one index stream per attribute. Every importer returns one.
///
/// Indices are absolute, zero-based and inside their arrays (an importer reports an index outside with its line).
struct SourceMesh {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  std::vector<Vec3f> positions;  ///< V x 3, object space; may hold non-finite values until validate() drops them
  std::vector<Vec3f> normals;    ///< as written, of any length
  std::vector<Vec2f> uvs;
  std::vector<Vec3f> colors;       ///< V x 3 (one a position) or empty; `encoded`, 0..1
  std::vector<Vec3f> face_colors;  ///< F x 3 or empty; `encoded`, 0..1

  std::vector<Vec2f> uvs1;                     ///< V x 2 (one a position) or empty: a second set
  std::vector<std::array<float, 4>> tangents;  ///< V x 4 or empty: unit tangent and the sign of the bitangent
  std::vector<float> alphas;                   ///< V or empty; 0..1

  std::vector<std::uint32_t> face_begin{0};    ///< F + 1: face f has the corners face_begin[f] .. face_begin[f + 1]
  std::vector<std::uint32_t> corner_position;  ///< C
  std::vector<std::uint32_t> corner_normal;    ///< C or empty; kNone where the corner has none
  std::vector<std::uint32_t> corner_uv;        ///< C or empty; kNone where the corner has none
  std::vector<std::uint32_t> face_smoothing;   ///< F or empty (no `s` statement: all smooth); 0 is off
  std::vector<std::uint32_t> face_material;    ///< F or empty; an index into materials, or kNone
  std::vector<std::uint32_t> face_object;      ///< F or empty; an index into objects

  std::vector<Material> materials;
  std::vector<std::string> objects;  ///< names of the o and g records, solids, ...
  std::string format;                ///< "OBJ", "PLY (binary, little endian)", ...
  bool weld_first = false;           ///< STL: positions are repeated in every facet and must be welded before normals are made
  Notes notes;                       ///< what was skipped or repaired while reading

  [[nodiscard]] std::size_t face_count() const { return face_begin.size() - 1; }
  /// Triangles as the file states them: a polygon of n corners counts n - 2.
  [[nodiscard]] std::size_t stated_triangle_count() const;
};

/// Indexed triangles with everything that drawing needs. One vertex has one position, normal, uv and colour: where faces do not
/// share a normal (crease, smoothing groups), the vertex is there twice.
struct Mesh {
  std::vector<Vec3f> positions;                ///< V x 3, object space, finite
  std::vector<Vec3f> normals;                  ///< V x 3, unit; empty: prepare() makes them by the scene's `vertex_normals`
  std::vector<Vec2f> uvs;                      ///< V x 2 or empty: the set that textures use unless they say otherwise
  std::vector<Vec2f> uvs1;                     ///< V x 2 or empty: a second set
  std::vector<std::array<float, 4>> tangents;  ///< V x 4 or empty: unit tangent of `uvs` and the sign of the bitangent, as glTF has them
  std::vector<Vec3f> colors;                   ///< V x 3 or empty; `encoded`; multiply ambient and diffuse
  std::vector<float> alphas;                   ///< V or empty; multiply the opacity
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< T, counter-clockwise seen from the front
  std::vector<std::uint32_t> triangle_material;         ///< T or empty (all 0); an index into materials
  std::vector<Material> materials;                      ///< empty: the default material

  [[nodiscard]] Bounds bounds() const;  ///< of the positions that triangles use
};

/// How build_mesh() makes missing normals.
struct NormalOptions {
  VertexNormals weights = VertexNormals::angle;
  double crease_deg = 180;  ///< 0..180; faces that meet at more do not share a normal
  bool recompute = false;   ///< ignore the file's normals
};

/// What build_mesh() did beyond copying, for `lustro info` and for warnings.
struct BuiltMesh {
  Mesh mesh;
  Notes notes;  ///< degenerate or non-finite data dropped, each kind once, with counts
};

/// The one validation step in which every importer ends, then triangles: fans for convex polygons, ears for concave ones; degenerate
/// and non-finite data dropped with a note; welding where the source asks for it; normals.
/// errors  malformed where an index lies outside its array; a mesh without triangles is not an error
[[nodiscard]] Result<BuiltMesh> build_mesh(const SourceMesh& source, const NormalOptions& options = {});

/// The same without a copy of the source, which is left without its geometry.
/// threads  0: one a core; the result is the same for any number
[[nodiscard]] Result<BuiltMesh> build_mesh(SourceMesh&& source, const NormalOptions& options = {}, int threads = 0);

/// A mesh by name, so that a scene needs no file: `plane`, `cube`, `sphere`, `torus`, `teapot`, or with the number of segments
/// `sphere:12`, `torus:48`, `plane:10`. Sizes: the plane spans -1..1 in x and z and faces +y, the cube -1..1, the sphere has radius 1, the
/// torus radii 0.7 and 0.3 about the y axis, the teapot is about 3 high upright on y = 0 (Martin Newell's, assets/).
/// errors  usage for an unknown name or a number of segments outside 3..1024
[[nodiscard]] Result<SourceMesh> make_primitive(std::string_view name);

/// The names that make_primitive() knows.
[[nodiscard]] std::span<const std::string_view> primitive_names();

}  // namespace lustro
