// Around every position: the corners sorted by the edges they touch, joined in pairs by union and find. Linear in the corners but for the sort
// of each ring; all scratch memory is shared by the positions.
#include "mesh/smoothing.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "math/trig.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

/// Beyond these, rings that no honest mesh has: they cost linear time and may share less.
constexpr std::size_t kMaxFacesCompared = 64;
constexpr std::size_t kMaxBridges = 16;

/// Face corners in the order of their positions; those of one position in ascending order.
struct Rings {
  std::vector<std::uint32_t> begin;   ///< V + 1
  std::vector<std::uint32_t> corner;  ///< C
};

// Each thread looks at all corners and places those of a range of positions.
Rings rings_of(const Faces& faces, int threads) {
  Rings rings;
  const std::size_t positions = faces.positions.size();
  resize_big(rings.begin, positions + 1);
  resize_big(rings.corner, faces.corner_position.size());
  const std::size_t ranges = faces.corner_position.size() < kSmallestSlice ? 1 : thread_count(threads);
  const auto first = [&](std::size_t r) { return static_cast<std::uint32_t>(positions * r / ranges); };
  std::vector<std::uint32_t> sizes(ranges);
  parallel_for(ranges, threads, [&](std::size_t r) {
    const std::uint32_t low = first(r);
    const std::uint32_t width = first(r + 1) - low;
    std::uint32_t size = 0;
    for (const std::uint32_t position : faces.corner_position) {
      if (position - low < width) {
        ++rings.begin[position + 1];
        ++size;
      }
    }
    sizes[r] = size;
  });
  std::exclusive_scan(sizes.begin(), sizes.end(), sizes.begin(), 0U);
  parallel_for(ranges, threads, [&](std::size_t r) {
    const std::uint32_t low = first(r);
    const std::uint32_t width = first(r + 1) - low;
    std::vector<std::uint32_t> end(width);
    std::uint32_t sum = sizes[r];
    for (std::uint32_t i = 0; i < width; ++i) {
      end[i] = sum;
      sum += rings.begin[low + i + 1];
      rings.begin[low + i + 1] = sum;
    }
    for (std::uint32_t c = 0; c < faces.corner_position.size(); ++c) {
      if (faces.corner_position[c] - low < width) {
        rings.corner[end[faces.corner_position[c] - low]++] = c;
      }
    }
  });
  return rings;
}

/// The corners around one position, while they are being joined.
class Ring {
 public:
  Ring(const Faces& faces, const std::vector<std::uint32_t>& corner_face, std::span<const Vec3d> normals,
       std::span<const std::uint8_t> is_sliver, double crease_deg)
      : faces_(faces),
        corner_face_(corner_face),
        normals_(normals),
        is_sliver_(is_sliver),
        is_creased_(crease_deg < 180),
        least_cosine_(cosine_deg(std::min(180.0, crease_deg + kCreaseSlackDeg))) {}

  /// Writes the corners' groups, numbered from `count` on in the order of the corners. Returns the next number.
  std::uint32_t group(std::span<const std::uint32_t> corners, std::uint32_t count, std::vector<std::uint32_t>& of_corner) {
    corners_ = corners;
    parent_.resize(corners.size());
    std::iota(parent_.begin(), parent_.end(), 0U);
    if (is_creased_) {
      join_across_edges();
    } else {
      join_by_smoothing();
    }
    for (std::uint32_t i = 0; i < corners.size(); ++i) {  // a root is the first of its own, so it is numbered before the others ask
      const std::uint32_t root = find(i);
      of_corner[corners[i]] = root == i ? count++ : of_corner[corners[root]];
    }
    return count;
  }

 private:
  /// Corner i of the ring touches the edge to the position `end`.
  struct Touch {
    std::uint32_t end;
    std::uint32_t corner;
    friend bool operator<(const Touch& a, const Touch& b) { return a.end != b.end ? a.end < b.end : a.corner < b.corner; }
  };

  [[nodiscard]] std::uint32_t face_of(std::uint32_t i) const { return corner_face_[corners_[i]]; }

  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }

  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

  [[nodiscard]] bool same_smoothing(std::uint32_t f, std::uint32_t g) const {
    return faces_.smoothing.empty() || (faces_.smoothing[f] == faces_.smoothing[g] && (faces_.smoothing[f] != 0 || f == g));
  }

  void join_by_smoothing() {
    touches_.clear();
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      touches_.push_back({faces_.smoothing[face_of(i)], i});
    }
    std::sort(touches_.begin(), touches_.end());
    for (std::size_t k = 1; k < touches_.size(); ++k) {
      if (same_smoothing(face_of(touches_[k - 1].corner), face_of(touches_[k].corner))) {
        join(touches_[k - 1].corner, touches_[k].corner);
      }
    }
  }

  void join_across_edges() {
    touches_.clear();
    bridges_.clear();
    has_host_.assign(corners_.size(), 0);
    for (std::uint32_t i = 0; i < corners_.size(); ++i) {
      const std::uint32_t c = corners_[i];
      const std::uint32_t begin = faces_.begin[face_of(i)];
      const std::uint32_t end = faces_.begin[face_of(i) + 1];
      const std::uint32_t before = faces_.corner_position[c > begin ? c - 1 : end - 1];
      const std::uint32_t after = faces_.corner_position[c + 1 < end ? c + 1 : begin];
      touches_.push_back({before, i});
      touches_.push_back({after, i});
      if (is_sliver_[face_of(i)] != 0 && bridges_.size() < kMaxBridges) {
        bridges_.emplace_back(before, after);
      }
    }
    for (std::size_t b = 0; b < bridges_.size(); ++b) {
      const auto [from, to] = bridges_[b];
      const auto rename = [from = from, to = to](std::uint32_t& end) { end = end == from ? to : end; };
      for (Touch& touch : touches_) {
        rename(touch.end);
      }
      for (std::size_t later = b + 1; later < bridges_.size(); ++later) {
        rename(bridges_[later].first);
        rename(bridges_[later].second);
      }
    }
    std::sort(touches_.begin(), touches_.end());
    for (std::size_t begin = 0; begin < touches_.size();) {
      std::size_t end = begin;
      while (end < touches_.size() && touches_[end].end == touches_[begin].end) {
        ++end;
      }
      join_one_edge({touches_.data() + begin, end - begin});
      begin = end;
    }
  }

  void join_one_edge(std::span<const Touch> touches) {
    for (std::size_t k = 0; k < touches.size(); ++k) {
      const std::uint32_t f = face_of(touches[k].corner);
      for (std::size_t l = k + 1; l < std::min(touches.size(), k + kMaxFacesCompared); ++l) {
        const std::uint32_t g = face_of(touches[l].corner);
        if (is_sliver_[f] == 0 && is_sliver_[g] == 0 && same_smoothing(f, g) && dot(normals_[f], normals_[g]) >= least_cosine_) {
          join(touches[k].corner, touches[l].corner);
        }
      }
    }
    for (const Touch& sliver : touches) {
      if (is_sliver_[face_of(sliver.corner)] == 0 || has_host_[sliver.corner] != 0) {
        continue;
      }
      for (const Touch& host : touches.first(std::min(touches.size(), kMaxFacesCompared))) {
        if (is_sliver_[face_of(host.corner)] == 0 && same_smoothing(face_of(sliver.corner), face_of(host.corner))) {
          join(sliver.corner, host.corner);
          has_host_[sliver.corner] = 1;  // one only: a second would bring the two together
          break;
        }
      }
    }
  }

  const Faces& faces_;
  const std::vector<std::uint32_t>& corner_face_;
  std::span<const Vec3d> normals_;
  std::span<const std::uint8_t> is_sliver_;
  bool is_creased_;
  double least_cosine_;
  std::span<const std::uint32_t> corners_;
  std::vector<std::uint32_t> parent_;
  std::vector<Touch> touches_;
  std::vector<std::uint8_t> has_host_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> bridges_;
};

}  // namespace

SmoothingGroups smoothing_groups(const Faces& faces, std::span<const Vec3d> normals, std::span<const std::uint8_t> is_sliver, double crease_deg,
                                 int threads) {
  SmoothingGroups groups;
  if (crease_deg >= 180 && faces.smoothing.empty()) {
    groups.of_corner.assign(faces.corner_position.begin(), faces.corner_position.end());
    groups.count = static_cast<std::uint32_t>(faces.positions.size());
    return groups;
  }
  resize_big(groups.of_corner, faces.corner_position.size());
  std::vector<std::uint32_t> corner_face;
  resize_big(corner_face, faces.corner_position.size());
  parallel_slices(faces.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t f = first; f < last; ++f) {
      std::fill(corner_face.data() + faces.begin[f], corner_face.data() + faces.begin[f + 1], static_cast<std::uint32_t>(f));
    }
  });
  const Rings rings = rings_of(faces, threads);
  // The groups of a slice are numbered from 0 on, then by what the slices before it have.
  const std::size_t slices = slice_count(faces.positions.size(), threads, kSmallestSlice / 4);
  const auto slice_begin = [&](std::size_t s) { return faces.positions.size() * s / slices; };
  std::vector<std::uint32_t> first(slices);
  parallel_for(slices, threads, [&](std::size_t s) {
    Ring ring(faces, corner_face, normals, is_sliver, crease_deg);
    for (std::size_t p = slice_begin(s); p < slice_begin(s + 1); ++p) {
      first[s] = ring.group(std::span(rings.corner).subspan(rings.begin[p], rings.begin[p + 1] - rings.begin[p]), first[s], groups.of_corner);
    }
  });
  for (std::uint32_t& count : first) {
    groups.count += std::exchange(count, groups.count);
  }
  parallel_for(slices, threads, [&](std::size_t s) {
    for (std::size_t i = rings.begin[slice_begin(s)]; first[s] != 0 && i < rings.begin[slice_begin(s + 1)]; ++i) {
      groups.of_corner[rings.corner[i]] += first[s];
    }
  });
  return groups;
}

}  // namespace lustro
