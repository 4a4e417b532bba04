// Culling by bounding boxes and normal cones: the box's image coordinates as intervals, a little wider than what rounding can move a vertex; and
// faces that look away by more than snapping to the image's grid can turn them.
#include "raster/bins.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "parallel/parallel_for.hpp"

namespace lustro {
namespace {

constexpr std::size_t kStretch = 512;  // clusters that one job looks at

struct Interval {
  float low = 0, high = 0;
  float slack = 0;  // of it what rounding may add

  [[nodiscard]] float largest() const { return std::max(std::abs(low), std::abs(high)); }
};

/// One row of an affine transform over a box; `slack` bounds what rounding adds.
Interval transform(const float* row, const Vec3f& center, const Vec3f& extent) {
  const float middle = ((row[0] * center.x + row[1] * center.y) + row[2] * center.z) + row[3];
  const float reach = (std::abs(row[0]) * extent.x + std::abs(row[1]) * extent.y) + std::abs(row[2]) * extent.z;
  const float size = ((std::abs(row[0] * center.x) + std::abs(row[1] * center.y)) + std::abs(row[2] * center.z)) + std::abs(row[3]);
  const float slack = 1e-6F * (size + reach);
  return {middle - (reach + slack), middle + (reach + slack), slack};
}

/// What a cluster is to the picture.
struct Sight {
  enum class Kind : std::uint8_t { hidden, whole, loose } kind = Kind::hidden;
  TileRange tiles{};
  VisibleCluster cluster;
};

/// Whether the image shows every triangle of the cluster from the side that is not drawn.
///
/// Which side is seen is decided by the corners on the image's grid (reference/triangle.cpp), so the cone alone does not say it: a triangle
/// that is thinner there than corners are moved may turn over. A triangle of altitude h whose normal and line of sight enclose an angle of
/// cosine c has an altitude of at least p h c near^2 / (far^3 k) pixels, with p the pixels of a unit at distance 1 and k the most that
/// looking askance stretches an edge; it keeps its side if that is more than twice what a corner is moved by.
///
/// blur  what rounding may move a corner by, pixels
bool looks_away(const PreparedScene& scene, const Instance& instance, const Cluster& cluster, const NormalCone& cone, const Interval& depth,
                float widest_x, float widest_y, float blur) {
  const View& view = scene.view;
  constexpr double kCosine = 0.1;
  const bool is_perspective = view.projection == Projection::perspective;
  const Vec3d lower = vec_cast<double>(cluster.lower);
  const Vec3d upper = vec_cast<double>(cluster.upper);
  const Vec3d sight = is_perspective ? (lower + upper) * 0.5 - instance.eye : instance.eye;
  const double distance = length(sight);
  const double radius = is_perspective ? length(upper - lower) * 0.5 : 0;
  if (!(distance > radius) || !(cone.cosine > 0)) {
    return false;
  }
  // The angles between the cone's axis and the sight, of the cone, and of the ball around the box as the eye sees it: cosine and sine of the
  // sum.
  double cosine = (instance.cull == Culling::back ? 1 : -1) * dot(vec_cast<double>(cone.axis), sight) / distance;
  double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  const auto widen = [&](double c, double s) {
    const double sum = cosine * c - sine * s;
    sine = sine * c + cosine * s;
    cosine = sum;
    return cosine > kCosine;
  };
  const auto rest = [](double v) { return std::sqrt(std::max(0.0, 1 - v * v)); };
  const auto cone_cosine = static_cast<double>(cone.cosine);
  if (!(cosine > kCosine) || !widen(cone_cosine, rest(cone_cosine)) || !widen(rest(radius / distance), radius / distance)) {
    return false;
  }
  const std::array<float, 12>& m = instance.image_from_object.m;
  const double pixels = length(vec_cast<double>(Vec3f{m[0], m[1], m[2]}));
  double altitude = pixels * static_cast<double>(cone.thinnest) * kCosine;
  if (is_perspective) {
    const auto near = static_cast<double>(depth.low);
    const auto far = static_cast<double>(depth.high);
    const double x = static_cast<double>(widest_x) / view.pixels_per_unit;
    const double y = static_cast<double>(widest_y) / view.pixels_per_unit;
    altitude *= near * near / (far * far * far * std::sqrt(1 + x * x + y * y));
  }
  constexpr double kSnapping = 0.003;  // half a step of the grid in x and in y: 2^0.5 / 512
  return altitude > 2 * (kSnapping + static_cast<double>(blur)) * 1.01;
}

Sight look_at(const Frame& frame, const Instance& instance, const Cluster& cluster, const NormalCone* cone) {
  const View& view = frame.scene->view;
  const Vec3f center = (cluster.lower + cluster.upper) * 0.5F;
  const Vec3f extent = (cluster.upper - cluster.lower) * 0.5F;
  const float* m = instance.image_from_object.m.data();
  const Interval x = transform(m, center, extent);
  const Interval y = transform(m + 4, center, extent);
  const Interval depth = transform(m + 8, center, extent);
  if (depth.high < view.depth_near || depth.low > view.depth_far) {
    return {};
  }
  const bool is_perspective = view.projection == Projection::perspective;
  // In pixels, from the image's centre.
  constexpr float kGuardBand = 24000;  // a little less than the reference's
  Sight sight;
  sight.kind = Sight::Kind::loose;
  Interval px{-kGuardBand, kGuardBand};
  Interval py{-kGuardBand, kGuardBand};
  if (depth.low > view.depth_near) {  // false for NaN
    const float widest = is_perspective ? 1 / depth.low : 1;
    const float narrowest = is_perspective ? 1 / depth.high : 1;
    const auto project = [&](const Interval& v) {
      return Interval{std::min(v.low * widest, v.low * narrowest), std::max(v.high * widest, v.high * narrowest)};
    };
    px = project(x);
    py = project(y);
    if (px.low > -kGuardBand && px.high < kGuardBand && py.low > -kGuardBand && py.high < kGuardBand) {
      sight.kind = Sight::Kind::whole;
      const float moved = is_perspective ? ((x.slack + y.slack) + (px.largest() + py.largest()) * depth.slack) * widest : x.slack + y.slack;
      const float rounded = 5e-7F * ((px.largest() + py.largest()) + (view.center_x + view.center_y));
      if (cone != nullptr && looks_away(*frame.scene, instance, cluster, *cone, depth, px.largest(), py.largest(), moved + rounded)) {
        return {};
      }
    }
    sight.cluster.nearest =
        is_perspective ? widest * 1.0001F : (view.depth_far - depth.low) / (view.depth_far - view.depth_near) * 1.0001F + 1e-6F;
  }
  const auto tile = [](float pixels, int size, int tiles) {
    return static_cast<int>(std::clamp(std::floor(pixels / static_cast<float>(size)), 0.0F, static_cast<float>(tiles - 1)));
  };
  constexpr float kMargin = 1.5F;  // half a pixel for samples, and snapping
  const float left = px.low + view.center_x - kMargin;
  const float right = px.high + view.center_x + kMargin;
  const float top = py.low + view.center_y - kMargin;
  const float bottom = py.high + view.center_y + kMargin;
  if (sight.kind == Sight::Kind::whole &&
      (right < 0 || bottom < 0 || left > static_cast<float>(view.width) || top > static_cast<float>(view.height))) {
    return {};
  }
  const auto pixel = [](float v, int size) { return static_cast<std::int16_t>(std::clamp(std::floor(v), 0.0F, static_cast<float>(size - 1))); };
  sight.cluster.left = pixel(left, view.width);
  sight.cluster.right = pixel(right, view.width);
  sight.cluster.top = pixel(top, view.height);
  sight.cluster.bottom = pixel(bottom, view.height);
  sight.tiles = {tile(left, frame.tile_width, frame.tiles_x), tile(top, frame.tile_height, frame.tiles_y),
                 tile(right, frame.tile_width, frame.tiles_x), tile(bottom, frame.tile_height, frame.tiles_y)};
  return sight;
}

void cut_into_parts(const PreparedScene& scene, BinWork& work) {
  work.used = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const auto count = static_cast<std::uint32_t>(scene.instances[i].drawable->clusters.clusters.size());
    for (std::uint32_t first = 0; first < count; first += kStretch) {
      if (work.used == work.parts.size()) {
        work.parts.emplace_back();
      }
      BinWork::Part& part = work.parts[work.used++];
      part.instance = i;
      part.first = first;
      part.last = std::min(count, first + static_cast<std::uint32_t>(kStretch));
      part.clusters.clear();
      part.ranges.clear();
      part.loose.clear();
    }
  }
}

/// Counts, then fills. `range_of(i)` is where item i lies.
template <class RangeOf>
void make_lists(const Frame& frame, std::size_t count, RangeOf&& range_of, TileLists& lists) {
  const auto tiles = static_cast<std::size_t>(frame.tiles_x) * static_cast<std::size_t>(frame.tiles_y);
  lists.begin.assign(tiles + 1, 0);
  const auto each_tile = [&](std::size_t i, auto&& visit) {
    const TileRange range = range_of(i);
    for (int y = range.top; y <= range.bottom; ++y) {
      for (int x = range.left; x <= range.right; ++x) {
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.tiles_x) + static_cast<std::size_t>(x));
      }
    }
  };
  for (std::size_t i = 0; i < count; ++i) {
    each_tile(i, [&](std::size_t tile) { ++lists.begin[tile]; });
  }
  std::uint32_t sum = 0;
  for (std::uint32_t& begin : lists.begin) {
    const std::uint32_t size = begin;
    begin = sum;
    sum += size;
  }
  lists.entries.resize(sum);
  for (std::size_t i = 0; i < count; ++i) {
    each_tile(i, [&](std::size_t tile) { lists.entries[lists.begin[tile]++] = static_cast<std::uint32_t>(i); });
  }
  for (std::size_t tile = tiles; tile > 0; --tile) {  // filling moved every begin to its end
    lists.begin[tile] = lists.begin[tile - 1];
  }
  lists.begin[0] = 0;
}

}  // namespace

void lay_out_geometry(Frame& frame, const PreparedScene& scene, int tile) {
  const View& view = scene.view;
  frame.scene = &scene;
  frame.tile_width = tile;
  frame.tile_height = view.samples <= 2 ? tile : (view.samples <= 8 ? tile / 2 : tile / 4);  // samples of a tile stay in the cache
  frame.tiles_x = (view.width + frame.tile_width - 1) / frame.tile_width;
  frame.tiles_y = (view.height + frame.tile_height - 1) / frame.tile_height;
  frame.pattern = sample_pattern(view.samples);
  frame.lowest = frame.highest = frame.pattern[0];
  for (const SampleOffset& offset : frame.pattern) {
    frame.lowest = {std::min(frame.lowest.x, offset.x), std::min(frame.lowest.y, offset.y)};
    frame.highest = {std::max(frame.highest.x, offset.x), std::max(frame.highest.y, offset.y)};
  }
  frame.farthest = depth_key_of(view, view.depth_far);
  frame.material_instance.assign(scene.materials.size(), 0);
  frame.alpha_modes = 0;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    frame.alpha_modes |= scene.instances[i].alpha_modes;
    const std::size_t end = i + 1 < scene.instances.size() ? scene.instances[i + 1].first_material : scene.materials.size();
    std::fill(frame.material_instance.data() + scene.instances[i].first_material, frame.material_instance.data() + end, i);
  }
}

void sort_into_tiles(Frame& frame, BinWork& work, int threads) {
  const PreparedScene& scene = *frame.scene;
  cut_into_parts(scene, work);
  const auto look = [&](std::size_t p) {
    BinWork::Part& part = work.parts[p];
    const Instance& instance = scene.instances[part.instance];
    const Clusters& clusters = instance.drawable->clusters;
    const bool has_cones = instance.cull != Culling::none && instance.is_similarity && !instance.drawable->cones.empty();
    for (std::uint32_t c = part.first; c < part.last; ++c) {
      const Cluster& cluster = clusters.clusters[c];
      const Sight sight = look_at(frame, instance, cluster, has_cones ? &instance.drawable->cones[c] : nullptr);
      if (sight.kind == Sight::Kind::whole) {
        part.clusters.push_back(sight.cluster);
        part.clusters.back().instance = part.instance;
        part.clusters.back().cluster = c;
        part.ranges.push_back(sight.tiles);
      } else if (sight.kind == Sight::Kind::loose) {
        for (std::uint32_t t = 0; t < cluster.triangles; ++t) {
          setup_triangle(scene, part.instance, clusters.triangle_at(cluster.first_triangle + t), part.loose);
        }
      }
    }
  };
  parallel_for(work.used, threads, std::ref(look));  // a reference, because std::function would allocate for the lambda itself
  frame.clusters.clear();
  frame.loose.clear();
  work.ranges.clear();
  for (const BinWork::Part& part : std::span(work.parts).first(work.used)) {
    frame.clusters.insert(frame.clusters.end(), part.clusters.begin(), part.clusters.end());
    frame.loose.insert(frame.loose.end(), part.loose.begin(), part.loose.end());
    work.ranges.insert(work.ranges.end(), part.ranges.begin(), part.ranges.end());
  }
  make_lists(
      frame, work.ranges.size(), [&](std::size_t i) { return work.ranges[i]; }, frame.cluster_lists);
  make_lists(
      frame, frame.loose.size(),
      [&](std::size_t i) {
        const ScreenTriangle& t = frame.loose[i];
        const auto [low_x, high_x] = std::minmax({t.x[0], t.x[1], t.x[2]});
        const auto [low_y, high_y] = std::minmax({t.y[0], t.y[1], t.y[2]});
        const auto tile = [](std::int32_t units, int size, int tiles) { return std::clamp((units >> 8) / size, 0, tiles - 1); };
        return TileRange{
            tile(low_x - kSubpixelUnits, frame.tile_width, frame.tiles_x), tile(low_y - kSubpixelUnits, frame.tile_height, frame.tiles_y),
            tile(high_x + kSubpixelUnits, frame.tile_width, frame.tiles_x), tile(high_y + kSubpixelUnits, frame.tile_height, frame.tiles_y)};
      },
      frame.loose_lists);
}

}  // namespace lustro
