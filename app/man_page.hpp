// The man page in roff, made from the manual.
#pragma once

#include <string>

#include "manual.hpp"

namespace lustro::app {

[[nodiscard]] std::string man_page(const Manual& manual);

}  // namespace lustro::app
