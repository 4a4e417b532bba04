// `lustro batch IN... -o FOLDER`: many models to a folder of pictures, one picture a core, each drawn in a process of its own that may fail
// alone.
#include <fmt/format.h>

#include <chrono>
#include <cmath>

#include "app/batch_jobs.hpp"
#include "app/commands.hpp"
#include "app/cores.hpp"
#include "app/drawing.hpp"
#include "app/emptiness.hpp"
#include "app/json_out.hpp"
#include "app/outputs.hpp"
#include "app/progress.hpp"
#include "app/scene_input.hpp"
#include "app/worker_pool.hpp"
#include "image/file.hpp"

namespace lustro::app {
namespace {

namespace fs = std::filesystem;

struct BatchFlags {
  BatchInputs inputs;
  std::string output;
  SceneFlags scene_flags;
  DrawFlags draw_flags;
  PngFlags png;
  double time_limit = 0;
  double memory_limit = 0;  ///< MB
  bool resume = false;
  bool warnings = false;
  bool allow_empty = false;
  InputFlags input;
};

struct Failure {
  BatchJob job;
  ExitCode code = ExitCode::internal;
  std::string message;
};

struct Drawn {
  BatchJob job;
  std::uint64_t triangles = 0;
};

struct Summary {
  std::vector<Drawn> drawn;
  std::vector<Failure> failed;
  std::size_t skipped = 0;
  Notes notes;
  std::size_t noted = 0;  ///< models that brought notes
  double seconds = 0;

  [[nodiscard]] double pictures_per_second() const { return seconds > 0 ? static_cast<double>(drawn.size()) / seconds : 0; }
};

Result<void> check_flags(const BatchFlags& flags) {
  constexpr double kMostSeconds = 1e6, kMostMegabytes = 1e9;
  if (!(flags.time_limit >= 0 && flags.time_limit <= kMostSeconds)) {
    return fail(ErrorKind::usage, "--time-limit", fmt::format("{} is outside 0..{}", flags.time_limit, kMostSeconds));
  }
  if (!(flags.memory_limit >= 0 && flags.memory_limit <= kMostMegabytes)) {
    return fail(ErrorKind::usage, "--memory-limit", fmt::format("{} is outside 0..{}", flags.memory_limit, kMostMegabytes));
  }
  return write_options(flags.png, Transfer::srgb, 1).map([](const WriteOptions&) {});
}

/// Whether the picture is there and newer than its model.
bool is_done(const BatchJob& job) {
  std::error_code error;
  const auto drawn = fs::last_write_time(job.output, error);
  if (error) {
    return false;
  }
  if (is_primitive(job.input)) {
    return true;
  }
  const auto changed = fs::last_write_time(job.input, error);
  return !error && drawn > changed;
}

// --- in the workers ----------------------------------------------------------------------------------------------------------------

/// One model, on one thread, to its file.
Result<Rendering> draw_job(const BatchFlags& flags, const BatchJob& job, RenderOptions options, Notes& notes) {
  const Session alone{.threads = 1, .quiet = true};
  Result<LoadedScene> loaded = load_scene_argument(job.input, flags.scene_flags, load_options(alone, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  notes = std::move(loaded->notes);
  options.threads = alone.threads;
  const std::vector<std::string> outputs{job.output.string()};
  draw_what_is_written(outputs, flags.png, options);
  Result<Rendering> rendering = draw_scene(alone, job.input, loaded->scene, flags.scene_flags, std::move(options), flags.allow_empty);
  if (!rendering) {
    return rendering;
  }
  notes.insert(notes.end(), rendering->notes.begin(), rendering->notes.end());
  std::error_code error;
  fs::create_directories(job.output.parent_path(), error);  // where it fails, the writing says why
  const Result<WriteOptions> write = write_options(flags.png, loaded->scene.image.transfer, alone.threads, loaded->scene.image.tone);
  if (const auto written = write_outputs(outputs, *rendering, *write); !written) {
    return tl::unexpected(written.error());
  }
  return rendering;
}

/// The job's end as a text that crosses to the other process.
std::string run_job(const BatchFlags& flags, const BatchJob& job, const RenderOptions& options) {
  Notes notes;
  const Result<Rendering> rendering = draw_job(flags, job, options, notes);
  Json json{{"notes", json_notes(notes)}};
  if (rendering) {
    json["triangles"] = rendering->stats.triangles;
  } else {
    json["code"] = static_cast<int>(exit_code_of(rendering.error().kind));
    // A scene's file names itself in most messages, but a flag or the memory does not.
    std::string text = rendering.error().text();
    if (text.find(fs::path(job.input).filename().string()) == std::string::npos) {
      text = fmt::format("{}: {}", job.input, text);
    }
    if (rendering.error().kind == ErrorKind::limit && flags.memory_limit > 0) {
      text += fmt::format(" (--memory-limit grants {} MB)", flags.memory_limit);
    }
    json["message"] = text;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// --- in the command ----------------------------------------------------------------------------------------------------------------

/// What a worker said, into the summary. What does not read as that came from a broken process.
void take_result(const BatchJob& job, const std::string& text, Summary& summary) {
  const Json json = Json::parse(text, nullptr, false);
  try {
    Notes notes;
    for (const Json& note : json.at("notes")) {
      notes.push_back({note.at("where").get<std::string>(), note.at("message").get<std::string>()});
    }
    if (json.contains("message")) {
      summary.failed.push_back({job, static_cast<ExitCode>(json.at("code").get<int>()), json.at("message").get<std::string>()});
    } else {
      summary.drawn.push_back({job, json.at("triangles").get<std::uint64_t>()});
    }
    summary.noted += notes.empty() ? 0U : 1U;
    summary.notes.insert(summary.notes.end(), notes.begin(), notes.end());
  } catch (const Json::exception&) {
    summary.failed.push_back({job, ExitCode::internal, fmt::format("{}: the process that drew it answered nonsense", job.input)});
  }
}

void take_end(const JobEnd& end, const BatchJob& job, Summary& summary) {
  if (end.has_result) {
    take_result(job, end.text, summary);
  } else {
    remove_temporaries(job.output.parent_path(), end.process);
    summary.failed.push_back({job, ExitCode::limit, fmt::format("{}: {}", job.input, end.text)});
  }
}

Json summary_json(const Summary& summary) {
  Json pictures = Json::array(), failures = Json::array();
  for (const Drawn& drawn : summary.drawn) {
    pictures.push_back({{"input", drawn.job.input}, {"output", drawn.job.output.string()}, {"triangles", drawn.triangles}});
  }
  for (const Failure& failure : summary.failed) {
    failures.push_back({{"input", failure.job.input},
                        {"output", failure.job.output.string()},
                        {"code", static_cast<int>(failure.code)},
                        {"message", failure.message}});
  }
  return {{"drawn", summary.drawn.size()},
          {"failed", summary.failed.size()},
          {"skipped", summary.skipped},
          {"seconds", summary.seconds},
          {"pictures_per_second", summary.pictures_per_second()},
          {"pictures", std::move(pictures)},
          {"failures", std::move(failures)},
          {"notes", json_notes(summary.notes)}};
}

std::string summary_text(const Summary& summary) {
  std::string text = fmt::format("drew {}", counted(summary.drawn.size(), "picture", "pictures"));
  text += summary.skipped > 0 ? fmt::format(", skipped {}", grouped(summary.skipped)) : "";
  text += summary.failed.empty() ? "" : fmt::format(", {} failed", grouped(summary.failed.size()));
  return text + fmt::format(" ({:.2f} s, {:.1f} pictures a second)", summary.seconds, summary.pictures_per_second());
}

Result<void> make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    return fail(ErrorKind::io, folder.string(), fmt::format("cannot be made: {}", error ? error.message() : "something else has that name"));
  }
  return {};
}

Result<ExitCode> run_batch(const Session& session, const BatchFlags& flags) {
  if (const Result<void> checked = check_flags(flags); !checked) {
    return tl::unexpected(checked.error());
  }
  const Result<RenderOptions> options = render_options(session, flags.draw_flags);
  if (!options) {
    return tl::unexpected(options.error());
  }
  Scene tried;  // a wrong flag is said once, not once a model
  if (const Result<void> applied = apply_scene_flags(flags.scene_flags, tried); !applied) {
    return tl::unexpected(applied.error());
  }
  if (flags.inputs.arguments.empty() && flags.inputs.list.empty()) {
    return fail(ErrorKind::usage, "", "what to draw? Name meshes, folders of meshes, or a --list");
  }
  Result<std::vector<BatchJob>> jobs = batch_jobs(flags.inputs, flags.output);
  if (!jobs) {
    return tl::unexpected(jobs.error());
  }
  if (const Result<void> made = make_folder(flags.output); !made) {
    return tl::unexpected(made.error());
  }
  Summary summary;
  if (flags.resume) {
    summary.skipped = static_cast<std::size_t>(std::erase_if(*jobs, is_done));
  }

  const auto start = std::chrono::steady_clock::now();
  ProgressBar progress(session, "drawing");
  const auto show = progress.callback();
  const WorkerLimits limits{.seconds = flags.time_limit, .bytes = static_cast<std::uint64_t>(std::ceil(flags.memory_limit * 1e6))};
  std::size_t ended = 0;
  const Result<void> ran = run_in_workers(
      jobs->size(), threads_meant(session.threads), limits, [&](std::size_t i) { return run_job(flags, (*jobs)[i], *options); },
      [&](const JobEnd& end) {
        const std::size_t failures = summary.failed.size(), notes = summary.notes.size();
        if (show) {
          progress.wipe();
        }
        take_end(end, (*jobs)[end.job], summary);
        if (summary.failed.size() > failures) {
          say_error(summary.failed.back().message);
        }
        if (flags.warnings) {
          say_warnings(session, {summary.notes.begin() + static_cast<std::ptrdiff_t>(notes), summary.notes.end()});
        }
        if (show) {
          show(static_cast<double>(++ended) / static_cast<double>(jobs->size()));
        }
      });
  progress.wipe();
  if (!ran) {
    return tl::unexpected(ran.error());
  }
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (summary.noted > 0 && !flags.warnings) {
    say_warning(session, fmt::format("something was skipped or repaired in {}; --warnings lists it", counted(summary.noted, "model", "models")));
  }
  say(session, summary_text(summary));
  const Result<void> printed = session.json ? print_json(summary_json(summary)) : Result<void>{};
  return printed.map([&] { return summary.failed.empty() ? ExitCode::success : ExitCode::incomplete; });
}

}  // namespace

Command make_batch(CommandLine& line, Session& session) {
  CLI::App* app =
      add_subcommand(line, session, "batch", "Draws many models to a folder of pictures, one a core; a model that fails stops no other");
  auto flags = std::make_shared<BatchFlags>();
  app->add_option("IN", flags->inputs.arguments, "Meshes, scene files, folders of meshes (.obj, .ply, .stl, .off, .3mf), primitive:NAME")
      ->type_name("FILE")
      ->expected(-1);
  const std::string input = "Input", output = "Output", limits = "Limits";
  app->add_option("--list", flags->inputs.list, "A file that names further ones, one a line; - is standard input")
      ->type_name("FILE")
      ->group(input);
  app->add_flag("-r,--recursive", flags->inputs.recursive, "Folders with the folders in them")->disable_flag_override()->group(input);
  app->add_option("-o,--output", flags->output, "The folder of the pictures, made where it is missing: chair.obj becomes chair.png")
      ->type_name("FOLDER")
      ->required()
      ->group(output);
  app->add_flag("--resume", flags->resume, "Skips models whose picture is there and newer than they are")
      ->disable_flag_override()
      ->group(output);
  add_png_flags(*app, flags->png, output);
  app->add_flag("--allow-empty", flags->allow_empty, "Writes a picture even if nothing was drawn in it")->disable_flag_override()->group(output);
  app->add_flag("--warnings", flags->warnings, "Lists what was skipped or repaired in each model, not only in how many")
      ->disable_flag_override()
      ->group(output);
  app->add_option("--time-limit", flags->time_limit, "Seconds that a model may take, 0 is any number (default: 0)")
      ->type_name("S")
      ->group(limits);
  app->add_option("--memory-limit", flags->memory_limit,
                  "Megabytes (10^6 bytes) that drawing a model may allocate, beside its file, 0 is any number (default: 0)")
      ->type_name("MB")
      ->group(limits);
  flags->scene_flags = add_scene_flags(*app);
  add_draw_flags(*app, flags->draw_flags, flags->scene_flags);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro batch models -o thumbnails --size 512x512 --samples 4", "a folder of meshes"},
           {"lustro batch models -r -o thumbnails --resume --time-limit 30 --memory-limit 2000", "again, only what is new; with limits"},
           {"find . -name '*.stl' | lustro batch --list - -o pictures --material pewter --json", "what another program finds"}},
          [&session, flags] { return run_batch(session, *flags); }};
}

}  // namespace lustro::app
