// What the local model of lighting costs: a scene's picture beside the one that the radiance equation gives, and where they part.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/render.hpp"
#include "lustro/result.hpp"
#include "lustro/scene.hpp"

namespace lustro {

/// How far picture b is from picture a. Red, green and blue; alpha has no part in it.
struct PictureError {
  double rmse = 0;       ///< root mean square over pixels and channels, linear light
  double flip = 0;       ///< mean FLIP error of the stored pictures (toned and encoded), 0..1
  double luminance = 0;  ///< mean |Y_b - Y_a|, over the truth's mean Y (Rec. 709)
  double bias = 0;       ///< mean (Y_b - Y_a), over the truth's mean Y: above 0 where b is brighter
};

/// What the local picture leaves out or makes up.
enum class ApproximationCause : std::uint8_t {
  interpolation,    ///< light at faces or vertices, and not at every pixel
  mesh_normals,     ///< normals that are interpolated over flat triangles
  ambient,          ///< a constant in place of light that comes from other surfaces
  shadows,          ///< lights that shine through everything, and areas that shine as points
  interreflection,  ///< surfaces that light each other, mirrors and glass
};
inline constexpr std::size_t kApproximationCauses = 5;

/// `interpolation`, `mesh-normals`, ...
[[nodiscard]] std::string_view cause_name(ApproximationCause cause);
/// A sentence for people.
[[nodiscard]] std::string_view cause_text(ApproximationCause cause);

/// One cause by itself: two pictures that differ in it alone.
struct CauseError {
  ApproximationCause cause = ApproximationCause::interpolation;
  bool applies = true;  ///< false: the scene does not have it (light is found at every pixel, say), and there are no pictures
  Image before, after;  ///< H x W x 4, linear: with the approximation and without it
  PictureError error;
  PictureError noise;  ///< what the samples' chance alone makes of it, one standard error
};

/// A term of the local picture beside what it stands for: the ambient term beside all light that met more than one surface, the others beside
/// their own direct light with shadows.
struct TermError {
  AovKind term = AovKind::ambient;  ///< ambient, diffuse, specular or emission
  Image local, truth;               ///< H x W x 4, linear
  PictureError error;
  PictureError noise;
};

/// The scene's picture and the truth.
struct ApproximationReport {
  Image local;  ///< H x W x 4, linear: as Engine::raster draws it
  Image truth;  ///< the same by Engine::path
  PictureError error;
  PictureError noise;  ///< of the truth, one standard error
  /// In the order of ApproximationCause. All but mesh_normals are a chain: the first one's `before` is `local`, the last one's `after` is
  /// `truth`, and each one's `before` the `after` of the one before it; so their signed differences add up to the whole one's.
  std::vector<CauseError> causes;
  std::vector<TermError> terms;  ///< those that the scene has
  int samples = 0;               ///< paths a pixel of the truth
  std::uint64_t rays = 0;        ///< of all pictures
  double seconds = 0;
  Notes notes;
};

struct ApproximationOptions {
  int threads = 0;  ///< 0: one a core
  PathOptions path{};
  std::function<void(double)> progress{};  ///< called with 0..1
};

/// Draws the scene both ways, and what lies between. Every true picture is drawn twice with half of the samples: how those halves differ is what
/// is known of the noise.
/// errors  as render(); unsupported in a build without Engine::path; usage for fewer than two samples
[[nodiscard]] Result<ApproximationReport> measure_approximations(const Scene& scene, const ApproximationOptions& options = {});

/// How far b is from a.
/// truth_luminance  mean Y of the truth, by which the luminances are divided; where it is 0 they stand as they are
/// errors           usage where the sizes differ
[[nodiscard]] Result<PictureError> picture_error(const Image& a, const Image& b, double truth_luminance, Transfer transfer, const Tone& tone);

/// Mean Y (Rec. 709) of the picture's linear rgb.
[[nodiscard]] double mean_luminance(const Image& image);

}  // namespace lustro
