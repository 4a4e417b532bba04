// The counts of the model: see stage_work.hpp. They are counted from the formulas of src/shade and docs/theory, not from what the renderer
// executes.
#include "stage_work.hpp"

namespace lustro::app {
namespace {

constexpr double kClusterTriangles = 128, kClusterBytes = 64, kClusterTest = 40;
constexpr double kVertexBytes = 12, kTriangleBytes = 4;
constexpr double kTransform = 18 + 3;     // three rows of three products; one division, two products
constexpr double kSetup = 4 + 3 + 4;      // two edges, the area's sign, the box
constexpr double kPixelTest = 3 * 2 + 4;  // three edges, depth
constexpr double kPixelBytes = 4;

constexpr double kInterpolate = 15 + 10;          // the weighted normal, and its length made 1
constexpr double kPosition = 17 + 10;             // the point, and V made 1
constexpr double kStore = 3 * (8 + 2);            // the transfer curve, rounding
constexpr double kAmbientAndDiffuse = 5 + 3 * 3;  // N.L; two products and their sum a channel
constexpr double kReflect = 7 + 5, kHalf = 3 + 10 + 5;
constexpr double kMicrofacets = 55, kFresnel = 3 * 6;
constexpr double kPower = 25, kSpecular = 3 * 2;

double light_operations(Lighting lighting) {
  switch (lighting) {
    case Lighting::constant:
      return 0;
    case Lighting::lambert:
      return kAmbientAndDiffuse;
    case Lighting::phong:
      return kAmbientAndDiffuse + kReflect + kPower + kSpecular;
    case Lighting::blinn_phong:
      return kAmbientAndDiffuse + kHalf + kPower + kSpecular;
    case Lighting::ggx:
      return kAmbientAndDiffuse + kMicrofacets + kFresnel;
  }
  return 0;
}

double pixel_operations(const FrameFacts& facts) {
  if (facts.shading.interpolation != Interpolation::phong) {
    return 15 + kStore;  // the colour from the vertices or the face, which are lit once for many pixels
  }
  return kInterpolate + kPosition + facts.lights * light_operations(facts.shading.lighting) + kStore;
}

}  // namespace

StageWork cull_work(const FrameFacts& facts) {
  const auto whole_clusters = (facts.triangles + 127) / 128;
  const auto clusters = static_cast<double>(whole_clusters);
  static_assert(kClusterTriangles == 128);
  return {.bytes = clusters * kClusterBytes, .operations = clusters * kClusterTest};
}

StageWork visibility_work(const FrameFacts& facts) {
  const auto vertices = static_cast<double>(facts.vertices), triangles = static_cast<double>(facts.triangles);
  return {.bytes = vertices * kVertexBytes + triangles * kTriangleBytes,
          .operations = vertices * kTransform + triangles * kSetup + static_cast<double>(facts.pixels_covered) * kPixelTest};
}

StageWork shading_work(const FrameFacts& facts) {
  return {.bytes = static_cast<double>(facts.pixels) * kPixelBytes,
          .operations = static_cast<double>(facts.pixels_covered) * pixel_operations(facts)};
}

}  // namespace lustro::app
