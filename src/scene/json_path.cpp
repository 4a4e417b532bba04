// See json_path.hpp.
#include "scene/json_path.hpp"

#include "scene/nearest.hpp"

namespace lustro {
namespace {

constexpr std::size_t kLongestPlainKey = 60;

bool is_plain(std::string_view key) {
  for (const char c : key) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '$';
    if (!is_letter) {
      return false;
    }
  }
  return !key.empty() && key.size() <= kLongestPlainKey;
}

}  // namespace

std::string joined_path(const std::string& path, std::string_view key) {
  if (!is_plain(key)) {
    return path + "[" + quote(key) + "]";
  }
  return path.empty() ? std::string(key) : path + "." + std::string(key);
}

std::string joined_path(const std::string& path, std::size_t index) {
  return path + "[" + std::to_string(index) + "]";
}

std::string JsonPath::text() const {
  if (parent == nullptr) {
    return {};
  }
  return is_index ? joined_path(parent->text(), index) : joined_path(parent->text(), key);
}

}  // namespace lustro
