// Draws the tree of scenes, or scene and mesh files, by the reference or by a row of kernels, and prints a line `HASH NAME` for each picture. It
// links the core alone, so that it can be built for any processor: tests/portable/check compares what it prints there with the hashes in the
// repository.
//
//   portable_hashes rows                  the reference, and the rows that this build has and this machine can run
//   portable_hashes ROW tree N            every N-th scene of tests/truth/scene_tree.hpp
//   portable_hashes ROW FILE...           each file at 160 x 120
//   portable_hashes ROW frames N FILE...  no hashes: the least milliseconds of N pictures of 1920 x 1080 on one thread
#include <algorithm>
#include <chrono>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include "image/hash.hpp"
#include "lustro/lustro.hpp"
#include "truth/golden_hash.hpp"
#include "truth/scene_tree.hpp"

namespace {

using lustro::Engine;
using lustro::RenderOptions;
using lustro::Target;

constexpr std::size_t kBytesStride = 20;  ///< of how many scenes of the tree one's stored bytes are compared too

/// Who draws: `reference`, or a row that this machine can run.
lustro::Result<RenderOptions> painter(const std::string& row) {
  if (row == "reference") {
    return RenderOptions{.engine = Engine::reference};
  }
  return lustro::parse_target(row).map([](Target target) { return RenderOptions{.target = target}; });
}

std::string hash_of_text(const std::string& text) {
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016" PRIx64, lustro::xxh64(std::as_bytes(std::span(text)), 0));
  return digits;
}

void print_line(const std::string& hash, const std::string& name) {
  std::printf("%s %s\n", hash.c_str(), name.c_str());
}

int hash_tree(const RenderOptions& how, std::size_t stride) {
  RenderOptions options = how;
  options.threads = 0;
  const std::vector<lustro::truth::TreeScene>& tree = lustro::truth::scene_tree();
  for (std::size_t i = 0; i < tree.size(); i += stride) {
    options.threads = options.threads % 3 + 1;
    std::string bytes;
    print_line(lustro::truth::golden_hash(tree[i].scene, options, &bytes), tree[i].name);
    if (i % kBytesStride == 0) {
      print_line(hash_of_text(bytes), tree[i].name + ":bytes");
    }
  }
  return 0;
}

/// What cannot be loaded is its message, which is the same everywhere too.
int hash_file(const RenderOptions& options, const std::string& file) {
  const lustro::Result<lustro::LoadedScene> loaded = lustro::load_scene(file);
  if (!loaded) {
    print_line(hash_of_text(loaded.error().text()), file);
    return 0;
  }
  lustro::Scene scene = loaded->scene;
  scene.image.width = 160;
  scene.image.height = 120;
  std::string bytes;
  const std::string hash = lustro::truth::golden_hash(scene, options, &bytes);
  print_line(bytes.empty() ? hash_of_text(hash) : hash, file);
  print_line(hash_of_text(bytes), file + ":bytes");
  return 0;
}

int time_frames(const RenderOptions& how, int count, const std::string& file) {
  lustro::Result<lustro::LoadedScene> loaded = lustro::load_scene(file);
  if (!loaded) {
    std::fprintf(stderr, "%s\n", loaded.error().text().c_str());
    return 1;
  }
  loaded->scene.image.width = 1920;
  loaded->scene.image.height = 1080;
  RenderOptions options = how;
  options.threads = 1;
  options.store_color = false;
  options.store_bytes = true;
  lustro::Renderer renderer;
  lustro::Rendering rendering;
  std::vector<double> times;
  for (int i = 0; i < count; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    if (const auto drawn = renderer.render(loaded->scene, options, rendering); !drawn) {
      std::fprintf(stderr, "%s\n", drawn.error().text().c_str());
      return 1;
    }
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
  }
  std::printf("%8.1f ms  %s\n", *std::min_element(times.begin(), times.end()), file.c_str());
  return 0;
}

int run(const std::vector<std::string>& words) {
  const lustro::Result<RenderOptions> options = painter(words[0]);
  if (!options) {
    std::fprintf(stderr, "%s\n", options.error().text().c_str());
    return 2;
  }
  const int count = words.size() > 2 ? std::max(std::atoi(words[2].c_str()), 1) : 1;
  if (words[1] == "tree") {
    return hash_tree(*options, static_cast<std::size_t>(count));
  }
  const bool frames = words[1] == "frames" && words.size() > 3;
  int worst = 0;
  for (auto file = words.begin() + (frames ? 3 : 1); file != words.end(); ++file) {
    worst = std::max(worst, frames ? time_frames(*options, count, *file) : hash_file(*options, *file));
  }
  return worst;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() == 1 && words[0] == "rows") {
    std::printf("reference\n");
    for (const Target target : lustro::available_targets()) {
      std::printf("%s\n", std::string(lustro::target_name(target)).c_str());
    }
    return 0;
  }
  if (words.size() < 2) {
    std::fprintf(stderr, "usage: portable_hashes rows | ROW tree N | ROW FILE... | ROW frames N FILE...\n");
    return 2;
  }
  return run(words);
}
