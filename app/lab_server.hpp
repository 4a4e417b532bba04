// The lab's server: HTTP on loopback, by libevent, on the calling thread alone.
#pragma once

#include <functional>
#include <optional>

#include "lab_page.hpp"
#include "lab_watch.hpp"

namespace lustro::app {

/// Whether this build can serve at all.
[[nodiscard]] Result<void> check_server();

/// Serves until the process is asked to end (SIGINT, SIGTERM, SIGHUP).
/// watch    null: no file was given. Its files are looked at three times a second, and whoever listens is told of changes
/// port     nothing: the first free one from 8000 on; 0: any
/// started  called with the port once requests are taken
/// errors   io where the port is taken, or the system refuses it; unsupported in a build without libevent
[[nodiscard]] Result<void> serve_lab(const LabPage& page, LabWatch* watch, std::optional<int> port,
                                     const std::function<Result<void>(int port)>& started);

}  // namespace lustro::app
