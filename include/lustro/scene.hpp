// The scene: what the scene file says, as plain data with its defaults. docs/using/scene-file.md describes every key.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/material.hpp"
#include "lustro/mesh.hpp"
#include "lustro/options.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// The key `shadow`: light that does not arrive where something stands before it, for directional, point and spot lights. Each light sees the
/// scene as a map of depths (Williams 1978).
struct ShadowSettings {
  int size = 2048;   ///< texels a side of a light's map, 16..8192; of a point light's six maps half as many
  int softness = 0;  ///< texels by which an edge is blurred on either side, 0..16
};

/// The key `occlusion`: light from all around (the ambient term, the environment's diffuse light) does not arrive from where something stands
/// near by. Surfaces are sorted along the lines of many directions; of each point's hemisphere those count, by their cosine, that are free.
struct OcclusionSettings {
  int directions = 128;            ///< that are looked into from each point, 4..1024
  int size = 256;                  ///< lines of a direction that lie beside each other, on a side of the scene, 16..1024
  std::optional<double> radius{};  ///< world units: what is farther away hides nothing, from half of it on ever less; nothing: a quarter of the
                                   ///< diagonal of the scene's box
};

/// The key `ground`: a floor below everything that shows nothing but the shadows on it, and lets through what is behind it.
struct GroundSettings {
  std::optional<double> height{};  ///< its y in the world; nothing: of the scene's lowest point
  float strength = 1;              ///< how dense the deepest shadow is, 0..1
};

/// The key `image`.
struct ImageSettings {
  int width = 1024;  ///< pixels, 1..16384
  int height = 768;
  int samples = 4;  ///< coverage samples a pixel: 1, 2, 4, 8 or 16
  Transfer transfer = Transfer::srgb;
  Color background{{0.1F, 0.1F, 0.12F}};
  float background_alpha = 1;
  bool transparent = false;  ///< the background has alpha 0
  Tone tone{};               ///< of the bytes that are stored
};

/// The key `camera`. Right-handed, y up on the image. What is not stated frames the whole scene.
struct Camera {
  Projection projection = Projection::perspective;
  ViewPreset view = ViewPreset::three_quarter;  ///< used when there is no eye
  std::optional<Vec3d> eye{};
  std::optional<Vec3d> target{};
  std::optional<Vec3d> up{};
  double fov = 42;                 ///< vertical, degrees, perspective
  std::optional<double> height{};  ///< world units, orthographic
  std::optional<double> near{};    ///< distance along the view direction
  std::optional<double> far{};
};

/// The key `shading`.
struct Shading {
  Lighting lighting = Lighting::phong;
  Interpolation interpolation = Interpolation::phong;
  NormalInterpolation normals = NormalInterpolation::lerp;
  VertexNormals vertex_normals = VertexNormals::angle;
  std::optional<double> crease{};  ///< degrees, 0..180; 180 when not stated, 40 for STL
  bool recompute_normals = false;
  TermSet terms{};
  bool two_sided = false;
  Culling cull = Culling::none;  ///< faces of which this side is seen are left out
  bool normalized = false;       ///< energy-normalised specular lobes, times N.L
};

/// The key `attenuation` of a light.
struct Attenuation {
  double constant = 1, linear = 0, quadratic = 0;  ///< f = 1 / (c + l d + q d^2)
  std::optional<double> falloff{};                 ///< if stated: f = 1 / d^falloff
  bool unclamped = false;                          ///< without it f is limited to 1
  std::optional<double> range{};                   ///< > 0: f is multiplied by clamp(1 - (d / range)^4, 0, 1) (KHR_lights_punctual)
};

/// One entry of `lights`.
struct Light {
  LightType type = LightType::directional;
  std::string name{};
  Vec3d position{0, 0, 0};    ///< world; all but directional; the centre of an area
  Vec3d direction{0, 0, -1};  ///< the way that the light travels, world, of any length but 0; directional and spot; the way an area faces
  Color ambient{{0, 0, 0}};
  Color diffuse{{1, 1, 1}};
  Color specular{{1, 1, 1}};
  Attenuation attenuation{};
  double cutoff = 45;            ///< half angle, degrees, 0..90
  std::optional<double> beam{};  ///< half angle, degrees, smaller than cutoff
  SpotFade fade = SpotFade::smoothstep;
  double exponent = 0;  ///< 0..10000
  bool shadow = true;   ///< where the scene has shadows: this light throws some

  // Of areas, whose `diffuse` is the radiance that they emit: what a camera would see of them.
  Vec2f size{1, 1};               ///< rectangle: its edges, world units
  std::optional<Vec3d> x_axis{};  ///< rectangle: the way of its first edge, made perpendicular to `direction`; else level
  double radius = 1;              ///< disk and sphere, world units
};

/// The key `environment`: light from infinitely far away, all around.
struct Environment {
  std::string file{};                      ///< a picture of all directions, as ReflectionShape::sphere lays them out, relative to the scene file
  Color color{{1, 1, 1}};                  ///< where there is no picture: the same from everywhere
  Vec3f gain{1, 1, 1};                     ///< what it is multiplied by
  double rotation = 0;                     ///< degrees about +y, counter-clockwise seen from above
  bool visible = true;                     ///< it is the background
  std::shared_ptr<const Image> picture{};  ///< RGB, linear; filled by load_scene(), or by hand
};

/// The key `fog`, on the Euclidean distance from the eye to the point.
struct Fog {
  FogMode mode = FogMode::exp;
  double density = 1;
  double start = 0;
  double end = 1;
  Color color{{0, 0, 0}};
};

/// One entry of `objects`.
struct Object {
  std::string name{};
  std::string source{};                ///< the key `mesh`: a file, or `primitive:NAME`; only for messages once `mesh` is there
  std::shared_ptr<const Mesh> mesh{};  ///< filled by load_scene(), or by hand
  std::optional<Material> material{};  ///< overrides the mesh's own
  Mat4 matrix{};                       ///< world_from_object
};

struct Scene {
  ImageSettings image{};
  Camera camera{};
  Shading shading{};
  Color ambient{{0.2F, 0.2F, 0.2F}};           ///< I_a
  std::optional<std::vector<Light>> lights{};  ///< nothing: a default rig that moves with the camera; empty: no light
  std::optional<Fog> fog{};
  std::optional<ShadowSettings> shadow{};        ///< nothing: every light reaches every surface that faces it
  std::optional<OcclusionSettings> occlusion{};  ///< nothing: ambient light is everywhere
  std::optional<GroundSettings> ground{};        ///< nothing: no floor; with one, lights have shadows also where `shadow` is not stated
  std::optional<Environment> environment{};
  std::vector<Object> objects{};
};

/// A loaded scene and what was noticed on the way.
struct LoadedScene {
  Scene scene;
  Notes notes;
  std::vector<std::string> cameras{};     ///< of a glTF file: what LoadOptions::gltf_camera may choose from, by name
  std::vector<std::string> animations{};  ///< of a glTF file, by name
};

struct LoadOptions {
  bool transparency_is_tr = false;  ///< an MTL file's lone `Tr` is the opacity (as 3ds Max writes it), not 1 - opacity

  /// Called by load_scene() with the scene as the file states it, before its meshes are loaded by it: the place for what overrides the file.
  std::function<Result<void>(Scene&)> adjust = {};

  bool strict = false;                 ///< a texture that is missing or broken is an error, not a note
  Transfer transfer = Transfer::srgb;  ///< how colour textures of 8 and 16 bits are decoded; load_scene() and load_meshes() take the scene's

  int threads = 0;  ///< for reading and building meshes and textures; 0: one a core. The result is the same for any number

  // Of glTF files.
  std::string gltf_camera = {};     ///< the camera to look through, its index or name; empty: everything is framed
  std::optional<double> time = {};  ///< seconds into the animation; nothing: the nodes as they are stated
  std::string animation = {};       ///< which one, its index or name; empty: the first
  GltfShading gltf_shading = GltfShading::classic;

  /// Called with each file before it is opened, by the path under which it was found: for who watches files, or packs them. Several threads may
  /// call it at the same time, and a file may be named more than once. What assimp opens beside its file is not named.
  std::function<void(const std::filesystem::path&)> on_file = {};
};

/// The scene that a JSON text describes, meshes not loaded yet (Object::source names them).
/// file    only for messages
/// errors  malformed, with the line and column of broken JSON or the path of the key; usage for an unknown library material
[[nodiscard]] Result<Scene> parse_scene(std::string_view text, const std::string& file = "scene");

/// Loads what the objects' `source` names, relative to `folder`, by the scene's shading options. Objects that have a mesh keep it. A file that
/// two objects name is loaded once.
[[nodiscard]] Result<Notes> load_meshes(Scene& scene, const std::filesystem::path& folder, const LoadOptions& options = {});

/// A scene file, a glTF file or a bare mesh file, by content. A bare mesh is the scene with that one object, lit on both sides. Of a glTF file
/// every node with a mesh is an object (`source` is FILE#nodes[N], which load_meshes() reads too), lit on both sides with energy-normalised
/// highlights.
[[nodiscard]] Result<LoadedScene> load_scene(const std::filesystem::path& file, const LoadOptions& options = {});

/// A mesh file as it states itself (OBJ, PLY, STL, OFF, glTF): by content first, then by extension. The MTL files that an OBJ names are read
/// from its folder, and the pictures that those name from theirs and the tree around it. Of a glTF file: all that its scene draws, in one mesh
/// in world space.
[[nodiscard]] Result<SourceMesh> load_mesh_file(const std::filesystem::path& file, const LoadOptions& options = {});

/// The scene as JSON text that parse_scene() reads back to the same scene. Stated are the keys that differ from their defaults.
[[nodiscard]] std::string scene_json(const Scene& scene);

/// The JSON Schema (draft 2020-12) of the scene file, made from the table of options.
[[nodiscard]] std::string scene_schema();

}  // namespace lustro
