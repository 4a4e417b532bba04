// The command `lustro`: the table of contents. One line a subcommand; to learn one, open the file named in the margin.
#include <array>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"
#include "app/heap.hpp"

namespace {

using namespace lustro::app;

constexpr std::array kCommands{
    CommandMaker{"render", make_render},            // commands/render.cpp       a scene or a mesh to a picture
    CommandMaker{"info", make_info},                // commands/info.cpp         what a file holds
    CommandMaker{"explain", make_explain},          // commands/explain.cpp      one pixel taken apart
    CommandMaker{"truth", make_truth},              // commands/truth.cpp        what the local model costs
    CommandMaker{"compare", make_compare},          // commands/compare.cpp      how two pictures differ
    CommandMaker{"convert", make_convert},          // commands/convert.cpp      a mesh or a scene to a mesh file of another format
    CommandMaker{"batch", make_batch},              // commands/batch.cpp        many models to a folder of pictures
    CommandMaker{"lab", make_lab},                  // commands/lab.cpp          the page in the browser, and who serves it
    CommandMaker{"turntable", make_turntable},      // commands/turntable.cpp    a scene that turns, as an animation or frame by frame
    CommandMaker{"hash", make_hash},                // commands/hash.cpp         the hash of the float picture
    CommandMaker{"bench", make_bench},              // commands/bench.cpp        where the time of a picture goes
    CommandMaker{"materials", make_materials},      // commands/materials.cpp    the library of materials, as a list and as a picture
    CommandMaker{"schema", make_schema},            // commands/schema.cpp       the JSON Schema of the scene file
    CommandMaker{"glsl", make_glsl},                // commands/glsl.cpp         the lighting equation as GLSL shaders
    CommandMaker{"completions", make_completions},  // commands/completions.cpp  completion scripts for the shells
    CommandMaker{"man", make_man},                  // commands/man.cpp          the man page
};

}  // namespace

int main(int argc, char** argv) {
  prepare_heap();
  try {
    return static_cast<int>(run_command_line(kCommands, std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc)));
  } catch (const std::bad_alloc&) {
    say_error("memory ran out");
    return static_cast<int>(ExitCode::limit);
  } catch (const std::exception& fault) {
    say_error(fault.what(), "this is a fault of Lustro: please report it with the command line and its files");
    return static_cast<int>(ExitCode::internal);
  }
}
