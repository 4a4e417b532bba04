// kLanes fragments at a time: where they lie in their triangles and what the vertices say of them. Part of a row (row.cpp).
//
// The lanes of one batch show the same material, and so the same instance. What a lane calculates is what the reference calculates for that
// fragment (reference/triangle.cpp, reference/face.hpp), operation by operation.
#pragma once

#include "raster/frame.hpp"
#include "raster/row_faces.hpp"
#include "raster/row_texture.hpp"
#include "scene/mapped_surface.hpp"
#include "shade/depth_map.hpp"
#include "shade/interpolation.hpp"
#include "shade/occlusion.hpp"
#include "shade/shadow_catcher.hpp"
#include "simd/lanes.hpp"

// What a kernel fills is not cleared first.
// NOLINTBEGIN(cppcoreguidelines-pro-type-member-init)
namespace lustro::HWY_NAMESPACE {

/// Coefficients under vertex colours.
HWY_INLINE Coefficients<Float> tinted(const Coefficients<float>& stated, const Vec3<Float>& tint) {
  return {vec_cast<Float>(stated.ambient) * tint, vec_cast<Float>(stated.diffuse) * tint, vec_cast<Float>(stated.specular),
          vec_cast<Float>(stated.emission), stated.shininess};
}

/// Where kLanes fragments lie on the image and in their triangles.
struct FragmentPlaces {
  Float x, y, depth;
  Weights<Float> weights;
  Float corner_weight1, corner_weight2;  // of the screen triangle's own corners
};

/// The weights of clipped triangles' vertices, or their slopes, lane by lane: rare.
inline HWY_NOINLINE void unclip(const Frame& frame, Int flags, const Mask& clipped, const Weights<Float>& at, Weights<Float>& weights) {
  alignas(64) std::array<std::uint32_t, kLanes> chosen{}, flag{};
  alignas(64) std::array<std::array<float, kLanes>, 3> in, out;
  store_where(clipped, chosen.data(), Int(1));
  store(flag.data(), flags);
  for (std::size_t k = 0; k < 3; ++k) {
    store(in[k].data(), at[k]);
    store(out[k].data(), weights[k]);
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    if (chosen[i] != 0) {
      const std::array<Vec3f, 3>& corner = frame.loose[flag[i] >> Record::kLooseShift].corner_weights;
      const auto blend = [&](float a, float b, float c) { return (a * in[0][i] + b * in[1][i]) + c * in[2][i]; };
      out[0][i] = blend(corner[0].x, corner[1].x, corner[2].x);
      out[1][i] = blend(corner[0].y, corner[1].y, corner[2].y);
      out[2][i] = blend(corner[0].z, corner[1].z, corner[2].z);
    }
  }
  for (std::size_t k = 0; k < 3; ++k) {
    weights[k] = load(out[k].data());
  }
}

/// From the corners of the screen triangle to the vertices of the mesh's: linear, so for weights and their slopes alike.
HWY_INLINE Weights<Float> at_vertices(const Faces& faces, const Weights<Float>& at_corners) {
  const Int flags = faces.flags;
  const Mask is_swapped = (flags & Int(Record::kSwapped)) > Int(0);
  Weights<Float> weights{at_corners[0], select(is_swapped, at_corners[2], at_corners[1]), select(is_swapped, at_corners[1], at_corners[2])};
  if (HWY_UNLIKELY(faces.table.has_clipped)) {
    unclip(faces.table.frame, flags, (flags & Int(Record::kClipped)) > Int(0), at_corners, weights);
  }
  return weights;
}

/// reference/triangle.cpp: interpolants_at()
HWY_INLINE FragmentPlaces locate(const Faces& faces, Int px, Int py) {
  const FaceTable& of = faces.table;
  const View& view = faces.scene.view;
  const Int x = px - faces.choose(of.x);
  const Int y = py - faces.choose(of.y);
  Float e1, e2;
  if (HWY_LIKELY(of.is_small)) {
    e1 = edge_along<true>(faces.choose(of.edge1_x), faces.choose(of.edge1_y), x, y);
    e2 = edge_along<true>(faces.choose(of.edge2_x), faces.choose(of.edge2_y), x, y);
  } else {
    e1 = edge_along<false>(faces.choose(of.edge1_x), faces.choose(of.edge1_y), x, y);
    e2 = edge_along<false>(faces.choose(of.edge2_x), faces.choose(of.edge2_y), x, y);
  }
  const Float key = (faces.choose(of.key0) + faces.choose(of.key_slope1) * e1) + faces.choose(of.key_slope2) * e2;
  const Float inverse_area = faces.choose(of.inverse_area);
  Float w1 = e1 * inverse_area;
  Float w2 = e2 * inverse_area;
  FragmentPlaces at;
  if (view.projection == Projection::perspective) {
    at.depth = Float(1) / key;
    w1 = (w1 * faces.choose(of.key1)) * at.depth;
    w2 = (w2 * faces.choose(of.key2)) * at.depth;
  } else {
    at.depth = Float(view.depth_far) - key * Float(view.depth_far - view.depth_near);
  }
  at.corner_weight1 = w1;
  at.corner_weight2 = w2;
  at.weights = at_vertices(faces, {(Float(1) - w1) - w2, w1, w2});
  at.x = to_float(px) * Float(1.0F / kSubpixelUnits);  // exact, as a division by a power of two is
  at.y = to_float(py) * Float(1.0F / kSubpixelUnits);
  return at;
}

/// reference/triangle.cpp: weight_slopes_at()
HWY_INLINE WeightSlopes<Float> slopes_at(const Faces& faces, const FragmentPlaces& at) {
  const auto part = [&](std::size_t i) { return faces.choose(faces.table.slopes[i]); };
  const bool is_perspective = faces.scene.view.projection == Projection::perspective;
  const CornerSlopes<Float> of{part(0), part(1), part(2), part(3), part(4), part(5)};
  const WeightSlopes<Float> corners = weight_slopes(is_perspective, of, at.corner_weight1, at.corner_weight2, at.depth);
  return {at_vertices(faces, corners.dx), at_vertices(faces, corners.dy)};
}

/// kLanes fragments of one material, ready to be lit. Everything is made where it stays: what is cleared first, or copied, goes through memory.
struct Batch {
  Faces faces;
  FragmentPlaces at;
  Vec3<Float> position;
  Vec3<Float> normal;          // where it is asked for
  WeightSlopes<Float> slopes;  // where the table has them

  HWY_INLINE Batch(const FaceTable& table, std::size_t number, Int px, Int py, bool needs_normal)
      : faces(table, number),
        at(locate(faces, px, py)),
        position(faces.scene.view.point_at(at.x, at.y, at.depth)),
        normal(!needs_normal                                              ? Vec3<Float>{}
               : faces.scene.shading.interpolation == Interpolation::flat ? faces.face_normal()
                                                                          : faces.normal_at(faces.scene.shading.normals, at.weights)),
        slopes(HWY_UNLIKELY(table.has_slopes) ? slopes_at(faces, at) : WeightSlopes<Float>{}) {}
};

/// What the maps say of a batch.
struct Mapped {
  std::array<Footprint<Float>, 2> at;
  MapFactors<Float> factors;
  Vec3<Float> reflection;  // what is seen in the mirrored view, where there is a reflection map
};

/// The opacity of what catches shadows, but for its strength.
inline HWY_NOINLINE Float shadow_on(const Faces& faces, const Vec3<Float>& position, const Vec3<Float>& normal) {
  const PreparedScene& scene = faces.scene;
  const Vec3<Float> face_normal = faces.face_normal();
  return caught_shadow(scene.surrounding_light(), scene.lights, position, normal, [&](std::size_t i) {
    return i == scene.lights.size() ? openness_at(scene.occlusion.shading, position, normal, face_normal)
                                    : visibility_of(scene.lights[i], scene.shadows.maps[i], position, face_normal, normal);
  });
}

/// reference/opacity.cpp: opacity_at()
HWY_INLINE Float opacity_of(const Faces& faces, const FragmentPlaces& at, const WeightSlopes<Float>& slopes) {
  const Float opacity = opacity_on<LaneFetch, Float>(faces, at.weights, slopes);
  const ShadingOpacity& stated = faces.material.opacity;
  if (HWY_LIKELY(!stated.has_halo && !(stated.catches > 0))) {
    return opacity;
  }
  const Shading& shading = faces.scene.shading;
  const Vec3<Float> normal = shading.interpolation == Interpolation::flat ? faces.face_normal() : faces.normal_at(shading.normals, at.weights);
  const View& view = faces.scene.view;
  return stated.catches > 0 ? shadow_on(faces, view.point_at(at.x, at.y, at.depth), normal) * Float(stated.catches)
                            : halo(opacity, dot(normal, view.to_eye_at(at.x, at.y)));
}

/// Looks the material's maps up; the normal becomes theirs.
inline HWY_NOINLINE void look_up_maps(Batch& batch, Mapped& mapped) {
  const Faces& faces = batch.faces;
  const ShadingMaps& maps = faces.material.maps;
  mapped.at = footprints_on<Float>(faces, batch.at.weights, batch.slopes);
  mapped.factors = map_factors<LaneFetch>(maps, mapped.at);
  if (maps.changes_normal()) {
    batch.normal = mapped_normal<LaneFetch>(faces, faces.scene.shading.normals, batch.at.weights, batch.slopes, mapped.at, batch.normal);
  }
  if (HWY_UNLIKELY(maps.reflects)) {
    mapped.reflection = look_up_reflection<LaneFetch>(
        faces.material.reflection, mirrored_view_on(faces, batch.at.weights, batch.slopes, batch.at.x, batch.at.y, batch.normal));
  }
}

}  // namespace lustro::HWY_NAMESPACE
// NOLINTEND(cppcoreguidelines-pro-type-member-init)
