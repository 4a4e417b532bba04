// By libdeflate.
#include "image/inflate.hpp"

#include <libdeflate.h>

#include <memory>

namespace lustro {

bool inflate_exactly(std::string_view packed, std::span<char> out) {
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(libdeflate_alloc_decompressor(),
                                                                                                       &libdeflate_free_decompressor);
  if (decompressor == nullptr) {
    return false;
  }
  char nothing = 0;
  std::size_t made = 0;
  const libdeflate_result result =
      libdeflate_deflate_decompress(decompressor.get(), packed.data(), packed.size(), out.empty() ? &nothing : out.data(), out.size(), &made);
  return result == LIBDEFLATE_SUCCESS && made == out.size();
}

std::uint32_t crc32_of(std::string_view bytes) {
  return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace lustro
