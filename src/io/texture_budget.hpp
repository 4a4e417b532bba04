// How much memory the textures of a scene may take together. Pictures are small beside what they become: a megabyte of PNG may state a gigabyte.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "image/limits.hpp"
#include "lustro/result.hpp"
#include "parallel/parallel_for.hpp"
#include "texture/texture.hpp"

namespace lustro {

/// What textures that are read one after the other may still take.
class TextureBudget {
 public:
  static constexpr std::uint64_t kMostBytes = std::uint64_t{4} << 30U;

  explicit TextureBudget(std::uint64_t most = kMostBytes) : most_(most), left_(most) {}

  /// What a reader may unpack: a texel takes 4 bytes at least.
  [[nodiscard]] ImageLimits limits(ImageLimits stated = {}) const {
    stated.pixels = std::min(stated.pixels, std::max(std::int64_t{1}, static_cast<std::int64_t>(left_ / 4)));
    return stated;
  }

  /// Takes what the texture needs, or says why it cannot be kept.
  [[nodiscard]] std::optional<Error> take(const Texture& texture, const std::string& where);

  /// Reads `count` pictures, a few at the same time: as many for any number of threads, so that the same ones find room.
  ///
  /// read(i, threads)  reads picture i within limits(), from any thread
  /// keep(i)           in order, one at a time, once it is read: takes it from the budget
  template <class Read, class Keep>
  static void in_order(std::size_t count, int threads, Read&& read, Keep&& keep) {
    constexpr std::size_t kAtOnce = 16;
    for (std::size_t first = 0; first < count; first += kAtOnce) {
      const std::size_t last = std::min(count, first + kAtOnce);
      parallel_jobs(last - first, threads, [&](std::size_t i, int own_threads) { read(first + i, own_threads); });
      for (std::size_t i = first; i < last; ++i) {
        keep(i);
      }
    }
  }

 private:
  std::uint64_t most_;
  std::uint64_t left_;
};

}  // namespace lustro
