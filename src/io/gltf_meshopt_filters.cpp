// The filters of EXT_meshopt_compression, appendix B: octahedral normals, quaternions without their largest part, shared exponents.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "io/gltf_meshopt.hpp"

namespace lustro {
namespace {

template <class T>
T load(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

template <class T>
void store(char* to, T value) {
  std::memcpy(to, &value, sizeof value);
}

/// The nearest whole number, halves away from 0.
template <class T>
T rounded(float x) {
  return static_cast<T>(x * static_cast<float>(std::numeric_limits<T>::max()) + (x >= 0 ? 0.5F : -0.5F));
}

template <class T>
void undo_octahedral(char* element) {
  const auto part = [&](std::size_t i) { return static_cast<float>(load<T>(element + i * sizeof(T))); };
  float x = part(0);
  float y = part(1);
  const float z = (part(2) - std::abs(x)) - std::abs(y);
  const float fold = std::min(z, 0.0F);  // the lower half is folded outwards
  x += x >= 0 ? fold : -fold;
  y += y >= 0 ? fold : -fold;
  const float size = std::sqrt((x * x + y * y) + z * z);
  const float scale = size > 0 ? 1 / size : 0;
  store(element, rounded<T>(std::clamp(x * scale, -1.0F, 1.0F)));
  store(element + sizeof(T), rounded<T>(std::clamp(y * scale, -1.0F, 1.0F)));
  store(element + 2 * sizeof(T), rounded<T>(std::clamp(z * scale, -1.0F, 1.0F)));
}

void undo_quaternion(char* element) {
  const auto last = load<std::int16_t>(element + 6);
  const auto largest = static_cast<std::size_t>(last & 3);
  const float scale = 0.70710678118654752440F / static_cast<float>(last | 3);
  std::array<float, 4> parts{};
  for (std::size_t i = 0; i < 3; ++i) {
    parts[i] = std::clamp(static_cast<float>(load<std::int16_t>(element + 2 * i)) * scale, -1.0F, 1.0F);
  }
  parts[3] = std::sqrt(std::max(0.0F, ((1 - parts[0] * parts[0]) - parts[1] * parts[1]) - parts[2] * parts[2]));
  for (std::size_t i = 0; i < 4; ++i) {
    store(element + 2 * ((largest + i + 1) % 4), rounded<std::int16_t>(parts[i]));
  }
}

void undo_exponential(char* number) {
  const auto bits = load<std::int32_t>(number);
  const std::int32_t exponent = bits >> 24;
  const auto mantissa = static_cast<std::int32_t>(static_cast<std::uint32_t>(bits) << 8U) >> 8;
  const auto power = std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52U);
  store(number, static_cast<float>(static_cast<double>(mantissa) * power));
}

}  // namespace

void undo_meshopt_filter(char* elements, const GltfMeshopt& packed) {
  for (std::size_t i = 0; i < packed.count; ++i) {
    char* element = elements + i * packed.stride;
    switch (packed.filter) {
      case GltfMeshopt::Filter::none:
        return;
      case GltfMeshopt::Filter::octahedral:
        packed.stride == 4 ? undo_octahedral<std::int8_t>(element) : undo_octahedral<std::int16_t>(element);
        break;
      case GltfMeshopt::Filter::quaternion:
        undo_quaternion(element);
        break;
      case GltfMeshopt::Filter::exponential:
        for (std::size_t k = 0; k < packed.stride; k += 4) {
          undo_exponential(element + k);
        }
    }
  }
}

}  // namespace lustro
