// See surroundings.hpp.
#include "scene/surroundings.hpp"

#include <algorithm>
#include <cmath>

#include "scene/environment_light.hpp"
#include "scene/prepare_maps.hpp"

namespace lustro {
namespace {

/// Half powers of two: group g stands for 2^(g / 2).
int group_of(float n) {
  int group = 0;
  for (double limit = 1.189207115002721; limit < static_cast<double>(n); limit *= 1.4142135623730951) {  // 2^(1/4), then steps of 2^(1/2)
    ++group;
  }
  return group;
}

float exponent_of(int group) {
  float n = (group & 1) != 0 ? 1.4142135F : 1.0F;
  for (int i = 0; i < group / 2; ++i) {
    n *= 2;
  }
  return n;
}

ShadingMap sphere_map(std::shared_ptr<const Texture> texture, const Vec3f& gain, double rotation) {
  TextureUse use;
  use.texture = std::move(texture);
  use.sampler.wrap_u = Wrap::repeat;
  use.sampler.wrap_v = Wrap::clamp_to_edge;
  use.gain = gain;
  use.uv_matrix[2] = static_cast<float>(rotation / 360);
  return prepare_map(use);
}

bool is_mirror(const Material& material) {
  return material.illumination && *material.illumination >= 3 && *material.illumination <= 7;
}

bool has_highlight(const ShadingMaterial& material) {
  const Vec3f& k = material.coefficients.specular;
  return material.lighting != Lighting::constant && material.lighting != Lighting::lambert && (k.x > 0 || k.y > 0 || k.z > 0);
}

}  // namespace

void EnvironmentCache::use(const std::shared_ptr<const Image>& picture) {
  if (picture != picture_) {
    diffuse_.reset();
    sharp_.reset();
    blurred_.clear();
    picture_ = picture;
  }
}

const ShadingEnvironment& EnvironmentCache::diffuse(int threads) {
  if (!diffuse_) {
    diffuse_ = diffuse_light(*picture_, threads);
  }
  return *diffuse_;
}

Result<std::shared_ptr<const Texture>> EnvironmentCache::white() {
  if (white_ == nullptr) {
    Image one(1, 1, 3);
    std::fill(one.pixels.begin(), one.pixels.end(), 1.0F);
    auto texture = make_texture(one, 1);
    if (!texture) {
      return texture;
    }
    white_ = *std::move(texture);
  }
  return white_;
}

Result<std::shared_ptr<const Texture>> EnvironmentCache::sharp(int threads) {
  if (sharp_ == nullptr) {
    auto texture = make_texture(*picture_, threads);
    if (!texture) {
      return texture;
    }
    sharp_ = *std::move(texture);
  }
  return sharp_;
}

Result<std::shared_ptr<const Texture>> EnvironmentCache::blurred(float n, int threads) {
  const int group = group_of(n);
  const auto found = std::ranges::find(blurred_, group, &Blur::group);
  if (found != blurred_.end()) {
    return found->texture;
  }
  auto texture = make_texture(blurred_by_lobe(*picture_, exponent_of(group), threads), threads);
  if (texture) {
    blurred_.push_back({group, *texture});
  }
  return texture;
}

Result<void> lay_surroundings(const Scene& scene, EnvironmentCache& cache, int threads, PreparedScene& prepared) {
  if (!scene.environment) {
    return {};
  }
  const Environment& environment = *scene.environment;
  const Vec3f& gain = prepared.environment->color;
  const bool is_plain = environment.picture == nullptr;
  if (is_plain) {
    prepared.around = diffuse_light(gain);
  } else {
    cache.use(environment.picture);
    prepared.around = turned(cache.diffuse(threads), environment.rotation);
    for (Vec3f& part : prepared.around->of) {
      part = part * gain;
    }
  }
  const auto map_of = [&](Result<std::shared_ptr<const Texture>> texture, const Vec3f& by) {
    return std::move(texture).map([&](std::shared_ptr<const Texture>&& t) { return sphere_map(std::move(t), by, environment.rotation); });
  };
  if (environment.visible && !scene.image.transparent) {
    auto sky = map_of(is_plain ? cache.white() : cache.sharp(threads), gain);
    if (!sky) {
      return tl::unexpected(std::move(sky).error());
    }
    prepared.sky = *std::move(sky);
    prepared.background = {0, 0, 0, 1};
  }
  for (ShadingMaterial& material : prepared.materials) {
    if (material.maps.reflects || !has_highlight(material)) {
      continue;
    }
    const bool mirrors = is_mirror(material.stated);
    const float stated = material.coefficients.shininess.n;
    const float n = material.lighting == Lighting::phong ? stated : stated / 4;
    const bool keeps_energy = mirrors || prepared.shading.normalized || material.lighting == Lighting::ggx;
    auto map = map_of(is_plain  ? cache.white()
                      : mirrors ? cache.sharp(threads)
                                : cache.blurred(n, threads),
                      keeps_energy ? gain : gain * (2 / (n + 1)));
    if (!map) {
      return tl::unexpected(std::move(map).error());
    }
    material.reflection.shape = ReflectionShape::sphere;
    material.reflection.present = 1;
    material.reflection.faces[0] = *std::move(map);
    material.maps.reflects = true;
  }
  return {};
}

}  // namespace lustro
