// The floor below everything, and surfaces like it: they show nothing but the shadows on them (shade/shadow_catcher.hpp).
#pragma once

#include "lustro/scene.hpp"
#include "scene/view.hpp"

namespace lustro {

/// Whether a material is MTL's illum 10: what is there is seen through it, and shadows on it.
[[nodiscard]] bool catches_shadows(const Material& material);

/// A square at the scene's foot, so large that shadows end on it. Planes that the camera does not state are moved
/// before and behind the square.
///
/// bounds  of the objects, world
[[nodiscard]] Object make_ground(const GroundSettings& settings, const Camera& camera, const Bounds& bounds, View& view);

}  // namespace lustro
