// The reference renderer's table of contents. Slow and obvious: it defines what correct is.
#include "reference/render.hpp"

#include <algorithm>
#include <atomic>

#include "parallel/parallel_for.hpp"
#include "parallel/progress.hpp"
#include "reference/aov.hpp"
#include "reference/bands.hpp"
#include "reference/pixel.hpp"
#include "reference/triangle.hpp"
#include "reference/visibility.hpp"

namespace lustro {

void render_reference(const PreparedScene& scene, std::span<const Aov> aovs, const RenderOptions& options, Rendering& result) {
  const bool wants_lights = std::any_of(aovs.begin(), aovs.end(), [](const Aov& aov) { return aov.kind == AovKind::light; });
  const View& view = scene.view;
  result.color = Image(view.width, view.height, 4);
  const std::vector<ScreenTriangle> triangles = setup_triangles(scene, options.threads);  // reference/triangle.cpp
  const auto bins = bin_by_band(view, triangles);

  Progress progress(options.progress, bins.size());
  std::atomic<std::uint64_t> covered{0};
  parallel_for(bins.size(), options.threads, [&](std::size_t band) {
    const int top = static_cast<int>(band) * kBandRows;
    const Rectangle rows{0, top, view.width, std::min(view.height, top + kBandRows)};
    Visibility visibility(scene, rows);  // reference/visibility.cpp
    for (const std::uint32_t index : bins[band]) {
      visibility.draw(triangles[index], index);
    }
    std::uint64_t covered_here = 0;
    for (int y = rows.top; y < rows.bottom; ++y) {
      for (int x = rows.left; x < rows.right; ++x) {
        const Pixel pixel = resolve_pixel(scene, triangles, visibility, x, y, wants_lights, nullptr);  // reference/pixel.cpp
        const std::array<float, 4> color = pixel.color();
        std::copy(color.begin(), color.end(), result.color.at(x, y).begin());
        for (std::size_t i = 0; i < aovs.size(); ++i) {
          store_aov(aovs[i], scene, pixel, result.layers[i].image.at(x, y));
        }
        covered_here += pixel.coverage > 0 ? 1 : 0;
      }
    }
    covered += covered_here;
    progress.step();
  });
  result.stats = {.triangles = scene.triangle_count, .triangles_seen = covered > 0 ? 0 : triangles.size(), .pixels_covered = covered};
  if (options.store_bytes) {
    result.bytes = to_bytes(result.color, scene.transfer, scene.tone);
  }
}

}  // namespace lustro
