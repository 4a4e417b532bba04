// How large a picture may be. Every reader checks its header against this before it takes memory.
#pragma once

#include <cstdint>
#include <new>
#include <string>

#include "lustro/result.hpp"

namespace lustro {

constexpr std::int64_t kMaxImageSide = 16384;

/// What a reader takes. The defaults are what read_image() promises; whoever has less memory (a fuzz target, say) states less.
struct ImageLimits {
  std::int64_t side = kMaxImageSide;
  std::int64_t pixels = kMaxImageSide * kMaxImageSide;
  std::int64_t chunk_bytes = std::int64_t{1} << 30;  ///< of what a file packs in one piece, unpacked
};

/// errors  malformed for a side below 1; limit
[[nodiscard]] Result<void> check_image_size(std::int64_t width, std::int64_t height, const std::string& where, const ImageLimits& limits);

/// What `make` returns, a Result; where it finds no memory, the error that says so.
/// errors  limit
template <class Make>
[[nodiscard]] auto within_memory(const std::string& where, Make&& make) -> decltype(make()) {
  try {
    return make();
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, where, "does not fit into memory");
  }
}

}  // namespace lustro
