// The scene made flat for drawing: matrices in float, colours in linear light, lights relative to the eye. Every renderer starts from this, so
// they agree on every input bit.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "lustro/result.hpp"
#include "lustro/scene.hpp"
#include "math/affine_rows.hpp"
#include "scene/depth_maps.hpp"
#include "scene/mesh_cache.hpp"
#include "scene/occlusion_maps.hpp"
#include "scene/view.hpp"
#include "shade/environment.hpp"
#include "shade/fog.hpp"
#include "shade/lighting.hpp"
#include "shade/opacity.hpp"
#include "shade/reflection.hpp"
#include "shade/texturing.hpp"

namespace lustro {

/// A material ready for shading. Coefficients of terms that are switched off are 0.
struct ShadingMaterial {
  Coefficients<float> coefficients{};
  Vec3f albedo;  ///< k_d, linear, also when the diffuse term is off
  Lighting lighting = Lighting::phong;
  Culling cull = Culling::none;
  Material stated;  ///< as the scene states it, with linear colours
  ShadingMaps maps;
  ShadingOpacity opacity;
  ShadingReflection reflection;  ///< where maps.reflects
};

/// Sets of alpha modes: of a material, bit_of() its mode.
using AlphaModes = std::uint8_t;
[[nodiscard]] constexpr AlphaModes bit_of(AlphaMode mode) {
  return static_cast<AlphaModes>(1U << static_cast<unsigned>(mode));
}

/// A light with a size, as it is: the path tracer's. Relative to the eye.
struct AreaLight {
  LightType type = LightType::rectangle;
  std::uint32_t light = 0;  ///< its place in PreparedScene::lights, where its stand-in is
  Vec3f center;
  Vec3f normal{0, 0, -1};                  ///< unit, of rectangle and disk: the side that shines
  Vec3f x_axis{1, 0, 0}, y_axis{0, 1, 0};  ///< unit, of rectangle and disk, along the edges
  float half_width = 0, half_height = 0;   ///< rectangle
  float radius = 0;                        ///< disk and sphere
  Vec3f diffuse, specular;                 ///< the radiance that diffuse surfaces and highlights see
};

/// The sky as it is: the path tracer's.
struct PreparedEnvironment {
  Vec3f color;                           ///< with the gain; of a picture the gain alone
  std::shared_ptr<const Image> picture;  ///< RGB, linear, or null
  float cosine = 1, sine = 0;            ///< of the rotation about +y
  bool visible = true;
};

/// One object's mesh at its place.
struct Instance {
  std::shared_ptr<const DrawableMesh> drawable;
  const Mesh* mesh = nullptr;  ///< drawable->mesh: with unit normals unless the interpolation is flat
  std::uint32_t object = 0;
  std::uint32_t first_triangle = 0;  ///< triangles are numbered through the scene, in order
  std::uint32_t first_material = 0;  ///< index into PreparedScene::materials of the mesh's material 0
  bool has_own_materials = false;    ///< false: every triangle has first_material
  AlphaModes alpha_modes = 0;        ///< of its materials
  Culling cull = Culling::none;      ///< of its materials, where all are of one mind
  bool has_mixed_culling = false;    ///< where they are not
  bool is_mirrored = false;          ///< the matrix turns the winding round
  bool is_similarity = false;        ///< the matrix keeps angles: normals may be interpolated before they are turned
  float size = 1;                    ///< how many times larger than the mesh it is drawn: the cube root of the growth of its volume
  Mat4 world_from_object;            ///< as the scene states it
  Vec3d eye;                         ///< object space, for a similarity: where the eye stands, or the way that an orthographic view looks

  AffineRows image_from_object;     ///< (pixels * depth from the image's centre, x and y; depth), orthographic: (pixels, pixels, depth)
  AffineRows relative_from_object;  ///< world orientation, relative to the eye
  AffineRows normal_from_object;    ///< inverse transpose up to a positive factor, for a similarity a rotation; no translation

  [[nodiscard]] std::uint32_t material_of(std::uint32_t triangle) const {
    return first_material + (has_own_materials && !mesh->triangle_material.empty() ? mesh->triangle_material[triangle] : 0U);
  }
};

struct PreparedScene {
  View view;
  Shading shading;
  Transfer transfer = Transfer::srgb;
  Tone tone;
  std::vector<Instance> instances;
  std::vector<ShadingMaterial> materials;
  std::vector<ShadingLight> lights;
  std::vector<Light> stated_lights;       ///< one each, the default rig included
  std::vector<AreaLight> area_lights;     ///< those of them with a size, for which `lights` holds a stand-in without
  std::vector<std::string> object_names;  ///< one an object
  Vec3f ambient;
  std::optional<ShadingFog> fog;
  std::optional<PreparedEnvironment> environment;
  std::optional<ShadingEnvironment> around;  ///< the environment's diffuse light, where it is laid around: scene/surroundings.hpp
  std::optional<ShadingMap> sky;             ///< what is seen of it in place of the background, likewise
  DepthMaps shadows;                         ///< one map a light, or none where the scene has no shadows
  OcclusionMaps occlusion;                   ///< no directions where the scene has none
  std::array<float, 4> background{};         ///< linear, premultiplied; where there is a sky its alpha, 1, counts alone
  std::uint32_t triangle_count = 0;
  Notes notes;

  /// Whether what light arrives at a surface depends on other surfaces.
  [[nodiscard]] bool looks_beyond() const { return !shadows.empty() || !occlusion.empty(); }
  [[nodiscard]] SurroundingLight surrounding_light() const { return {ambient, around ? &*around : nullptr, !occlusion.empty()}; }
};

/// errors  usage where something does not fit together (an object without a mesh, a singular matrix, a camera that cannot see); limit for more
///         than 2^32 - 2 triangles; empty for a scene without any triangle
[[nodiscard]] Result<PreparedScene> prepare(const Scene& scene);

/// The same into what the last picture left there, whose memory is used again; and with what is kept of the meshes.
[[nodiscard]] Result<void> prepare(const Scene& scene, MeshCache& cache, int threads, PreparedScene& prepared);

}  // namespace lustro
