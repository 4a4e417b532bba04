// `lustro render SCENE|MESH -o OUT`: draws a scene. Its flags for the scene come from the table of options.
#include "lustro/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>

#include "app/commands.hpp"
#include "app/drawing.hpp"
#include "app/hash_text.hpp"
#include "app/json_out.hpp"
#include "app/outputs.hpp"
#include "app/scene_input.hpp"

namespace lustro::app {
namespace {

struct RenderFlags {
  std::string scene;
  SceneFlags scene_flags;
  DrawFlags draw_flags;
  std::vector<std::string> outputs;
  std::string expected_hash;
  std::string aovs;
  PngFlags png;
  bool allow_empty = false;
  InputFlags input;
  bool print_scene = false;
};

Result<void> check_flags(const Session& session, const RenderFlags& flags) {
  const bool to_stdout = std::find(flags.outputs.begin(), flags.outputs.end(), kStdout) != flags.outputs.end();
  if (to_stdout && (session.json || flags.print_scene)) {
    return fail(ErrorKind::usage, "-o -",
                fmt::format("the picture and the text of {} cannot both go to standard output", session.json ? "--json" : "--print-scene"));
  }
  return write_options(flags.png, Transfer::srgb, session.threads).map([](const WriteOptions&) {});
}

/// The file of --resume is a file of its own.
Result<void> check_resume(const std::filesystem::path& resume, const std::vector<std::string>& outputs) {
  if (resume == kStdout) {
    return fail(ErrorKind::usage, "--resume", "found -, expected a file");
  }
  const auto place = [](const std::filesystem::path& file) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file, ignored), ignored);
  };
  const auto same = [&](const std::string& output) { return !resume.empty() && place(output) == place(resume); };
  const auto found = std::ranges::find_if(outputs, same);
  return found == outputs.end() ? Result<void>() : fail(ErrorKind::usage, "--resume", fmt::format("{} is where the picture is written", *found));
}

/// `hash` stands there only where one was asked for.
Json render_json(const RenderFlags& flags, const Scene& scene, const Rendering& rendering, const std::vector<std::string>& written,
                 const Notes& notes, const std::optional<std::uint64_t>& hash) {
  Json json{{"scene", flags.scene},
            {"outputs", written},
            {"width", scene.image.width},
            {"height", scene.image.height},
            {"samples", scene.image.samples},
            {"triangles", rendering.stats.triangles},
            {"pixels_covered", rendering.stats.pixels_covered},
            {"notes", json_notes(notes)}};
  if (rendering.stats.samples > 0) {
    json["paths"] = {{"samples", rendering.stats.samples},
                     {"resumed", rendering.stats.samples_resumed},
                     {"rays", rendering.stats.rays},
                     {"error", rendering.stats.samples > 1 ? Json(rendering.stats.error) : nullptr}};
  }
  if (hash) {
    json["hash"] = hash_text(*hash);
  }
  return json;
}

/// A line for each picture, and one for all their layers.
void say_what_was_written(const Session& session, const std::vector<std::string>& outputs, const std::vector<std::string>& written,
                          const ImageSettings& image, const Rendering& rendering, double seconds) {
  const RenderStats& stats = rendering.stats;
  const std::string resumed = stats.samples_resumed > 0 ? fmt::format(" ({} of them from before)", stats.samples_resumed) : "";
  // One path alone does not say how far it is from the next.
  const std::string error = stats.samples > 1 ? fmt::format(", error {:.2g} %", stats.error * 100) : "";
  const std::string paths =
      stats.samples > 0 ? fmt::format(", {} path{} a pixel{}{}", stats.samples, stats.samples == 1 ? "" : "s", resumed, error) : "";
  std::string layers;
  for (const std::string& file : written) {
    if (std::find(outputs.begin(), outputs.end(), file) == outputs.end()) {
      layers += (layers.empty() ? "" : ", ") + file;
    } else if (file != kStdout) {
      say(session, fmt::format("wrote {} ({} x {}, {}{}, {:.2f} s)", file, image.width, image.height,
                               counted(rendering.stats.triangles, "triangle", "triangles"), paths, seconds));
    }
  }
  if (!layers.empty()) {
    say(session, fmt::format("wrote its layers {}", layers));
  }
}

/// While paths are followed their picture is written from time to time, as a whole, where the last one will be. Not to standard output or a
/// pipe, not while there is nothing in it, and not where a hash says what may be written. What kept one from being written is in `failure`, in
/// the words of writing.
void write_previews(const RenderFlags& flags, const std::vector<std::string>& outputs, const WriteOptions& write, PathOptions& path,
                    std::optional<Error>& failure) {
  const std::vector<std::string> files = rewritable_outputs(outputs);
  if (files.empty() || !(path.preview_seconds > 0) || !flags.expected_hash.empty()) {
    return;
  }
  path.preview = [files, write, &failure](const Rendering& rendering) -> Result<void> {
    if (rendering.stats.pixels_covered == 0) {
      return {};
    }
    const Result<std::vector<std::string>> written = write_outputs(files, rendering, write);
    if (!written) {
      failure = written.error();
      return tl::unexpected(written.error());
    }
    return {};
  };
}

Result<ExitCode> run_render(const Session& session, const RenderFlags& flags) {
  if (const Result<void> checked = check_flags(session, flags); !checked) {
    return tl::unexpected(checked.error());
  }
  Result<RenderOptions> options = render_options(session, flags.draw_flags, flags.aovs);
  if (!options) {
    return tl::unexpected(options.error());
  }
  std::optional<std::uint64_t> expected;
  if (!flags.expected_hash.empty()) {
    const Result<std::uint64_t> parsed = parse_hash(flags.expected_hash);
    if (!parsed) {
      return fail(parsed.error().kind, "--expect-hash", parsed.error().message);
    }
    expected = *parsed;
  }
  Result<LoadedScene> loaded = load_scene_argument(flags.scene, flags.scene_flags, load_options(session, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  const Scene& scene = loaded->scene;
  if (flags.print_scene) {
    say_warnings(session, loaded->notes);
    return print(scene_json(scene) + "\n").map([] { return ExitCode::success; });
  }
  const bool is_named = !flags.outputs.empty();
  const std::vector<std::string> outputs = is_named ? flags.outputs : std::vector<std::string>{default_output(flags.scene)};
  if (const Result<void> checked = check_outputs(outputs); !checked) {
    return tl::unexpected(checked.error());
  }
  if (const Result<void> checked = is_named ? Result<void>() : check_default_output(outputs.front()); !checked) {
    return tl::unexpected(checked.error());
  }
  if (const Result<void> checked = check_resume(flags.draw_flags.path.resume, outputs); !checked) {
    return tl::unexpected(checked.error());
  }

  draw_what_is_written(outputs, flags.png, *options);
  options->store_color = options->store_color || expected.has_value();
  const WriteOptions write = *write_options(flags.png, scene.image.transfer, session.threads, scene.image.tone);
  std::optional<Error> unwritten;
  write_previews(flags, outputs, write, options->path, unwritten);

  const auto start = std::chrono::steady_clock::now();
  Notes notes = std::move(loaded->notes);
  const Result<Rendering> rendering = draw_scene(session, flags.scene, scene, flags.scene_flags, *std::move(options), flags.allow_empty);
  if (rendering) {
    notes.insert(notes.end(), rendering->notes.begin(), rendering->notes.end());
  }
  say_warnings(session, notes);
  if (!rendering) {
    return tl::unexpected(unwritten ? *unwritten : rendering.error());
  }
  std::optional<std::uint64_t> hash;
  if (expected) {
    hash = hash_image(rendering->color);
    if (*hash != *expected) {
      say_error(fmt::format("{}: the picture's hash is {}, and {} was expected; nothing is written", flags.scene, hash_text(*hash),
                            hash_text(*expected)));
      const Result<void> printed = session.json ? print_json(render_json(flags, scene, *rendering, {}, notes, hash)) : Result<void>{};
      return printed.map([] { return ExitCode::different; });
    }
  }

  const Result<std::vector<std::string>> written = write_outputs(outputs, *rendering, write);
  if (!written) {
    return tl::unexpected(written.error());
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say_what_was_written(session, outputs, *written, scene.image, *rendering, seconds);
  if (session.json) {
    return print_json(render_json(flags, scene, *rendering, *written, notes, hash)).map([] { return ExitCode::success; });
  }
  return ExitCode::success;
}

}  // namespace

Command make_render(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "render", "Draws a scene or a mesh; flags override what the scene file says");
  auto flags = std::make_shared<RenderFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  const std::string output = "Output";
  app->add_option("-o,--output", flags->outputs,
                  "The picture: .png, .exr or .pfm; - is a PNG on standard output (default: the mesh's name with .png, beside it)")
      ->type_name("FILE")
      ->group(output)
      ->expected(-1)
      ->allow_extra_args(false);
  app->add_option(
         "--aov", flags->aovs,
         "Layers beside the picture, separated by commas: " + aov_list() + ". An .exr holds them all; out.png brings out.NAME.png for each")
      ->type_name("LIST")
      ->group(output);
  add_png_flags(*app, flags->png, output);
  app->add_option("--expect-hash", flags->expected_hash,
                  "Writes only if the picture has this hash, as `lustro hash` prints it; otherwise the exit code is 1")
      ->type_name("HASH")
      ->group(output);
  app->add_flag("--allow-empty", flags->allow_empty, "Writes the picture even if nothing was drawn in it")
      ->disable_flag_override()
      ->group(output);
  app->add_flag("--print-scene", flags->print_scene, "Draws nothing; prints the scene file with all flags laid over it")->group(output);
  flags->scene_flags = add_scene_flags(*app);
  add_draw_flags(*app, flags->draw_flags, flags->scene_flags);
  add_resume_flag(*app, flags->draw_flags);
  add_preview_flag(*app, flags->draw_flags);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro render bunny.ply --material jade --view front -o jade.png", "a mesh in a classic material, from the front"},
           {"lustro render scene.json --size 1920x1080 --samples 16 -o big.png", "a scene, larger and smoother than its file says"},
           {"lustro render primitive:teapot --interpolation flat --light \"point 2,3,4 color=#fff\" -o facets.png", "one lamp, facets shown"},
           {"lustro render scene.json --engine path --seconds 20 -o truth.png", "light from surface to surface, for 20 seconds"},
           {"lustro render scene.json --aov depth,normal,diffuse,light:0 -o out.exr -o out.png", "layers, to compute with and to look at"}},
          [&session, flags] { return run_render(session, *flags); }};
}

}  // namespace lustro::app
