// THE table of options. Each key of the scene file stands here once: its name, its flag of the command, its kind, range, default, help and the
// member that holds it. Reading and writing JSON, the JSON Schema, the documentation's table of keys, the command's flags, its man page and
// completions are all made from it.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "lustro/scene.hpp"
#include "scene/words.hpp"

namespace lustro {

/// The largest magnitude of a number in a scene: every number must be finite as a float, too.
inline constexpr double kLargestNumber = static_cast<double>(std::numeric_limits<float>::max());

/// What a key's value looks like in JSON.
enum class ValueKind : std::uint8_t {
  boolean,
  integer,
  number,
  vector,       ///< [x, y, z]
  matrix,       ///< 16 numbers, row-major
  color,        ///< [r, g, b] linear, "#rrggbb" encoded
  color_alpha,  ///< a colour, with an optional fourth number
  word,         ///< one of an enum's words
  terms,        ///< a list of words
  text,
  table,       ///< an object with keys of its own: image, camera, shading, attenuation, fog
  lights,      ///< a list of lights
  objects,     ///< a list of objects
  material,    ///< the name of a material or a table of its coefficients
  materials,   ///< names and their materials
  texture,     ///< the name of a picture's file or a table
  reflection,  ///< the same
  wrap,        ///< a word, or a list of two: along u and along v
  pair,        ///< [u, v]
  triple,      ///< a number, or a list of three: of red, green and blue
  affine,      ///< six numbers, row by row
  toggle,      ///< true, false, or a table with keys of its own: shadow, occlusion, ground
};

/// The numbers that a key takes; each number of a vector, matrix or colour.
struct Range {
  double lower = -kLargestNumber;
  double upper = kLargestNumber;
  bool lower_open = false;  ///< the end itself is outside
  bool upper_open = false;
  std::span<const int> allowed{};  ///< if not empty: only these

  [[nodiscard]] bool contains(double value) const;
};

/// `0..90`, `more than 0`, `0 or more`, `more than 0 and less than 180`, `1, 2, 4, 8 or 16`; empty where every finite number is good.
[[nodiscard]] std::string range_text(const Range& range);

/// `120 is outside 0..90`
[[nodiscard]] std::string outside_message(const Range& range, double value);

/// Tables that `true` stands for where they state nothing, and `false` where there is none.
template <class V>
inline constexpr bool kIsToggle = std::is_same_v<V, ShadowSettings> || std::is_same_v<V, OcclusionSettings> || std::is_same_v<V, GroundSettings>;

/// A colour together with the alpha of its fourth number.
struct ColorAlphaRef {
  Color& color;
  float& alpha;
};

/// A value in some struct, whatever its type. monostate: the file has the key, no struct does (`materials`).
using ValueRef =
    std::variant<bool*, int*, float*, double*, std::optional<double>*, Vec3d*, std::optional<Vec3d>*, Mat4*, Color*, ColorAlphaRef, std::string*,
                 TermSet*, Transfer*, Projection*, ViewPreset*, Lighting*, std::optional<Lighting>*, Interpolation*, NormalInterpolation*,
                 VertexNormals*, Culling*, std::optional<Culling>*, LightType*, SpotFade*, FogMode*, ImageSettings*, Camera*, Shading*,
                 Attenuation*, std::optional<Fog>*, std::optional<Environment>*, Tone*, ToneOperator*, std::optional<ShadowSettings>*,
                 std::optional<OcclusionSettings>*, std::optional<GroundSettings>*, std::optional<int>*, std::optional<std::vector<Light>>*,
                 std::vector<Object>*, std::optional<Material>*, AlphaMode*, StatedTextures*, std::optional<StatedTexture>*,
                 std::optional<StatedReflection>*, ReflectionShape*, WrapPair*, TextureFilter*, MipFilter*, TextureChannel*, Vec2f*, Vec3f*,
                 std::optional<std::array<float, 6>>*, std::monostate>;

/// Where a struct keeps a value: one of these three stands in its table.
template <auto kMember, class T>
ValueRef at(T& object) {
  return &(object.*kMember);
}
template <auto kColor, auto kAlpha, class T>
ValueRef color_at(T& object) {
  return ColorAlphaRef{object.*kColor, object.*kAlpha};
}
template <class T>
ValueRef nowhere(T& /*object*/) {
  return std::monostate{};
}

/// One key of the struct T.
template <class T>
struct Field {
  std::string_view key;   ///< as in the scene file
  std::string_view flag;  ///< of the command, `--samples`; empty where there is none
  ValueRef (*value)(T& object);
  std::string_view help;       ///< one sentence without its full stop
  std::string_view unit = {};  ///< `degrees`, `pixels`, ...
  Range range = {};
  std::string_view absent = {};  ///< what holds where the key is not stated, if the struct's default does not say it
};

/// The keys of T in the order of the documentation: ImageSettings, Tone, Camera, Shading, Light, Attenuation, Fog, Environment, ShadowSettings,
/// OcclusionSettings, GroundSettings, Material, StatedTextures, StatedTexture, StatedReflection, Object, Scene.
template <class T>
[[nodiscard]] std::span<const Field<T>> fields();

/// What a table of a material holds whose `textures` are these and that states nothing else: a colour that stands beside its texture is white,
/// as in MTL files.
[[nodiscard]] Material material_with(StatedTextures textures);

/// Calls f with a reference to the value: `Transfer&`, `double&`, ..., ColorAlphaRef, or std::monostate.
template <class F>
decltype(auto) visit_value(const ValueRef& value, F&& f) {
  return std::visit(
      [&]<class R>(const R& ref) -> decltype(auto) {
        if constexpr (std::is_pointer_v<R>) {
          return f(*ref);
        } else {
          return f(ref);
        }
      },
      value);
}

[[nodiscard]] ValueKind kind_of(const ValueRef& value);

template <class T>
[[nodiscard]] ValueKind kind_of(const Field<T>& field) {
  T object;
  return kind_of(field.value(object));
}

/// Whether "not stated" is a value of its own (std::optional).
[[nodiscard]] bool is_optional(const ValueRef& value);

template <class T>
[[nodiscard]] bool is_optional(const Field<T>& field) {
  T object;
  return is_optional(field.value(object));
}

/// The words that the value may be; empty where it is no word and no list of words.
[[nodiscard]] std::span<const Word> words_of_value(const ValueRef& value);

template <class T>
[[nodiscard]] std::span<const Word> words_of_field(const Field<T>& field) {
  T object;
  return words_of_value(field.value(object));
}

/// The value as set_from_text() reads it; `none` where nothing is stated.
[[nodiscard]] std::string value_text(const ValueRef& value);

template <class T>
[[nodiscard]] std::string value_text(const T& object, const Field<T>& field) {
  T copy = object;
  return value_text(field.value(copy));
}

/// What holds where the key is not stated: Field::absent, or the struct's default as text.
template <class T>
[[nodiscard]] std::string default_text(const Field<T>& field) {
  return field.absent.empty() ? value_text(T{}, field) : std::string(field.absent);
}

/// Sets the value from a command line's text: `true`, `4`, `0.1`, `1,2,3`, `#ff8800`, `blinn-phong`, `ambient,diffuse`. A switch without text
/// is true.
///
/// errors  usage, with what was found and expected; `where` is the flag (or the key). The value is unchanged then
[[nodiscard]] Result<void> set_from_text(const ValueRef& value, const Range& range, std::string_view where, std::string_view text);

template <class T>
[[nodiscard]] Result<void> set_from_text(T& object, const Field<T>& field, std::string_view text) {
  return set_from_text(field.value(object), field.range, field.flag.empty() ? field.key : field.flag, text);
}

/// A field without its struct, for help, man page, completions and documentation.
struct FieldInfo {
  std::string_view key;
  std::string_view flag;
  std::string_view help;
  std::string_view unit;
  ValueKind kind = ValueKind::text;
  bool optional = false;
  Range range;
  std::string default_text;
  std::span<const Word> words;
};

/// The keys of one table of the scene file.
struct FieldGroup {
  std::string_view path;  ///< `image`, `lights[]`, ...; empty for the scene's own keys
  std::string_view help;  ///< one sentence without its full stop
  std::vector<FieldInfo> fields;
};

/// All keys of the scene file, group by group.
[[nodiscard]] std::vector<FieldGroup> field_groups();

/// Sets what a flag of the command names (`--samples`, `--light`, ...), wherever it belongs. `--light` appends a light (the first one replaces
/// nothing but the default rig) and `none` removes all; `--material` gives every object that material; `--fog none` removes the fog;
/// a flag of `shadow`, `occlusion` or `ground` switches that on. errors
/// usage, `where` is the flag. The scene is unchanged then
[[nodiscard]] Result<void> set_scene_flag(Scene& scene, std::string_view flag, std::string_view text);

}  // namespace lustro
