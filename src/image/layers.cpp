// Layers as pictures that can be looked at. Numbers are mapped to 0..1 by the layer's name; light is left as it is.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "image/id_color.hpp"
#include "lustro/image.hpp"
#include "math/lane.hpp"

namespace lustro {
namespace {

enum class Kind { light, depth, direction, position, id, share };

Kind kind_of(const Layer& layer) {
  static constexpr std::array<std::pair<std::string_view, Kind>, 8> kKinds{{{"depth", Kind::depth},
                                                                            {"normal", Kind::direction},
                                                                            {"position", Kind::position},
                                                                            {"object", Kind::id},
                                                                            {"material", Kind::id},
                                                                            {"triangle", Kind::id},
                                                                            {"barycentrics", Kind::share},
                                                                            {"mask", Kind::share}}};
  const auto* found = std::ranges::find(kKinds, std::string_view(layer.name), &std::pair<std::string_view, Kind>::first);
  return found == kKinds.end() ? Kind::light : found->second;
}

struct Range {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();
  void add(float v) {
    if (std::isfinite(v)) {
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  /// 0..1 within the range; where the range is one value, that value is `alone`.
  [[nodiscard]] float place(float v, float alone) const { return high > low ? clamp01((v - low) / (high - low)) : alone; }
};

bool is_zero(std::span<const float> pixel) {
  return std::ranges::all_of(pixel, [](float v) { return !(v != 0); });
}

/// Near is white; far stays lighter than the black of the background, which is infinitely far.
Image depth_preview(const Image& depth) {
  Range range;
  for (const float v : depth.pixels) {
    range.add(v);
  }
  constexpr float kFar = 0.1F;
  Image out(depth.width, depth.height, depth.channels);
  std::ranges::transform(depth.pixels, out.pixels.begin(),
                         [&](float v) { return std::isfinite(v) ? 1.0F - (1.0F - kFar) * range.place(v, 0.0F) : 0.0F; });
  return out;
}

Image direction_preview(const Image& normals) {
  Image out(normals.width, normals.height, normals.channels);
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      if (!is_zero(normals.at(x, y))) {
        std::ranges::transform(normals.at(x, y), out.at(x, y).begin(), [](float n) { return clamp01(n * 0.5F + 0.5F); });
      }
    }
  }
  return out;
}

/// Each axis by its own bounds over what was drawn; an axis without extent is 0.5.
Image position_preview(const Image& positions) {
  std::vector<Range> ranges(static_cast<std::size_t>(positions.channels));
  const auto each_pixel = [&](auto&& f) {
    for (int y = 0; y < positions.height; ++y) {
      for (int x = 0; x < positions.width; ++x) {
        if (!is_zero(positions.at(x, y))) {
          f(x, y, positions.at(x, y));
        }
      }
    }
  };
  each_pixel([&](int, int, std::span<const float> p) {
    for (std::size_t c = 0; c < p.size(); ++c) {
      ranges[c].add(p[c]);
    }
  });
  Image out(positions.width, positions.height, positions.channels);
  each_pixel([&](int x, int y, std::span<const float> p) {
    for (std::size_t c = 0; c < p.size(); ++c) {
      out.at(x, y)[c] = ranges[c].place(p[c], 0.5F);
    }
  });
  return out;
}

Image id_preview(const Image& ids) {
  Image out(ids.width, ids.height, 3);
  for (int y = 0; y < ids.height; ++y) {
    for (int x = 0; x < ids.width; ++x) {
      const Vec3f color = id_color(ids.at(x, y)[0]);
      const auto to = out.at(x, y);
      to[0] = color.x;
      to[1] = color.y;
      to[2] = color.z;
    }
  }
  return out;
}

}  // namespace

bool is_data_layer(const Layer& layer) {
  return kind_of(layer) != Kind::light;
}

Image layer_preview(const Layer& layer) {
  switch (kind_of(layer)) {
    case Kind::depth:
      return depth_preview(layer.image);
    case Kind::direction:
      return direction_preview(layer.image);
    case Kind::position:
      return position_preview(layer.image);
    case Kind::id:
      return layer.image.channels > 0 ? id_preview(layer.image) : Image();
    case Kind::light:
    case Kind::share:
      break;
  }
  return layer.image;
}

}  // namespace lustro
