// What must hold between the keys of a scene, whoever made it: a file, flags or a program.
#pragma once

#include "lustro/scene.hpp"

namespace lustro {

/// Nothing, or the first rule that is broken: near < far, beam < cutoff, directions that are not zero, an eye that is not the target, an up that
/// is not along the view, a fog that ends behind its start, affine matrices. errors  malformed; `where` is the path of the key, `lights[2].beam`
[[nodiscard]] Result<void> check_scene(const Scene& scene);

/// Keys that are stated and change nothing, each with its path: the cutoff of a point light, the height of a perspective camera.
[[nodiscard]] Notes unused_keys(const Scene& scene);

}  // namespace lustro
