// A surrounding that says where one looks.
#pragma once

#include <memory>

#include "lustro/image.hpp"
#include "lustro/texture.hpp"

namespace lustro {

/// A picture whose colour is its own direction d, as (d + 1) / 2. direction(u, v), of any length, of the picture's coordinates 0..1.
std::shared_ptr<const Texture> picture(int width, int height, const auto& direction) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Vec3d d = normalize(direction((x + 0.5) / width, (y + 0.5) / height));
      const auto pixel = image.at(x, y);
      pixel[0] = static_cast<float>(d.x * 0.5 + 0.5);
      pixel[1] = static_cast<float>(d.y * 0.5 + 0.5);
      pixel[2] = static_cast<float>(d.z * 0.5 + 0.5);
    }
  }
  return *make_texture(image, 1);
}

}  // namespace lustro
