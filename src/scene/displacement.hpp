// The displacement maps of an object, as the mesh stage takes them (mesh/displace.hpp).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lustro/mesh.hpp"
#include "lustro/scene.hpp"
#include "mesh/displace.hpp"

namespace lustro {

/// One entry for each material that the object's mesh names, with the map that its triangles are drawn with: those that have a texture, and for
/// which the mesh has texture coordinates. Empty where there is none at all.
[[nodiscard]] std::vector<std::optional<TextureUse>> displacement_of(const Object& object);

/// The same as heights. They hold their textures' texels, which must outlive them.
[[nodiscard]] std::vector<DisplacementMap> displacement_maps(std::span<const std::optional<TextureUse>> uses);

}  // namespace lustro
