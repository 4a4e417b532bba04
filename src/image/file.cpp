// Whole files in and out on POSIX calls: they give the system's reason for a failure, and a name that surely did not exist before (O_EXCL).
#include "image/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>
#include <utility>

#include "lustro/image.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxFileBytes = std::size_t{8} << 30;

std::string reason(int error) {
  return std::generic_category().message(error);
}

/// An open file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }
  [[nodiscard]] int get() const { return fd_; }
  /// Some file systems report a full disk only here. Returns an errno, 0 when all went well.
  [[nodiscard]] int close_now() { return ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
};

/// 0, or the errno of what stopped it.
int write_all(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(fd, bytes.data(), std::min(bytes.size(), std::size_t{1} << 30));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      return errno;
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
  return 0;
}

/// The file that a chain of symbolic links ends at, whether it exists or not.
Result<fs::path> follow_links(const fs::path& file) {
  fs::path target = file;
  std::error_code error;
  for (int hops = 0; fs::is_symlink(target, error); ++hops) {
    if (hops == 40) {
      return fail(ErrorKind::io, file.string(), fmt::format("cannot be written: {}", reason(ELOOP)));
    }
    const fs::path next = fs::read_symlink(target, error);
    if (error) {
      return fail(ErrorKind::io, file.string(), fmt::format("cannot be written: {}", error.message()));
    }
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

/// How the names of a process's temporary files begin.
std::string temporary_prefix(int process) {
  return fmt::format(".lustro-{}-", process);
}

/// A device or a pipe has no content to protect, and a rename would replace the device itself.
Result<void> write_in_place(const fs::path& file, std::span<const std::byte> bytes) {
  Descriptor out(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  int error = out.get() < 0 ? errno : write_all(out.get(), bytes);
  if (error == 0) {
    error = out.close_now();
  }
  if (error != 0) {
    return fail(ErrorKind::io, file.string(), fmt::format("cannot be written: {}", reason(error)));
  }
  return {};
}

}  // namespace

Result<std::vector<std::byte>> read_file_bytes(const fs::path& file, const std::function<Result<void>(std::span<const std::byte>)>& accept) {
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) {
    return fail(ErrorKind::io, file.string(), fmt::format("cannot be opened: {}", reason(errno)));
  }
  if (S_ISDIR(status.st_mode)) {
    return fail(ErrorKind::io, file.string(), "is a folder, and a file was expected");
  }
  const auto too_large = [&] { return fail(ErrorKind::limit, file.string(), "holds more than 8 GiB, the most that is read"); };
  const std::size_t stated = S_ISREG(status.st_mode) ? static_cast<std::size_t>(status.st_size) : 0;
  if (stated > kMaxFileBytes) {
    return too_large();
  }
  std::vector<std::byte> bytes(kHeadBytes);
  std::size_t size = 0;
  bool accepted = false;
  try {
    for (;;) {
      const ssize_t got = ::read(in.get(), bytes.data() + size, bytes.size() - size);
      if (got < 0 && errno == EINTR) {
        continue;
      }
      if (got < 0) {
        return fail(ErrorKind::io, file.string(), fmt::format("cannot be read: {}", reason(errno)));
      }
      size += static_cast<std::size_t>(got);
      if (!accepted && (got == 0 || size == kHeadBytes)) {
        if (auto ok = accept(std::span(bytes).first(size)); !ok) {
          return tl::unexpected(std::move(ok).error());
        }
        accepted = true;
      }
      if (got == 0) {
        break;
      }
      if (size == bytes.size()) {
        if (size >= kMaxFileBytes) {
          return too_large();
        }
        // one byte more than the file states, so that its end is seen without growing again
        bytes.resize(std::min(kMaxFileBytes, std::max({stated + 1, 2 * size, std::size_t{65536}})));
      }
    }
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, file.string(), "does not fit into memory");
  }
  bytes.resize(size);
  return bytes;
}

// The name of an existing symbolic link stays a link: the file that it points to is replaced, as a plain overwrite would do.
Result<void> write_file_atomically(const fs::path& file, std::span<const std::byte> bytes) {
  const auto cannot = [&](int error) { return fail(ErrorKind::io, file.string(), fmt::format("cannot be written: {}", reason(error))); };
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status) || !file.has_filename()) {
    return fail(ErrorKind::io, file.string(), "cannot be written: it is a folder");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    return write_in_place(file, bytes);
  }
  if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0) {
    return cannot(errno);  // a rename would step over the write protection
  }
  auto target = follow_links(file);
  if (!target) {
    return tl::unexpected(std::move(target).error());
  }
  for (int attempt = 0; attempt < 10000; ++attempt) {
    const fs::path temporary = target->parent_path() / fmt::format("{}{}.tmp", temporary_prefix(::getpid()), attempt);
    Descriptor out(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (out.get() < 0 && errno == EEXIST) {
      continue;  // another thread's, or left behind by a killed process
    }
    if (out.get() < 0) {
      return cannot(errno);
    }
    int error = write_all(out.get(), bytes);
    if (error == 0) {
      error = out.close_now();
    }
    if (error == 0 && ::rename(temporary.c_str(), target->c_str()) != 0) {
      error = errno;
    }
    if (error != 0) {
      ::unlink(temporary.c_str());
      return cannot(error);
    }
    return {};
  }
  return cannot(EEXIST);
}

void remove_temporaries(const fs::path& folder, int process) {
  const std::string prefix = temporary_prefix(process);
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with(prefix) && name.ends_with(".tmp")) {
      std::error_code ignored;
      fs::remove(entry->path(), ignored);
    }
  }
}

}  // namespace lustro
