// From the tree of a scene file to the scene. parse_scene() = parse_json(), read_scene(), check_scene().
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "lustro/scene.hpp"
#include "scene/json_path.hpp"

namespace lustro {

/// What the file's `materials` says.
using NamedMaterials = std::map<std::string, Material, std::less<>>;

/// Editors find the schema by this key; it means nothing else.
inline constexpr std::string_view kSchemaKey = "$schema";

/// The scene of a document; every key is checked by itself, not yet against the others.
/// errors  malformed, usage; `where` is the path of the key
[[nodiscard]] Result<Scene> read_scene(const nlohmann::json& document);

}  // namespace lustro
