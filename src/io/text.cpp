// The slower half of the text cursor, and foreign text made fit for messages.
#include "io/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace lustro {

namespace {

// The length of the UTF-8 character that begins at `at`, or 0 where there is none (RFC 3629: no overlong forms, no surrogates).
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const auto follows = [&](std::size_t i, unsigned low, unsigned high) { return byte(i) >= low && byte(i) <= high; };
  const unsigned first = byte(at);
  if (first < 0x80U) {
    return 1;
  }
  if (first >= 0xC2U && first <= 0xDFU) {
    return follows(at + 1, 0x80, 0xBF) ? 2 : 0;
  }
  if (first >= 0xE0U && first <= 0xEFU) {
    const unsigned low = first == 0xE0U ? 0xA0U : 0x80U;
    const unsigned high = first == 0xEDU ? 0x9FU : 0xBFU;
    return follows(at + 1, low, high) && follows(at + 2, 0x80, 0xBF) ? 3 : 0;
  }
  if (first >= 0xF0U && first <= 0xF4U) {
    const unsigned low = first == 0xF0U ? 0x90U : 0x80U;
    const unsigned high = first == 0xF4U ? 0x8FU : 0xBFU;
    return follows(at + 1, low, high) && follows(at + 2, 0x80, 0xBF) && follows(at + 3, 0x80, 0xBF) ? 4 : 0;
  }
  return 0;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, const TextRules& rules, std::size_t first_line)
    : here_(text.data()), end_(text.data() + text.size()), line_(first_line), rules_(rules) {
  if (text.starts_with("\xEF\xBB\xBF")) {
    here_ += 3;
  }
}

std::size_t TextCursor::joint_length(const char* p) const {
  if (!rules_.joined_lines || p + 1 == end_) {
    return 0;
  }
  if (p[1] == '\n') {
    return 2;
  }
  if (p[1] != '\r') {
    return 0;
  }
  return p + 2 != end_ && p[2] == '\n' ? 3 : 2;
}

bool TextCursor::skip_joint() {
  const std::size_t length = joint_length(here_);
  here_ += length;
  line_ += length != 0 ? 1 : 0;
  return length != 0;
}

void TextCursor::skip_newline() {
  if (*here_ == '\r' && here_ + 1 != end_ && here_[1] == '\n') {
    ++here_;
  }
  ++here_;
  ++line_;
}

void TextCursor::next_line() {
  while (!at_line_end()) {
    while (here_ != end_ && !ends_word(here_)) {
      ++here_;
    }
  }
  while (here_ != end_ && !is_newline(*here_)) {  // a comment: its backslashes join nothing
    ++here_;
  }
  if (here_ != end_) {
    skip_newline();
  }
}

void TextCursor::skip_space() {
  while (at_line_end() && here_ != end_) {
    next_line();
  }
}

// Visual C++ prints `1.#QNAN`, `-1.#IND00`, `1.#INF`: the only words in which a # does not begin a comment. Any other number ends here.
template <class F>
bool TextCursor::number_before_hash_of(const char* hash, F& value) {
  const std::string_view after(hash, std::min<std::size_t>(static_cast<std::size_t>(end_ - hash), 5));
  const bool is_infinite = after.starts_with("#INF");
  const bool is_nan = after == "#QNAN" || after == "#SNAN" || after.starts_with("#IND");
  if (hash[-1] != '.' || !(is_infinite || is_nan)) {
    here_ = rules_.hash_comments ? hash : here_;
    return rules_.hash_comments;
  }
  const F magnitude = is_infinite ? std::numeric_limits<F>::infinity() : std::numeric_limits<F>::quiet_NaN();
  value = value < 0 ? -magnitude : magnitude;
  here_ = hash;
  while (here_ != end_ && !ends_word(here_)) {
    ++here_;
  }
  return true;
}

bool TextCursor::number_before_hash(const char* hash, float& value) {
  return number_before_hash_of(hash, value);
}
bool TextCursor::number_before_hash(const char* hash, double& value) {
  return number_before_hash_of(hash, value);
}

bool TextCursor::integer(std::int64_t& value, char also_ends) {
  constexpr std::int64_t kSaturated = 100'000'000'000'000'000;
  skip_blanks();
  const char* p = here_;
  const bool is_negative = p != end_ && *p == '-';
  if (p != end_ && (*p == '-' || *p == '+')) {
    ++p;
  }
  const char* digits = p;
  std::int64_t magnitude = 0;
  for (; p != end_ && *p >= '0' && *p <= '9'; ++p) {
    magnitude = std::min(magnitude * 10 + (*p - '0'), kSaturated);
  }
  const bool ends = p == end_ || ends_word(p) || (also_ends != '\0' && *p == also_ends) || (rules_.hash_comments && *p == '#');
  if (p == digits || !ends) {
    return false;
  }
  here_ = p;
  value = is_negative ? -magnitude : magnitude;
  return true;
}

std::string TextCursor::rest_of_line() {
  std::string rest;
  while (!at_line_end()) {
    const char* begin = here_;
    while (here_ != end_ && !is_newline(*here_) && (*here_ != '\\' || joint_length(here_) == 0) &&
           !(rules_.hash_comments && *here_ == '#' && here_ != begin && is_blank(here_[-1]))) {
      ++here_;
    }
    rest += rest.empty() ? "" : " ";
    rest.append(begin, here_);
    while (!rest.empty() && is_blank(rest.back())) {
      rest.pop_back();
    }
  }
  return rest;
}

std::string at_line(const std::string& file, std::size_t line) {
  return fmt::format("{}:{}", file, line);
}

std::string at_byte(const std::string& file, std::size_t byte) {
  return fmt::format("{}: byte {}", file, byte);
}

std::string shown(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string out = "\"";
  std::size_t shown = 0;
  std::size_t at = 0;
  for (; at < text.size() && shown < kMost; ++shown) {
    const std::size_t length = utf8_length(text, at);
    const auto byte = static_cast<unsigned char>(text[at]);
    if (length == 0 || byte < 0x20U || byte == 0x7FU) {
      out += fmt::format("\\x{:02X}", byte);
      ++at;
    } else {
      out.append(text.substr(at, length));
      at += length;
    }
  }
  return out + (at < text.size() ? "...\"" : "\"");
}

std::string to_utf8(std::string name) {
  std::size_t at = 0;
  while (at < name.size()) {
    const std::size_t length = utf8_length(name, at);
    if (length == 0) {
      break;
    }
    at += length;
  }
  if (at == name.size()) {
    return name;
  }
  std::string out;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U) {
      out += c;
    } else {
      out += static_cast<char>(0xC0U | (byte >> 6U));
      out += static_cast<char>(0x80U | (byte & 0x3FU));
    }
  }
  return out;
}

}  // namespace lustro
