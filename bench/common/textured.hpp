// The torus of the comparisons under three maps.
#pragma once

#include "common/subjects.hpp"
#include "lustro/image.hpp"

namespace lustro::bench {

/// Pictures of 1024 x 1024 bytes, RGB, the top row first.
struct Maps {
  ByteImage diffuse, specular, normal;
};
[[nodiscard]] Maps make_maps();

/// common_scene() of a torus with texture coordinates and tangents under those maps, trilinear and repeated. The coordinates run to and fro
/// along both circles, so that every vertex has one pair of them.
[[nodiscard]] Scene textured_scene(const Subject& subject, const Maps& maps);

}  // namespace lustro::bench
