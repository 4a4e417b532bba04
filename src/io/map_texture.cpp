// MTL's map statements and options, one by one.
#include "io/map_texture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "image/lower_case.hpp"
#include "image/srgb.hpp"
#include "math/trig.hpp"

namespace lustro {
namespace {

struct Statement {
  std::string_view name;  // lower case
  std::string_view slot;
};

constexpr std::array<Statement, 19> kStatements{{
    {"map_ka", "ambient"},    {"map_kd", "diffuse"},        {"map_ks", "specular"}, {"map_ke", "emission"},     {"map_ns", "shininess"},
    {"map_d", "opacity"},     {"map_opacity", "opacity"},   {"map_tr", "opacity"},  {"decal", "decal"},         {"map_decal", "decal"},
    {"bump", "bump"},         {"map_bump", "bump"},         {"norm", "normal"},     {"map_norm", "normal"},     {"map_kn", "normal"},
    {"disp", "displacement"}, {"map_disp", "displacement"}, {"refl", "reflection"}, {"map_refl", "reflection"},
}};

const TextureSlot* slot_of(std::string_view statement) {
  for (const Statement& known : kStatements) {
    if (known.name == statement) {
      return known.slot == kReflectionSlot.key ? &kReflectionSlot : texture_slot(known.slot);
    }
  }
  return nullptr;
}

/// The options that choose texels. Noted are those that cannot be honoured.
void choose_texels(const TextureMap& map, const MapSurroundings& around, Sampler& sampler, const std::function<void(std::string)>& note) {
  const auto ignored = [&](std::string_view option, std::string_view why) {
    note(fmt::format("{}: {} is ignored: {}", map.statement, option, why));
  };
  if (map.turbulence.x != 0 || map.turbulence.y != 0 || map.turbulence.z != 0) {
    ignored("-t", "the format does not say which noise it means");
  }
  if (map.color_correction && around.transfer == Transfer::none) {
    ignored("-cc", "the scene's transfer takes colours as they stand");
  }
  if (map.texture_resolution != 0) {
    ignored("-texres", "pictures are used at their own size, which is as sharp as they are");
  }
  if (map.boost < 0) {
    ignored("-boost", "below 0 it would blur");
  } else {
    sampler.lod_bias = -std::min(map.boost, 16.0F);
  }
  if (map.clamp) {
    sampler.wrap_u = sampler.wrap_v = Wrap::clamp_to_edge;
  }
  sampler.blend_u = map.blend_u;
  sampler.blend_v = map.blend_v;
  if (!map.blend_u && !map.blend_v) {
    sampler.magnify = sampler.minify = TextureFilter::nearest;
    sampler.mip = MipFilter::none;
  }
}

/// The place among ReflectionMap::faces that -type names.
std::size_t face_of_type(std::string_view type) {
  constexpr std::string_view kCube = "cube_";
  if (!type.starts_with(kCube)) {
    return 0;
  }
  const auto* const face = std::find(kCubeFaces.begin(), kCubeFaces.end(), type.substr(kCube.size()));
  return face == kCubeFaces.end() ? 0 : static_cast<std::size_t>(face - kCubeFaces.begin());
}

std::uint8_t channel_of(char letter) {
  switch (letter) {
    case 'r':
      return 0;
    case 'g':
      return 1;
    case 'b':
      return 2;
    case 'm':
      return 3;
    default:
      return 4;  // l
  }
}

std::array<float, 4> border_of(const StatedTexture& stated, Transfer transfer) {
  const Vec3f& rgb = stated.border.rgb;
  if (transfer == Transfer::srgb && stated.border.space == ColorSpace::encoded) {
    return {srgb_decode(rgb.x), srgb_decode(rgb.y), srgb_decode(rgb.z), stated.border_alpha};
  }
  return {rgb.x, rgb.y, rgb.z, stated.border_alpha};
}

/// From (u, v) as the scene file counts them to the picture's, whose rows go down.
std::array<float, 6> uv_matrix_of(const StatedTexture& stated) {
  std::array<double, 6> matrix{};
  if (stated.matrix) {
    std::ranges::transform(*stated.matrix, matrix.begin(), [](float m) { return static_cast<double>(m); });
  } else {
    const double c = cosine_deg(static_cast<double>(stated.rotation));
    const double s = sine_deg(static_cast<double>(stated.rotation));
    const auto u = static_cast<double>(stated.scale.x);
    const auto v = static_cast<double>(stated.scale.y);
    matrix = {c * u, -s * v, static_cast<double>(stated.offset.x), s * u, c * v, static_cast<double>(stated.offset.y)};
  }
  if (!stated.v_down) {
    matrix = {matrix[0], matrix[1], matrix[2], -matrix[3], -matrix[4], 1 - matrix[5]};
  }
  std::array<float, 6> result{};
  std::ranges::transform(matrix, result.begin(), [](double m) { return static_cast<float>(m); });
  return result;
}

/// Reflection maps have no coordinates of the surface: v goes down before the matrix, too.
void count_from_the_top(std::array<float, 6>& m) {
  m = {m[0], -m[1], m[1] + m[2], m[3], -m[4], m[4] + m[5]};
}

/// Numbers whose products are still finite as floats.
float bounded(float value) {
  return std::clamp(value, -1e9F, 1e9F);
}

}  // namespace

void tilt_normals(TextureUse& use, float factor) {
  // (t gain + base) 2 - 1 becomes factor times as much in x and y
  const float shift = (1 - factor) * 0.5F;
  use.gain = {use.gain.x * factor, use.gain.y * factor, use.gain.z};
  use.base = {use.base.x * factor + shift, use.base.y * factor + shift, use.base.z};
}

MapUse use_of_stated(const StatedTexture& stated, const TextureSlot& slot, Transfer transfer) {
  MapUse result;
  result.slot = &slot;
  TextureUse& use = result.use;
  use.name = stated.file;
  use.sampler.wrap_u = stated.wrap.u;
  use.sampler.wrap_v = stated.wrap.v;
  use.sampler.magnify = stated.magnify;
  use.sampler.minify = stated.minify;
  use.sampler.mip = stated.mip;
  use.sampler.anisotropy = stated.anisotropy;
  use.sampler.lod_bias = stated.lod_bias;
  use.sampler.border = border_of(stated, slot.content == TextureContent::color ? transfer : Transfer::none);
  use.uv_set = static_cast<std::uint8_t>(stated.uv_set);
  use.uv_matrix = uv_matrix_of(stated);
  if (&slot == &kReflectionSlot && !stated.v_down) {
    count_from_the_top(use.uv_matrix);
  }
  use.gain = stated.gain;
  use.base = stated.base;
  use.leaves_outside = stated.once;
  result.states_channel = stated.channel != TextureChannel::automatic;
  if (slot.is_scalar && result.states_channel) {
    use.channel = static_cast<std::uint8_t>(static_cast<int>(stated.channel) - static_cast<int>(TextureChannel::red));
  }
  return result;
}

std::optional<MapUse> use_of_map(const TextureMap& map, const MapSurroundings& around, const std::function<void(std::string)>& note) {
  const std::string statement = lower_case(map.statement);
  MapUse result;
  result.slot = slot_of(statement);
  if (result.slot == nullptr) {
    note(fmt::format("{} is kept, but not drawn: the classic model has no place for it", map.statement));
    return std::nullopt;
  }
  const bool is_reflection = result.slot == &kReflectionSlot;
  if (is_reflection && around.illumination && *around.illumination < 3) {
    note(fmt::format("{} is kept, but not drawn: it belongs to illum 3 and above, and the material states {}", map.statement,
                     *around.illumination));
    return std::nullopt;
  }
  TextureUse& use = result.use;
  choose_texels(map, around, use.sampler, note);
  use.name = map.file;
  use.uv_matrix = {bounded(map.scale.x), 0, bounded(map.offset.x), 0, -bounded(map.scale.y), 1 - bounded(map.offset.y)};
  const float gain = bounded(map.gain);
  const float base = bounded(map.base);
  const float bump_multiplier = bounded(map.bump_multiplier);
  use.gain = {gain, gain, gain};
  use.base = {base, base, base};
  use.leaves_outside = map.clamp;

  char channel = map.channel;
  if (channel == 'z') {
    note(fmt::format("{}: -imfchan z is ignored: pictures have no depth, the luminance is used", map.statement));
    channel = 'l';
  }
  if (result.slot->is_scalar) {
    result.states_channel = channel != 0;
    use.channel = channel_of(channel);
  } else if (result.slot->key == "decal") {
    result.alpha_of_decal = channel == 'm' ? '\0' : channel;
  } else if (channel != 0) {
    note(fmt::format("{}: -imfchan is ignored: it belongs to maps of one value", map.statement));
  }
  if (is_reflection) {
    result.shape = map.type.starts_with("cube") ? ReflectionShape::cube : ReflectionShape::sphere;
    result.face = face_of_type(map.type);
    count_from_the_top(use.uv_matrix);
  } else if (!map.type.empty()) {
    note(fmt::format("{}: -type is ignored: it belongs to refl", map.statement));
  }
  if (statement == "map_tr" && !around.transparency_is_tr) {
    use.gain = {-gain, -gain, -gain};
    use.base = {1 - base, 1 - base, 1 - base};
  }
  if (result.slot->key == "bump") {
    use.gain = use.gain * bump_multiplier;
    use.base = use.base * bump_multiplier;
    result.may_be_normals = channel == 0;
    result.bump_multiplier = bump_multiplier;
    result.gain = gain;
    result.base = base;
  } else if (result.slot->key == "normal") {
    tilt_normals(use, bump_multiplier);
  }
  return result;
}

}  // namespace lustro
