// What every field can do, by the type of its member: its kind, its words, its value as text and back. See fields.hpp.
#include "scene/fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/text_values.hpp"

namespace lustro {
namespace {

// --- kinds ------------------------------------------------------------------------------------------------------------------

template <class V>
inline constexpr bool kIsWord = std::is_enum_v<V>;

template <class V>
struct Optional {
  using Value = V;
  static constexpr bool kIs = false;
};
template <class V>
struct Optional<std::optional<V>> {
  using Value = V;
  static constexpr bool kIs = true;
};

template <class V>
constexpr ValueKind kind_of_type() {
  if constexpr (Optional<V>::kIs) {
    return kind_of_type<typename Optional<V>::Value>();
  } else if constexpr (std::is_same_v<V, bool>) {
    return ValueKind::boolean;
  } else if constexpr (std::is_same_v<V, int>) {
    return ValueKind::integer;
  } else if constexpr (std::is_floating_point_v<V>) {
    return ValueKind::number;
  } else if constexpr (std::is_same_v<V, Vec3d>) {
    return ValueKind::vector;
  } else if constexpr (std::is_same_v<V, Mat4>) {
    return ValueKind::matrix;
  } else if constexpr (std::is_same_v<V, Color>) {
    return ValueKind::color;
  } else if constexpr (std::is_same_v<V, ColorAlphaRef>) {
    return ValueKind::color_alpha;
  } else if constexpr (kIsWord<V>) {
    return ValueKind::word;
  } else if constexpr (std::is_same_v<V, TermSet>) {
    return ValueKind::terms;
  } else if constexpr (std::is_same_v<V, std::string>) {
    return ValueKind::text;
  } else if constexpr (std::is_same_v<V, std::vector<Light>>) {
    return ValueKind::lights;
  } else if constexpr (std::is_same_v<V, std::vector<Object>>) {
    return ValueKind::objects;
  } else if constexpr (std::is_same_v<V, Material>) {
    return ValueKind::material;
  } else if constexpr (std::is_same_v<V, StatedTexture>) {
    return ValueKind::texture;
  } else if constexpr (std::is_same_v<V, StatedReflection>) {
    return ValueKind::reflection;
  } else if constexpr (std::is_same_v<V, WrapPair>) {
    return ValueKind::wrap;
  } else if constexpr (std::is_same_v<V, Vec2f>) {
    return ValueKind::pair;
  } else if constexpr (std::is_same_v<V, Vec3f>) {
    return ValueKind::triple;
  } else if constexpr (std::is_same_v<V, std::array<float, 6>>) {
    return ValueKind::affine;
  } else if constexpr (kIsToggle<V>) {
    return ValueKind::toggle;
  } else if constexpr (std::is_same_v<V, std::monostate>) {
    return ValueKind::materials;
  } else {
    return ValueKind::table;
  }
}

// --- values from text ------------------------------------------------------------------------------------------------------------

/// The error of the first number outside the range.
Result<void> check(const Range& range, std::initializer_list<double> values) {
  for (const double value : values) {
    if (!range.contains(value)) {
      return fail(ErrorKind::usage, "", outside_message(range, value));
    }
  }
  return {};
}

Result<void> check(const Range& range, const Vec3d& v) {
  return check(range, {v.x, v.y, v.z});
}

/// Assigns what was read if it is in the range.
template <class To, class From>
Result<void> assign(To& to, const Result<From>& from, const Result<void>& in_range) {
  if (!from) {
    return tl::unexpected(from.error());
  }
  if (in_range) {
    to = static_cast<To>(*from);
  }
  return in_range;
}

struct FromText {
  std::string_view text;
  const Range& range;

  Result<void> operator()(bool& value) const { return assign(value, parse_bool(text), {}); }
  Result<void> operator()(int& value) const {
    const auto read = parse_int(text);
    return assign(value, read, read ? check(range, {static_cast<double>(*read)}) : Result<void>{});
  }
  Result<void> operator()(float& value) const { return number(value); }
  Result<void> operator()(double& value) const { return number(value); }
  Result<void> operator()(Vec3d& value) const {
    const auto read = parse_vector(text);
    return assign(value, read, read ? check(range, *read) : Result<void>{});
  }
  Result<void> operator()(Mat4& value) const {
    const auto read = parse_matrix(text);
    Result<void> in_range;
    for (std::size_t i = 0; read && in_range && i < 16; ++i) {
      in_range = check(range, {read->m[i]});
    }
    return assign(value, read, in_range);
  }
  Result<void> operator()(Color& value) const {
    const auto read = parse_color(text);
    return assign(value, read, read ? check(range, vec_cast<double>(read->rgb)) : Result<void>{});
  }
  Result<void> operator()(ColorAlphaRef value) const {
    const auto read = parse_color_alpha(text, true);
    if (!read) {
      return tl::unexpected(read.error());
    }
    value.color = read->color;
    value.alpha = read->alpha.value_or(1.0F);
    return {};
  }
  Result<void> operator()(std::string& value) const {
    value = std::string(text);
    return {};
  }
  Result<void> operator()(TermSet& value) const { return assign(value, parse_terms(text), {}); }
  template <class E>
  requires kIsWord<E> Result<void>
  operator()(E& value) const { return assign(value, parse_word<E>(text), {}); }
  Result<void> operator()(Attenuation& value) const {
    const auto read = parse_vector(text);
    const Result<void> in_range = read ? check(Range{.lower = 0}, *read) : Result<void>{};
    if (!read || !in_range) {
      return tl::unexpected(read ? in_range.error() : read.error());
    }
    value.constant = read->x;
    value.linear = read->y;
    value.quadratic = read->z;
    value.falloff.reset();
    return {};
  }
  Result<void> operator()(Fog& value) const { return assign(value, parse_fog(text), {}); }
  Result<void> operator()(Vec2f& value) const {
    const auto read = parse_pair(text);
    return assign(value, read, read ? check(range, {static_cast<double>(read->x), static_cast<double>(read->y)}) : Result<void>{});
  }
  /// A colour, else the name of a picture's file.
  Result<void> operator()(Environment& value) const {
    value = {};
    if (const auto color = parse_color(text)) {
      value.color = *color;
    } else {
      value.file = std::string(text);
    }
    return {};
  }
  Result<void> operator()(Material& value) const { return assign(value, parse_material(text), {}); }
  Result<void> operator()(std::optional<std::vector<Light>>& value) const {
    if (text == "none") {
      value.emplace();
      return {};
    }
    auto light = parse_light(text);
    if (!light) {
      return tl::unexpected(light.error());
    }
    if (!value) {
      value.emplace();
    }
    value->push_back(*std::move(light));
    return {};
  }
  /// What is stated stays when it is switched on.
  template <class V>
  requires kIsToggle<V> Result<void>
  operator()(std::optional<V>& value) const {
    const auto is_on = parse_bool(text);
    if (!is_on) {
      return tl::unexpected(is_on.error());
    }
    if (!*is_on) {
      value.reset();
    } else if (!value) {
      value.emplace();
    }
    return {};
  }
  /// "Not stated" is `none`, else as the value.
  template <class V>
  Result<void> operator()(std::optional<V>& value) const {
    if (text == "none") {
      value.reset();
      return {};
    }
    V read = value.value_or(V{});
    Result<void> done = (*this)(read);
    if (done) {
      value = std::move(read);
    }
    return done;
  }
  template <class V>
  Result<void> operator()(const V&) const {
    return fail(ErrorKind::usage, "", "cannot be stated in one text");
  }

 private:
  template <class F>
  Result<void> number(F& value) const {
    const auto read = parse_number(text);
    return assign(value, read, read ? check(range, {*read}) : Result<void>{});
  }
};

// --- values to text -------------------------------------------------------------------------------------------------------------

struct ToText {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return fmt::format("{}", value); }
  std::string operator()(float value) const { return number_text(value); }
  std::string operator()(double value) const { return number_text(value); }
  std::string operator()(const Vec3d& v) const { return fmt::format("{},{},{}", number_text(v.x), number_text(v.y), number_text(v.z)); }
  std::string operator()(const Mat4& matrix) const {
    std::string text;
    for (const double number : matrix.m) {
      text += (text.empty() ? "" : ",") + number_text(number);
    }
    return text;
  }
  std::string operator()(const Color& color) const { return color_text(color); }
  std::string operator()(const ColorAlphaRef& value) const { return color_text(value.color, value.alpha); }
  std::string operator()(const std::string& value) const { return value; }
  std::string operator()(const TermSet& terms) const {
    std::string text;
    for (const Word& word : term_words()) {
      if (terms.*kTermMembers[word.value]) {
        text += text.empty() ? "" : ",";
        text += word.word;
      }
    }
    return text.empty() ? "none" : text;
  }
  template <class E>
  requires kIsWord<E> std::string operator()(E value) const { return std::string(word_of(value)); }
  std::string operator()(const Attenuation& a) const { return (*this)(Vec3d{a.constant, a.linear, a.quadratic}); }
  std::string operator()(const Material& material) const { return material.name; }
  std::string operator()(const StatedTexture& texture) const { return texture.file; }
  std::string operator()(const StatedReflection& map) const { return (*this)(map.picture); }
  std::string operator()(const std::array<float, 6>& matrix) const {
    std::string text;
    for (const float number : matrix) {
      text += (text.empty() ? "" : ",") + number_text(number);
    }
    return text;
  }
  std::string operator()(const Vec3f& v) const {
    return v.x == v.y && v.y == v.z ? number_text(v.x) : fmt::format("{},{},{}", number_text(v.x), number_text(v.y), number_text(v.z));
  }
  std::string operator()(const Vec2f& v) const { return fmt::format("{},{}", number_text(v.x), number_text(v.y)); }
  std::string operator()(const WrapPair& wrap) const {
    return wrap.u == wrap.v ? std::string(word_of(wrap.u)) : fmt::format("{},{}", word_of(wrap.u), word_of(wrap.v));
  }
  std::string operator()(const std::vector<Light>& lights) const { return lights.empty() ? "none" : fmt::format("{} lights", lights.size()); }
  template <class V>
  std::string operator()(const std::optional<V>& value) const {
    if constexpr (kIsToggle<V>) {
      return value ? "true" : "false";
    } else {
      return value ? (*this)(*value) : "none";
    }
  }
  template <class V>
  requires(kind_of_type<V>() == ValueKind::table || kind_of_type<V>() == ValueKind::objects || kind_of_type<V>() == ValueKind::materials ||
           kIsToggle<V>) std::string
  operator()(const V&) const {
    return {};
  }
};

template <class T>
FieldInfo info_of(const Field<T>& field) {
  return {field.key,          field.flag,  field.help,          field.unit,           kind_of(field),
          is_optional(field), field.range, default_text(field), words_of_field(field)};
}

template <class T>
FieldGroup group_of(std::string_view path, std::string_view help) {
  FieldGroup group{path, help, {}};
  for (const Field<T>& field : fields<T>()) {
    group.fields.push_back(info_of(field));
  }
  return group;
}

/// Sets the field with that flag, if T has one.
template <class T>
std::optional<Result<void>> set_flag(T& object, std::string_view flag, std::string_view text) {
  for (const Field<T>& field : fields<T>()) {
    if (field.flag == flag) {
      return set_from_text(object, field, text);
    }
  }
  return std::nullopt;
}

}  // namespace

// --- ranges ------------------------------------------------------------------------------------------------------------------

bool Range::contains(double value) const {
  if (!std::isfinite(value)) {
    return false;
  }
  if (!allowed.empty()) {
    return std::any_of(allowed.begin(), allowed.end(), [&](int good) { return value == static_cast<double>(good); });
  }
  return (lower_open ? value > lower : value >= lower) && (upper_open ? value < upper : value <= upper);
}

std::string range_text(const Range& range) {
  if (!range.allowed.empty()) {
    std::string text;
    for (std::size_t i = 0; i < range.allowed.size(); ++i) {
      const std::string_view separator = i == 0 ? "" : i + 1 == range.allowed.size() ? " or " : ", ";
      text += fmt::format("{}{}", separator, range.allowed[i]);
    }
    return text;
  }
  const bool has_lower = range.lower > -kLargestNumber;
  const bool has_upper = range.upper < kLargestNumber;
  if (has_lower && has_upper && !range.lower_open && !range.upper_open) {
    return fmt::format("{}..{}", number_text(range.lower), number_text(range.upper));
  }
  const std::string lower = range.lower_open ? "more than " + number_text(range.lower) : number_text(range.lower) + " or more";
  const std::string upper = range.upper_open ? "less than " + number_text(range.upper) : number_text(range.upper) + " or less";
  return !has_lower && !has_upper ? "" : !has_upper ? lower : !has_lower ? upper : lower + " and " + upper;
}

std::string outside_message(const Range& range, double value) {
  const std::string number = number_text(value);
  if (std::isfinite(value) && std::abs(value) > kLargestNumber) {
    return fmt::format("{} is too large, the largest number is {}", number, number_text(std::numeric_limits<float>::max()));
  }
  const std::string text = range_text(range);
  return text.find("..") != std::string::npos ? fmt::format("{} is outside {}", number, text) : fmt::format("{} is not {}", number, text);
}

// --- fields ------------------------------------------------------------------------------------------------------------------

ValueKind kind_of(const ValueRef& value) {
  return visit_value(value, []<class V>(V&&) { return kind_of_type<std::remove_cvref_t<V>>(); });
}

bool is_optional(const ValueRef& value) {
  return visit_value(value, []<class V>(V&&) { return Optional<std::remove_cvref_t<V>>::kIs; });
}

std::span<const Word> words_of_value(const ValueRef& value) {
  return visit_value(value, []<class V>(V&&) -> std::span<const Word> {
    using Value = typename Optional<std::remove_cvref_t<V>>::Value;
    if constexpr (kIsWord<Value>) {
      return words_of<Value>();
    } else if constexpr (std::is_same_v<Value, WrapPair>) {
      return words_of<Wrap>();
    } else if constexpr (std::is_same_v<Value, TermSet>) {
      return term_words();
    } else {
      return {};
    }
  });
}

std::string value_text(const ValueRef& value) {
  return visit_value(value, [](const auto& stated) { return ToText{}(stated); });
}

Result<void> set_from_text(const ValueRef& value, const Range& range, std::string_view where, std::string_view text) {
  auto done = visit_value(value, FromText{text, range});
  if (!done) {
    done.error().where = where;
  }
  return done;
}

std::vector<FieldGroup> field_groups() {
  return {
      group_of<Scene>("", "the scene's own keys"),
      group_of<ImageSettings>("image", "the picture"),
      group_of<Tone>("image.tone", "tone mapping, on the way from linear light to bytes"),
      group_of<Camera>("camera", "right-handed, y up on the image; what is not stated frames the whole scene"),
      group_of<Shading>("shading", "how surfaces are lit"),
      group_of<Light>("lights[]", "one light"),
      group_of<Attenuation>("lights[].attenuation", "1 / (c + l d + q d^2), or 1 / d^falloff, at the distance d"),
      group_of<Fog>("fog", "on the Euclidean distance from the eye to the point, after lighting; the background is not fogged"),
      group_of<Environment>("environment", "the sky; a file's name or a colour stands for a table with that `file` or `color`"),
      group_of<ShadowSettings>("shadow", "the maps of depths through which lights see what they reach; `true` is a table that states nothing"),
      group_of<OcclusionSettings>("occlusion",
                                  "how far and how closely is looked for what hides the light from all around; `true` states nothing"),
      group_of<GroundSettings>("ground", "the floor that catches shadows; `true` states nothing"),
      group_of<Material>("materials.*", "the coefficients of a material"),
      group_of<StatedTextures>("materials.*.textures",
                               "what varies over the surface; colours multiply their coefficient, one value each the others"),
      group_of<StatedTexture>("materials.*.textures.*", "one texture; a file's name alone stands for a table with that `file`"),
      group_of<StatedReflection>("materials.*.textures.reflection",
                                 "what a mirroring surface shows; a file's name alone stands for a table with that `picture`"),
      group_of<Object>("objects[]", "one object"),
  };
}

Result<void> set_scene_flag(Scene& scene, std::string_view flag, std::string_view text) {
  const auto unknown = fail(ErrorKind::usage, std::string(flag), "unknown flag");
  if (flag.empty()) {
    return unknown;
  }
  for (auto& done : {set_flag(scene, flag, text), set_flag(scene.image, flag, text), set_flag(scene.image.tone, flag, text),
                     set_flag(scene.camera, flag, text), set_flag(scene.shading, flag, text)}) {
    if (done) {
      return *done;
    }
  }
  // A flag of one of these tables switches it on.
  const auto set_toggled = [&](auto& table) -> std::optional<Result<void>> {
    auto stated = table.value_or(typename std::remove_cvref_t<decltype(table)>::value_type{});
    const auto set = set_flag(stated, flag, text);
    if (set && *set) {
      table = stated;
    }
    return set;
  };
  if (const auto set = set_toggled(scene.shadow)) {
    return *set;
  }
  if (const auto set = set_toggled(scene.occlusion)) {
    return *set;
  }
  if (const auto set = set_toggled(scene.ground)) {
    return *set;
  }
  Object stated;
  const auto done = set_flag(stated, flag, text);
  if (!done) {
    return unknown;
  }
  if (*done) {
    for (Object& object : scene.objects) {
      object.material = stated.material;
    }
  }
  return *done;
}

}  // namespace lustro
