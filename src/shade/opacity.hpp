// How much of what lies behind a surface hides.
//
//   a = opacity * map * vertex alpha, within 0..1           halo: a = 1 - |N.V| (1 - a)
//
//   A surface that catches shadows has the opacity that shade/shadow_catcher.hpp gives, times how strongly it catches; else a = 0 for it.
//
//   blend   the surface's light is seen with a, what lies behind with 1 - a (Porter and Duff 1984, over)
//   mask    a sample is covered where a >= cutoff
//
// source  Ramey, Rose and Tyerman, MTL specification, d -halo; glTF 2.0, 3.9.4
#pragma once

#include "lustro/options.hpp"
#include "math/lane.hpp"
#include "shade/texturing.hpp"

namespace lustro {

/// The same for all lanes.
struct ShadingOpacity {
  AlphaMode mode = AlphaMode::opaque;  ///< blend and mask: only where something can be seen through
  float opacity = 1;
  float cutoff = 0.5F;
  bool has_vertex_alphas = false;
  bool has_map = false;
  bool has_halo = false;
  float catches = 0;  ///< above 0: it shows nothing but shadows, and these so strongly
  ShadingMap map;

  /// Whether it is the same everywhere.
  [[nodiscard]] bool is_uniform() const { return !has_vertex_alphas && !has_map && !has_halo && !(catches > 0); }
};

/// MTL's halo: denser where the surface is seen from the side.
template <class F>
LUSTRO_INLINE F halo(const F& opacity, const F& n_dot_v) {
  return F(1) - lane_abs(n_dot_v) * (F(1) - opacity);
}

}  // namespace lustro
