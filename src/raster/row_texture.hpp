// How a row reads texels (texture/sample.hpp: Fetch), and what a strip of fragments looks up. Part of a row (row.cpp).
#pragma once

#include "shade/texturing.hpp"
#include "simd/lanes.hpp"
#include "texture/texture.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// Reads the texels of kLanes places of a texture of bytes.
class ByteFetch {
 public:
  HWY_INLINE explicit ByteFetch(const TextureLayout& layout) : layout_(layout) {}

  /// A quad in one block a lane: the upper pair and the lower one.
  [[nodiscard]] HWY_INLINE Texel<Float> quad(const TexelQuad<Float>& quad) const {
    alignas(64) std::array<std::int32_t, kLanes> upper, lower;
    store(upper.data(), quad.upper);
    store(lower.data(), quad.lower);
    const auto texel = [&](std::int32_t place) {
      return reinterpret_cast<const std::int32_t*>(layout_.bytes + std::size_t{4} * static_cast<std::size_t>(place));
    };
    hn::Vec<IntTag> words[4];
    load_pairs([&](std::size_t i) { return texel(upper[i]); }, [&](std::size_t i) { return texel(lower[i]); }, words);
    Texel<Float> result;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto channel = [&](std::size_t w) { return to_float((Int(words[w]) >> static_cast<int>(8 * c)) & Int(0xFF)); };
      result[c] = blend_quad(channel(0), channel(1), channel(2), channel(3), quad.across, quad.down);
    }
    return result;
  }
  [[nodiscard]] HWY_INLINE float unit() const { return layout_.unit; }
  [[nodiscard]] HWY_INLINE float scale() const { return layout_.scale; }

 private:
  TextureLayout layout_;
};

/// Reads the texels of kLanes places, of whatever numbers: the pair of a row by 16 bytes a lane.
class LaneFetch {
 public:
  HWY_INLINE explicit LaneFetch(const TextureLayout& layout) : layout_(layout) {}

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
  [[nodiscard]] HWY_INLINE Texel<Float> quad(const TexelQuad<Float>& quad) const {
    if (layout_.bytes != nullptr) {
      return ByteFetch(layout_).quad(quad);
    }
    const Pair upper = pair_at(quad.upper);
    const Pair lower = pair_at(quad.lower);
    Texel<Float> result;
    for (std::size_t c = 0; c < 4; ++c) {
      result[c] = blend_quad(upper.left[c], upper.right[c], lower.left[c], lower.right[c], quad.across, quad.down);
    }
    return result;
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
