// The command `lustro`: the table of contents. One line a subcommand; to learn one, open the file named in the margin.
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/commands.hpp"

namespace {

using namespace lustro::app;

ExitCode run(std::vector<std::string> arguments) {
  Session session;
  CommandLine line = make_command_line(session);
  for (const auto make : {
           make_render,       // commands/render.cpp       a scene or a mesh to a picture
           make_info,         // commands/info.cpp         what a file holds
           make_explain,      // commands/explain.cpp      one pixel taken apart
           make_compare,      // commands/compare.cpp      how two pictures differ
           make_batch,        // commands/batch.cpp        many models to a folder of pictures
           make_turntable,    // commands/turntable.cpp    a scene that turns, as an animation or frame by frame
           make_hash,         // commands/hash.cpp         the hash of the float picture
           make_bench,        // commands/bench.cpp        where the time of a picture goes
           make_materials,    // commands/materials.cpp    the library of materials, as a list and as a picture
           make_schema,       // commands/schema.cpp       the JSON Schema of the scene file
           make_glsl,         // commands/glsl.cpp         the lighting equation as GLSL shaders
           make_completions,  // commands/completions.cpp  completion scripts for the shells
           make_man,          // commands/man.cpp          the man page
       }) {
    line.commands.push_back(make(line, session));
  }
  return run_command_line(line, std::move(arguments));
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return static_cast<int>(run(std::vector<std::string>(argv + (argc > 0 ? 1 : 0), argv + argc)));
  } catch (const std::bad_alloc&) {
    say_error("memory ran out");
    return static_cast<int>(ExitCode::limit);
  } catch (const std::exception& fault) {
    say_error(fault.what(), "this is a fault of Lustro: please report it with the command line and its files");
    return static_cast<int>(ExitCode::internal);
  }
}
