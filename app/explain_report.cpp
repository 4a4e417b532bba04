// An Explanation as text: see explain_report.hpp. Vectors stand in columns, so that a sum can be followed down the page.
#include "explain_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "math/power.hpp"
#include "report.hpp"
#include "scene/ground.hpp"
#include "scene/words.hpp"

namespace lustro::app {
namespace {

std::string number(float x) {
  return fmt::format("{:.6g}", x);
}
std::string columns(const Vec3f& v) {
  return fmt::format("{:>12.6g} {:>12.6g} {:>12.6g}", v.x, v.y, v.z);
}

std::string row(int indent, const std::string& name, const std::string& value, const std::string& how = {}) {
  constexpr int kNameColumns = 22;
  if (value.empty()) {
    return fmt::format("{:{}}{}\n", "", indent, name);
  }
  return fmt::format("{:{}}{:<{}}{}{}{}\n", "", indent, name, kNameColumns - indent, value, how.empty() ? "" : "   ", how);
}

std::string row(int indent, const std::string& name, const Vec3f& v, const std::string& how = {}) {
  return row(indent, name, columns(v), how);
}

std::string named(int index, const std::string& name) {
  return name.empty() ? fmt::format("{}", index) : fmt::format("{} {}", index, printable(name));
}

std::string percent(float share) {
  return fmt::format("{:.4g} %", static_cast<double>(share) * 100);
}

const char* specular_formula(Lighting lighting) {
  switch (lighting) {
    case Lighting::phong:
      return "max(R.V, 0)^n";
    case Lighting::blinn_phong:
      return "max(N.H, 0)^n";
    case Lighting::ggx:
      return "F D Vis max(N.L, 0)";
    case Lighting::lambert:
    case Lighting::constant:
      break;
  }
  return "0";
}

/// (R.V)^n or (N.H)^n as the equation has it.
float highlight(const FragmentExplanation& fragment, const LightExplanation& light) {
  const float cosine = fragment.lighting == Lighting::phong ? light.r_dot_v : light.n_dot_h;
  if (light.n_dot_l <= 0) {
    return 0;
  }
  const float n = fragment.coefficients.shininess;
  const bool varies = std::any_of(fragment.maps.begin(), fragment.maps.end(), [](const MapExplanation& map) { return map.map == "shininess"; });
  return varies ? power(std::max(cosine, 0.0F), LaneExponent<float>{n}) : power(std::max(cosine, 0.0F), n);
}

/// What GGX says of one light, beside its H.
std::string microfacet_text(const FragmentExplanation& fragment, const ShadingExplanation& shading, const LightExplanation& light) {
  const Surface<float> surface{.position = shading.position, .normal = shading.normal, .to_eye = shading.to_eye};
  const float alpha2 = 2 / (fragment.coefficients.shininess + 2);
  const Microfacets<float> facets = microfacets(surface, alpha2, light.to_light, light.n_dot_l);
  const Vec3f& k_s = fragment.coefficients.specular.rgb;
  const auto fresnel = [&](float k) { return std::min(k, 1.0F) + (1 - std::min(k, 1.0F)) * facets.grazing; };
  return row(6, "F", Vec3f{fresnel(k_s.x), fresnel(k_s.y), fresnel(k_s.z)}, "k_s + (1 - k_s) (1 - |V.H|)^5") +
         fmt::format("      V.H = {}   D Vis max(N.L, 0) = {}\n", number(dot(shading.to_eye, light.half)), number(facets.lobe));
}

std::string light_text(const PreparedScene& scene, const FragmentExplanation& fragment, const ShadingExplanation& shading,
                       const LightExplanation& light) {
  const ShadingLight& shining = scene.lights[static_cast<std::size_t>(light.light)];
  std::string text = row(4, fmt::format("light {}", named(light.light, light.name)), "");
  text += row(6, "L", light.to_light, "towards the light");
  const bool is_phong = fragment.lighting == Lighting::phong;
  const bool is_ggx = fragment.lighting == Lighting::ggx;
  const bool has_half = fragment.lighting == Lighting::blinn_phong || is_ggx;
  if (is_phong) {
    text += row(6, "R", light.reflected, "2 (N.L) N - L");
  }
  if (has_half) {
    text += row(6, "H", light.half, "(L + V) / |L + V|");
  }
  std::string scalars = fmt::format("N.L = {}", number(light.n_dot_l));
  if (is_phong) {
    scalars += fmt::format("   R.V = {}", number(light.r_dot_v));
  }
  if (has_half) {
    scalars += fmt::format("   N.H = {}", number(light.n_dot_h));
  }
  scalars += fmt::format("   f = {}   s = {}", number(light.attenuation), number(light.spot));
  if (shining.has_shadow) {
    scalars += fmt::format("   v = {}", number(light.visibility));
  }
  if (light.distance > 0) {
    scalars += fmt::format("   distance = {}", number(light.distance));
  }
  const char* dark = light.n_dot_l <= 0 ? "   (the light is behind the surface)" : light.visibility == 0 ? "   (in its shadow)" : "";
  text += fmt::format("      {}{}\n", scalars, dark);
  if (is_ggx) {
    text += microfacet_text(fragment, shading, light);
  }
  if (shining.ambient != Vec3f{}) {
    text += row(6, "l_a", shining.ambient);
  }
  text += row(6, "l_d", shining.diffuse);
  if (is_phong || has_half) {
    text += row(6, "l_s", shining.specular);
  }
  text += row(6, "ambient", light.ambient, scene.occlusion.empty() ? "f s k_a l_a" : "f s a k_a l_a");
  const char* v = shining.has_shadow ? " v" : "";
  text += row(6, "diffuse", light.diffuse, fmt::format("f s{} k_d l_d {}max(N.L, 0)", v, is_ggx ? "(1 - F) " : ""));
  if (is_ggx) {
    text += row(6, "specular", light.specular, fmt::format("f s{} l_s {}", v, specular_formula(fragment.lighting)));
  } else if (is_phong || has_half) {
    text += row(6, "specular", light.specular,
                fmt::format("f s{} k_s l_s spec, spec = {} = {}", v, specular_formula(fragment.lighting), number(highlight(fragment, light))));
  }
  return text;
}

std::string shading_text(const PreparedScene& scene, const Explanation& explanation, const FragmentExplanation& fragment,
                         const ShadingExplanation& shading, std::size_t index) {
  std::string text;
  if (explanation.interpolation == Interpolation::gouraud) {
    text += row(2, fmt::format("vertex {}", index), fmt::format("weight {}", number(shading.weight)));
  } else if (explanation.interpolation == Interpolation::flat) {
    text += row(2, "the face's centre", "");
  }
  text += row(4, "position", shading.position, "world");
  if (fragment.lighting == Lighting::constant) {
    return text + row(4, "diffuse", shading.diffuse, "k_d, unlit");
  }
  text += row(4, "N", shading.normal);
  text += row(4, "V", shading.to_eye, "towards the eye");
  const bool has_occlusion = !scene.occlusion.empty();
  if (has_occlusion) {
    text += row(4, "a", number(shading.openness), "the share of the hemisphere above that nothing near by hides");
  }
  text += row(4, "scene's ambient", shading.scene_ambient, has_occlusion ? "a k_a I_a" : "k_a I_a");
  if (scene.environment) {
    text += row(4, "environment", shading.environment, has_occlusion ? "a k_d E" : "k_d E");
  }
  for (const LightExplanation& light : shading.lights) {
    text += light_text(scene, fragment, shading, light);
  }
  const char* clamped = explanation.interpolation == Interpolation::gouraud ? ", clamped at the vertex" : "";
  text += row(4, "sum: ambient", shading.ambient, std::string("the scene's + the lights'") + clamped);
  text += row(4, "     diffuse", shading.diffuse);
  text += row(4, "     specular", shading.specular);
  return text + row(4, "     emission", shading.emission, "k_e");
}

std::string map_text(const MapExplanation& map) {
  const std::string value = fmt::format("{:>12.6g} {:>12.6g} {:>12.6g} {:>12.6g}", map.value[0], map.value[1], map.value[2], map.value[3]);
  std::string how = fmt::format("at {}, {}, level {}", number(map.u), number(map.v), number(std::max(map.level_of_detail, 0.0F)));
  how += map.applies ? "" : ", outside: it does not apply";
  return row(2, "  " + map.map + " map", value, map.name.empty() ? how : printable(map.name) + " " + how);
}

std::string fragment_text(const PreparedScene& scene, const Explanation& explanation, const FragmentExplanation& fragment, std::size_t index) {
  const Material& k = fragment.coefficients;
  std::string text = fmt::format("\nsurface {} of {}, seen by {} of {} samples, {} of the pixel\n", index + 1, explanation.fragments.size(),
                                 fragment.samples, explanation.samples, percent(fragment.weight));
  text += row(2, "object", named(fragment.object, fragment.object_name));
  text += row(2, "triangle", fmt::format("{}, its {}", fragment.triangle, fragment.front ? "front" : "back"));
  text += row(2, "barycentrics", fragment.barycentrics);
  text += row(2, "shaded at", fmt::format("{}, {} of the picture, depth {}", number(fragment.x), number(fragment.y), number(fragment.depth)));
  text += row(2, "position", fragment.position, "world");
  if (fragment.opacity < 1) {
    text += row(2, "opacity", number(fragment.opacity), "the share of what lies behind that it hides");
  }
  text += row(2, "material", named(fragment.material, fragment.material_name.empty() ? "(the default)" : fragment.material_name),
              fmt::format("lighting {}", word_of(fragment.lighting)));
  if (catches_shadows(k)) {
    return text +
           "\n  It is black, and hides 1 - lit / unhindered: the light of a white Lambert surface here, with shadows and occlusion and "
           "without.\n\n";
  }
  text += row(2, "  k_a", k.ambient.rgb) + row(2, "  k_d", k.diffuse.rgb) + row(2, "  k_s", k.specular.rgb) + row(2, "  k_e", k.emission.rgb);
  text += row(2, "  n", number(k.shininess));
  for (const MapExplanation& map : fragment.maps) {
    text += map_text(map);
  }
  const char* a = scene.occlusion.empty() ? "" : "a ";
  if (fragment.lighting == Lighting::ggx) {
    text += fmt::format(
        "\n  I = k_e + {0}k_a I_a + sum over the lights of f s [ {0}k_a l_a + {1}k_d l_d (1 - F) max(N.L, 0) + l_s {2}{3} ]\n"
        "  alpha^2 = 2 / (n + 2) = {4}\n\n",
        a, scene.shadows.empty() ? "" : "v (", specular_formula(fragment.lighting), scene.shadows.empty() ? "" : ")",
        number(2 / (k.shininess + 2)));
  } else if (fragment.lighting != Lighting::constant) {
    const bool has_shadows = !scene.shadows.empty();
    text += fmt::format(
        "\n  I = k_e + {0}k_a I_a + sum over the lights of f s [ {0}k_a l_a + {1}k_d l_d max(N.L, 0) + k_s l_s spec{2} ]\n  spec = {3}{4}\n\n",
        a, has_shadows ? "v (" : "", has_shadows ? ")" : "", specular_formula(fragment.lighting),
        fragment.lighting == Lighting::lambert ? "" : ", 0 where N.L <= 0");
  } else {
    text += "\n  I = k_d, unlit\n\n";
  }
  for (std::size_t i = 0; i < fragment.shadings.size(); ++i) {
    text += shading_text(scene, explanation, fragment, fragment.shadings[i], i);
  }
  if (fragment.reflection != Vec3f{}) {
    text += row(2, "reflection", fragment.reflection, "k_s times the reflection map: more of specular");
  }
  if (fragment.fog_factor != 1) {
    text += row(2, "fog", fragment.fog, fmt::format("the surface counts {}", number(fragment.fog_factor)));
  }
  return text;
}

}  // namespace

bool terms_sum_to_color(const Explanation& e) {
  const Vec3f sum = ((((e.ambient + e.diffuse) + e.specular) + e.emission) + e.fog) + e.background;
  return sum == Vec3f{e.color[0], e.color[1], e.color[2]};
}

std::string explanation_text(const Scene& scene, const PreparedScene& prepared, const Explanation& e) {
  std::string text = fmt::format("pixel {}, {} of {} x {}: interpolation {}, {} {}\n", e.x, e.y, scene.image.width, scene.image.height,
                                 word_of(e.interpolation), e.samples, e.samples == 1 ? "sample" : "samples");
  for (std::size_t i = 0; i < e.fragments.size(); ++i) {
    text += fragment_text(prepared, e, e.fragments[i], i);
  }
  if (e.background_weight > 0) {
    text += fmt::format("\nbackground, {} of the pixel\n", percent(e.background_weight));
  }
  text += "\nthe pixel: each surface's terms by its share of the pixel\n";
  text += row(2, "  ambient", e.ambient) + row(2, "+ diffuse", e.diffuse) + row(2, "+ specular", e.specular) + row(2, "+ emission", e.emission);
  text += row(2, "+ fog", e.fog) + row(2, "+ background", e.background);
  text += row(2, "= colour", Vec3f{e.color[0], e.color[1], e.color[2]}, fmt::format("alpha {}", number(e.color[3])));
  return text + row(2, "stored", fmt::format("{:>12} {:>12} {:>12}", e.bytes[0], e.bytes[1], e.bytes[2]),
                    fmt::format("alpha {}   #{:02x}{:02x}{:02x}   transfer {}", e.bytes[3], e.bytes[0], e.bytes[1], e.bytes[2],
                                word_of(scene.image.transfer)));
}

}  // namespace lustro::app
