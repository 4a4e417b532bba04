// Pictures of noise for the tests of textures.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "texture/texture.hpp"

namespace lustro {

inline float unit_random(std::mt19937& random) {
  return static_cast<float>(random() >> 8) * 0x1p-24F;
}

inline Image noise(int width, int height, int channels, unsigned seed, float low = 0, float high = 1) {
  std::mt19937 random(seed);
  Image image(width, height, channels);
  for (float& x : image.pixels) {
    x = low + (high - low) * unit_random(random);
  }
  return image;
}

inline std::shared_ptr<const Texture> made(const Image& image, int threads = 1) {
  auto texture = make_texture(image, threads);
  EXPECT_TRUE(texture) << (texture ? "" : texture.error().text());
  return texture ? *texture : nullptr;
}

}  // namespace lustro
