// The exact command that draws a scene.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "lustro/scene.hpp"

namespace lustro::web {

/// `lustro render INPUT --flag value ... -o OUTPUT`, where flags over `base` (what INPUT alone is) give `scene`, key for key; nothing where no
/// flags can.
[[nodiscard]] std::optional<std::string> command_text(const std::string& input, const Scene& base, const Scene& scene, std::string_view output);

/// A word as a POSIX shell takes it: in quotes where it needs them.
[[nodiscard]] std::string shell_word(std::string_view text);

}  // namespace lustro::web
