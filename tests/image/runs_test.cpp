#include "image/runs.hpp"

#include "image/support.hpp"

namespace lustro {

void PrintTo(const Stretch& stretch, std::ostream* out) {
  *out << stretch.literals << "+" << stretch.repeats;
}

namespace {

using Bytes = std::vector<std::uint8_t>;

/// The same, byte by byte.
std::vector<Stretch> plain_stretches(const Bytes& data) {
  std::vector<Stretch> stretches(1);
  for (std::size_t i = 0; i < data.size();) {
    std::size_t repeats = 0;
    while (i > 0 && i + repeats < data.size() && data[i + repeats] == data[i - 1]) {
      ++repeats;
    }
    if (repeats >= kShortestRun) {
      stretches.back().repeats = static_cast<std::uint32_t>(repeats);
      stretches.emplace_back();
      i += repeats;
    } else {
      ++stretches.back().literals;
      ++i;
    }
  }
  return stretches;
}

TEST(Runs, KnownStretches) {
  EXPECT_EQ(find_stretches(Bytes{7}), (std::vector<Stretch>{{1, 0}}));
  EXPECT_EQ(find_stretches(Bytes(8, 7)), (std::vector<Stretch>{{8, 0}}));  // seven repeats are too few
  EXPECT_EQ(find_stretches(Bytes(9, 7)), (std::vector<Stretch>{{1, 8}, {0, 0}}));
  EXPECT_EQ(find_stretches(Bytes(1000, 0)), (std::vector<Stretch>{{1, 999}, {0, 0}}));
  EXPECT_EQ(find_stretches(Bytes{1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3}), (std::vector<Stretch>{{2, 8}, {3, 0}}));
  EXPECT_EQ(find_stretches(Bytes{1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2}), (std::vector<Stretch>{{1, 8}, {1, 8}, {0, 0}}));
}

TEST(Runs, EveryRunAtEveryPlaceIsFound) {
  for (std::size_t before = 0; before < 140; ++before) {
    for (std::size_t length = 1; length < 150; length += length < 12 ? 1 : 9) {
      Bytes data;
      for (std::size_t i = 0; i < before; ++i) {
        data.push_back(static_cast<std::uint8_t>(i % 2));
      }
      data.insert(data.end(), length, 255);
      ASSERT_EQ(find_stretches(data), plain_stretches(data)) << before << " before " << length;
      data.push_back(0);
      ASSERT_EQ(find_stretches(data), plain_stretches(data)) << before << " before " << length;
    }
  }
}

TEST(Runs, RandomBytesGiveWhatAPlainSearchGives) {
  RandomBits random(1);
  for (int round = 0; round < 3000; ++round) {
    Bytes data;
    const std::size_t size = 1 + random() % 1000;
    const std::uint32_t values = 1 + random() % 4;
    const std::uint32_t stays = 1 + random() % 40;
    while (data.size() < size) {
      const auto value = static_cast<std::uint8_t>((random() % values) * 0x55);
      data.insert(data.end(), std::min<std::size_t>(size - data.size(), 1 + random() % stays), value);
    }
    ASSERT_EQ(find_stretches(data), plain_stretches(data)) << round;
  }
}

}  // namespace
}  // namespace lustro
