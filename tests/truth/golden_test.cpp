// Any change of any bit is seen: the hash of every scene of the tree stands in golden_hashes.txt. The hashes are of float bits, so equal hashes
// under GCC and Clang, -O0 and -O3, one thread and several, prove the promise of equal bits.
//
// After a change that is meant:  LUSTRO_UPDATE_GOLDENS=1 build/release/tests/test_truth --gtest_filter='Golden.*'
#include <gtest/gtest.h>

#include <bit>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "lustro/lustro.hpp"
#include "truth/scene_tree.hpp"

namespace lustro::truth {
namespace {

/// FNV-1a (Fowler, Noll, Vo), 64 bits, over 32-bit words.
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

std::string hash_of(const Scene& scene, int threads, Engine engine) {
  RenderOptions options;
  options.engine = engine;
  options.threads = threads;
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
  return hash.text();
}

std::filesystem::path golden_file() {
  return std::filesystem::path(LUSTRO_SOURCE_DIR) / "tests" / "truth" / "golden_hashes.txt";
}

std::map<std::string, std::string> read_goldens() {
  std::map<std::string, std::string> goldens;
  std::ifstream in(golden_file());
  std::string hash;
  std::string name;
  while (in >> hash >> name) {
    goldens[name] = hash;
  }
  return goldens;
}

TEST(Golden, EverySceneHasTheBitsThatItHad) {
  if (std::getenv("LUSTRO_UPDATE_GOLDENS") != nullptr) {
    std::ofstream out(golden_file());
    for (const TreeScene& entry : scene_tree()) {
      out << hash_of(entry.scene, 0, Engine::reference) << ' ' << entry.name << '\n';
    }
    GTEST_SKIP() << "wrote " << golden_file();
  }
  const std::map<std::string, std::string> goldens = read_goldens();
  ASSERT_EQ(goldens.size(), scene_tree().size()) << "names must be unique, and every scene must have its hash";
  int changed = 0;
  int threads = 0;
  for (const TreeScene* entry : chosen_scenes()) {
    threads = threads % 4 + 1;
    const auto golden = goldens.find(entry->name);
    ASSERT_NE(golden, goldens.end()) << entry->name << " has no hash in " << golden_file();
    for (const Engine engine : {Engine::reference, Engine::raster}) {
      const std::string hash = hash_of(entry->scene, threads, engine);
      if (hash != golden->second && ++changed <= 10) {
        ADD_FAILURE() << entry->name << (engine == Engine::raster ? " (raster): " : ": ") << hash << ", was " << golden->second;
      }
    }
  }
  EXPECT_EQ(changed, 0) << "scenes changed; if that was meant, see the top of " << __FILE__;
}

}  // namespace
}  // namespace lustro::truth
