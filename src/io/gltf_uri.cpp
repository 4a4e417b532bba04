// See gltf_uri.hpp.
#include "io/gltf_uri.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "io/percent.hpp"
#include "parallel/big_memory.hpp"
#include "scene/nearest.hpp"

namespace lustro {
namespace {

/// The value of a digit, or -1.
int base64_digit(char c) {
  if (c >= 'A' && c <= 'Z') {
    return c - 'A';
  }
  if (c >= 'a' && c <= 'z') {
    return c - 'a' + 26;
  }
  if (c >= '0' && c <= '9') {
    return c - '0' + 52;
  }
  return c == '+' || c == '-' ? 62 : c == '/' || c == '_' ? 63 : -1;
}

Result<std::string> decoded(std::string_view uri) {
  if (auto plain = without_percent(uri)) {
    return *std::move(plain);
  }
  return fail(ErrorKind::malformed, {}, fmt::format("{} has a % without two digits behind it", quote(uri)));
}

FileBytes owned(std::size_t size) {
  FileBytes bytes;
  bytes.data = make_big_array<char>(size);
  bytes.size = size;
  return bytes;
}

Result<FileBytes> decode_base64(std::string_view text) {
  while (!text.empty() && text.back() == '=') {
    text.remove_suffix(1);
  }
  if (text.size() % 4 == 1) {
    return fail(ErrorKind::malformed, {}, "its base64 is cut short");
  }
  FileBytes bytes = owned(text.size() / 4 * 3 + (text.size() % 4 == 0 ? 0 : text.size() % 4 - 1));
  std::uint32_t bits = 0;
  std::size_t written = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = base64_digit(text[i]);
    if (digit < 0) {
      return fail(ErrorKind::malformed, {}, fmt::format("its base64 has {} at letter {}", quote(text.substr(i, 1)), i));
    }
    bits = bits << 6U | static_cast<std::uint32_t>(digit);
    if (i % 4 != 0) {
      const auto shift = static_cast<std::uint32_t>(6 - 2 * (i % 4));
      bytes.data[written++] = static_cast<char>(bits >> shift & 0xFFU);
    }
  }
  return bytes;
}

}  // namespace

bool is_data_uri(std::string_view uri) {
  return uri.starts_with("data:");
}

Result<FileBytes> decode_data_uri(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (comma == std::string_view::npos) {
    return fail(ErrorKind::malformed, {}, fmt::format("{} has no comma before its data", quote(uri)));
  }
  const std::string_view data = uri.substr(comma + 1);
  if (uri.substr(0, comma).ends_with(";base64")) {
    return decode_base64(data);
  }
  const Result<std::string> plain = decoded(data);
  if (!plain) {
    return tl::unexpected(plain.error());
  }
  FileBytes bytes = owned(plain->size());
  std::copy(plain->begin(), plain->end(), bytes.data.get());
  return bytes;
}

Result<std::string> confined_path(std::string_view uri) {
  const std::size_t colon = uri.find(':');
  if (colon != std::string_view::npos && uri.find('/') > colon) {
    return fail(ErrorKind::malformed, {}, fmt::format("{} is no file beside the document: only relative paths are read", quote(uri)));
  }
  const Result<std::string> plain = decoded(uri.substr(0, uri.find_first_of("?#")));
  if (!plain) {
    return tl::unexpected(plain.error());
  }
  std::string slashed = *plain;
  std::replace(slashed.begin(), slashed.end(), '\\', '/');
  if (slashed.empty() || slashed.find('\0') != std::string::npos) {
    return fail(ErrorKind::malformed, {}, fmt::format("{} names no file", quote(uri)));
  }
  const bool has_drive = slashed.size() > 1 && slashed[1] == ':';
  if (slashed.front() == '/' || has_drive) {
    return fail(ErrorKind::malformed, {}, fmt::format("{} is an absolute path: only files in the document's folder are read", quote(uri)));
  }
  const std::filesystem::path path = std::filesystem::path(slashed).lexically_normal();
  if (path.begin() != path.end() && *path.begin() == "..") {
    return fail(ErrorKind::malformed, {}, fmt::format("{} lies outside the document's folder", quote(uri)));
  }
  return path.string();
}

}  // namespace lustro
