// The rows of kernels: which this build has, which this machine can run, which one draws.
#pragma once

#include "lustro/render.hpp"
#include "raster/frame.hpp"

namespace lustro {

/// The widest row for `automatic`, else the one that is asked for.
/// errors  unsupported where the machine cannot run it, with those that it can
[[nodiscard]] Result<Target> choose_target(Target wanted);

/// The kernels of a row that choose_target() gave.
[[nodiscard]] const Kernels& kernels_of(Target target);

}  // namespace lustro
