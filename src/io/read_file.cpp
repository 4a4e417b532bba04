// Reads a regular file by POSIX calls; its size is checked before memory is taken.
#include "io/read_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <new>
#include <string>
#include <system_error>

namespace lustro {

namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

// Closes what it holds.
struct Descriptor {
  int number;
  explicit Descriptor(int number_) : number(number_) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor(Descriptor&&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (number >= 0) {
      ::close(number);
    }
  }
};

std::uint64_t memory_bytes() {
  const auto pages = ::sysconf(_SC_PHYS_PAGES);
  const auto page = ::sysconf(_SC_PAGESIZE);
  return pages > 0 && page > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page) : UINT64_MAX;
}

}  // namespace

Result<FileBytes> read_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  const Descriptor descriptor(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // non-blocking: a pipe must not hang the open
  if (descriptor.number < 0) {
    return fail(ErrorKind::io, name, fmt::format("cannot be opened: {}", reason(errno)));
  }
  struct stat status {};
  if (::fstat(descriptor.number, &status) != 0) {
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

  FileBytes bytes;
  bytes.data.reset(new (std::nothrow) char[size + 1]);  // not zeroed; one byte more, so that an empty file has an address too
  if (!bytes.data) {
    return fail(ErrorKind::limit, name, fmt::format("no memory for its {} bytes", size));
  }
  while (bytes.size < size) {
    const ::ssize_t got = ::read(descriptor.number, bytes.data.get() + bytes.size, size - bytes.size);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      return fail(ErrorKind::io, name, fmt::format("cannot be read: {}", reason(errno)));
    }
    if (got == 0) {
      break;  // it was shortened meanwhile: the parser judges what there is
    }
    bytes.size += static_cast<std::size_t>(got);
  }
  return bytes;
}

}  // namespace lustro
