// `lustro convert IN OUT`: whatever Lustro reads, as a mesh file of another format.
#include <fmt/format.h>

#include <CLI/App.hpp>
#include <cmath>
#include <optional>

#include "app/commands.hpp"
#include "app/json_out.hpp"
#include "app/scene_input.hpp"
#include "io/mesh_format.hpp"
#include "lustro/mesh_file.hpp"
#include "mesh/drop_normals.hpp"

namespace lustro::app {
namespace {

struct ConvertFlags {
  std::string input;
  std::string output;
  bool ascii = false;
  double scale = 1;
  std::string up;
  std::optional<double> crease;
  bool recompute_normals = false;
  bool no_normals = false;
  InputFlags reading;
};

Result<void> check_flags(const ConvertFlags& flags) {
  if (!(flags.scale > 0) || !std::isfinite(flags.scale)) {
    return fail(ErrorKind::usage, "--scale", fmt::format("{} is no positive number", flags.scale));
  }
  if (flags.crease && !(*flags.crease >= 0 && *flags.crease <= 180)) {
    return fail(ErrorKind::usage, "--crease", fmt::format("{} is outside 0..180", *flags.crease));
  }
  if (!flags.up.empty() && flags.up != "z-to-y" && flags.up != "y-to-z") {
    return fail(ErrorKind::usage, "--up", fmt::format("{} is neither z-to-y nor y-to-z", flags.up));
  }
  if (flags.no_normals && (flags.crease || flags.recompute_normals)) {
    return fail(ErrorKind::usage, "--no-normals", "leaves out what --crease and --recompute-normals are about");
  }
  const MeshFormat format = mesh_format_of_name(flags.output);
  if (flags.ascii && format != MeshFormat::ply && format != MeshFormat::stl) {
    return fail(ErrorKind::usage, "--ascii", fmt::format("is about .ply and .stl, and {} is neither", flags.output));
  }
  return {};
}

/// Scales in double, then turns by exchanging axes: no rounding but that of the product.
void move(const ConvertFlags& flags, Mesh& mesh) {
  const auto turned = [&flags](const Vec3f& v) {
    return flags.up == "z-to-y" ? Vec3f{v.x, v.z, -v.y} : flags.up == "y-to-z" ? Vec3f{v.x, -v.z, v.y} : v;
  };
  for (Vec3f& position : mesh.positions) {
    position = turned(flags.scale == 1 ? position : vec_cast<float>(vec_cast<double>(position) * flags.scale));
  }
  for (Vec3f& normal : mesh.normals) {
    normal = turned(normal);
  }
  for (auto& tangent : mesh.tangents) {
    const Vec3f direction = turned({tangent[0], tangent[1], tangent[2]});
    tangent = {direction.x, direction.y, direction.z, tangent[3]};
  }
}

Result<LoadedScene> load(const Session& session, const ConvertFlags& flags) {
  LoadOptions options = load_options(session, flags.reading);
  options.adjust = [&flags](Scene& scene) -> Result<void> {
    if (flags.crease) {
      scene.shading.crease = flags.crease;
    }
    scene.shading.recompute_normals |= flags.recompute_normals;
    return {};
  };
  return load_input(flags.input, options);
}

Result<ExitCode> run_convert(const Session& session, const ConvertFlags& flags) {
  if (const Result<void> checked = check_flags(flags); !checked) {
    return tl::unexpected(checked.error());
  }
  const Result<LoadedScene> loaded = load(session, flags);
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  Notes notes = loaded->notes;
  if (!is_primitive(flags.input) && is_scene_file(flags.input)) {
    notes.push_back({flags.input, "of a scene its objects are converted: camera, lights and shading are left out"});
  }
  Result<Mesh> mesh = flatten_scene(loaded->scene);
  if (!mesh) {
    return tl::unexpected(mesh.error());
  }
  if (mesh->triangles.empty()) {
    return fail(ErrorKind::empty, flags.input, "holds no triangles to convert");
  }
  if (flags.no_normals) {
    drop_normals(*mesh);
  }
  move(flags, *mesh);
  MeshWriteOptions options;
  options.ascii = flags.ascii;
  options.texture_folder = std::filesystem::absolute(flags.input).parent_path();
  const Result<Notes> written = write_mesh(flags.output, *mesh, options);
  if (!written) {
    return tl::unexpected(written.error());
  }
  notes.insert(notes.end(), written->begin(), written->end());
  say_warnings(session, notes);
  if (session.json) {
    return print_json({{"in", flags.input},
                       {"out", flags.output},
                       {"vertices", mesh->positions.size()},
                       {"triangles", mesh->triangles.size()},
                       {"bounds", json_bounds(mesh->bounds())},
                       {"notes", json_notes(notes)}})
        .map([] { return ExitCode::success; });
  }
  say(session, fmt::format("wrote {} ({}, {})", flags.output, counted(mesh->positions.size(), "vertex", "vertices"),
                           counted(mesh->triangles.size(), "triangle", "triangles")));
  return ExitCode::success;
}

}  // namespace

Command make_convert(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "convert", "Writes a mesh, or a scene's objects as one, in another format");
  auto flags = std::make_shared<ConvertFlags>();
  app->add_option("IN", flags->input, kSceneHelp)->type_name("FILE")->required();
  app->add_option("OUT", flags->output, "The file to write, its format by its extension: .obj (with .mtl), .ply, .stl, .glb")
      ->type_name("FILE")
      ->required();
  const std::string output = "Output";
  app->add_flag("--ascii", flags->ascii, "PLY and STL as text, in place of binary")->disable_flag_override()->group(output);
  const std::string geometry = "Geometry";
  app->add_option("--scale", flags->scale, "Multiplies all lengths: 0.001 makes metres of millimetres (default: 1)")
      ->type_name("NUMBER")
      ->group(geometry);
  app->add_option("--up", flags->up, "Turns the model: what pointed up along one axis then does along the other")
      ->type_name("z-to-y|y-to-z")
      ->group(geometry);
  app->add_option("--crease", flags->crease, "Faces that meet at more degrees do not share a normal (default: 180, for STL 40)")
      ->type_name("DEGREES")
      ->group(geometry);
  app->add_flag("--recompute-normals", flags->recompute_normals, "Makes normals anew, whatever the file holds")
      ->disable_flag_override()
      ->group(geometry);
  app->add_flag("--no-normals", flags->no_normals, "Leaves normals out, and joins the vertices that they had parted")
      ->disable_flag_override()
      ->group(geometry);
  add_input_flags(*app, flags->reading);
  return {app,
          {{"lustro convert part.stl part.ply --no-normals", "facets to a mesh whose triangles share vertices"},
           {"lustro convert part.stl part.obj --scale 0.001 --up z-to-y", "from a printer's millimetres to metres, with y up"},
           {"lustro convert model.obj model.glb", "one file with materials and their pictures"},
           {"lustro convert scene.json scene.obj", "all objects of a scene where they stand"}},
          [&session, flags] { return run_convert(session, *flags); }};
}

}  // namespace lustro::app
