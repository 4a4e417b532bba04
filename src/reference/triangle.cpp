// Projection, clipping against the near plane and the guard band (Sutherland and Hodgman 1974), snapping to 8 subpixel bits.
#include "reference/triangle.hpp"

#include <algorithm>
#include <cmath>

#include "parallel/parallel_for.hpp"
#include "scene/samples.hpp"

namespace lustro {
namespace {

// Corners may lie this far from the image's centre; with images of at most 16384 pixels, coordinates stay within +-2^15 pixels, so that 1/256
// pixel is exact in a float and an edge function fits 64 bits by far.
constexpr float kGuardBand = 24576;

// A corner before projection. For an orthographic view x and y are pixels already and depth is not divided by.
struct ClipVertex {
  float x = 0, y = 0, depth = 0;
  Vec3f weights;
};

// At most a triangle cut by five planes.
struct Polygon {
  std::array<ClipVertex, 8> corners;
  std::size_t size = 0;
  void add(const ClipVertex& v) { corners[size++] = v; }
};

// Signed distance to plane `plane`, >= 0 inside.
float distance_to(const View& view, int plane, const ClipVertex& v) {
  const float limit = view.projection == Projection::perspective ? kGuardBand * v.depth : kGuardBand;
  switch (plane) {
    case 0:
      return v.depth - view.depth_near;
    case 1:
      return limit - v.x;
    case 2:
      return limit + v.x;
    case 3:
      return limit - v.y;
    default:
      return limit + v.y;
  }
}

// Where the edge crosses the plane, computed from its inner to its outer end, so that both triangles at a shared edge get the same point.
ClipVertex crossing(const ClipVertex& inside, const ClipVertex& outside, float inner, float outer) {
  const float t = inner / (inner - outer);
  return {inside.x + (outside.x - inside.x) * t, inside.y + (outside.y - inside.y) * t, inside.depth + (outside.depth - inside.depth) * t,
          inside.weights + (outside.weights - inside.weights) * t};
}

Polygon clip(const View& view, Polygon polygon) {
  for (int plane = 0; plane < 5; ++plane) {
    Polygon kept;
    for (std::size_t i = 0; i < polygon.size; ++i) {
      const ClipVertex& a = polygon.corners[i];
      const ClipVertex& b = polygon.corners[(i + 1) % polygon.size];
      const float da = distance_to(view, plane, a);
      const float db = distance_to(view, plane, b);
      if (da >= 0) {
        kept.add(a);
      }
      if ((da >= 0) != (db >= 0)) {
        kept.add(da >= 0 ? crossing(a, b, da, db) : crossing(b, a, db, da));
      }
    }
    polygon = kept;
  }
  return polygon;
}

std::int32_t snap(float pixels) {
  return static_cast<std::int32_t>(std::floor(pixels * kSubpixelUnits + 0.5F));
}

// One corner on the image.
struct ScreenCorner {
  std::int32_t x, y;
  float depth_key;
  Vec3f weights;
};
ScreenCorner project(const View& view, const ClipVertex& v) {
  const float scale = view.projection == Projection::perspective ? 1.0F / v.depth : 1.0F;
  return {snap(v.x * scale + view.center_x), snap(v.y * scale + view.center_y), depth_key_of(view, v.depth), v.weights};
}

bool touches_image(const View& view, const ScreenTriangle& t) {
  const auto [left, right] = std::minmax({t.x[0], t.x[1], t.x[2]});
  const auto [top, bottom] = std::minmax({t.y[0], t.y[1], t.y[2]});
  return right >= 0 && left <= view.width * kSubpixelUnits && bottom >= 0 && top <= view.height * kSubpixelUnits;
}

}  // namespace

float depth_key_of(const View& view, float depth) {
  return view.projection == Projection::perspective ? 1.0F / depth : (view.depth_far - depth) / (view.depth_far - view.depth_near);
}

float depth_of(const View& view, float depth_key) {
  return view.projection == Projection::perspective ? 1.0F / depth_key : view.depth_far - depth_key * (view.depth_far - view.depth_near);
}

std::array<std::int64_t, 3> edges_at(const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  return {edge_function(t.x[1], t.y[1], t.x[2], t.y[2], px, py), edge_function(t.x[2], t.y[2], t.x[0], t.y[0], px, py),
          edge_function(t.x[0], t.y[0], t.x[1], t.y[1], px, py)};
}

bool covers(const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const std::array<std::int64_t, 3> e = edges_at(t, px, py);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t from = (i + 1) % 3;
    const std::size_t to = (i + 2) % 3;
    // With y down and a positive area the corners run clockwise as seen: a top edge runs right, a left edge runs up.
    const bool is_top_left = t.y[to] < t.y[from] || (t.y[to] == t.y[from] && t.x[to] > t.x[from]);
    if (e[i] < 0 || (e[i] == 0 && !is_top_left)) {
      return false;
    }
  }
  return true;
}

float depth_key_at(const ScreenTriangle& t, const std::array<std::int64_t, 3>& edges) {
  const float inverse_area = 1.0F / static_cast<float>(t.area2);
  const float slope1 = (t.depth_key[1] - t.depth_key[0]) * inverse_area;
  const float slope2 = (t.depth_key[2] - t.depth_key[0]) * inverse_area;
  return (t.depth_key[0] + slope1 * static_cast<float>(edges[1])) + slope2 * static_cast<float>(edges[2]);
}

namespace {

// Weights of the screen triangle's own corners.
struct CornerWeights {
  float key, w0, w1, w2;
};
CornerWeights corner_weights_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const std::array<std::int64_t, 3> edges = edges_at(t, px, py);
  const float key = depth_key_at(t, edges);
  const float inverse_area = 1.0F / static_cast<float>(t.area2);
  float w1 = static_cast<float>(edges[1]) * inverse_area;
  float w2 = static_cast<float>(edges[2]) * inverse_area;
  if (view.projection == Projection::perspective) {  // b_i / w_i is linear on the image, and 1/w is the depth key
    const float depth = 1.0F / key;
    w1 = (w1 * t.depth_key[1]) * depth;
    w2 = (w2 * t.depth_key[2]) * depth;
  }
  return {key, (1.0F - w1) - w2, w1, w2};
}

// From the corners of the screen triangle to the vertices of the mesh's: linear, so for weights and their slopes alike.
Vec3f at_vertices(const ScreenTriangle& t, float w0, float w1, float w2) {
  if (!t.is_clipped) {
    return t.is_swapped ? Vec3f{w0, w2, w1} : Vec3f{w0, w1, w2};
  }
  return (t.corner_weights[0] * w0 + t.corner_weights[1] * w1) + t.corner_weights[2] * w2;
}

}  // namespace

Interpolants interpolants_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const CornerWeights at = corner_weights_at(view, t, px, py);
  return {at.key, at_vertices(t, at.w0, at.w1, at.w2)};
}

WeightSlopes<float> weight_slopes_at(const View& view, const ScreenTriangle& t, std::int32_t px, std::int32_t py) {
  const CornerWeights at = corner_weights_at(view, t, px, py);
  const bool is_perspective = view.projection == Projection::perspective;
  const auto of = corner_slopes<float>(is_perspective, t.x, t.y, 1.0F / static_cast<float>(t.area2), t.depth_key);
  const WeightSlopes<float> corners = weight_slopes(is_perspective, of, at.w1, at.w2, depth_of(view, at.key));
  const Vec3f dx = at_vertices(t, corners.dx[0], corners.dx[1], corners.dx[2]);
  const Vec3f dy = at_vertices(t, corners.dy[0], corners.dy[1], corners.dy[2]);
  return {{dx.x, dx.y, dx.z}, {dy.x, dy.y, dy.z}};
}

void setup_triangle(const PreparedScene& scene, std::uint32_t instance_index, std::uint32_t index, std::vector<ScreenTriangle>& out) {
  const Instance& instance = scene.instances[instance_index];
  const auto& corners = instance.mesh->triangles[index];
  const Culling cull = scene.materials[instance.material_of(index)].cull;
  Polygon polygon;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3f p = instance.image_from_object(instance.mesh->positions[corners[i]]);
    polygon.add({p.x, p.y, p.z, Vec3f{i == 0 ? 1.0F : 0.0F, i == 1 ? 1.0F : 0.0F, i == 2 ? 1.0F : 0.0F}});
  }
  bool is_inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int plane = 0; plane < 5; ++plane) {
      is_inside = is_inside && distance_to(scene.view, plane, polygon.corners[i]) >= 0;  // false for NaN
    }
  }
  if (!is_inside) {
    polygon = clip(scene.view, polygon);
  }
  for (std::size_t i = 2; i < polygon.size; ++i) {
    std::array<ScreenCorner, 3> c{project(scene.view, polygon.corners[0]), project(scene.view, polygon.corners[i - 1]),
                                  project(scene.view, polygon.corners[i])};
    std::int64_t area2 = edge_function(c[0].x, c[0].y, c[1].x, c[1].y, c[2].x, c[2].y);
    if (area2 == 0) {
      continue;
    }
    // Counter-clockwise with y up is a negative area with y down.
    const bool is_front = (area2 < 0) != instance.is_mirrored;
    if (cull == (is_front ? Culling::front : Culling::back)) {
      continue;
    }
    const bool is_swapped = area2 < 0;
    if (is_swapped) {
      std::swap(c[1], c[2]);
      area2 = -area2;
    }
    ScreenTriangle t;
    t.id = instance.first_triangle + index;
    t.instance = instance_index;
    t.is_front = is_front;
    t.area2 = area2;
    t.is_swapped = is_swapped;
    t.is_clipped = !is_inside;
    for (std::size_t k = 0; k < 3; ++k) {
      t.x[k] = c[k].x;
      t.y[k] = c[k].y;
      t.depth_key[k] = c[k].depth_key;
      t.corner_weights[k] = c[k].weights;
    }
    if (touches_image(scene.view, t)) {
      out.push_back(t);
    }
  }
}

std::vector<ScreenTriangle> setup_triangles(const PreparedScene& scene, int threads) {
  constexpr std::uint32_t kChunk = 4096;
  struct Chunk {
    std::uint32_t instance, first, last;
    std::vector<ScreenTriangle> triangles;
  };
  std::vector<Chunk> chunks;
  for (std::uint32_t i = 0; i < scene.instances.size(); ++i) {
    const auto count = static_cast<std::uint32_t>(scene.instances[i].mesh->triangles.size());
    for (std::uint32_t first = 0; first < count; first += kChunk) {
      chunks.push_back({i, first, std::min(count, first + kChunk), {}});
    }
  }
  parallel_for(chunks.size(), threads, [&](std::size_t c) {
    for (std::uint32_t t = chunks[c].first; t < chunks[c].last; ++t) {
      setup_triangle(scene, chunks[c].instance, t, chunks[c].triangles);
    }
  });
  std::vector<ScreenTriangle> all;
  for (Chunk& chunk : chunks) {
    all.insert(all.end(), chunk.triangles.begin(), chunk.triangles.end());
    chunk.triangles = {};
  }
  return all;
}

}  // namespace lustro
