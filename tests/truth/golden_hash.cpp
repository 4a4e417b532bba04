// FNV-1a over the words of the pictures.
#include "truth/golden_hash.hpp"

#include <array>
#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>

namespace lustro::truth {
namespace {

class Hash {
 public:
  void add(std::span<const float> values) {
    for (const float value : values) {
      state_ = (state_ ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001B3U;
    }
  }
  [[nodiscard]] std::string text() const {
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016" PRIx64, state_);
    return digits.data();
  }

 private:
  std::uint64_t state_ = 0xCBF29CE484222325U;
};

}  // namespace

std::string golden_hash(const Scene& scene, const RenderOptions& how, std::string* bytes) {
  RenderOptions options = how;
  options.store_bytes = bytes != nullptr;
  for (const AovKind kind : {AovKind::diffuse, AovKind::specular, AovKind::depth, AovKind::normal, AovKind::barycentrics}) {
    options.aovs.push_back({kind});
  }
  const Result<Rendering> rendering = render(scene, options);
  if (!rendering) {
    return rendering.error().text();
  }
  Hash hash;
  hash.add(rendering->color.pixels);
  for (const Layer& layer : rendering->layers) {
    hash.add(layer.image.pixels);
  }
  if (bytes != nullptr) {
    bytes->append(reinterpret_cast<const char*>(rendering->bytes.pixels.data()), rendering->bytes.pixels.size());
  }
  return hash.text();
}

}  // namespace lustro::truth
