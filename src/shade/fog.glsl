// Fog on the Euclidean distance from the eye: the mirror of shade/fog.hpp (OpenGL 2.1 specification, equations 3.31 to 3.33).

const int kFogLinear = 0;
const int kFogExp = 1;
const int kFogExp2 = 2;

struct ShadingFog {
  int mode;
  float density;
  float end;
  float range_scale;  // 1 / (end - start)
  vec3 color;
};

uniform ShadingFog fog;

// f: the share of the surface's colour that reaches the eye, 0..1.
//   linear (end - d) / (end - start)      exp e^(-density d)      exp2 e^(-(density d)^2)
float fog_factor(ShadingFog f, float d) {
  if (f.mode == kFogLinear) {
    return clamp((f.end - d) * f.range_scale, 0.0, 1.0);
  }
  float depth = f.density * d;
  return clamp(exp2((f.mode == kFogExp ? depth : depth * depth) * -1.44269504), 0.0, 1.0);
}
