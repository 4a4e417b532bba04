// The keys of a light, of its `attenuation`, of `fog`, of `environment`, `shadow`, `occlusion` and `ground`.
#include <array>

#include "scene/fields.hpp"

namespace lustro {
namespace {

constexpr Range kColor{.lower = 0};
constexpr Range kNotNegative{.lower = 0};
constexpr Range kPositive{.lower = 0, .lower_open = true};
constexpr Range kHalfAngle{.lower = 0, .upper = 90};
constexpr Range kExponent{.lower = 0, .upper = 10000};

constexpr std::array kLightFields{
    Field<Light>{"type", "", at<&Light::type>, "what kind of light it is"},
    Field<Light>{"name", "", at<&Light::name>, "what messages, layers and `explain` call it"},
    Field<Light>{"position", "", at<&Light::position>, "where it stands; of an area its centre; not of a directional one", "world units"},
    Field<Light>{"direction", "", at<&Light::direction>,
                 "the way that the light travels (directional, spot), or that an area faces (rectangle, disk), of any length but 0"},
    Field<Light>{"ambient", "", at<&Light::ambient>, "its ambient colour l_a", "", kColor},
    Field<Light>{"diffuse", "", at<&Light::diffuse>, "its diffuse colour l_d; of an area (rectangle, disk, sphere) the radiance that it emits",
                 "", kColor},
    Field<Light>{"specular", "", at<&Light::specular>, "its specular colour l_s", "", kColor},
    Field<Light>{"attenuation", "", at<&Light::attenuation>, "how a point or spot light fades with the distance", "", {}, "none"},
    Field<Light>{"cutoff", "", at<&Light::cutoff>, "half angle of a spot light's cone", "degrees", kHalfAngle},
    Field<Light>{"beam", "", at<&Light::beam>, "half angle inside which a spot light is at its full; it fades from there to the cutoff",
                 "degrees", kHalfAngle, "a hard edge at the cutoff"},
    Field<Light>{"fade", "", at<&Light::fade>, "how a spot light falls from its beam to the cutoff; t goes from 0 to 1 with the cosine"},
    Field<Light>{"exponent", "", at<&Light::exponent>, "a spot light falls off with the cosine from its axis to this power", "", kExponent},
    Field<Light>{"size", "", at<&Light::size>, "the edges of a rectangle", "world units", kPositive},
    Field<Light>{"x_axis", "", at<&Light::x_axis>, "the way of a rectangle's first edge, made perpendicular to `direction`", "", {}, "level"},
    Field<Light>{"radius", "", at<&Light::radius>, "of a disk or a sphere", "world units", kPositive},
    Field<Light>{"shadow", "", at<&Light::shadow>, "where the scene has shadows: this light throws some"},
};

constexpr std::array kAttenuationFields{
    Field<Attenuation>{"constant", "", at<&Attenuation::constant>, "c in f = 1 / (c + l d + q d^2)", "", kNotNegative},
    Field<Attenuation>{"linear", "", at<&Attenuation::linear>, "l in f = 1 / (c + l d + q d^2)", "", kNotNegative},
    Field<Attenuation>{"quadratic", "", at<&Attenuation::quadratic>, "q in f = 1 / (c + l d + q d^2)", "", kNotNegative},
    Field<Attenuation>{"falloff", "", at<&Attenuation::falloff>, "p in f = 1 / d^p, in place of the three others", "", kNotNegative,
                       "the three others"},
    Field<Attenuation>{"unclamped", "", at<&Attenuation::unclamped>, "without it f is limited to 1"},
    Field<Attenuation>{"range", "", at<&Attenuation::range>, "where the light ends: f is multiplied by clamp(1 - (d / range)^4, 0, 1)",
                       "world units", Range{.lower = 0, .lower_open = true}, "it has no end"},
};

constexpr std::array kFogFields{
    Field<Fog>{"mode", "", at<&Fog::mode>, "how the share f of the surface's own colour falls with the distance d from the eye"},
    Field<Fog>{"density", "", at<&Fog::density>, "of exp and exp2", "1 / world units", kNotNegative},
    Field<Fog>{"start", "", at<&Fog::start>, "of linear: no fog nearer than this", "world units"},
    Field<Fog>{"end", "", at<&Fog::end>, "of linear: nothing but fog farther than this", "world units"},
    Field<Fog>{"color", "", at<&Fog::color>, "what everything fades to", "", kColor},
};

constexpr std::array kEnvironmentFields{
    Field<Environment>{"file",
                       "",
                       at<&Environment::file>,
                       "a picture of all directions, laid out as a reflection map's sphere, relative to the scene file",
                       "",
                       {},
                       "none"},
    Field<Environment>{"color", "", at<&Environment::color>, "where there is no picture: the same from everywhere", "", kColor},
    Field<Environment>{"gain", "", at<&Environment::gain>, "what it is multiplied by", "", kNotNegative},
    Field<Environment>{"rotation", "", at<&Environment::rotation>, "about +y, counter-clockwise seen from above", "degrees"},
    Field<Environment>{"visible", "", at<&Environment::visible>, "it is the background, too"},
};

constexpr Range kMapSize{.lower = 16, .upper = 8192};
constexpr Range kSoftness{.lower = 0, .upper = 16};

constexpr std::array kShadowFields{
    Field<ShadowSettings>{"size", "--shadow-size", at<&ShadowSettings::size>,
                          "side of a light's map; each of the six that look around a point light has half of it", "texels", kMapSize},
    Field<ShadowSettings>{"softness", "--shadow-softness", at<&ShadowSettings::softness>, "how far edges are blurred on either side", "texels",
                          kSoftness},
};

constexpr Range kDirections{.lower = 4, .upper = 1024};
constexpr Range kUnit{.lower = 0, .upper = 1};
constexpr Range kOcclusionSize{.lower = 16, .upper = 1024};

constexpr std::array kOcclusionFields{
    Field<OcclusionSettings>{"directions", "--occlusion-directions", at<&OcclusionSettings::directions>, "that are looked into from each point",
                             "", kDirections},
    Field<OcclusionSettings>{"size", "--occlusion-size", at<&OcclusionSettings::size>,
                             "lines of a direction that lie beside each other, on a side of the scene", "", kOcclusionSize},
    Field<OcclusionSettings>{"radius", "--occlusion-radius", at<&OcclusionSettings::radius>,
                             "what is farther away hides nothing, from half of it on ever less", "world units", kPositive,
                             "a quarter of the diagonal of the scene's box"},
};

constexpr std::array kGroundFields{
    Field<GroundSettings>{
        "height", "--ground-height", at<&GroundSettings::height>, "its y in the world", "world units", {}, "that of the lowest point"},
    Field<GroundSettings>{"strength", "--ground-strength", at<&GroundSettings::strength>, "how dense the deepest shadow is", "", kUnit},
};

}  // namespace

template <>
std::span<const Field<OcclusionSettings>> fields<OcclusionSettings>() {
  return kOcclusionFields;
}

template <>
std::span<const Field<GroundSettings>> fields<GroundSettings>() {
  return kGroundFields;
}

template <>
std::span<const Field<Environment>> fields<Environment>() {
  return kEnvironmentFields;
}

template <>
std::span<const Field<ShadowSettings>> fields<ShadowSettings>() {
  return kShadowFields;
}

template <>
std::span<const Field<Light>> fields<Light>() {
  return kLightFields;
}

template <>
std::span<const Field<Attenuation>> fields<Attenuation>() {
  return kAttenuationFields;
}

template <>
std::span<const Field<Fog>> fields<Fog>() {
  return kFogFields;
}

}  // namespace lustro
