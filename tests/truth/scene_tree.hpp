// A tree of several hundred small scenes that together ask for every clause of the lighting model: each lighting x interpolation x light kind x
// attenuation x camera, and variations of everything else. Made in code from exact decimal numbers, so that it is the same on every machine;
// any renderer can be held against any judge on it.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lustro/scene.hpp"

namespace lustro::truth {

struct TreeScene {
  std::string name;       ///< a path in the tree: `phong/gouraud/point/polynomial/orthographic`, `variations/fog/exp2/...`
  std::string geometry;   ///< scenes of equal `geometry` show the same triangles at the same pixels
  Scene scene;            ///< meshes loaded; `source` names them where a scene file can
  bool is_judged = true;  ///< the judge in double precision knows all that it shows
};

/// The whole tree, always in the same order.
[[nodiscard]] const std::vector<TreeScene>& scene_tree();

/// Tests of many scenes look at every n-th: n from the environment variable LUSTRO_TREE_STRIDE, else 1 (7 under sanitizers).
[[nodiscard]] std::size_t scene_stride();

/// The scenes of the tree that tests look at.
[[nodiscard]] std::vector<const TreeScene*> chosen_scenes();

/// A mesh that a scene file can name: `primitive:sphere:16`.
[[nodiscard]] std::shared_ptr<const Mesh> tree_mesh(const std::string& source, const Shading& shading = {});

}  // namespace lustro::truth
