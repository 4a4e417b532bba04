// Drawing for a command: the flags that say who draws, and what every picture passes before it is used.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

#include "lustro/render.hpp"
#include "report.hpp"
#include "scene_flags.hpp"

namespace lustro::app {

/// `--engine`, `--target` and how long paths are followed, of every command that draws.
struct DrawFlags {
  std::string engine = "raster";
  const CLI::Option* target = nullptr;
  PathOptions path;  ///< `--spp`, `--seconds`, ...
  std::vector<const CLI::Option*> path_flags;
};

/// Which of the flags of paths a command has: `--seconds` means something else to those that measure time themselves.
enum class PathFlags { none, all, without_seconds };

/// `--spp`, `--target-error`, `--bounces`, `--seed` and, with all, `--seconds`; `--spp` first. What `path` holds is the default.
std::vector<const CLI::Option*> add_path_flags(CLI::App& app, PathOptions& path, const std::string& group, PathFlags which = PathFlags::all);

/// `--resume` and `--preview`, of a command that draws one picture.
void add_resume_flag(CLI::App& app, DrawFlags& flags);
void add_preview_flag(CLI::App& app, DrawFlags& flags);

/// Where a time or an error is stated and no number of paths, there is no other limit.
void settle_samples(const std::vector<const CLI::Option*>& path_flags, PathOptions& path);

/// Adds the flags. `--target` is the camera's as well: `--target 0,1,0` is a point, `--target avx2` a target to draw with.
///
/// paths  which of those that say how long paths are followed
void add_draw_flags(CLI::App& app, DrawFlags& flags, SceneFlags& scene_flags, PathFlags paths = PathFlags::all);

/// What the flags ask for, with the session's threads.
/// errors  usage for an unknown target, unsupported for one that this machine lacks; `where` is the flag, or the variable of the environment
[[nodiscard]] Result<RenderOptions> render_options(const Session& session, const DrawFlags& flags);

/// The same with the layers that the flag `--aov` lists; an empty list is none.
/// errors  usage for an unknown layer, `where` is the flag
[[nodiscard]] Result<RenderOptions> render_options(const Session& session, const DrawFlags& flags, const std::string& aovs);

/// The names that `--aov` knows, for its help.
[[nodiscard]] std::string aov_list();

/// An error of drawing as the command's user knows its place: a flag where one was stated, else the scene and the key.
[[nodiscard]] Error placed(const Error& error, const std::string& scene_name, const SceneFlags& flags);

/// Whether the picture shows anything.
/// errors  empty, with the reason
[[nodiscard]] Result<void> check_not_empty(const std::string& scene_name, const Scene& scene, const Rendering& rendering);

/// The scene drawn, with a progress bar where one may appear, and never an empty picture unless it is allowed: then a note says so.
/// errors  as render(), placed(); empty
[[nodiscard]] Result<Rendering> draw_scene(const Session& session, const std::string& scene_name, const Scene& scene, const SceneFlags& flags,
                                           RenderOptions options, bool allow_empty);

}  // namespace lustro::app
