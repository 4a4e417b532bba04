// What paths have brought so far, in a file: a picture that was interrupted goes on from it, and ends with the same bits.
//
// Little-endian: the eight bytes `LUSTROP1`, width, height and samples (32 bits each), rays, fingerprint and probe (64 bits each); then for each
// pixel, from the top left, eight doubles (the sums of red, green, blue, their squares, the squares of luminance, alpha), then a byte a pixel
// (1: a path met a surface), then XXH64 of all that stands before.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lustro/render.hpp"
#include "lustro/scene.hpp"

namespace lustro {

/// What a pixel has seen: sums, and sums of squares.
struct PixelSums {
  std::array<double, 3> color{};
  std::array<double, 3> squares{};
  double luminance_squares = 0;
  double alpha = 0;
  bool has_hit = false;
};

struct PathState {
  int width = 0, height = 0;
  int samples = 0;                ///< a pixel
  std::uint64_t rays = 0;         ///< that were shot
  std::uint64_t fingerprint = 0;  ///< of the scene's file and the options: path_fingerprint()
  std::uint64_t probe = 0;  ///< of what the first path of each pixel brought, which files, this program and the machine decide: hash_sums()
  std::vector<PixelSums> pixels;
};

/// A number for all that a scene states and an option decides about what paths bring; tone and coverage samples do not.
[[nodiscard]] std::uint64_t path_fingerprint(const Scene& scene, const PathOptions& options);

/// A number for the bits of the sums.
[[nodiscard]] std::uint64_t hash_sums(std::span<const PixelSums> pixels);

/// The file's bytes.
[[nodiscard]] std::vector<std::byte> encode_path_state(const PathState& state);

/// A picture of this size from a file's bytes.
///
/// name    for messages
/// errors  malformed; usage where it holds another size
[[nodiscard]] Result<PathState> decode_path_state(std::span<const std::byte> bytes, const std::string& name, int width, int height);

/// The same from a file; nothing where there is none. No more is read than a picture of this size takes.
/// errors  those of decode_path_state(); io
[[nodiscard]] Result<std::optional<PathState>> read_path_state(const std::filesystem::path& file, int width, int height);

}  // namespace lustro
