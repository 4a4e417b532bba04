// The one step in which every importer ends: what comes out of it can be drawn without another look.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "lustro/mesh.hpp"

namespace lustro {

/// A source in which
///   - every index lies inside its array, every corner's position is finite, every normal that a corner names has length 1,
///     every uv and colour is finite;
///   - every face has at least three distinct corners and no corner at the place of the one before it;
///   - positions are welded where the source asked for it (`weld_first`).
struct ValidMesh {
  SourceMesh source;                        ///< without materials, objects and notes, which nobody needs further on
  std::vector<std::uint32_t> corner_color;  ///< C, into source.colors, where welding parted it from corner_position; else empty
  Notes notes;                              ///< what was dropped or replaced, each kind once, with its count
};

/// errors  malformed where arrays do not fit together or an index lies outside its array; limit beyond 2^32 - 2 positions or corners
[[nodiscard]] Result<ValidMesh> validate(const SourceMesh& source);
/// The same without a copy. Where there is an error, the source is as it was.
[[nodiscard]] Result<ValidMesh> validate(SourceMesh&& source, int threads);

/// The checks alone: arrays that fit together, indices inside.
[[nodiscard]] Result<void> check_source(const SourceMesh& source, int threads);

/// errors  limit where an array of `count` things could not be indexed
[[nodiscard]] Result<void> check_count(std::size_t count, const char* what);

/// `1 face`, `2 faces`: every note counts its things so.
[[nodiscard]] std::string counted(std::size_t count, const char* singular, const char* plural);

}  // namespace lustro
