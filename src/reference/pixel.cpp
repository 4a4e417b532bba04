// From samples to a pixel.
#include "reference/pixel.hpp"

#include <algorithm>

#include "scene/samples.hpp"

namespace lustro {
namespace {

// The samples of a pixel that show the same triangle.
struct Group {
  std::uint32_t triangle;
  int samples;
  std::size_t first_sample;
};

std::vector<Group> group_samples(const Visibility& visibility, int x, int y, std::size_t samples) {
  std::vector<Group> groups;
  for (std::size_t s = 0; s < samples; ++s) {
    const std::uint32_t winner = visibility.winner(x, y, static_cast<int>(s));
    if (winner == Visibility::kNothing) {
      continue;
    }
    const auto same = std::find_if(groups.begin(), groups.end(), [winner](const Group& g) { return g.triangle == winner; });
    if (same != groups.end()) {
      ++same->samples;
    } else {
      groups.push_back({winner, 1, s});
    }
  }
  return groups;
}

}  // namespace

Pixel resolve_pixel(const PreparedScene& scene, const std::vector<ScreenTriangle>& triangles, const Visibility& visibility, int x, int y,
                    bool wants_lights, std::vector<FragmentExplanation>* explanation) {
  const auto pattern = sample_pattern(scene.view.samples);
  const auto samples = static_cast<float>(pattern.size());
  const std::int32_t center_x = x * kSubpixelUnits + kSubpixelUnits / 2;
  const std::int32_t center_y = y * kSubpixelUnits + kSubpixelUnits / 2;

  Pixel pixel;
  std::vector<Vec3f> light_parts(wants_lights ? scene.lights.size() : 0);
  pixel.light_parts.resize(light_parts.size());
  int covered = 0;
  int most = 0;
  for (const Group& group : group_samples(visibility, x, y, pattern.size())) {
    const ScreenTriangle& t = triangles[group.triangle];
    // Shaded at the pixel's centre if that is inside, else at the first of its samples: never outside the triangle, where weights would be wild.
    const SampleOffset offset = covers(t, center_x, center_y) ? SampleOffset{0, 0} : pattern[group.first_sample];
    FragmentExplanation* fragment_explanation = nullptr;
    if (explanation != nullptr) {
      explanation->push_back({});
      fragment_explanation = &explanation->back();
      fragment_explanation->samples = group.samples;
    }
    const Fragment fragment = shade_fragment(scene, t, center_x + offset.x, center_y + offset.y, light_parts, fragment_explanation);

    const float weight = static_cast<float>(group.samples) / samples;
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
    covered += group.samples;
    if (group.samples > most) {
      most = group.samples;
      pixel.dominant = fragment;
    }
  }
  pixel.coverage = static_cast<float>(covered) / samples;
  const float uncovered = (samples - static_cast<float>(covered)) / samples;
  pixel.background = Vec3f{scene.background[0], scene.background[1], scene.background[2]} * uncovered;
  pixel.alpha = pixel.coverage + scene.background[3] * uncovered;
  return pixel;
}

}  // namespace lustro
