// The file in which pictures by paths are kept. The checksum is made right, so that what it protects is reached.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "image/hash.hpp"
#include "path/state.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::byte> bytes(size);
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<std::byte>(data[i]);
  }
  static_cast<void>(lustro::decode_path_state(bytes, "fuzz", 2, 1));
  if (size < 8) {
    return 0;
  }
  const std::uint64_t sum = lustro::xxh64(std::span(bytes).first(size - 8), 0);
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[size - 8 + i] = static_cast<std::byte>(sum >> (8 * i));
  }
  if (const auto state = lustro::decode_path_state(bytes, "fuzz", 2, 1)) {
    const bool is_sound = state->samples >= 1 && state->pixels.size() == 2 && std::isfinite(state->pixels[1].squares[2]);
    if (!is_sound || lustro::encode_path_state(*state).size() != size) {
      std::abort();
    }
  }
  return 0;
}
