// bench_shadows SUBJECT [SECONDS]: a frame with shadows beside the same frame without, one directional light, a map of 2048 texels a side. The
// picture is checked first: the reference draws the same floats.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "common/frames.hpp"
#include "common/measure.hpp"

int main(int argc, char** argv) {
  using namespace lustro::bench;
  const Subject* subject = argc > 1 ? find_subject(argv[1]) : nullptr;
  if (subject == nullptr) {
    std::fprintf(stderr, "usage: bench_shadows SUBJECT [SECONDS]\n");
    return 2;
  }
  try {
    lustro::Scene scene = common_scene(*subject, 1);
    scene.lights->resize(1);
    scene.lights->front().direction = {-1, -0.35, -0.3};  // low enough for the subject to throw a shadow on itself
    OurFrames without(*subject, scene);
    scene.shadow.emplace();
    OurFrames with(*subject, scene);
    lustro::Scene still = scene;
    still.objects[0].matrix = turned(*subject, 7);
    const auto reference = lustro::render(still, {.engine = lustro::Engine::reference, .store_bytes = true});
    const std::string key = "shadows/" + subject->name;
    if (!reference || reference->bytes.pixels != with.draw(7).bytes.pixels) {
      report_failure(key, "the reference draws other bytes");
      return 1;
    }
    const double changed = share_that_differs(with.draw(7).bytes, without.draw(7).bytes);
    if (!(changed > 0.005)) {
      report_failure(key, "there are no shadows");
      return 1;
    }
    const std::vector<Side> sides{{"with", [&](int i) { with.draw(i); }}, {"without", [&](int i) { without.draw(i); }}};
    const std::vector<Times> times = in_turns(sides, {.most_seconds = argc > 2 ? std::atof(argv[2]) : 20});
    report(key, "bytes of the reference", sides, times);
    for (OurFrames* frames : {&with, &without}) {
      const lustro::RenderTimes& spent = frames->draw(7).times;
      std::fprintf(stderr, "a frame %s shadows: maps %.2f ms, visibility %.2f ms, shading %.2f ms, in all %.2f ms\n",
                   frames == &with ? "with" : "without", spent.shadows, spent.visibility, spent.shading, spent.total);
    }
    std::fprintf(stderr, "with shadows %.2f times the frame without\n", times[0].median_ms / times[1].median_ms);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_shadows: %s\n", e.what());
    return 1;
  }
  return 0;
}
