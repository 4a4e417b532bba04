// Which face corners around a position share one normal: by smoothing groups and by the crease angle.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lustro/vec.hpp"

namespace lustro {

/// Polygons as flat arrays; what normals are made from.
struct Faces {
  std::span<const Vec3f> positions;                ///< V x 3
  std::span<const std::uint32_t> begin;            ///< F + 1; face f has the corners begin[f] .. begin[f + 1], at least 3
  std::span<const std::uint32_t> corner_position;  ///< C
  std::span<const std::uint32_t> smoothing;        ///< F or empty (all smooth); 0 is off

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(begin.size() - 1); }
};

/// A crease is forgiven this much, so that faces that meet at exactly the crease angle share, whatever the rounding of their corners.
inline constexpr double kCreaseSlackDeg = 0.01;

/// The corners that share a normal have one group, and all of a group lie at one position.
struct SmoothingGroups {
  std::vector<std::uint32_t> of_corner;  ///< C; 0 .. count - 1
  std::uint32_t count = 0;
};

/// Groups the corners around every position.
///
///   - Without smoothing groups and with a crease of 180 degrees, all faces around a position share.
///   - With smoothing groups (and 180), those of one group around a position share; a face in group 0 keeps its own normal.
///   - With a smaller crease, two faces share where they meet in an edge that ends at the position, belong to the same group and turn their
///     normals by at most `crease_deg`; sharing passes on from neighbour to neighbour.
///
/// A sliver has no normal to compare: its long edges count as one edge, across which its neighbours meet, and it joins one of them. Faces
/// with opposite windings are taken as they stand: their normals differ by up to 180 degrees, so that a crease parts them. Where more than
/// 64 faces meet in one edge, each is compared with the next ones only.
///
/// normals     F, unit, or 0
/// is_sliver   F; not 0 where the face's normal is noise
/// crease_deg  0..180
/// threads     0: one a core; the groups are the same for any number
[[nodiscard]] SmoothingGroups smoothing_groups(const Faces& faces, std::span<const Vec3d> normals, std::span<const std::uint8_t> is_sliver,
                                               double crease_deg, int threads = 0);

}  // namespace lustro
