// What `lustro bench` measured, as a table and as JSON.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "json_out.hpp"
#include "lustro/render.hpp"
#include "machine.hpp"
#include "stage_work.hpp"
#include "turning.hpp"

namespace lustro::app {

/// Milliseconds of one picture.
struct FrameTimes {
  double frame = 0;  ///< from the scene to the bytes, by the caller's clock
  RenderTimes stages;
};

struct BenchReport {
  std::string scene;
  ImageSettings image;
  Camera camera;   ///< as all frames had it
  SweptBody body;  ///< about whose axis the scene turned
  std::string engine, target;
  int threads = 1;
  FrameFacts facts;
  MachineLimits machine;
  std::vector<FrameTimes> frames;
  Notes notes;
};

[[nodiscard]] std::string bench_text(const BenchReport& report);
[[nodiscard]] Json bench_json(const BenchReport& report);

}  // namespace lustro::app
