// Our picture beside a peer's: how many pixels differ, and whether all of those lie where surfaces end.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/scene.hpp"

namespace lustro::peers {

struct PictureDifference {
  long pixels = 0;
  long over = 0;      ///< differ by more than 2/255 in a channel
  long strays = 0;    ///< of these, more than a pixel away from every edge (see picture_difference.cpp)
  int worst = 0;      ///< away from edges, 1/255
  std::string stray;  ///< the first of them, in words
  ByteImage ours;

  [[nodiscard]] double share() const { return static_cast<double>(over) / static_cast<double>(pixels); }
};

/// Renders the scene and compares.
[[nodiscard]] PictureDifference compare_with_peer(const Scene& scene, const ByteImage& peer);

/// Ours, the peer's, and eight times their difference, side by side.
void write_triple(const std::filesystem::path& file, const ByteImage& ours, const ByteImage& peer);

}  // namespace lustro::peers
