// From samples to a pixel.
#include "reference/pixel.hpp"

#include <algorithm>

#include "reference/opacity.hpp"
#include "scene/samples.hpp"
#include "scene/sky.hpp"

namespace lustro {
namespace {

// A triangle in a pixel.
struct Part {
  std::uint32_t triangle;
  std::int32_t x, y;  // where it is shaded, 1/256 pixel
  float opacity;
  float amount = 0;  // samples, each by what of it the triangle brings to the eye
  int samples = 0;   // that show it
};

// The place where a triangle is shaded in a pixel: its centre if that is inside, else the first of the samples that show it: never outside the
// triangle, where weights would be wild.
class Places {
 public:
  Places(const PreparedScene& scene, int x, int y) : pattern_(sample_pattern(scene.view.samples)) {
    x_ = x * kSubpixelUnits + kSubpixelUnits / 2;
    y_ = y * kSubpixelUnits + kSubpixelUnits / 2;
  }
  [[nodiscard]] Part part(const ScreenTriangle& t, std::uint32_t index, std::size_t first_sample) const {
    const SampleOffset offset = covers(t, x_, y_) ? SampleOffset{0, 0} : pattern_[first_sample];
    return {index, x_ + offset.x, y_ + offset.y, 1};
  }
  [[nodiscard]] std::uint64_t key(const View& view, const ScreenTriangle& t, std::size_t sample) const {
    return key_at(view, t, x_ + pattern_[sample].x, y_ + pattern_[sample].y);
  }

 private:
  std::span<const SampleOffset> pattern_;
  std::int32_t x_, y_;
};

// A blended triangle in front of what a sample shows behind it.
struct Layer {
  std::uint64_t key;
  std::uint32_t triangle;
};

// What a pixel shows: its parts in the order of the samples that show them, and within a sample from the nearest to the farthest; and how much
// of the background.
struct PixelParts {
  std::vector<Part> parts;
  float uncovered = 0;  // samples, each by what of the background it shows
};
PixelParts parts_of(const PreparedScene& scene, const std::vector<ScreenTriangle>& triangles, const Visibility& visibility, int x, int y) {
  const Places places(scene, x, y);
  PixelParts result;
  const auto part_of = [&](std::uint32_t triangle, std::size_t sample, bool is_blended) -> Part& {
    const auto same = std::find_if(result.parts.begin(), result.parts.end(), [triangle](const Part& p) { return p.triangle == triangle; });
    if (same != result.parts.end()) {
      return *same;
    }
    Part& part = result.parts.emplace_back(places.part(triangles[triangle], triangle, sample));
    if (is_blended) {
      part.opacity = opacity_at(scene, triangles[triangle], part.x, part.y);
    }
    return part;
  };
  for (std::size_t s = 0; s < static_cast<std::size_t>(scene.view.samples); ++s) {
    std::vector<Layer> layers;
    for (const std::uint32_t triangle : visibility.layers(x, y)) {
      const std::uint64_t key = places.key(scene.view, triangles[triangle], s);
      if (key > visibility.key(x, y, static_cast<int>(s))) {
        layers.push_back({key, triangle});
      }
    }
    std::sort(layers.begin(), layers.end(), [](const Layer& a, const Layer& b) { return a.key > b.key; });
    float let_through = 1;
    const auto add = [&](std::uint32_t triangle, bool is_blended) {
      Part& part = part_of(triangle, s, is_blended);
      part.amount += let_through * part.opacity;
      ++part.samples;
      let_through = let_through * (1.0F - part.opacity);
    };
    for (const Layer& layer : layers) {
      add(layer.triangle, true);
    }
    const std::uint32_t winner = visibility.winner(x, y, static_cast<int>(s));
    if (winner != Visibility::kNothing) {
      add(winner, false);
    } else {
      result.uncovered += let_through;
    }
  }
  return result;
}

}  // namespace

Pixel resolve_pixel(const PreparedScene& scene, const std::vector<ScreenTriangle>& triangles, const Visibility& visibility, int x, int y,
                    bool wants_lights, std::vector<FragmentExplanation>* explanation) {
  const auto samples = static_cast<float>(scene.view.samples);
  Pixel pixel;
  std::vector<Vec3f> light_parts(wants_lights ? scene.lights.size() : 0);
  pixel.light_parts.resize(light_parts.size());
  const PixelParts shown = parts_of(scene, triangles, visibility, x, y);
  float covered = 0;
  float most = 0;
  for (const Part& part : shown.parts) {
    if (!(part.amount > 0)) {
      continue;
    }
    const float weight = part.amount / samples;
    FragmentExplanation* fragment_explanation = nullptr;
    if (explanation != nullptr) {
      explanation->push_back({});
      fragment_explanation = &explanation->back();
      fragment_explanation->samples = part.samples;
      fragment_explanation->opacity = part.opacity;
      fragment_explanation->weight = weight;
    }
    const Fragment fragment = shade_fragment(scene, triangles[part.triangle], part.x, part.y, light_parts, fragment_explanation);

    pixel.terms.ambient += fragment.terms.ambient * weight;
    pixel.terms.diffuse += fragment.terms.diffuse * weight;
    pixel.terms.specular += fragment.terms.specular * weight;
    pixel.terms.emission += fragment.terms.emission * weight;
    pixel.fog += fragment.fog * weight;
    pixel.scene_part += fragment.scene_part * weight;
    pixel.albedo += fragment.albedo * weight;
    for (std::size_t l = 0; l < light_parts.size(); ++l) {
      pixel.light_parts[l] += light_parts[l] * weight;
    }
    covered += part.amount;
    if (part.amount > most) {
      most = part.amount;
      pixel.dominant = fragment;
    }
  }
  pixel.coverage = covered / samples;
  pixel.uncovered = shown.uncovered / samples;
  pixel.background = background_at(scene, x, y) * pixel.uncovered;
  pixel.alpha = pixel.coverage + scene.background[3] * pixel.uncovered;
  return pixel;
}

}  // namespace lustro
