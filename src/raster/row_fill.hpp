// Filling a tile: clusters to vertices, vertices to triangles, triangles to the nearest one of every sample. Part of a row (row.cpp).
//
// Every number is the reference's (reference/triangle.cpp, reference/visibility.cpp), bit for bit: image coordinates are the same integers; an
// edge function is an integer, here in 32 bits where a triangle spans less than 64 pixels and in the 53 bits of a double elsewhere; and a depth
// key is a function of the triangle and the sample alone.
#pragma once

#include <bit>
#include <cstring>
#include <type_traits>

#include "raster/frame.hpp"
#include "raster/row_sheets.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// Below this extent, 1/256 pixel, an edge function stays below 2^31 in a triangle's box and a vector's width around it.
inline constexpr std::int32_t kSmallExtent = 64 * kSubpixelUnits;

/// One triangle whose edge functions fit 32 bits: in patches where it is narrow, else in rows.
template <class AnyCanvas>
inline HWY_NOINLINE bool fill_small(const AnyCanvas& c, const Record& t, std::uint32_t record, const PixelRange& range) {
  TileScratch& s = c.scratch;
  const Float key0(t.key[0]);
  const Float slope1((t.key[1] - t.key[0]) * t.inverse_area);
  const Float slope2((t.key[2] - t.key[0]) * t.inverse_area);
  const Float farthest(c.frame.farthest);

  // Edge i lies opposite corner i: e(p) = dx (py - y_from) - dy (px - x_from)
  const auto dx0 = t.x[2] - t.x[1], dy0 = t.y[2] - t.y[1];
  const auto dx1 = t.x[0] - t.x[2], dy1 = t.y[0] - t.y[2];
  const auto dx2 = t.x[1] - t.x[0], dy2 = t.y[1] - t.y[0];
  const Int bias0(edge_bias(t.x[1], t.y[1], t.x[2], t.y[2]));
  const Int bias1(edge_bias(t.x[2], t.y[2], t.x[0], t.y[0]));
  const Int bias2(edge_bias(t.x[0], t.y[0], t.x[1], t.y[1]));
  const auto x0 = t.x[0], x1 = t.x[1], x2 = t.x[2], y0 = t.y[0], y1 = t.y[1], y2 = t.y[2];

  // How lanes lie: kColumns beside each other, kRows below each other.
  const auto fill = [&]([[maybe_unused]] auto is_patch) {
#if HWY_TARGET == HWY_SCALAR
    constexpr bool kIsPatch = false;
    constexpr std::size_t kRows = 1;
#else
    constexpr bool kIsPatch = decltype(is_patch)::value;
    constexpr std::size_t kRows = kIsPatch ? kPatchRows : 1;
#endif
    constexpr int kColumns = static_cast<int>(kLanes / kRows);
    const Int row_of = kIsPatch ? lane_numbers() >> 2 : Int(0);
    const Int column_of = kIsPatch ? lane_numbers() & Int(3) : lane_numbers();
    const Int x_of = column_of * Int(kSubpixelUnits), y_of = row_of * Int(kSubpixelUnits);
    const Int lanes0 = y_of * Int(dx0) - x_of * Int(dy0);
    const Int lanes1 = y_of * Int(dx1) - x_of * Int(dy1);
    const Int lanes2 = y_of * Int(dx2) - x_of * Int(dy2);
    const Int right0(dy0 * (kColumns * kSubpixelUnits)), right1(dy1 * (kColumns * kSubpixelUnits)), right2(dy2 * (kColumns * kSubpixelUnits));
    constexpr int kDown = static_cast<int>(kRows) * kSubpixelUnits;
    const Int down0(dx0 * kDown), down1(dx1 * kDown), down2(dx2 * kDown);
    bool has_won = false;
    for (std::size_t sample = 0; sample < c.frame.pattern.size(); ++sample) {
      const std::int32_t px = range.left * kSubpixelUnits + kSubpixelUnits / 2 + c.frame.pattern[sample].x;
      const std::int32_t py = range.top * kSubpixelUnits + kSubpixelUnits / 2 + c.frame.pattern[sample].y;
      Int row0 = lanes0 + Int(dx0 * (py - y1) - dy0 * (px - x1));
      Int row1 = lanes1 + Int(dx1 * (py - y2) - dy1 * (px - x2));
      Int row2 = lanes2 + Int(dx2 * (py - y0) - dy2 * (px - x0));
      std::size_t at = sample * s.plane + c.at(range.left, range.top);
      if constexpr (!AnyCanvas::kKeepsWinners && !kIsPatch) {
        if (range.right - range.left < 2 * kColumns) {  // what is not covered there is sooner merged than foreseen
          for (int x = range.left; x <= range.right; x += kColumns, at += static_cast<std::size_t>(kColumns)) {
            Int e0 = row0;
            Int e1 = row1;
            Int e2 = row2;
            std::size_t here = at;
            for (int y = range.top; y <= range.bottom; ++y, here += s.stride) {
              const Mask inside = !(((e0 + bias0) | (e1 + bias1) | (e2 + bias2)) < Int(0));
              merge(c, inside, (key0 + slope1 * to_float(e1)) + slope2 * to_float(e2), farthest, here, record);
              e0 = e0 + down0;
              e1 = e1 + down1;
              e2 = e2 + down2;
            }
            row0 = row0 - right0;
            row1 = row1 - right1;
            row2 = row2 - right2;
          }
          continue;
        }
      }
      for (int y = range.top; y <= range.bottom; y += static_cast<int>(kRows)) {
        Int e0 = row0;
        Int e1 = row1;
        Int e2 = row2;
        std::size_t here = at;
        for (int x = range.left;;) {
          Mask inside = !(((e0 + bias0) | (e1 + bias1) | (e2 + bias2)) < Int(0));
          if constexpr (kIsPatch) {  // rows below the tile are not its own
            inside = inside & !(row_of > Int(range.bottom - y));
          }
          if (any_of(inside)) {
            const Float key = (key0 + slope1 * to_float(e1)) + slope2 * to_float(e2);
#if HWY_TARGET != HWY_SCALAR
            if constexpr (kIsPatch) {
              has_won |= merge_patch(c, inside, key, farthest, here, record);
            } else
#endif
            {
              has_won |= merge(c, inside, key, farthest, here, record);
            }
          }
          x += kColumns;
          if (x > range.right) {
            break;
          }
          here += static_cast<std::size_t>(kColumns);
          e0 = e0 - right0;
          e1 = e1 - right1;
          e2 = e2 - right2;
        }
        at += kRows * s.stride;
        row0 = row0 + down0;
        row1 = row1 + down1;
        row2 = row2 + down2;
      }
    }
    return has_won;
  };
  return kLanes > 4 && range.right - range.left < 8 ? fill(std::true_type()) : fill(std::false_type());
}

/// One triangle of any size: the same with whole numbers in doubles.
template <class AnyCanvas>
inline HWY_NOINLINE bool fill_large(const AnyCanvas& c, const Record& t, std::uint32_t record, const PixelRange& range) {
  TileScratch& s = c.scratch;
  const Float key0(t.key[0]);
  const Float slope1((t.key[1] - t.key[0]) * t.inverse_area);
  const Float slope2((t.key[2] - t.key[0]) * t.inverse_area);
  const Float farthest(c.frame.farthest);
  constexpr std::array<std::size_t, 3> kFrom{1, 2, 0};
  constexpr std::array<std::size_t, 3> kTo{2, 0, 1};
  std::array<double, 3> dx{}, dy{}, bias{};
  std::array<Wide, 3> across;
  const Wide numbers = widen(lane_numbers() * Int(kSubpixelUnits));
  for (std::size_t i = 0; i < 3; ++i) {
    dx[i] = static_cast<double>(t.x[kTo[i]]) - static_cast<double>(t.x[kFrom[i]]);
    dy[i] = static_cast<double>(t.y[kTo[i]]) - static_cast<double>(t.y[kFrom[i]]);
    bias[i] = edge_bias(t.x[kFrom[i]], t.y[kFrom[i]], t.x[kTo[i]], t.y[kTo[i]]);
    across[i] = numbers * wide(-dy[i]);
  }
  bool has_won = false;
  for (std::size_t sample = 0; sample < c.frame.pattern.size(); ++sample) {
    const std::int32_t px = range.left * kSubpixelUnits + kSubpixelUnits / 2 + c.frame.pattern[sample].x;
    const std::int32_t py = range.top * kSubpixelUnits + kSubpixelUnits / 2 + c.frame.pattern[sample].y;
    const auto width = static_cast<double>((range.right - range.left) * kSubpixelUnits);
    const auto height = static_cast<double>((range.bottom - range.top) * kSubpixelUnits);
    std::array<double, 3> row{};
    bool is_outside = false;
    bool is_inside = true;
    for (std::size_t i = 0; i < 3; ++i) {
      row[i] = dx[i] * static_cast<double>(py - t.y[kFrom[i]]) - dy[i] * static_cast<double>(px - t.x[kFrom[i]]);
      const double largest = row[i] + ((dx[i] > 0 ? dx[i] * height : 0) + (dy[i] < 0 ? -dy[i] * width : 0));
      const double smallest = row[i] + ((dx[i] < 0 ? dx[i] * height : 0) + (dy[i] > 0 ? -dy[i] * width : 0));
      is_outside = is_outside || largest + bias[i] < 0;
      is_inside = is_inside && smallest + bias[i] >= 0;
    }
    if (is_outside) {
      continue;
    }
    std::size_t at = sample * s.plane + c.at(range.left, range.top);
    for (int y = range.top; y <= range.bottom; ++y, at += s.stride) {
      std::size_t here = at;
      std::array<double, 3> begin = row;
      for (int x = range.left; x <= range.right; x += static_cast<int>(kLanes), here += kLanes) {
        const Float e1 = narrow(across[1] + wide(begin[1]));
        const Float e2 = narrow(across[2] + wide(begin[2]));
        // Rounding keeps the sign of a whole number.
        Mask inside = first_lanes(static_cast<std::size_t>(range.right - x + 1));
        if (!is_inside) {
          inside = inside & (narrow(across[0] + wide(begin[0] + bias[0])) >= Float(0)) &
                   (narrow(across[1] + wide(begin[1] + bias[1])) >= Float(0)) & (narrow(across[2] + wide(begin[2] + bias[2])) >= Float(0));
        }
        if (any_of(inside)) {
          const Float key = (key0 + slope1 * e1) + slope2 * e2;
          has_won |= merge(c, inside, key, farthest, here, record);
        }
        for (std::size_t i = 0; i < 3; ++i) {
          begin[i] -= dy[i] * static_cast<double>(static_cast<int>(kLanes) * kSubpixelUnits);
        }
      }
      for (std::size_t i = 0; i < 3; ++i) {
        row[i] += dx[i] * kSubpixelUnits;
      }
    }
  }
  return has_won;
}

/// Turns a triangle round so that its area is positive; false where it has none.
inline bool orient(Record& t, bool is_mirrored) {
  const std::int64_t area2 = edge_function(t.x[0], t.y[0], t.x[1], t.y[1], t.x[2], t.y[2]);
  t.flags = (area2 < 0) == is_mirrored ? Record::kBack : 0U;
  if (area2 < 0) {
    const auto swap = [](auto& corners) {
      const auto first = corners[1];
      corners[1] = corners[2];
      corners[2] = first;
    };
    swap(t.x);
    swap(t.y);
    swap(t.key);
    t.flags |= Record::kSwapped;
  }
  t.inverse_area = 1.0F / static_cast<float>(area2 < 0 ? -area2 : area2);
  return area2 != 0;
}

/// The next record to be filled in; it is kept by counting it.
HWY_INLINE Record& next_record(TileScratch& s) {
  if (HWY_UNLIKELY(s.record_count == s.records.size())) {
    s.grow_records();
  }
  return s.records[s.record_count];
}

/// The cluster's vertices on the image (reference/triangle.cpp: project()).
inline HWY_NOINLINE void project_vertices(const Frame& frame, TileScratch& s, const Instance& instance, const Cluster& cluster) {
  const View& view = frame.scene->view;
  const Clusters& clusters = instance.drawable->clusters;
  const std::uint32_t* vertices = clusters.vertices.data() + cluster.first_vertex;
  const std::vector<Vec3f>& positions = instance.mesh->positions;
  const bool is_packed = !clusters.positions[0].empty();
  const float* xs = is_packed ? clusters.positions[0].data() + cluster.first_vertex : nullptr;
  const float* ys = is_packed ? clusters.positions[1].data() + cluster.first_vertex : nullptr;
  const float* zs = is_packed ? clusters.positions[2].data() + cluster.first_vertex : nullptr;
  const bool is_perspective = view.projection == Projection::perspective;
  const Float depth_range(view.depth_far - view.depth_near);
  for (std::size_t i = 0; i < cluster.vertices; i += kLanes) {
    const Vec3<Float> p =
        instance.image_from_object(is_packed ? Vec3<Float>{load(xs + i), load(ys + i), load(zs + i)} : gather(positions, vertices + i));
    const Float inverse = Float(1) / p.z;
    const Float scale = is_perspective ? inverse : Float(1);
    const auto snap = [](Float pixels) { return truncate(floor_of(pixels * Float(kSubpixelUnits) + Float(0.5F))); };
    store_quads(snap(p.x * scale + Float(view.center_x)), snap(p.y * scale + Float(view.center_y)),
                bits_of(is_perspective ? inverse : (Float(view.depth_far) - p.z) / depth_range), Int(0), &s.vertices[i].x);
  }
}

/// kLanes triangles of a cluster, corner by corner, as they came out of setup.
struct TriangleLanes {
  alignas(64) std::array<std::array<std::int32_t, kLanes>, 3> x, y, local;
  alignas(64) std::array<std::array<float, kLanes>, 3> key;
  alignas(64) std::array<float, kLanes> inverse_area;
  alignas(64) std::array<std::int32_t, kLanes> left, top, right, bottom, flags;
};

/// One corner of kLanes triangles.
struct Corners {
  Int x, y;
  Float key;
};

/// Where kLanes triangles come from.
struct TriangleSource {
  const Instance& instance;
  const Cluster& cluster;
  std::size_t first;  // of the lanes, within the cluster

  [[nodiscard]] std::uint32_t in_mesh(std::size_t lane) const {
    return instance.drawable->clusters.triangle_at(cluster.first_triangle + first + lane);
  }
};

/// The geometry of one of the lanes, as the next record.
template <bool kHasId>
HWY_INLINE Record& begin_record(TileScratch& s, const TriangleLanes& lanes, const TriangleSource& source, std::size_t i) {
  Record& t = next_record(s);
  for (std::size_t k = 0; k < 3; ++k) {
    t.x[k] = lanes.x[k][i];
    t.y[k] = lanes.y[k][i];
    t.key[k] = lanes.key[k][i];
  }
  t.inverse_area = lanes.inverse_area[i];
  t.flags = static_cast<std::uint32_t>(lanes.flags[i]);
  if constexpr (kHasId) {
    t.id = source.instance.first_triangle + source.in_mesh(i);
  }
  return t;
}

/// What shading asks for beside it.
HWY_INLINE void complete_record(Record& t, const TriangleLanes& lanes, const TriangleSource& source, std::size_t i) {
  const std::uint32_t* vertices = source.instance.drawable->clusters.vertices.data() + source.cluster.first_vertex;
  for (std::size_t k = 0; k < 3; ++k) {
    t.vertex[k] = vertices[lanes.local[k][i]];
  }
  t.material = source.instance.material_of(t.id - source.instance.first_triangle);
}

/// The same for a record that is kept.
HWY_INLINE void keep_record(TileScratch& s, Record& t, const TriangleLanes& lanes, const TriangleSource& source, std::size_t i) {
  complete_record(t, lanes, source, i);
  ++s.record_count;
}

/// Whether a material asks for other treatment than that of all triangles alike.
HWY_INLINE bool is_mixed(const Instance& instance) {
  return instance.alpha_modes != bit_of(AlphaMode::opaque) || instance.has_mixed_culling;
}

/// Those of kLanes triangles that are drawn now: their material has the alpha mode at hand, and, where materials differ in that, it does not
/// leave out the side that is seen. Which side that is, is known of the small ones.
inline HWY_NOINLINE Mask chosen_by_material(const Canvas& c, const TriangleSource& source, Mask stays, Mask is_small, Mask is_back) {
  alignas(64) std::array<std::int32_t, kLanes> chosen{};
  const std::uint32_t small = mask_bits(is_small);
  const std::uint32_t back = mask_bits(is_back);
  for (std::uint32_t left = mask_bits(stays); left != 0; left &= left - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(left));
    const ShadingMaterial& material = c.frame.scene->materials[source.instance.material_of(source.in_mesh(i))];
    const bool is_left_out = (small >> i & 1U) != 0 && material.cull == ((back >> i & 1U) != 0 ? Culling::back : Culling::front);
    chosen[i] = material.opacity.mode == c.mode && !is_left_out ? 1 : 0;
  }
  return load(chosen.data()) > Int(0);
}

/// What of a triangle is left out.
HWY_INLINE Culling culling_of(const Canvas& c, const TriangleSource& source, std::size_t i) {
  const Instance& instance = source.instance;
  return HWY_UNLIKELY(instance.has_mixed_culling) ? c.frame.scene->materials[instance.material_of(source.in_mesh(i))].cull : instance.cull;
}

/// Below this extent triangles are filled many at a time: together they cost less than each in vectors that it fills in part.
inline constexpr std::int32_t kTinyExtent = 6 * kSubpixelUnits;

/// Triangles below kTinyExtent, one a lane: every lane looks at the pixels of its own box. What it finds is merged lane by lane.
struct TinyTriangles {
  Int x0, y0, x1, y1, x2, y2;  // after the swap
  Float key0, key1, key2, inverse_area;
  Int lowest_x, lowest_y, highest_x, highest_y;
};
template <class AnyCanvas>
inline HWY_NOINLINE void fill_tiny(const AnyCanvas& c, const TinyTriangles& t, Mask chosen, const TriangleLanes& lanes,
                                   const TriangleSource& source) {
  TileScratch& s = c.scratch;
  const Float slope1 = (t.key1 - t.key0) * t.inverse_area;
  const Float slope2 = (t.key2 - t.key0) * t.inverse_area;
  const Int dx0 = t.x2 - t.x1, dy0 = t.y2 - t.y1;
  const Int dx1 = t.x0 - t.x2, dy1 = t.y0 - t.y2;
  const Int dx2 = t.x1 - t.x0, dy2 = t.y1 - t.y0;
  const auto bias_of = [](Int dx, Int dy) {  // edge_bias()
    return select((dy < Int(0)) | ((dy == Int(0)) & (dx > Int(0))), Int(0), Int(-1));
  };
  const Int bias0 = bias_of(dx0, dy0), bias1 = bias_of(dx1, dy1), bias2 = bias_of(dx2, dy2);
  const Int right0 = dy0 << 8, right1 = dy1 << 8, right2 = dy2 << 8;  // a pixel to the right
  const Int down0 = dx0 << 8, down1 = dx1 << 8, down2 = dx2 << 8;
  const Float farthest(c.frame.farthest);
  std::array<std::uint32_t, kLanes> records;
  std::uint32_t has_record = 0;
  for (std::size_t sample = 0; sample < c.frame.pattern.size(); ++sample) {
    // Pixels whose sample lies in the box.
    const std::int32_t sample_x = kSubpixelUnits / 2 + c.frame.pattern[sample].x;
    const std::int32_t sample_y = kSubpixelUnits / 2 + c.frame.pattern[sample].y;
    const Int left_pixel = lane_max((t.lowest_x + Int(kSubpixelUnits - 1 - sample_x)) >> 8, Int(c.area.left));
    const Int top_pixel = lane_max((t.lowest_y + Int(kSubpixelUnits - 1 - sample_y)) >> 8, Int(c.area.top));
    const Int right_pixel = lane_min((t.highest_x - Int(sample_x)) >> 8, Int(c.area.right - 1));
    const Int bottom_pixel = lane_min((t.highest_y - Int(sample_y)) >> 8, Int(c.area.bottom - 1));
    const Mask holds = chosen & !(left_pixel > right_pixel) & !(top_pixel > bottom_pixel);
    if (!any_of(holds)) {
      continue;
    }
    const Int columns = right_pixel - left_pixel;
    const Int rows = bottom_pixel - top_pixel;
    const Int at = (top_pixel - Int(c.area.top)) * Int(static_cast<std::int32_t>(s.stride)) + (left_pixel - Int(c.area.left));
    const Int px = (left_pixel << 8) + Int(sample_x);
    const Int py = (top_pixel << 8) + Int(sample_y);
    Int row0 = dx0 * (py - t.y1) - dy0 * (px - t.x1);
    Int row1 = dx1 * (py - t.y2) - dy1 * (px - t.x2);
    Int row2 = dx2 * (py - t.y0) - dy2 * (px - t.x0);
    Mask in_row = holds;
    for (std::int32_t row = 0; any_of(in_row); in_row = in_row & (rows > Int(row)), ++row) {
      Int e0 = row0, e1 = row1, e2 = row2;
      Mask in_box = in_row;
      for (std::int32_t column = 0; any_of(in_box); in_box = in_box & (columns > Int(column)), ++column) {
        const Float key = (t.key0 + slope1 * to_float(e1)) + slope2 * to_float(e2);
        const Mask here = in_box & !(((e0 + bias0) | (e1 + bias1) | (e2 + bias2)) < Int(0)) & (key >= farthest);
        e0 = e0 - right0;
        e1 = e1 - right1;
        e2 = e2 - right2;
        std::uint32_t left = mask_bits(here);
        if (left == 0) {
          continue;
        }
        alignas(64) std::array<float, kLanes> keys;
        alignas(64) std::array<std::int32_t, kLanes> places;
        store(keys.data(), key);
        store(places.data(), at + Int(static_cast<std::int32_t>(sample * s.plane + static_cast<std::size_t>(row) * s.stride) + column));
        for (; left != 0; left &= left - 1) {
          const auto i = static_cast<std::size_t>(__builtin_ctz(left));
          const auto place = static_cast<std::size_t>(places[i]);
          const float old = s.depth_key[place];
          if constexpr (!AnyCanvas::kKeepsWinners) {
            s.depth_key[place] = keys[i] > old ? keys[i] : old;
            continue;
          }
          if (keys[i] < old) {
            continue;
          }
          if (keys[i] == old && s.records[s.winner[place]].id < source.instance.first_triangle + source.in_mesh(i)) {
            continue;
          }
          if ((has_record >> i & 1) == 0) {
            has_record |= 1U << i;
            records[i] = static_cast<std::uint32_t>(s.record_count);
            keep_record(s, begin_record<true>(s, lanes, source, i), lanes, source, i);
          }
          s.depth_key[place] = keys[i];
          s.winner[place] = records[i];
        }
      }
      row0 = row0 + down0;
      row1 = row1 + down1;
      row2 = row2 + down2;
    }
  }
}

/// One of the lanes on its own.
template <class AnyCanvas>
inline HWY_NOINLINE void fill_one(const AnyCanvas& c, const TriangleLanes& lanes, const TriangleSource& source, std::size_t i) {
  TileScratch& s = c.scratch;
  Record& t = begin_record<AnyCanvas::kKeepsWinners>(s, lanes, source, i);
  const bool is_small = (t.flags & Record::kSmall) != 0;
  if (!is_small) {  // its area does not fit 32 bits: once more, from the vertices
    for (std::size_t k = 1; k < 3; ++k) {
      const auto vertex = static_cast<std::size_t>(lanes.local[k][i]);
      t.x[k] = s.vertices[vertex].x;
      t.y[k] = s.vertices[vertex].y;
      t.key[k] = s.vertices[vertex].key;
    }
    if (!orient(t, source.instance.is_mirrored) ||
        culling_of(c, source, i) == ((t.flags & Record::kBack) != 0 ? Culling::back : Culling::front)) {
      return;
    }
  }
  const auto record = static_cast<std::uint32_t>(s.record_count);
  const PixelRange range{lanes.left[i], lanes.top[i], lanes.right[i], lanes.bottom[i]};
  if (AnyCanvas::kKeepsWinners && HWY_UNLIKELY(c.mode != AlphaMode::opaque)) {
    complete_record(t, lanes, source, i);
    s.record_count += fill_seen_through(c, t, record, range) ? 1U : 0U;
  } else if ((is_small ? fill_small(c, t, record, range) : fill_large(c, t, record, range)) && AnyCanvas::kKeepsWinners) {
    keep_record(s, t, lanes, source, i);
  }
}

/// The cluster's triangles, kLanes at a time: those that cannot hold a sample are dropped, the others are filled.
template <class AnyCanvas>
inline HWY_NOINLINE void fill_triangles(const AnyCanvas& c, const Instance& instance, const Cluster& cluster) {
  TileScratch& s = c.scratch;
  const Frame& frame = c.frame;
  const std::uint32_t* corners = instance.drawable->clusters.corners.data() + cluster.first_triangle;
  constexpr std::int32_t kCenter = kSubpixelUnits / 2;
  const Int to_first_x(kSubpixelUnits - 1 - kCenter - frame.highest.x), to_first_y(kSubpixelUnits - 1 - kCenter - frame.highest.y);
  const Int to_last_x(kCenter + frame.lowest.x), to_last_y(kCenter + frame.lowest.y);
  const Culling culling = instance.cull;
  TriangleLanes lanes;

  for (std::size_t begin = 0; begin < cluster.triangles; begin += kLanes) {
    const auto corner = [&](int k) {
      const std::uint32_t* packed = corners + begin;
      hn::Vec<IntTag> words[4];
      load_quads([&](std::size_t i) { return &s.vertices[(packed[i] >> (8 * k)) & 0xFF].x; }, words);
      return Corners{words[0], words[1], from_bits(words[2])};
    };
    const auto [x0, y0, key0] = corner(0);
    const auto [x1, y1, stated_key1] = corner(1);
    const auto [x2, y2, stated_key2] = corner(2);
    const Int lowest_x = lane_min(lane_min(x0, x1), x2), highest_x = lane_max(lane_max(x0, x1), x2);
    const Int lowest_y = lane_min(lane_min(y0, y1), y2), highest_y = lane_max(lane_max(y0, y1), y2);
    const Int left = lane_max((lowest_x + to_first_x) >> 8, Int(c.area.left));
    const Int top = lane_max((lowest_y + to_first_y) >> 8, Int(c.area.top));
    const Int right = lane_min((highest_x - to_last_x) >> 8, Int(c.area.right - 1));
    const Int bottom = lane_min((highest_y - to_last_y) >> 8, Int(c.area.bottom - 1));
    Mask stays = first_lanes(cluster.triangles - begin) & !(left > right) & !(top > bottom);
    if (!any_of(stays)) {
      continue;
    }
    const Mask is_small = lane_max(highest_x - lowest_x, highest_y - lowest_y) < Int(kSmallExtent);
    const Int area2 = (x1 - x0) * (y2 - y0) - (y1 - y0) * (x2 - x0);  // of the small ones
    stays = stays & !(is_small & (area2 == Int(0)));
    const TriangleSource source{instance, cluster, begin};
    const Mask is_swapped = area2 < Int(0);
    if (HWY_UNLIKELY(is_mixed(instance))) {
      // Counter-clockwise with y up is a negative area with y down.
      stays = chosen_by_material(c, source, stays, is_small, instance.is_mirrored ? is_swapped : !is_swapped);
      if (!any_of(stays)) {
        continue;
      }
    }
    if (culling != Culling::none) {
      // Counter-clockwise with y up is a negative area with y down.
      const bool keeps_swapped = (culling == Culling::back) != instance.is_mirrored;
      stays = stays & !(is_small & (keeps_swapped ? !is_swapped : is_swapped));
      if (!any_of(stays)) {
        continue;
      }
    }
    const TinyTriangles tiny{x0,
                             y0,
                             select(is_swapped, x2, x1),
                             select(is_swapped, y2, y1),
                             select(is_swapped, x1, x2),
                             select(is_swapped, y1, y2),
                             key0,
                             select(is_swapped, stated_key2, stated_key1),
                             select(is_swapped, stated_key1, stated_key2),
                             Float(1) / to_float(select(is_swapped, Int(0) - area2, area2)),
                             lowest_x,
                             lowest_y,
                             highest_x,
                             highest_y};
    store(lanes.x[0].data(), tiny.x0);
    store(lanes.x[1].data(), tiny.x1);
    store(lanes.x[2].data(), tiny.x2);
    store(lanes.y[0].data(), tiny.y0);
    store(lanes.y[1].data(), tiny.y1);
    store(lanes.y[2].data(), tiny.y2);
    store(lanes.key[0].data(), tiny.key0);
    store(lanes.key[1].data(), tiny.key1);
    store(lanes.key[2].data(), tiny.key2);
    store(lanes.inverse_area.data(), tiny.inverse_area);
    const Int packed = load(corners + begin);
    store(lanes.local[0].data(), packed & Int(0xFF));
    store(lanes.local[1].data(), (packed >> 8) & Int(0xFF));
    store(lanes.local[2].data(), (packed >> 16) & Int(0xFF));
    const Int swapped_flag = select(is_swapped, Int(Record::kSwapped), Int(0));
    // Counter-clockwise with y up is a negative area with y down.
    const Int back_flag = select(is_swapped, Int(instance.is_mirrored ? Record::kBack : 0), Int(instance.is_mirrored ? 0 : Record::kBack));
    store(lanes.flags.data(), (swapped_flag | back_flag) | select(is_small, Int(Record::kSmall), Int(0)));

    Mask is_tiny = stays & (lane_max(highest_x - lowest_x, highest_y - lowest_y) < Int(kTinyExtent));
    if (HWY_UNLIKELY(c.mode != AlphaMode::opaque)) {
      is_tiny = first_lanes(0);
    }
    if (any_of(is_tiny)) {
      fill_tiny(c, tiny, is_tiny, lanes, source);
    }
    std::uint32_t rest = mask_bits(stays & !is_tiny);
    if (rest != 0) {
      store(lanes.left.data(), left);
      store(lanes.top.data(), top);
      store(lanes.right.data(), right);
      store(lanes.bottom.data(), bottom);
      for (; rest != 0; rest &= rest - 1) {
        fill_one(c, lanes, source, static_cast<std::size_t>(__builtin_ctz(rest)));
      }
    }
  }
}

/// A triangle that was clipped or lies near what clips.
template <class AnyCanvas>
inline void fill_loose(const AnyCanvas& c, std::uint32_t index) {
  const ScreenTriangle& t = c.frame.loose[index];
  const Instance& instance = c.frame.scene->instances[t.instance];
  Record& r = next_record(c.scratch);
  const auto lowest = [](const std::array<std::int32_t, 3>& v) {
    return v[0] < v[1] ? (v[0] < v[2] ? v[0] : v[2]) : (v[1] < v[2] ? v[1] : v[2]);
  };
  const auto highest = [](const std::array<std::int32_t, 3>& v) {
    return v[0] > v[1] ? (v[0] > v[2] ? v[0] : v[2]) : (v[1] > v[2] ? v[1] : v[2]);
  };
  const auto limit = [](int value, int low, int high) { return value < low ? low : (value > high ? high : value); };
  constexpr std::int32_t kCenter = kSubpixelUnits / 2;
  const PixelRange range{limit((lowest(t.x) + (kSubpixelUnits - 1 - kCenter - c.frame.highest.x)) >> 8, c.area.left, c.area.right),
                         limit((lowest(t.y) + (kSubpixelUnits - 1 - kCenter - c.frame.highest.y)) >> 8, c.area.top, c.area.bottom),
                         limit((highest(t.x) - (kCenter + c.frame.lowest.x)) >> 8, c.area.left - 1, c.area.right - 1),
                         limit((highest(t.y) - (kCenter + c.frame.lowest.y)) >> 8, c.area.top - 1, c.area.bottom - 1)};
  if (range.left > range.right || range.top > range.bottom) {
    return;
  }
  const std::uint32_t in_mesh = t.id - instance.first_triangle;
  r.material = instance.material_of(in_mesh);
  if (c.frame.scene->materials[r.material].opacity.mode != c.mode) {
    return;
  }
  r.x = t.x;
  r.y = t.y;
  r.key = t.depth_key;
  r.inverse_area = 1.0F / static_cast<float>(t.area2);
  r.id = t.id;
  r.vertex = instance.mesh->triangles[in_mesh];
  r.flags = (t.is_swapped ? Record::kSwapped : 0U) | (t.is_front ? 0U : Record::kBack) |
            (t.is_clipped ? Record::kClipped | index << Record::kLooseShift : 0U);
  const auto record = static_cast<std::uint32_t>(c.scratch.record_count);
  const bool is_kept = c.mode == AlphaMode::opaque ? fill_large(c, r, record, range) : fill_seen_through(c, r, record, range);
  c.scratch.record_count += is_kept && AnyCanvas::kKeepsWinners ? 1U : 0U;
}

/// The smallest depth key in a block of the tile, over all samples: what lies wholly behind it is not seen.
inline HWY_NOINLINE float find_farthest(const Canvas& c, std::size_t block_x, std::size_t block_y) {
  const TileScratch& s = c.scratch;
  constexpr auto kWidth = static_cast<std::size_t>(TileScratch::kBlockWidth);
  constexpr auto kHeight = static_cast<std::size_t>(TileScratch::kBlockHeight);
  const auto rows = static_cast<std::size_t>(c.area.bottom - c.area.top);
  const std::size_t end_y = (block_y + 1) * kHeight < rows ? (block_y + 1) * kHeight : rows;
  Float lowest(3e38F);
  for (std::size_t sample = 0; sample < c.frame.pattern.size(); ++sample) {
    for (std::size_t y = block_y * kHeight; y < end_y; ++y) {
      const float* row = &s.depth_key[sample * s.plane + y * s.stride + block_x * kWidth];
      for (std::size_t x = 0; x < kWidth; x += kLanes) {  // beyond the tile's right edge nothing is drawn, so nothing is hidden
        lowest = lane_min(load(row + x), lowest);
      }
    }
  }
  alignas(64) std::array<float, kLanes> lanes;
  store(lanes.data(), lowest);
  float farthest = lanes[0];
  for (std::size_t i = 1; i < kLanes; ++i) {
    farthest = lanes[i] < farthest ? lanes[i] : farthest;
  }
  return farthest;
}

/// The blocks that a cluster may touch.
struct BlockRange {
  std::size_t left, top, right, bottom;  // bounds included
};
HWY_INLINE BlockRange blocks_of(const Canvas& c, const VisibleCluster& cluster) {
  const auto block = [](int pixel, int low, int high, int size) {
    const int inside = pixel < low ? low : (pixel >= high ? high - 1 : pixel);
    return static_cast<std::size_t>((inside - low) / size);
  };
  constexpr int kWidth = TileScratch::kBlockWidth;
  constexpr int kHeight = TileScratch::kBlockHeight;
  return {block(cluster.left, c.area.left, c.area.right, kWidth), block(cluster.top, c.area.top, c.area.bottom, kHeight),
          block(cluster.right, c.area.left, c.area.right, kWidth), block(cluster.bottom, c.area.top, c.area.bottom, kHeight)};
}

/// Whether everything in the cluster's blocks is nearer than the cluster can be. An equally near triangle may win by its number.
HWY_INLINE bool is_hidden(const Canvas& c, const VisibleCluster& cluster, const BlockRange& range) {
  TileScratch& s = c.scratch;
  for (std::size_t y = range.top; y <= range.bottom; ++y) {
    for (std::size_t x = range.left; x <= range.right; ++x) {
      float& farthest = s.block_farthest[y * s.blocks_x + x];
      if (farthest < -1) {
        farthest = find_farthest(c, x, y);
      }
      if (!(farthest > cluster.nearest)) {
        return false;
      }
    }
  }
  return true;
}

/// The tile's clusters, roughly the nearest first, so that they hide the others: sorted into buckets by depth key.
inline HWY_NOINLINE std::span<const std::uint32_t> sort_clusters(const Frame& frame, std::span<const std::uint32_t> list, TileScratch& s) {
  constexpr std::size_t kBuckets = 64;
  float low = 3e38F;
  float high = 0;
  for (const std::uint32_t entry : list) {
    const float nearest = frame.clusters[entry].nearest;
    low = nearest < low ? nearest : low;
    high = nearest > high ? nearest : high;
  }
  const float scale = high > low ? static_cast<float>(kBuckets - 1) / (high - low) : 0;
  const auto bucket_of = [&](std::uint32_t entry) {
    const float place = (high - frame.clusters[entry].nearest) * scale;
    return place > 0 && place < static_cast<float>(kBuckets) ? static_cast<std::size_t>(place) : 0;
  };
  std::array<std::uint32_t, kBuckets + 1> begin{};
  for (const std::uint32_t entry : list) {
    ++begin[bucket_of(entry) + 1];
  }
  for (std::size_t i = 0; i < kBuckets; ++i) {
    begin[i + 1] += begin[i];
  }
  if (s.sorted_clusters.size() < list.size()) {
    s.grow_sorted(list.size());
  }
  for (const std::uint32_t entry : list) {
    s.sorted_clusters[begin[bucket_of(entry)]++] = entry;
  }
  return std::span<const std::uint32_t>(s.sorted_clusters).first(list.size());
}

/// What filling will read of a cluster, asked for while another is filled.
HWY_INLINE void prefetch_cluster(const Frame& frame, const VisibleCluster& visible) {
  const Clusters& clusters = frame.scene->instances[visible.instance].drawable->clusters;
  const Cluster& cluster = clusters.clusters[visible.cluster];
  constexpr std::size_t kLine = 16;  // words
  for (std::size_t i = 0; i < cluster.triangles; i += kLine) {
    __builtin_prefetch(clusters.corners.data() + cluster.first_triangle + i);
  }
  if (!clusters.positions[0].empty()) {
    for (std::size_t i = 0; i < cluster.vertices; i += kLine) {
      for (const std::vector<float>& axis : clusters.positions) {
        __builtin_prefetch(axis.data() + cluster.first_vertex + i);
      }
    }
  }
}

/// The tile's triangles of the canvas's alpha mode.
template <class AnyCanvas>
inline HWY_NOINLINE void fill_mode(const AnyCanvas& c, std::size_t tile) {
  const Frame& frame = c.frame;
  TileScratch& s = c.scratch;
  const std::span<const std::uint32_t> loose = frame.loose_lists.of(tile);
  for (const std::uint32_t entry : loose) {
    fill_loose(c, entry);
  }
  if (!loose.empty()) {
    for (float& farthest : s.block_farthest) {
      farthest = -2;
    }
  }
  const std::span<const std::uint32_t> sorted = std::span<const std::uint32_t>(s.sorted_clusters).first(s.sorted_count);
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (i + 1 < sorted.size()) {
      prefetch_cluster(frame, frame.clusters[sorted[i + 1]]);
    }
    const VisibleCluster& visible = frame.clusters[sorted[i]];
    const Instance& instance = frame.scene->instances[visible.instance];
    if (HWY_UNLIKELY((instance.alpha_modes & bit_of(c.mode)) == 0)) {
      continue;
    }
    const BlockRange blocks = blocks_of(c, visible);
    if (is_hidden(c, visible, blocks)) {
      continue;
    }
    const Cluster& cluster = instance.drawable->clusters.clusters[visible.cluster];
    project_vertices(frame, s, instance, cluster);
    fill_triangles(c, instance, cluster);
    for (std::size_t y = blocks.top; y <= blocks.bottom; ++y) {
      for (std::size_t x = blocks.left; x <= blocks.right; ++x) {
        s.block_farthest[y * s.blocks_x + x] = -2;
      }
    }
  }
}

/// An empty tile, and the order of its clusters.
template <bool kKeepsWinners>
HWY_INLINE void begin_tile(const Frame& frame, std::size_t tile, const TileArea& area, TileScratch& s) {
  const std::size_t rows = static_cast<std::size_t>(area.bottom - area.top) * s.stride;
  for (std::size_t sample = 0; sample < frame.pattern.size(); ++sample) {
    for (std::size_t i = 0; i < rows; i += kLanes) {  // a key is never below 0
      store(&s.depth_key[sample * s.plane + i], Float(-1));
      if constexpr (kKeepsWinners) {
        store(&s.winner[sample * s.plane + i], Int(-1));
      }
    }
  }
  for (float& farthest : s.block_farthest) {
    farthest = -1;
  }
  s.sorted_count = sort_clusters(frame, frame.cluster_lists.of(tile), s).size();
}

inline void fill_tile(const Frame& frame, std::size_t tile, TileScratch& s) {
  const TileArea area = frame.area(tile);
  s.record_count = 0;
  s.sorted_count = 0;
  if (frame.cluster_lists.of(tile).empty() && frame.loose_lists.of(tile).empty() && !frame.wants_all) {
    return;  // shade_tile() does not look at it
  }
  begin_tile<true>(frame, tile, area, s);
  fill_mode(Canvas{frame, s, area, AlphaMode::opaque, area.top, area.bottom}, tile);
  if (HWY_UNLIKELY((frame.alpha_modes & bit_of(AlphaMode::mask)) != 0)) {
    fill_mode(Canvas{frame, s, area, AlphaMode::mask, area.top, area.bottom}, tile);
  }
}

inline void fill_keys(const Frame& frame, std::size_t tile, TileScratch& s) {
  if (HWY_UNLIKELY(frame.alpha_modes != bit_of(AlphaMode::opaque))) {  // a mask's opacity is found by its record
    fill_tile(frame, tile, s);
    return;
  }
  const TileArea area = frame.area(tile);
  s.record_count = 0;
  begin_tile<false>(frame, tile, area, s);
  fill_mode(KeyCanvas{{frame, s, area, AlphaMode::opaque, area.top, area.bottom}}, tile);
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
