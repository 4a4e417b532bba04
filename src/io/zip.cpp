// Reads the directory at the archive's end and believes none of its numbers.
#include "io/zip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>

#include "image/inflate.hpp"
#include "io/text.hpp"

namespace lustro {
namespace {

constexpr std::string_view kEndMark("PK\x05\x06", 4);
constexpr std::string_view kEnd64Mark("PK\x06\x06", 4);
constexpr std::string_view kLocator64Mark("PK\x06\x07", 4);
constexpr std::string_view kEntryMark("PK\x01\x02", 4);
constexpr std::string_view kLocalMark("PK\x03\x04", 4);
constexpr std::size_t kEndBytes = 22;
constexpr std::size_t kEnd64Bytes = 56;
constexpr std::size_t kLocator64Bytes = 20;
constexpr std::size_t kEntryBytes = 46;
constexpr std::size_t kLocalBytes = 30;
constexpr std::size_t kMostComment = 65535;
constexpr std::uint64_t kIn64 = 0xFFFFFFFFU;  // the value stands in the ZIP64 field

/// `count` bytes, the least significant first. They are there.
std::uint64_t number(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint64_t value = 0;
  for (std::size_t i = count; i-- > 0;) {
    value = value << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return value;
}

bool has(std::string_view bytes, std::uint64_t at, std::uint64_t count) {
  return at <= bytes.size() && count <= bytes.size() - at;
}

struct Directory {
  std::uint64_t begin = 0;
  std::uint64_t count = 0;
};

std::optional<std::size_t> find_end(std::string_view bytes) {
  if (bytes.size() < kEndBytes) {
    return std::nullopt;
  }
  const std::size_t first = bytes.size() - std::min(bytes.size(), kEndBytes + kMostComment);
  for (std::size_t at = bytes.size() - kEndBytes + 1; at-- > first;) {
    if (bytes.substr(at, 4) == kEndMark) {
      return at;
    }
  }
  return std::nullopt;
}

Result<Directory> find_directory(std::string_view bytes, const std::string& file) {
  const std::optional<std::size_t> end = find_end(bytes);
  if (!end) {
    return fail(ErrorKind::malformed, at_byte(file, bytes.size()), "the ZIP archive ends without a directory: it is cut short");
  }
  if (number(bytes, *end + 4, 2) != 0 || number(bytes, *end + 6, 2) != 0) {
    return fail(ErrorKind::unsupported, at_byte(file, *end), "is one file of a ZIP archive in several");
  }
  Directory directory{number(bytes, *end + 16, 4), number(bytes, *end + 10, 2)};
  if (*end >= kLocator64Bytes && bytes.substr(*end - kLocator64Bytes, 4) == kLocator64Mark) {
    const std::uint64_t end64 = number(bytes, *end - kLocator64Bytes + 8, 8);
    if (!has(bytes, end64, kEnd64Bytes) || bytes.substr(end64, 4) != kEnd64Mark) {
      return fail(ErrorKind::malformed, at_byte(file, *end - kLocator64Bytes), fmt::format("a ZIP64 directory at byte {} is not there", end64));
    }
    directory = {number(bytes, end64 + 48, 8), number(bytes, end64 + 32, 8)};
  }
  return directory;
}

/// Takes what the 32-bit fields leave to the ZIP64 field. False where that is missing or short.
bool take_zip64(std::string_view extra, ZipPart& part) {
  const bool needs = part.unpacked == kIn64 || part.packed == kIn64 || part.header == kIn64;
  for (std::size_t at = 0; needs && has(extra, at, 4);) {
    const std::size_t size = number(extra, at + 2, 2);
    if (!has(extra, at + 4, size)) {
      return false;
    }
    if (number(extra, at, 2) == 1) {
      std::string_view field = extra.substr(at + 4, size);
      for (std::uint64_t* const value : {&part.unpacked, &part.packed, &part.header}) {
        if (*value != kIn64) {
          continue;
        }
        if (field.size() < 8) {
          return false;
        }
        *value = number(field, 0, 8);
        field.remove_prefix(8);
      }
      return true;
    }
    at += 4 + size;
  }
  return !needs;
}

}  // namespace

Result<ZipArchive> open_zip(std::string_view bytes, const std::string& file) {
  const Result<Directory> directory = find_directory(bytes, file);
  if (!directory) {
    return tl::unexpected(directory.error());
  }
  ZipArchive archive{bytes, file, {}};
  std::uint64_t at = directory->begin;
  for (std::uint64_t i = 0; i < directory->count; ++i) {
    if (!has(bytes, at, kEntryBytes) || bytes.substr(at, 4) != kEntryMark) {
      return fail(ErrorKind::malformed, at_byte(file, at),
                  fmt::format("entry {} of {} of the ZIP directory is not there", i + 1, directory->count));
    }
    const std::size_t name_bytes = number(bytes, at + 28, 2);
    const std::size_t extra_bytes = number(bytes, at + 30, 2);
    const std::size_t comment_bytes = number(bytes, at + 32, 2);
    if (!has(bytes, at + kEntryBytes, name_bytes + extra_bytes + comment_bytes)) {
      return fail(ErrorKind::malformed, at_byte(file, at), "an entry of the ZIP directory is cut short");
    }
    ZipPart part{number(bytes, at + 20, 4),
                 number(bytes, at + 24, 4),
                 number(bytes, at + 42, 4),
                 static_cast<std::uint32_t>(number(bytes, at + 16, 4)),
                 static_cast<std::uint16_t>(number(bytes, at + 10, 2)),
                 (number(bytes, at + 8, 2) & 1U) != 0};
    std::string name(bytes.substr(at + kEntryBytes, name_bytes));
    if (!take_zip64(bytes.substr(at + kEntryBytes + name_bytes, extra_bytes), part)) {
      return fail(ErrorKind::malformed, at_byte(file, at), fmt::format("the ZIP64 sizes of {} are missing", shown(name)));
    }
    archive.parts.insert_or_assign(std::move(name), part);
    at += kEntryBytes + name_bytes + extra_bytes + comment_bytes;
  }
  return archive;
}

Result<std::string> read_zip_part(const ZipArchive& archive, std::string_view name, std::uint64_t most) {
  const std::string where = fmt::format("{}: {}", archive.file, to_utf8(std::string(name)));
  const auto found = archive.parts.find(name);
  if (found == archive.parts.end()) {
    return fail(ErrorKind::malformed, where, "is not in the ZIP archive");
  }
  const ZipPart& part = found->second;
  const std::string_view bytes = archive.bytes;
  if (part.is_encrypted) {
    return fail(ErrorKind::unsupported, where, "is encrypted");
  }
  if (part.method != 0 && part.method != 8) {
    return fail(ErrorKind::unsupported, where, fmt::format("is packed by method {}, expected 0 (stored) or 8 (deflate)", part.method));
  }
  if (!has(bytes, part.header, kLocalBytes) || bytes.substr(part.header, 4) != kLocalMark) {
    return fail(ErrorKind::malformed, where, fmt::format("its header at byte {} is not there", part.header));
  }
  const std::uint64_t begin = part.header + kLocalBytes + number(bytes, part.header + 26, 2) + number(bytes, part.header + 28, 2);
  if (!has(bytes, begin, part.packed)) {
    return fail(ErrorKind::malformed, where,
                fmt::format("its {} bytes from byte {} on reach beyond the archive's {}", part.packed, begin, bytes.size()));
  }
  const std::string_view packed = bytes.substr(begin, part.packed);
  const bool is_false = part.method == 0 ? part.unpacked != part.packed : part.unpacked / kMostInflation > part.packed;
  if (is_false) {
    return fail(ErrorKind::malformed, where, fmt::format("{} bytes claim to unpack to {}", part.packed, part.unpacked));
  }
  if (part.unpacked > most) {
    return fail(ErrorKind::limit, where, fmt::format("unpacks to {} bytes, and at most {} are read", part.unpacked, most));
  }
  std::string out;
  if (part.method == 0) {
    out = packed;
  } else {
    out.resize(part.unpacked);
    if (!inflate_exactly(packed, out)) {
      return fail(ErrorKind::malformed, where, fmt::format("its data do not unpack to the {} bytes that are stated", part.unpacked));
    }
  }
  if (crc32_of(out) != part.crc) {
    return fail(ErrorKind::malformed, where, "its check sum (CRC-32) does not hold");
  }
  return out;
}

}  // namespace lustro
