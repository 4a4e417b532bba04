// A flat hash table of indices: open addressing, linear probing. The caller owns the keys and says what is equal; the table says which index
// came first. So welding and the merging of vertices take linear time and no memory per element but eight bytes.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lustro/vec.hpp"

namespace lustro {

/// One more word into a hash: the finaliser of SplitMix64 (Steele, Lea, Flood 2014).
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t hash, std::uint64_t word) {
  std::uint64_t z = (hash ^ word) + 0x9E3779B97F4A7C15U;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
  return z ^ (z >> 31U);
}

/// The bits of x, the same for -0 and 0, which compare equal.
[[nodiscard]] inline std::uint32_t value_bits(float x) {
  return std::bit_cast<std::uint32_t>(x + 0.0F);
}

[[nodiscard]] inline std::uint64_t mix(std::uint64_t hash, const Vec3f& v) {
  return mix(mix(hash, std::uint64_t{value_bits(v.x)} << 32U | value_bits(v.y)), value_bits(v.z));
}

class IndexTable {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  explicit IndexTable(std::size_t expected = 0) : slots_(std::bit_ceil(2 * expected + 16)) {}

  /// The index in the table whose key has this hash and for which equal(index) holds, or kNone.
  template <class Equal>
  [[nodiscard]] std::uint32_t find(std::uint64_t hash, const Equal& equal) const {
    return slots_[probe(hash, equal)].index;
  }

  /// The same; where there is none, `index` goes in and is the answer.
  template <class Equal>
  std::uint32_t find_or_insert(std::uint64_t hash, std::uint32_t index, const Equal& equal) {
    const std::size_t place = probe(hash, equal);
    if (slots_[place].index != kNone) {
      return slots_[place].index;
    }
    slots_[place] = {static_cast<std::uint32_t>(hash), index};
    if (++size_ * 2 > slots_.size()) {
      grow();
    }
    return index;
  }

 private:
  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t index = kNone;
  };

  template <class Equal>
  [[nodiscard]] std::size_t probe(std::uint64_t hash, const Equal& equal) const {
    const std::size_t mask = slots_.size() - 1;
    const auto short_hash = static_cast<std::uint32_t>(hash);
    std::size_t place = short_hash & mask;
    while (slots_[place].index != kNone && !(slots_[place].hash == short_hash && equal(slots_[place].index))) {
      place = (place + 1) & mask;
    }
    return place;
  }

  void grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.index != kNone) {
        slots_[probe(slot.hash, [](std::uint32_t) { return false; })] = slot;
      }
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace lustro
