// See gltf_reader.hpp. A path is looked for only when there is an error: the value's address tells where in the tree it stands.
#include "io/gltf_reader.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/json_document.hpp"
#include "scene/json_path.hpp"
#include "scene/text_values.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

/// Writes the path from `from` to `target`; false where it is not in there. The depth is bounded by parse_json().
bool find_path(const Json& from, const Json* target, const std::string& path, std::string& found) {  // NOLINT(misc-no-recursion)
  if (&from == target) {
    found = path;
    return true;
  }
  if (from.is_array()) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      if (from[i].is_structured() || &from[i] == target) {
        if (find_path(from[i], target, joined_path(path, i), found)) {
          return true;
        }
      }
    }
  } else if (from.is_object()) {
    for (auto item = from.begin(); item != from.end(); ++item) {
      if (item->is_structured() || &*item == target) {
        if (find_path(*item, target, joined_path(path, item.key()), found)) {
          return true;
        }
      }
    }
  }
  return false;
}

std::string path_of(const Json& root, const Json& target) {
  std::string path;
  find_path(root, &target, {}, path);
  return path;
}

const Json& empty_table() {
  static const Json empty = Json::object();
  return empty;
}

const Json& empty_list() {
  static const Json empty = Json::array();
  return empty;
}

}  // namespace

void GltfReader::fail(const Json& place, std::string message, ErrorKind kind) {
  if (!error_) {
    error_ = Error{kind, path_of(root_, place), std::move(message)};
  }
}

void GltfReader::fail(const Json& table, std::string_view key, std::string message, ErrorKind kind) {
  if (!error_) {
    error_ = Error{kind, joined_path(path_of(root_, table), key), std::move(message)};
  }
}

void GltfReader::missing(const Json& parent, std::string_view key, std::string_view expected) {
  fail(parent, key, fmt::format("is missing, expected {}", expected));
}

void GltfReader::expected(const Json& value, std::string_view expected) {
  fail(value, fmt::format("found {}, expected {}", found_text(value), expected));
}

const Json* GltfReader::find(const Json& table, std::string_view key) {
  if (!table.is_object()) {
    return nullptr;
  }
  const auto found = table.find(key);
  return found == table.end() ? nullptr : &*found;
}

const Json& GltfReader::table(const Json& parent, std::string_view key) {
  const Json* found = find(parent, key);
  if (found == nullptr) {
    return empty_table();
  }
  if (!found->is_object()) {
    expected(*found, "a table {...}");
    return empty_table();
  }
  return *found;
}

const Json& GltfReader::list(const Json& parent, std::string_view key) {
  const Json* found = find(parent, key);
  if (found == nullptr) {
    return empty_list();
  }
  if (!found->is_array()) {
    expected(*found, "a list");
    return empty_list();
  }
  return *found;
}

const Json& GltfReader::tables(const Json& parent, std::string_view key) {
  const Json& all = list(parent, key);
  for (const Json& one : all) {
    if (!one.is_object()) {
      expected(one, "a table {...}");
      return empty_list();
    }
    static_cast<void>(text(one, "name"));  // every table of a list may have one
  }
  return all;
}

const Json* GltfReader::extension(const Json& parent, std::string_view name) {
  const Json& all = table(parent, "extensions");
  const Json* found = find(all, name);
  if (found == nullptr) {
    return nullptr;
  }
  if (!found->is_object()) {
    expected(*found, "a table {...}");
    return nullptr;
  }
  bool is_declared = false;
  for (const Json& used : list(root_, "extensionsUsed")) {
    is_declared = is_declared || used == name;
  }
  if (!is_declared) {
    fail(*found, "is stated, but not listed in extensionsUsed");
  }
  return found;
}

std::uint64_t GltfReader::whole_of(const Json& value, const WholeRange& range) {
  if (!value.is_number()) {
    expected(value, "a whole number");
    return range.lower;
  }
  const auto number = value.get<double>();
  if (!(number >= static_cast<double>(range.lower) && number <= static_cast<double>(range.upper))) {
    fail(value, fmt::format("{} is outside {}..{}", number_text(number), range.lower, range.upper));
    return range.lower;
  }
  if (std::floor(number) != number) {
    expected(value, "a whole number");
    return range.lower;
  }
  return static_cast<std::uint64_t>(number);
}

double GltfReader::number_of(const Json& value, const NumberRange& range) {
  if (!value.is_number()) {
    expected(value, "a number");
    return 0;
  }
  const auto number = value.get<double>();
  if (!(number >= range.lower && number <= range.upper)) {
    fail(value, fmt::format("{} is outside {}..{}", number_text(number), number_text(range.lower), number_text(range.upper)));
    return 0;
  }
  return number;
}

std::uint64_t GltfReader::whole(const Json& parent, std::string_view key, const WholeRange& range, std::uint64_t absent) {
  const Json* found = find(parent, key);
  return found == nullptr ? absent : whole_of(*found, range);
}

std::uint64_t GltfReader::needed_whole(const Json& parent, std::string_view key, const WholeRange& range) {
  if (find(parent, key) == nullptr) {
    missing(parent, key, "a whole number");
  }
  return whole(parent, key, range, range.lower);
}

double GltfReader::number(const Json& parent, std::string_view key, const NumberRange& range, double absent) {
  const Json* found = find(parent, key);
  return found == nullptr ? absent : number_of(*found, range);
}

double GltfReader::needed_number(const Json& parent, std::string_view key, const NumberRange& range) {
  if (find(parent, key) == nullptr) {
    missing(parent, key, "a number");
  }
  return number(parent, key, range, 0);
}

bool GltfReader::boolean(const Json& parent, std::string_view key, bool absent) {
  const Json* found = find(parent, key);
  if (found == nullptr) {
    return absent;
  }
  if (!found->is_boolean()) {
    expected(*found, "true or false");
    return absent;
  }
  return found->get<bool>();
}

std::string GltfReader::text(const Json& parent, std::string_view key) {
  const Json* found = find(parent, key);
  if (found == nullptr) {
    return {};
  }
  if (!found->is_string()) {
    expected(*found, "text");
    return {};
  }
  return found->get<std::string>();
}

std::uint32_t GltfReader::index_of(const Json& value, std::size_t count, std::string_view what) {
  if (count == 0 && value.is_number()) {
    fail(value, fmt::format("{} is outside: there are no {}", found_text(value), what));
    return 0;
  }
  return static_cast<std::uint32_t>(whole_of(value, {0, count == 0 ? 0 : count - 1}));
}

std::uint32_t GltfReader::index(const Json& parent, std::string_view key, std::size_t count, std::string_view what) {
  const Json* found = find(parent, key);
  return found == nullptr ? kGltfNone : index_of(*found, count, what);
}

std::uint32_t GltfReader::needed_index(const Json& parent, std::string_view key, std::size_t count, std::string_view what) {
  if (find(parent, key) == nullptr) {
    missing(parent, key, fmt::format("an index of {}", what));
    return 0;
  }
  return index(parent, key, count, what);
}

void GltfReader::read_numbers(const Json& parent, std::string_view key, double* to, std::size_t count, const NumberRange& range) {
  const Json* found = find(parent, key);
  if (found == nullptr) {
    return;
  }
  if (!found->is_array() || found->size() != count) {
    expected(*found, fmt::format("a list of {} numbers", count));
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    to[i] = number_of((*found)[i], range);
  }
}

}  // namespace lustro
