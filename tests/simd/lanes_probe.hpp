// A row's lanes for tests: arrays of as many numbers as it has lanes. simd/lanes_probe.cpp is compiled once a row.
#pragma once

#include <cstddef>
#include <cstdint>

#include "lustro/vec.hpp"

namespace lustro {

struct LaneProbe {
  std::size_t lanes;
  void (*max)(const float* a, const float* b, float* out);
  void (*min)(const float* a, const float* b, float* out);
  /// Of the lanes whose number is not 0.
  std::uint32_t (*mask_bits)(const std::int32_t* numbers);
  std::size_t (*count_true)(const std::int32_t* numbers);
  void (*store_chosen)(const std::int32_t* numbers, const std::int32_t* values, std::int32_t* out);
  void (*choose_lanes)(const float* from, const std::int32_t* index, float* out);
  void (*counts_before)(std::uint32_t bits, std::int32_t* out);
  void (*truncate)(const float* a, std::int32_t* out);
  /// The lowest byte of every lane, then the next one, ...: four times as many numbers as lanes.
  void (*bytes_of)(const std::int32_t* words, std::int32_t* out);
  /// The pairs that begin at p + at[i]: the first of all lanes, then the second.
  void (*load_pairs)(const std::int32_t* p, const std::int32_t* at, std::int32_t* out);
};

}  // namespace lustro
