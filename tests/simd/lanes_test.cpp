// What lanes.hpp writes for each instruction set, against math/lane.hpp: the same bits, on what is not a number, too.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include "lustro/render.hpp"
#include "math/lane.hpp"
#include "simd/lanes_probe.hpp"

namespace lustro {

const LaneProbe& lanes_scalar();
const LaneProbe& lanes_sse4();
const LaneProbe& lanes_avx2();
const LaneProbe& lanes_avx512();
const LaneProbe& lanes_neon();

namespace {

/// Of the rows that this machine can run.
std::vector<std::pair<std::string_view, const LaneProbe*>> probes() {
  std::vector<std::pair<std::string_view, const LaneProbe*>> result;
  for (const Target target : available_targets()) {
    const LaneProbe* probe = nullptr;
    switch (target) {
      case Target::scalar:
        probe = &lanes_scalar();
        break;
#ifdef LUSTRO_HAS_SSE4
      case Target::sse4:
        probe = &lanes_sse4();
        break;
#endif
#ifdef LUSTRO_HAS_AVX2
      case Target::avx2:
        probe = &lanes_avx2();
        break;
#endif
#ifdef LUSTRO_HAS_AVX512
      case Target::avx512:
        probe = &lanes_avx512();
        break;
#endif
#ifdef LUSTRO_HAS_NEON
      case Target::neon:
        probe = &lanes_neon();
        break;
#endif
      default:
        ADD_FAILURE() << "no probe of the row " << target_name(target);
        continue;
    }
    result.emplace_back(target_name(target), probe);
  }
  return result;
}

constexpr std::size_t kMostLanes = 16;
template <class T>
using Lanes = std::array<T, kMostLanes>;

std::uint32_t bits(float x) {
  return std::bit_cast<std::uint32_t>(x);
}

/// Every pair of these, a lane's own in every lane.
void expect_equal_bits(void (*LaneProbe::*lanes)(const float*, const float*, float*), float (*scalar)(float, float)) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<float> values{0.0F, -0.0F, 1.0F, -1.0F, 1e-42F, -1e-42F, 3e38F, kInfinity, -kInfinity, kNan, -kNan};
  for (const auto& [name, probe] : probes()) {
    for (std::size_t first = 0; first < values.size(); ++first) {
      for (std::size_t second = 0; second < values.size(); ++second) {
        Lanes<float> a{}, b{}, out{};
        for (std::size_t i = 0; i < kMostLanes; ++i) {
          a[i] = values[(first + i) % values.size()];
          b[i] = values[(second + 2 * i) % values.size()];
        }
        (probe->*lanes)(a.data(), b.data(), out.data());
        for (std::size_t i = 0; i < probe->lanes; ++i) {
          ASSERT_EQ(bits(out[i]), bits(scalar(a[i], b[i]))) << name << ", lane " << i << ": " << a[i] << " and " << b[i];
        }
      }
    }
  }
}

TEST(Lanes, MaximaAreTheSecondWhereTheFirstIsNotGreater) {
  expect_equal_bits(&LaneProbe::max, [](float a, float b) { return lane_max(a, b); });
}

TEST(Lanes, MinimaAreTheSecondWhereTheFirstIsNotLess) {
  expect_equal_bits(&LaneProbe::min, [](float a, float b) { return lane_min(a, b); });
}

TEST(Lanes, EveryMaskIsItsBitsAndItsCount) {
  for (const auto& [name, probe] : probes()) {
    for (std::uint32_t mask = 0; mask < 1U << probe->lanes; ++mask) {
      Lanes<std::int32_t> numbers{};
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        numbers[i] = (mask >> i & 1U) != 0 ? -7 : 0;
      }
      ASSERT_EQ(probe->mask_bits(numbers.data()), mask) << name;
      ASSERT_EQ(probe->count_true(numbers.data()), static_cast<std::size_t>(std::popcount(mask))) << name;
    }
  }
}

TEST(Lanes, ChosenLanesAreStoredOneAfterTheOther) {
  for (const auto& [name, probe] : probes()) {
    Lanes<std::int32_t> values{};
    std::iota(values.begin(), values.end(), 100);
    for (std::uint32_t mask = 0; mask < 1U << probe->lanes; ++mask) {
      Lanes<std::int32_t> numbers{}, out{};
      std::vector<std::int32_t> chosen;
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        numbers[i] = static_cast<std::int32_t>(mask >> i & 1U);
        if (numbers[i] != 0) {
          chosen.push_back(values[i]);
        }
      }
      probe->store_chosen(numbers.data(), values.data(), out.data());
      ASSERT_EQ(std::vector<std::int32_t>(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(chosen.size())), chosen)
          << name << ", mask " << mask;
    }
  }
}

TEST(Lanes, LanesAreChosenByTheirNumbers) {
  for (const auto& [name, probe] : probes()) {
    Lanes<float> from{}, out{};
    std::iota(from.begin(), from.end(), 0.5F);
    for (std::size_t step = 0; step < probe->lanes; ++step) {
      Lanes<std::int32_t> index{};
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        index[i] = static_cast<std::int32_t>((i * step + step) % probe->lanes);
      }
      probe->choose_lanes(from.data(), index.data(), out.data());
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        ASSERT_EQ(out[i], from[static_cast<std::size_t>(index[i])]) << name << ", lane " << i;
      }
    }
  }
}

TEST(Lanes, EveryLaneCountsTheSetOnesBeforeIt) {
  for (const auto& [name, probe] : probes()) {
    for (std::uint32_t mask = 0; mask < 1U << probe->lanes; ++mask) {
      Lanes<std::int32_t> out{};
      probe->counts_before(mask, out.data());
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        ASSERT_EQ(out[i], std::popcount(mask & ((1U << i) - 1))) << name << ", mask " << mask << ", lane " << i;
      }
    }
  }
}

TEST(Lanes, FloatsLoseWhatStandsBehindThePoint) {
  const std::vector<float> values{0.0F,       -0.0F,       0.99999994F,   -0.99999994F,   1.5F,  -1.5F,
                                  8388607.5F, -8388607.5F, 2147483520.0F, -2147483648.0F, 1e-42F};
  for (const auto& [name, probe] : probes()) {
    for (std::size_t first = 0; first < values.size(); ++first) {
      Lanes<float> a{};
      Lanes<std::int32_t> out{};
      for (std::size_t i = 0; i < kMostLanes; ++i) {
        a[i] = values[(first + i) % values.size()];
      }
      probe->truncate(a.data(), out.data());
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        ASSERT_EQ(out[i], truncate(a[i])) << name << ": " << a[i];
      }
    }
  }
}

TEST(Lanes, BytesAreTakenOutOfWords) {
  for (const auto& [name, probe] : probes()) {
    Lanes<std::int32_t> words{};
    std::array<std::int32_t, 4 * kMostLanes> out{};
    for (std::size_t i = 0; i < kMostLanes; ++i) {
      words[i] = static_cast<std::int32_t>(0x80FF7F01U + 0x11030507U * static_cast<std::uint32_t>(i));
    }
    probe->bytes_of(words.data(), out.data());
    for (std::size_t byte = 0; byte < 4; ++byte) {
      for (std::size_t i = 0; i < probe->lanes; ++i) {
        ASSERT_EQ(out[byte * probe->lanes + i], static_cast<std::int32_t>(static_cast<std::uint32_t>(words[i]) >> 8 * byte & 0xFF))
            << name << ", byte " << byte << " of lane " << i;
      }
    }
  }
}

TEST(Lanes, PairsAreReadFromWhereverTheyBegin) {
  std::array<std::int32_t, 64> numbers{};
  std::iota(numbers.begin(), numbers.end(), 1000);
  for (const auto& [name, probe] : probes()) {
    Lanes<std::int32_t> at{};
    std::array<std::int32_t, 2 * kMostLanes> out{};
    for (std::size_t i = 0; i < kMostLanes; ++i) {
      at[i] = static_cast<std::int32_t>(i * 37 % 63);
    }
    probe->load_pairs(numbers.data(), at.data(), out.data());
    for (std::size_t i = 0; i < probe->lanes; ++i) {
      ASSERT_EQ(out[i], 1000 + at[i]) << name << ", lane " << i;
      ASSERT_EQ(out[probe->lanes + i], 1001 + at[i]) << name << ", lane " << i;
    }
  }
}

}  // namespace
}  // namespace lustro
