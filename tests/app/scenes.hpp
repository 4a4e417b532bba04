// Small inputs for the tests of the command.
#pragma once

#include <string>

namespace lustro::testing {

/// A square that faces +z, in front of a camera at (0, 0, 3); 32 x 24 pixels.
inline std::string square_obj() {
  return "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";
}

inline std::string square_scene(const std::string& more = "") {
  return R"({"image": {"width": 32, "height": 24}, "camera": {"eye": [0, 0, 3], "target": [0, 0, 0]},
             "lights": [{"type": "directional", "direction": [0, 0, -1]}, {"type": "point", "position": [1, 1, 2], "name": "lamp"}],
             "objects": [{"mesh": "square.obj", "material": "jade"}])" +
         more + "}";
}

/// A single triangle behind the camera of square_scene().
inline std::string behind_obj() {
  return "v -1 -1 9\nv 1 -1 9\nv 1 1 9\nf 1 2 3\n";
}

}  // namespace lustro::testing
