// `lustro truth SCENE`: the local picture beside the true one, and what each approximation costs.
#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <system_error>

#include "app/commands.hpp"
#include "app/drawing.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/scene_input.hpp"
#include "app/truth_report.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

struct TruthFlags {
  std::string scene;
  std::string output;
  PathOptions path{.samples = 256};
  std::vector<const CLI::Option*> path_flags;
  SceneFlags scene_flags;
  InputFlags input;
};

Result<void> write_text_file(const fs::path& file, const std::string& text) {
  return write_file_atomically(file, std::as_bytes(std::span<const char>(text)));
}

/// The pictures of one row, and their difference.
Result<void> write_row(const fs::path& folder, const TruthRow& row, const Image& before, const Image& after, const WriteOptions& options) {
  const Result<Comparison> comparison = compare_images(before, after, 0, options.transfer);
  if (!comparison) {
    return tl::unexpected(comparison.error());
  }
  Result<void> written = write_image(folder / row.before, before, options);
  if (written) {
    written = write_image(folder / row.after, after, options);
  }
  if (written) {
    written = write_image(folder / row.difference, comparison->heatmap, {.threads = options.threads});
  }
  return written;
}

Result<void> write_report(const fs::path& folder, const std::string& scene_name, const Scene& scene, const ApproximationReport& report,
                          int threads) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) {
    return fail(ErrorKind::io, folder.string(), fmt::format("the folder cannot be made: {}", failed.message()));
  }
  const WriteOptions options{.transfer = scene.image.transfer, .tone = scene.image.tone, .threads = threads};
  const std::vector<TruthRow> rows = truth_rows(report);
  auto row = rows.begin();
  Result<void> written = write_row(folder, *row++, report.local, report.truth, options);
  for (const CauseError& cause : report.causes) {
    if (written && cause.applies) {
      written = write_row(folder, *row++, cause.before, cause.after, options);
    }
  }
  for (const TermError& term : report.terms) {
    if (written) {
      written = write_row(folder, *row++, term.local, term.truth, options);
    }
  }
  for (const auto& [name, image] : {std::pair{"local.exr", &report.local}, std::pair{"truth.exr", &report.truth}}) {
    if (written) {
      written = write_image(folder / name, *image, {});
    }
  }
  for (const auto& [name, text] :
       {std::pair{"report.txt", truth_text(report)}, std::pair{"report.json", truth_json(scene_name, report).dump(2) + "\n"},
        std::pair{"index.html", truth_page(scene_name, report)}}) {
    if (written) {
      written = write_text_file(folder / name, text);
    }
  }
  return written;
}

/// `box-truth` for `scenes/box.json`, in the current folder.
std::string default_folder(const std::string& argument) {
  const std::string stem = is_primitive(argument) ? argument.substr(argument.find(':') + 1) : fs::path(argument).stem().string();
  return stem + "-truth";
}

Result<ExitCode> run_truth(const Session& session, const TruthFlags& flags) {
  const std::string output = flags.output.empty() ? default_folder(flags.scene) : flags.output;
  if (std::error_code ignored; fs::exists(output, ignored) && !fs::is_directory(output, ignored)) {
    return fail(ErrorKind::io, output, "is a file; a folder for the report is expected");
  }
  if (flags.path.samples < 2) {
    return fail(ErrorKind::usage, "--spp",
                fmt::format("{} is below 2: the noise is told by two pictures with half of the paths each", flags.path.samples));
  }
  const Result<LoadedScene> loaded = load_scene_argument(flags.scene, flags.scene_flags, load_options(session, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  say_warnings(session, loaded->notes);
  ApproximationOptions options{.threads = session.threads, .path = flags.path};
  settle_samples(flags.path_flags, options.path);
  ProgressBar progress(session, "following light");
  options.progress = progress.callback();
  const Result<ApproximationReport> report = measure_approximations(loaded->scene, options);
  progress.wipe();
  if (!report) {
    return tl::unexpected(placed(report.error(), flags.scene, flags.scene_flags));
  }
  say_warnings(session, report->notes);
  if (const Result<void> written = write_report(output, flags.scene, loaded->scene, *report, session.threads); !written) {
    return tl::unexpected(written.error());
  }
  const Result<void> printed = session.json    ? print_json(truth_json(flags.scene, *report))
                               : session.quiet ? Result<void>{}
                                               : print(truth_text(*report));
  if (!printed) {
    return tl::unexpected(printed.error());
  }
  say(session, fmt::format("wrote {}", printable((fs::path(output) / "index.html").string())));
  return ExitCode::success;
}

}  // namespace

Command make_truth(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "truth", "Draws the local picture and the true one, and measures what each approximation costs");
  auto flags = std::make_shared<TruthFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  app->add_option("-o,--output", flags->output, "The folder of the pictures and the report (default: SCENE-truth)")
      ->type_name("FOLDER")
      ->group("Output");
  flags->path_flags = add_path_flags(*app, flags->path, "Paths");
  flags->scene_flags = add_scene_flags(*app);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro truth box.json", "writes box-truth/index.html, a page with the pictures and the figures"},
           {"lustro truth bunny.ply --spp 1024 -o bunny --json", "with more paths and less noise; the figures for a script"}},
          [&session, flags] { return run_truth(session, *flags); }};
}

}  // namespace lustro::app
