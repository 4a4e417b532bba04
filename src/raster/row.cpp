// One row: the kernels for one instruction set. Compiled once for each, with its flags and LUSTRO_ROW, its name (cmake/LustroRows.cmake).
#include "raster/row_fill.hpp"
#include "raster/row_resolve.hpp"

namespace lustro {

#define LUSTRO_JOIN(a, b) a##b
#define LUSTRO_KERNELS(row) LUSTRO_JOIN(kernels_, row)

const Kernels& LUSTRO_KERNELS(LUSTRO_ROW)();
const Kernels& LUSTRO_KERNELS(LUSTRO_ROW)() {
  static constexpr Kernels kKernels{HWY_NAMESPACE::fill_tile, HWY_NAMESPACE::fill_keys, HWY_NAMESPACE::shade_tile};
  return kKernels;
}

}  // namespace lustro
