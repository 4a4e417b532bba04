// See displacement.hpp.
#include "scene/displacement.hpp"

#include <algorithm>

#include "scene/prepare_maps.hpp"
#include "shade/texturing.hpp"

namespace lustro {
namespace {

// The texels' mean around a place, over a square of `spacing` texels.
float height_at(const ShadingMap& map, const Vec2f& uv, float spacing) {
  Footprint<float> at = on_map(map, Footprint<float>{uv.x, uv.y, 0, 0, 0, 0});
  at.u_dx = spacing / map.width;
  at.v_dy = spacing / map.height;
  const float applies = map.leaves_outside ? is_on_picture(at.u, at.v) : 1.0F;
  return chosen_channel(map, value_of(map, sample(map.sampler, TexelReader(map.texels), map.width, map.height, at), 1.0F)) * applies;
}

}  // namespace

std::vector<std::optional<TextureUse>> displacement_of(const Object& object) {
  const Mesh& mesh = *object.mesh;
  const auto is_drawn = [&](const std::optional<TextureUse>& use) {
    return use && use->texture && use->uv_set <= 1 && !(use->uv_set == 0 ? mesh.uvs : mesh.uvs1).empty();
  };
  const std::size_t count = std::max<std::size_t>(mesh.materials.size(), 1);
  std::vector<std::optional<TextureUse>> uses;
  for (std::size_t i = 0; i < count; ++i) {
    const Material* material = object.material ? &*object.material : (mesh.materials.empty() ? nullptr : &mesh.materials[i]);
    if (material != nullptr && is_drawn(material->textures.displacement)) {
      uses.resize(count);
      uses[i] = material->textures.displacement;
    }
  }
  return uses;
}

std::vector<DisplacementMap> displacement_maps(std::span<const std::optional<TextureUse>> uses) {
  std::vector<DisplacementMap> maps(uses.size());
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (!uses[i]) {
      continue;
    }
    ShadingMap map = prepare_map(*uses[i]);
    map.sampler.anisotropy = 1;
    const std::array<float, 6>& m = map.uv_matrix;
    maps[i].uv_set = map.uv_set;
    maps[i].texels_from_uv = {m[0] * map.width, m[1] * map.width, m[3] * map.height, m[4] * map.height};
    maps[i].height = [map](const Vec2f& uv, float spacing) { return height_at(map, uv, spacing); };
  }
  return maps;
}

}  // namespace lustro
