// A sampler in double precision, written from the OpenGL 4.6 specification, 8.14 and 8.15, and from EXT_texture_filter_anisotropic: what
// look-ups are held against. It shares nothing with them but the texels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "texture/sample.hpp"

namespace lustro {

using Rgba = std::array<double, 4>;

/// The specification's sampler. `margin` becomes the distance to the nearest place where a choice (of a texel, of a level) changes.
class SamplerOracle {
 public:
  SamplerOracle(const Texture& texture, const Sampler& sampler) : texture_(texture), sampler_(sampler) {}

  Rgba sample(const Footprint<double>& at) {
    const double px = std::hypot(at.u_dx * texture_.width(), at.v_dx * texture_.height());
    const double py = std::hypot(at.u_dy * texture_.width(), at.v_dy * texture_.height());
    const double longest = std::max(px, py);
    if (sampler_.anisotropy == 1) {
      return look(at.u, at.v, std::log2(longest) + static_cast<double>(sampler_.lod_bias));
    }
    const double ratio = longest / std::max(std::min(px, py), 1.0);  // see sample.hpp: the short axis counts as a texel
    const double looks = std::max(1.0, std::ceil(std::min(ratio, static_cast<double>(sampler_.anisotropy))));
    if (ratio < sampler_.anisotropy) {
      choose(ratio);
    }
    choose(px > py ? (px - py) * 1e-2 : (py - px) * 1e-2);
    Rgba sum{};
    for (int i = 1; i <= static_cast<int>(looks); ++i) {
      const double along = i / (looks + 1) - 0.5;
      const double lambda = std::log2(longest / looks) + static_cast<double>(sampler_.lod_bias);
      const Rgba value =
          px > py ? look(at.u + at.u_dx * along, at.v + at.v_dx * along, lambda) : look(at.u + at.u_dy * along, at.v + at.v_dy * along, lambda);
      for (std::size_t c = 0; c < 4; ++c) {
        sum[c] += value[c] / looks;
      }
    }
    return sum;
  }

  double margin = 1;

 private:
  // A value whose integer part decides.
  void choose(double x) { margin = std::min(margin, std::abs(x - std::round(x))); }

  // Table 8.19 with the functions below it.
  static int wrapped(Wrap wrap, long long i, int size) {
    const auto mod = [](long long a, long long n) { return ((a % n) + n) % n; };
    const auto mirror = [](long long a) { return a >= 0 ? a : -(1 + a); };
    switch (wrap) {
      case Wrap::repeat:
        return static_cast<int>(mod(i, size));
      case Wrap::mirrored_repeat:
        return static_cast<int>((size - 1) - mirror(mod(i, 2LL * size) - size));
      case Wrap::clamp_to_edge:
        return static_cast<int>(std::clamp<long long>(i, 0, size - 1));
      case Wrap::clamp_to_border:
        break;
    }
    return static_cast<int>(std::clamp<long long>(i, -1, size));
  }

  [[nodiscard]] Rgba texel(std::size_t level, long long i, long long j) const {
    const TextureLevel& l = texture_.levels()[level];
    const int x = wrapped(sampler_.wrap_u, i, l.width);
    const int y = wrapped(sampler_.wrap_v, j, l.height);
    Rgba result{};
    for (std::size_t c = 0; c < 4; ++c) {
      const bool is_border = x < 0 || y < 0 || x >= l.width || y >= l.height;
      result[c] = static_cast<double>(is_border ? sampler_.border[c] : texture_.texel(level, x, y)[c]);
    }
    return result;
  }

  Rgba look_at_level(std::size_t level, TextureFilter filter, double s, double t) {
    const double u = s * texture_.levels()[level].width;
    const double v = t * texture_.levels()[level].height;
    if (filter == TextureFilter::nearest) {
      choose(u);
      choose(v);
      return texel(level, static_cast<long long>(std::floor(u)), static_cast<long long>(std::floor(v)));
    }
    if (!sampler_.blend_u) {
      choose(u);
    }
    if (!sampler_.blend_v) {
      choose(v);
    }
    const auto i = static_cast<long long>(std::floor(sampler_.blend_u ? u - 0.5 : u));
    const auto j = static_cast<long long>(std::floor(sampler_.blend_v ? v - 0.5 : v));
    const double a = sampler_.blend_u ? u - 0.5 - std::floor(u - 0.5) : 0;
    const double b = sampler_.blend_v ? v - 0.5 - std::floor(v - 0.5) : 0;
    Rgba result{};
    for (std::size_t c = 0; c < 4; ++c) {
      result[c] = (1 - a) * (1 - b) * texel(level, i, j)[c] + a * (1 - b) * texel(level, i + 1, j)[c] + (1 - a) * b * texel(level, i, j + 1)[c] +
                  a * b * texel(level, i + 1, j + 1)[c];
    }
    return result;
  }

  Rgba look(double s, double t, double lambda) {
    const bool is_soft =
        sampler_.magnify == TextureFilter::linear && sampler_.minify == TextureFilter::nearest && sampler_.mip != MipFilter::none;
    const double c = is_soft ? 0.5 : 0;
    if (sampler_.magnify != sampler_.minify) {
      margin = std::min(margin, std::abs(lambda - c));
    }
    if (lambda <= c) {
      return look_at_level(0, sampler_.magnify, s, t);
    }
    const double q = static_cast<double>(texture_.levels().size()) - 1;
    if (sampler_.mip == MipFilter::none) {
      return look_at_level(0, sampler_.minify, s, t);
    }
    if (sampler_.mip == MipFilter::nearest) {
      choose(lambda + 0.5);
      const double d = lambda <= 0.5 ? 0 : (lambda <= q + 0.5 ? std::ceil(lambda + 0.5) - 1 : q);
      return look_at_level(static_cast<std::size_t>(d), sampler_.minify, s, t);
    }
    if (is_soft) {
      choose(lambda);  // for it starts at 1/2
    }
    const double d1 = lambda >= q ? q : std::floor(lambda);
    const double d2 = lambda >= q ? q : d1 + 1;
    const double f = lambda - std::floor(lambda);
    const Rgba near = look_at_level(static_cast<std::size_t>(d1), sampler_.minify, s, t);
    const Rgba far = look_at_level(static_cast<std::size_t>(d2), sampler_.minify, s, t);
    Rgba result{};
    for (std::size_t i = 0; i < 4; ++i) {
      result[i] = (1 - f) * near[i] + f * far[i];
    }
    return result;
  }

  const Texture& texture_;
  const Sampler& sampler_;
};

}  // namespace lustro
