// What local lighting makes of a scene's environment: smooth light for the diffuse term, a blurred picture for each width of highlight, and what
// is seen behind everything.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "lustro/scene.hpp"
#include "scene/prepare.hpp"

namespace lustro {

/// What is made of a picture of all directions, kept for as long as the next scene shows the same picture. It owns the textures, so it must
/// outlive the scenes around which it was laid.
class EnvironmentCache {
 public:
  /// Forgets what was made of other pictures.
  void use(const std::shared_ptr<const Image>& picture);

  [[nodiscard]] const ShadingEnvironment& diffuse(int threads);
  /// A texture of one white texel, for a sky of one colour.
  [[nodiscard]] Result<std::shared_ptr<const Texture>> white();
  /// The picture as it is, as a texture.
  [[nodiscard]] Result<std::shared_ptr<const Texture>> sharp(int threads);
  /// As the lobe of that exponent sees it; exponents are grouped by the half power of two that is nearest.
  [[nodiscard]] Result<std::shared_ptr<const Texture>> blurred(float n, int threads);

 private:
  struct Blur {
    int group = 0;
    std::shared_ptr<const Texture> texture;
  };
  std::shared_ptr<const Image> picture_;
  std::optional<ShadingEnvironment> diffuse_;
  std::shared_ptr<const Texture> white_, sharp_;
  std::vector<Blur> blurred_;
};

/// Lays the environment, if there is one, around the prepared scene: PreparedScene::around and sky, and a reflection map for every material with
/// a highlight that has none of its own.
///
/// The diffuse term gains k_d times light_around(). The specular term gains k_s times the picture blurred by the material's own lobe, times what
/// the lobe reflects of a white sky: 2 / (n + 1) for the classic one, 1 for those that keep energy, at normal incidence. The lobe of Blinn and
/// Phong, and of GGX, is that of Phong with a quarter of the exponent. Mirrors and glass (illum 3 to 7) show the picture as it is.
///
/// errors  limit for a picture beyond what textures may be
[[nodiscard]] Result<void> lay_surroundings(const Scene& scene, EnvironmentCache& cache, int threads, PreparedScene& prepared);

}  // namespace lustro
