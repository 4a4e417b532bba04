// N floats that calculate like one: a thin type over Google Highway's vectors, with the names of math/lane.hpp, so that the lighting equation
// reads as mathematics and is compiled for every instruction set. Only operations that IEEE 754 defines to the last bit stand here: no fused
// multiply-add, no estimate, no minimum or maximum whose answer to NaN differs between machines.
//
// Included by the sources of a row only (raster/row.cpp), which are compiled once an instruction set, with its compiler flags; everything lies
// in a namespace that bears its name.
#pragma once

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lustro/vec.hpp"
#include "math/lane.hpp"

namespace lustro::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::RebindToSigned<FloatTag>;
using UintTag = hn::RebindToUnsigned<FloatTag>;

inline constexpr std::size_t kLanes = HWY_LANES(float);
inline constexpr FloatTag kFloats{};
inline constexpr IntTag kInts{};
inline constexpr UintTag kUints{};

using lustro::lane_max;  // the templates, beside the overloads below
using lustro::lane_min;

// clang-format off
struct Mask {
  hn::Mask<FloatTag> m;
  Mask(hn::Mask<FloatTag> m_) : m(m_) {}  // NOLINT(google-explicit-constructor)
};
HWY_INLINE Mask operator&(Mask a, Mask b) { return hn::And(a.m, b.m); }
HWY_INLINE Mask operator|(Mask a, Mask b) { return hn::Or(a.m, b.m); }
HWY_INLINE Mask operator!(Mask a) { return hn::Not(a.m); }
HWY_INLINE bool any_of(Mask a) { return !hn::AllFalse(kFloats, a.m); }
HWY_INLINE bool all_of(Mask a) { return hn::AllTrue(kFloats, a.m); }

struct Float {
  hn::Vec<FloatTag> v;
  HWY_INLINE Float() : v(hn::Zero(kFloats)) {}
  HWY_INLINE Float(float x) : v(hn::Set(kFloats, x)) {}  // NOLINT(google-explicit-constructor)
  HWY_INLINE Float(hn::Vec<FloatTag> v_) : v(v_) {}      // NOLINT(google-explicit-constructor)
};
HWY_INLINE Float operator+(Float a, Float b) { return hn::Add(a.v, b.v); }
HWY_INLINE Float operator-(Float a, Float b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Float operator*(Float a, Float b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Float operator/(Float a, Float b) { return hn::Div(a.v, b.v); }
HWY_INLINE Float operator-(Float a) { return hn::Neg(a.v); }
HWY_INLINE Mask operator<(Float a, Float b) { return hn::Lt(a.v, b.v); }
HWY_INLINE Mask operator>(Float a, Float b) { return hn::Gt(a.v, b.v); }
HWY_INLINE Mask operator<=(Float a, Float b) { return hn::Le(a.v, b.v); }
HWY_INLINE Mask operator>=(Float a, Float b) { return hn::Ge(a.v, b.v); }
HWY_INLINE Mask operator==(Float a, Float b) { return hn::Eq(a.v, b.v); }
HWY_INLINE Float select(Mask m, Float a, Float b) { return hn::IfThenElse(m.m, a.v, b.v); }
#if HWY_TARGET == HWY_SCALAR
#elif HWY_ARCH_X86  // maxps and minps are these comparisons in one instruction: the second operand where either is NaN or both are zeros
HWY_INLINE Float lane_max(Float a, Float b) { return hn::Max(a.v, b.v); }
HWY_INLINE Float lane_min(Float a, Float b) { return hn::Min(a.v, b.v); }
#elif HWY_ARCH_WASM  // pmax(x, y) = x < y ? y : x
HWY_INLINE Float lane_max(Float a, Float b) { return hn::Vec<FloatTag>{wasm_f32x4_pmax(b.v.raw, a.v.raw)}; }
HWY_INLINE Float lane_min(Float a, Float b) { return hn::Vec<FloatTag>{wasm_f32x4_pmin(b.v.raw, a.v.raw)}; }
#endif
HWY_INLINE Float square_root(Float a) { return hn::Sqrt(a.v); }
HWY_INLINE Float sqrt(Float a) { return hn::Sqrt(a.v); }

struct Int {
  hn::Vec<IntTag> v;
  HWY_INLINE Int() : v(hn::Zero(kInts)) {}
  HWY_INLINE Int(std::int32_t x) : v(hn::Set(kInts, x)) {}  // NOLINT(google-explicit-constructor)
  HWY_INLINE Int(hn::Vec<IntTag> v_) : v(v_) {}             // NOLINT(google-explicit-constructor)
};
HWY_INLINE Int operator+(Int a, Int b) { return hn::Add(a.v, b.v); }
HWY_INLINE Int operator-(Int a, Int b) { return hn::Sub(a.v, b.v); }
HWY_INLINE Int operator*(Int a, Int b) { return hn::Mul(a.v, b.v); }
HWY_INLINE Int operator&(Int a, Int b) { return hn::And(a.v, b.v); }
HWY_INLINE Int operator|(Int a, Int b) { return hn::Or(a.v, b.v); }
HWY_INLINE Int operator<<(Int a, int bits) { return hn::ShiftLeftSame(a.v, bits); }
HWY_INLINE Int operator>>(Int a, int bits) { return hn::ShiftRightSame(a.v, bits); }
HWY_INLINE Mask operator<(Int a, Int b) { return hn::RebindMask(kFloats, hn::Lt(a.v, b.v)); }
HWY_INLINE Mask operator>(Int a, Int b) { return hn::RebindMask(kFloats, hn::Gt(a.v, b.v)); }
HWY_INLINE Mask operator==(Int a, Int b) { return hn::RebindMask(kFloats, hn::Eq(a.v, b.v)); }
HWY_INLINE Int select(Mask m, Int a, Int b) { return hn::IfThenElse(hn::RebindMask(kInts, m.m), a.v, b.v); }
HWY_INLINE Int lane_min(Int a, Int b) { return hn::Min(a.v, b.v); }
HWY_INLINE Int lane_max(Int a, Int b) { return hn::Max(a.v, b.v); }

HWY_INLINE Int bits_of(Float a) { return hn::BitCast(kInts, a.v); }
HWY_INLINE Float from_bits(Int a) { return hn::BitCast(kFloats, a.v); }
HWY_INLINE Float to_float(Int a) { return hn::ConvertTo(kFloats, a.v); }
/// Of what fits 32 bits. (On x86, Highway repairs what does not by four instructions more.)
#if HWY_TARGET == HWY_SSE4
HWY_INLINE Int truncate(Float a) { return hn::Vec<IntTag>{_mm_cvttps_epi32(a.v.raw)}; }
#elif HWY_TARGET == HWY_AVX2
HWY_INLINE Int truncate(Float a) { return hn::Vec<IntTag>{_mm256_cvttps_epi32(a.v.raw)}; }
#elif HWY_TARGET == HWY_AVX3
HWY_INLINE Int truncate(Float a) { return hn::Vec<IntTag>{_mm512_cvttps_epi32(a.v.raw)}; }
#else
HWY_INLINE Int truncate(Float a) { return hn::ConvertTo(kInts, a.v); }
#endif
HWY_INLINE Float floor_of(Float a) { return hn::Floor(a.v); }

HWY_INLINE Float load(const float* p) { return hn::LoadU(kFloats, p); }
HWY_INLINE Int load(const std::int32_t* p) { return hn::LoadU(kInts, p); }
HWY_INLINE Int load(const std::uint32_t* p) { return hn::BitCast(kInts, hn::LoadU(kUints, p)); }
HWY_INLINE void store(float* p, Float a) { hn::StoreU(a.v, kFloats, p); }
HWY_INLINE void store(std::int32_t* p, Int a) { hn::StoreU(a.v, kInts, p); }
HWY_INLINE void store(std::uint32_t* p, Int a) { hn::StoreU(hn::BitCast(kUints, a.v), kUints, p); }
HWY_INLINE void store_where(Mask m, float* p, Float a) { hn::BlendedStore(a.v, m.m, kFloats, p); }
HWY_INLINE void store_where(Mask m, std::uint32_t* p, Int a) { hn::BlendedStore(hn::BitCast(kUints, a.v), hn::RebindMask(kUints, m.m), kUints, p); }

/// p[index] of every lane.
HWY_INLINE Float gather(const float* p, Int index) { return hn::GatherIndex(kFloats, p, index.v); }
HWY_INLINE Int gather(const std::int32_t* p, Int index) { return hn::GatherIndex(kInts, p, index.v); }
HWY_INLINE Int gather(const std::uint32_t* p, Int index) { return hn::GatherIndex(kInts, reinterpret_cast<const std::int32_t*>(p), index.v); }
/// The lanes of a mask as bits, the first the lowest.
HWY_INLINE std::uint32_t mask_bits(Mask m) {
#if HWY_TARGET == HWY_SSE4
  return static_cast<std::uint32_t>(_mm_movemask_ps(m.m.raw));
#elif HWY_TARGET == HWY_AVX2
  return static_cast<std::uint32_t>(_mm256_movemask_ps(m.m.raw));
#elif HWY_TARGET == HWY_AVX3
  return m.m.raw;
#elif HWY_TARGET == HWY_WASM
  return wasm_i32x4_bitmask(m.m.raw);
#else
  alignas(8) std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(kFloats, m.m, bytes);
  return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8;
#endif
}
HWY_INLINE std::size_t count_true(Mask m) { return static_cast<std::size_t>(__builtin_popcount(mask_bits(m))); }
/// Of every mask of eight lanes: how many are set before each, a byte a lane.
inline constexpr auto kCountsBefore = [] {
  std::array<std::uint64_t, 256> result{};
  for (std::uint32_t mask = 0; mask < 256; ++mask) {
    for (std::uint32_t lane = 0, count = 0; lane < 8; ++lane) {
      result[mask] |= std::uint64_t{count} << 8 * lane;
      count += mask >> lane & 1;
    }
  }
  return result;
}();
/// How many lanes are set before each.
HWY_INLINE Int counts_before([[maybe_unused]] std::uint32_t bits) {
#if HWY_TARGET == HWY_SCALAR
  return {0};
#else
  const hn::Rebind<std::uint8_t, IntTag> bytes;
  if constexpr (kLanes <= 8) {
    return hn::PromoteTo(kInts, hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(&kCountsBefore[bits & 0xFF])));
  }
  constexpr std::uint64_t kEach = 0x0101010101010101;
  const std::array<std::uint64_t, 2> counts{kCountsBefore[bits & 0xFF], kCountsBefore[bits >> 8 & 0xFF] + static_cast<std::uint64_t>(__builtin_popcount(bits & 0xFF)) * kEach};
  return hn::PromoteTo(kInts, hn::LoadU(bytes, reinterpret_cast<const std::uint8_t*>(counts.data())));
#endif
}
/// The lanes of a mask, one after the other; kLanes entries are written. (Some processors need a hundred cycles to store fewer.)
#if HWY_TARGET == HWY_AVX2  // GCC copies the table of Highway's own Compress to the stack at every call
/// Of every mask of eight lanes: the chosen lanes' numbers, four bits each, the first the lowest.
inline constexpr auto kChosenLanes = [] {
  std::array<std::uint32_t, 256> result{};
  for (std::uint32_t mask = 0; mask < 256; ++mask) {
    for (std::uint32_t lane = 0, count = 0; lane < 8; ++lane) {
      result[mask] |= (mask >> lane & 1) != 0 ? lane << 4 * count++ : 0;
    }
  }
  return result;
}();
HWY_INLINE void store_chosen(Mask m, std::int32_t* p, Int a) {
  const auto fours = hn::ShiftLeft<2>(hn::Iota(kUints, 0));
  const auto lanes = hn::And(hn::Shr(hn::Set(kUints, kChosenLanes[mask_bits(m)]), fours), hn::Set(kUints, 7));
  hn::StoreU(hn::TableLookupLanes(a.v, hn::IndicesFromVec(kInts, lanes)), kInts, p);
}
#elif HWY_TARGET == HWY_WASM  // Highway 1.0 looks bytes up one by one
/// Of every mask of four lanes: the bytes of the chosen ones.
alignas(16) inline constexpr auto kChosenBytes = [] {
  std::array<std::array<std::uint8_t, 16>, 16> result{};
  for (std::uint32_t mask = 0; mask < 16; ++mask) {
    for (std::uint32_t lane = 0, count = 0; lane < 4; ++lane) {
      for (std::uint32_t byte = 0; byte < 4 && (mask >> lane & 1) != 0; ++byte) {
        result[mask][count++] = static_cast<std::uint8_t>(4 * lane + byte);
      }
    }
  }
  return result;
}();
HWY_INLINE void store_chosen(Mask m, std::int32_t* p, Int a) {
  wasm_v128_store(p, wasm_i8x16_swizzle(a.v.raw, wasm_v128_load(kChosenBytes[mask_bits(m)].data())));
}
#else
HWY_INLINE void store_chosen(Mask m, std::int32_t* p, Int a) { hn::StoreU(hn::Compress(a.v, hn::RebindMask(kInts, m.m)), kInts, p); }
#endif
HWY_INLINE void store_chosen(Mask m, std::uint32_t* p, Int a) { store_chosen(m, reinterpret_cast<std::int32_t*>(p), a); }

/// 0, 1, 2, ...
HWY_INLINE Int lane_numbers() { return hn::Iota(kInts, 0); }
/// The first `count` lanes.
HWY_INLINE Mask first_lanes(std::size_t count) { return hn::FirstN(kFloats, count); }

/// Room for sixteen vectors, not cleared.
struct Words {
  hn::Vec<IntTag> w[16];
  HWY_INLINE Int operator[](std::size_t i) const { return w[i]; }
};
#if HWY_TARGET != HWY_SCALAR
/// Sixteen bytes of every fourth lane from `lane` on, a block each.
template <class Tag, class At>
HWY_INLINE hn::Vec<Tag> load_blocks(Tag tag, At&& at, std::size_t lane) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(tag, at(lane));
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, load_blocks(half, at, lane + hn::MaxLanes(Tag()) / 2), load_blocks(half, at, lane));
  }
}

/// The same of eight bytes and eight bytes.
template <class Tag, class First, class Second>
HWY_INLINE hn::Vec<Tag> load_blocks(Tag tag, First&& first, Second&& second, std::size_t lane) {
  const hn::Half<Tag> half;
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::Combine(tag, hn::LoadU(half, second(lane)), hn::LoadU(half, first(lane)));
  } else {
    return hn::Combine(tag, load_blocks(half, first, second, lane + hn::MaxLanes(Tag()) / 2), load_blocks(half, first, second, lane));
  }
}
#endif

/// Four words of kLanes structures, transposed: words[w] holds word w of all of them. at(i) is where those of lane i begin. Loads of 16 bytes
/// and shuffles cost less than four gathers on every machine, and on some a fifth.
template <class At>
HWY_INLINE void load_quads(At&& at, hn::Vec<IntTag>* words) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t w = 0; w < 4; ++w) {
    words[w] = Int(at(std::size_t{0})[w]).v;
  }
#else
  const auto row0 = load_blocks(kInts, at, 0), row1 = load_blocks(kInts, at, 1);
  const auto row2 = load_blocks(kInts, at, 2), row3 = load_blocks(kInts, at, 3);
  const hn::Repartition<std::int64_t, IntTag> halves;
  const auto low01 = hn::BitCast(halves, hn::InterleaveLower(kInts, row0, row1));
  const auto low23 = hn::BitCast(halves, hn::InterleaveLower(kInts, row2, row3));
  const auto high01 = hn::BitCast(halves, hn::InterleaveUpper(kInts, row0, row1));
  const auto high23 = hn::BitCast(halves, hn::InterleaveUpper(kInts, row2, row3));
  words[0] = hn::BitCast(kInts, hn::InterleaveLower(halves, low01, low23));
  words[1] = hn::BitCast(kInts, hn::InterleaveUpper(halves, low01, low23));
  words[2] = hn::BitCast(kInts, hn::InterleaveLower(halves, high01, high23));
  words[3] = hn::BitCast(kInts, hn::InterleaveUpper(halves, high01, high23));
#endif
}

/// The opposite: the four words of lane i are stored at out + 4 i.
HWY_INLINE void store_quads(Int a, Int b, Int c, Int d, std::int32_t* out) {
#if HWY_TARGET == HWY_SCALAR
  store(out, a);
  store(out + 1, b);
  store(out + 2, c);
  store(out + 3, d);
#else
  hn::StoreInterleaved4(a.v, b.v, c.v, d.v, kInts, out);
#endif
}

#if HWY_TARGET != HWY_SCALAR
/// Of each block of four words: 0 and 2 of a, then of b.
HWY_INLINE Int even_words(Float a, Float b) {
#if HWY_TARGET == HWY_AVX3
  return bits_of(hn::Vec<FloatTag>{_mm512_shuffle_ps(a.v.raw, b.v.raw, 0x88)});
#elif HWY_TARGET == HWY_AVX2
  return bits_of(hn::Vec<FloatTag>{_mm256_shuffle_ps(a.v.raw, b.v.raw, 0x88)});
#else
  return bits_of(hn::ConcatEven(kFloats, b.v, a.v));
#endif
}
/// 1 and 3.
HWY_INLINE Int odd_words(Float a, Float b) {
#if HWY_TARGET == HWY_AVX3
  return bits_of(hn::Vec<FloatTag>{_mm512_shuffle_ps(a.v.raw, b.v.raw, 0xDD)});
#elif HWY_TARGET == HWY_AVX2
  return bits_of(hn::Vec<FloatTag>{_mm256_shuffle_ps(a.v.raw, b.v.raw, 0xDD)});
#else
  return bits_of(hn::ConcatOdd(kFloats, b.v, a.v));
#endif
}
#endif

/// As load_quads(), of two words.
template <class At>
HWY_INLINE void load_pairs(At&& at, Int& first, Int& second) {
#if HWY_TARGET == HWY_SCALAR
  first = Int(at(std::size_t{0})[0]);
  second = Int(at(std::size_t{0})[1]);
#else
  const auto next = [&](std::size_t i) { return at(i + 1); };
  const Float a = from_bits(load_blocks(kInts, at, next, 0));  // of every fourth lane and the one behind it
  const Float b = from_bits(load_blocks(kInts, at, next, 2));
  first = even_words(a, b);
  second = odd_words(a, b);
#endif
}

/// math/lane.hpp: gather_pairs()
HWY_INLINE TwoPairs<Float> gather_pairs(const float* p, Int first, Int second) {
  alignas(64) std::array<std::int32_t, kLanes> at_first, at_second;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  store(at_first.data(), first);
  store(at_second.data(), second);
  const auto at = [p](std::int32_t place) { return reinterpret_cast<const std::int32_t*>(p + static_cast<std::size_t>(place)); };
  Int first_left, first_right, second_left, second_right;
  load_pairs([&](std::size_t i) { return at(at_first[i]); }, first_left, first_right);
  load_pairs([&](std::size_t i) { return at(at_second[i]); }, second_left, second_right);
  return {from_bits(first_left), from_bits(first_right), from_bits(second_left), from_bits(second_right)};
}

/// Chooses among kLanes numbers side by side: lane i takes the one at its index. Made once and used for many tables.
class LaneChoice {
 public:
  HWY_INLINE explicit LaneChoice(Int index) : indices_(indices_of(index)) {}
  HWY_INLINE Float operator()(const float* p) const { return chosen(hn::LoadU(kFloats, p)); }
  HWY_INLINE Int operator()(const std::int32_t* p) const { return bits_of(chosen(from_bits(load(p)).v)); }
  HWY_INLINE Int operator()(const std::uint32_t* p) const { return bits_of(chosen(from_bits(load(p)).v)); }

 private:
#if HWY_TARGET == HWY_SCALAR
  using Indices = Int;
  static HWY_INLINE Indices indices_of(Int index) { return index; }
  [[nodiscard]] static HWY_INLINE hn::Vec<FloatTag> chosen(hn::Vec<FloatTag> of) { return of; }
#elif HWY_TARGET == HWY_WASM  // Highway 1.0 goes through memory
  using Indices = v128_t;
  static HWY_INLINE Indices indices_of(Int index) { return (index * Int(0x04040404) + Int(0x03020100)).v.raw; }
  [[nodiscard]] HWY_INLINE hn::Vec<FloatTag> chosen(hn::Vec<FloatTag> of) const { return hn::Vec<FloatTag>{wasm_i8x16_swizzle(of.raw, indices_)}; }
#else
  using Indices = decltype(hn::IndicesFromVec(kFloats, hn::Zero(kInts)));
  static HWY_INLINE Indices indices_of(Int index) { return hn::IndicesFromVec(kFloats, index.v); }
  [[nodiscard]] HWY_INLINE hn::Vec<FloatTag> chosen(hn::Vec<FloatTag> of) const { return hn::TableLookupLanes(of, indices_); }
#endif
  Indices indices_;
};

/// list[index[i]] of every lane. The numbers are read from memory one by one: they address.
HWY_INLINE Vec3<Float> gather(const std::vector<Vec3f>& list, const std::uint32_t* index) {
  const float* f = &list.data()->x;
  // Four words are loaded where three stand: not behind the last vector.
  if (HWY_UNLIKELY(kLanes == 1 || any_of(load(index) == Int(static_cast<std::int32_t>(list.size() - 1))))) {
    const Int i = load(index) + load(index) + load(index);
    return {gather(f, i), gather(f, i + Int(1)), gather(f, i + Int(2))};
  }
  hn::Vec<IntTag> words[4];
  load_quads([&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(f + std::size_t{3} * index[i]); }, words);
  return {from_bits(words[0]), from_bits(words[1]), from_bits(words[2])};
}

/// The same of pairs and of fours.
HWY_INLINE Vec2<Float> gather(const std::vector<Vec2f>& list, const std::uint32_t* index) {
  Int x, y;
  load_pairs([&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(&list[index[i]].x); }, x, y);
  return {from_bits(x), from_bits(y)};
}
HWY_INLINE std::array<Float, 4> gather(const std::vector<std::array<float, 4>>& list, const std::uint32_t* index) {
  hn::Vec<IntTag> words[4];
  load_quads([&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(list[index[i]].data()); }, words);
  return {from_bits(words[0]), from_bits(words[1]), from_bits(words[2]), from_bits(words[3])};
}

/// Byte kByte of every lane, the lowest is 0.
template <std::size_t kByte>
HWY_INLINE Int byte_of(Int a) {
#if HWY_TARGET != HWY_SCALAR
  if constexpr (kByte > 0) {  // one shuffle in place of a shift and a mask
    constexpr std::uint32_t kRest = 0x80808000U;  // of a lane: nothing
    const hn::Repartition<std::uint8_t, IntTag> bytes;
    const auto from = hn::Add(hn::ShiftLeft<2>(hn::And(hn::Iota(kUints, 0), hn::Set(kUints, 3))), hn::Set(kUints, kRest + kByte));
    return hn::BitCast(kInts, hn::TableLookupBytesOr0(hn::BitCast(bytes, a.v), hn::BitCast(bytes, from)));
  }
#endif
  return a >> static_cast<int>(8 * kByte) & Int(0xFF);
}

/// kLanes structures of 16 words, transposed: words[w] holds word w of all of them.
HWY_INLINE void transpose(const std::uint32_t* first, const std::uint32_t* index, Words& words) {
  for (std::size_t q = 0; q < 16; q += 4) {
    load_quads([&](std::size_t i) { return reinterpret_cast<const std::int32_t*>(first) + std::size_t{16} * index[i] + q; }, &words.w[q]);
  }
}

/// The opposite for floats: structure i of 16 words is stored at out + 16 i.
HWY_INLINE void store_transposed(const std::array<Float, 16>& words, float* out) {
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t w = 0; w < 16; ++w) {
    store(out + w, words[w]);
  }
#else
  const hn::FixedTag<float, 4> quad;
  alignas(64) float quads[4 * kLanes];
  for (std::size_t q = 0; q < 4; ++q) {
    hn::StoreInterleaved4(words[4 * q].v, words[4 * q + 1].v, words[4 * q + 2].v, words[4 * q + 3].v, kFloats, quads);
    for (std::size_t i = 0; i < kLanes; ++i) {
      hn::Store(hn::Load(quad, quads + 4 * i), quad, out + 16 * i + 4 * q);
    }
  }
#endif
}

/// Sixteen floats in a row: sums of structures, word by word.
struct Sixteen {
#if HWY_TARGET == HWY_SCALAR
  float w[16] = {};
  HWY_INLINE void add(const float* p, float weight) {
    for (std::size_t i = 0; i < 16; ++i) {
      w[i] = w[i] + p[i] * weight;
    }
  }
  HWY_INLINE void store_to(float* p) const {
    for (std::size_t i = 0; i < 16; ++i) {
      p[i] = w[i];
    }
  }
#else
  static constexpr hn::FixedTag<float, 4> kQuad{};
  hn::Vec<hn::FixedTag<float, 4>> q[4];
  HWY_INLINE Sixteen() {
    for (auto& v : q) {
      v = hn::Zero(kQuad);
    }
  }
  HWY_INLINE void add(const float* p, float weight) {
    const auto by = hn::Set(kQuad, weight);
    for (std::size_t i = 0; i < 4; ++i) {
      q[i] = hn::Add(q[i], hn::Mul(hn::Load(kQuad, p + 4 * i), by));
    }
  }
  HWY_INLINE void store_to(float* p) const {
    for (std::size_t i = 0; i < 4; ++i) {
      hn::StoreU(q[i], kQuad, p + 4 * i);
    }
  }
#endif
};

/// kLanes samples in rows of four: what a small triangle's box is, rather than a long row. Lane i lies in column i % 4 of row i / 4.
#if HWY_TARGET != HWY_SCALAR
inline constexpr std::size_t kPatchRows = kLanes / 4;
template <class T> using RowTag = hn::FixedTag<T, 4>;
template <class T, class Tag> HWY_INLINE hn::Vec<Tag> load_rows(Tag tag, const T* p, std::size_t stride) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    return hn::LoadU(tag, p);
  } else {
    const hn::Half<Tag> half;
    return hn::Combine(tag, load_rows(half, p + stride * (hn::MaxLanes(Tag()) / 8), stride), load_rows(half, p, stride));
  }
}
template <class T, class Tag> HWY_INLINE void store_rows(Tag tag, hn::Vec<Tag> v, T* p, std::size_t stride) {
  if constexpr (hn::MaxLanes(Tag()) == 4) {
    hn::StoreU(v, tag, p);
  } else {
    const hn::Half<Tag> half;
    store_rows(half, hn::LowerHalf(half, v), p, stride);
    store_rows(half, hn::UpperHalf(half, v), p + stride * (hn::MaxLanes(Tag()) / 8), stride);
  }
}
HWY_INLINE Float load_patch(const float* p, std::size_t stride) { return load_rows(kFloats, p, stride); }
HWY_INLINE Int load_patch(const std::uint32_t* p, std::size_t stride) { return hn::BitCast(kInts, load_rows(kUints, p, stride)); }
HWY_INLINE void store_patch(float* p, std::size_t stride, Float a) { store_rows(kFloats, a.v, p, stride); }
HWY_INLINE void store_patch(std::uint32_t* p, std::size_t stride, Int a) { store_rows(kUints, hn::BitCast(kUints, a.v), p, stride); }
#endif

/// N doubles: room for products of image coordinates, which stay exact below 2^53. narrow() rounds to the nearest float, as a conversion of the
/// whole number to float does.
#if HWY_TARGET == HWY_SCALAR  // one lane has no halves
struct Wide {
  double d[kLanes];
};
template <class Of>
HWY_INLINE Wide make_wide(Of&& of) {
  Wide w;  // NOLINT(cppcoreguidelines-pro-type-member-init)
  for (std::size_t i = 0; i < kLanes; ++i) {
    w.d[i] = of(i);
  }
  return w;
}
HWY_INLINE Wide widen(Int a) {
  std::int32_t lanes[kLanes];
  store(lanes, a);
  return make_wide([&](std::size_t i) { return static_cast<double>(lanes[i]); });
}
HWY_INLINE Wide wide(double x) { return make_wide([x](std::size_t) { return x; }); }
HWY_INLINE Wide operator+(const Wide& a, const Wide& b) { return make_wide([&](std::size_t i) { return a.d[i] + b.d[i]; }); }
HWY_INLINE Wide operator-(const Wide& a, const Wide& b) { return make_wide([&](std::size_t i) { return a.d[i] - b.d[i]; }); }
HWY_INLINE Wide operator*(const Wide& a, const Wide& b) { return make_wide([&](std::size_t i) { return a.d[i] * b.d[i]; }); }
HWY_INLINE Float narrow(const Wide& a) {
  float lanes[kLanes];
  for (std::size_t i = 0; i < kLanes; ++i) {
    lanes[i] = static_cast<float>(a.d[i]);
  }
  return load(lanes);
}
#elif HWY_TARGET == HWY_WASM  // Highway 1.0 has no doubles for WebAssembly; the compiler has
struct Wide {
  v128_t low, high;
};
HWY_INLINE Wide widen(Int a) {
  return {wasm_f64x2_convert_low_i32x4(a.v.raw), wasm_f64x2_convert_low_i32x4(wasm_i32x4_shuffle(a.v.raw, a.v.raw, 2, 3, 2, 3))};
}
HWY_INLINE Wide wide(double x) { return {wasm_f64x2_splat(x), wasm_f64x2_splat(x)}; }
HWY_INLINE Wide operator+(Wide a, Wide b) { return {wasm_f64x2_add(a.low, b.low), wasm_f64x2_add(a.high, b.high)}; }
HWY_INLINE Wide operator-(Wide a, Wide b) { return {wasm_f64x2_sub(a.low, b.low), wasm_f64x2_sub(a.high, b.high)}; }
HWY_INLINE Wide operator*(Wide a, Wide b) { return {wasm_f64x2_mul(a.low, b.low), wasm_f64x2_mul(a.high, b.high)}; }
HWY_INLINE Float narrow(Wide a) {
  const v128_t low = wasm_f32x4_demote_f64x2_zero(a.low);
  const v128_t high = wasm_f32x4_demote_f64x2_zero(a.high);
  return hn::Vec<FloatTag>{wasm_i32x4_shuffle(low, high, 0, 1, 4, 5)};
}
#else
using DoubleTag = hn::Repartition<double, FloatTag>;  // half as many lanes
using HalfFloatTag = hn::Half<FloatTag>;
using HalfIntTag = hn::RebindToSigned<HalfFloatTag>;
inline constexpr DoubleTag kDoubles{};
struct Wide {
  hn::Vec<DoubleTag> low, high;
};
HWY_INLINE Wide widen(Int a) {
  return {hn::PromoteTo(kDoubles, hn::LowerHalf(HalfIntTag(), a.v)), hn::PromoteTo(kDoubles, hn::UpperHalf(HalfIntTag(), a.v))};
}
HWY_INLINE Wide wide(double x) { return {hn::Set(kDoubles, x), hn::Set(kDoubles, x)}; }
HWY_INLINE Wide operator+(Wide a, Wide b) { return {hn::Add(a.low, b.low), hn::Add(a.high, b.high)}; }
HWY_INLINE Wide operator-(Wide a, Wide b) { return {hn::Sub(a.low, b.low), hn::Sub(a.high, b.high)}; }
HWY_INLINE Wide operator*(Wide a, Wide b) { return {hn::Mul(a.low, b.low), hn::Mul(a.high, b.high)}; }
HWY_INLINE Float narrow(Wide a) { return hn::Combine(kFloats, hn::DemoteTo(HalfFloatTag(), a.high), hn::DemoteTo(HalfFloatTag(), a.low)); }
#endif
// clang-format on

}  // namespace lustro::HWY_NAMESPACE

namespace lustro {
template <>
struct LaneInt<HWY_NAMESPACE::Float> {
  using type = HWY_NAMESPACE::Int;
};
}  // namespace lustro
