// `lustro hash SCENE`: the hash of the float picture and of its layers, equal on every machine.
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/drawing.hpp"
#include "app/hash_text.hpp"
#include "app/json_out.hpp"
#include "app/scene_input.hpp"

namespace lustro::app {
namespace {

struct HashFlags {
  std::string scene;
  SceneFlags scene_flags;
  DrawFlags draw_flags;
  std::string aovs;
  bool allow_empty = false;
  InputFlags input;
};

/// The bare hash of the picture; with layers a line for each, led by the picture's.
std::string hashes_as_text(const Rendering& rendering) {
  if (rendering.layers.empty()) {
    return hash_text(hash_image(rendering.color)) + "\n";
  }
  std::string text = fmt::format("{}  color\n", hash_text(hash_image(rendering.color)));
  for (const Layer& layer : rendering.layers) {
    text += fmt::format("{}  {}\n", hash_text(hash_image(layer.image)), layer.name);
  }
  return text;
}

Json hashes_as_json(const HashFlags& flags, const Rendering& rendering, const Notes& notes) {
  Json layers = Json::object();
  for (const Layer& layer : rendering.layers) {
    layers[layer.name] = hash_text(hash_image(layer.image));
  }
  return {{"scene", flags.scene},
          {"hash", hash_text(hash_image(rendering.color))},
          {"layers", std::move(layers)},
          {"width", rendering.color.width},
          {"height", rendering.color.height},
          {"notes", json_notes(notes)}};
}

Result<ExitCode> run_hash(const Session& session, const HashFlags& flags) {
  Result<RenderOptions> options = render_options(session, flags.draw_flags, flags.aovs);
  if (!options) {
    return tl::unexpected(options.error());
  }
  Result<LoadedScene> loaded = load_scene_argument(flags.scene, flags.scene_flags, load_options(session, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  say_warnings(session, loaded->notes);
  const Result<Rendering> rendering = draw_scene(session, flags.scene, loaded->scene, flags.scene_flags, *std::move(options), flags.allow_empty);
  if (!rendering) {
    return tl::unexpected(rendering.error());
  }
  say_warnings(session, rendering->notes);
  Notes notes = std::move(loaded->notes);
  notes.insert(notes.end(), rendering->notes.begin(), rendering->notes.end());
  const Result<void> printed = session.json ? print_json(hashes_as_json(flags, *rendering, notes)) : print(hashes_as_text(*rendering));
  return printed.map([] { return ExitCode::success; });
}

}  // namespace

Command make_hash(CommandLine& line, Session& session) {
  CLI::App* app =
      add_subcommand(line, session, "hash", "Prints the hash of the picture before it is stored: 16 digits, the same on every machine");
  auto flags = std::make_shared<HashFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  const std::string output = "Output";
  app->add_option("--aov", flags->aovs, "Layers to hash beside the picture, separated by commas: " + aov_list())
      ->type_name("LIST")
      ->group(output);
  app->add_flag("--allow-empty", flags->allow_empty, "Prints the hash even if nothing was drawn")->disable_flag_override()->group(output);
  flags->scene_flags = add_scene_flags(*app);
  add_draw_flags(*app, flags->draw_flags, flags->scene_flags);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro hash scene.json", "for a list of what pictures should be, or a comparison between machines"},
           {"lustro hash bunny.ply --aov depth,normal,diffuse", "the hash of each layer, too"},
           {"lustro render scene.json -o scene.png --expect-hash $(cat scene.hash)", "draws only what is expected"}},
          [&session, flags] { return run_hash(session, *flags); }};
}

}  // namespace lustro::app
