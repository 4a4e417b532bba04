// Completion scripts for bash, zsh and fish, made from the manual.
#pragma once

#include <string>

#include "manual.hpp"

namespace lustro::app {

[[nodiscard]] std::string bash_completion(const Manual& manual);
[[nodiscard]] std::string zsh_completion(const Manual& manual);
[[nodiscard]] std::string fish_completion(const Manual& manual);

}  // namespace lustro::app
