// What the scenes of the tree are made of: geometries with their cameras, materials, lights, attenuations, and the words that name them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "truth/scene_tree.hpp"

namespace lustro::truth {

struct NamedAttenuation {
  std::string name;
  Attenuation value;
};

struct LightKind {
  std::string name;
  std::function<std::vector<Light>(const Attenuation&)> lights;
};

[[nodiscard]] const std::vector<NamedAttenuation>& attenuations();  ///< `none` first
[[nodiscard]] const std::vector<LightKind>& light_kinds();
[[nodiscard]] std::size_t geometry_count();

/// Geometry `place` (0 .. geometry_count() - 1) with its materials, 96 x 72 pixels, one sample, seen by a camera that states everything.
[[nodiscard]] TreeScene base_scene(std::size_t place, Projection projection);

/// Everything that the core of the tree keeps fixed, varied one at a time.
void add_variations(std::vector<TreeScene>& tree);

/// Maps of every kind. Scenes of `textures/` are for the judge; those of `pictures/` show what it does not calculate.
void add_textures(std::vector<TreeScene>& tree);

[[nodiscard]] Mat4 translation(double x, double y, double z);
[[nodiscard]] Mat4 scaling(double x, double y, double z);
/// A rotation about an axis (0, 1, 2) whose cosine and sine are 0.8 and 0.6: exact decimals, no libm.
[[nodiscard]] Mat4 turned(int axis);

[[nodiscard]] const char* word(Lighting model);
[[nodiscard]] const char* word(Interpolation interpolation);
[[nodiscard]] const char* word(Projection projection);

}  // namespace lustro::truth
