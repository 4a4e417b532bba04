#include "image/huffman.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <numeric>
#include <queue>
#include <vector>

#include "image/support.hpp"

namespace lustro {
namespace {

std::vector<std::uint8_t> lengths_of(const std::vector<std::uint32_t>& counts, int limit) {
  std::vector<std::uint8_t> lengths(counts.size());
  huffman_lengths(counts, limit, lengths);
  return lengths;
}

/// 1 for a code that is complete.
double kraft_sum(const std::vector<std::uint8_t>& lengths) {
  double sum = 0;
  for (const std::uint8_t length : lengths) {
    sum += length == 0 ? 0 : 1.0 / static_cast<double>(1U << length);
  }
  return sum;
}

std::uint64_t bits_for(const std::vector<std::uint32_t>& counts, const std::vector<std::uint8_t>& lengths) {
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    bits += std::uint64_t{counts[i]} * lengths[i];
  }
  return bits;
}

/// What Huffman's own procedure needs: the sum of all inner nodes.
std::uint64_t least_bits(const std::vector<std::uint32_t>& counts) {
  std::priority_queue<std::uint64_t, std::vector<std::uint64_t>, std::greater<>> queue;
  for (const std::uint32_t count : counts) {
    if (count != 0) {
      queue.push(count);
    }
  }
  std::uint64_t bits = 0;
  while (queue.size() > 1) {
    std::uint64_t sum = queue.top();
    queue.pop();
    sum += queue.top();
    queue.pop();
    bits += sum;
    queue.push(sum);
  }
  return bits;
}

/// What the best code of limited length needs, by packages and merging (Larmore and Hirschberg 1990).
std::uint64_t least_bits(const std::vector<std::uint32_t>& counts, int limit) {
  std::vector<std::uint64_t> leaves;
  std::copy_if(counts.begin(), counts.end(), std::back_inserter(leaves), [](std::uint32_t c) { return c != 0; });
  std::sort(leaves.begin(), leaves.end());
  std::vector<std::uint64_t> merged = leaves;
  for (int level = 1; level < limit; ++level) {
    std::vector<std::uint64_t> packages;
    for (std::size_t i = 0; i + 1 < merged.size(); i += 2) {
      packages.push_back(merged[i] + merged[i + 1]);
    }
    merged = leaves;
    merged.insert(merged.end(), packages.begin(), packages.end());
    std::sort(merged.begin(), merged.end());
  }
  return std::accumulate(merged.begin(), merged.begin() + static_cast<std::ptrdiff_t>(2 * leaves.size() - 2), std::uint64_t{0});
}

TEST(Huffman, LengthsOfATextbookExample) {
  // Cormen et al., Introduction to Algorithms: a 45, b 13, c 12, d 16, e 9, f 5
  EXPECT_EQ(lengths_of({45, 13, 12, 16, 9, 5}, 15), (std::vector<std::uint8_t>{1, 3, 3, 3, 4, 4}));
  EXPECT_EQ(lengths_of({0, 7, 0, 1}, 15), (std::vector<std::uint8_t>{0, 1, 0, 1}));
}

TEST(Huffman, CodesOfTheExampleInRfc1951) {
  const std::vector<std::uint8_t> lengths{3, 3, 3, 3, 3, 2, 4, 4};
  std::vector<std::uint16_t> codes(8);
  huffman_codes(lengths, codes);
  // 010 011 100 101 110 00 1110 1111, read from the right
  EXPECT_EQ(codes, (std::vector<std::uint16_t>{0b010, 0b110, 0b001, 0b101, 0b011, 0b00, 0b0111, 0b1111}));
}

TEST(Huffman, WithoutALimitNoCodeIsShorter) {
  RandomBits random(1);
  for (int round = 0; round < 2000; ++round) {
    std::vector<std::uint32_t> counts(2 + random() % 285);
    const unsigned skew = random() % 12;  // so that depths stay below 15
    for (std::uint32_t& count : counts) {
      count = 1 + (random() >> (20 + random() % (skew + 1)));
    }
    const auto lengths = lengths_of(counts, 15);
    ASSERT_EQ(kraft_sum(lengths), 1);
    if (*std::max_element(lengths.begin(), lengths.end()) < 15) {
      ASSERT_EQ(bits_for(counts, lengths), least_bits(counts));
    }
  }
}

TEST(Huffman, TheLimitHoldsAndCostsLittle) {
  RandomBits random(2);
  std::vector<std::uint32_t> fibonacci{1, 1};
  while (fibonacci.size() < 40) {
    fibonacci.push_back(fibonacci[fibonacci.size() - 1] + fibonacci[fibonacci.size() - 2]);
  }
  std::map<int, double> worst;
  for (int round = 0; round < 500; ++round) {
    std::vector<std::uint32_t> counts(fibonacci.begin(), fibonacci.begin() + 20 + static_cast<int>(random() % 20));
    for (std::uint32_t i = random() % 200; i > 0; --i) {
      counts.push_back(random() % 3 == 0 ? 0 : 1 + random() % 100);
    }
    std::shuffle(counts.begin(), counts.end(), random);
    for (const int limit : {8, 14, 15}) {
      const auto lengths = lengths_of(counts, limit);
      ASSERT_EQ(kraft_sum(lengths), 1);
      ASSERT_LE(*std::max_element(lengths.begin(), lengths.end()), limit);
      const double ratio = static_cast<double>(bits_for(counts, lengths)) / static_cast<double>(least_bits(counts, limit));
      ASSERT_GE(ratio, 1);
      worst[limit] = std::max(worst[limit], ratio);
    }
  }
  EXPECT_LT(worst[8], 1.3);  // 8 bits for up to 256 symbols: there is little choice, and it is not the best one
  EXPECT_LT(worst[14], 1.01);
  EXPECT_LT(worst[15], 1.01);
}

TEST(Huffman, TheRarerSymbolNeverHasTheShorterCode) {
  RandomBits random(3);
  for (int round = 0; round < 300; ++round) {
    std::vector<std::uint32_t> counts(30);
    for (std::uint32_t& count : counts) {
      count = random() >> (random() % 32);
    }
    counts[0] = counts[1] = 5;
    for (std::uint32_t& count : counts) {
      count /= 64;  // the sum must stay below 2^32
    }
    counts[2] = counts[3] = 9;
    const auto lengths = lengths_of(counts, 7);
    for (std::size_t i = 0; i < counts.size(); ++i) {
      ASSERT_EQ(counts[i] == 0, lengths[i] == 0);
      for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts[k] != 0 && counts[i] > counts[k]) {
          ASSERT_LE(lengths[i], lengths[k]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace lustro
