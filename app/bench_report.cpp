// The benchmark's table and JSON: see bench_report.hpp.
#include "bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report.hpp"

namespace lustro::app {
namespace {

/// The middle one and the smallest; for an even number the mean of the two in the middle.
struct Statistics {
  double median = 0, min = 0;
};

template <class Value>
Statistics statistics(const std::vector<FrameTimes>& frames, const Value& value) {
  std::vector<double> sorted;
  sorted.reserve(frames.size());
  for (const FrameTimes& frame : frames) {
    sorted.push_back(value(frame));
  }
  std::sort(sorted.begin(), sorted.end());
  const std::size_t n = sorted.size();
  return n == 0 ? Statistics{} : Statistics{(sorted[(n - 1) / 2] + sorted[n / 2]) / 2, sorted.front()};
}

struct Stage {
  const char* name;
  double RenderTimes::*time;
  StageWork (*work)(const FrameFacts&);  ///< null: nothing that the machine limits
};

constexpr std::array<Stage, 4> kStages{{
    {"prepare", &RenderTimes::prepare, nullptr},
    {"cull", &RenderTimes::cull, cull_work},
    {"visibility", &RenderTimes::visibility, visibility_work},
    {"shading", &RenderTimes::shading, shading_work},
}};

/// The least time that the machine needs for the work, and which of its two limits says so.
struct Limit {
  double milliseconds = 0;
  bool is_memory = false;
};

Limit limit_of(const StageWork& work, const MachineLimits& machine) {
  const double memory = work.bytes / machine.copy_bytes_per_second * 1e3;
  const double arithmetic = work.operations / machine.operations_per_second * 1e3;
  return {std::max(memory, arithmetic), memory > arithmetic};
}

double per_second(std::uint64_t count, double milliseconds) {
  return milliseconds > 0 ? static_cast<double>(count) / milliseconds * 1e3 : 0;
}

Json json_statistics(const Statistics& s) {
  return {{"median", s.median}, {"min", s.min}};
}

std::string scaled(double value, const char* unit) {
  const char* prefix = "";
  for (const char* next : {"k", "M", "G", "T"}) {
    if (value < 1000) {
      break;
    }
    value /= 1000;
    prefix = next;
  }
  return fmt::format("{:.3g} {}{}", value, prefix, unit);
}

}  // namespace

std::string bench_text(const BenchReport& report) {
  std::string text =
      fmt::format("{}: {}, {} x {} pixels, {}, {}, {} ({})\n", report.scene, counted(report.facts.triangles, "triangle", "triangles"),
                  report.image.width, report.image.height, counted(static_cast<std::uint64_t>(report.image.samples), "sample", "samples"),
                  counted(static_cast<std::uint64_t>(report.threads), "thread", "threads"), report.engine, report.target);
  text += fmt::format("{:<12}{:>12}{:>12}{:>14}{:>10}  {}\n", "ms", "median", "min", "machine needs", "reached", "limited by");
  const Statistics frame = statistics(report.frames, [](const FrameTimes& f) { return f.frame; });
  text += fmt::format("{:<12}{:>12.3f}{:>12.3f}\n", "frame", frame.median, frame.min);
  for (const Stage& stage : kStages) {
    const Statistics s = statistics(report.frames, [&](const FrameTimes& f) { return f.stages.*stage.time; });
    text += fmt::format("  {:<10}{:>12.3f}{:>12.3f}", stage.name, s.median, s.min);
    if (stage.work != nullptr && s.median > 0) {
      const StageWork work = stage.work(report.facts);
      const Limit limit = limit_of(work, report.machine);
      text += fmt::format("{:>14.3f}{:>9.0f}%  {}", limit.milliseconds, limit.milliseconds / s.median * 100,
                          limit.is_memory ? "memory, " + scaled(work.bytes, "B") : "arithmetic, " + scaled(work.operations, "operations"));
    }
    text += "\n";
  }
  text +=
      fmt::format("{} triangles and {} pixels a second, {} of {} pixels covered\n", scaled(per_second(report.facts.triangles, frame.median), ""),
                  scaled(per_second(report.facts.pixels, frame.median), ""), grouped(report.facts.pixels_covered), grouped(report.facts.pixels));
  text += fmt::format("this machine, measured now with as many threads: copies {}/s, multiplies and adds {}/s\n",
                      scaled(report.machine.copy_bytes_per_second, "B"), scaled(report.machine.operations_per_second, "operations"));
  return text;
}

Json bench_json(const BenchReport& report) {
  const Statistics frame = statistics(report.frames, [](const FrameTimes& f) { return f.frame; });
  Json stages = Json::object(), limits = Json::object();
  for (const Stage& stage : kStages) {
    const Statistics s = statistics(report.frames, [&](const FrameTimes& f) { return f.stages.*stage.time; });
    stages[stage.name] = json_statistics(s);
    if (stage.work != nullptr) {
      const StageWork work = stage.work(report.facts);
      const Limit limit = limit_of(work, report.machine);
      limits[stage.name] = {{"bytes", work.bytes},
                            {"operations", work.operations},
                            {"limited_by", limit.is_memory ? "memory" : "arithmetic"},
                            {"limit_ms", limit.milliseconds},
                            {"share", s.median > 0 ? Json(limit.milliseconds / s.median) : Json(nullptr)}};
    }
  }
  Json all = Json::array();
  for (const FrameTimes& f : report.frames) {
    all.push_back(f.frame);
  }
  return {{"scene", report.scene},
          {"frames", report.frames.size()},
          {"frame_ms", json_statistics(frame)},
          {"stages_ms", std::move(stages)},
          {"triangles_per_second", per_second(report.facts.triangles, frame.median)},
          {"pixels_per_second", per_second(report.facts.pixels, frame.median)},
          {"triangles", report.facts.triangles},
          {"vertices", report.facts.vertices},
          {"width", report.image.width},
          {"height", report.image.height},
          {"samples", report.image.samples},
          {"pixels_covered", report.facts.pixels_covered},
          {"lights", report.facts.lights},
          {"threads", report.threads},
          {"engine", report.engine},
          {"target", report.target},
          {"machine",
           {{"copy_bytes_per_second", report.machine.copy_bytes_per_second}, {"operations_per_second", report.machine.operations_per_second}}},
          {"limits", std::move(limits)},
          {"camera",
           {{"eye", json_vector(*report.camera.eye)},
            {"target", json_vector(*report.camera.target)},
            {"up", json_vector(*report.camera.up)},
            {"fov", report.camera.fov},
            {"height", report.camera.height ? Json(*report.camera.height) : Json(nullptr)},
            {"near", *report.camera.near},
            {"far", *report.camera.far}}},
          {"turned_about", json_vector(report.body.center)},
          {"all_frames_ms", std::move(all)},
          {"notes", json_notes(report.notes)}};
}

}  // namespace lustro::app
