// Drawing for a command: see drawing.hpp.
#include "drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "emptiness.hpp"
#include "progress.hpp"
#include "scene/fields.hpp"
#include "words.hpp"

namespace lustro::app {
namespace {

constexpr int kMostSamples = 1048576;
constexpr const char* kTargetVariable = "LUSTRO_TARGET";
constexpr std::string_view kAllowEmptyHint = "(--allow-empty writes the picture all the same)";

/// The target that is asked for, and where: by the flag, else by the environment.
struct NamedTarget {
  std::string name = "auto";
  std::string place;
};

Result<NamedTarget> named_target(const DrawFlags& flags) {
  NamedTarget named;
  for (const std::string& value : flags.target->results()) {
    if (!is_target_word(value)) {
      continue;  // the camera's
    }
    if (!named.place.empty()) {
      return fail(ErrorKind::usage, "--target", fmt::format("{} and {} cannot both draw", named.name, value));
    }
    named = {value, "--target"};
  }
  if (const char* const variable = std::getenv(kTargetVariable); named.place.empty() && variable != nullptr && *variable != '\0') {
    named = {variable, kTargetVariable};
  }
  return named;
}

/// The stated flag that an error at this key (`camera.near`) is about: the key's own, else another one of its table; empty where there is none.
std::string flag_of_key(std::string_view key, const SceneFlags& flags) {
  const auto is_stated = [&flags](std::string_view name) {
    return !name.empty() && std::any_of(flags.flags.begin(), flags.flags.end(),
                                        [&](const SceneFlags::Flag& f) { return f.name == name && f.option->count() > 0; });
  };
  for (const FieldGroup& group : field_groups()) {
    if (group.path.empty() || !key.starts_with(group.path) || key.substr(group.path.size(), 1) != ".") {
      continue;
    }
    std::string other;
    for (const FieldInfo& field : group.fields) {
      if (!is_stated(field.flag)) {
        continue;
      }
      if (field.key == key.substr(group.path.size() + 1)) {
        return std::string(field.flag);
      }
      other = field.flag;
    }
    return other;
  }
  return {};
}

}  // namespace

std::vector<const CLI::Option*> add_path_flags(CLI::App& app, PathOptions& path, const std::string& group, PathFlags which) {
  std::vector<const CLI::Option*> flags;
  const auto add = [&](CLI::Option* option, const char* type) {
    flags.push_back(option->type_name(type)->group(group));
    return option;
  };
  if (which == PathFlags::none) {
    return flags;
  }
  const bool has_seconds = which == PathFlags::all;
  add(app.add_option("--spp", path.samples,
                     fmt::format("Paths a pixel, at most (default: {}, or {} with {}--target-error)", path.samples, kMostSamples,
                                 has_seconds ? "--seconds or " : "")),
      "N")
      ->check(CLI::Range(1, kMostSamples));
  if (has_seconds) {
    add(app.add_option("--seconds", path.seconds, "Stops after the pass over the picture in which this time is over"), "S")
        ->check(CLI::PositiveNumber);
  }
  add(app.add_option("--target-error", path.target_error,
                     "Stops when the pixels' standard error, as a share of the picture's mean luminance, is at most this"),
      "E")
      ->check(CLI::PositiveNumber);
  add(app.add_option("--bounces", path.bounces,
                     "Surfaces that a path meets at most; 1 is direct light, as the local model has it, with shadows (default: 16)"),
      "N")
      ->check(CLI::Range(0, 10000));
  add(app.add_option("--seed", path.seed, "Another number draws another noise (default: 0)"), "N");
  return flags;
}

void add_resume_flag(CLI::App& app, DrawFlags& flags) {
  flags.path_flags.push_back(
      app.add_option("--resume", flags.path.resume,
                     "Keeps what paths brought in this file, every 10 seconds and at the end, and goes on from it where it is "
                     "there: the picture is that of a run without a break")
          ->type_name("FILE")
          ->group("Paths (with --engine path)"));
}

void add_preview_flag(CLI::App& app, DrawFlags& flags) {
  flags.path_flags.push_back(app.add_option("--preview", flags.path.preview_seconds,
                                            "Writes the picture so far this often, seconds; 0 writes the last one alone (default: 5)")
                                 ->type_name("S")
                                 ->check(CLI::NonNegativeNumber)
                                 ->group("Paths (with --engine path)"));
}

void settle_samples(const std::vector<const CLI::Option*>& path_flags, PathOptions& path) {
  if (!path_flags.empty() && path_flags.front()->count() == 0 && (path.seconds > 0 || path.target_error > 0)) {
    path.samples = kMostSamples;
  }
}

void add_draw_flags(CLI::App& app, DrawFlags& flags, SceneFlags& scene_flags, PathFlags paths) {
  one_of(app.add_option(
             "--engine", flags.engine,
             "Who draws: raster is fast, reference is slow and obvious, and both give the same picture; path follows light from surface to "
             "surface, which they approximate (default: raster)"),
         {"raster", "reference", "path"})
      ->group("Drawing");
  flags.path_flags = add_path_flags(app, flags.path, "Paths (with --engine path)", paths);
  const auto target = std::find_if(scene_flags.flags.begin(), scene_flags.flags.end(), [](const auto& flag) { return flag.name == "--target"; });
  target->option->expected(1, CLI::detail::expected_max_vector_size)->allow_extra_args(false);  // one of each kind
  target->option->type_name("X,Y,Z|auto|scalar|sse4|avx2|avx512|neon|wasm");
  target->option->description(target->option->get_description() +
                              "; or the processor's instructions to draw with, which do not change the picture (default: auto, the widest "
                              "that there are, or what the environment's LUSTRO_TARGET says)");
  flags.target = target->option;
  scene_flags.has_two_targets = true;
}

Result<RenderOptions> render_options(const Session& session, const DrawFlags& flags) {
  RenderOptions options{.threads = session.threads, .aovs = {}};
  options.engine = flags.engine == "path" ? Engine::path : flags.engine == "reference" ? Engine::reference : Engine::raster;
  for (const CLI::Option* option : flags.path_flags) {
    if (options.engine != Engine::path && option->count() > 0) {
      return fail(ErrorKind::usage, option->get_name(), "belongs to --engine path");
    }
  }
  options.path = flags.path;
  settle_samples(flags.path_flags, options.path);
  const Result<NamedTarget> named = named_target(flags);
  if (!named) {
    return tl::unexpected(named.error());
  }
  const Result<Target> target = parse_target(named->name);
  if (!target) {
    return fail(target.error().kind, named->place, target.error().message);
  }
  options.target = *target;
  return options;
}

Result<RenderOptions> render_options(const Session& session, const DrawFlags& flags, const std::string& aovs) {
  Result<RenderOptions> options = render_options(session, flags);
  if (!options || aovs.empty()) {
    return options;
  }
  Result<std::vector<Aov>> parsed = parse_aovs(aovs);
  if (!parsed) {
    return fail(parsed.error().kind, "--aov", parsed.error().message);
  }
  options->aovs = std::move(*parsed);
  return options;
}

std::string aov_list() {
  std::string names;
  for (const std::string_view name : aov_names()) {
    names += (names.empty() ? "" : ", ") + std::string(name) + (name == "light" ? ":N, light:*" : "");
  }
  return names;
}

Error placed(const Error& error, const std::string& scene_name, const SceneFlags& flags) {
  if (error.kind == ErrorKind::usage && error.where.empty() && error.message.starts_with("light:")) {
    return {error.kind, "--aov", error.message};
  }
  if (std::string flag = flag_of_key(error.where, flags); !flag.empty()) {
    return {error.kind, std::move(flag), error.message};
  }
  return {error.kind, error.where.empty() ? scene_name : fmt::format("{}: {}", scene_name, error.where), error.message};
}

Result<void> check_not_empty(const std::string& scene_name, const Scene& scene, const Rendering& rendering) {
  if (rendering.stats.pixels_covered > 0 || rendering.stats.triangles == 0) {
    return {};
  }
  return fail(ErrorKind::empty, scene_name, fmt::format("nothing was drawn: {}", why_empty(scene, rendering.stats)));
}

Result<Rendering> draw_scene(const Session& session, const std::string& scene_name, const Scene& scene, const SceneFlags& flags,
                             RenderOptions options, bool allow_empty) {
  ProgressBar progress(session, "drawing");
  options.progress = progress.callback();
  Result<Rendering> rendering = render(scene, options);
  progress.wipe();
  std::string nothing;
  if (!rendering) {
    if (rendering.error().kind != ErrorKind::empty) {
      return tl::unexpected(placed(rendering.error(), scene_name, flags));
    }
    nothing = fmt::format("nothing was drawn: {}", rendering.error().text());
    rendering = empty_rendering(scene);
  } else if (const Result<void> checked = check_not_empty(scene_name, scene, *rendering); !checked) {
    nothing = checked.error().message;
  }
  if (!nothing.empty() && !allow_empty) {
    return fail(ErrorKind::empty, scene_name, fmt::format("{} {}", nothing, kAllowEmptyHint));
  }
  if (!nothing.empty()) {
    rendering->notes.push_back({scene_name, nothing});
  }
  return rendering;
}

}  // namespace lustro::app
