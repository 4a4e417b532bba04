// From the general form to the plain one and back.
#include "mesh/plain_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <utility>

#include "mesh/first_use.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

bool all_equal_corners(const std::vector<std::uint32_t>& corners, const std::vector<std::uint32_t>& positions, int threads) {
  std::atomic<bool> is_equal = corners.size() == positions.size();
  parallel_slices(is_equal ? corners.size() : 0, threads, [&](std::size_t begin, std::size_t end) {
    if (std::memcmp(corners.data() + begin, positions.data() + begin, (end - begin) * sizeof(std::uint32_t)) != 0) {
      is_equal = false;
    }
  });
  return is_equal;
}

bool all_triangles(const std::vector<std::uint32_t>& face_begin, int threads) {
  std::atomic<bool> is_good = true;
  parallel_slices(face_begin.size(), threads, [&](std::size_t begin, std::size_t end) {
    bool good = true;
    for (std::size_t f = begin; f < end; ++f) {
      good &= face_begin[f] == 3 * f;
    }
    if (!good) {
      is_good = false;
    }
  });
  return is_good;
}

template <class T>
void reorder(std::vector<T>& list, const FirstUse& numbers, int threads) {
  if (list.empty()) {
    return;
  }
  std::vector<T> sorted;
  resize_big(sorted, list.size());
  parallel_slices(list.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      sorted[numbers.new_of_old[v]] = list[v];
    }
  });
  list = std::move(sorted);
}

/// Streams that the general and the plain form call alike.
template <class From, class To>
void move_what_both_have(From& from, To& to) {
  to.positions = std::move(from.positions);
  to.normals = std::move(from.normals);
  to.uvs = std::move(from.uvs);
  to.colors = std::move(from.colors);
  to.materials = std::move(from.materials);
  to.format = std::move(from.format);
  to.notes = std::move(from.notes);
}

/// All faces are in one smoothing group, or there are none.
bool is_all_smooth(const std::vector<std::uint32_t>& smoothing) {
  return smoothing.empty() ||
         (smoothing.front() != 0 && std::all_of(smoothing.begin(), smoothing.end(), [&](std::uint32_t s) { return s == smoothing.front(); }));
}

}  // namespace

void sort_by_first_use(PlainMesh& plain, int threads) {
  const FirstUse numbers = number_by_first_use(plain.triangles, plain.positions.size(), threads);
  plain.used = numbers.used;
  if (numbers.is_sorted) {
    return;
  }
  renumber(plain.triangles, numbers, threads);
  reorder(plain.positions, numbers, threads);
  reorder(plain.normals, numbers, threads);
  reorder(plain.uvs, numbers, threads);
  reorder(plain.colors, numbers, threads);
}

SourceMesh to_source(PlainMesh plain) {
  SourceMesh source;
  const std::size_t corners = 3 * plain.triangles.size();
  resize_big(source.corner_position, corners);
  if (corners != 0) {
    std::memcpy(source.corner_position.data(), plain.triangles.data(), corners * sizeof(std::uint32_t));
  }
  plain.triangles = {};
  resize_big(source.face_begin, corners / 3 + 1);
  for (std::size_t f = 0; f < source.face_begin.size(); ++f) {
    source.face_begin[f] = static_cast<std::uint32_t>(3 * f);
  }
  if (!plain.normals.empty()) {
    source.corner_normal = source.corner_position;
  }
  if (!plain.uvs.empty()) {
    source.corner_uv = source.corner_position;
  }
  source.face_material = std::move(plain.materials_of);
  move_what_both_have(plain, source);
  return source;
}

std::optional<PlainMesh> to_plain(SourceMesh& source, const NormalOptions& options, int threads) {
  const std::size_t vertices = source.positions.size();
  const bool has_normals = !source.corner_normal.empty();
  const bool has_uvs = !source.corner_uv.empty();
  const bool is_plain =
      makes_plain_normals(options) && !source.weld_first && source.face_colors.empty() && source.uvs1.empty() && source.tangents.empty() &&
      source.alphas.empty() && (source.normals.empty() || (has_normals && source.normals.size() == vertices)) &&
      (source.uvs.empty() || (has_uvs && source.uvs.size() == vertices)) && is_all_smooth(source.face_smoothing) &&
      all_triangles(source.face_begin, threads) && (!has_normals || all_equal_corners(source.corner_normal, source.corner_position, threads)) &&
      (!has_uvs || all_equal_corners(source.corner_uv, source.corner_position, threads));
  if (!is_plain) {
    return std::nullopt;
  }
  PlainMesh plain;
  source.corner_normal = {};
  source.corner_uv = {};
  resize_big(plain.triangles, source.corner_position.size() / 3);
  parallel_slices(plain.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::memcpy(plain.triangles.data() + begin, source.corner_position.data() + 3 * begin, 12 * (end - begin));
  });
  source.corner_position = {};
  plain.materials_of = std::move(source.face_material);
  move_what_both_have(source, plain);
  return plain;
}

}  // namespace lustro
