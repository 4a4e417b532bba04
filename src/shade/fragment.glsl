#ifdef PHONG_INTERPOLATION
// Fragment shader: lights every fragment with the interpolated normal (Phong 1975).
#endif
#ifdef PER_VERTEX
// Fragment shader: the colour comes from the vertex shader.
#endif

precision highp float;
precision highp int;

#ifdef POSITION
in vec3 surface_position;  // the eye is the origin
#endif
#ifdef PHONG_INTERPOLATION
in vec3 surface_normal;
#endif
#ifdef GOURAUD
in vec3 front_color;
#ifdef TWO_SIDED
in vec3 back_color;
#endif
#endif
#ifdef FLAT
flat in vec3 front_color;
#ifdef TWO_SIDED
flat in vec3 back_color;
#endif
#endif
#ifdef PHONG_INTERPOLATION
#ifdef ORTHOGRAPHIC

uniform vec3 view_to_eye;  // V of an orthographic view: unit, opposite to the view direction
#endif
#endif

out vec4 fragment_color;
#ifdef PHONG_INTERPOLATION

#include "lighting.glsl"
#endif
#ifdef FOG

#include "fog.glsl"
#endif
#ifdef SRGB

// The sRGB transfer function (IEC 61966-2-1).
vec3 srgb_encode(vec3 linear) {
  return mix(linear * 12.92, pow(linear, vec3(1.0 / 2.4)) * 1.055 - vec3(0.055), step(vec3(0.0031308), linear));
}
#endif

void main() {
#ifdef PHONG_INTERPOLATION
  Surface s;
  s.position = surface_position;
  s.normal = normalize(surface_normal);
#ifdef TWO_SIDED
  if (!gl_FrontFacing) {
    s.normal = -s.normal;
  }
#endif
#ifdef ORTHOGRAPHIC
  s.to_eye = view_to_eye;
#else
  s.to_eye = normalize(-surface_position);
#endif
  vec3 color = sum(light_surface(s, material));
#endif
#ifdef PER_VERTEX
#ifdef TWO_SIDED
  vec3 color = gl_FrontFacing ? front_color : back_color;
#else
  vec3 color = front_color;
#endif
#endif
#ifdef FOG
  float clear = fog_factor(fog, length(surface_position));
  color = color * clear + fog.color * (1.0 - clear);
#endif
#ifdef SRGB
  color = clamp(color, 0.0, 1.0);
  color = srgb_encode(color);
#endif
  fragment_color = vec4(color, 1.0);
}
