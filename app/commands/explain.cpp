// `lustro explain SCENE X Y`: one pixel taken apart, down to the last term.
#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/explain_report.hpp"
#include "app/scene_input.hpp"

namespace lustro::app {
namespace {

struct ExplainFlags {
  std::string scene;
  int x = 0, y = 0;
  SceneFlags scene_flags;
  InputFlags input;
};

Result<ExitCode> run_explain(const Session& session, const ExplainFlags& flags) {
  const Result<LoadedScene> loaded = load_scene_argument(flags.scene, flags.scene_flags, load_options(session, flags.input));
  if (!loaded) {
    return tl::unexpected(loaded.error());
  }
  say_warnings(session, loaded->notes);
  const Result<Explanation> explanation = explain(loaded->scene, flags.x, flags.y);
  if (!explanation) {
    return tl::unexpected(explanation.error());
  }
  const Result<PreparedScene> prepared = prepare(loaded->scene);  // for the lights' own colours in the text
  if (!prepared) {
    return tl::unexpected(prepared.error());
  }
  const Result<void> printed =
      session.json ? print_json(explanation_json(*explanation)) : print(explanation_text(loaded->scene, *prepared, *explanation));
  if (!printed) {
    return tl::unexpected(printed.error());
  }
  if (!terms_sum_to_color(*explanation)) {
    say_error("the terms do not sum to the pixel", "this is a fault of Lustro: please report it with the command line and its files");
    return ExitCode::internal;
  }
  return ExitCode::success;
}

}  // namespace

Command make_explain(CommandLine& line, Session& session) {
  CLI::App* app =
      add_subcommand(line, session, "explain", "Takes one pixel of the picture apart: what is seen there, how it is lit, what is stored");
  auto flags = std::make_shared<ExplainFlags>();
  app->add_option("SCENE", flags->scene, kSceneHelp)->type_name("FILE")->required();
  app->add_option("X", flags->x, "The pixel's column, 0 is the left one")->type_name("N")->required();
  app->add_option("Y", flags->y, "The pixel's row, 0 is the top one")->type_name("N")->required();
  flags->scene_flags = add_scene_flags(*app);
  add_input_flags(*app, flags->input);
  return {app,
          {{"lustro explain scene.json 400 300", "why that pixel has its colour"},
           {"lustro explain bunny.ply 512 384 --lighting blinn-phong --json", "with flags as of `lustro render`, for a script"}},
          [&session, flags] { return run_explain(session, *flags); }};
}

}  // namespace lustro::app
