// A file's bytes: all of them, or any part by several threads at once.
//
// Read, not mapped: what another program does to the file meanwhile cannot pull the memory away under a parser (SIGBUS), and reading is as fast:
// a copy from the system's cache into memory that is reused, where a mapping pays for each page that it makes visible.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "lustro/result.hpp"
#include "parallel/big_memory.hpp"

namespace lustro {

/// The bytes of a file, owned.
struct FileBytes {
  BigArray<char> data;
  std::size_t size = 0;

  [[nodiscard]] std::string_view view() const { return {data.get(), size}; }
};

/// Bytes that can be read from any place: a file, or memory that stands for one.
class ByteSource {
 public:
  explicit ByteSource(std::string_view bytes) : bytes_(bytes), size_(bytes.size()) {}
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;
  ByteSource(ByteSource&& other) noexcept;
  ByteSource& operator=(ByteSource&&) = delete;
  ~ByteSource();

  /// A regular file, open for reading.
  /// errors  io with the system's reason: missing, unreadable, a folder, a device or pipe; limit where it is larger than this machine's memory
  [[nodiscard]] static Result<ByteSource> open(const std::filesystem::path& file);

  /// As it was when the file was opened.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// The `count` bytes from `begin` on: in place where they are in memory, else read into `room`, which holds as many. Empty where they cannot
  /// be read, or are not there any more. Any number of threads may read at the same time.
  [[nodiscard]] std::string_view read(std::size_t begin, std::size_t count, char* room) const;

  /// All bytes. Those of a file that was shortened meanwhile are those that it still has: the parser judges them.
  /// errors  io with the system's reason; limit where there is no memory
  [[nodiscard]] Result<FileBytes> read_all(int threads) const;

 private:
  ByteSource(int descriptor, std::size_t size, std::string name) : descriptor_(descriptor), size_(size), name_(std::move(name)) {}

  int descriptor_ = -1;
  std::string_view bytes_;
  std::size_t size_ = 0;
  std::string name_;
};

/// A regular file as a whole.
/// errors  as ByteSource::open() and read_all()
[[nodiscard]] Result<FileBytes> read_file(const std::filesystem::path& file);

/// Who is told which files are opened: LoadOptions::on_file.
using FileWatcher = std::function<void(const std::filesystem::path&)>;

/// Tells who wants to know it that a file is about to be opened.
inline void tell(const FileWatcher& watcher, const std::filesystem::path& file) {
  if (watcher) {
    watcher(file);
  }
}

}  // namespace lustro
