// A JSON tree built from nlohmann-json's events, because its own tree builder takes duplicate keys and any depth.
#include "scene/json_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "scene/json_path.hpp"
#include "scene/nearest.hpp"
#include "scene/text_values.hpp"

namespace lustro {
namespace {

using nlohmann::json;

/// What stands between two marks of a message, or up to its end.
std::string_view between(std::string_view text, std::string_view begin, std::string_view end) {
  const std::size_t from = text.find(begin);
  if (from == std::string_view::npos) {
    return {};
  }
  text.remove_prefix(from + begin.size());
  return text.substr(0, text.find(end));
}

/// The run of letters, digits and signs around a byte: where it begins, and itself.
std::pair<std::size_t, std::string_view> word_around(std::string_view text, std::size_t position) {
  constexpr std::string_view kEnds = " \t\r\n,:[]{}\"";
  std::size_t begin = std::min(position, text.size());
  while (begin > 0 && kEnds.find(text[begin - 1]) == std::string_view::npos) {
    --begin;
  }
  std::string_view word = text.substr(begin);
  return {begin, word.substr(0, word.find_first_of(kEnds))};
}

/// Where and why a text is no JSON.
struct Flaw {
  std::size_t position = 0;  // in bytes, from 0
  std::string reason;
};

/// The library's message without its number, its place and what it read last (which may be long, or no UTF-8).
Flaw flaw_of(std::string_view what, std::string_view text, std::size_t position) {
  const auto [word_begin, word] = word_around(text, position);
  if (what.find("number overflow") != std::string_view::npos) {
    return {word_begin, fmt::format("the number {} is too large", quote(word))};
  }
  std::string reason(between(what, " - ", "; "));
  if (reason.empty()) {
    return {position, "syntax error"};
  }
  std::string_view expected = what.substr(what.rfind("; expected ") == std::string_view::npos ? what.size() : what.rfind("; expected ") + 11);
  expected = expected.substr(0, expected.find("; last read"));
  if (expected == "'[', '{', or a literal") {
    expected = "a value";
  } else if (expected == "string literal") {
    expected = "a key in quotes";
  }
  const bool is_word = reason.starts_with("invalid literal") || reason.starts_with("invalid number");
  if (is_word) {
    reason = fmt::format("found {}", quote(word.empty() ? text.substr(std::min(word_begin, text.size()), 1) : word));
    expected = expected.empty() || expected.starts_with("end of input") ? expected : "a number";
    expected = expected.empty() ? "a value" : expected;
  }
  constexpr std::size_t kLongestExpected = 80;
  if (!expected.empty() && expected.size() <= kLongestExpected) {
    reason += fmt::format(", expected {}", expected);
  }
  return {is_word ? word_begin : position, reason};
}

/// Takes the events of the parser and builds the tree.
class TreeBuilder {
 public:
  TreeBuilder(std::string_view text, const std::string& file, const JsonLimits& limits) : text_(text), file_(file), limits_(limits) {}

  bool null() { return add(nullptr) != nullptr; }
  bool boolean(bool value) { return add(value) != nullptr; }
  bool number_integer(json::number_integer_t value) { return add(value) != nullptr; }
  bool number_unsigned(json::number_unsigned_t value) { return add(value) != nullptr; }
  bool number_float(json::number_float_t value, const std::string&) { return add(value) != nullptr; }
  bool string(std::string& value) { return add(std::move(value)) != nullptr; }
  static bool binary(json::binary_t&) { return false; }  // not in a text

  bool start_object(std::size_t) { return open(json::object()); }
  bool start_array(std::size_t) { return open(json::array()); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& name) {
    if (open_.back()->contains(name)) {
      return stop(ErrorKind::malformed, fmt::format("{}: {}", file_, joined_path(path(), name)), "is stated twice");
    }
    keys_.back() = name;
    return true;
  }

  bool parse_error(std::size_t read, const std::string&, const json::exception& error) {
    const Flaw flaw = flaw_of(error.what(), text_, read == 0 ? 0 : read - 1);
    const std::string_view before = text_.substr(0, flaw.position);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t newline = before.rfind('\n');
    const std::size_t column = before.size() - (newline == std::string_view::npos ? 0 : newline + 1) + 1;
    return stop(ErrorKind::malformed, fmt::format("{}:{}:{}", file_, line, column), fmt::format("broken JSON: {}", flaw.reason));
  }

  [[nodiscard]] Result<json> finish(bool is_good) {
    if (!is_good || failed_) {
      return tl::unexpected(error_);
    }
    return std::move(root_);
  }

 private:
  /// Puts a value where the document stands; nullptr where there are too many.
  json* add(json value) {
    if (++count_ > limits_.values) {
      stop(ErrorKind::limit, file_, fmt::format("has more than {} values", limits_.values));
      return nullptr;
    }
    if (open_.empty()) {
      root_ = std::move(value);
      return &root_;
    }
    json& parent = *open_.back();
    if (parent.is_array()) {
      parent.push_back(std::move(value));
      return &parent.back();
    }
    return &(parent[keys_.back()] = std::move(value));
  }

  bool open(json value) {
    if (open_.size() == limits_.depth) {
      return stop(ErrorKind::limit, file_, fmt::format("has lists and tables nested deeper than {}", limits_.depth));
    }
    json* added = add(std::move(value));
    if (added == nullptr) {
      return false;
    }
    open_.push_back(added);  // stays where it is: its parent does not grow until it is closed
    keys_.emplace_back();
    return true;
  }

  bool close() {
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  bool stop(ErrorKind kind, std::string where, std::string message) {
    error_ = {kind, std::move(where), std::move(message)};
    failed_ = true;
    return false;
  }

  /// Of the table or list that is open.
  [[nodiscard]] std::string path() const {
    std::string text;
    for (std::size_t i = 0; i + 1 < open_.size(); ++i) {
      text = open_[i]->is_array() ? joined_path(text, open_[i]->size() - 1) : joined_path(text, keys_[i]);
    }
    return text;
  }

  std::string_view text_;
  const std::string& file_;
  const JsonLimits& limits_;
  json root_;
  std::vector<json*> open_;        // the lists and tables that are not closed yet
  std::vector<std::string> keys_;  // the key that each open table is at
  std::size_t count_ = 0;
  bool failed_ = false;
  Error error_{ErrorKind::malformed, {}, "is no JSON"};
};

}  // namespace

Result<nlohmann::json> parse_json(std::string_view text, const std::string& file, const JsonLimits& limits) {
  if (text.size() > limits.bytes) {
    return fail(ErrorKind::limit, file, fmt::format("has {} bytes, the largest JSON text that is read has {}", text.size(), limits.bytes));
  }
  TreeBuilder builder(text, file, limits);
  try {
    return builder.finish(json::sax_parse(text.begin(), text.end(), &builder));
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, file, "does not fit into memory");
  } catch (const json::exception& error) {
    return fail(ErrorKind::malformed, file, error.what());
  }
}

std::string found_text(const json& value) {
  switch (value.type()) {
    case json::value_t::null:
      return "null";
    case json::value_t::boolean:
      return value.get<bool>() ? "true" : "false";
    case json::value_t::number_integer:
    case json::value_t::number_unsigned:
    case json::value_t::number_float:
      return number_text(value.get<double>());
    case json::value_t::string:
      return quote(value.get_ref<const std::string&>());
    case json::value_t::array:
      return value.empty() ? "an empty list" : fmt::format("a list of {}", value.size());
    case json::value_t::object:
      return value.empty() ? "an empty table" : fmt::format("a table of {}", value.size());
    default:
      return "something else";
  }
}

}  // namespace lustro
