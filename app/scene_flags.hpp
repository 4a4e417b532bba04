// The flags of the scene: one for each key of the scene file that has one, made from the table of options (src/scene/fields.hpp), which is why
// none of them is named here.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/scene.hpp"

namespace lustro::app {

/// The flags of one subcommand. Their values are read after parsing.
struct SceneFlags {
  struct Flag {
    std::string name;  ///< `--samples`
    CLI::Option* option = nullptr;
  };
  std::vector<Flag> flags;
  CLI::Option* size = nullptr;       ///< `--size 800x600`: --width and --height in one
  bool has_two_targets = false;      ///< `--target` takes a target to draw with as well (drawing.hpp)
  CLI::Option* no_lights = nullptr;  ///< `--no-lights`: --light none
};

[[nodiscard]] SceneFlags add_scene_flags(CLI::App& app);

/// Whether a value of `--target` names a target to draw with (`avx2`), not the point that the camera looks at (`0,1,0`, `none`).
[[nodiscard]] bool is_target_word(std::string_view value);

/// Lays the stated flags over the scene. The first --light replaces the scene's lights, further ones join it.
/// errors  usage, `where` is the flag
[[nodiscard]] Result<void> apply_scene_flags(const SceneFlags& flags, Scene& scene);

}  // namespace lustro::app
