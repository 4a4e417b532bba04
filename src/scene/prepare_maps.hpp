// A material's textures made ready for drawing: which of them have something to say where they are drawn, and the numbers that kernels read.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "lustro/material.hpp"
#include "lustro/mesh.hpp"
#include "lustro/scene.hpp"
#include "mesh/tangents.hpp"
#include "scene/mesh_cache.hpp"
#include "shade/opacity.hpp"
#include "shade/reflection.hpp"
#include "shade/texturing.hpp"
#include "texture/slots.hpp"

namespace lustro {

/// A map that is drawn: its name, and where a material keeps it.
struct MapRow {
  MapKind kind;
  const TextureSlot* slot;
};
[[nodiscard]] std::span<const MapRow> map_rows();

/// The tangents that an object's tangent-space normal maps ask of its mesh: how the first of them lies on it. Nothing: they ask for none.
[[nodiscard]] std::optional<TangentOptions> tangents_for(const Object& object, const Shading& shading);

/// One map, as shading looks it up. It holds the texture's texels.
[[nodiscard]] ShadingMap prepare_map(const TextureUse& use);

/// Maps that cannot be drawn are left out with a note: without a texture, without the mesh's texture coordinates, or of what only a pixel's own
/// lighting knows where light is not calculated in the pixel. Those of terms that are off are left out without one.
///
/// where  for notes: `objects[3]`
[[nodiscard]] ShadingMaps prepare_maps(const Material& material, const Mesh& mesh, const Shading& shading, const std::string& where,
                                       Notes& notes);

/// What of the material lets see through: the mode is `opaque` where nothing does. An opacity map that cannot be drawn is left out with a note.
[[nodiscard]] ShadingOpacity prepare_opacity(const Material& material, const DrawableMesh& drawable, const std::string& where, Notes& notes);

/// A material's reflection map, if it has one that is drawn: highlights belong to the lighting model and are not switched off, and there are
/// textures. Faces of a cube that have none are black, with a note.
[[nodiscard]] bool prepare_reflection(const Material& material, const Shading& shading, const std::string& where, Notes& notes,
                                      ShadingReflection& result);

/// The names of a cube map's faces, in their order: `right`, `left`, ...
[[nodiscard]] std::span<const std::string_view, 6> cube_face_names();

}  // namespace lustro
