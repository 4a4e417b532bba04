#include "image/adler.hpp"

#include <libdeflate.h>

#include <vector>

#include "image/support.hpp"

namespace lustro {
namespace {

TEST(Adler, TheWordWikipediaInTwoParts) {
  EXPECT_EQ(libdeflate_adler32(1, "Wikipedia", 9), 0x11E60398U);
  EXPECT_EQ(joined_adler(libdeflate_adler32(1, "Wiki", 4), libdeflate_adler32(1, "pedia", 5), 5), 0x11E60398U);
}

TEST(Adler, PartsOfAnyLengthJoin) {
  RandomBits random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::uint8_t> bytes(random() % 200'000);
    const auto fill = static_cast<std::uint8_t>(random());
    for (std::uint8_t& v : bytes) {
      v = round % 2 == 0 ? std::uint8_t{255} : static_cast<std::uint8_t>(random() & fill);
    }
    const std::size_t cut = bytes.empty() ? 0 : random() % bytes.size();
    bytes.push_back(1);  // so that there is memory to point to
    const std::size_t size = bytes.size() - 1;
    const std::uint32_t first = libdeflate_adler32(kAdlerOfNothing, bytes.data(), cut);
    const std::uint32_t second = libdeflate_adler32(kAdlerOfNothing, bytes.data() + cut, size - cut);
    ASSERT_EQ(joined_adler(first, second, size - cut), libdeflate_adler32(kAdlerOfNothing, bytes.data(), size));
  }
}

}  // namespace
}  // namespace lustro
