// The tables of words. A new value of an enum gets its line here, and everything that names options knows it.
#include "scene/words.hpp"

#include <array>

#include "scene/nearest.hpp"

namespace lustro {
namespace {

template <class E>
constexpr Word word(E value, std::string_view text, std::string_view help) {
  return {static_cast<std::uint8_t>(value), text, help};
}

constexpr std::array kLighting{
    word(Lighting::constant, "constant", "the diffuse colour alone, unlit"),
    word(Lighting::lambert, "lambert", "ambient and diffuse, no highlight (Lambert 1760)"),
    word(Lighting::phong, "phong", "highlight by (R.V)^n (Phong 1975)"),
    word(Lighting::blinn_phong, "blinn-phong", "highlight by (N.H)^n (Blinn 1977)"),
    word(Lighting::ggx, "ggx", "microfacets as glTF 2.0 asks, alpha^2 = 2 / (n + 2) (Walter et al. 2007)"),
};
constexpr std::array kInterpolation{
    word(Interpolation::flat, "flat", "lit once a face, at its centre, with the face's normal"),
    word(Interpolation::gouraud, "gouraud", "lit at the vertices; the clamped colour is interpolated (Gouraud 1971)"),
    word(Interpolation::phong, "phong", "lit at every pixel with the interpolated normal (Phong 1975)"),
};
constexpr std::array kNormalInterpolation{
    word(NormalInterpolation::lerp, "lerp", "weighted sum, then normalised"),
    word(NormalInterpolation::slerp, "slerp", "spherical weighted average (Buss and Fillmore 2001)"),
};
constexpr std::array kVertexNormals{
    word(VertexNormals::uniform, "uniform", "the sum of the unit normals of the faces around the vertex"),
    word(VertexNormals::area, "area", "weighted by the faces' areas"),
    word(VertexNormals::angle, "angle", "weighted by the faces' angles at the vertex"),
};
constexpr std::array kCulling{
    word(Culling::none, "none", "both sides of a face are drawn"),
    word(Culling::back, "back", "faces that are seen from behind are left out: of a closed mesh nothing is missed"),
    word(Culling::front, "front", "faces that are seen from the front are left out: a look inside"),
};
constexpr std::array kWrap{
    word(Wrap::repeat, "repeat", "the picture again"),
    word(Wrap::mirrored_repeat, "mirrored_repeat", "the picture again, every other one mirrored"),
    word(Wrap::clamp_to_edge, "clamp_to_edge", "the texels of the edge"),
    word(Wrap::clamp_to_border, "clamp_to_border", "the colour `border`"),
};
constexpr std::array kTextureFilter{
    word(TextureFilter::nearest, "nearest", "the nearest texel"),
    word(TextureFilter::linear, "linear", "the four around the place, blended"),
};
constexpr std::array kMipFilter{
    word(MipFilter::none, "none", "the picture itself, however small it appears"),
    word(MipFilter::nearest, "nearest", "the level next to the footprint's size"),
    word(MipFilter::linear, "linear", "the two levels around it, blended"),
};
constexpr std::array kTextureChannel{
    word(TextureChannel::automatic, "auto", "the luminance; of opacity the alpha of a picture that has one"),
    word(TextureChannel::red, "red", "the first channel"),
    word(TextureChannel::green, "green", "the second one"),
    word(TextureChannel::blue, "blue", "the third one"),
    word(TextureChannel::alpha, "alpha", "the fourth one; 1 where there is none"),
    word(TextureChannel::luminance, "luminance", "0.2126 red + 0.7152 green + 0.0722 blue"),
};
constexpr std::array kReflectionShape{
    word(ReflectionShape::sphere, "sphere", "one picture: longitude from left to right, its middle towards -z, +y at its top"),
    word(ReflectionShape::cube, "cube", "six pictures"),
};
constexpr std::array kAlphaMode{
    word(AlphaMode::blend, "blend", "the share of what lies behind that is hidden"),
    word(AlphaMode::mask, "mask", "there is a surface where it is alpha_cutoff or more, else nothing"),
    word(AlphaMode::opaque, "opaque", "nothing: the surface hides what lies behind"),
};
constexpr std::array kTransfer{
    word(Transfer::none, "none", "every colour as it stands, stored as it is, as classic OpenGL did"),
    word(Transfer::srgb, "srgb", "lit in linear light, stored with the sRGB encoding"),
};
constexpr std::array kToneOperator{
    word(ToneOperator::none, "none", "what is brighter than 1 is stored as 1"),
    word(ToneOperator::reinhard, "reinhard", "c / (1 + luminance) (Reinhard et al. 2002)"),
    word(ToneOperator::aces, "aces", "the film-like curve of ACES (Stephen Hill's fit)"),
    word(ToneOperator::agx, "agx", "AgX: bright colours fade to white (Troy Sobotka; Benjamin Wrensch's polynomial)"),
};
constexpr std::array kProjection{
    word(Projection::perspective, "perspective", "far things look smaller"),
    word(Projection::orthographic, "orthographic", "parallel rays: size does not depend on distance"),
};
constexpr std::array kViewPreset{
    word(ViewPreset::three_quarter, "three-quarter", "from the front, a little from the right and above"),
    word(ViewPreset::iso, "iso", "along the diagonal of a cube"),
    word(ViewPreset::front, "front", "from +z"),
    word(ViewPreset::back, "back", "from -z"),
    word(ViewPreset::left, "left", "from -x"),
    word(ViewPreset::right, "right", "from +x"),
    word(ViewPreset::top, "top", "from +y"),
    word(ViewPreset::bottom, "bottom", "from -y"),
};
constexpr std::array kLightType{
    word(LightType::directional, "directional", "parallel light from far away, like the sun's"),
    word(LightType::point, "point", "light from one position in all directions"),
    word(LightType::spot, "spot", "light from one position into a cone"),
    word(LightType::rectangle, "rectangle", "an area of two edges that shines from its front"),
    word(LightType::disk, "disk", "a round area that shines from its front"),
    word(LightType::sphere, "sphere", "a ball that shines all around"),
};
constexpr std::array kSpotFade{
    word(SpotFade::smoothstep, "smoothstep", "t^2 (3 - 2 t)"),
    word(SpotFade::quadratic, "quadratic", "t^2, as glTF's lights ask"),
};
constexpr std::array kGltfShading{
    word(GltfShading::classic, "classic", "highlights by (N.H)^n, energy-normalised"),
    word(GltfShading::ggx, "ggx", "microfacets, as glTF asks"),
};
constexpr std::array kFogMode{
    word(FogMode::linear, "linear", "f = (end - d) / (end - start)"),
    word(FogMode::exp, "exp", "f = exp(-density d)"),
    word(FogMode::exp2, "exp2", "f = exp(-(density d)^2)"),
};
constexpr std::array kTerms{
    Word{0, "ambient", "k_a I_a and the lights' ambient parts"},
    Word{1, "diffuse", "k_d l_d max(N.L, 0)"},
    Word{2, "specular", "k_s l_s spec"},
    Word{3, "emission", "k_e"},
};

}  // namespace

// clang-format off
template <> std::span<const Word> words_of<Lighting>() { return kLighting; }
template <> std::span<const Word> words_of<Interpolation>() { return kInterpolation; }
template <> std::span<const Word> words_of<NormalInterpolation>() { return kNormalInterpolation; }
template <> std::span<const Word> words_of<VertexNormals>() { return kVertexNormals; }
template <> std::span<const Word> words_of<Culling>() { return kCulling; }
template <> std::span<const Word> words_of<Wrap>() { return kWrap; }
template <> std::span<const Word> words_of<TextureFilter>() { return kTextureFilter; }
template <> std::span<const Word> words_of<MipFilter>() { return kMipFilter; }
template <> std::span<const Word> words_of<TextureChannel>() { return kTextureChannel; }
template <> std::span<const Word> words_of<ReflectionShape>() { return kReflectionShape; }
template <> std::span<const Word> words_of<AlphaMode>() { return kAlphaMode; }
template <> std::span<const Word> words_of<Transfer>() { return kTransfer; }
template <> std::span<const Word> words_of<ToneOperator>() { return kToneOperator; }
template <> std::span<const Word> words_of<Projection>() { return kProjection; }
template <> std::span<const Word> words_of<ViewPreset>() { return kViewPreset; }
template <> std::span<const Word> words_of<LightType>() { return kLightType; }
template <> std::span<const Word> words_of<SpotFade>() { return kSpotFade; }
template <> std::span<const Word> words_of<GltfShading>() { return kGltfShading; }
template <> std::span<const Word> words_of<FogMode>() { return kFogMode; }
// clang-format on

std::span<const Word> term_words() {
  return kTerms;
}

const Word* find_word(std::span<const Word> table, std::string_view text) {
  for (const Word& entry : table) {
    if (entry.word == text) {
      return &entry;
    }
  }
  return nullptr;
}

std::string word_list(std::span<const Word> table) {
  std::string list;
  for (const Word& entry : table) {
    list += (list.empty() ? "" : ", ");
    list += entry.word;
  }
  return list;
}

std::string unknown_word_message(std::span<const Word> table, std::string_view text) {
  std::vector<std::string_view> known;
  for (const Word& entry : table) {
    known.push_back(entry.word);
  }
  return unknown_name_message("word", text, known);
}

}  // namespace lustro
