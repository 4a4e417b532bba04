// ZIP archives: the parts by name, unpacked one by one.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro {

/// One file of an archive, as the central directory states it.
struct ZipPart {
  std::uint64_t packed = 0;    ///< bytes in the archive
  std::uint64_t unpacked = 0;  ///< bytes of the file
  std::uint64_t header = 0;    ///< where its local header begins
  std::uint32_t crc = 0;
  std::uint16_t method = 0;  ///< 0 stored, 8 deflate
  bool is_encrypted = false;
};

struct ZipArchive {
  std::string_view bytes;
  std::string file;  ///< for messages
  std::map<std::string, ZipPart, std::less<>> parts;
};

/// The directory of an archive in memory, which must outlive the result. ZIP64 is read, too.
/// errors  malformed with the byte where a structure is cut short or points outside; unsupported for an archive in several files
/// source  PKWARE, APPNOTE.TXT 6.3
[[nodiscard]] Result<ZipArchive> open_zip(std::string_view bytes, const std::string& file);

/// The bytes of a part; its check sum holds.
/// most    bytes: what a part claims beyond that, or beyond what its packed bytes can become, is refused before memory is taken
/// errors  malformed, limit; unsupported for encryption and for other methods than stored and deflate
[[nodiscard]] Result<std::string> read_zip_part(const ZipArchive& archive, std::string_view name, std::uint64_t most);

}  // namespace lustro
