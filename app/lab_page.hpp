// The files of the lab's page: those inside the program, or those of a folder.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro::app {

/// A file of a page that is inside the program: cmake/embed_page.cmake makes the table.
struct EmbeddedFile {
  std::string_view name;  ///< `assets/index-Bx3kq9Zc.js`
  std::string_view etag;  ///< of its content, in quotes, as HTTP has it
  const unsigned char* bytes = nullptr;
  std::size_t size = 0;   ///< of `bytes`
  bool is_gzip = false;   ///< `bytes` are packed
  std::size_t plain = 0;  ///< bytes when unpacked
};

/// The page with which the program was built, sorted by name; empty where there was none.
[[nodiscard]] std::span<const EmbeddedFile> embedded_page();

/// A file as it is sent.
struct PageFile {
  std::string_view bytes;  ///< of an embedded file
  std::string owned{};     ///< of any other; `bytes` is empty then
  std::string etag{};
  bool is_gzip = false;

  [[nodiscard]] std::string_view content() const { return bytes.empty() ? std::string_view(owned) : bytes; }
};

/// Where the page comes from.
class LabPage {
 public:
  /// The embedded files, which must outlive the page.
  explicit LabPage(std::span<const EmbeddedFile> files) : files_(files) {}
  /// A folder that holds an index.html; read at each request, so that what is built anew is shown.
  explicit LabPage(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The file of that name, `index.html`, `assets/a.js`. Of a folder only what lies in it: no `..`, no name that begins with a dot, no link that
  /// leads out.
  /// takes_gzip  packed bytes are welcome
  /// returns     nothing where there is no such file
  [[nodiscard]] std::optional<PageFile> find(std::string_view name, bool takes_gzip) const;

 private:
  std::span<const EmbeddedFile> files_;
  std::filesystem::path folder_;
};

/// The page from a folder if one is stated, else the embedded one.
/// errors  io where the folder has no index.html; unsupported where the program was built without a page
[[nodiscard]] Result<LabPage> lab_page(const std::string& folder, std::span<const EmbeddedFile> embedded);

/// `text/javascript; charset=utf-8` for `a.js`; `application/octet-stream` for what no page has.
[[nodiscard]] std::string_view content_type_of(std::string_view name);

/// Whether the name holds a hash of the content, as Vite's do (`assets/index-Bx3kq9Zc.js`): what it stands for never changes.
[[nodiscard]] bool is_hashed_name(std::string_view name);

/// The unpacked bytes of a gzip file of one member (RFC 1952).
/// plain    their number
/// returns  nothing where that is not what the bytes are
[[nodiscard]] std::optional<std::string> gunzip(std::string_view packed, std::size_t plain);

}  // namespace lustro::app
