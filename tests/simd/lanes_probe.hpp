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
};

}  // namespace lustro
