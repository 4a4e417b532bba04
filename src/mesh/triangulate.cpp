// Ear cutting with predicates in double: float coordinates seen along a main axis are compared without any rounding, in other directions with
// an error far below the rounding of the coordinates themselves.
#include "mesh/triangulate.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>

#include "math/trig.hpp"
#include "mesh/polygon.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {
namespace {

/// Tests of a corner against an ear that a polygon may cost, a corner. Enough for honest outlines of a hundred thousand corners; a knot of
/// crossing edges would else take cubic time.
constexpr std::size_t kTestsPerCorner = 4000;

}  // namespace

void Triangulator::project(std::span<const Vec3f> polygon) {
  const PolygonPlane plane = plane_of(polygon.size(), [&](std::size_t i) { return polygon[i]; });
  const Vec3d& n = plane.normal;
  rounding_ = plane.rounding;
  // Axes u, v with u x v = n, without a branch on a near-zero component (Duff et al. 2017); along a main axis they are main axes, exactly.
  const double sign = n.z < 0 ? -1.0 : 1.0;
  const double a = -1.0 / (sign + n.z);
  const double b = n.x * n.y * a;
  const Vec3d u{1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x};
  const Vec3d v{b, sign + n.y * n.y * a, -n.y};
  const Vec3d origin = vec_cast<double>(polygon[0]);
  points_.resize(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3d p = vec_cast<double>(polygon[i]) - origin;
    points_[i] = {dot(p, u), dot(p, v)};
  }
}

/// Twice the signed area of a, b, c.
double Triangulator::cross_at(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
  const Point &p = points_[a], &q = points_[b], &r = points_[c];
  return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
}

Triangulator::Turn Triangulator::turn_at(std::uint32_t corner) const {
  const Point &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
  const double reach = std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(c.x - b.x), std::abs(c.y - b.y)});
  const double turn = cross_at(previous_[corner], corner, next_[corner]);
  if (std::abs(turn) <= rounding_ * reach) {
    return Turn::straight;
  }
  return turn > 0 ? Turn::left : Turn::right;
}

/// How far the outline turns in all: 2 pi once round, whatever its dents. Nothing where it turns back on itself, left or right alike.
std::optional<double> Triangulator::turning() const {
  double turned = 0;
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    const Point &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
    const double along = (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y);
    if (turn_[i] == Turn::straight && along <= 0) {
      return std::nullopt;
    }
    turned += arctangent2(cross_at(previous_[i], i, next_[i]), along);
  }
  return turned;
}

/// Convex, and no triangle of the fan from corner 0 without area. The corners are known to turn once round.
bool Triangulator::is_fan() const {
  const auto size = static_cast<std::uint32_t>(points_.size());
  if (turn_[1] != Turn::left || turn_[size - 1] != Turn::left || std::find(turn_.begin(), turn_.end(), Turn::right) != turn_.end()) {
    return false;
  }
  for (std::uint32_t i = 1; i + 1 < size; ++i) {
    if (cross_at(0, i, i + 1) <= 0) {
      return false;
    }
  }
  return true;
}

/// Sorts the corners that are not convex into a grid with about two in a cell: only they can lie in an ear.
void Triangulator::build_grid() {
  const auto is_obstacle = [&](std::uint32_t i) { return turn_[i] != Turn::left; };
  lower_ = upper_ = points_[0];
  std::size_t obstacles = 0;
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    lower_ = {std::min(lower_.x, points_[i].x), std::min(lower_.y, points_[i].y)};
    upper_ = {std::max(upper_.x, points_[i].x), std::max(upper_.y, points_[i].y)};
    obstacles += is_obstacle(i) ? 1U : 0U;
  }
  cells_ = static_cast<std::uint32_t>(std::clamp(std::sqrt(static_cast<double>(obstacles) / 2), 1.0, 1024.0));
  cell_begin_.assign(std::size_t{cells_} * cells_ + 1, 0);
  const auto cell_of = [&](std::uint32_t i) { return std::size_t{row_of(points_[i].y)} * cells_ + column_of(points_[i].x); };
  for (std::uint32_t i = 0; i < points_.size(); ++i) {
    cell_begin_[cell_of(i) + 1] += is_obstacle(i) ? 1U : 0U;
  }
  std::partial_sum(cell_begin_.begin(), cell_begin_.end(), cell_begin_.begin());
  obstacles_.resize(obstacles);
  for (auto i = static_cast<std::uint32_t>(points_.size()); i-- > 0;) {  // filled from behind: the ends move back to the begins
    if (is_obstacle(i)) {
      obstacles_[--cell_begin_[cell_of(i) + 1]] = i;
    }
  }
  cell_begin_.erase(cell_begin_.begin());  // every end is now the begin of its own cell
  cell_begin_.push_back(static_cast<std::uint32_t>(obstacles));
}

std::uint32_t Triangulator::cell_at(double x, double lower, double upper) const {
  return upper > lower ? static_cast<std::uint32_t>(std::clamp((x - lower) / (upper - lower) * cells_, 0.0, cells_ - 1.0)) : 0;
}

/// Whether the triangle at the corner has no other corner inside it or within `slack` of its third side. Corners in the very place of one of
/// its own do not count: the outline passes there without entering.
bool Triangulator::is_ear(std::uint32_t corner, double slack) {
  const std::uint32_t before = previous_[corner];
  const std::uint32_t after = next_[corner];
  const Point a = points_[before], b = points_[corner], c = points_[after];
  const double lower_x = std::min({a.x, b.x, c.x}) - slack, upper_x = std::max({a.x, b.x, c.x}) + slack;
  const double lower_y = std::min({a.y, b.y, c.y}) - slack, upper_y = std::max({a.y, b.y, c.y}) + slack;
  const double side_slack = slack * std::max(std::abs(c.x - a.x), std::abs(c.y - a.y));
  const auto in_place_of = [](const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; };
  const std::uint32_t left = column_of(lower_x), right = column_of(upper_x);
  for (std::uint32_t row = row_of(lower_y); row <= row_of(upper_y); ++row) {
    const std::size_t begin = cell_begin_[std::size_t{row} * cells_ + left];
    const std::size_t end = cell_begin_[std::size_t{row} * cells_ + right + 1];
    tests_left_ -= std::min(tests_left_, end - begin + 1);
    for (std::size_t k = begin; k < end; ++k) {
      const std::uint32_t i = obstacles_[k];
      const Point p = points_[i];
      if (p.x < lower_x || p.x > upper_x || p.y < lower_y || p.y > upper_y || next_[i] == i || turn_[i] == Turn::left || in_place_of(p, a) ||
          in_place_of(p, b) || in_place_of(p, c)) {
        continue;
      }
      if (cross_at(before, corner, i) >= 0 && cross_at(corner, after, i) >= 0 && cross_at(after, before, i) >= -side_slack) {
        return false;
      }
    }
  }
  return true;
}

bool Triangulator::cut_ears(std::vector<std::array<std::uint32_t, 3>>& out) {
  const auto size = static_cast<std::uint32_t>(points_.size());
  build_grid();
  tests_left_ = kTestsPerCorner * size;

  // What a corner must be to be cut off next. A round without a cut lets the next, weaker claim in; a cut goes back to the first.
  enum Claim : std::uint8_t { ear, ear_touching, straight, left, any };
  int claim = ear;
  bool clean = true;
  std::uint32_t corner = 1;
  std::uint32_t remaining = size;
  std::uint32_t tried = 0;
  while (remaining > 3) {
    bool cut = tests_left_ == 0;
    switch (claim) {
      case ear:
        cut |= turn_[corner] == Turn::left && is_ear(corner, rounding_);
        break;
      case ear_touching:
        cut |= turn_[corner] == Turn::left && is_ear(corner, 0);
        break;
      case straight:
        cut |= turn_[corner] == Turn::straight;
        break;
      case left:
        cut |= turn_[corner] == Turn::left;
        break;
      default:
        cut = true;
    }
    const std::uint32_t before = previous_[corner];
    const std::uint32_t after = next_[corner];
    if (cut) {
      clean = clean && claim <= straight && tests_left_ > 0;
      out.push_back({before, corner, after});
      next_[before] = after;
      previous_[after] = before;
      next_[corner] = corner;  // no longer part of the outline
      turn_[before] = turn_at(before);
      turn_[after] = turn_at(after);
      --remaining;
      claim = ear;
      tried = 0;
      corner = next_[after];  // not the neighbour at once: a fan of needles around one corner would be the rule
    } else {
      tests_left_ -= std::min<std::size_t>(tests_left_, 1);
      corner = after;
      if (++tried == remaining) {
        tried = 0;
        ++claim;
      }
    }
  }
  out.push_back({previous_[corner], corner, next_[corner]});
  return clean && turn_[corner] != Turn::right;
}

bool Triangulator::cut(std::span<const Vec3f> polygon, std::vector<std::array<std::uint32_t, 3>>& out) {
  const auto size = static_cast<std::uint32_t>(polygon.size());
  if (size == 3) {
    out.push_back({0, 1, 2});
    return true;
  }
  project(polygon);
  next_.resize(size);
  previous_.resize(size);
  turn_.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) {
    next_[i] = i + 1 < size ? i + 1 : 0;
    previous_[i] = i > 0 ? i - 1 : size - 1;
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    turn_[i] = turn_at(i);
  }
  const double turned = size == 4 ? 2 * kPi : turning().value_or(2 * kPi);  // four corners cannot turn left twice round
  const bool turns_once = std::abs(turned - 2 * kPi) < 1;
  if (!turns_once || !is_fan()) {
    return cut_ears(out) && turns_once;
  }
  for (std::uint32_t i = 1; i + 1 < size; ++i) {
    out.push_back({0, i, i + 1});
  }
  return true;
}

// A polygon of n corners makes n - 2 triangles, so every face knows where its own begin.
Triangles triangulate(const SourceMesh& mesh, int threads) {
  Triangles triangles;
  const std::size_t count = mesh.corner_position.size() - 2 * mesh.face_count();
  resize_big(triangles.corners, count);
  resize_big(triangles.face, count);
  std::atomic<std::size_t> crossing = 0;
  parallel_slices(mesh.face_count(), threads, [&](std::size_t first_face, std::size_t end_face) {
    Triangulator triangulator;
    std::vector<Vec3f> polygon;
    std::vector<std::array<std::uint32_t, 3>> cut;
    for (std::size_t f = first_face; f < end_face; ++f) {
      const std::uint32_t begin = mesh.face_begin[f];
      const std::uint32_t end = mesh.face_begin[f + 1];
      std::size_t t = begin - 2 * f;
      if (end - begin == 3) {
        triangles.corners[t] = {begin, begin + 1, begin + 2};
        triangles.face[t] = static_cast<std::uint32_t>(f);
        continue;
      }
      polygon.clear();
      for (std::uint32_t c = begin; c < end; ++c) {
        polygon.push_back(mesh.positions[mesh.corner_position[c]]);
      }
      cut.clear();
      crossing += triangulator.cut(polygon, cut) ? 0U : 1U;
      for (const auto& corners : cut) {
        triangles.corners[t] = {begin + corners[0], begin + corners[1], begin + corners[2]};
        triangles.face[t++] = static_cast<std::uint32_t>(f);
      }
    }
  });
  triangles.crossing_polygons = crossing;
  return triangles;
}

}  // namespace lustro
