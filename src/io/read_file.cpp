// Reads regular files by POSIX calls; sizes are checked before memory is taken.
#include "io/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <new>
#include <string>
#include <system_error>
#include <utility>

#include "parallel/slices.hpp"

namespace lustro {

namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::uint64_t memory_bytes() {
  const auto pages = ::sysconf(_SC_PHYS_PAGES);
  const auto page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) : UINT64_MAX;
}

struct Outcome {
  std::size_t size = 0;
  int error = 0;
};

/// Reads until `count` bytes are there, the file ends or the system refuses.
Outcome read_part(int descriptor, std::size_t begin, std::size_t count, char* room) {
  Outcome outcome;
  while (outcome.size < count) {
    const ::ssize_t got = ::pread(descriptor, room + outcome.size, count - outcome.size, static_cast<::off_t>(begin + outcome.size));
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      outcome.error = got < 0 ? errno : 0;
      break;
    }
    outcome.size += static_cast<std::size_t>(got);
  }
  return outcome;
}

}  // namespace

ByteSource::ByteSource(ByteSource&& other) noexcept
    : descriptor_(std::exchange(other.descriptor_, -1)), bytes_(other.bytes_), size_(other.size_), name_(std::move(other.name_)) {}

ByteSource::~ByteSource() {
  if (descriptor_ >= 0) {
    ::close(descriptor_);
  }
}

Result<ByteSource> ByteSource::open(const std::filesystem::path& file) {
  const std::string name = file.string();
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);  // non-blocking: a pipe must not hang the open
  if (descriptor < 0) {
    return fail(ErrorKind::io, name, fmt::format("cannot be opened: {}", reason(errno)));
  }
  ByteSource source(descriptor, 0, name);
  struct stat status {};
  if (::fstat(descriptor, &status) != 0) {
    return fail(ErrorKind::io, name, fmt::format("cannot be examined: {}", reason(errno)));
  }
  if (S_ISDIR(status.st_mode)) {
    return fail(ErrorKind::io, name, "is a folder, not a file");
  }
  if (!S_ISREG(status.st_mode)) {
    return fail(ErrorKind::io, name, "is not a regular file");
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (const std::uint64_t most = memory_bytes(); size > most) {
    return fail(ErrorKind::limit, name, fmt::format("the file has {} bytes, and this machine's memory {}", size, most));
  }
  source.size_ = static_cast<std::size_t>(size);
  return source;
}

std::string_view ByteSource::read(std::size_t begin, std::size_t count, char* room) const {
  if (begin > size_ || count > size_ - begin) {
    return {};
  }
  if (descriptor_ < 0) {
    return bytes_.substr(begin, count);
  }
  return read_part(descriptor_, begin, count, room).size == count ? std::string_view(room, count) : std::string_view();
}

Result<FileBytes> ByteSource::read_all(int threads) const {
  FileBytes bytes;
  try {
    bytes.data = make_big_array<char>(size_);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, name_, fmt::format("no memory for its {} bytes", size_));
  }
  if (descriptor_ < 0) {
    std::copy(bytes_.begin(), bytes_.end(), bytes.data.get());
    bytes.size = size_;
    return bytes;
  }
  constexpr std::size_t kLeast = std::size_t{1} << 20U;  // a system call on more does not get faster, and less is not worth a thread
  std::atomic<int> error = 0;
  std::atomic<std::size_t> end = size_;  // of what could be read without a gap
  parallel_slices(
      size_, threads,
      [&](std::size_t begin, std::size_t stop) {
        const Outcome outcome = read_part(descriptor_, begin, stop - begin, bytes.data.get() + begin);
        if (outcome.error != 0) {
          error = outcome.error;
        }
        if (outcome.size < stop - begin) {
          std::size_t known = end;
          while (begin + outcome.size < known && !end.compare_exchange_weak(known, begin + outcome.size)) {
          }
        }
      },
      kLeast);
  if (error != 0) {
    return fail(ErrorKind::io, name_, fmt::format("cannot be read: {}", reason(error)));
  }
  bytes.size = end;
  return bytes;
}

Result<FileBytes> read_file(const std::filesystem::path& file) {
  const Result<ByteSource> source = ByteSource::open(file);
  if (!source) {
    return tl::unexpected(source.error());
  }
  return source->read_all(0);
}

}  // namespace lustro
