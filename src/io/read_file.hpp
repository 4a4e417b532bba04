// A file's bytes. Read, not mapped: what another program does to the file meanwhile cannot pull the memory away under a parser.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro {

/// The bytes of a file, owned.
struct FileBytes {
  std::unique_ptr<char[]> data;
  std::size_t size = 0;

  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// A regular file as a whole.
/// errors  io with the system's reason: missing, unreadable, a folder, a device or pipe; limit where it is larger than this machine's memory
[[nodiscard]] Result<FileBytes> read_file(const std::filesystem::path& file);

}  // namespace lustro
