// Values as they are written on a command line: numbers, vectors, colours, whole lights, materials and fogs.
#pragma once

#include <string>
#include <string_view>

#include "lustro/scene.hpp"

namespace lustro {

/// `true`, `false` (also on, off, yes, no, 1, 0); nothing is true.
[[nodiscard]] Result<bool> parse_bool(std::string_view text);
[[nodiscard]] Result<int> parse_int(std::string_view text);
/// A finite decimal number, the whole text.
[[nodiscard]] Result<double> parse_number(std::string_view text);
/// `x,y,z`
[[nodiscard]] Result<Vec3d> parse_vector(std::string_view text);
/// `x,y`
[[nodiscard]] Result<Vec2f> parse_pair(std::string_view text);
/// 16 numbers, row-major.
[[nodiscard]] Result<Mat4> parse_matrix(std::string_view text);

/// A colour, and the alpha where it states one.
struct ParsedColor {
  Color color;
  std::optional<float> alpha;
};

/// `#rgb`, `#rrggbb` (encoded), `r,g,b` (linear), `color(srgb r g b)` (encoded, not in steps of 1/255; CSS Color 4). With `with_alpha` also
/// `#rgba`,
/// `#rrggbbaa`, `r,g,b,a` and `color(srgb r g b / a)`.
/// errors  usage, also for a negative number
[[nodiscard]] Result<ParsedColor> parse_color_alpha(std::string_view text, bool with_alpha);
[[nodiscard]] Result<Color> parse_color(std::string_view text);

/// The forms of parse_color_alpha() that begin with # or `color(`, as the scene file writes colours in text.
[[nodiscard]] bool is_color_text(std::string_view text);

/// `ambient,diffuse`; `none` is the empty set.
[[nodiscard]] Result<TermSet> parse_terms(std::string_view text);

/// A whole light, its type first, then where it stands or goes, then any keys of the scene file's light:
///
///     directional -1,-1,0 diffuse=#fff
///     point 2,3,4 color=#fff attenuation=1,0.1,0.02
///     spot 2,3,4 -1,-1,-1 cutoff=30 beam=20 exponent=8 falloff=2
///
/// `color` is diffuse and specular together. errors  usage
[[nodiscard]] Result<Light> parse_light(std::string_view text);

/// `jade`, `jade,shininess=20`, `diffuse=#f00,shininess=20` (commas or spaces between the keys). errors  usage
[[nodiscard]] Result<Material> parse_material(std::string_view text);

/// `exp`, `exp density=0.2 color=#abc`, `linear start=2 end=9`. errors  usage
[[nodiscard]] Result<Fog> parse_fog(std::string_view text);

/// The shortest decimal text that reads back to the same number: `0.1`, `1e+30`.
[[nodiscard]] std::string number_text(double value);
[[nodiscard]] std::string number_text(float value);

/// `#rrggbb` where the colour is encoded and made of bytes, `color(srgb r g b)` where it is encoded otherwise, `r,g,b` where it is linear; with
/// an alpha other than 1 also that.
[[nodiscard]] std::string color_text(const Color& color, float alpha = 1);

}  // namespace lustro
