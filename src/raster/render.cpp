// The pipeline's table of contents: from a scene to a picture, one line a stage.
#include "lustro/render.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <mutex>
#include <new>

#include "image/store.hpp"
#include "parallel/parallel_for.hpp"
#include "parallel/progress.hpp"
#include "path/render.hpp"
#include "path/state.hpp"
#include "raster/bins.hpp"
#include "raster/depth_maps.hpp"
#include "raster/frame.hpp"
#include "raster/scratch_pool.hpp"
#include "raster/target.hpp"
#include "reference/aov.hpp"
#include "reference/depth_maps.hpp"
#include "reference/render.hpp"
#include "reference/triangle.hpp"
#include "scene/prepare.hpp"
#include "scene/surroundings.hpp"

namespace lustro {

namespace {

/// What stays from one picture to the next.
struct Workshop {
  explicit Workshop(ClusterUse use) : meshes(use) {}

  MeshCache meshes;
  EnvironmentCache surroundings;
  PreparedScene prepared;
  Frame frame;
  BinWork bins;
  Scratches scratches;
  DepthWorkshop depths;
};

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

void store_layers(const Frame& frame, Pixel& pixel, std::vector<Vec3f>& light_parts, int x, int y) {
  pixel.light_parts.swap(light_parts);
  for (std::size_t i = 0; i < frame.aovs.size(); ++i) {
    store_aov(frame.aovs[i], *frame.scene, pixel, frame.layers[i].image.at(x, y));
  }
  pixel.light_parts.swap(light_parts);
}

/// An image of this size, whose memory is used again.
template <class AnyImage>
void resize(AnyImage& image, const View& view, int channels) {
  image.width = view.width;
  image.height = view.height;
  image.channels = channels;
  image.pixels.resize(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height) * static_cast<std::size_t>(channels));
}

/// A pixel that shows the background alone, as reference/pixel.cpp sums it.
StoredPixel background_pixel(const PreparedScene& scene) {
  Pixel pixel;
  const std::array<float, 4>& b = scene.background;
  pixel.background = {b[0], b[1], b[2]};
  pixel.alpha = 0.0F + b[3];
  StoredPixel stored;
  stored.color = pixel.color();
  store_pixel8(stored.color, scene.transfer, Toning(scene.tone), stored.bytes);
  return stored;
}

/// The picture's tiles and where its pixels go.
void lay_out(Frame& frame, const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options, Rendering& result) {
  lay_out_geometry(frame, scene);
  frame.aovs = aovs;
  frame.wants_all = !aovs.empty();
  frame.wants_lights = std::any_of(aovs.begin(), aovs.end(), [](const Aov& aov) { return aov.kind == AovKind::light; });
  frame.layers = result.layers;
  frame.store_layers = store_layers;
  frame.color = options.store_color ? result.color.pixels.data() : nullptr;
  frame.bytes = options.store_bytes ? result.bytes.pixels.data() : nullptr;
  frame.srgb = scene.transfer == Transfer::srgb ? &srgb_table() : nullptr;
  frame.toning = Toning(scene.tone);
  frame.store_pixel8 = store_pixel8;
  frame.background = background_pixel(scene);
}

/// How many rows of tiles are this share's.
std::size_t tile_rows(const Frame& frame, const Share& share) {
  return static_cast<std::size_t>(std::max(frame.tiles_y - share.index + share.count - 1, 0)) / static_cast<std::size_t>(share.count);
}

/// What they are in pixels. Rows that touch are one band.
void list_bands(const Frame& frame, const Share& share, std::vector<Band>& bands) {
  bands.clear();
  for (int row = share.index; row < frame.tiles_y; row += share.count) {
    const TileArea area = frame.area(static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.tiles_x));
    if (!bands.empty() && bands.back().end == area.top) {
      bands.back().end = area.bottom;
    } else {
      bands.push_back({area.top, area.bottom});
    }
  }
}

void draw_tiles(Workshop& workshop, const Kernels& kernels, const RenderOptions& options, Rendering& result) {
  const auto begin = Clock::now();
  const Frame& frame = workshop.frame;
  const auto tiles_x = static_cast<std::size_t>(frame.tiles_x);
  const auto first = static_cast<std::size_t>(options.share.index);
  const auto step = static_cast<std::size_t>(options.share.count);
  const std::size_t tiles = tiles_x * tile_rows(frame, options.share);
  Progress progress(options.progress, tiles);
  ScratchPool pool(workshop.scratches, workshop.frame);
  const auto draw_tile = [&](std::size_t i) {
    const std::size_t tile = (first + i / tiles_x * step) * tiles_x + i % tiles_x;
    TileScratch* scratch = pool.take();
    const auto start = Clock::now();
    kernels.fill_tile(frame, tile, *scratch);
    const auto filled = Clock::now();
    kernels.shade_tile(frame, tile, *scratch);
    scratch->visibility_ms += milliseconds(filled - start);
    scratch->shading_ms += milliseconds(Clock::now() - filled);
    pool.give_back(scratch);
    progress.step();
  };
  parallel_for(tiles, options.threads, std::ref(draw_tile));  // a reference, because std::function would allocate for the lambda itself
  double visibility = 0;
  double shading = 0;
  for (const auto& scratch : pool.used()) {
    visibility += scratch->visibility_ms;
    shading += scratch->shading_ms;
    result.stats.pixels_covered += scratch->pixels_covered;
  }
  const double share = milliseconds(Clock::now() - begin) / std::max(visibility + shading, 1e-9);
  result.times.visibility = visibility * share;
  result.times.shading = shading * share;
}

/// What the local model cannot draw as it is.
void note_what_is_approximated(const PreparedScene& scene, Notes& notes) {
  if (!scene.area_lights.empty()) {
    notes.push_back({fmt::format("lights[{}]", scene.area_lights.front().light),
                     "has a size, which --engine path alone draws: here it shines from its centre"});
  }
}

/// What paths do without.
void note_what_paths_leave_out(const PreparedScene& scene, Notes& notes) {
  if (std::any_of(scene.materials.begin(), scene.materials.end(),
                  [](const ShadingMaterial& material) { return material.opacity.catches > 0; })) {
    notes.push_back({"ground", "a surface that shows nothing but shadows (`ground`, illumination 10) is not drawn by --engine path"});
  }
}

void rasterize(Workshop& workshop, Target target, std::span<const Aov> aovs, const RenderOptions& options, Rendering& result) {
  const PreparedScene& prepared = workshop.prepared;
  result.stats = {.triangles = prepared.triangle_count};
  if (options.store_color) {
    resize(result.color, prepared.view, 4);
  }
  if (options.store_bytes) {
    resize(result.bytes, prepared.view, 4);
  }
  const auto begin = Clock::now();
  draw_depth_maps(prepared, workshop.prepared.shadows, kernels_of(target), options.threads, workshop.depths);  // raster/depth_maps.cpp
  draw_occlusion(prepared, workshop.prepared.occlusion, options.threads);                                      // scene/occlusion_maps.cpp
  result.times.shadows = milliseconds(Clock::now() - begin);
  lay_out(workshop.frame, prepared, aovs, options, result);
  list_bands(workshop.frame, options.share, result.bands);
  const auto laid_out = Clock::now();
  sort_into_tiles(workshop.frame, workshop.bins, options.threads);  // raster/bins.cpp
  result.times.cull = milliseconds(Clock::now() - laid_out);
  draw_tiles(workshop, kernels_of(target), options, result);  // raster/row.cpp
  if (result.stats.pixels_covered == 0) {
    result.stats.triangles_seen = setup_triangles(prepared, options.threads).size();
  }
}

/// Whether a layer is a part of the local model's sum, which the path tracer does not have.
bool is_local_term(AovKind kind) {
  switch (kind) {
    case AovKind::ambient:
    case AovKind::diffuse:
    case AovKind::specular:
    case AovKind::emission:
    case AovKind::fog:
    case AovKind::background:
    case AovKind::light:
    case AovKind::scene:
      return true;
    default:
      return false;
  }
}

/// The picture by paths; layers of numbers (depth, normals, ids, ...) by the rasterizer, for both see the same surfaces.
Result<void> draw_paths(const Scene& scene, std::span<const Aov> aovs, const RenderOptions& options, Target target, Workshop& workshop,
                        Rendering& result) {
  bool wants_numbers = false;
  for (const Aov& aov : aovs) {
    if (is_local_term(aov.kind)) {
      return fail(ErrorKind::unsupported, "",
                  fmt::format("the layer {} is a part of the local model's sum, which --engine path does not have",
                              make_layer(aov, workshop.prepared).name));
    }
    wants_numbers = wants_numbers || aov.kind != AovKind::variance;
  }
  if (wants_numbers) {
    RenderOptions numbers = options;
    numbers.store_color = numbers.store_bytes = false;
    numbers.progress = {};
    rasterize(workshop, target, aovs, numbers, result);
  }
  const std::uint64_t fingerprint = options.path.resume.empty() ? 0 : path_fingerprint(scene, options.path);  // path/state.cpp
  auto drawn = render_path(workshop.prepared, aovs, options, fingerprint, result);                            // path/render.cpp
  if (drawn && result.stats.pixels_covered == 0) {
    result.stats.triangles_seen = setup_triangles(workshop.prepared, options.threads).size();
  }
  return drawn;
}

/// What the picture was drawn with where the scene left it open.
void report_choices(const PreparedScene& scene, const Camera& stated, Rendering& result) {
  const View& view = scene.view;
  result.camera = stated;
  result.camera.eye = view.eye;
  result.camera.target = view.target;
  result.camera.up = view.up;
  result.camera.near = view.near;
  result.camera.far = view.far;
  if (view.projection == Projection::orthographic) {
    result.camera.height = view.height / view.pixels_per_unit;
  }
  result.lights = scene.stated_lights;
  result.bands.assign(1, {0, view.height});
}

Result<void> draw(const Scene& scene, const RenderOptions& options, Workshop& workshop, Rendering& result) {
  const auto begin = Clock::now();
  if (options.share.count < 1 || options.share.index < 0 || options.share.index >= options.share.count) {
    return fail(ErrorKind::usage, "share", fmt::format("{} of {} is none", options.share.index, options.share.count));
  }
  const auto target = choose_target(options.target);  // raster/target.cpp
  if (!target) {
    return tl::unexpected(target.error());
  }
  PreparedScene& prepared = workshop.prepared;
  if (auto done = prepare(scene, workshop.meshes, options.threads, prepared); !done) {  // scene/prepare.cpp
    return done;
  }
  const auto aovs = unfold_aovs(options.aovs, prepared);  // reference/aov.cpp
  if (!aovs) {
    return tl::unexpected(aovs.error());
  }
  result.notes = prepared.notes;
  report_choices(prepared, scene.camera, result);
  result.times = {};
  result.times.prepare = milliseconds(Clock::now() - begin);
  result.layers.clear();
  for (const Aov& aov : *aovs) {
    result.layers.push_back(make_layer(aov, prepared));
  }
  if (options.engine == Engine::path) {
    note_what_paths_leave_out(prepared, result.notes);
    auto drawn = draw_paths(scene, *aovs, options, *target, workshop, result);
    result.times.total = milliseconds(Clock::now() - begin);
    return drawn;
  }
  if (auto done = lay_surroundings(scene, workshop.surroundings, options.threads, prepared); !done) {  // scene/surroundings.cpp
    return done;
  }
  note_what_is_approximated(prepared, result.notes);
  if (options.engine == Engine::reference) {
    draw_depth_maps(prepared, prepared.shadows, options.threads);   // reference/depth_maps.cpp
    draw_occlusion(prepared, prepared.occlusion, options.threads);  // scene/occlusion_maps.cpp
    render_reference(prepared, *aovs, options, result);             // reference/render.cpp
    result.times.total = milliseconds(Clock::now() - begin);
    return {};
  }
  rasterize(workshop, *target, *aovs, options, result);
  result.times.total = milliseconds(Clock::now() - begin);
  return {};
}

Result<void> draw_within_memory(const Scene& scene, const RenderOptions& options, Workshop& workshop, Rendering& result) {
  try {
    return draw(scene, options, workshop, result);
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, "", fmt::format("not enough memory to draw {} x {} pixels", scene.image.width, scene.image.height));
  }
}

}  // namespace

struct Renderer::State : Workshop {
  using Workshop::Workshop;
};

Renderer::Renderer() : state_(std::make_unique<State>(ClusterUse::often)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

Result<void> Renderer::render(const Scene& scene, const RenderOptions& options, Rendering& result) {
  return draw_within_memory(scene, options, *state_, result);
}

Result<Rendering> render(const Scene& scene, const RenderOptions& options) {
  Rendering result;
  Workshop workshop(ClusterUse::once);
  if (auto drawn = draw_within_memory(scene, options, workshop, result); !drawn) {
    return tl::unexpected(drawn.error());
  }
  return result;
}

}  // namespace lustro
