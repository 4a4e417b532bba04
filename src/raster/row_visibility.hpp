// What of each light, and of all that surrounds it, arrives at fragments: at a batch of them, or at a strip. Part of a row (row.cpp).
#pragma once

#include "raster/row_strip.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// a, stored in the place after the last light.
inline HWY_NOINLINE void find_openness(const PreparedScene& scene, TileScratch& s, std::size_t at, const Vec3<Float>& position,
                                       const Vec3<Float>& normal, const Vec3<Float>& face_normal) {
  store(&s.visibilities[scene.lights.size() * kStrip + at], openness_at(scene.occlusion.shading, position, normal, face_normal));
}

/// What of the lights and of all that surrounds it arrives at a batch of fragments, at the first place of TileScratch::visibilities;
/// reference/visibilities.cpp.
inline HWY_NOINLINE void find_visibilities(const PreparedScene& scene, TileScratch& s, const Vec3<Float>& position, const Vec3<Float>& normal,
                                           const Vec3<Float>& face_normal) {
  for (std::size_t l = 0; l < scene.shadows.maps.size(); ++l) {
    const DepthMap& map = scene.shadows.maps[l];
    if (map.shape != DepthShape::none) {
      store(&s.visibilities[l * kStrip], visibility_of(scene.lights[l], map, position, face_normal, normal));
    }
  }
  if (!scene.occlusion.empty()) {
    find_openness(scene, s, 0, position, normal, face_normal);
  }
}

/// The same of one batch, at the first place.
HWY_INLINE const float* find_visibilities(const PreparedScene& scene, TileScratch& s, const Batch& batch) {
  if (HWY_UNLIKELY(scene.looks_beyond())) {
    const Vec3<Float> face_normal = batch.faces.face_normal();
    find_visibilities(scene, s, batch.position, scene.shading.interpolation == Interpolation::phong ? batch.normal : face_normal, face_normal);
  }
  return s.visibilities.data();
}

/// What a strip's fragments read of a map.
struct Squares {
  alignas(64) std::array<std::int32_t, kStrip> first;
  alignas(64) std::array<float, kStrip> share_x, share_y, key, slope_x, slope_y;
  alignas(64) std::array<float, kStrip> to_light_x, to_light_y, to_light_z, n_dot_l;  ///< facing_share()'s

  /// Whether any surface of the batch faces the light, as the equation judges it: N.L > 0.
  HWY_INLINE bool aim(std::size_t i, const ShadingLight& light, const Vec3<Float>& position, const Vec3<Float>& normal) {
    const Vec3<Float> to_light = incident_light(light, position).to_light;
    const Float cosine = dot(normal, to_light);
    store(&to_light_x[i], to_light.x);
    store(&to_light_y[i], to_light.y);
    store(&to_light_z[i], to_light.z);
    store(&n_dot_l[i], cosine);
    return any_of(cosine > Float(0));
  }
  [[nodiscard]] HWY_INLINE Float facing(std::size_t i, const Vec3<Float>& face_normal, const Vec3<Float>& normal) const {
    return facing_share(face_normal, normal, {load(&to_light_x[i]), load(&to_light_y[i]), load(&to_light_z[i])}, load(&n_dot_l[i]));
  }

  HWY_INLINE void put(std::size_t i, const DepthSquare<Float>& square) {
    store(&first[i], square.first);
    store(&share_x[i], square.share_x);
    store(&share_y[i], square.share_y);
    store(&key[i], square.key);
    store(&slope_x[i], square.slope_x);
    store(&slope_y[i], square.slope_y);
  }
  [[nodiscard]] HWY_INLINE DepthSquare<Float> get(std::size_t i) const {
    return {load(&first[i]), load(&share_x[i]), load(&share_y[i]), load(&key[i]), load(&slope_x[i]), load(&slope_y[i])};
  }
  /// Asks for the texels: they lie far apart, and most are not in the cache.
  HWY_INLINE void prefetch(const DepthMap& map, std::size_t i) const {
    constexpr std::size_t kEvery = kLanes > 1 ? 2 : 1;  // neighbours mostly share a line of the cache
    for (std::size_t lane = 0; lane < kLanes; lane += kEvery) {
      const float* keys = map.keys + static_cast<std::size_t>(first[i + lane]);
      __builtin_prefetch(keys);
      __builtin_prefetch(keys + map.size);
    }
  }
};

/// The same of a strip. Where a light is behind the surface nothing asks for it. Short loops: the processor works at several vectors at once.
inline HWY_NOINLINE void find_visibilities(const Run& run, const FaceTable& faces, const Strip& strip) {
  const PreparedScene& scene = *run.frame.scene;
  const std::size_t batches = (run.count + kLanes - 1) / kLanes;
  const auto face_normal_at = [&](std::size_t i) { return Faces(faces, i / kLanes).face_normal(); };
  Squares squares;
  std::array<std::size_t, kStrip / kLanes> asked;  // the first fragments of batches that face the light
  if (!scene.occlusion.empty()) {
    for (std::size_t i = 0; i < run.count; i += kLanes) {
      find_openness(scene, run.s, i, Strip::get(strip.position, i), Strip::get(strip.normal, i), face_normal_at(i));
    }
  }
  for (std::size_t l = 0; l < scene.shadows.maps.size(); ++l) {
    const DepthMap& map = scene.shadows.maps[l];
    if (map.shape == DepthShape::none) {
      continue;
    }
    float* visibilities = &run.s.visibilities[l * kStrip];
    std::size_t count = 0;
    for (std::size_t i = 0; i < batches * kLanes; i += kLanes) {
      if (squares.aim(i, scene.lights[l], Strip::get(strip.position, i), Strip::get(strip.normal, i))) {
        asked[count++] = i;
      } else {
        store(visibilities + i, Float(0));
      }
    }
    for (std::size_t b = 0; b < count; ++b) {
      const Vec3<Float> face_normal = face_normal_at(asked[b]);
      squares.put(asked[b], square_around(map, Strip::get(strip.position, asked[b]), face_normal));
      squares.prefetch(map, asked[b]);
      store(visibilities + asked[b], squares.facing(asked[b], face_normal, Strip::get(strip.normal, asked[b])));
    }
    for (std::size_t b = 0; b < count; ++b) {
      store(visibilities + asked[b], share_that_is_lit(map, squares.get(asked[b])) * load(visibilities + asked[b]));
    }
  }
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
