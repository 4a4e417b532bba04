// Tone mapping: from linear light of any brightness to what a picture can store, 0..1, still linear. F is a lane type: the kernels that store
// bytes do the same as image/store.cpp. After it comes the transfer.
//
//   c = 2^exposure c
//   none       c
//   reinhard   c / (1 + L), L = 0.2126 r + 0.7152 g + 0.0722 b    Reinhard, Stark, Shirley and Ferwerda 2002, equation 3, without its key
//   aces       the fit by Stephen Hill (MJP's BakingLab, ACES.hlsl) to ACES 1.0: the reference rendering transform and the output transform for
//              100 nit sRGB displays; both of his matrices, and between them (v (v + 0.0245786) - 0.000090537) /
//              (v (0.983729 v + 0.4329510) + 0.238081)
//   agx        Troy Sobotka's AgX with its default contrast, by Benjamin Wrensch's polynomial of degree 6 ("Minimal AgX implementation"): log2
//              over -12.47393..4.026069 stops; its result is encoded with a power of 2.2, which is taken back here
#pragma once

#include <array>

#include "lustro/image.hpp"
#include "lustro/vec.hpp"
#include "math/power.hpp"

namespace lustro {

/// A tone, ready for use. The same for all lanes.
struct Toning {
  ToneOperator curve = ToneOperator::none;
  float gain = 1;

  Toning() = default;
  explicit Toning(const Tone& tone) : curve(tone.curve), gain(exp2_of(tone.exposure)) {}
  /// false: every colour stays as it is.
  [[nodiscard]] bool changes() const { return curve != ToneOperator::none || gain != 1; }
};

template <class F>
LUSTRO_INLINE Vec3<F> times_rows(const std::array<float, 9>& m, const Vec3<F>& v) {
  const auto row = [&](std::size_t i) { return (F(m[i]) * v.x + F(m[i + 1]) * v.y) + F(m[i + 2]) * v.z; };
  return {row(0), row(3), row(6)};
}

template <class F>
LUSTRO_INLINE Vec3<F> tone_reinhard(const Vec3<F>& c) {
  const F luminance = (F(0.2126F) * c.x + F(0.7152F) * c.y) + F(0.0722F) * c.z;
  return c * (F(1) / (F(1) + lane_max(luminance, F(0))));
}

template <class F>
LUSTRO_INLINE Vec3<F> tone_aces(const Vec3<F>& c) {
  constexpr std::array<float, 9> kIn{0.59719F, 0.35458F, 0.04823F, 0.07600F, 0.90834F, 0.01566F, 0.02840F, 0.13383F, 0.83777F};
  constexpr std::array<float, 9> kOut{1.60475F, -0.53108F, -0.07367F, -0.10208F, 1.10813F, -0.00605F, -0.00327F, -0.07276F, 1.07602F};
  const Vec3<F> v = times_rows(kIn, c);
  const auto fit = [](const F& stated) {
    const F x = lane_min(stated, F(1e15F));  // whose square is still a number
    return (x * (x + F(0.0245786F)) - F(0.000090537F)) / (x * (F(0.983729F) * x + F(0.4329510F)) + F(0.238081F));
  };
  return times_rows(kOut, Vec3<F>{fit(v.x), fit(v.y), fit(v.z)});
}

template <class F>
LUSTRO_INLINE Vec3<F> tone_agx(const Vec3<F>& c) {
  constexpr std::array<float, 9> kIn{0.842479062253094F,  0.0784335999999992F, 0.0792237451477643F, 0.0423282422610123F, 0.878468636469772F,
                                     0.0791661274605434F, 0.0423756549057051F, 0.0784336F,          0.879142973793104F};
  constexpr std::array<float, 9> kOut{1.19687900512017F,    -0.0980208811401368F, -0.0990297440797205F, -0.0528968517574562F, 1.15190312990417F,
                                      -0.0989611768448433F, -0.0529716355144438F, -0.0980434501171241F, 1.15107367264116F};
  constexpr float kLeast = -12.47393F;
  constexpr float kMost = 4.026069F;
  const auto contrast = [](const F& light) {
    const F stops = log2_of(lane_max(light, F(1e-30F)));
    const F x = (lane_min(lane_max(stops, F(kLeast)), F(kMost)) - F(kLeast)) * F(1 / (kMost - kLeast));
    const F x2 = x * x;
    const F x4 = x2 * x2;
    return (((((F(15.5F) * (x4 * x2) - F(40.14F) * (x4 * x)) + F(31.96F) * x4) - F(6.868F) * (x2 * x)) + F(0.4298F) * x2) + F(0.1191F) * x) -
           F(0.00232F);
  };
  const Vec3<F> v = times_rows(kIn, c);
  const Vec3<F> encoded = times_rows(kOut, Vec3<F>{contrast(v.x), contrast(v.y), contrast(v.z)});
  const Exponent exponent(2.2F);
  return {power(encoded.x, exponent), power(encoded.y, exponent), power(encoded.z, exponent)};
}

/// A linear colour, not premultiplied. What comes out may lie outside 0..1, as it does with `none`.
template <class F>
LUSTRO_INLINE Vec3<F> toned(const Toning& toning, const Vec3<F>& color) {
  const Vec3<F> c = color * F(toning.gain);
  switch (toning.curve) {
    case ToneOperator::reinhard:
      return tone_reinhard(c);
    case ToneOperator::aces:
      return tone_aces(c);
    case ToneOperator::agx:
      return tone_agx(c);
    case ToneOperator::none:
      break;
  }
  return c;
}

}  // namespace lustro
