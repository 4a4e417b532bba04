// What a mesh alone decides about its drawing: that it is sound, its missing normals, its clusters. Made once, kept for the pictures to come.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lustro/mesh.hpp"
#include "lustro/result.hpp"
#include "lustro/texture.hpp"
#include "mesh/clusters.hpp"
#include "mesh/cones.hpp"
#include "mesh/tangents.hpp"

namespace lustro {

/// A mesh ready for drawing.
struct DrawableMesh {
  std::shared_ptr<const Mesh> stated;  ///< as the scene holds it
  std::shared_ptr<const Mesh> mesh;    ///< checked; with unit normals unless none were asked for
  std::vector<Vec3f> colors;           ///< V x 3, linear, or empty
  bool has_alphas = false;             ///< the mesh's alphas let see through somewhere
  Clusters clusters;
  std::vector<NormalCone> cones;  ///< of the clusters, or empty
  std::string note;               ///< what did not go as asked, or empty
};

/// What the scene's options say about a mesh.
struct MeshDemand {
  NormalOptions normals{};
  bool wants_normals = true;
  bool encoded_colors = true;                             ///< vertex colours are decoded to linear light
  bool wants_cones = false;                               ///< faces that look away are not drawn; met where the mesh will be drawn often
  std::optional<TangentOptions> tangents{};               ///< made where the mesh states none
  std::vector<std::optional<TextureUse>> displacement{};  ///< of displacement_of(); asks for normals

  friend bool operator==(const MeshDemand& a, const MeshDemand& b) {
    return a.normals.weights == b.normals.weights && a.normals.crease_deg == b.normals.crease_deg && a.wants_normals == b.wants_normals &&
           a.encoded_colors == b.encoded_colors && a.wants_cones == b.wants_cones && a.tangents == b.tangents &&
           a.displacement == b.displacement;
  }
};

class MeshCache {
 public:
  /// use  how often what get() makes will be drawn
  explicit MeshCache(ClusterUse use) : use_(use) {}

  /// where  for messages: `objects[3].mesh`
  /// errors  usage where a hand-built mesh does not fit together
  [[nodiscard]] Result<std::shared_ptr<const DrawableMesh>> get(const std::shared_ptr<const Mesh>& mesh, const MeshDemand& demand, int threads,
                                                                const std::string& where);

  /// Drops what get() was not asked for since the last call.
  void forget_unused();

 private:
  struct Entry {
    std::shared_ptr<const DrawableMesh> drawable;
    MeshDemand demand;
    bool is_used = true;
  };
  ClusterUse use_;
  std::vector<Entry> entries_;
};

}  // namespace lustro
