#include "image/png_filter.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "image/support.hpp"

namespace lustro {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// PaethPredictor of the PNG standard, 9.4.
int standard_paeth(int a, int b, int c) {
  const int p = a + b - c;
  const int pa = std::abs(p - a);
  const int pb = std::abs(p - b);
  const int pc = std::abs(p - c);
  if (pa <= pb && pa <= pc) {
    return a;
  }
  return pb <= pc ? b : c;
}

/// A row from its filtered bytes, as the standard reconstructs it (9.2).
Bytes reconstructed(const Bytes& filtered, const Bytes& up, std::size_t step) {
  Bytes row(filtered.size() - 1);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int a = i >= step ? row[i - step] : 0;
    const int b = up[i];
    const int c = i >= step ? up[i - step] : 0;
    const int foretold[] = {0, a, b, (a + b) / 2, standard_paeth(a, b, c)};
    row[i] = static_cast<std::uint8_t>(filtered[i + 1] + foretold[filtered[0]]);
  }
  return row;
}

Bytes random_row(RandomBits& random, std::size_t size) {
  Bytes row(size);
  const std::uint32_t range = 1 + random() % 256;
  for (std::uint8_t& v : row) {
    v = static_cast<std::uint8_t>(random() % range);
  }
  return row;
}

TEST(RowFilter, PaethIsTheStandardsForAllNeighbours) {
  constexpr std::size_t kStep = 1;
  Bytes row(512);  // left neighbour and pixel in turns
  Bytes up(512);
  Bytes filtered(513);
  for (int left = 0; left < 256; ++left) {
    for (int corner = 0; corner < 256; ++corner) {
      for (std::size_t above = 0; above < 256; ++above) {
        row[2 * above] = static_cast<std::uint8_t>(left);
        up[2 * above] = static_cast<std::uint8_t>(corner);
        up[2 * above + 1] = static_cast<std::uint8_t>(above);
      }
      filter_row(RowFilter::paeth, row, up, kStep, filtered);
      for (int above = 0; above < 256; ++above) {
        const int foretold = 256 - filtered[2 * static_cast<std::size_t>(above) + 2];  // of a pixel that is 0
        ASSERT_EQ(foretold & 0xFF, standard_paeth(left, above, corner)) << left << " " << above << " " << corner;
      }
    }
  }
}

TEST(RowFilter, EveryFilterIsUndoneByTheStandard) {
  RandomBits random(1);
  for (std::size_t step = 1; step <= 8; ++step) {
    for (std::size_t pixels = 1; pixels < 80; ++pixels) {
      const Bytes row = random_row(random, step * pixels);
      const Bytes up = random_row(random, step * pixels);
      Bytes filtered(row.size() + 1);
      for (const RowFilter filter : {RowFilter::sub, RowFilter::up, RowFilter::paeth}) {
        filter_row(filter, row, up, step, filtered);
        ASSERT_EQ(filtered[0], static_cast<int>(filter));
        ASSERT_EQ(reconstructed(filtered, up, step), row) << step << " bytes, " << pixels << " pixels, filter " << int{filtered[0]};
      }
      filter_row_well(row, up, step, filtered);
      ASSERT_EQ(reconstructed(filtered, up, step), row);
    }
  }
}

TEST(RowFilter, TheOneThatLeavesTheFewestDifferencesIsTaken) {
  const auto chosen = [](const Bytes& row, const Bytes& up) {
    Bytes filtered(row.size() + 1);
    filter_row_well(row, up, 1, filtered);
    return static_cast<RowFilter>(filtered[0]);
  };
  EXPECT_EQ(chosen({1, 9, 4, 7}, {1, 9, 4, 7}), RowFilter::up);
  EXPECT_EQ(chosen({1, 9, 4, 7}, {1, 9, 4, 8}), RowFilter::up);
  EXPECT_EQ(chosen({50, 50, 50, 50, 50, 50}, {7, 90, 200, 13, 5, 61}), RowFilter::sub);
  EXPECT_EQ(chosen({12, 22, 32, 42, 52, 62}, {10, 20, 30, 40, 50, 60}), RowFilter::up);  // nothing is 0: the first of the three
  EXPECT_EQ(chosen(Bytes(4096, 50), Bytes(4096, 60)), RowFilter::paeth);                 // 256 differences in each of 16 lanes are not 0
  EXPECT_EQ(chosen({5, 5, 5, 5, 8, 8, 8, 8}, {0, 0, 0, 0, 8, 8, 8, 8}), RowFilter::paeth);
}

TEST(RowFilter, TheChoiceMinimisesTheCountOnRandomRows) {
  RandomBits random(2);
  const auto different = [](const Bytes& filtered) {
    return static_cast<std::ptrdiff_t>(filtered.size()) - 1 - std::count(filtered.begin() + 1, filtered.end(), 0);
  };
  for (int round = 0; round < 500; ++round) {
    const std::size_t step = 1 + random() % 4;
    const std::size_t size = step * (1 + random() % 700);  // beyond the blocks in which bytes are counted
    const Bytes up = random_row(random, size);
    Bytes row = random() % 2 == 0 ? up : random_row(random, size);
    for (std::size_t i = 0; i < size; i += 1 + random() % 20) {
      row[i] = static_cast<std::uint8_t>(random() % 3);
    }
    Bytes filtered(size + 1);
    filter_row_well(row, up, step, filtered);
    const auto by_choice = different(filtered);
    for (const RowFilter filter : {RowFilter::sub, RowFilter::up, RowFilter::paeth}) {
      filter_row(filter, row, up, step, filtered);
      ASSERT_LE(by_choice, different(filtered)) << size;
    }
  }
}

}  // namespace
}  // namespace lustro
