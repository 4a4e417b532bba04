// Any change of any bit is seen: the hash of every scene of the tree stands in golden_hashes.txt. The hashes are of float bits, so equal hashes
// under GCC and Clang, -O0 and -O3, one thread and several, prove the promise of equal bits.
//
// After a change that is meant:  LUSTRO_UPDATE_GOLDENS=1 build/release/tests/test_truth --gtest_filter='Golden.*'
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include "lustro/lustro.hpp"
#include "truth/golden_hash.hpp"
#include "truth/scene_tree.hpp"

namespace lustro::truth {
namespace {

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
      out << golden_hash(entry.scene, {.engine = Engine::reference}) << ' ' << entry.name << '\n';
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
      const std::string hash = golden_hash(entry->scene, {.threads = threads, .engine = engine});
      if (hash != golden->second && ++changed <= 10) {
        ADD_FAILURE() << entry->name << (engine == Engine::raster ? " (raster): " : ": ") << hash << ", was " << golden->second;
      }
    }
  }
  EXPECT_EQ(changed, 0) << "scenes changed; if that was meant, see the top of " << __FILE__;
}

}  // namespace
}  // namespace lustro::truth
