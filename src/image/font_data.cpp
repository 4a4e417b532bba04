// DejaVu Sans 2.37, byte by byte, as the build found it (cmake/LustroEmbedFont.cmake). A file of its own, because it takes seconds to compile.
#include "image/font_data.hpp"

namespace lustro {
namespace {

constexpr unsigned char kDejaVuSans[] = {
#include "image/dejavu_sans.inc"
};

}  // namespace

std::span<const unsigned char> dejavu_sans() {
  return kDejaVuSans;
}

}  // namespace lustro
