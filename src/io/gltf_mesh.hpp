// A glTF mesh as it stands in a pose: primitives as triangles, morph targets and skin applied.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "io/gltf_file.hpp"
#include "io/gltf_pose.hpp"
#include "lustro/mesh.hpp"

namespace lustro {

/// Whether a primitive becomes triangles: not points and lines, nor what has no positions.
[[nodiscard]] bool is_drawn(const GltfPrimitive& primitive);

/// A material of the document (kGltfNone: the default) on a surface with vertex colours or without: they tint what is scattered, and since a
/// metal scatters nothing, it is drawn as no metal there.
struct GltfMaterialUse {
  std::uint32_t material = kGltfNone;
  bool is_colored = false;
  friend bool operator<(const GltfMaterialUse& a, const GltfMaterialUse& b) {
    return a.material != b.material ? a.material < b.material : !a.is_colored && b.is_colored;
  }
};

/// The material as it is drawn there.
[[nodiscard]] GltfMaterial material_of(const GltfDocument& document, const GltfMaterialUse& use);

/// Gathers primitives into one SourceMesh. Materials are those that its triangles use.
class GltfMeshBuilder {
 public:
  GltfMeshBuilder(GltfFile& file, const GltfPose& pose) : file_(file), pose_(pose) {}

  /// Which of the document's materials each of the mesh's is.
  [[nodiscard]] const std::vector<GltfMaterialUse>& material_uses() const { return material_uses_; }

  /// The mesh of a node: skinned, in world space; else in the node's own space, moved by `placement`.
  /// object  the index into SourceMesh::objects that its faces get; kNone: no objects are stated
  [[nodiscard]] Result<void> add(std::uint32_t node, const std::optional<Mat4>& placement, std::uint32_t object);

  [[nodiscard]] SourceMesh finish();

  SourceMesh& mesh() { return mesh_; }

 private:
  struct Vertices;
  /// Vertices that are in the mesh: primitives that name the same accessors share them.
  struct Placed {
    std::uint32_t base = 0, count = 0;
    bool has_normals = false;
    bool has_colors = false;
    bool is_mirrored = false;
    std::vector<std::uint32_t> packed_indices{};  ///< of a Draco mesh
  };
  using Shared = std::map<std::vector<std::uint32_t>, Placed>;
  [[nodiscard]] Result<void> add_primitive(std::uint32_t node, const GltfPrimitive& primitive, const std::string& path,
                                           const std::optional<Mat4>& placement, std::uint32_t object, Shared& shared);
  [[nodiscard]] Result<Placed> place(std::uint32_t node_index, const GltfPrimitive& primitive, const std::string& path,
                                     const std::optional<Mat4>& placement);
  [[nodiscard]] Result<void> read_vertices(const GltfPrimitive& primitive, const std::string& path, Vertices& vertices);
  [[nodiscard]] Result<void> unpack(const GltfPrimitive& primitive, const std::string& path, Vertices& vertices);
  [[nodiscard]] Result<void> morph(const GltfPrimitive& primitive, const std::vector<double>& weights, Vertices& vertices);
  [[nodiscard]] Result<void> skin(const GltfPrimitive& primitive, std::uint32_t index, Vertices& vertices);
  void append(const Vertices& vertices);
  [[nodiscard]] Result<void> add_faces(const GltfPrimitive& primitive, const std::string& path, const Placed& vertices, std::uint32_t object);
  std::uint32_t place_of(const GltfMaterialUse& use);

  GltfFile& file_;
  const GltfPose& pose_;
  SourceMesh mesh_;
  std::vector<GltfMaterialUse> material_uses_;
  std::map<GltfMaterialUse, std::uint32_t> materials_;  ///< index here
  bool has_flat_ = false;
};

}  // namespace lustro
