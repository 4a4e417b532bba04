// See occlusion_maps.hpp. A direction's triangles are drawn one after the other, by integers and with the rule of the upper left edge, so that
// lines through the edge of two triangles meet one of them; the depths of a line are kept sorted, in whatever order they come.
#include "scene/occlusion_maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "math/trig.hpp"
#include "parallel/parallel_for.hpp"
#include "scene/prepare.hpp"

namespace lustro {
namespace {

constexpr int kMargin = 2;                                 // lines at the map's edges that meet nothing
constexpr double kDeepest = 65000;                         // layers' units through the whole scene
constexpr std::int32_t kSubline = 256;                     // the corners' places are rounded to this part of the distance of two lines
constexpr std::size_t kMostWords = std::size_t{1} << 29U;  // 2 GiB
constexpr auto kWords = static_cast<std::size_t>(ShadingOcclusion::kWords);
constexpr auto kLayers = static_cast<std::size_t>(ShadingOcclusion::kLayers);

using Layers = std::array<std::uint16_t, kLayers>;  // of a line

// Spread evenly over a hemisphere: the points of a spherical spiral (Gonzalez 2010, Fibonacci lattice).
Vec3d direction_of(int i, int count) {
  constexpr double kGoldenAngle = 137.50776405003785;  // degrees
  const double height = 1 - (i + 0.5) / count;
  const double radius = std::sqrt(1 - height * height);
  const double angle = i * kGoldenAngle - 360 * std::floor(i * kGoldenAngle / 360);
  return {radius * cosine_deg(angle), height, radius * sine_deg(angle)};
}

// A corner on a map.
struct Corner {
  std::int32_t x, y;  // 1 / kSubline
  float depth;
};

// Where the line's new depth belongs. Of more than there is room for the deepest are lost.
void add_depth(Layers& line, std::uint16_t depth) {
  for (std::uint16_t& layer : line) {
    if (depth < layer) {
      std::swap(depth, layer);
    }
  }
}

// Twice the area of the triangle to the right of a b.
std::int64_t area_of(const Corner& a, const Corner& b, std::int32_t x, std::int32_t y) {
  return static_cast<std::int64_t>(b.x - a.x) * (y - a.y) - static_cast<std::int64_t>(b.y - a.y) * (x - a.x);
}

// 0 where points on the edge belong to the triangle, else 1.
std::int64_t bias_of(const Corner& a, const Corner& b) {
  const bool is_top = a.y == b.y && b.x > a.x;
  return is_top || b.y < a.y ? 0 : 1;
}

// The map's lines, row by row.
struct Grid {
  std::vector<Layers> lines;
  std::int32_t size = 0;

  void draw(Corner a, Corner b, Corner c) {
    const auto first = [](std::int32_t least) { return (least + kSubline / 2 - 1) >> 8; };  // the first centre at or after it
    const auto last = [](std::int32_t most) { return (most - kSubline / 2) >> 8; };
    const std::int32_t left = std::max(first(std::min({a.x, b.x, c.x})), 0);
    const std::int32_t right = std::min(last(std::max({a.x, b.x, c.x})), size - 1);
    const std::int32_t top = std::max(first(std::min({a.y, b.y, c.y})), 0);
    const std::int32_t bottom = std::min(last(std::max({a.y, b.y, c.y})), size - 1);
    if (left > right || top > bottom) {
      return;
    }
    std::int64_t area = area_of(a, b, c.x, c.y);
    if (area == 0) {
      return;
    }
    if (area < 0) {
      std::swap(b, c);
      area = -area;
    }
    const float inverse = 1.0F / static_cast<float>(area);
    const std::array bias{bias_of(b, c), bias_of(c, a), bias_of(a, b)};
    for (std::int32_t y = top; y <= bottom; ++y) {
      for (std::int32_t x = left; x <= right; ++x) {
        const std::int32_t px = x * kSubline + kSubline / 2;
        const std::int32_t py = y * kSubline + kSubline / 2;
        const std::int64_t of_a = area_of(b, c, px, py);
        const std::int64_t of_b = area_of(c, a, px, py);
        const std::int64_t of_c = area_of(a, b, px, py);
        if (of_a < bias[0] || of_b < bias[1] || of_c < bias[2]) {
          continue;
        }
        const float depth =
            a.depth + ((b.depth - a.depth) * (static_cast<float>(of_b) * inverse) + (c.depth - a.depth) * (static_cast<float>(of_c) * inverse));
        const float kept = lane_min(lane_max(depth, 0.0F), static_cast<float>(ShadingOcclusion::kNothing - 1));
        add_depth(lines[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) + static_cast<std::size_t>(x)],
                  static_cast<std::uint16_t>(kept));
      }
    }
  }
};

bool hides(const ShadingMaterial& material) {
  return material.opacity.mode != AlphaMode::blend || material.opacity.opacity >= 0.5F;
}

void draw_direction(const PreparedScene& scene, const OcclusionLines& direction, Grid& grid, std::vector<Corner>& corners) {
  constexpr std::int32_t kFarthest = (1024 + 16) * kSubline;  // beyond every map: no difference of two of them leaves the integers
  const auto place = [](float at) {
    return static_cast<std::int32_t>(
        std::floor(lane_min(lane_max(at * kSubline + 0.5F, static_cast<float>(-kFarthest)), static_cast<float>(kFarthest))));
  };
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = *instance.mesh;
    corners.resize(mesh.positions.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3f at = direction.place(instance.relative_from_object(mesh.positions[i]));
      corners[i] = {place(at.x), place(at.y), at.z};
    }
    const bool may_let_through = (instance.alpha_modes & bit_of(AlphaMode::blend)) != 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (may_let_through && !hides(scene.materials[instance.material_of(static_cast<std::uint32_t>(t))])) {
        continue;
      }
      const auto& triangle = mesh.triangles[t];
      grid.draw(corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]);
    }
  }
}

}  // namespace

Result<void> plan_occlusion(const OcclusionSettings& settings, const Extent& extent, const Vec3d& eye, OcclusionMaps& maps) {
  maps.clear();
  const auto size = static_cast<std::size_t>(settings.size);
  if (static_cast<std::size_t>(settings.directions) * size * size * kWords > kMostWords) {
    return fail(ErrorKind::limit, "occlusion",
                fmt::format("{} directions of {} x {} lines are more than 2^27 lines", settings.directions, settings.size, settings.size));
  }
  const Vec3d middle = (extent.bounds.lower + extent.bounds.upper) * 0.5;
  const double diagonal = length(extent.bounds.upper - extent.bounds.lower);
  const double across = diagonal > 0 ? diagonal : 1;  // whatever the direction, the whole scene is within
  const double lines = (settings.size - 2 * kMargin) / across;
  const double deep = kDeepest / across;
  const double radius = settings.radius.value_or(0.25 * across);
  for (int i = 0; i < settings.directions; ++i) {
    const Vec3d up = direction_of(i, settings.directions);
    const Vec3d right = normalize(cross(std::abs(up.y) < 0.9 ? Vec3d{0, 1, 0} : Vec3d{1, 0, 0}, up));
    const Vec3d below = cross(right, up);
    const Vec3d from = eye - middle;
    const double center = 0.5 * settings.size;
    maps.directions.push_back(
        {to_rows({right * lines, below * lines, up * -deep},
                 {dot(right, from) * lines + center, dot(below, from) * lines + center, 0.5 * kDeepest - dot(up, from) * deep}),
         vec_cast<float>(up)});
  }
  maps.shading.size = settings.size;
  maps.shading.across = static_cast<float>(lines);
  maps.shading.deep = static_cast<float>(deep);
  maps.shading.lift = static_cast<float>(static_cast<double>(ShadingOcclusion::kLift) / lines);
  maps.shading.reach = static_cast<float>(std::min(radius * deep, 1e20));
  return {};
}

void draw_occlusion(const PreparedScene& scene, OcclusionMaps& maps, int threads) {
  if (maps.empty()) {
    return;
  }
  const auto size = static_cast<std::size_t>(maps.shading.size);
  const std::size_t words = size * size * kWords;
  maps.layers.resize(maps.directions.size() * words);
  parallel_for(maps.directions.size(), threads, [&](std::size_t direction) {
    Grid grid;
    Layers nothing;
    nothing.fill(ShadingOcclusion::kNothing);
    grid.size = maps.shading.size;
    grid.lines.assign(size * size, nothing);
    std::vector<Corner> corners;
    draw_direction(scene, maps.directions[direction], grid, corners);
    std::int32_t* to = &maps.layers[direction * words];
    for (const Layers& line : grid.lines) {
      for (std::size_t word = 0; word < kWords; ++word) {
        const std::uint32_t both = line[2 * word] | static_cast<std::uint32_t>(line[2 * word + 1]) << 16U;
        *to++ = static_cast<std::int32_t>(both);
      }
    }
  });
  maps.shading.directions = maps.directions;
  maps.shading.layers = maps.layers.data();
}

}  // namespace lustro
