// The core of the tree: lighting x interpolation x light kind x attenuation x camera.
#include "truth/scene_tree.hpp"

#include <array>
#include <cstdlib>
#include <iterator>
#include <map>
#include <stdexcept>
#include <tuple>

#include "truth/tree_parts.hpp"

namespace lustro::truth {
namespace {

constexpr std::array kModels{Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong};
constexpr std::array kInterpolations{Interpolation::flat, Interpolation::gouraud, Interpolation::phong};
constexpr std::array kProjections{Projection::perspective, Projection::orthographic};

/// Scenes of one lighting model differ in geometry, material and transfer as well, in turn.
void add_core(std::vector<TreeScene>& tree) {
  std::size_t turn = 0;
  for (const Lighting model : kModels) {
    for (const Interpolation interpolation : kInterpolations) {
      for (const LightKind& kind : light_kinds()) {
        for (const NamedAttenuation& attenuation : attenuations()) {
          if (&attenuation != &attenuations().front() && (kind.name == "directional" || model == Lighting::constant)) {
            continue;  // a directional light has no attenuation, `constant` no light
          }
          for (const Projection projection : kProjections) {
            const std::size_t place = turn % geometry_count();
            const Transfer transfer = turn / 2 % 2 == 0 ? Transfer::srgb : Transfer::none;
            TreeScene entry = base_scene(place, projection);
            entry.name =
                std::string(word(model)) + "/" + word(interpolation) + "/" + kind.name + "/" + attenuation.name + "/" + word(projection);
            entry.scene.image.transfer = transfer;
            entry.scene.shading.lighting = model;
            entry.scene.shading.interpolation = interpolation;
            entry.scene.lights = kind.lights(attenuation.value);
            tree.push_back(std::move(entry));
            turn = turn * 5 % 7919 + 3;
          }
        }
      }
    }
  }
}

}  // namespace

std::shared_ptr<const Mesh> tree_mesh(const std::string& source, const Shading& shading) {
  using Key = std::tuple<std::string, VertexNormals, double>;
  static std::map<Key, std::shared_ptr<const Mesh>> meshes;
  const double crease = shading.crease.value_or(180);
  std::shared_ptr<const Mesh>& mesh = meshes[{source, shading.vertex_normals, crease}];
  if (!mesh) {
    const std::string prefix = "primitive:";
    const Result<SourceMesh> made = make_primitive(source.substr(prefix.size()));
    if (!made) {
      throw std::runtime_error(made.error().text());
    }
    Result<BuiltMesh> built =
        build_mesh(*made, {.weights = shading.vertex_normals, .crease_deg = crease, .recompute = shading.recompute_normals});
    if (!built) {
      throw std::runtime_error(built.error().text());
    }
    mesh = std::make_shared<const Mesh>(std::move(built->mesh));
  }
  return mesh;
}

const std::vector<TreeScene>& scene_tree() {
  static const std::vector<TreeScene> tree = [] {
    std::vector<TreeScene> scenes;
    add_core(scenes);
    add_variations(scenes);
    add_textures(scenes);
    return scenes;
  }();
  return tree;
}

std::size_t scene_stride() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  std::size_t stride = 7;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
  std::size_t stride = 7;
#else
  std::size_t stride = 1;
#endif
#else
  std::size_t stride = 1;
#endif
  if (const char* text = std::getenv("LUSTRO_TREE_STRIDE"); text != nullptr && std::atoi(text) > 0) {
    stride = static_cast<std::size_t>(std::atoi(text));
  }
  return stride;
}

std::vector<const TreeScene*> chosen_scenes() {
  std::vector<const TreeScene*> chosen;
  for (std::size_t i = 0; i < scene_tree().size(); i += scene_stride()) {
    chosen.push_back(&scene_tree()[i]);
  }
  return chosen;
}

}  // namespace lustro::truth
