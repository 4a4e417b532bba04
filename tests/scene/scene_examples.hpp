// Scenes that several tests share.
#pragma once

#include <string>

namespace lustro {

/// The example of the scene format's contract.
inline const std::string kExampleScene = R"({
  "image":   {"width": 1024, "height": 768, "samples": 4, "transfer": "srgb", "background": [0.1, 0.1, 0.12]},
  "camera":  {"projection": "perspective", "eye": [1.6, 1.7, 3.4], "target": [0, 0, 0], "up": [0, 1, 0],
              "fov": 42, "near": 0.1, "far": 50},
  "shading": {"lighting": "phong", "interpolation": "phong", "normals": "lerp", "vertex_normals": "angle",
              "crease": 180, "terms": ["ambient", "diffuse", "specular", "emission"], "two_sided": false},
  "ambient": [0.2, 0.2, 0.2],
  "lights":  [
    {"type": "directional", "direction": [-0.4, -0.8, -0.6], "diffuse": [0.9, 0.9, 0.85], "specular": [0.9, 0.9, 0.85]},
    {"type": "point", "position": [2.2, 1.5, 2], "ambient": [0.05, 0.05, 0.1], "diffuse": [1, 0.8, 0.6],
     "specular": [1, 1, 1], "attenuation": {"constant": 1, "linear": 0.05, "quadratic": 0.03}},
    {"type": "spot", "position": [-1.5, 2.5, 2.5], "direction": [0.5, -0.9, -0.9], "cutoff": 28, "beam": 20,
     "exponent": 12, "attenuation": {"falloff": 2}}
  ],
  "materials": {
    "stone": "jade",
    "red":   {"ambient": [0.17, 0.01, 0.01], "diffuse": [0.61, 0.04, 0.04], "specular": [0.73, 0.63, 0.63],
              "emission": [0, 0, 0], "shininess": 76.8, "opacity": 1}
  },
  "objects": [
    {"mesh": "bunny.ply", "material": "stone"},
    {"mesh": "teapot.obj", "matrix": [1,0,0,0.5, 0,1,0,0, 0,0,1,0, 0,0,0,1]}
  ]
})";

}  // namespace lustro
