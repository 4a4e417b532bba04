// The subcommands, one file each in commands/. To add one: write commands/NAME.cpp, declare it here, and name it in main.cpp.
#pragma once

#include "command_line.hpp"

namespace lustro::app {

[[nodiscard]] Command make_render(CommandLine& line, Session& session);
[[nodiscard]] Command make_info(CommandLine& line, Session& session);
[[nodiscard]] Command make_explain(CommandLine& line, Session& session);
[[nodiscard]] Command make_compare(CommandLine& line, Session& session);
[[nodiscard]] Command make_hash(CommandLine& line, Session& session);
[[nodiscard]] Command make_truth(CommandLine& line, Session& session);
[[nodiscard]] Command make_turntable(CommandLine& line, Session& session);
[[nodiscard]] Command make_convert(CommandLine& line, Session& session);
[[nodiscard]] Command make_batch(CommandLine& line, Session& session);
[[nodiscard]] Command make_bench(CommandLine& line, Session& session);
[[nodiscard]] Command make_materials(CommandLine& line, Session& session);
[[nodiscard]] Command make_lab(CommandLine& line, Session& session);
[[nodiscard]] Command make_glsl(CommandLine& line, Session& session);
[[nodiscard]] Command make_schema(CommandLine& line, Session& session);
[[nodiscard]] Command make_completions(CommandLine& line, Session& session);
[[nodiscard]] Command make_man(CommandLine& line, Session& session);

}  // namespace lustro::app
