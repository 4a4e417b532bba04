// The triangles that a strip of fragments shows, and what the mesh says of their vertices. Part of a row (row.cpp).
//
// Fragments beside each other mostly show the same triangle, and its numbers lie far apart: they are fetched, and what follows from the triangle
// alone is worked out, once for a row of such fragments. Each lane then chooses its own by one shuffle of what lies side by side.
#pragma once

#include "raster/frame.hpp"
#include "scene/mapped_surface.hpp"
#include "shade/interpolation.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

inline constexpr std::size_t kStrip = TileScratch::kStrip;

/// One of something for each vertex.
template <class T>
using Three = std::array<T, 3>;

/// What of its triangles a stage asks for.
struct FaceWants {
  bool slopes = false;     ///< of the weights on the image
  bool positions = false;  ///< of the vertices, object space; and the face's normal
  bool normals = false;    ///< of the vertices, as all that follows
  bool tangents = false;
  bool colors = false;
  bool alphas = false;
  std::uint32_t uv_sets = 0;  ///< bit i: set i of the texture coordinates
};

/// Edge function from corner `from` to corner `to`, as a float of the exact whole number: (to_x - from_x, to_y - from_y) is the edge, (x, y) the
/// way from any point on it.
template <bool kSmall>
HWY_INLINE Float edge_along(Int edge_x, Int edge_y, Int x, Int y) {
  if constexpr (kSmall) {
    return to_float(edge_x * y - edge_y * x);
  } else {
    return narrow(widen(edge_x) * widen(y) - widen(edge_y) * widen(x));
  }
}

/// The words of a record by their place.
enum RecordWord : std::size_t { word_x = 0, word_y = 3, word_inverse_area = 6, word_key = 7, word_vertex = 10, word_flags = 15 };

/// The normal of a mesh's triangle, object space, not of length 1.
HWY_INLINE Vec3<Float> object_normal(const Three<Vec3<Float>>& corners) {
  const Vec3<Float> ab = corners[1] - corners[0];
  const Vec3<Float> ac = corners[2] - corners[0];
  Float size = lane_abs(ab.x);
  for (const Float& part : {ab.y, ab.z, ac.x, ac.y, ac.z}) {
    size = lane_max(lane_abs(part), size);
  }
  const Float scale = Float(1) / size;
  return cross(ab * scale, ac * scale);
}

/// The triangles of up to kStrip fragments of one material: first listed, then found, then chosen from.
class FaceTable {
 public:
  static constexpr std::size_t kRoom = kStrip + kLanes;
  using Row = std::array<float, kRoom>;
  using IntRow = std::array<std::int32_t, kRoom>;
  template <std::size_t kCount>
  using Rows = std::array<Row, kCount>;

  const Frame& frame;
  const Instance& instance;
  const ShadingMaterial& material;

  // Of the screen triangle's corners; edge1 goes from corner 2 to corner 0, edge2 from 0 to 1.
  alignas(64) IntRow x, y, edge1_x, edge1_y, edge2_x, edge2_y, flags;
  alignas(64) Row inverse_area, key0, key1, key2, key_slope1, key_slope2;
  alignas(64) Rows<6> slopes;  // CornerSlopes
  // Of the mesh's triangle: a row a component, vertex by vertex.
  alignas(64) std::array<std::array<std::uint32_t, kRoom>, 3> vertex;
  alignas(64) Rows<9> positions, normals, colors;
  alignas(64) Rows<3> face_normal;  // world, unit, of the front
  alignas(64) Rows<3> alphas;
  alignas(64) std::array<Rows<6>, 2> uvs;
  alignas(64) Rows<12> tangents;
  bool is_small = true;      // all of them: Record::kSmall
  bool has_clipped = false;  // any of them: Record::kClipped
  bool has_slopes = false;

  HWY_INLINE FaceTable(const Frame& frame_, const Record* records, const Instance& instance_, const ShadingMaterial& material_)
      : frame(frame_), instance(instance_), material(material_), records_(records) {}

  /// Lists the triangles of 1 .. kStrip fragments. A vector of records more is read.
  HWY_INLINE void list(const std::uint32_t* record, std::size_t fragments) {
    std::size_t count = 0;
    std::uint32_t last = Record::kNone;
    for (std::size_t i = 0; i < fragments; i += kLanes) {
      const std::size_t rest = (fragments - i < kLanes ? fragments - i : kLanes) - 1;
      const Int shown = load(record + i);
      const Mask changes = first_lanes(rest) & !(shown == load(record + i + 1));  // the last of a row of fragments that show one triangle
      const std::uint32_t bits = mask_bits(changes);
      const std::size_t begin = count - (last == record[i] ? 1 : 0);
      store_chosen(changes, &listed_[begin], shown);
      store(&rank_[i], counts_before(bits));
      begin_[i / kLanes] = begin;
      count = begin + static_cast<std::size_t>(__builtin_popcount(bits));
      last = listed_[count++] = record[i + rest];
    }
    count_ = count;
  }

  /// Works out what is asked for.
  void find(const FaceWants& wants);

  [[nodiscard]] HWY_INLINE std::size_t begin_of(std::size_t batch) const { return begin_[batch]; }
  [[nodiscard]] HWY_INLINE Int rank_of(std::size_t batch) const { return load(&rank_[batch * kLanes]); }

 private:
  const Record* records_;
  std::size_t count_ = 0;
  alignas(64) std::array<std::uint32_t, kRoom> listed_;
  alignas(64) std::array<std::int32_t, kStrip> rank_;  // of a fragment's triangle among its batch's
  std::array<std::size_t, kStrip / kLanes> begin_;     // of a batch's triangles

  template <std::size_t kCount>
  static HWY_INLINE void put(Rows<kCount>& rows, std::size_t first, std::size_t i, const Vec3<Float>& value) {
    store(&rows[first][i], value.x);
    store(&rows[first + 1][i], value.y);
    store(&rows[first + 2][i], value.z);
  }
};

inline HWY_NOINLINE void FaceTable::find(const FaceWants& wants) {
  const PreparedScene& scene = *frame.scene;
  const Mesh& mesh = *instance.mesh;
  const bool is_perspective = scene.view.projection == Projection::perspective;
  has_slopes = wants.slopes;
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    listed_[count_ + lane] = listed_[count_ - 1];
  }
  for (std::size_t i = 0; i < count_; i += kLanes) {
    Words words;
    transpose(reinterpret_cast<const std::uint32_t*>(records_), &listed_[i], words);
    const Three<Int> corner_x{words[word_x], words[word_x + 1], words[word_x + 2]};
    const Three<Int> corner_y{words[word_y], words[word_y + 1], words[word_y + 2]};
    const Float area(from_bits(words[word_inverse_area]));
    const Three<Float> key{from_bits(words[word_key]), from_bits(words[word_key + 1]), from_bits(words[word_key + 2])};
    store(&x[i], corner_x[0]);
    store(&y[i], corner_y[0]);
    store(&edge1_x[i], corner_x[0] - corner_x[2]);
    store(&edge1_y[i], corner_y[0] - corner_y[2]);
    store(&edge2_x[i], corner_x[1] - corner_x[0]);
    store(&edge2_y[i], corner_y[1] - corner_y[0]);
    store(&flags[i], words[word_flags]);
    store(&inverse_area[i], area);
    store(&key0[i], key[0]);
    store(&key1[i], key[1]);
    store(&key2[i], key[2]);
    store(&key_slope1[i], (key[1] - key[0]) * area);
    store(&key_slope2[i], (key[2] - key[0]) * area);
    has_clipped = has_clipped || any_of((words[word_flags] & Int(Record::kClipped)) > Int(0));
    is_small = is_small && all_of((words[word_flags] & Int(Record::kSmall)) > Int(0));
    if (wants.slopes) {
      const CornerSlopes<Float> of = corner_slopes<Float>(is_perspective, corner_x, corner_y, area, key);
      std::size_t row = 0;
      for (const Float& part : {of.w1_dx, of.w2_dx, of.w1_dy, of.w2_dy, of.key_dx, of.key_dy}) {
        store(&slopes[row++][i], part);
      }
    }
    for (std::size_t v = 0; v < 3; ++v) {
      store(&vertex[v][i], words[word_vertex + v]);
    }
  }
  if (wants.positions) {
    for (std::size_t i = 0; i < count_; i += kLanes) {
      Three<Vec3<Float>> corners;
      for (std::size_t v = 0; v < 3; ++v) {
        corners[v] = gather(mesh.positions, &vertex[v][i]);
        put(positions, 3 * v, i, corners[v]);
      }
      put(face_normal, 0, i, normalize(instance.normal_from_object(object_normal(corners))));
    }
  }
  const auto each_vertex = [&](auto&& take) {
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t i = 0; i < count_; i += kLanes) {
        take(v, i, &vertex[v][i]);
      }
    }
  };
  if (wants.normals) {
    each_vertex([&](std::size_t v, std::size_t i, const std::uint32_t* index) { put(normals, 3 * v, i, gather(mesh.normals, index)); });
  }
  if (wants.colors) {
    each_vertex(
        [&](std::size_t v, std::size_t i, const std::uint32_t* index) { put(colors, 3 * v, i, gather(instance.drawable->colors, index)); });
  }
  if (wants.alphas) {
    each_vertex(
        [&](std::size_t v, std::size_t i, const std::uint32_t* index) { store(&alphas[v][i], gather(mesh.alphas.data(), load(index))); });
  }
  for (std::size_t set = 0; set < 2; ++set) {
    if ((wants.uv_sets >> set & 1U) != 0) {
      each_vertex([&](std::size_t v, std::size_t i, const std::uint32_t* index) {
        const Vec2<Float> uv = gather(set == 0 ? mesh.uvs : mesh.uvs1, index);
        store(&uvs[set][2 * v][i], uv.x);
        store(&uvs[set][2 * v + 1][i], uv.y);
      });
    }
  }
  if (wants.tangents) {
    each_vertex([&](std::size_t v, std::size_t i, const std::uint32_t* index) {
      const std::array<Float, 4> tangent = gather(mesh.tangents, index);
      for (std::size_t part = 0; part < 4; ++part) {
        store(&tangents[4 * v + part][i], tangent[part]);
      }
    });
  }
}

/// kLanes triangles of one instance and material: those that a batch of fragments shows.
struct Faces {
  const FaceTable& table;
  const PreparedScene& scene;
  const Instance& instance;
  const ShadingMaterial& material;
  std::size_t begin;  // in the table
  LaneChoice lanes;   // from there on
  Int flags;
  Float side;  // -1 where the back is seen and lit with its normals turned round

  HWY_INLINE Faces(const FaceTable& of, std::size_t batch)
      : table(of),
        scene(*of.frame.scene),
        instance(of.instance),
        material(of.material),
        begin(of.begin_of(batch)),
        lanes(of.rank_of(batch)),
        flags(choose(of.flags)),
        side(scene.shading.two_sided ? select((flags & Int(Record::kBack)) > Int(0), Float(-1), Float(1)) : Float(1)) {}

  [[nodiscard]] HWY_INLINE Float choose(const FaceTable::Row& row) const { return lanes(&row[begin]); }
  [[nodiscard]] HWY_INLINE Int choose(const FaceTable::IntRow& row) const { return lanes(&row[begin]); }
  template <std::size_t kCount>
  [[nodiscard]] HWY_INLINE Vec3<Float> choose(const FaceTable::Rows<kCount>& rows, std::size_t first) const {
    return {choose(rows[first]), choose(rows[first + 1]), choose(rows[first + 2])};
  }

  [[nodiscard]] HWY_INLINE Vec3<Float> stated_position(std::size_t i) const { return choose(table.positions, 3 * i); }
  [[nodiscard]] HWY_INLINE Vec3<Float> stated_normal(std::size_t i) const { return choose(table.normals, 3 * i); }
  [[nodiscard]] HWY_INLINE std::array<Float, 4> stated_tangent(std::size_t i) const {
    return {choose(table.tangents[4 * i]), choose(table.tangents[4 * i + 1]), choose(table.tangents[4 * i + 2]),
            choose(table.tangents[4 * i + 3])};
  }
  [[nodiscard]] HWY_INLINE Vec2<Float> stated_uv(std::size_t set, std::size_t i) const {
    return {choose(table.uvs[set][2 * i]), choose(table.uvs[set][2 * i + 1])};
  }
  [[nodiscard]] HWY_INLINE Float stated_alpha(std::size_t i) const { return choose(table.alphas[i]); }
  [[nodiscard]] Vec3<Float> position(std::size_t i) const { return instance.relative_from_object(stated_position(i)); }
  [[nodiscard]] Vec3<Float> normal(std::size_t i) const {
    const Vec3<Float> n = instance.normal_from_object(stated_normal(i));
    return (instance.is_similarity ? n : normalize(n)) * side;
  }
  [[nodiscard]] Vec3<Float> face_normal() const { return choose(table.face_normal, 0) * side; }

  [[nodiscard]] HWY_INLINE Vec3<Float> normal_at(NormalInterpolation mode, const Weights<Float>& w) const {
    const bool turns_once = instance.is_similarity;
    const Three<Vec3<Float>> n = turns_once ? Three<Vec3<Float>>{stated_normal(0), stated_normal(1), stated_normal(2)}
                                            : Three<Vec3<Float>>{normal(0), normal(1), normal(2)};
    const Vec3<Float> sum = weighted_sum(n, w);
    Vec3<Float> fallback{};
    if (HWY_UNLIKELY(any_of(dot(sum, sum) < Float(1e-12F)))) {  // where normals cancel, and only there, the face's is needed
      fallback = normal_of_face(turns_once);
    }
    const Vec3<Float> interpolated = interpolate_normal(mode, n, w, fallback);
    return turns_once ? instance.normal_from_object(interpolated) * side : interpolated;
  }

  [[nodiscard]] Vec3<Float> tint(const Weights<Float>& w) const {
    if (instance.drawable->colors.empty()) {
      return {Float(1), Float(1), Float(1)};
    }
    return weighted_sum<Float>({choose(table.colors, 0), choose(table.colors, 3), choose(table.colors, 6)}, w);
  }

 private:
  /// For the rare fragment that asks: positions need not be in the table.
  [[nodiscard]] HWY_NOINLINE Vec3<Float> normal_of_face(bool in_object) const {
    Three<Vec3<Float>> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      alignas(64) std::array<std::uint32_t, kLanes> index;
      store(index.data(), lanes(&table.vertex[i][begin]));
      corners[i] = gather(instance.mesh->positions, index.data());
    }
    const Vec3<Float> normal = object_normal(corners);
    return in_object ? normalize(normal) : normalize(instance.normal_from_object(normal)) * side;
  }
};

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
