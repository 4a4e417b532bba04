// The browser of whoever sits in front of the machine.
#pragma once

#include <string>

namespace lustro::app {

/// Whether there is a display on which a browser could open: DISPLAY or WAYLAND_DISPLAY, or macOS.
[[nodiscard]] bool has_display();

/// Opens an address in the browser: by the program that BROWSER names, else as the desktop does it. Does not wait for it; where there is none,
/// nothing happens.
void open_browser(const std::string& url);

}  // namespace lustro::app
