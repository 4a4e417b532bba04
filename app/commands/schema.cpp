// `lustro schema`: the JSON Schema of the scene file, for editors.
#include "app/commands.hpp"
#include "lustro/scene.hpp"

namespace lustro::app {

Command make_schema(CommandLine& line, Session& session) {
  CLI::App* app = add_subcommand(line, session, "schema", "Prints the JSON Schema of the scene file, with which editors complete and check it");
  return {app, {{"lustro schema > lustro.schema.json", "for an editor's settings"}}, []() -> Result<ExitCode> {
            std::string schema = scene_schema();
            if (!schema.ends_with('\n')) {
              schema += '\n';
            }
            return print(schema).map([] { return ExitCode::success; });
          }};
}

}  // namespace lustro::app
