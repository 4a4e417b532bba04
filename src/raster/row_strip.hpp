// Strips of fragments on their way through shading. Part of a row (row.cpp).
#pragma once

#include "raster/row_fragment.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

inline constexpr std::size_t kStrip = TileScratch::kStrip;

/// Fragments on their way through shading, a stage at a time. Each stage is a short loop, so that the processor works at several of its vectors
/// at once, and the compiler keeps what all of them need in registers.
struct Strip {
  using Rows = std::array<std::array<float, kStrip>, 3>;
  alignas(64) Rows position, normal, to_eye, tint, color;
  alignas(64) Rows ambient, diffuse, specular, emission;  // coefficients, where maps change them
  alignas(64) std::array<float, kStrip> shininess;        // where a map does
  alignas(64) Rows reflection;                            // reflected_surroundings(), where there is a reflection map

  HWY_INLINE static void put(Rows& rows, std::size_t i, const Vec3<Float>& value) {
    store(&rows[0][i], value.x);
    store(&rows[1][i], value.y);
    store(&rows[2][i], value.z);
  }
  HWY_INLINE static Vec3<Float> get(const Rows& rows, std::size_t i) { return {load(&rows[0][i]), load(&rows[1][i]), load(&rows[2][i])}; }
};

/// Fragments of one material in a row.
struct Run {
  const Frame& frame;
  TileScratch& s;
  const TileScratch::Fragments& fragments;
  const Instance& instance;
  const ShadingMaterial& material;
  std::size_t begin, count;

  [[nodiscard]] HWY_INLINE Batch batch(std::size_t i, bool needs_normal = true) const {
    return make_batch(frame, s, fragments, instance, material, begin + i, count - i < kLanes ? count - i : kLanes, needs_normal);
  }
  /// Strip by strip.
  template <class Shade>
  void in_strips(Shade&& shade) const {
    for (std::size_t i = 0; i < count; i += kStrip) {
      shade(Run{frame, s, fragments, instance, material, begin + i, count - i < kStrip ? count - i : kStrip});
    }
  }
};

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
