// The values of a PLY body, one after the other, from text or from bytes of either order: what reads elements does not see the difference.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "io/note_book.hpp"
#include "io/ply_header.hpp"
#include "io/text.hpp"

namespace lustro {

/// Values of an ascii body. A value may stand on a later line than the one before it.
class PlyTextValues {
 public:
  PlyTextValues(std::string_view bytes, const PlyHeader& header, const std::string& file, NoteBook& notes)
      : text_(bytes.substr(header.body), {.hash_comments = false, .joined_lines = false}, header.body_line), file_(file), notes_(notes) {}

  /// The next value; false where there is none, or where it is no number.
  [[nodiscard]] bool read(PlyType type, double& value) {
    text_.skip_space();
    if (type == PlyType::float64) {
      return text_.number(value);
    }
    if (type == PlyType::float32) {  // straight to float: rounding twice is not rounding once
      float single = 0;
      const bool is_number = text_.number(single);
      value = static_cast<double>(single);
      return is_number;
    }
    std::int64_t whole = 0;
    if (text_.integer(whole)) {
      value = static_cast<double>(whole);
      return true;
    }
    return text_.number(value);  // some writers put a point into integers too
  }

  [[nodiscard]] bool skip(PlyType type, std::uint64_t count) {
    double value = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      if (!read(type, value)) {
        return false;
      }
    }
    return true;
  }

  void begin_element() {
    for (text_.skip_space(); !text_.at_end(); text_.skip_space()) {
      const std::string_view word = text_.peek_word();
      if (word != "comment" && word != "obj_info") {
        return;
      }
      notes_.add(text_.line(), "comments among the data are skipped");
      text_.next_line();
    }
  }

  void end_element() {
    if (!text_.at_line_end()) {
      notes_.add(text_.line(), "values behind those that the header states are skipped");
      text_.next_line();
    }
  }

  [[nodiscard]] std::size_t remaining() const { return text_.remaining(); }
  [[nodiscard]] std::size_t line() const { return text_.line(); }
  [[nodiscard]] std::string place() const { return at_line(file_, text_.line()); }
  [[nodiscard]] std::string place_of_value() const { return place(); }

  /// What stands where a value was expected.
  [[nodiscard]] std::string found() {
    text_.skip_space();
    return text_.at_end() ? "the end of the file" : shown(text_.word());
  }

 private:
  TextCursor text_;
  const std::string& file_;
  NoteBook& notes_;
};

/// Values of a binary body.
template <bool kIsSwapped>
class PlyByteValues {
 public:
  PlyByteValues(std::string_view bytes, const PlyHeader& header, const std::string& file, const NoteBook& /*notes*/)
      : bytes_(bytes), at_(header.body), file_(file) {}

  [[nodiscard]] bool read(PlyType type, double& value) {
    switch (type) {
      case PlyType::int8:
        return read_as<std::int8_t>(value);
      case PlyType::uint8:
        return read_as<std::uint8_t>(value);
      case PlyType::int16:
        return read_as<std::int16_t>(value);
      case PlyType::uint16:
        return read_as<std::uint16_t>(value);
      case PlyType::int32:
        return read_as<std::int32_t>(value);
      case PlyType::uint32:
        return read_as<std::uint32_t>(value);
      case PlyType::float32:
        return read_as<float>(value);
      case PlyType::float64:
        return read_as<double>(value);
    }
    return false;
  }

  [[nodiscard]] bool skip(PlyType type, std::uint64_t count) {
    value_at_ = at_;
    if (count > remaining() / size_of(type)) {
      return false;
    }
    at_ += static_cast<std::size_t>(count) * size_of(type);
    return true;
  }

  void begin_element() {}
  void end_element() {}

  [[nodiscard]] std::size_t remaining() const { return bytes_.size() - at_; }
  [[nodiscard]] std::size_t line() const { return 0; }
  [[nodiscard]] std::string place() const { return at_byte(file_, at_); }
  [[nodiscard]] std::string place_of_value() const { return at_byte(file_, value_at_); }
  [[nodiscard]] std::string found() { return "the end of the file"; }

 private:
  template <class T>
  bool read_as(double& value) {
    value_at_ = at_;
    if (remaining() < sizeof(T)) {
      return false;
    }
    char raw[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      raw[i] = bytes_[at_ + (kIsSwapped ? sizeof(T) - 1 - i : i)];
    }
    T number;
    std::memcpy(&number, raw, sizeof(T));
    value = static_cast<double>(number);
    at_ += sizeof(T);
    return true;
  }

  std::string_view bytes_;
  std::size_t at_;
  std::size_t value_at_ = 0;  // of the last value
  const std::string& file_;
};

}  // namespace lustro
