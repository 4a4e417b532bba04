// `lustro info FILE`: what a mesh or scene file holds, as the file states it and as it is drawn, and what had to be repaired.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "app/commands.hpp"
#include "app/info_report.hpp"
#include "app/json_out.hpp"
#include "app/scene_input.hpp"

namespace lustro::app {
namespace {

struct InfoFlags {
  std::string file;
  InputFlags input;
};

Result<ExitCode> finish(const Session& session, const Json& json, const std::string& text) {
  const Result<void> printed = session.json ? print_json(json) : print(text);
  return printed.map([] { return ExitCode::success; });
}

Result<ExitCode> mesh_info(const Session& session, const InfoFlags& flags, const LoadOptions& options) {
  const Result<SourceMesh> source =
      is_primitive(flags.file) ? make_primitive(flags.file.substr(std::string("primitive:").size())) : load_mesh_file(flags.file, options);
  if (!source) {
    return tl::unexpected(source.error());
  }
  NormalOptions normals;
  normals.crease_deg = source->weld_first ? 40 : 180;  // as a bare mesh is drawn
  const Result<BuiltMesh> built = build_mesh(*source, normals);
  if (!built) {
    return tl::unexpected(built.error());
  }
  MeshReport report = make_mesh_report(flags.file, *source, *built);
  LoadedScene scene;
  if (source->format.starts_with("glTF")) {
    Result<LoadedScene> loaded = load_scene(flags.file, options);
    if (!loaded) {
      return tl::unexpected(loaded.error());
    }
    scene = std::move(*loaded);
    report.scene = &scene;
  }
  return finish(session, mesh_json(report), mesh_text(report));
}

Result<ExitCode> scene_info(const Session& session, const InfoFlags& flags, const LoadOptions& options) {
  const Result<LoadedScene> loaded = load_scene(flags.file, options);
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  return finish(session, scene_info_json(flags.file, *loaded), scene_info_text(flags.file, *loaded));
}

}  // namespace

Command make_info(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "info", "Tells what a mesh or scene file holds, and what was repaired in it");
  auto flags = std::make_shared<InfoFlags>();
  app->add_option("FILE", flags->file, "A mesh (OBJ, PLY, STL, OFF, 3MF, glTF), a scene file, or primitive:NAME")->type_name("FILE")->required();
  add_input_flags(*app, flags->input);
  return {
      app,
      {{"lustro info bunny.ply", "counts, bounds, materials, repairs"}, {"lustro info scene.json --json", "the same of a scene, for a script"}},
      [&session, flags]() -> Result<ExitCode> {
        const LoadOptions options = load_options(session, flags->input);
        const bool is_scene = !is_primitive(flags->file) && is_scene_file(flags->file);
        return is_scene ? scene_info(session, *flags, options) : mesh_info(session, *flags, options);
      }};
}

}  // namespace lustro::app
