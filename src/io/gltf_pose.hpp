// Where every node of a glTF file stands, and how its morph targets weigh: as stated, or at a moment of an animation.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/gltf_file.hpp"

namespace lustro {

struct GltfPose {
  std::vector<Mat4> world;                   ///< N, world_from_node
  std::vector<std::vector<double>> weights;  ///< N; of the morph targets of the node's mesh
};

/// time       seconds; nothing: the nodes as they are stated
/// animation  its index or name; empty: the first one
/// errors     usage for an animation that is not there; malformed where keys do not rise, or a place is not finite
[[nodiscard]] Result<GltfPose> pose_of(GltfFile& file, const std::optional<double>& time, const std::string& animation);

/// T R S of a translation, a quaternion (x, y, z, w; of any length but 0) and a scale.
[[nodiscard]] Mat4 matrix_of(const std::array<double, 3>& translation, const std::array<double, 4>& rotation,
                             const std::array<double, 3>& scale);

/// The last key of an animation, seconds.
[[nodiscard]] Result<double> duration_of(GltfFile& file, const GltfAnimation& animation);

/// The index that a number or a name means in a list of names, or nothing. A number wins.
[[nodiscard]] std::optional<std::size_t> find_named(const std::vector<std::string>& names, const std::string& wanted);

/// `0 "walk", 1 "run"`, for messages.
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace lustro
