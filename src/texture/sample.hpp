// Looking a texture up: the only place where coordinates become texels. F is a lane type: float for the reference, N floats for a kernel, which
// brings its own way to read texels (Fetch); all arithmetic around it stands here, once.
//
//   source  OpenGL 4.6 core specification, 8.14 (minification: level of detail, wrap modes, filters) and 8.15 (magnification);
//           EXT_texture_filter_anisotropic for several looks along a footprint's long axis
//
// Where we differ: the short axis of a footprint counts as at least one texel, since looks closer than that bring nothing; and what is not
// finite has a meaning: such a coordinate counts as 0, such a derivative as a footprint without size. Whatever the numbers, no texel outside the
// texture is read.
#pragma once

#include <array>
#include <cstdint>

#include "lustro/texture.hpp"
#include "math/lane.hpp"
#include "math/power.hpp"
#include "texture/texture.hpp"

namespace lustro {

/// RGBA.
template <class F>
using Texel = std::array<F, 4>;

/// Where a surface shows a texture, and how that changes on the image.
template <class F>
struct Footprint {
  F u, v;        ///< in pictures: 0..1 is one
  F u_dx, v_dx;  ///< a pixel to the right
  F u_dy, v_dy;  ///< a pixel down
};

/// A level as lanes need it: each lane may look at another one. All words whole numbers.
template <class F>
struct LevelPlace {
  IntOf<F> width, height, row, first;
};

/// Four texels: a pair side by side in each of two rows, and how they are blended. What is the same in both rows or columns has blend 0.
template <class F>
struct TexelQuad {
  IntOf<F> upper, lower;  ///< places of the left texels
  F across, down;         ///< share of the right ones, of the lower ones
  F inside;               ///< share that is not the sampler's border
};

/// One or two levels and where to look at them.
template <class F>
struct Places {
  TexelQuad<F> near, far;  ///< of the larger and of the smaller level
  F blend;                 ///< share of the smaller level; where it is 0 in all lanes `far` is not looked at
};

/// What a footprint's size asks for.
template <class F>
struct FootprintSize {
  F lod;             ///< log2 of the texels that a look spans; below 0 the texture is magnified
  F looks;           ///< 1..anisotropy, whole
  F u_long, v_long;  ///< the long axis: pictures that a pixel's step along it brings
};

/// a + (b - a) t: exactly a at t = 0 and where a = b.
template <class V, class T>
LUSTRO_INLINE V blend(const V& a, const V& b, const T& t) {
  return a + (b - a) * t;
}

/// One channel of a quad. V may be a lane type, or a vector that holds a texel's channels.
template <class V, class T>
LUSTRO_INLINE V blend_quad(const V& upper_left, const V& upper_right, const V& lower_left, const V& lower_right, const T& across,
                           const T& down) {
  return blend(blend(upper_left, upper_right, across), blend(lower_left, lower_right, across), down);
}

namespace texture_detail {

template <class F>
struct AxisPlace {
  IntOf<F> texel;  ///< 0 .. size - 1
  F share;         ///< of the next one
  F inside;        ///< share that is not border
};

template <class F>
LUSTRO_INLINE F finite_or_zero(const F& x) {
  return select(lane_abs(x) < F(3e38F), x, F(0));
}

template <class F>
LUSTRO_INLINE F limit(const F& x, const F& low, const F& high) {
  return lane_min(lane_max(x, low), high);
}

/// Equation 8.14.3, GL_NEAREST: texel floor(wrap(c) size). c is finite.
template <class F>
LUSTRO_INLINE AxisPlace<F> nearest_on_axis(Wrap wrap, const F& c, const IntOf<F>& size) {
  using I = IntOf<F>;
  const F n = to_float(size);
  switch (wrap) {
    case Wrap::repeat:
      return {lane_min(truncate((c - floor_of(c)) * n), size - I(1)), F(0), F(1)};
    case Wrap::mirrored_repeat: {
      const F half = c * F(0.5F);
      const I i = truncate((half - floor_of(half)) * F(2) * n);  // 0 .. 2 size
      return {lane_max(select(i < size, i, size + size - I(1) - i), I(0)), F(0), F(1)};
    }
    case Wrap::clamp_to_edge:
      return {truncate(limit(c * n, F(0), n - F(1))), F(0), F(1)};
    case Wrap::clamp_to_border:
      break;
  }
  const F x = floor_of(limit(c * n, F(-1), n));
  return {truncate(limit(x, F(0), n - F(1))), F(0), select(x < F(0), F(0), select(x < n, F(1), F(0)))};
}

/// Equation 8.14.3, GL_LINEAR: the two texels around wrap(c) size - 1/2.
template <class F>
LUSTRO_INLINE AxisPlace<F> linear_on_axis(Wrap wrap, const F& c, const IntOf<F>& size) {
  using I = IntOf<F>;
  const F n = to_float(size);
  switch (wrap) {
    case Wrap::repeat: {
      const F x = (c - floor_of(c)) * n - F(0.5F);  // -1/2 .. size - 1/2
      const F left = floor_of(x);
      return {select(left < F(0), size - I(1), truncate(left)), x - left, F(1)};
    }
    case Wrap::mirrored_repeat: {  // beyond the edge lies the edge's own texel: folded, then as clamp_to_edge
      const F half = c * F(0.5F);
      const F turn = (half - floor_of(half)) * F(2);  // 0 .. 2
      const F x = limit(lane_min(turn, F(2) - turn) * n - F(0.5F), F(0), n - F(1));
      const F left = floor_of(x);
      return {truncate(left), x - left, F(1)};
    }
    case Wrap::clamp_to_edge: {
      const F x = limit(c * n - F(0.5F), F(0), n - F(1));
      const F left = floor_of(x);
      return {truncate(left), x - left, F(1)};
    }
    case Wrap::clamp_to_border:
      break;
  }
  const F x = limit(c * n - F(0.5F), F(-1), n);
  const F left = floor_of(x);
  const F share = x - left;
  const auto is_before = left < F(0);     // border, texel 0
  const auto is_inner = left < n - F(1);  // else: texel size - 1, border; or border twice
  const F inside = select(is_before, share, select(is_inner, F(1), select(left < n, F(1) - share, F(0))));
  return {truncate(limit(left, F(0), n - F(1))), select(is_before, F(0), select(is_inner, share, F(0))), inside};
}

template <class F, class M>
LUSTRO_INLINE AxisPlace<F> on_axis(const Sampler& sampler, Wrap wrap, bool blends, const F& c, const IntOf<F>& size, const M& is_magnified) {
  if (!blends) {
    return nearest_on_axis(wrap, c, size);
  }
  if (sampler.magnify == sampler.minify) {
    return sampler.magnify == TextureFilter::linear ? linear_on_axis(wrap, c, size) : nearest_on_axis(wrap, c, size);
  }
  const AxisPlace<F> linear = linear_on_axis(wrap, c, size);
  const AxisPlace<F> nearest = nearest_on_axis(wrap, c, size);
  const AxisPlace<F>& magnified = sampler.magnify == TextureFilter::linear ? linear : nearest;
  const AxisPlace<F>& minified = sampler.magnify == TextureFilter::linear ? nearest : linear;
  return {select(is_magnified, magnified.texel, minified.texel), select(is_magnified, magnified.share, minified.share),
          select(is_magnified, magnified.inside, minified.inside)};
}

template <class F, class M>
TexelQuad<F> quad_at(const Sampler& sampler, const LevelPlace<F>& level, const F& u, const F& v, const M& is_magnified) {
  using I = IntOf<F>;
  const AxisPlace<F> x = on_axis(sampler, sampler.wrap_u, sampler.blend_u, u, level.width, is_magnified);
  const AxisPlace<F> y = on_axis(sampler, sampler.wrap_v, sampler.blend_v, v, level.height, is_magnified);
  const I left = level.first + x.texel;
  const I upper = left + y.texel * level.row;
  const I lower = select(y.texel + I(1) < level.height, upper + level.row, sampler.wrap_v == Wrap::repeat ? left : upper);
  return {upper, lower, x.share, y.share, x.inside * y.inside};
}

}  // namespace texture_detail

/// lod = log2(rho / looks) + bias: 8.14.1, with rho the footprint's long axis in texels of the picture.
template <class F>
LUSTRO_INLINE FootprintSize<F> size_of_footprint(const Sampler& sampler, float width, float height, const Footprint<F>& at) {
  const F ux = at.u_dx * F(width), vx = at.v_dx * F(height);
  const F uy = at.u_dy * F(width), vy = at.v_dy * F(height);
  constexpr float kLeast = 1e-30F, kMost = 1e30F;  // NaN becomes the least
  const F x2 = lane_min(lane_max(ux * ux + vx * vx, F(kLeast)), F(kMost));
  const F y2 = lane_min(lane_max(uy * uy + vy * vy, F(kLeast)), F(kMost));
  const auto is_along_x = x2 > y2;
  const F long2 = select(is_along_x, x2, y2);
  FootprintSize<F> size{F(0), F(1), F(0), F(0)};
  if (sampler.anisotropy <= 1) {
    size.lod = log2_of(long2) * F(0.5F) + F(sampler.lod_bias);
    return size;
  }
  const F short2 = lane_max(select(is_along_x, y2, x2), F(1));
  const F ratio = square_root(long2 / short2);
  size.looks = lane_max(-floor_of(-lane_min(ratio, F(static_cast<float>(sampler.anisotropy)))), F(1));
  size.lod = log2_of(long2 / (size.looks * size.looks)) * F(0.5F) + F(sampler.lod_bias);
  size.u_long = texture_detail::finite_or_zero(select(is_along_x, at.u_dx, at.u_dy));
  size.v_long = texture_detail::finite_or_zero(select(is_along_x, at.v_dx, at.v_dy));
  return size;
}

/// A level of detail between the picture itself, 0, and its smallest level.
template <class F>
LUSTRO_INLINE F limit_lod(const F& lod, std::int32_t level_count) {
  return lane_max(lane_min(lod, to_float(IntOf<F>(level_count - 1))), F(0));
}

/// Where a look at (u, v) finds its texels: the same for all textures of one size that are looked up alike.
template <class F, class Fetch>
Places<F> places_at(const Sampler& sampler, const Fetch& fetch, const F& u, const F& v, const F& lod) {
  using I = IntOf<F>;
  using texture_detail::quad_at;
  const F x = texture_detail::finite_or_zero(u);
  const F y = texture_detail::finite_or_zero(v);
  const bool has_soft_change =
      sampler.magnify == TextureFilter::linear && sampler.minify == TextureFilter::nearest && sampler.mip != MipFilter::none;
  const auto is_magnified = lod <= F(has_soft_change ? 0.5F : 0.0F);  // c of 8.15
  const std::int32_t last = fetch.level_count() - 1;
  const F limited = limit_lod(lod, fetch.level_count());
  Places<F> places{};
  places.blend = F(0);
  switch (sampler.mip) {
    case MipFilter::none:
      places.near = places.far = quad_at(sampler, fetch.level(I(0)), x, y, is_magnified);
      break;
    case MipFilter::nearest: {  // ceil(lod + 1/2) - 1: the larger level where two are as near; the picture itself up to 1/2
      const I level = lane_max(truncate(-floor_of(-(limited + F(0.5F)))) - I(1), I(0));
      places.near = places.far = quad_at(sampler, fetch.level(select(is_magnified, I(0), level)), x, y, is_magnified);
      break;
    }
    case MipFilter::linear: {
      const F whole = floor_of(select(is_magnified, F(0), limited));
      const I level = truncate(whole);
      places.near = quad_at(sampler, fetch.level(level), x, y, is_magnified);
      places.blend = select(is_magnified, F(0), limited - whole);
      places.far = places.near;
      if (any_of(places.blend > F(0))) {
        places.far = quad_at(sampler, fetch.level(lane_min(level + I(1), I(last))), x, y, is_magnified);
      }
      break;
    }
  }
  return places;
}

/// The blended value of the texels at `places`, in the texture's own numbers (TextureLayout::scale).
///
/// AnyPlaces  Places<F>, or the same with other quads that the Fetch knows
template <class F, class Fetch, class AnyPlaces>
LUSTRO_INLINE Texel<F> fetch_places(const Sampler& sampler, const Fetch& fetch, const AnyPlaces& places) {
  const bool has_border = sampler.wrap_u == Wrap::clamp_to_border || sampler.wrap_v == Wrap::clamp_to_border;
  const auto look = [&](const auto& quad) __attribute__((always_inline)) {
    Texel<F> texel = fetch.quad(quad);
    if (has_border) {
      for (std::size_t c = 0; c < 4; ++c) {
        texel[c] = blend(F(sampler.border[c] * fetch.unit()), texel[c], quad.inside);
      }
    }
    return texel;
  };
  Texel<F> result = look(places.near);
  if (any_of(places.blend > F(0))) {
    const Texel<F> far = look(places.far);
    for (std::size_t c = 0; c < 4; ++c) {
      result[c] = blend(result[c], far[c], places.blend);
    }
  }
  return result;
}

/// The texture's value over a footprint, RGBA.
///
/// Fetch  reads one texture:
///   std::int32_t level_count() const
///   LevelPlace<F> level(const IntOf<F>& number) const      a number of 0 .. level_count - 1 a lane
///   Texel<F> quad(const TexelQuad<F>& quad) const          blend_quad() of the four texels' numbers, channel by channel
///   float unit() const                                     the number that stands for 1
///   float scale() const                                    its inverse
template <class F, class Fetch>
Texel<F> sample(const Sampler& sampler, const Fetch& fetch, float width, float height, const Footprint<F>& at) {
  const FootprintSize<F> size = size_of_footprint(sampler, width, height, at);
  Texel<F> sum = {F(0), F(0), F(0), F(0)};
  if (sampler.anisotropy <= 1) {
    sum = fetch_places<F>(sampler, fetch, places_at(sampler, fetch, at.u, at.v, size.lod));
  } else {
    for (float look = 1; any_of(F(look) <= size.looks); look += 1) {
      const F along = F(look) / (size.looks + F(1)) - F(0.5F);
      const Texel<F> texel =
          fetch_places<F>(sampler, fetch, places_at(sampler, fetch, at.u + size.u_long * along, at.v + size.v_long * along, size.lod));
      for (std::size_t c = 0; c < 4; ++c) {
        sum[c] = sum[c] + select(F(look) <= size.looks, texel[c], F(0));
      }
    }
    for (F& channel : sum) {
      channel = channel / size.looks;
    }
  }
  for (F& channel : sum) {
    channel = channel * F(fetch.scale());
  }
  return sum;
}

/// Reads one texel after the other: the reference's way.
class TexelReader {
 public:
  explicit TexelReader(const TextureLayout& layout) : layout_(layout) {}

  [[nodiscard]] std::int32_t level_count() const { return layout_.level_count; }
  [[nodiscard]] LevelPlace<float> level(std::int32_t number) const {
    const TextureLevel& level = layout_.levels[number];
    return {level.width, level.height, level.row, level.first};
  }
  [[nodiscard]] Texel<float> quad(const TexelQuad<float>& quad) const {
    Texel<float> result{};
    for (std::size_t c = 0; c < 4; ++c) {
      result[c] =
          blend_quad(number(quad.upper, c), number(quad.upper + 1, c), number(quad.lower, c), number(quad.lower + 1, c), quad.across, quad.down);
    }
    return result;
  }
  [[nodiscard]] float unit() const { return layout_.unit; }
  [[nodiscard]] float scale() const { return layout_.scale; }

 private:
  [[nodiscard]] float number(std::int32_t place, std::size_t channel) const {
    const std::size_t i = std::size_t{4} * static_cast<std::size_t>(place) + channel;
    if (layout_.bytes != nullptr) {
      return static_cast<float>(layout_.bytes[i]);
    }
    return layout_.unorms != nullptr ? static_cast<float>(layout_.unorms[i]) : layout_.floats[i];
  }

  TextureLayout layout_;
};

}  // namespace lustro
