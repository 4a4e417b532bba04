#include "simd/lanes_probe.hpp"

#include "simd/lanes.hpp"

namespace lustro {
namespace HWY_NAMESPACE {

inline Mask mask_of(const std::int32_t* numbers) {
  return !(load(numbers) == Int(0));
}

}  // namespace HWY_NAMESPACE

#define LUSTRO_JOIN(a, b) a##b
#define LUSTRO_LANES(row) LUSTRO_JOIN(lanes_, row)

const LaneProbe& LUSTRO_LANES(LUSTRO_ROW)();
const LaneProbe& LUSTRO_LANES(LUSTRO_ROW)() {
  using namespace HWY_NAMESPACE;  // NOLINT(google-build-using-namespace)
  static constexpr LaneProbe kProbe{
      kLanes,
      [](const float* a, const float* b, float* out) { store(out, lane_max(load(a), load(b))); },
      [](const float* a, const float* b, float* out) { store(out, lane_min(load(a), load(b))); },
      [](const std::int32_t* numbers) { return mask_bits(mask_of(numbers)); },
      [](const std::int32_t* numbers) { return count_true(mask_of(numbers)); },
      [](const std::int32_t* numbers, const std::int32_t* values, std::int32_t* out) { store_chosen(mask_of(numbers), out, load(values)); },
      [](const float* from, const std::int32_t* index, float* out) { store(out, LaneChoice(load(index))(from)); },
      [](std::uint32_t bits, std::int32_t* out) { store(out, counts_before(bits)); },
      [](const float* a, std::int32_t* out) { store(out, truncate(load(a))); },
      [](const std::int32_t* words, std::int32_t* out) {
        store(out, byte_of<0>(load(words)));
        store(out + kLanes, byte_of<1>(load(words)));
        store(out + 2 * kLanes, byte_of<2>(load(words)));
        store(out + 3 * kLanes, byte_of<3>(load(words)));
      },
      [](const std::int32_t* p, const std::int32_t* at, std::int32_t* out) {
        Int first, second;
        load_pairs([&](std::size_t i) { return p + at[i]; }, first, second);
        store(out, first);
        store(out + kLanes, second);
      },
  };
  return kProbe;
}

}  // namespace lustro
