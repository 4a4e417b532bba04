// ZIP archives for tests: parts as they are given, stored or deflated, right or spoilt.
#pragma once

#include <libdeflate.h>

#include <cstdint>
#include <string>
#include <vector>

namespace lustro {

struct ZipEntry {
  std::string name;
  std::string bytes;
  bool is_packed = true;
  bool is_zip64 = false;
};

inline std::string little(std::uint64_t value, unsigned count) {
  std::string bytes;
  for (unsigned i = 0; i < count; ++i) {
    bytes += static_cast<char>((value >> (8 * i)) & 0xFFU);
  }
  return bytes;
}

inline std::string deflated(const std::string& bytes) {
  libdeflate_compressor* const compressor = libdeflate_alloc_compressor(6);
  std::string out(libdeflate_deflate_compress_bound(compressor, bytes.size()), '\0');
  out.resize(libdeflate_deflate_compress(compressor, bytes.data(), bytes.size(), out.data(), out.size()));
  libdeflate_free_compressor(compressor);
  return out;
}

inline std::string zip(const std::vector<ZipEntry>& entries) {
  std::string archive;
  std::string directory;
  for (const ZipEntry& entry : entries) {
    const std::string packed = entry.is_packed ? deflated(entry.bytes) : entry.bytes;
    const std::uint32_t crc = libdeflate_crc32(0, entry.bytes.data(), entry.bytes.size());
    const std::string field64 =
        entry.is_zip64 ? little(1, 2) + little(24, 2) + little(entry.bytes.size(), 8) + little(packed.size(), 8) + little(archive.size(), 8)
                       : "";
    const auto in32 = [&entry](std::size_t value) { return little(entry.is_zip64 ? 0xFFFFFFFFU : value, 4); };
    const std::string common = little(20, 2) + little(0, 2) + little(entry.is_packed ? 8 : 0, 2) + little(0, 4) + little(crc, 4) +
                               in32(packed.size()) + in32(entry.bytes.size()) + little(entry.name.size(), 2);
    directory += "PK\x01\x02" + little(20, 2) + common + little(field64.size(), 2) + little(0, 2) + little(0, 2) + little(0, 2) + little(0, 4) +
                 in32(archive.size()) + entry.name + field64;
    archive += "PK\x03\x04" + common + little(0, 2) + entry.name + packed;
  }
  const std::size_t begin = archive.size();
  return archive + directory + "PK\x05\x06" + little(0, 4) + little(entries.size(), 2) + little(entries.size(), 2) +
         little(directory.size(), 4) + little(begin, 4) + little(0, 2);
}

}  // namespace lustro
