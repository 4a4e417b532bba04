#ifdef PHONG_INTERPOLATION
// Vertex shader: brings the vertex and its normal to the fragments, which are lit one by one (Phong 1975).
#endif
#ifdef GOURAUD
// Vertex shader: lights the vertex; the colour, clamped to 0..1 here, is interpolated (Gouraud 1971).
#endif
#ifdef FLAT
// Vertex shader: lights the face once, at its centre, with its normal; every fragment gets that colour. The three vertices of a face carry the
// same face_center and face_normal, so it does not matter which of them is the provoking one.
#endif

precision highp float;
precision highp int;

layout(location = 0) in vec3 position;  // object space
#ifdef FLAT
layout(location = 1) in vec3 face_normal;  // object space, unit
layout(location = 2) in vec3 face_center;  // object space
#else
layout(location = 1) in vec3 normal;  // object space, unit
#endif

uniform mat4 eye_from_object;     // to a space with the eye as its origin, without scaling lengths: lights and materials live there
uniform mat4 clip_from_eye;       // the projection
uniform mat3 normal_from_object;  // inverse transpose of the upper left of eye_from_object
#ifdef PER_VERTEX
#ifdef ORTHOGRAPHIC
uniform vec3 view_to_eye;  // V of an orthographic view: unit, opposite to the view direction
#endif
#endif

#ifdef POSITION
out vec3 surface_position;  // the eye is the origin
#endif
#ifdef PHONG_INTERPOLATION
out vec3 surface_normal;
#endif
#ifdef GOURAUD
out vec3 front_color;
#ifdef TWO_SIDED
out vec3 back_color;
#endif
#endif
#ifdef FLAT
flat out vec3 front_color;
#ifdef TWO_SIDED
flat out vec3 back_color;
#endif
#endif
#ifdef PER_VERTEX

#include "lighting.glsl"

// The colour of one side of the surface at a point.
vec3 color_at(vec3 place, vec3 n) {
  Surface s;
  s.position = place;
  s.normal = n;
#ifdef ORTHOGRAPHIC
  s.to_eye = view_to_eye;
#else
  s.to_eye = normalize(-place);
#endif
#ifdef GOURAUD
  return clamp(sum(light_surface(s, material)), 0.0, 1.0);
#else
  return sum(light_surface(s, material));
#endif
}
#endif

void main() {
  vec4 place = eye_from_object * vec4(position, 1.0);
  gl_Position = clip_from_eye * place;
#ifdef POSITION
  surface_position = vec3(place);
#endif
#ifdef PHONG_INTERPOLATION
  surface_normal = normalize(normal_from_object * normal);
#endif
#ifdef GOURAUD
  vec3 n = normalize(normal_from_object * normal);
  front_color = color_at(vec3(place), n);
#ifdef TWO_SIDED
  back_color = color_at(vec3(place), -n);
#endif
#endif
#ifdef FLAT
  vec3 center = vec3(eye_from_object * vec4(face_center, 1.0));
  vec3 n = normalize(normal_from_object * face_normal);
  front_color = color_at(center, n);
#ifdef TWO_SIDED
  back_color = color_at(center, -n);
#endif
#endif
}
