// bench_threads SUBJECT [SECONDS]: two threads against one. The bytes are compared first: they must be equal.
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "common/frames.hpp"
#include "common/measure.hpp"

int main(int argc, char** argv) {
  using namespace lustro::bench;
  const Subject* subject = argc > 1 ? find_subject(argv[1]) : nullptr;
  if (subject == nullptr) {
    std::fprintf(stderr, "usage: bench_threads SUBJECT [SECONDS]\n");
    return 2;
  }
  try {
    const lustro::Scene scene = common_scene(*subject, 1);
    OurFrames one(*subject, scene, 1);
    OurFrames two(*subject, scene, 2);
    const std::string key = "threads/" + subject->name;
    if (one.draw(7).bytes.pixels != two.draw(7).bytes.pixels) {
      report_failure(key, "one thread and two draw different bytes");
      return 1;
    }
    const std::vector<Side> sides{{"two", [&](int i) { two.draw(i); }}, {"one", [&](int i) { one.draw(i); }}};
    report(key, "equal bytes", sides, in_turns(sides, {.most_seconds = argc > 2 ? std::atof(argv[2]) : 20}));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_threads: %s\n", e.what());
    return 1;
  }
  return 0;
}
