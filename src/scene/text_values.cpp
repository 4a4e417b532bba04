// Numbers, vectors, colours and terms from and to text. Numbers are read by fast_float and printed by fmt: both round correctly and know no
// locale.
#include "scene/text_values.hpp"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "scene/nearest.hpp"
#include "scene/words.hpp"

namespace lustro {
namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_space(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && is_space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

tl::unexpected<Error> expected_but_found(std::string_view expected, std::string_view found) {
  return fail(ErrorKind::usage, "", fmt::format("found {}, expected {}", quote(found), expected));
}

/// The numbers between commas, at most `most`.
Result<std::vector<double>> parse_numbers(std::string_view text, std::size_t most, std::string_view expected) {
  std::vector<double> numbers;
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const auto number = parse_number(trimmed(rest.substr(0, comma)));
    if (!number || numbers.size() == most) {
      return expected_but_found(expected, text);
    }
    numbers.push_back(*number);
    if (comma == std::string_view::npos) {
      return numbers;
    }
    rest.remove_prefix(comma + 1);
  }
}

int hex_digit(char c) {
  return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// #rgb, #rgba, #rrggbb, #rrggbbaa as bytes; empty where it is none of them.
std::vector<int> hex_bytes(std::string_view digits) {
  const bool is_short = digits.size() == 3 || digits.size() == 4;
  if (!is_short && digits.size() != 6 && digits.size() != 8) {
    return {};
  }
  std::vector<int> bytes;
  for (std::size_t i = 0; i < digits.size(); i += is_short ? 1 : 2) {
    const int high = hex_digit(digits[i]);
    const int low = hex_digit(digits[is_short ? i : i + 1]);
    if (high < 0 || low < 0) {
      return {};
    }
    bytes.push_back(16 * high + low);
  }
  return bytes;
}

/// `srgb r g b` or `srgb r g b / a`: what stands between the brackets of color(...).
std::vector<double> css_numbers(std::string_view inside) {
  inside = trimmed(inside);
  if (!inside.starts_with("srgb ")) {
    return {};
  }
  inside.remove_prefix(5);
  std::vector<double> numbers;
  while (!(inside = trimmed(inside)).empty()) {
    if (inside.front() == '/' && numbers.size() == 3) {
      inside = trimmed(inside.substr(1));
    } else if (numbers.size() == 3) {
      return {};
    }
    std::size_t end = 0;
    while (end < inside.size() && !is_space(inside[end]) && inside[end] != '/') {
      ++end;
    }
    const auto number = parse_number(inside.substr(0, end));
    if (!number || numbers.size() == 4) {
      return {};
    }
    numbers.push_back(*number);
    inside.remove_prefix(end);
  }
  return numbers.size() < 3 ? std::vector<double>{} : numbers;
}

constexpr double kLargestFloat = static_cast<double>(std::numeric_limits<float>::max());

/// A decimal text with a sign and a dot where JSON would else lose that it is -0.
std::string with_signed_zero(const std::string& text) {
  return text == "-0" ? "-0.0" : text;
}

}  // namespace

Result<bool> parse_bool(std::string_view text) {
  for (const std::string_view yes : {"", "true", "on", "yes", "1"}) {
    if (text == yes) {
      return true;
    }
  }
  for (const std::string_view no : {"false", "off", "no", "0"}) {
    if (text == no) {
      return false;
    }
  }
  return expected_but_found("true or false", text);
}

Result<int> parse_int(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range && end == text.data() + text.size()) {
    return fail(ErrorKind::usage, "", fmt::format("{} is too large", quote(text)));
  }
  if (error != std::errc{} || end != text.data() + text.size()) {
    return expected_but_found("a whole number", text);
  }
  return value;
}

Result<double> parse_number(std::string_view text) {
  double value = 0;
  const auto [end, error] = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return expected_but_found("a finite number", text);
  }
  return value;
}

Result<Vec3d> parse_vector(std::string_view text) {
  constexpr std::string_view kExpected = "three numbers x,y,z";
  const auto numbers = parse_numbers(text, 3, kExpected);
  if (!numbers || numbers->size() != 3) {
    return expected_but_found(kExpected, text);
  }
  return Vec3d{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

Result<Vec2f> parse_pair(std::string_view text) {
  constexpr std::string_view kExpected = "two numbers x,y";
  const auto numbers = parse_numbers(text, 2, kExpected);
  if (!numbers || numbers->size() != 2) {
    return expected_but_found(kExpected, text);
  }
  return Vec2f{static_cast<float>((*numbers)[0]), static_cast<float>((*numbers)[1])};
}

Result<Mat4> parse_matrix(std::string_view text) {
  constexpr std::string_view kExpected = "16 numbers, row by row";
  const auto numbers = parse_numbers(text, 16, kExpected);
  if (!numbers || numbers->size() != 16) {
    return expected_but_found(kExpected, text);
  }
  Mat4 matrix;
  for (std::size_t i = 0; i < 16; ++i) {
    matrix.m[i] = (*numbers)[i];
  }
  return matrix;
}

bool is_color_text(std::string_view text) {
  return text.starts_with('#') || text.starts_with("color(");
}

Result<ParsedColor> parse_color_alpha(std::string_view text, bool with_alpha) {
  const std::string_view expected =
      with_alpha ? "a colour: #rgb, #rrggbb, #rrggbbaa, r,g,b or r,g,b,a" : "a colour: #rgb, #rrggbb or three numbers r,g,b";
  std::vector<double> numbers;
  ColorSpace space = ColorSpace::encoded;
  if (text.starts_with('#')) {
    for (const int byte : hex_bytes(text.substr(1))) {
      numbers.push_back(static_cast<double>(static_cast<float>(byte) / 255.0F));
    }
  } else if (text.starts_with("color(") && text.ends_with(')')) {
    numbers = css_numbers(text.substr(6, text.size() - 7));
  } else if (const auto stated = parse_numbers(text, 4, expected)) {
    numbers = *stated;
    space = ColorSpace::linear;
  }
  if (numbers.size() != 3 && !(with_alpha && numbers.size() == 4)) {
    return expected_but_found(expected, text);
  }
  for (const double number : numbers) {
    if (number < 0) {
      return fail(ErrorKind::usage, "", fmt::format("{} is less than 0", number_text(number)));
    }
    if (number > kLargestFloat) {
      return fail(ErrorKind::usage, "", fmt::format("{} is too large", number_text(number)));
    }
  }
  if (numbers.size() == 4 && numbers[3] > 1) {
    return fail(ErrorKind::usage, "", fmt::format("{} is outside 0..1", number_text(numbers[3])));
  }
  ParsedColor parsed;
  parsed.color = {{static_cast<float>(numbers[0]), static_cast<float>(numbers[1]), static_cast<float>(numbers[2])}, space};
  if (numbers.size() == 4) {
    parsed.alpha = static_cast<float>(numbers[3]);
  }
  return parsed;
}

Result<Color> parse_color(std::string_view text) {
  return parse_color_alpha(text, false).map([](const ParsedColor& parsed) { return parsed.color; });
}

Result<TermSet> parse_terms(std::string_view text) {
  TermSet terms{false, false, false, false};
  if (text == "none") {
    return terms;
  }
  std::string_view rest = text;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view name = trimmed(rest.substr(0, comma));
    const Word* word = find_word(term_words(), name);
    if (word == nullptr) {
      return fail(ErrorKind::usage, "", unknown_word_message(term_words(), name));
    }
    terms.*kTermMembers[word->value] = true;
    if (comma == std::string_view::npos) {
      return terms;
    }
    rest.remove_prefix(comma + 1);
  }
}

std::string number_text(double value) {
  return with_signed_zero(fmt::format("{}", value));
}

std::string number_text(float value) {
  std::string text = fmt::format("{}", value);
  // The text is read as a double and then rounded to float. Where the two roundings miss the float (rare), the double's own digits stand
  // instead.
  const auto back = parse_number(text);
  if (!back || static_cast<float>(*back) != value) {
    text = fmt::format("{}", static_cast<double>(value));
  }
  return with_signed_zero(text);
}

std::string color_text(const Color& color, float alpha) {
  const std::array<float, 4> values{color.rgb.x, color.rgb.y, color.rgb.z, alpha};
  const std::size_t count = alpha == 1.0F ? 3 : 4;
  if (color.space == ColorSpace::linear) {
    std::string text = fmt::format("{},{},{}", number_text(values[0]), number_text(values[1]), number_text(values[2]));
    return count == 3 ? text : text + "," + number_text(alpha);
  }
  std::string hex = "#";
  bool is_bytes = true;
  for (std::size_t i = 0; i < count; ++i) {
    const float scaled = std::floor(values[i] * 255.0F + 0.5F);
    is_bytes = is_bytes && scaled >= 0 && scaled <= 255 && scaled / 255.0F == values[i] && !std::signbit(values[i]);
    hex += is_bytes ? fmt::format("{:02x}", static_cast<int>(scaled)) : "";
  }
  if (is_bytes) {
    return hex;
  }
  const std::string text = fmt::format("color(srgb {} {} {}", number_text(values[0]), number_text(values[1]), number_text(values[2]));
  return count == 3 ? text + ")" : fmt::format("{} / {})", text, number_text(alpha));
}

}  // namespace lustro
