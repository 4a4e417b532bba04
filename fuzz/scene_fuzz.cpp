// Any bytes as a scene file: a scene that keeps every rule and reads back the same from its own text, or an error with a place and a message.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "lustro/scene.hpp"
#include "scene/check_scene.hpp"
#include "scene/text_values.hpp"

namespace {

void require(bool holds) {
  if (!holds) {
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace lustro;
  const std::string_view text(reinterpret_cast<const char*>(data), size);

  const auto scene = parse_scene(text, "input");
  if (scene) {
    require(check_scene(*scene).has_value());
    const std::string written = scene_json(*scene);
    const auto again = parse_scene(written, "again");
    require(again.has_value());
    require(scene_json(*again) == written);
  } else {
    require(scene.error().where.starts_with("input"));
    require(!scene.error().message.empty());
  }

  // The same bytes as a command line's texts.
  if (const auto light = parse_light(text); !light) {
    require(!light.error().message.empty());
  }
  if (const auto material = parse_material(text); !material) {
    require(!material.error().message.empty());
  }
  if (const auto fog = parse_fog(text); !fog) {
    require(!fog.error().message.empty());
  }
  if (const auto color = parse_color_alpha(text, true)) {
    const auto back = parse_color_alpha(color_text(color->color, color->alpha.value_or(1.0F)), true);
    require(back && back->color == color->color && back->alpha.value_or(1.0F) == color->alpha.value_or(1.0F));
  }
  return 0;
}
