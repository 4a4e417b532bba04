// What several tests of images need: a folder of their own, random pictures, bytes from hand.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "lustro/image.hpp"

namespace lustro {

/// An empty folder, removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "lustro-test-XXXXXX").string();
    path_ = ::mkdtemp(pattern.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(path_), std::filesystem::directory_iterator()));
  }

 private:
  std::filesystem::path path_;
};

inline std::vector<std::byte> bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

inline std::vector<std::byte> bytes_of_text(const std::string& text) {
  std::vector<std::byte> bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

/// The bits of the generator as the 32 that they are (its own type may be wider).
class RandomBits {
 public:
  using result_type = std::uint32_t;
  explicit RandomBits(unsigned seed) : generator_(seed) {}
  static constexpr result_type min() { return 0; }
  static constexpr result_type max() { return 0xFFFFFFFF; }
  result_type operator()() { return static_cast<result_type>(generator_()); }

 private:
  std::mt19937 generator_;
};

/// 0..1 from the bits of the generator, the same with every standard library.
inline float unit(std::mt19937& random) {
  return static_cast<float>(random() >> 8) * 0x1p-24F;
}

/// Colours 0..1; alpha (the last of 2 or 4 channels) 0..1 and multiplied in.
inline Image random_image(int width, int height, int channels, unsigned seed) {
  std::mt19937 random(seed);
  Image image(width, height, channels);
  const auto step = static_cast<std::size_t>(channels);
  for (std::size_t i = 0; i < image.pixels.size(); i += step) {
    const bool has_alpha = step == 2 || step == 4;
    const float alpha = has_alpha ? unit(random) : 1.0F;
    for (std::size_t c = 0; c < step; ++c) {
      image.pixels[i + c] = has_alpha && c == step - 1 ? alpha : unit(random) * alpha;
    }
  }
  return image;
}

inline float largest_difference(const Image& a, const Image& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.channels, b.channels);
  float worst = a.pixels.size() == b.pixels.size() ? 0.0F : 1e30F;
  for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
    worst = std::max(worst, std::abs(a.pixels[i] - b.pixels[i]));
  }
  return worst;
}

}  // namespace lustro
