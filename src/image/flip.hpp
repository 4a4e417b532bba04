// FLIP, an estimate of the difference that a person sees when two pictures are flipped back and forth on a screen.
#pragma once

#include <span>
#include <vector>

namespace lustro {

/// Pixels that one degree of the field of view holds: a screen 0.7 m wide and 3840 pixels across, seen from 0.7 m. 67 as the paper rounds it.
constexpr double kPixelsPerDegree = 67.02064327658225;

/// The error of every pixel, 0 (equal) .. 1.
///
/// a, b     H x W x 3, interleaved, sRGB-encoded, 0..1
/// returns  H x W, the same for any number of threads
/// source   Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images",
///          sections 4.1 (colour), 4.2 (features), 4.3 (final)
[[nodiscard]] std::vector<float> flip_error(std::span<const float> a, std::span<const float> b, int width, int height,
                                            double pixels_per_degree = kPixelsPerDegree);

}  // namespace lustro
