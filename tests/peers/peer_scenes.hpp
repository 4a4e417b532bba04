// Scenes for OpenGL: curved and angular primitives and real meshes under every kind of light, both projections, transfer none.
#pragma once

#include <string>
#include <vector>

#include "lustro/scene.hpp"

namespace lustro::peers {

struct PeerScene {
  std::string name;
  Scene scene;  ///< Gouraud with Blinn-Phong; lights that the fixed function knows
};

/// Names of the subjects: `primitives`, `teapot`, and of real meshes those that are there.
[[nodiscard]] std::vector<std::string> subjects();

/// A subject by each projection and each set of lights of the fixed function (no beam, polynomial attenuation that stays below 1).
[[nodiscard]] std::vector<PeerScene> fixed_function_scenes(const std::string& subject);

/// Lights that only the shaders know: beams, falloff, no limit, more than eight.
[[nodiscard]] std::vector<PeerScene> shader_scenes(const std::string& subject);

}  // namespace lustro::peers
