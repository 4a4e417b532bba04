// All library materials on spheres in one picture, labelled, a row or two a group.
#pragma once

#include <functional>

#include "lustro/image.hpp"

namespace lustro::app {

/// The sheet, linear, opaque. Every sphere stands in the same light, because light and view are parallel.
[[nodiscard]] Result<Image> material_sheet(int threads, std::function<void(double)> progress);

}  // namespace lustro::app
