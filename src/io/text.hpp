// A cursor over text in memory that knows its line: words, numbers, names. One pass, nothing copied, nothing read beyond the end.
#pragma once

#include <fast_float/fast_float.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <system_error>

namespace lustro {

/// What the text formats do not share.
struct TextRules {
  bool hash_comments = true;  ///< `#` at the start of a word begins a comment that ends with the line
  bool joined_lines = false;  ///< a backslash before the end of a line joins the next one to it (OBJ, MTL)
};

/// Reads a text word by word. Lines end with LF, CRLF or a lone CR; a UTF-8 byte order mark at the start is skipped.
class TextCursor {
 public:
  TextCursor(std::string_view text, const TextRules& rules, std::size_t first_line = 1);

  [[nodiscard]] bool at_end() const { return here_ == end_; }
  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] std::size_t remaining() const { return static_cast<std::size_t>(end_ - here_); }

  [[nodiscard]] const char* here() const { return here_; }

  /// Goes to the start of any line of the text.
  void go_to(const char* start, std::size_t line) {
    here_ = start;
    line_ = line;
  }

  /// Moves over blanks, and over the ends of joined lines.
  void skip_blanks() {
    while (here_ != end_) {
      if (is_blank(*here_)) {
        ++here_;
      } else if (*here_ != '\\' || !skip_joint()) {
        return;
      }
    }
  }

  /// True where the line holds nothing more but perhaps a comment. Moves over blanks.
  [[nodiscard]] bool at_line_end() {
    skip_blanks();
    return here_ == end_ || is_newline(*here_) || (rules_.hash_comments && *here_ == '#');
  }

  /// Moves to the start of the next line; what the line still holds is skipped, with the lines that are joined to it.
  void next_line();

  /// Moves over blanks, ends of lines and comments, to the next word: for formats in which a line's end is a blank.
  void skip_space();

  /// The next word of the line, or an empty one where the line ends.
  [[nodiscard]] std::string_view word() {
    if (at_line_end()) {
      return {};
    }
    const char* begin = here_;
    while (here_ != end_ && !ends_word(here_)) {
      ++here_;
    }
    return {begin, static_cast<std::size_t>(here_ - begin)};
  }

  /// The next word, left where it is.
  [[nodiscard]] std::string_view peek_word() {
    const TextCursor before = *this;
    const std::string_view found = word();
    *this = before;
    return found;
  }

  /// The next word as a number, correctly rounded; `nan` and `inf` as C prints them on any system are numbers too. False, and the cursor
  /// stays, where the word is none.
  template <class F>
  [[nodiscard]] bool number(F& value) {
    skip_blanks();
    const char* begin = here_ != end_ && *here_ == '+' ? here_ + 1 : here_;  // from_chars takes no plus sign
    if (begin != here_ && begin != end_ && (*begin == '-' || *begin == '+')) {
      return false;
    }
    const auto [stop, code] = fast_float::from_chars(begin, end_, value);
    if (code == std::errc::invalid_argument) {
      return false;
    }
    if (stop == end_ || ends_word(stop) || *stop == '#') {
      if (stop != end_ && *stop == '#') {
        return number_before_hash(stop, value);
      }
      here_ = stop;
      return true;
    }
    return false;
  }

  /// The next word as a whole number. False, and the cursor stays, where the digits do not end the word, or `also_ends` does not come next.
  /// Beyond +-10^17 the number keeps that size: it is outside of every array.
  [[nodiscard]] bool integer(std::int64_t& value, char also_ends = '\0');

  /// Moves over `c` if it comes next, without blanks before it.
  [[nodiscard]] bool take(char c) {
    if (here_ == end_ || *here_ != c) {
      return false;
    }
    ++here_;
    return true;
  }

  [[nodiscard]] bool next_is(char c) const { return here_ != end_ && *here_ == c; }

  /// True where a blank, the end of the line or the end of the text comes next.
  [[nodiscard]] bool at_word_end() const { return here_ == end_ || ends_word(here_); }

  /// What the line still holds, without the blanks around it and without a comment (a `#` after a blank). Blanks inside are kept.
  [[nodiscard]] std::string rest_of_line();

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
  static bool is_newline(char c) { return c == '\n' || c == '\r'; }

 private:
  [[nodiscard]] bool ends_word(const char* p) const { return is_blank(*p) || is_newline(*p) || (*p == '\\' && joint_length(p) != 0); }
  [[nodiscard]] std::size_t joint_length(const char* p) const;  // of a backslash and the line's end; 0 where there is none
  bool skip_joint();
  void skip_newline();
  bool number_before_hash(const char* hash, float& value);
  bool number_before_hash(const char* hash, double& value);
  template <class F>
  bool number_before_hash_of(const char* hash, F& value);

  const char* here_;
  const char* end_;
  std::size_t line_;
  TextRules rules_;
};

/// `file:line`, as messages name a place.
[[nodiscard]] std::string at_line(const std::string& file, std::size_t line);

/// `file: byte N`.
[[nodiscard]] std::string at_byte(const std::string& file, std::size_t byte);

/// Foreign text for a message: in double quotes, at most 40 characters, what does not print as \xNN.
[[nodiscard]] std::string shown(std::string_view text);

/// A name as UTF-8: valid UTF-8 as it stands, else each byte read as Latin-1 (old exporters write the system's code page).
[[nodiscard]] std::string to_utf8(std::string name);

}  // namespace lustro
