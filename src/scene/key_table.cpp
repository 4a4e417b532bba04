// See key_table.hpp.
#include "scene/key_table.hpp"

#include <fmt/format.h>

#include "scene/fields.hpp"

namespace lustro {
namespace {

/// What may stand there: kind, range and unit in a few words.
std::string value_column(const FieldInfo& field) {
  const std::string range = range_text(field.range);
  const auto with_range = [&](std::string_view kind) {
    std::string text = range.empty() ? std::string(kind) : fmt::format("{}, {}", kind, range);
    return field.unit.empty() ? text : fmt::format("{}, {}", text, field.unit);
  };
  switch (field.kind) {
    case ValueKind::boolean:
      return "`true` or `false`";
    case ValueKind::integer:
      return with_range("whole number");
    case ValueKind::number:
      return with_range("number");
    case ValueKind::vector:
      return field.unit.empty() ? "`[x, y, z]`" : fmt::format("`[x, y, z]`, {}", field.unit);
    case ValueKind::matrix:
      return "16 numbers";
    case ValueKind::color:
      return "colour";
    case ValueKind::color_alpha:
      return "colour, with alpha";
    case ValueKind::terms:
      return "list of words";
    case ValueKind::text:
      return "text";
    case ValueKind::table:
      return "table";
    case ValueKind::toggle:
      return "`true`, `false` or table";
    case ValueKind::lights:
    case ValueKind::objects:
      return "list of tables";
    case ValueKind::material:
      return "name or table";
    case ValueKind::materials:
      return "table of names or tables";
    case ValueKind::texture:
    case ValueKind::reflection:
      return "file or table";
    case ValueKind::pair:
      return field.unit.empty() ? "`[u, v]`" : with_range("`[x, y]`");
    case ValueKind::triple:
      return "number, or `[r, g, b]`";
    case ValueKind::affine:
      return "six numbers";
    case ValueKind::wrap:
    case ValueKind::word: {
      std::string text;
      for (const Word& word : field.words) {
        text += fmt::format("{}`{}`", text.empty() ? "" : ", ", word.word);
      }
      return text;
    }
  }
  return {};
}

/// A default as the scene file writes it.
std::string default_column(const FieldInfo& field) {
  switch (field.kind) {
    case ValueKind::color:
    case ValueKind::color_alpha:
    case ValueKind::pair:
    case ValueKind::vector: {
      const bool is_list = !field.default_text.empty() && field.default_text.find_first_not_of("0123456789.,-") == std::string::npos;
      return is_list ? fmt::format("`[{}]`", field.default_text) : field.default_text;
    }
    case ValueKind::matrix:
      return "identity";
    case ValueKind::terms:
      return "all";
    case ValueKind::wrap:
    case ValueKind::word:
      return field.optional ? field.default_text : fmt::format("`{}`", field.default_text);
    default:
      return field.default_text;
  }
}

std::string heading(std::string_view path) {
  return path.empty() ? "### The file" : fmt::format("### `{}`", path);
}

}  // namespace

std::string key_tables_markdown() {
  std::string page;
  for (const FieldGroup& group : field_groups()) {
    page += fmt::format("{}\n\n{}{}.\n\n", heading(group.path), static_cast<char>(group.help[0] - 'a' + 'A'), group.help.substr(1));
    page += "| key | value | default | meaning | flag |\n|---|---|---|---|---|\n";
    std::string words;
    for (const FieldInfo& field : group.fields) {
      const std::string flag = field.flag.empty() ? "" : fmt::format("`{}`", field.flag);
      page += fmt::format("| `{}` | {} | {} | {} | {} |\n", field.key, value_column(field), default_column(field), field.help, flag);
      for (const Word& word : field.words) {
        words += fmt::format("- `{}: {}`: {}\n", field.key, word.word, word.help);
      }
    }
    page += words.empty() ? "\n" : "\n" + words + "\n";
  }
  return page;
}

}  // namespace lustro
