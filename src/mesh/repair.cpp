// One loop for all three.
#include "mesh/repair.hpp"

#include <atomic>
#include <cmath>

#include "parallel/slices.hpp"

namespace lustro {
namespace {

/// Counts the elements that `repair` says were beyond repair.
template <class T, class Repair>
std::size_t repair_all(std::vector<T>& list, int threads, const Repair& repair) {
  std::atomic<std::size_t> count = 0;
  parallel_slices(list.size(), threads, [&](std::size_t begin, std::size_t end) {
    std::size_t bad = 0;
    for (std::size_t i = begin; i < end; ++i) {
      bad += repair(list[i]) ? 0U : 1U;
    }
    count += bad;
  });
  return count;
}

}  // namespace

std::size_t whiten(std::vector<Vec3f>& colors, int threads) {
  return repair_all(colors, threads, [](Vec3f& color) {
    const bool is_good = is_finite(color);
    color = is_good ? color : Vec3f{1, 1, 1};
    return is_good;
  });
}

std::size_t replace_uvs(std::vector<Vec2f>& uvs, int threads) {
  return repair_all(uvs, threads, [](Vec2f& uv) {
    const bool is_good = std::isfinite(uv.x) && std::isfinite(uv.y);
    uv = is_good ? uv : Vec2f{};
    return is_good;
  });
}

std::size_t normalize_normals(std::vector<Vec3f>& normals, int threads) {
  return repair_all(normals, threads, [](Vec3f& normal) {
    const Vec3d n = vec_cast<double>(normal);
    const double size = length(n);
    const bool is_good = std::isfinite(size) && size > 0;
    normal = is_good ? vec_cast<float>(Vec3d{n.x / size, n.y / size, n.z / size}) : Vec3f{};
    return is_good;
  });
}

}  // namespace lustro
