// `lustro bench SCENE --frames N`: loads once, draws many pictures of the scene as it turns, and says where the time goes and how far each stage
// is from what the machine can do.
#include <fmt/format.h>

#include <chrono>

#include "app/bench_report.hpp"
#include "app/commands.hpp"
#include "app/cores.hpp"
#include "app/drawing.hpp"
#include "app/progress.hpp"
#include "app/scene_input.hpp"
#include "app/turning.hpp"
#include "math/trig.hpp"
#include "raster/target.hpp"
#include "scene/prepare.hpp"

namespace lustro::app {
namespace {

constexpr double kRadiansAFrame = 0.01;
constexpr int kMostFrames = 1'000'000;

struct BenchFlags {
  std::string scene;
  SceneFlags scene_flags;
  DrawFlags draw_flags;
  int frames = 60;
  int warmup = 3;
  InputFlags input;
};

Result<void> check_flags(const BenchFlags& flags) {
  if (flags.frames < 1 || flags.frames > kMostFrames) {
    return fail(ErrorKind::usage, "--frames", fmt::format("{} is outside 1..{}", flags.frames, kMostFrames));
  }
  if (flags.warmup < 0 || flags.warmup > kMostFrames) {
    return fail(ErrorKind::usage, "--warmup", fmt::format("{} is outside 0..{}", flags.warmup, kMostFrames));
  }
  return {};
}

/// Every frame of the run, `warmup` of them not counted. Each picture is made anew; what is kept is the meshes and their clusters.
Result<void> draw_frames(const Session& session, const BenchFlags& flags, Scene& scene, const RenderOptions& options, BenchReport& report) {
  const std::vector<Mat4> matrices = matrices_of(scene);
  Renderer renderer;
  Rendering picture;
  ProgressBar progress(session, "measuring");
  const auto show = progress.callback();
  const int count = flags.warmup + flags.frames;
  for (int i = 0; i < count; ++i) {
    const double angle = kRadiansAFrame * std::max(0, i - flags.warmup);
    turn_objects(scene, matrices, report.body, sine(angle), cosine(angle));
    const auto start = std::chrono::steady_clock::now();
    const Result<void> drawn = renderer.render(scene, options, picture);
    const double milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (!drawn) {
      return tl::unexpected(placed(drawn.error(), flags.scene, flags.scene_flags));
    }
    if (const Result<void> checked = check_not_empty(flags.scene, scene, picture); !checked) {
      return checked;
    }
    if (i >= flags.warmup) {
      report.frames.push_back({milliseconds, picture.times});
      report.facts.pixels_covered += picture.stats.pixels_covered;
    }
    if (show) {
      show(static_cast<double>(i + 1) / count);
    }
  }
  report.facts.pixels_covered /= static_cast<std::uint64_t>(flags.frames);
  report.notes.insert(report.notes.end(), picture.notes.begin(), picture.notes.end());
  return {};
}

Result<ExitCode> run_bench(const Session& session, const BenchFlags& flags) {
  if (const Result<void> checked = check_flags(flags); !checked) {
    return tl::unexpected(checked.error());
  }
  Result<RenderOptions> options = render_options(session, flags.draw_flags);
  if (!options) {
    return tl::unexpected(options.error());
  }
  options->store_color = false;
  options->store_bytes = true;
  Result<LoadedScene> loaded = load_scene_argument(flags.scene, flags.scene_flags, load_options(session, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  Scene& scene = loaded->scene;
  BenchReport report;
  report.scene = flags.scene;
  report.notes = std::move(loaded->notes);
  report.threads = threads_meant(session.threads);
  report.body = swept_body(scene);
  {
    const Result<PreparedScene> prepared = prepare(scene);  // the first frame's camera stays
    if (!prepared) {
      return tl::unexpected(placed(prepared.error(), flags.scene, flags.scene_flags));
    }
    const Result<Camera> camera = definite_camera(scene.camera, scene.image, prepared->view, report.body);
    if (!camera) {
      return tl::unexpected(placed(camera.error(), flags.scene, flags.scene_flags));
    }
    scene.camera = *camera;
    report.facts.lights = static_cast<int>(prepared->lights.size());
    report.facts.triangles = prepared->triangle_count;
  }
  report.image = scene.image;
  report.camera = scene.camera;
  report.engine = flags.draw_flags.engine;
  const Result<Target> target = choose_target(options->target);
  report.target = target ? std::string(target_name(*target)) : std::string();
  report.facts.shading = scene.shading;
  report.facts.pixels = static_cast<std::uint64_t>(scene.image.width) * static_cast<std::uint64_t>(scene.image.height);
  for (const Object& object : scene.objects) {
    report.facts.vertices += object.mesh->positions.size();
  }
  report.machine = measure_machine(report.threads);
  if (const Result<void> drawn = draw_frames(session, flags, scene, *options, report); !drawn) {
    return tl::unexpected(drawn.error());
  }
  say_warnings(session, report.notes);
  const Result<void> printed = session.json ? print_json(bench_json(report)) : print(bench_text(report));
  return printed.map([] { return ExitCode::success; });
}

}  // namespace

Command make_bench(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "bench",
                                 "Measures how fast a scene is drawn, stage by stage, and how far that is from the machine's limits");
  auto flags = std::make_shared<BenchFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  const std::string group = "Measurement";
  app->add_option("--frames", flags->frames,
                  "Pictures to draw; the scene turns by 0.01 radians about the vertical from each to the next (default: 60)")
      ->type_name("N")
      ->group(group);
  app->add_option("--warmup", flags->warmup, "Pictures to draw before those that count (default: 3)")->type_name("N")->group(group);
  flags->scene_flags = add_scene_flags(*app);
  add_draw_flags(*app, flags->draw_flags, flags->scene_flags, PathFlags::none);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro bench bunny.ply --size 1920x1080 --samples 1", "median and best of 60 frames"},
           {"lustro bench scene.json --frames 200 --threads 1 --target avx2 --json", "another setting, for a script"}},
          [&session, flags] { return run_bench(session, *flags); }};
}

}  // namespace lustro::app
