// Drawing a scene, and taking one pixel apart.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"

namespace lustro {

/// What can be drawn beside the colour picture. Exactly: colour = ((((ambient + diffuse) + specular) + emission) + fog) + background in
/// every pixel and channel; the layers of all lights and `scene` sum to ambient + diffuse + specular + emission up to float rounding.
enum class AovKind : std::uint8_t {
  ambient,
  diffuse,
  specular,
  emission,
  fog,
  background,
  light,         ///< one light's ambient + diffuse + specular; `light:0`, `light:1`, ..., `light:*`
  scene,         ///< the scene's ambient light, emission and reflection maps: what no light brings
  depth,         ///< distance along the view direction, world units; infinity on the background
  normal,        ///< the normal that was lit, world, unit; 0 on the background
  position,      ///< world
  albedo,        ///< k_d, linear
  object,        ///< index of the object; -1 on the background
  material,      ///< index into PreparedScene's materials; -1 on the background
  triangle,      ///< index within the object's mesh, of a displaced one as it is subdivided; -1 on the background
  barycentrics,  ///< perspective-correct weights of the triangle's three vertices
  mask,          ///< share of the pixel that is covered: samples, each by what its surfaces hide together
  variance,      ///< Engine::path: of each pixel's mean, channel by channel; its root is the standard error
};

struct Aov {
  AovKind kind = AovKind::depth;
  int light = -1;  ///< for `light`: which; -1: all of them
};

/// `diffuse`, `light:2`, ... ; a comma-separated list.
/// errors  usage for an unknown name, with the known ones
[[nodiscard]] Result<std::vector<Aov>> parse_aovs(std::string_view list);

/// All the names that parse_aovs() knows, in their order.
[[nodiscard]] std::span<const std::string_view> aov_names();

/// Who draws. The first two give the same bits.
enum class Engine : std::uint8_t {
  raster,     ///< tiles, lanes and threads
  reference,  ///< slow and obvious: it defines what correct is
  path,       ///< follows light from surface to surface: what the local model approximates (docs/using/ground-truth.md)
};

struct Rendering;

/// How long Engine::path looks, and how far. It stops at the first of `samples`, `seconds` and `target_error` that is reached.
struct PathOptions {
  int samples = 64;         ///< paths a pixel, at most; 1..1048576
  double seconds = 0;       ///< > 0: no pass over the picture begins after this time
  double target_error = 0;  ///< > 0: RenderStats::error that is good enough
  int bounces = 16;         ///< surfaces that a path meets at most, 0..10000; 1: direct light, lit as the local model does, with shadows
  std::uint32_t seed = 0;   ///< another one draws another noise
  /// Not empty: the file that keeps what paths brought. Where it is there, the picture goes on from it, and ends as one that was never
  /// interrupted, bit by bit; it is written (as a whole or not at all) when the picture is done, and every 10 seconds before. It is refused
  /// where the scene, its size, the bounces or the seed are others.
  std::filesystem::path resume{};
  /// Called between passes with the picture so far, as it would be if that were all: after a first quick look, then when `preview_seconds` have
  /// gone by (longer where the call itself takes long), never with the last one, which render() returns. An error ends the drawing with it.
  std::function<Result<void>(const Rendering&)> preview{};
  double preview_seconds = 5;
};

/// The instruction set whose row of kernels draws. All rows give the same bits.
enum class Target : std::uint8_t { automatic, scalar, sse4, avx2, avx512, neon, wasm };

/// The rows that this build has and this machine can run, the widest first.
[[nodiscard]] std::span<const Target> available_targets();

/// `scalar`, `sse4`, `avx2`, ...
[[nodiscard]] std::string_view target_name(Target target);

/// The opposite of target_name(), also `auto`.
/// errors  usage for an unknown name, with the known ones; unsupported for a row that this machine cannot run, with those that it can
[[nodiscard]] Result<Target> parse_target(std::string_view name);

/// Which rows of a picture are drawn where several programs draw it together (the workers of a page, say): bands of pixels, as Engine::raster
/// cuts them, go round in turn. A pixel's bits do not depend on it. Rendering::bands says which they are.
struct Share {
  int index = 0;  ///< 0..count - 1
  int count = 1;  ///< 1: everything
};

/// Rows of pixels, `end` excluded.
struct Band {
  int begin = 0, end = 0;
  friend bool operator==(const Band&, const Band&) = default;
};

struct RenderOptions {
  int threads = 0;  ///< 0: one a core
  std::vector<Aov> aovs{};
  std::function<void(double)> progress{};  ///< called with 0..1, from any thread, one call at a time
  Engine engine = Engine::raster;
  Target target = Target::automatic;  ///< of Engine::raster; automatic: the widest that the machine has
  bool store_color = true;            ///< fill Rendering::color
  bool store_bytes = false;           ///< fill Rendering::bytes
  PathOptions path{};                 ///< of Engine::path
  Share share{};                      ///< of Engine::raster; the others draw everything
};

struct RenderStats {
  std::uint64_t triangles = 0;       ///< in the scene
  std::uint64_t triangles_seen = 0;  ///< inside the picture and not degenerate; counted only where no pixel is covered, to say why, else 0
  std::uint64_t pixels_covered = 0;  ///< with at least one covered sample; 0: nothing was drawn

  // Of Engine::path.
  int samples = 0;          ///< paths a pixel that the picture is the mean of
  int samples_resumed = 0;  ///< of these from PathOptions::resume
  std::uint64_t rays = 0;   ///< that were shot, those to lights included
  double error = 0;         ///< root mean square of the pixels' standard errors over the picture's mean, of luminance; 0 of one path: not known
};

/// Where the time of one picture went, milliseconds. The last two are done tile by tile on all threads at once: their sum is the wall time of
/// the tiles, divided between them as the threads' own time was.
struct RenderTimes {
  double prepare = 0;     ///< camera, matrices, lights; clusters of meshes that are new to the renderer
  double shadows = 0;     ///< maps of depths, of shadows
  double cull = 0;        ///< clusters against the picture, and their tiles
  double visibility = 0;  ///< vertices, triangles, depth
  double shading = 0;     ///< light, samples to pixels, pixels to bytes
  double total = 0;
};

struct Rendering {
  Image color;                ///< H x W x 4, linear light (or as it stands with transfer `none`), alpha premultiplied
  ByteImage bytes;            ///< H x W x 4: what to_bytes(color) gives with the scene's transfer and tone
  std::vector<Layer> layers;  ///< one an AOV, in the order asked for (`light:*` unfolds)
  std::vector<Band> bands;    ///< the rows that were drawn, from top to bottom; without RenderOptions::share one band, all of them
  Camera camera;              ///< the scene's, with a choice made for all that it leaves open
  std::vector<Light> lights;  ///< the scene's, or the default rig in its place
  RenderStats stats;
  RenderTimes times;
  Notes notes;
};

/// Draws a scene. Equal scenes give equal bits, whatever the engine (but Engine::path), the target, the number of threads and the machine;
/// Engine::path gives equal bits for any number of threads on one machine.
/// errors  usage where the scene does not fit together (an object without a mesh, eye and target equal, ...) or the share is none; limit; empty
///         where there is nothing to draw at all; unsupported for a target that this machine cannot run
[[nodiscard]] Result<Rendering> render(const Scene& scene, const RenderOptions& options = {});

/// Draws many pictures of the same meshes: what a mesh alone decides (its clusters, its check, missing normals) is kept from one picture to the
/// next, for as long as the scene that is drawn holds the mesh. One picture at a time.
class Renderer {
 public:
  Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;
  ~Renderer();

  /// As lustro::render(); the buffers of `result` are used again where they fit, so that pictures of one size need no new memory.
  [[nodiscard]] Result<void> render(const Scene& scene, const RenderOptions& options, Rendering& result);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One light's part in one shading.
struct LightExplanation {
  int light = 0;
  std::string name;
  Vec3f to_light;   ///< L, unit
  Vec3f reflected;  ///< R = 2 (N.L) N - L
  Vec3f half;       ///< H = (L + V) / |L + V|
  float distance = 0;
  float n_dot_l = 0, r_dot_v = 0, n_dot_h = 0;
  float attenuation = 1, spot = 1;  ///< f_i, s_i
  float visibility = 1;             ///< v_i: the share of the light that is not in shadow here
  /// l_a, l_d, l_s, linear: an area's stand-in has its size in them, and without the term `specular` l_s is 0
  Vec3f light_ambient, light_diffuse, light_specular;
  Vec3f ambient, diffuse, specular;
};

/// One evaluation of the lighting equation: a pixel's for `phong`, a face's for `flat`, a vertex's for `gouraud`.
struct ShadingExplanation {
  float weight = 1;  ///< of this evaluation in the fragment: 1, or the vertex's barycentric coordinate
  Vec3f position;    ///< world
  Vec3f normal;      ///< N, world, unit, already turned round where two_sided asks for it
  Vec3f to_eye;      ///< V, unit
  /// k_a, k_d, k_s, k_e and n as they are in this evaluation: under vertex colours and maps, but for maps that come after it
  /// (FragmentExplanation::maps_ambient); 0 where a term is switched off
  Vec3f k_ambient, k_diffuse, k_specular, k_emission;
  float shininess = 0;
  Vec3f ambient, diffuse, specular, emission;  ///< sums over the lights (clamped at the vertex for `gouraud`)
  Vec3f scene_ambient;                         ///< k_a I_a, part of ambient
  float openness = 1;                          ///< a: what of the light from all around is not occluded
  Vec3f environment;                           ///< a k_d E, part of diffuse: the scene's environment
  Vec3f from_environment;                      ///< E
  Vec3f clamp{1, 1, 1};                        ///< what `gouraud` multiplies a vertex's terms by, so that their sum is at most 1
  std::vector<LightExplanation> lights;
};

/// What one of the material's maps said in a pixel.
struct MapExplanation {
  std::string map;               ///< `diffuse`, `normal`, ...: what it drives
  std::string name;              ///< TextureUse::name
  float u = 0, v = 0;            ///< where it was looked up, in pictures
  float level_of_detail = 0;     ///< log2 of the texels that a look spans; below 0: magnified
  std::array<float, 4> value{};  ///< RGBA with gain and base
  bool applies = true;           ///< false: the place lies outside a picture that leaves the material as it is there
};

/// One surface that a pixel shows, and with how many of its samples. They come in the order of the samples that show them, and within a sample
/// from the nearest to the farthest.
struct FragmentExplanation {
  int object = 0;
  std::string object_name;
  int triangle = 0;
  int material = 0;
  std::string material_name;
  bool front = true;
  int samples = 0;
  float opacity = 1;   ///< the share of what lies behind that it hides
  float weight = 1;    ///< its share of the pixel: what samples it covers, what it hides there, what nearer ones let through
  float x = 0, y = 0;  ///< where in the picture it was shaded
  float depth = 0;
  Vec3f barycentrics;
  Vec3f position;  ///< world
  Lighting lighting = Lighting::phong;
  Material coefficients;  ///< linear, as the maps leave them
  std::vector<MapExplanation> maps;
  std::vector<ShadingExplanation> shadings;
  /// what maps multiply the light of a face or of vertices by, term by term; 1 where they change coefficients instead (`phong`, decals)
  Vec3f maps_ambient{1, 1, 1}, maps_diffuse{1, 1, 1}, maps_specular{1, 1, 1}, maps_emission{1, 1, 1};
  Vec3f reflection;                                 ///< k_s times the reflection map, before fog: part of specular
  Vec3f ambient, diffuse, specular, emission, fog;  ///< of the fragment
  float fog_factor = 1;
};

/// The pixel taken apart. `color` equals the rendered pixel bit for bit, and ambient + ... + background, in AovKind's order, equals `color`'s
/// rgb.
struct Explanation {
  int x = 0, y = 0;
  Interpolation interpolation = Interpolation::phong;
  int samples = 1;
  Vec3f ambient_light;      ///< I_a, linear
  bool normalized = false;  ///< the lobes are, see Shading
  std::vector<FragmentExplanation> fragments;
  float background_weight = 0;  ///< the background's share of the pixel
  Vec3f ambient, diffuse, specular, emission, fog, background;
  std::array<float, 4> color{};
  std::array<std::uint8_t, 4> bytes{};
};

/// errors  usage where x, y lie outside the picture; else as render()
[[nodiscard]] Result<Explanation> explain(const Scene& scene, int x, int y);

}  // namespace lustro
