// See gltf_bake.hpp.
#include "io/gltf_bake.hpp"

#include <algorithm>
#include <cmath>

#include "image/limits.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

const Texture& largest_of(const GltfBake& bake) {
  const Texture* largest = nullptr;
  const auto texels = [](const Texture& t) { return static_cast<std::uint64_t>(t.width()) * static_cast<std::uint64_t>(t.height()); };
  for (const auto& picture : bake.pictures) {
    if (picture && (largest == nullptr || texels(*picture) > texels(*largest))) {
      largest = picture.get();
    }
  }
  return *largest;
}

/// Two neighbours along one axis and the second one's weight.
struct Pair {
  int first = 0, second = 0;
  double weight = 0;
};

Pair neighbours(int place, int size, int own_size, Wrap wrap) {
  const double at = (place + 0.5) * own_size / size - 0.5;
  const double floor = std::floor(at);
  const auto inside = [&](int i) { return wrap == Wrap::repeat ? (i + own_size) % own_size : std::clamp(i, 0, own_size - 1); };
  const int first = static_cast<int>(floor);
  return {inside(first), inside(first + 1), at - floor};
}

/// A picture as if it had the size of the largest one.
class Enlarged {
 public:
  Enlarged(const Texture& picture, const Texture& largest, Wrap wrap_u, Wrap wrap_v)
      : picture_(picture),
        width_(largest.width()),
        height_(largest.height()),
        is_same_(picture.width() == width_ && picture.height() == height_),
        wrap_u_(wrap_u),
        wrap_v_(wrap_v) {}

  [[nodiscard]] std::array<double, 4> at(int x, int y) const {
    if (is_same_) {
      const std::array<float, 4> t = picture_.texel(0, x, y);
      return {static_cast<double>(t[0]), static_cast<double>(t[1]), static_cast<double>(t[2]), static_cast<double>(t[3])};
    }
    const Pair u = neighbours(x, width_, picture_.width(), wrap_u_);
    const Pair v = neighbours(y, height_, picture_.height(), wrap_v_);
    const std::array<float, 4> a = picture_.texel(0, u.first, v.first);
    const std::array<float, 4> b = picture_.texel(0, u.second, v.first);
    const std::array<float, 4> c = picture_.texel(0, u.first, v.second);
    const std::array<float, 4> d = picture_.texel(0, u.second, v.second);
    std::array<double, 4> result{};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto mix = [](double from, double to, double weight) { return from + (to - from) * weight; };
      const double upper = mix(static_cast<double>(a[i]), static_cast<double>(b[i]), u.weight);
      const double lower = mix(static_cast<double>(c[i]), static_cast<double>(d[i]), u.weight);
      result[i] = mix(upper, lower, v.weight);
    }
    return result;
  }

 private:
  const Texture& picture_;
  int width_, height_;
  bool is_same_;
  Wrap wrap_u_, wrap_v_;
};

}  // namespace

void apply_texel(GltfSurface& surface, GltfRole role, const std::array<double, 4>& rgba, double occlusion_strength) {
  const auto tint = [&](std::array<double, 3>& color) {
    for (std::size_t i = 0; i < 3; ++i) {
      color[i] *= rgba[i];
    }
  };
  switch (role) {
    case GltfRole::base:
      tint(surface.base);
      break;
    case GltfRole::metallic:
      surface.metallic *= rgba[2];
      break;
    case GltfRole::roughness:
      surface.roughness *= rgba[1];
      break;
    case GltfRole::specular:
      surface.specular *= rgba[3];
      break;
    case GltfRole::specular_color:
      tint(surface.specular_color);
      break;
    case GltfRole::glossy_specular:
      tint(surface.glossy_specular);
      break;
    case GltfRole::glossiness:
      surface.glossiness *= rgba[3];
      break;
    case GltfRole::occlusion:
      surface.occlusion *= 1 + occlusion_strength * (rgba[0] - 1);
      break;
  }
}

std::array<double, 3> color_of(const ClassicSurface& classic, GltfTarget target) {
  return target == GltfTarget::ambient ? classic.ambient : target == GltfTarget::diffuse ? classic.diffuse : classic.specular;
}

std::uint64_t texels_of(const GltfBake& bake) {
  const Texture& largest = largest_of(bake);
  return static_cast<std::uint64_t>(largest.width()) * static_cast<std::uint64_t>(largest.height());
}

Result<std::shared_ptr<const Texture>> bake_gltf(const GltfBake& bake, int threads) {
  return within_memory({}, [&]() -> Result<std::shared_ptr<const Texture>> {
    const Texture& largest = largest_of(bake);
    std::vector<std::pair<GltfRole, Enlarged>> pictures;
    for (std::size_t role = 0; role < kGltfRoles; ++role) {
      if (bake.pictures[role]) {
        pictures.emplace_back(static_cast<GltfRole>(role), Enlarged(*bake.pictures[role], largest, bake.wrap_u, bake.wrap_v));
      }
    }
    const bool is_scalar = bake.target == GltfTarget::shininess;
    Image image(largest.width(), largest.height(), is_scalar ? 1 : 3);
    parallel_for(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
      float* to = image.pixels.data() + row * static_cast<std::size_t>(image.width * image.channels);
      for (int x = 0; x < image.width; ++x) {
        GltfSurface surface = bake.factors;
        for (const auto& [role, picture] : pictures) {
          apply_texel(surface, role, picture.at(x, static_cast<int>(row)), bake.occlusion_strength);
        }
        const ClassicSurface classic = classic_surface(surface);
        if (is_scalar) {
          *to++ = static_cast<float>(classic.shininess / bake.shininess_unit);
          continue;
        }
        const std::array<double, 3> rgb = color_of(classic, bake.target);
        to = std::transform(rgb.begin(), rgb.end(), to, [](double value) { return static_cast<float>(value); });
      }
    });
    return make_texture(image, threads);
  });
}

}  // namespace lustro
