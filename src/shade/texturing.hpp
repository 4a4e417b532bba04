// What maps do to a surface: from the place in a triangle to the factors of its coefficients, its exponent and its normal. F is a lane type:
// float for the reference, N floats for a kernel; Fetch reads texels (texture/sample.hpp).
//
// Derivatives are exact: with perspective u = U / Q, where U and Q are linear on the image, so u_dx = (U_dx - u Q_dx) / Q, from the triangle
// alone. Nothing is shared between pixels, so no picture depends on how pixels are grouped.
#pragma once

#include <array>
#include <cstdint>

#include "lustro/texture.hpp"
#include "lustro/vec.hpp"
#include "math/lane.hpp"
#include "math/power.hpp"
#include "shade/interpolation.hpp"
#include "shade/lighting.hpp"
#include "texture/sample.hpp"
#include "texture/texture.hpp"

namespace lustro {

enum class MapKind : std::uint8_t { ambient, diffuse, specular, emission, shininess, decal, bump, normal };
inline constexpr std::size_t kMapKinds = 8;

/// One map of a material, ready to be looked up. Numbers and pointers only: kernels read it. The same for all lanes.
struct ShadingMap {
  TextureLayout texels;
  float width = 1, height = 1;  ///< of the picture, texels
  Sampler sampler;
  std::uint8_t uv_set = 0;
  std::uint8_t channel = 0;
  bool leaves_outside = false;
  std::array<float, 6> uv_matrix{1, 0, 0, 0, 1, 0};
  bool has_matrix = false;  ///< it is another than that
  Vec3f gain{1, 1, 1};
  Vec3f base;

  [[nodiscard]] bool is_stretched() const { return gain.x != 1 || gain.y != 1 || gain.z != 1 || base.x != 0 || base.y != 0 || base.z != 0; }
};

/// All maps of a material: those that have something to say where it is drawn.
struct ShadingMaps {
  std::uint32_t present = 0;  ///< bit i: there is a map of MapKind i
  std::uint32_t uv_sets = 0;  ///< bit i: a map lies on set i
  std::array<ShadingMap, kMapKinds> maps;
  bool decal_on_ambient = true, decal_on_diffuse = true;  ///< the term is on
  bool normal_is_object_space = false;
  bool reflects = false;  ///< there is a reflection map (shade/reflection.hpp), too

  [[nodiscard]] bool has(MapKind kind) const { return (present >> static_cast<unsigned>(kind) & 1U) != 0; }
  [[nodiscard]] bool has_any() const { return present != 0 || reflects; }
  [[nodiscard]] bool changes_normal() const { return has(MapKind::bump) || has(MapKind::normal); }
  [[nodiscard]] const ShadingMap& operator[](MapKind kind) const { return maps[static_cast<std::size_t>(kind)]; }
  [[nodiscard]] ShadingMap& operator[](MapKind kind) { return maps[static_cast<std::size_t>(kind)]; }
};

/// How the weights of a triangle's three vertices change on the image: a pixel to the right, a pixel down. Each sums to 0.
template <class F>
struct WeightSlopes {
  Weights<F> dx, dy;
};

/// How the weights of a screen triangle's corners 1 and 2 change on the image before they are made perspective-correct, a pixel to the right and
/// a pixel down: of the triangle alone. With perspective, each is times its corner's depth key.
template <class F>
struct CornerSlopes {
  F w1_dx, w2_dx, w1_dy, w2_dy;
  F key_dx, key_dy;  ///< of the depth key, with perspective
};

/// x, y          the corners, 1/256 pixel
/// inverse_area  1 / twice the area, in 1/65536 pixel^2
/// key           depth keys of the corners; 1/depth with perspective
template <class F>
LUSTRO_INLINE CornerSlopes<F> corner_slopes(bool is_perspective, const std::array<IntOf<F>, 3>& x, const std::array<IntOf<F>, 3>& y,
                                            const F& inverse_area, const std::array<F, 3>& key) {
  const F per_pixel = inverse_area * F(256);
  // Edge functions 1 and 2 are linear: (x0 - x2) (py - y2) - (y0 - y2) (px - x2), and so on.
  const F w1_dx = to_float(y[2] - y[0]) * per_pixel;
  const F w1_dy = to_float(x[0] - x[2]) * per_pixel;
  const F w2_dx = to_float(y[0] - y[1]) * per_pixel;
  const F w2_dy = to_float(x[1] - x[0]) * per_pixel;
  if (!is_perspective) {
    return {w1_dx, w2_dx, w1_dy, w2_dy, F(0), F(0)};
  }
  return {w1_dx * key[1],
          w2_dx * key[2],
          w1_dy * key[1],
          w2_dy * key[2],
          (key[1] - key[0]) * w1_dx + (key[2] - key[0]) * w2_dx,
          (key[1] - key[0]) * w1_dy + (key[2] - key[0]) * w2_dy};
}

/// The slopes of the corners' weights at a point, before they are swapped or blended into those of a clipped triangle's vertices (which are
/// linear, so that slopes go the same way as weights).
///
/// w1, w2  weights of corners 1 and 2 at the point, perspective-correct
/// depth   at the point
template <class F>
LUSTRO_INLINE WeightSlopes<F> weight_slopes(bool is_perspective, const CornerSlopes<F>& of, const F& w1, const F& w2, const F& depth) {
  F w1_dx = of.w1_dx, w2_dx = of.w2_dx, w1_dy = of.w1_dy, w2_dy = of.w2_dy;
  if (is_perspective) {  // w_i = (b_i key_i) / key
    w1_dx = (w1_dx - w1 * of.key_dx) * depth;
    w1_dy = (w1_dy - w1 * of.key_dy) * depth;
    w2_dx = (w2_dx - w2 * of.key_dx) * depth;
    w2_dy = (w2_dy - w2 * of.key_dy) * depth;
  }
  return {{-(w1_dx + w2_dx), w1_dx, w2_dx}, {-(w1_dy + w2_dy), w1_dy, w2_dy}};
}

/// The texture coordinates at a point of a triangle, and how they change on the image.
template <class F>
LUSTRO_INLINE Footprint<F> footprint_at(const std::array<Vec2<F>, 3>& uvs, const Weights<F>& w, const WeightSlopes<F>& slopes) {
  const F u1 = uvs[1].x - uvs[0].x, u2 = uvs[2].x - uvs[0].x;
  const F v1 = uvs[1].y - uvs[0].y, v2 = uvs[2].y - uvs[0].y;
  return {(uvs[0].x * w[0] + uvs[1].x * w[1]) + uvs[2].x * w[2],
          (uvs[0].y * w[0] + uvs[1].y * w[1]) + uvs[2].y * w[2],
          u1 * slopes.dx[1] + u2 * slopes.dx[2],
          v1 * slopes.dx[1] + v2 * slopes.dx[2],
          u1 * slopes.dy[1] + u2 * slopes.dy[2],
          v1 * slopes.dy[1] + v2 * slopes.dy[2]};
}

/// How a point of the surface moves on the image: what a pixel to the right and a pixel down are on it. ab, ac: edges from vertex 0 to 1 and 2.
template <class F>
struct SurfaceSlopes {
  Vec3<F> dx, dy;
};
template <class F>
LUSTRO_INLINE SurfaceSlopes<F> surface_slopes(const Vec3<F>& ab, const Vec3<F>& ac, const WeightSlopes<F>& slopes) {
  return {ab * slopes.dx[1] + ac * slopes.dx[2], ab * slopes.dy[1] + ac * slopes.dy[2]};
}

/// A surface's coordinates as a map's: TextureUse::uv_matrix.
template <class F>
LUSTRO_INLINE Footprint<F> on_map(const ShadingMap& map, const Footprint<F>& at) {
  if (!map.has_matrix) {
    return at;
  }
  const std::array<float, 6>& m = map.uv_matrix;
  return {(F(m[0]) * at.u + F(m[1]) * at.v) + F(m[2]), (F(m[3]) * at.u + F(m[4]) * at.v) + F(m[5]), F(m[0]) * at.u_dx + F(m[1]) * at.v_dx,
          F(m[3]) * at.u_dx + F(m[4]) * at.v_dx,       F(m[0]) * at.u_dy + F(m[1]) * at.v_dy,       F(m[3]) * at.u_dy + F(m[4]) * at.v_dy};
}

/// What a map says at a point.
template <class F>
struct MapValue {
  Vec3<F> rgb;
  F alpha;
  F applies;  ///< 1, or 0 where the map leaves the material as it is
};

/// 1 within 0..1 along both axes.
template <class F>
LUSTRO_INLINE F is_on_picture(const F& u, const F& v) {
  const F nearest_u = lane_min(u, F(1) - u);  // below 0 outside
  const F nearest_v = lane_min(v, F(1) - v);
  return select(lane_min(nearest_u, nearest_v) >= F(0), F(1), F(0));
}

/// texel * gain + base.
template <class F>
LUSTRO_INLINE MapValue<F> value_of(const ShadingMap& map, const Texel<F>& texel, const F& applies) {
  return {{texel[0] * F(map.gain.x) + F(map.base.x), texel[1] * F(map.gain.y) + F(map.base.y), texel[2] * F(map.gain.z) + F(map.base.z)},
          texel[3],
          applies};
}

/// Looks a map up over a footprint, given in the coordinates of the surface. Large, so not forced into every caller.
template <class Fetch, class F>
MapValue<F> look_up(const ShadingMap& map, const Footprint<F>& surface) {
  const Footprint<F> at = on_map(map, surface);
  return value_of(map, sample(map.sampler, Fetch(map.texels), map.width, map.height, at), map.leaves_outside ? is_on_picture(at.u, at.v) : F(1));
}

/// The one value of a map that has one: TextureUse::channel. Alpha is stretched as red is.
template <class F>
LUSTRO_INLINE F chosen_channel(const ShadingMap& map, const MapValue<F>& value) {
  switch (map.channel) {
    case 0:
      return value.rgb.x;
    case 1:
      return value.rgb.y;
    case 2:
      return value.rgb.z;
    case 3:
      return value.alpha * F(map.gain.x) + F(map.base.x);
    default:  // Rec. 709
      return (value.rgb.x * F(0.2126F) + value.rgb.y * F(0.7152F)) + value.rgb.z * F(0.0722F);
  }
}

/// Whether v is neither 0 nor not a number.
template <class F>
LUSTRO_INLINE auto has_direction(const Vec3<F>& v) {
  return dot(v, v) > F(1e-30F);
}

/// v / |v|; `fallback` where v has no direction.
template <class F>
LUSTRO_INLINE Vec3<F> unit_or(const Vec3<F>& v, const Vec3<F>& fallback) {
  const F length2 = dot(v, v);
  const auto is_long = has_direction(v);
  const F scale = F(1) / square_root(select(is_long, length2, F(1)));
  return {select(is_long, v.x * scale, fallback.x), select(is_long, v.y * scale, fallback.y), select(is_long, v.z * scale, fallback.z)};
}

/// What maps of colours make of the coefficients: each is multiplied by its factor, then the decal is laid over.
template <class F>
struct MapFactors {
  Vec3<F> ambient{F(1), F(1), F(1)}, diffuse{F(1), F(1), F(1)}, specular{F(1), F(1), F(1)}, emission{F(1), F(1), F(1)};
  Vec3<F> decal{};
  F decal_share{};  ///< 0 where there is none
};

namespace texturing_detail {

template <class Fetch, class F>
LUSTRO_INLINE void look_up_factor(const ShadingMaps& maps, MapKind kind, const std::array<Footprint<F>, 2>& at, Vec3<F>& factor) {
  if (!maps.has(kind)) {
    return;
  }
  const ShadingMap& map = maps[kind];
  const MapValue<F> value = look_up<Fetch>(map, at[map.uv_set]);
  if (!map.leaves_outside) {
    factor = value.rgb;
    return;
  }
  const auto applies = value.applies > F(0);
  factor = {select(applies, value.rgb.x, F(1)), select(applies, value.rgb.y, F(1)), select(applies, value.rgb.z, F(1))};
}

}  // namespace texturing_detail

/// at  footprints of the mesh's two sets of texture coordinates
template <class Fetch, class F>
LUSTRO_INLINE MapFactors<F> map_factors(const ShadingMaps& maps, const std::array<Footprint<F>, 2>& at) {
  MapFactors<F> factors;
  texturing_detail::look_up_factor<Fetch>(maps, MapKind::ambient, at, factors.ambient);
  texturing_detail::look_up_factor<Fetch>(maps, MapKind::diffuse, at, factors.diffuse);
  texturing_detail::look_up_factor<Fetch>(maps, MapKind::specular, at, factors.specular);
  texturing_detail::look_up_factor<Fetch>(maps, MapKind::emission, at, factors.emission);
  if (maps.has(MapKind::decal)) {
    const ShadingMap& map = maps[MapKind::decal];
    const MapValue<F> value = look_up<Fetch>(map, at[map.uv_set]);
    factors.decal = value.rgb;
    factors.decal_share = value.alpha * value.applies;
  }
  return factors;
}

/// The coefficients under the maps. A decal covers what is there, vertex colours included.
template <class F, class N>
LUSTRO_INLINE void apply_factors(const ShadingMaps& maps, const MapFactors<F>& factors, Coefficients<F, N>& k) {
  k.ambient = k.ambient * factors.ambient;
  k.diffuse = k.diffuse * factors.diffuse;
  k.specular = k.specular * factors.specular;
  k.emission = k.emission * factors.emission;
  if (maps.has(MapKind::decal) && maps.decal_on_ambient) {
    k.ambient = k.ambient + (factors.decal - k.ambient) * factors.decal_share;
  }
  if (maps.has(MapKind::decal) && maps.decal_on_diffuse) {
    k.diffuse = k.diffuse + (factors.decal - k.diffuse) * factors.decal_share;
  }
}

/// k_d under the maps, also where the diffuse term is off.
template <class F>
LUSTRO_INLINE Vec3<F> textured_albedo(const ShadingMaps& maps, const MapFactors<F>& factors, const Vec3<F>& albedo) {
  const Vec3<F> k = albedo * factors.diffuse;
  return maps.has(MapKind::decal) ? k + (factors.decal - k) * factors.decal_share : k;
}

/// The terms of a face or a vertex under the maps of a pixel: classic texturing after lighting (OpenGL 1.0, 3.8.5, GL_MODULATE, term by term).
template <class F>
LUSTRO_INLINE void modulate(const MapFactors<F>& factors, Terms<F>& terms) {
  terms.ambient = terms.ambient * factors.ambient;
  terms.diffuse = terms.diffuse * factors.diffuse;
  terms.specular = terms.specular * factors.specular;
  terms.emission = terms.emission * factors.emission;
}

/// n under what the shininess map says, 0..10000.
template <class F>
LUSTRO_INLINE LaneExponent<F> shininess_under(const ShadingMap& map, const MapValue<F>& value, float shininess) {
  const F factor = select(value.applies > F(0), chosen_channel(map, value), F(1));
  return {lane_min(lane_max(factor * F(shininess), F(0)), F(10000))};
}
template <class Fetch, class F>
LUSTRO_INLINE LaneExponent<F> textured_shininess(const ShadingMaps& maps, const std::array<Footprint<F>, 2>& at, float shininess) {
  const ShadingMap& map = maps[MapKind::shininess];
  return shininess_under(map, look_up<Fetch>(map, at[map.uv_set]), shininess);
}

/// A normal map's vector: rgb * 2 - 1, of any length.
template <class Fetch, class F>
LUSTRO_INLINE MapValue<F> look_up_normal(const ShadingMaps& maps, const std::array<Footprint<F>, 2>& at) {
  const ShadingMap& map = maps[MapKind::normal];
  MapValue<F> value = look_up<Fetch>(map, at[map.uv_set]);
  value.rgb = value.rgb * F(2) - Vec3<F>{F(1), F(1), F(1)};
  return value;
}

/// x T + y B + z N with B = handedness (N x T), all of them as they are interpolated, not normalised: MikkTSpace. Not normalised either.
///
/// value       of look_up_normal()
/// handedness  its sign alone counts
template <class F>
LUSTRO_INLINE Vec3<F> from_tangent_frame(const Vec3<F>& value, const Vec3<F>& tangent, const F& handedness, const Vec3<F>& normal) {
  const Vec3<F> bitangent = cross(normal, tangent) * select(handedness < F(0), F(-1), F(1));
  return (tangent * value.x + bitangent * value.y) + normal * value.z;
}

/// The normal that a map states, in the space of light; `unchanged` where it does not apply or states none.
template <class F>
LUSTRO_INLINE Vec3<F> stated_normal(const Vec3<F>& stated, const F& applies, const Vec3<F>& unchanged) {
  return unit_or(stated * applies, unchanged);
}

/// A map's height over a point, and how it changes on the image.
template <class F>
struct HeightSlopes {
  F dx, dy;
};

/// The slopes of the bump map's height: central differences over one texel of the level that the pixel sees, along u and along v. So a pixel's
/// slope is the surface's own at the picture's finest level, and smooth.
/// source  Blinn 1978, Simulation of wrinkled surfaces
template <class Fetch, class F>
HeightSlopes<F> height_slopes(const ShadingMap& map, const Footprint<F>& surface) {
  const Footprint<F> at = on_map(map, surface);
  const Fetch fetch(map.texels);
  Sampler sampler = map.sampler;
  sampler.anisotropy = 1;
  const F lod = size_of_footprint(sampler, map.width, map.height, at).lod;
  const F texels = exp2_of(limit_lod(lod, map.texels.level_count));
  const F half_u = texels * F(0.5F / map.width);
  const F half_v = texels * F(0.5F / map.height);
  const auto height = [&](const F& u, const F& v) {
    Texel<F> texel = fetch_places<F>(sampler, fetch, places_at(sampler, fetch, u, v, lod));
    for (F& channel : texel) {
      channel = channel * F(fetch.scale());
    }
    return chosen_channel(map, value_of(map, texel, F(1)));
  };
  const F along_u = (height(at.u + half_u, at.v) - height(at.u - half_u, at.v)) * (F(map.width) / texels);
  const F along_v = (height(at.u, at.v + half_v) - height(at.u, at.v - half_v)) * (F(map.height) / texels);
  const F applies = map.leaves_outside ? is_on_picture(at.u, at.v) : F(1);
  return {(along_u * at.u_dx + along_v * at.v_dx) * applies, (along_u * at.u_dy + along_v * at.v_dy) * applies};
}

/// A normal over a bumpy surface.
/// source  Mikkelsen 2010, Bump mapping unparametrized surfaces on the GPU: n' = |det| n - sign(det) (h_dx R1 + h_dy R2),
///         R1 = P_dy x n, R2 = n x P_dx, det = P_dx . R1
///
/// normal   unit, on the side to which heights rise
/// surface  P_dx, P_dy in the normal's space
/// heights  in that space's unit
template <class F>
LUSTRO_INLINE Vec3<F> bumped_normal(const Vec3<F>& normal, const SurfaceSlopes<F>& surface, const HeightSlopes<F>& heights) {
  F size = F(1e-30F);
  for (const Vec3<F>& step : {surface.dx, surface.dy}) {
    size = lane_max(lane_abs(step.x), size);
    size = lane_max(lane_abs(step.y), size);
    size = lane_max(lane_abs(step.z), size);
  }
  const F scale = F(1) / size;  // so that no product underflows; the formula does not mind
  const Vec3<F> dx = surface.dx * scale;
  const Vec3<F> dy = surface.dy * scale;
  const Vec3<F> r1 = cross(dy, normal);
  const Vec3<F> r2 = cross(normal, dx);
  const F det = dot(dx, r1);
  const Vec3<F> gradient = (r1 * (heights.dx * scale) + r2 * (heights.dy * scale)) * select(det < F(0), F(-1), F(1));
  return unit_or(normal * lane_abs(det) - gradient, normal);
}

}  // namespace lustro
