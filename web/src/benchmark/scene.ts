// What is measured: 70 thousand triangles, three lights of three kinds, 960 x 540 pixels, one sample each.
import type { RenderRequest } from "../engine/types";

export const kRequest: RenderRequest = {
  width: 960,
  height: 540,
  samples: 1,
  scene: {
    image: { width: 960, height: 540, samples: 1 },
    camera: { eye: [0, 1.5, 2.2], target: [0, 0, 0], up: [0, 1, 0], near: 0.5, far: 6 },
    lights: [
      { type: "directional", direction: [-1, -1, -1] },
      { type: "point", position: [2, 2, 2], diffuse: [0.5, 0.4, 0.3] },
      { type: "spot", position: [-2, 3, 2], direction: [0.5, -1, -0.5], cutoff: 40, beam: 30 },
    ],
    shading: { cull: "back" },
    objects: [{ mesh: "primitive:torus:264", material: { diffuse: [0.5, 0.4, 0.3], specular: [0.5, 0.5, 0.5], shininess: 32 } }],
  },
};
