// A JSON text as a tree of values, read strictly: RFC 8259, no key twice, within stated limits.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro {

struct JsonLimits {
  std::size_t bytes = std::size_t{256} << 20U;
  std::size_t depth = 64;                      ///< lists and tables inside each other
  std::size_t values = std::size_t{1} << 24U;  ///< numbers, texts, lists, ... in all
};

/// The tree of a JSON text (UTF-8, with or without a byte order mark).
/// file    only for messages
/// errors  malformed, `file:line:column` where the text is no JSON, `file: path` for a key that is stated twice; limit
[[nodiscard]] Result<nlohmann::json> parse_json(std::string_view text, const std::string& file, const JsonLimits& limits = {});

/// A value for messages: `"abc"`, `4.5`, `a list of 2`.
[[nodiscard]] std::string found_text(const nlohmann::json& value);

}  // namespace lustro
