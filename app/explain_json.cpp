// An Explanation as JSON, member by member: see explain_report.hpp.
#include "explain_report.hpp"
#include "scene/words.hpp"

namespace lustro::app {
namespace {

Json light_json(const LightExplanation& light) {
  return {{"light", light.light},
          {"name", light.name},
          {"to_light", json_vector(light.to_light)},
          {"reflected", json_vector(light.reflected)},
          {"half", json_vector(light.half)},
          {"distance", json_number(light.distance)},
          {"n_dot_l", json_number(light.n_dot_l)},
          {"r_dot_v", json_number(light.r_dot_v)},
          {"n_dot_h", json_number(light.n_dot_h)},
          {"attenuation", json_number(light.attenuation)},
          {"spot", json_number(light.spot)},
          {"visibility", json_number(light.visibility)},
          {"light_ambient", json_vector(light.light_ambient)},
          {"light_diffuse", json_vector(light.light_diffuse)},
          {"light_specular", json_vector(light.light_specular)},
          {"ambient", json_vector(light.ambient)},
          {"diffuse", json_vector(light.diffuse)},
          {"specular", json_vector(light.specular)}};
}

Json shading_json(const ShadingExplanation& shading) {
  Json lights = Json::array();
  for (const LightExplanation& light : shading.lights) {
    lights.push_back(light_json(light));
  }
  return {{"weight", json_number(shading.weight)},
          {"position", json_vector(shading.position)},
          {"normal", json_vector(shading.normal)},
          {"to_eye", json_vector(shading.to_eye)},
          {"k_ambient", json_vector(shading.k_ambient)},
          {"k_diffuse", json_vector(shading.k_diffuse)},
          {"k_specular", json_vector(shading.k_specular)},
          {"k_emission", json_vector(shading.k_emission)},
          {"shininess", json_number(shading.shininess)},
          {"clamp", json_vector(shading.clamp)},
          {"from_environment", json_vector(shading.from_environment)},
          {"openness", json_number(shading.openness)},
          {"scene_ambient", json_vector(shading.scene_ambient)},
          {"environment", json_vector(shading.environment)},
          {"ambient", json_vector(shading.ambient)},
          {"diffuse", json_vector(shading.diffuse)},
          {"specular", json_vector(shading.specular)},
          {"emission", json_vector(shading.emission)},
          {"lights", lights}};
}

Json map_json(const MapExplanation& map) {
  Json value = Json::array();
  for (const float channel : map.value) {
    value.push_back(json_number(channel));
  }
  return {{"map", map.map},
          {"name", map.name},
          {"u", json_number(map.u)},
          {"v", json_number(map.v)},
          {"level_of_detail", json_number(map.level_of_detail)},
          {"value", value},
          {"applies", map.applies}};
}

Json fragment_json(const FragmentExplanation& fragment) {
  Json maps = Json::array();
  for (const MapExplanation& map : fragment.maps) {
    maps.push_back(map_json(map));
  }
  Json shadings = Json::array();
  for (const ShadingExplanation& shading : fragment.shadings) {
    shadings.push_back(shading_json(shading));
  }
  return {{"object", fragment.object},
          {"object_name", fragment.object_name},
          {"triangle", fragment.triangle},
          {"material", fragment.material},
          {"material_name", fragment.material_name},
          {"front", fragment.front},
          {"samples", fragment.samples},
          {"opacity", json_number(fragment.opacity)},
          {"weight", json_number(fragment.weight)},
          {"x", json_number(fragment.x)},
          {"y", json_number(fragment.y)},
          {"depth", json_number(fragment.depth)},
          {"barycentrics", json_vector(fragment.barycentrics)},
          {"position", json_vector(fragment.position)},
          {"lighting", word_of(fragment.lighting)},
          {"coefficients", json_material(fragment.coefficients)},
          {"maps", maps},
          {"shadings", shadings},
          {"maps_ambient", json_vector(fragment.maps_ambient)},
          {"maps_diffuse", json_vector(fragment.maps_diffuse)},
          {"maps_specular", json_vector(fragment.maps_specular)},
          {"maps_emission", json_vector(fragment.maps_emission)},
          {"reflection", json_vector(fragment.reflection)},
          {"ambient", json_vector(fragment.ambient)},
          {"diffuse", json_vector(fragment.diffuse)},
          {"specular", json_vector(fragment.specular)},
          {"emission", json_vector(fragment.emission)},
          {"fog", json_vector(fragment.fog)},
          {"fog_factor", json_number(fragment.fog_factor)}};
}

}  // namespace

Json explanation_json(const Explanation& explanation) {
  Json fragments = Json::array();
  for (const FragmentExplanation& fragment : explanation.fragments) {
    fragments.push_back(fragment_json(fragment));
  }
  Json color = Json::array();
  for (const float channel : explanation.color) {
    color.push_back(json_number(channel));
  }
  return {{"x", explanation.x},
          {"y", explanation.y},
          {"interpolation", word_of(explanation.interpolation)},
          {"samples", explanation.samples},
          {"ambient_light", json_vector(explanation.ambient_light)},
          {"normalized", explanation.normalized},
          {"fragments", fragments},
          {"background_weight", json_number(explanation.background_weight)},
          {"ambient", json_vector(explanation.ambient)},
          {"diffuse", json_vector(explanation.diffuse)},
          {"specular", json_vector(explanation.specular)},
          {"emission", json_vector(explanation.emission)},
          {"fog", json_vector(explanation.fog)},
          {"background", json_vector(explanation.background)},
          {"color", color},
          {"bytes", explanation.bytes}};
}

}  // namespace lustro::app
