// `lustro turntable SCENE -o OUT`: the scene turns once about the vertical before a camera that sees all of it, as an animation or frame by
// frame.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <optional>

#include "app/commands.hpp"
#include "app/drawing.hpp"
#include "app/frame_sink.hpp"
#include "app/json_out.hpp"
#include "app/progress.hpp"
#include "app/scene_input.hpp"
#include "app/turning.hpp"
#include "app/words.hpp"
#include "math/trig.hpp"

namespace lustro::app {
namespace {

struct TurntableFlags {
  std::string scene;
  SceneFlags scene_flags;
  DrawFlags draw_flags;
  PngFlags png;
  std::string output;
  std::optional<int> frames;
  std::optional<double> seconds;
  std::optional<double> frames_per_second;
  std::string orbit = "object";
  int quality = 90;
  InputFlags input;
};

/// Two of number, time and rate make the third.
struct Timing {
  int frames = 0;
  double frames_per_second = 0;
};

Result<Timing> timing_of(const TurntableFlags& flags) {
  constexpr int kMostFrames = 36000, kUsualFrames = 60;
  constexpr double kUsualRate = 30, kMostRate = 1000, kMostSeconds = 3600;
  if (flags.seconds && !(*flags.seconds > 0 && *flags.seconds <= kMostSeconds)) {
    return fail(ErrorKind::usage, "--seconds", fmt::format("{} is not more than 0 and at most {}", *flags.seconds, kMostSeconds));
  }
  if (flags.frames_per_second && !(*flags.frames_per_second > 0 && *flags.frames_per_second <= kMostRate)) {
    return fail(ErrorKind::usage, "--fps", fmt::format("{} is not more than 0 and at most {}", *flags.frames_per_second, kMostRate));
  }
  if (flags.frames && flags.seconds && flags.frames_per_second) {
    return fail(ErrorKind::usage, "--frames", "two of --frames, --seconds and --fps make the third");
  }
  Timing timing;
  if (flags.seconds && !flags.frames) {
    timing.frames_per_second = flags.frames_per_second.value_or(kUsualRate);
    timing.frames = static_cast<int>(std::min(std::max(std::round(*flags.seconds * timing.frames_per_second), 1.0), 1e9));
  } else {
    timing.frames = flags.frames.value_or(kUsualFrames);
    timing.frames_per_second = flags.seconds ? timing.frames / *flags.seconds : flags.frames_per_second.value_or(kUsualRate);
  }
  if (timing.frames < 1 || timing.frames > kMostFrames) {
    return fail(ErrorKind::usage, flags.frames ? "--frames" : "--seconds",
                fmt::format("{} frames are outside 1..{}", timing.frames, kMostFrames));
  }
  return timing;
}

/// The camera from which the whole turn is seen; where the eye is stated, that one.
Result<Camera> camera_of_turn(const Scene& scene, const SweptBody& body) {
  const Result<View> view = make_view(scene.camera, scene.image, extent_of(body));
  Result<Camera> camera = view ? definite_camera(scene.camera, scene.image, *view, body) : tl::unexpected(view.error());
  if (camera && scene.ground) {  // which reaches farther than the body
    camera->near = scene.camera.near;
    camera->far = scene.camera.far;
  }
  return camera;
}

/// The scene at one of the angles. An orbiting camera goes the other way round, so that the object is seen from the same sides.
void turn(Scene& scene, const Camera& camera, const std::vector<Mat4>& matrices, const SweptBody& body, double degrees, bool camera_orbits) {
  const double sine = sine_deg(degrees), cosine = cosine_deg(degrees);
  if (!camera_orbits) {
    turn_objects(scene, matrices, body, sine, cosine);
    return;
  }
  scene.camera.eye = turned(*camera.eye, body, -sine, cosine);
  scene.camera.target = turned(*camera.target, body, -sine, cosine);
  const SweptBody at_origin{};
  scene.camera.up = turned(*camera.up, at_origin, -sine, cosine);
}

Json turntable_json(const TurntableFlags& flags, const Scene& scene, const Timing& timing, const std::vector<std::string>& written,
                    const Notes& notes) {
  return {{"scene", flags.scene},
          {"outputs", written},
          {"frames", timing.frames},
          {"frames_per_second", timing.frames_per_second},
          {"seconds", timing.frames / timing.frames_per_second},
          {"width", scene.image.width},
          {"height", scene.image.height},
          {"notes", json_notes(notes)}};
}

Result<Notes> draw_turn(const Session& session, const TurntableFlags& flags, Scene& scene, const RenderOptions& options, const Timing& timing,
                        const FrameSink& sink) {
  const SweptBody body = swept_body(scene);
  const Result<Camera> camera = camera_of_turn(scene, body);
  if (!camera) {
    return tl::unexpected(placed(camera.error(), flags.scene, flags.scene_flags));
  }
  scene.camera = *camera;
  settle_for_turn(scene, body);
  const std::vector<Mat4> matrices = matrices_of(scene);
  Renderer renderer;
  Rendering picture;
  RenderStats seen;
  ProgressBar progress(session, "drawing");
  const auto show = progress.callback();
  for (int i = 0; i < timing.frames; ++i) {
    turn(scene, *camera, matrices, body, 360.0 * i / timing.frames, flags.orbit == "camera");
    if (const Result<void> drawn = renderer.render(scene, options, picture); !drawn) {
      return tl::unexpected(placed(drawn.error(), flags.scene, flags.scene_flags));
    }
    seen.pixels_covered += picture.stats.pixels_covered;
    seen.triangles = picture.stats.triangles;
    if (const Result<void> added = sink.add(picture.bytes); !added) {
      return tl::unexpected(added.error());
    }
    if (show) {
      show(static_cast<double>(i + 1) / timing.frames);
    }
  }
  if (seen.pixels_covered == 0) {
    return fail(ErrorKind::empty, flags.scene, "nothing was drawn in any frame");
  }
  return picture.notes;
}

Result<ExitCode> run_turntable(const Session& session, const TurntableFlags& flags) {
  const auto start = std::chrono::steady_clock::now();
  const Result<Timing> timing = timing_of(flags);
  if (!timing) {
    return tl::unexpected(timing.error());
  }
  if (flags.quality < 0 || flags.quality > 100) {
    return fail(ErrorKind::usage, "--quality", fmt::format("{} is outside 0..100", flags.quality));
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
  const AnimationOptions animation{.width = scene.image.width,
                                   .height = scene.image.height,
                                   .frames = timing->frames,
                                   .frames_per_second = timing->frames_per_second,
                                   .has_alpha = scene.image.transparent || scene.image.background_alpha < 1,
                                   .transfer = scene.image.transfer,
                                   .quality = flags.quality,
                                   .threads = session.threads};
  const Result<FrameSink> sink = make_frame_sink(flags.output, animation, flags.png);
  if (!sink) {
    return tl::unexpected(sink.error());
  }
  Notes notes = std::move(loaded->notes);
  const Result<Notes> drawn = draw_turn(session, flags, scene, *options, *timing, *sink);
  if (drawn) {
    notes.insert(notes.end(), drawn->begin(), drawn->end());
  }
  say_warnings(session, notes);
  if (!drawn) {
    return tl::unexpected(drawn.error());
  }
  const Result<std::vector<std::string>> written = sink->finish();
  if (!written) {
    return tl::unexpected(written.error());
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say(session, fmt::format("wrote {} ({}, {} x {}, {:.4g} a second, {:.2f} s)", flags.output,
                           counted(static_cast<std::uint64_t>(timing->frames), "frame", "frames"), scene.image.width, scene.image.height,
                           timing->frames_per_second, seconds));
  if (session.json) {
    return print_json(turntable_json(flags, scene, *timing, *written, notes)).map([] { return ExitCode::success; });
  }
  return ExitCode::success;
}

}  // namespace

Command make_turntable(CommandLine& line, Session& session) {
  CLI::App* app =
      add_subcommand(line, session, "turntable", "Turns a scene once about the vertical: an animation, a film, or a folder of frames");
  auto flags = std::make_shared<TurntableFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  const std::string output = "Output", turn = "Turn";
  app->add_option("-o,--output", flags->output,
                  "The animation: .apng (or .png), .webp, .gif, .mp4 (where ffmpeg is installed); a name without extension is a folder of "
                  "frame_0001.png, ...")
      ->type_name("FILE")
      ->required()
      ->group(output);
  app->add_option("--quality", flags->quality, "Of WebP, 0..100; 100 is without loss (default: 90)")->type_name("N")->group(output);
  app->add_option("--png-level", flags->png.png_level,
                  "Compression of a folder's PNG, 0 (none) to 12 (small and slow) (default: a fast packer of Lustro's own)")
      ->type_name("N")
      ->group(output);
  app->add_option("--frames", flags->frames, "Pictures of the whole turn (default: 60)")->type_name("N")->group(turn);
  app->add_option("--seconds", flags->seconds, "How long the turn takes (default: the frames at 30 a second)")->type_name("S")->group(turn);
  app->add_option("--fps", flags->frames_per_second, "Frames a second (default: 30)")->type_name("F")->group(turn);
  one_of(
      app->add_option("--orbit", flags->orbit,
                      "What goes round: the object, counter-clockwise seen from above, before lights that stand; or the camera, the other way "
                      "(default: object)"),
      {"object", "camera"})
      ->group(turn);
  flags->scene_flags = add_scene_flags(*app);
  add_draw_flags(*app, flags->draw_flags, flags->scene_flags, PathFlags::without_seconds);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro turntable bunny.ply -o bunny.webp --size 480x480 --seconds 4", "a small animation for a page"},
           {"lustro turntable scene.json -o frames --frames 240", "frames/frame_0001.png and so on, for a film"},
           {"lustro turntable part.stl -o part.apng --transparent --orbit camera", "without loss, with transparency, before lights that stand"}},
          [&session, flags] { return run_turntable(session, *flags); }};
}

}  // namespace lustro::app
