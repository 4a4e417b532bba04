// Whether two ways of drawing give the same floats, in colour and in all layers.
#pragma once

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <optional>
#include <string>

#include "lustro/lustro.hpp"

namespace lustro {

// Every layer there is.
inline std::vector<Aov> all_aovs() {
  std::vector<Aov> aovs;
  for (int kind = 0; kind <= static_cast<int>(AovKind::mask); ++kind) {
    aovs.push_back({static_cast<AovKind>(kind)});
  }
  return aovs;
}

// The first difference, in words.
inline std::optional<std::string> difference(const Image& a, const Image& b, const std::string& name) {
  if (a.width != b.width || a.height != b.height || a.channels != b.channels || a.pixels.size() != b.pixels.size()) {
    return name + ": sizes differ";
  }
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    if (std::bit_cast<std::uint32_t>(a.pixels[i]) != std::bit_cast<std::uint32_t>(b.pixels[i])) {
      const std::size_t pixel = i / static_cast<std::size_t>(a.channels);
      const std::size_t width = static_cast<std::size_t>(a.width);
      return name + "[" + std::to_string(pixel % width) + ", " + std::to_string(pixel / width) + "] channel " +
             std::to_string(i % static_cast<std::size_t>(a.channels)) + ": " + std::to_string(a.pixels[i]) + " and " +
             std::to_string(b.pixels[i]);
    }
  }
  return std::nullopt;
}

inline std::optional<std::string> difference(const Result<Rendering>& a, const Result<Rendering>& b) {
  if (!a || !b) {
    const bool agree = !a && !b && a.error().text() == b.error().text();
    return agree ? std::nullopt : std::optional<std::string>("one of them failed: " + (a ? b : a).error().text());
  }
  if (auto color = difference(a->color, b->color, "color")) {
    return color;
  }
  if (a->layers.size() != b->layers.size()) {
    return "numbers of layers differ";
  }
  for (std::size_t i = 0; i < a->layers.size(); ++i) {
    if (auto layer = difference(a->layers[i].image, b->layers[i].image, a->layers[i].name)) {
      return layer;
    }
  }
  if (a->bytes.pixels != b->bytes.pixels) {
    return "bytes differ";
  }
  if (a->stats.pixels_covered != b->stats.pixels_covered || a->stats.triangles_seen != b->stats.triangles_seen) {
    return "statistics differ";
  }
  return std::nullopt;
}

inline Result<Rendering> drawn(const Scene& scene, const RenderOptions& how, bool with_layers = true) {
  RenderOptions options = how;
  options.store_bytes = true;
  if (with_layers) {
    options.aovs = all_aovs();
  }
  return render(scene, options);
}

// The scene by the reference, by every row, and by the widest row on several numbers of threads.
inline void expect_parity(const Scene& scene, const std::string& name) {
  const Result<Rendering> reference = drawn(scene, {.engine = Engine::reference});
  const Result<Rendering> plain_reference = drawn(scene, {.engine = Engine::reference}, false);
  for (const Target target : available_targets()) {
    const auto found = difference(reference, drawn(scene, {.threads = 1, .target = target}));
    EXPECT_FALSE(found) << name << ", target " << target_name(target) << ": " << *found;
    const auto plain = difference(plain_reference, drawn(scene, {.threads = 2, .target = target}, false));
    EXPECT_FALSE(plain) << name << ", target " << target_name(target) << " without layers: " << *plain;
  }
  for (const int threads : {2, 3, 7}) {
    const auto found = difference(reference, drawn(scene, {.threads = threads}));
    EXPECT_FALSE(found) << name << ", " << threads << " threads: " << *found;
  }
}

// A renderer that draws scene after scene gives each as one that is new: nothing of the last is left in it.
template <typename SceneOf>
void expect_parity_when_used_again(unsigned scenes, SceneOf scene_of) {
  Renderer renderer;
  Rendering again;
  for (unsigned seed = 0; seed < scenes; ++seed) {
    const Scene scene = scene_of(seed);
    ASSERT_TRUE(renderer.render(scene, {.threads = 2}, again));
    const Result<Rendering> once = render(scene);
    ASSERT_TRUE(once);
    const auto found = difference(once->color, again.color, "used again " + std::to_string(seed));
    EXPECT_FALSE(found) << *found;
  }
}

}  // namespace lustro
