// What a picture is made of while it is drawn: what the stages hand on to each other. Plain data: the rows of kernels are compiled for other
// instruction sets than the rest, so nothing here is more than numbers and pointers to them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "image/srgb.hpp"
#include "image/tone.hpp"
#include "lustro/render.hpp"
#include "reference/pixel.hpp"
#include "reference/triangle.hpp"
#include "scene/prepare.hpp"
#include "scene/samples.hpp"

namespace lustro {

/// A cluster that may be seen.
struct VisibleCluster {
  std::uint32_t instance = 0;
  std::uint32_t cluster = 0;                              ///< within its mesh
  float nearest = 0;                                      ///< no vertex has a larger depth key
  std::int16_t left = 0, top = 0, right = 0, bottom = 0;  ///< pixels that it may touch, bounds included, limited to the picture
};

/// Pixels; the upper bounds are excluded.
struct TileArea {
  int left = 0, top = 0, right = 0, bottom = 0;
};

/// Lists of numbers, one a tile, one after the other.
struct TileLists {
  std::vector<std::uint32_t> begin;  ///< tiles + 1
  std::vector<std::uint32_t> entries;

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t tile) const {
    return std::span(entries).subspan(begin[tile], begin[tile + 1] - begin[tile]);
  }
};

/// A pixel as it is stored: linear, premultiplied floats, and bytes.
struct StoredPixel {
  std::array<float, 4> color{};
  std::array<std::uint8_t, 4> bytes{};
};

/// A picture's geometry, sorted into tiles, and where its pixels go.
struct Frame {
  const PreparedScene* scene = nullptr;
  int tile_width = 64, tile_height = 64;
  int tiles_x = 0, tiles_y = 0;
  std::span<const SampleOffset> pattern;
  SampleOffset lowest{0, 0}, highest{0, 0};  ///< bounds of the pattern's offsets
  float farthest = 0;                        ///< depth key of the far plane

  std::vector<VisibleCluster> clusters;          ///< wholly between the near plane and the guard band's edges
  std::vector<ScreenTriangle> loose;             ///< of all other clusters, clipped one by one
  TileLists cluster_lists;                       ///< of entries of `clusters`, the nearest first
  TileLists loose_lists;                         ///< of entries of `loose`
  AlphaModes alpha_modes = 0;                    ///< of all instances
  std::vector<std::uint32_t> material_instance;  ///< the instance that a material belongs to

  std::span<const Aov> aovs;
  bool wants_all = false;     ///< layers are stored: everything that a fragment knows
  bool wants_lights = false;  ///< layers of single lights are
  std::span<Layer> layers;
  /// Puts a pixel into the layers; not a row's business.
  void (*store_layers)(const Frame& frame, Pixel& pixel, std::vector<Vec3f>& light_parts, int x, int y) = nullptr;
  float* color = nullptr;         ///< H x W x 4, or null
  std::uint8_t* bytes = nullptr;  ///< H x W x 4, or null
  const SrgbTable* srgb = nullptr;
  Toning toning;
  void (*store_pixel8)(const std::array<float, 4>&, Transfer, const Toning&,
                       std::array<std::uint8_t, 4>&) = nullptr;  ///< image/store.hpp's, from outside the rows
  StoredPixel background;                                        ///< of a pixel that shows nothing else

  [[nodiscard]] TileArea area(std::size_t tile) const {
    const int x = static_cast<int>(tile) % tiles_x * tile_width;
    const int y = static_cast<int>(tile) / tiles_x * tile_height;
    const int right = x + tile_width;
    const int bottom = y + tile_height;
    return {x, y, right < scene->view.width ? right : scene->view.width, bottom < scene->view.height ? bottom : scene->view.height};
  }
};

/// A triangle that won a sample of the tile: all that shading needs of it, one cache line.
struct Record {
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;
  static constexpr std::uint32_t kSwapped = 1;  ///< as ScreenTriangle::is_swapped
  static constexpr std::uint32_t kBack = 2;     ///< not ScreenTriangle::is_front
  static constexpr std::uint32_t kClipped = 4;  ///< as ScreenTriangle::is_clipped; the number above kLooseShift is its place in Frame::loose
  static constexpr std::uint32_t kSmall = 8;    ///< every edge function fits 32 bits
  static constexpr std::uint32_t kLooseShift = 4;

  std::array<std::int32_t, 3> x{}, y{};
  float inverse_area = 0;
  std::array<float, 3> key{};
  std::array<std::uint32_t, 3> vertex{};  ///< in the mesh's order
  std::uint32_t id = 0;
  std::uint32_t material = 0;
  std::uint32_t flags = 0;
};
static_assert(sizeof(Record) == 64);

/// A thread's own memory, used again from tile to tile and from picture to picture.
struct TileScratch {
  static constexpr std::size_t kPadding = 16;      ///< lanes beyond a tile's right edge are written to, and never read
  static constexpr std::size_t kFragments = 2048;  ///< that are shaded at a time

  /// What shading makes of every part, kept together: one line of the cache, which resolving adds up at once.
  enum Term : std::size_t { ambient = 0, diffuse = 3, specular = 6, emission = 9, fog = 12, terms = 16 };
  /// What layers ask for beside it.
  enum Output : std::size_t { scene_part = 0, albedo = 3, normal = 6, position = 9, weights = 12, depth = 15, outputs = 16 };

  TileArea area{};                    ///< of the tile at hand
  std::size_t stride = 0;             ///< floats a row
  std::size_t plane = 0;              ///< floats a sample's plane
  std::vector<float> depth_key;       ///< samples x tile_height x stride
  std::vector<std::uint32_t> winner;  ///< an entry of `records`
  std::vector<Record> records;
  std::size_t record_count = 0;

  // The vertices of the cluster at hand, on the image.
  struct ScreenVertex {
    std::int32_t x = 0, y = 0;  ///< 1/256 pixel
    float key = 0;
    float unused = 0;  ///< so that 16 bytes are one vertex
  };
  alignas(64) std::array<ScreenVertex, Cluster::kMaxVertices + kPadding> vertices{};

  /// Fragments that wait for shading. They are sorted by material, so that lanes share one.
  struct Fragments {
    std::size_t count = 0;
    alignas(64) std::array<std::uint32_t, kFragments + kPadding> record{};
    alignas(64) std::array<std::int32_t, kFragments + kPadding> x{}, y{};  ///< where it is shaded, 1/256 pixel
  };
  Fragments whole;  ///< each is all of its pixel
  Fragments parts;  ///< of pixels that show several, or the background, too; or whose layers are stored
  std::array<std::uint32_t, kFragments + kPadding> part_place{};  ///< where sorting has put a part
  std::array<float, kFragments + kPadding> part_amount{};         ///< samples, each by what of it the part brings to the eye
  alignas(64) std::array<float, (kFragments + kPadding) * terms> part_terms{};
  std::array<std::array<float, kFragments + kPadding>, outputs> output{};
  std::vector<float> light_output;            ///< lights x 3 x (kFragments + kPadding), where layers of lights are stored
  std::vector<std::uint32_t> material_begin;  ///< for sorting
  std::vector<Vec3f> light_parts;
  std::vector<Reflection<float>> reflections;  ///< of every light by the material at hand

  static constexpr std::size_t kStrip = 256;  ///< fragments that go through shading together
  std::vector<float> visibilities;            ///< (lights, then what surrounds) x kStrip, where the scene looks beyond surfaces: what arrives

  /// A blended triangle in a pixel, in front of what some of its samples show behind it.
  struct Sheet {
    std::uint32_t record = 0;   ///< of `records`
    std::uint32_t next = 0;     ///< of the same pixel, an entry of `sheets`; Record::kNone: the last
    std::uint32_t samples = 0;  ///< bit i: sample i shows it
    std::int32_t x = 0, y = 0;  ///< where it is shaded, 1/256 pixel
    float opacity = 0;          ///< below 0: not known yet
    std::uint32_t part = 0;     ///< an entry of `pixel_parts`, or Record::kNone
  };
  /// A sheet in the order of depth.
  struct SheetPlace {
    std::uint64_t key = 0;    ///< as reference/visibility.hpp's: the larger, the nearer
    std::uint32_t sheet = 0;  ///< an entry of `sheets`
  };
  /// A triangle that a pixel shows.
  struct PixelPart {
    std::uint32_t record = 0;
    std::int32_t x = 0, y = 0;  ///< where it is shaded, 1/256 pixel
    float amount = 0;           ///< as part_amount
  };
  static constexpr std::size_t kSheets = std::size_t{1} << 17;  ///< that are kept at a time; a row of pixels keeps what it needs
  std::vector<Sheet> sheets;
  std::size_t sheet_count = 0;
  bool has_too_many_sheets = false;
  std::vector<std::uint32_t> first_sheet;  ///< of a pixel, an entry of `sheets`
  std::vector<SheetPlace> sheet_places;    ///< of a pixel
  std::vector<PixelPart> pixel_parts;      ///< of a pixel, in their order

  std::vector<std::uint32_t> sorted_clusters;  ///< the tile's, the nearest first
  std::size_t sorted_count = 0;
  static constexpr int kBlockWidth = 16;  ///< pixels
  static constexpr int kBlockHeight = 8;
  std::vector<float> block_farthest;  ///< the smallest depth key in each block; -1: nothing drawn yet; below: to be found again
  std::size_t blocks_x = 0;

  double visibility_ms = 0;
  double shading_ms = 0;
  std::uint64_t pixels_covered = 0;

  /// Room for tiles of this frame. Allocates only where the last frame was smaller.
  void fit(const Frame& frame);
  /// Room for so many clusters of a tile.
  void grow_sorted(std::size_t count);
  /// At least one more record.
  void grow_records();
  /// At least one more sheet.
  void grow_sheets();
  /// Room for a pixel with so many sheets.
  void fit_sheets_of_pixel(std::size_t count);
};

/// One instruction set's kernels.
struct Kernels {
  /// Fills depth_key, winner and records from all that touches the tile.
  void (*fill_tile)(const Frame& frame, std::size_t tile, TileScratch& scratch);
  /// Fills depth_key alone, from all that touches the tile.
  void (*fill_keys)(const Frame& frame, std::size_t tile, TileScratch& scratch);
  /// Shades what is seen and stores the tile's pixels.
  void (*shade_tile)(const Frame& frame, std::size_t tile, TileScratch& scratch);
};

}  // namespace lustro
