// THE lighting equation in GLSL ES 3.00: the mirror of shade/lighting.hpp, line for line. pow() stands where the C++ has power(), within its error.
//
#ifdef CONSTANT
//   I = k_d
#else
//   I = k_e + k_a I_a + sum_i f_i s_i [ k_a l_a + k_d l_d max(N.L, 0) + k_s l_s spec ]
//
#endif
#ifdef LAMBERT
//   spec = 0                 Lambert 1760
#endif
#ifdef PHONG
//   spec = max(R.V, 0)^n     Phong 1975, R = 2 (N.L) N - L; 0 where N.L <= 0
#endif
#ifdef BLINN_PHONG
//   spec = max(N.H, 0)^n     Blinn 1977, H = (L + V) / |L + V|; 0 where N.L <= 0
#endif
#ifdef GGX
//   k_d (1 - F) in place of k_d, and k_s spec = F D Vis max(N.L, 0), the microfacets of glTF 2.0, appendix B
#endif

// A point to be lit. The eye is the origin.
struct Surface {
  vec3 position;  // relative to the eye
  vec3 normal;    // N, unit, on the side that is seen
  vec3 to_eye;    // V, unit
};

// The material at that point.
struct Coefficients {
  vec3 ambient, diffuse, specular, emission;
  float shininess;
};

#ifndef CONSTANT
const int kDirectional = 0;
const int kPoint = 1;
const int kSpot = 2;

// A light, ready to shine.
struct ShadingLight {
  int type;
  vec3 position;  // relative to the eye
  vec3 travel;    // unit, the way that the light travels
  vec3 ambient, diffuse, specular;
  vec3 attenuation;         // constant, linear, quadratic; (1, 0, 0) does not attenuate
  float falloff;            // p of 1/d^p where p is none of 0, 1, 2 (those are polynomials), else 0
  float attenuation_limit;  // 1, or a huge number for no limit
  float range_scale;        // 1 / range; 0: none
  float cos_cutoff;
  float cos_beam;
  float beam_scale;  // 1 / (cos_beam - cos_cutoff); 0: no beam
  bool fades_quadratically;  // else by smoothstep
  float exponent;
};

// How a light arrives at a point.
struct Incident {
  vec3 to_light;      // L, unit
  float distance;     // 0 for a directional light
  float attenuation;  // f
  float spot;         // s
};

// One light's part of the sum.
struct LightTerms {
  vec3 ambient, diffuse, specular;
};
#endif

// The whole sum, term by term.
struct Terms {
  vec3 ambient, diffuse, specular, emission;
};

uniform Coefficients material;
#ifndef CONSTANT
uniform vec3 ambient_light;  // I_a
const int kMaxLights = 8;
uniform ShadingLight lights[kMaxLights];
#ifndef KNOWN_LIGHTS
uniform int light_count;
#endif
#endif

// The colour is the sum of the terms in exactly this order.
vec3 sum(Terms terms) {
  vec3 color = vec3(0.0);
#ifdef AMBIENT
  color += terms.ambient;
#endif
#ifdef DIFFUSE
  color += terms.diffuse;
#endif
#ifdef SPECULAR
  color += terms.specular;
#endif
#ifdef EMISSION
  color += terms.emission;
#endif
  return color;
}
#ifndef CONSTANT

// x^n with the conventions of lighting: x^0 = 1 for every x, negative x counts as 0, 0 to a positive power is 0. pow() alone leaves the first
// two open. What is raised to a negative power is a distance, which is never 0.
float power(float x, float n) {
  return n == 0.0 ? 1.0 : pow(max(x, 0.0), n);
}

// f = 1 / (c + l d + q d^2), or 1 / d^p; at most the limit.
float fall_off(ShadingLight light, float d) {
  float attenuation;
  if (light.falloff == 0.0) {
    if (light.attenuation == vec3(1.0, 0.0, 0.0)) {
      return 1.0;
    }
    vec3 c = light.attenuation;
    attenuation = 1.0 / (c.x + (c.y + c.z * d) * d);
  } else {
    attenuation = power(d, -light.falloff);
  }
  return min(attenuation, light.attenuation_limit);
}

// f, where a range is stated times clamp(1 - (d / range)^4, 0, 1).
float attenuate(ShadingLight light, float d) {
  float attenuation = fall_off(light, d);
  if (light.range_scale == 0.0) {
    return attenuation;
  }
  float share = d * light.range_scale;
  float square = share * share;
  return attenuation * clamp(1.0 - square * square, 0.0, 1.0);
}

// s = 0 outside the cutoff, else cs^exponent, faded from 1 at the beam to 0 at the cutoff by smoothstep between the cosines, or by t^2.
float spot_factor(ShadingLight light, float cs) {
  float spot = power(cs, light.exponent);
  if (light.beam_scale != 0.0) {
    float t = clamp((cs - light.cos_cutoff) * light.beam_scale, 0.0, 1.0);
    spot = spot * (t * t * (light.fades_quadratically ? 1.0 : 3.0 - 2.0 * t));
  }
  return cs < light.cos_cutoff ? 0.0 : spot;
}

// L, distance, f and s of a light at a point.
Incident incident_light(ShadingLight light, vec3 position) {
  Incident incident;
  if (light.type == kDirectional) {
    incident.to_light = -light.travel;
    incident.distance = 0.0;
    incident.attenuation = 1.0;
    incident.spot = 1.0;
    return incident;
  }
  vec3 offset = light.position - position;
  incident.distance = sqrt(max(dot(offset, offset), 1e-30));  // in the light itself L is 0: no diffuse, no highlight
  incident.to_light = offset * (1.0 / incident.distance);
  incident.attenuation = attenuate(light, incident.distance);
  incident.spot = 1.0;
  if (light.type == kPoint) {
    return incident;
  }
  incident.spot = spot_factor(light, -dot(light.travel, incident.to_light));
  return incident;
}
#ifdef PHONG

// R = 2 (N.L) N - L
vec3 reflect_about(vec3 normal, vec3 to_light) {
  return normal * (2.0 * dot(normal, to_light)) - to_light;
}

// R.V
float r_dot_v(Surface s, vec3 to_light) {
  return dot(reflect_about(s.normal, to_light), s.to_eye);
}
#endif
#ifdef BLINN_PHONG

// N.H, 0 where L and V are opposite and H does not exist.
float n_dot_h(Surface s, vec3 to_light) {
  vec3 both = to_light + s.to_eye;
  return dot(s.normal, both) / max(length(both), 1e-15);
}
#endif
#ifndef LAMBERT
#ifndef GGX
#ifdef NORMALIZED

// What makes the lobe reflect exactly the share k_s of a uniform environment at normal incidence.
float lobe_normalization(float n) {
#ifdef PHONG
  return (n + 2.0) * 0.5;  // Lafortune and Willems 1994, times pi for classic units
#endif
#ifdef BLINN_PHONG
  return ((n + 2.0) * (n + 4.0)) / (8.0 * (exp2(n * -0.5) + n));
#endif
}
#endif

// spec, gated: 0 where N.L <= 0.
float specular_factor(Surface s, float shininess, vec3 to_light, float n_dot_l) {
#ifdef PHONG
  float cosine = r_dot_v(s, to_light);
#endif
#ifdef BLINN_PHONG
  float cosine = n_dot_h(s, to_light);
#endif
  float spec = power(max(cosine, 0.0), shininess);
#ifdef NORMALIZED
  spec = spec * (lobe_normalization(shininess) * n_dot_l);
#endif
  return n_dot_l > 0.0 ? spec : 0.0;
}
#endif
#endif
#ifdef GGX

// F, D and Vis of GGX, but for the colour of F.
struct Microfacets {
  float grazing;  // (1 - |V.H|)^5
  float lobe;     // D Vis N.L, 0 where N.L <= 0
};

// D's (N.H)^2 (a - 1) + 1 is a (N.H)^2 + |N x H|^2, which does not cancel where the lobe is narrow.
Microfacets microfacets(Surface s, float a, vec3 to_light, float n_dot_l) {
  vec3 both = to_light + s.to_eye;
  float square = max(dot(both, both), 1e-12);  // below it L and V are opposite, and H does not exist
  float from_grazing = max(1.0 - abs(dot(s.to_eye, both)) / sqrt(square), 0.0);
  float from_grazing2 = from_grazing * from_grazing;
  float along = dot(s.normal, both);
  vec3 across = cross(s.normal, both);
  float spread = max((a * (along * along) + dot(across, across)) / square, a);
  float n_dot_v = abs(dot(s.normal, s.to_eye));
  float masking_l = n_dot_l + sqrt(a + (1.0 - a) * (n_dot_l * n_dot_l));
  float masking_v = n_dot_v + sqrt(a + (1.0 - a) * (n_dot_v * n_dot_v));
  float lobe = (a * n_dot_l) / ((spread * spread) * (masking_l * masking_v));
  Microfacets facets;
  facets.grazing = (from_grazing2 * from_grazing2) * from_grazing;
  facets.lobe = n_dot_l > 0.0 ? lobe : 0.0;
  return facets;
}

// One light's part by GGX, times pi for classic units. a = alpha^2 = 2 / (n + 2).
//   F   = k_s + (1 - k_s) (1 - |V.H|)^5
//   D   = a / ((N.H)^2 (a - 1) + 1)^2
//   Vis = 1 / ((N.L + sqrt(a + (1 - a) (N.L)^2)) (|N.V| + sqrt(a + (1 - a) (N.V)^2)))
LightTerms reflect_light(Surface s, Coefficients k, ShadingLight light, Incident incident) {
  float share = incident.attenuation * incident.spot;
  float n_dot_l = dot(s.normal, incident.to_light);
  LightTerms part;
  part.ambient = (k.ambient * light.ambient) * share;
  Microfacets facets = microfacets(s, 2.0 / (k.shininess + 2.0), incident.to_light, n_dot_l);
  vec3 facing = min(k.specular, vec3(1.0));
  vec3 not_facing = vec3(1.0) - facing;
  vec3 fresnel = facing + not_facing * facets.grazing;
  part.diffuse = ((k.diffuse * light.diffuse) * (share * max(n_dot_l, 0.0))) * (not_facing * (1.0 - facets.grazing));
  part.specular = (light.specular * fresnel) * (share * facets.lobe);
  return part;
}
#else

// f s [ k_a l_a + k_d l_d max(N.L, 0) + k_s l_s spec ]: one light's part.
LightTerms reflect_light(Surface s, Coefficients k, ShadingLight light, Incident incident) {
  float strength = incident.attenuation * incident.spot;
  float n_dot_l = dot(s.normal, incident.to_light);
  LightTerms part;
  part.ambient = (k.ambient * light.ambient) * strength;
  part.diffuse = (k.diffuse * light.diffuse) * (strength * max(n_dot_l, 0.0));
#ifdef LAMBERT
  part.specular = vec3(0.0);
#else
  float spec = specular_factor(s, k.shininess, incident.to_light, n_dot_l);
  part.specular = (k.specular * light.specular) * (strength * spec);
#endif
  return part;
}
#endif

// The sum with one more light.
Terms add_light(Terms terms, Surface s, Coefficients k, ShadingLight light) {
  Incident incident = incident_light(light, s.position);
  LightTerms part = reflect_light(s, k, light, incident);
  terms.ambient += part.ambient;
  terms.diffuse += part.diffuse;
  terms.specular += part.specular;
  return terms;
}
#endif

// The whole equation at one point.
Terms light_surface(Surface s, Coefficients k) {
  Terms terms;
#ifdef CONSTANT
  terms.ambient = vec3(0.0);
  terms.diffuse = k.diffuse;
  terms.specular = vec3(0.0);
  terms.emission = vec3(0.0);
#else
  terms.ambient = k.ambient * ambient_light;
  terms.diffuse = vec3(0.0);
  terms.specular = vec3(0.0);
  terms.emission = k.emission;
#ifdef KNOWN_LIGHTS
  KNOWN_LIGHTS
#else
  for (int i = 0; i < light_count; ++i) {
    terms = add_light(terms, s, k, lights[i]);
  }
#endif
#endif
  return terms;
}
