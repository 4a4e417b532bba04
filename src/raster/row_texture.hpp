// How a row reads texels (texture/sample.hpp: Fetch), and what a strip of fragments looks up. Part of a row (row.cpp).
#pragma once

#include <type_traits>

#include "shade/texturing.hpp"
#include "simd/lanes.hpp"
#include "texture/texture.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// TexelQuad whose places lie in memory, where lanes read them one by one.
struct StoredQuad {
  const std::int32_t* upper;
  const std::int32_t* lower;
  Float across, down, inside;
};

/// Reads the texels of kLanes places of a texture of bytes.
template <bool kIsGray>
class ByteFetch {
 public:
  HWY_INLINE explicit ByteFetch(const TextureLayout& layout) : layout_(layout) {}

  [[nodiscard]] HWY_INLINE Texel<Float> quad(const StoredQuad& quad) const {
    const auto texel = [&](std::int32_t place) {
      return reinterpret_cast<const std::int32_t*>(layout_.bytes + std::size_t{4} * static_cast<std::size_t>(place));
    };
    std::array<Int, 4> words;
    load_pairs([&](std::size_t i) { return texel(quad.upper[i]); }, words[0], words[1]);
    load_pairs([&](std::size_t i) { return texel(quad.lower[i]); }, words[2], words[3]);
    const auto blended = [&](auto channel) __attribute__((always_inline)) {
      const auto of = [&](std::size_t corner) __attribute__((always_inline)) {
        return to_float(byte_of<channel>(words[corner]));
      };
      return blend_quad(of(0), of(1), of(2), of(3), quad.across, quad.down);
    };
    using std::integral_constant;
    const Float red = blended(integral_constant<std::size_t, 0>());
    const Float alpha = blended(integral_constant<std::size_t, 3>());
    if constexpr (kIsGray) {
      return {red, red, red, alpha};
    }
    return {red, blended(integral_constant<std::size_t, 1>()), blended(integral_constant<std::size_t, 2>()), alpha};
  }
  [[nodiscard]] HWY_INLINE Texel<Float> quad(const TexelQuad<Float>& quad) const {
    alignas(64) std::array<std::int32_t, kLanes> upper, lower;
    store(upper.data(), quad.upper);
    store(lower.data(), quad.lower);
    return this->quad(StoredQuad{upper.data(), lower.data(), quad.across, quad.down, quad.inside});
  }
  [[nodiscard]] HWY_INLINE float unit() const { return layout_.unit; }
  [[nodiscard]] HWY_INLINE float scale() const { return layout_.scale; }

 private:
  TextureLayout layout_;
};

/// Reads the texels of kLanes places, of whatever numbers: the pair of a row by 16 bytes a lane.
template <bool kIsGray>
class AnyFetch {
 public:
  HWY_INLINE explicit AnyFetch(const TextureLayout& layout) : layout_(layout) {}

  [[nodiscard]] HWY_INLINE std::int32_t level_count() const { return layout_.level_count; }
  [[nodiscard]] HWY_INLINE LevelPlace<Float> level(Int number) const {
    alignas(64) std::array<std::int32_t, kLanes> numbers;
    store(numbers.data(), number);
    if (HWY_LIKELY(all_of(number == Int(numbers[0])))) {
      const TextureLevel& level = layout_.levels[numbers[0]];
      return {Int(level.width), Int(level.height), Int(level.row), Int(level.first)};
    }
    hn::Vec<IntTag> words[4];
    load_quads([&](std::size_t i) { return &layout_.levels[numbers[i]].width; }, words);
    return {Int(words[0]), Int(words[1]), Int(words[2]), Int(words[3])};
  }
  [[nodiscard]] HWY_INLINE Texel<Float> quad(const StoredQuad& quad) const {
    return this->quad(TexelQuad<Float>{load(quad.upper), load(quad.lower), quad.across, quad.down, quad.inside});
  }
  [[nodiscard]] HWY_INLINE Texel<Float> quad(const TexelQuad<Float>& quad) const {
    if (layout_.bytes != nullptr) {
      return ByteFetch<kIsGray>(layout_).quad(quad);
    }
    const Pair upper = pair_at(quad.upper);
    const Pair lower = pair_at(quad.lower);
    const auto blended = [&](std::size_t c) __attribute__((always_inline)) {
      return blend_quad(upper.left[c], upper.right[c], lower.left[c], lower.right[c], quad.across, quad.down);
    };
    const Float red = blended(0);
    if constexpr (kIsGray) {
      return {red, red, red, blended(3)};
    }
    return {red, blended(1), blended(2), blended(3)};
  }
  [[nodiscard]] HWY_INLINE float unit() const { return layout_.unit; }
  [[nodiscard]] HWY_INLINE float scale() const { return layout_.scale; }

 private:
  /// Two texels side by side.
  struct Pair {
    Texel<Float> left, right;
  };
  [[nodiscard]] HWY_INLINE Pair pair_at(Int place) const {
    alignas(64) std::array<std::int32_t, kLanes> places;
    store(places.data(), place);
    hn::Vec<IntTag> words[4];
    Pair pair;
    if (HWY_LIKELY(layout_.unorms != nullptr)) {
      load_quads([&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(layout_.unorms + std::size_t{4} * number(places[i])); },
                 words);
      const auto low = [&](std::size_t w) { return to_float(Int(words[w]) & Int(0xFFFF)); };
      const auto high = [&](std::size_t w) { return to_float((Int(words[w]) >> 16) & Int(0xFFFF)); };
      pair.left = {low(0), high(0), low(1), high(1)};
      pair.right = {low(2), high(2), low(3), high(3)};
      return pair;
    }
    const auto load_floats = [&](std::size_t right, Texel<Float>& texel) {
      load_quads(
          [&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(layout_.floats + std::size_t{4} * (number(places[i]) + right)); },
          words);
      texel = {from_bits(words[0]), from_bits(words[1]), from_bits(words[2]), from_bits(words[3])};
    };
    load_floats(0, pair.left);
    load_floats(1, pair.right);
    return pair;
  }
  static std::size_t number(std::int32_t place) { return static_cast<std::size_t>(place); }

  TextureLayout layout_;
};

using LaneFetch = AnyFetch<false>;

/// The levels of a texture for a strip of places: where a vector holds a word of all of them, lanes choose theirs by a shuffle.
class LevelTable {
 public:
  HWY_INLINE explicit LevelTable(const TextureLayout& layout) : layout_(layout), fits_(layout.level_count <= static_cast<std::int32_t>(kLanes)) {
    if (fits_) {
      const auto last = static_cast<std::size_t>(layout.level_count - 1);
      hn::Vec<IntTag> words[4];
      load_quads([&](std::size_t i) { return &layout.levels[i < last ? i : last].width; }, words);
      for (std::size_t word = 0; word < 4; ++word) {
        store(words_[word].data(), Int(words[word]));
      }
    }
  }
  [[nodiscard]] HWY_INLINE std::int32_t level_count() const { return layout_.level_count; }
  [[nodiscard]] HWY_INLINE LevelPlace<Float> level(Int number) const {
    if (HWY_LIKELY(fits_)) {
      const LaneChoice lanes(number);
      return {lanes(words_[0].data()), lanes(words_[1].data()), lanes(words_[2].data()), lanes(words_[3].data())};
    }
    return LaneFetch(layout_).level(number);
  }

 private:
  const TextureLayout& layout_;
  bool fits_;
  alignas(64) std::array<std::array<std::int32_t, kLanes>, 4> words_;
};

/// Has a texel come nearer; its value is not waited for.
HWY_INLINE void call_texel(const TextureLayout& layout, std::int32_t place) {
  const std::size_t i = std::size_t{4} * static_cast<std::size_t>(place);
  const void* texel = layout.floats + i;
  if (layout.bytes != nullptr) {
    texel = layout.bytes + i;
  } else if (layout.unorms != nullptr) {
    texel = layout.unorms + i;
  }
  __builtin_prefetch(texel);
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
