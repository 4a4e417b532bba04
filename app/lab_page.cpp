// A table that is looked up, and a folder that is not left: see lab_page.hpp.
#include "lab_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "image/hash.hpp"
#include "image/inflate.hpp"
#include "io/read_file.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHowToBuild = "scripts/lab builds the page and a program that holds it, --page FOLDER shows one that is built already";

std::uint32_t little_endian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

/// Whether every part of the name is an ordinary one: no `..`, nothing hidden, nothing absolute.
bool is_plain_name(std::string_view name) {
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('/', begin), name.size());
    if (begin == end || name[begin] == '.') {
      return false;
    }
    begin = end + 1;
  }
  return name.find('\0') == std::string_view::npos;
}

std::optional<PageFile> find_in_table(std::span<const EmbeddedFile> files, std::string_view name, bool takes_gzip) {
  const auto found =
      std::lower_bound(files.begin(), files.end(), name, [](const EmbeddedFile& file, std::string_view n) { return file.name < n; });
  if (found == files.end() || found->name != name) {
    return std::nullopt;
  }
  // an array of bytes is an array of chars
  const std::string_view bytes(reinterpret_cast<const char*>(found->bytes), found->size);
  PageFile file{.bytes = bytes, .etag = std::string(found->etag), .is_gzip = found->is_gzip};
  if (found->is_gzip && !takes_gzip) {
    std::optional<std::string> plain = gunzip(bytes, found->plain);
    if (!plain) {
      return std::nullopt;
    }
    file = {.bytes = {}, .owned = *std::move(plain), .etag = file.etag};
  }
  return file;
}

std::optional<PageFile> find_in_folder(const fs::path& folder, std::string_view name) {
  if (!is_plain_name(name)) {
    return std::nullopt;
  }
  std::error_code error;
  const fs::path root = fs::canonical(folder, error);
  const fs::path file = error ? fs::path() : fs::canonical(root / name, error);
  if (error || std::mismatch(root.begin(), root.end(), file.begin(), file.end()).first != root.end()) {
    return std::nullopt;
  }
  const Result<FileBytes> bytes = read_file(file);
  if (!bytes) {
    return std::nullopt;
  }
  const std::uint64_t hash = xxh64(std::as_bytes(std::span(bytes->view())), 0);
  return PageFile{.bytes = {}, .owned = std::string(bytes->view()), .etag = fmt::format("\"{:016x}\"", hash)};
}

}  // namespace

std::optional<PageFile> LabPage::find(std::string_view name, bool takes_gzip) const {
  return folder_.empty() ? find_in_table(files_, name, takes_gzip) : find_in_folder(folder_, name);
}

Result<LabPage> lab_page(const std::string& folder, std::span<const EmbeddedFile> embedded) {
  if (folder.empty()) {
    if (embedded.empty()) {
      return fail(ErrorKind::unsupported, "lab", fmt::format("this build of Lustro holds no page: {}", kHowToBuild));
    }
    return LabPage(embedded);
  }
  LabPage page{fs::path(folder)};
  if (!page.find("index.html", false)) {
    return fail(ErrorKind::io, folder, fmt::format("holds no index.html that can be read: {}", kHowToBuild));
  }
  return page;
}

std::string_view content_type_of(std::string_view name) {
  using Type = std::pair<std::string_view, std::string_view>;
  constexpr std::array kTypes{Type{".html", "text/html; charset=utf-8"},
                              Type{".js", "text/javascript; charset=utf-8"},
                              Type{".mjs", "text/javascript; charset=utf-8"},
                              Type{".css", "text/css; charset=utf-8"},
                              Type{".json", "application/json"},
                              Type{".map", "application/json"},
                              Type{".webmanifest", "application/manifest+json"},
                              Type{".wasm", "application/wasm"},
                              Type{".svg", "image/svg+xml"},
                              Type{".png", "image/png"},
                              Type{".jpg", "image/jpeg"},
                              Type{".jpeg", "image/jpeg"},
                              Type{".webp", "image/webp"},
                              Type{".ico", "image/x-icon"},
                              Type{".woff2", "font/woff2"},
                              Type{".woff", "font/woff"},
                              Type{".ttf", "font/ttf"},
                              Type{".gltf", "model/gltf+json"},
                              Type{".glb", "model/gltf-binary"},
                              Type{".txt", "text/plain; charset=utf-8"},
                              Type{".obj", "text/plain; charset=utf-8"},
                              Type{".mtl", "text/plain; charset=utf-8"}};
  for (const auto& [ending, type] : kTypes) {
    if (name.ends_with(ending)) {
      return type;
    }
  }
  return "application/octet-stream";
}

bool is_hashed_name(std::string_view name) {
  constexpr std::string_view kFolder = "assets/";
  constexpr std::size_t kDigits = 8;  // of base64, as Rollup writes them
  const std::size_t slash = name.rfind('/');
  const std::size_t dot = name.find('.', slash == std::string_view::npos ? 0 : slash);
  if (!name.starts_with(kFolder) || dot == std::string_view::npos || dot < slash + 1 + 1 + kDigits) {
    return false;
  }
  const std::string_view hash = name.substr(dot - kDigits, kDigits);
  const bool is_hash = std::all_of(hash.begin(), hash.end(), [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '-' || c == '_';
  });
  return is_hash && name[dot - kDigits - 1] == '-';
}

std::optional<std::string> gunzip(std::string_view packed, std::size_t plain) {
  // Written by our build alone: ten bytes without optional fields, deflate, CRC-32, size.
  constexpr std::size_t kHead = 10, kTail = 8;
  constexpr std::string_view kMark("\x1f\x8b\x08\x00", 4);
  if (packed.size() < kHead + kTail || !packed.starts_with(kMark) || plain / kMostInflation > packed.size()) {
    return std::nullopt;
  }
  const std::string_view tail = packed.substr(packed.size() - kTail);
  std::string out(plain, '\0');
  const bool is_good = inflate_exactly(packed.substr(kHead, packed.size() - kHead - kTail), out) && little_endian(tail) == crc32_of(out) &&
                       little_endian(tail.substr(4)) == static_cast<std::uint32_t>(plain);
  return is_good ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace lustro::app
