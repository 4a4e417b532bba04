// The font that the library carries inside itself.
#pragma once

#include <span>

namespace lustro {

/// The TrueType file of DejaVu Sans. Its licence: https://dejavu-fonts.github.io/License.html
[[nodiscard]] std::span<const unsigned char> dejavu_sans();

}  // namespace lustro
