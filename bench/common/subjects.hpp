// What every comparison draws: one family of closed, bumpy tori with shared vertices, one sheet that covers the picture, one scene.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/scene.hpp"

namespace lustro::bench {

/// A torus of radii 0.7 and about 0.3 about the y axis whose tube has low bumps; closed, counter-clockwise from outside, unit normals, every
/// vertex shared by six triangles. The triangles come ring by ring.
///
/// triangles  about so many: twice a product of two whole numbers
/// variation  shifts the bumps: different meshes of the same cost
[[nodiscard]] Mesh bumpy_torus(std::size_t triangles, int variation = 0);

/// A wavy sheet of 2 x 32 x 32 triangles over -1..1 in x and y that faces +z: more than the whole picture.
[[nodiscard]] Mesh wavy_sheet();

/// A subject by its name.
struct Subject {
  std::string name;        ///< `2k`, `5k`, `50k`, `70k`, `1m`, `10m`
  std::size_t triangles;   ///< about
  bool fills_the_picture;  ///< the sheet
};
[[nodiscard]] const std::vector<Subject>& subjects();
[[nodiscard]] const Subject* find_subject(std::string_view name);

/// The subject in the common scene: 1920 x 1080, two directional lights and a point light, Phong at every pixel with the exponent 24, lit on
/// both sides, values stored as they are (no sRGB encoding, which would cost the peers a power a channel), all of the camera stated. The torus
/// covers about 29 % of the picture, the sheet all of it.
[[nodiscard]] Scene common_scene(const Subject& subject, int samples);

/// world_from_object of frame `i`: every frame turns by 0.01 radians more, the torus about its axis, the sheet within its plane.
[[nodiscard]] Mat4 turned(const Subject& subject, int i);

}  // namespace lustro::bench
