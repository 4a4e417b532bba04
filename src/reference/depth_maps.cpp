// A map of depths is a picture of the casters with one sample a texel, of which the keys are kept.
#include "reference/depth_maps.hpp"

#include <bit>

#include "parallel/big_memory.hpp"
#include "parallel/parallel_for.hpp"
#include "reference/bands.hpp"
#include "reference/visibility.hpp"

namespace lustro {

void draw_depth_maps(const PreparedScene& scene, DepthMaps& maps, int threads) {
  if (maps.empty()) {
    return;
  }
  PreparedScene casters;
  make_casters(scene, casters);
  resize_big(maps.keys, texel_count(maps));
  for (const DepthFace& face : maps.faces) {
    look_from(casters, face.view);
    const std::vector<ScreenTriangle> triangles = setup_triangles(casters, threads);
    const auto bins = bin_by_band(casters.view, triangles);
    parallel_for(bins.size(), threads, [&](std::size_t band) {
      const int top = static_cast<int>(band) * kBandRows;
      const Rectangle rows{0, top, face.view.width, std::min(face.view.height, top + kBandRows)};
      Visibility visibility(casters, rows);
      for (const std::uint32_t index : bins[band]) {
        visibility.draw(triangles[index], index);
      }
      float* key = &maps.keys[face.first + static_cast<std::size_t>(top) * static_cast<std::size_t>(face.view.width)];
      for (int y = rows.top; y < rows.bottom; ++y) {
        for (int x = rows.left; x < rows.right; ++x) {
          *key++ = std::bit_cast<float>(static_cast<std::uint32_t>(visibility.key(x, y, 0) >> 32U));
        }
      }
    });
  }
  bind_keys(maps);
}

}  // namespace lustro
