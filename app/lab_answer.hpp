// What the lab's server answers to a request: all of its rules, and nothing of sockets.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "lab_page.hpp"
#include "lab_watch.hpp"

namespace lustro::app {

/// A request. Headers that it does not have are empty.
struct LabRequest {
  std::string method = "GET";
  std::string target = "/";  ///< as the request line has it: `/api/files/a%20b.obj?x`
  std::string host{};
  std::string accept_encoding{};
  std::string if_none_match{};
  std::string fetch_site{};     ///< Sec-Fetch-Site: who asks, as browsers say it
  std::string last_event_id{};  ///< what an event stream that broke off has seen last
};

/// A file that is sent while it is read.
struct FileBody {
  std::filesystem::path file;
};

/// Events from now on, after what stands in `first`.
struct EventStream {
  std::string first;
};

struct LabAnswer {
  int status = 200;
  std::vector<std::pair<std::string, std::string>> headers{};
  std::variant<std::string, std::string_view, FileBody, EventStream> body{};

  /// The value of a header; empty where it is not there.
  [[nodiscard]] std::string_view header(std::string_view name) const;
};

/// What is served.
struct LabSite {
  const LabPage* page = nullptr;
  const LabWatch* watch = nullptr;  ///< null: no file was given
  int port = 0;
};

/// The answer. Never anything but the page's files, and the model's.
[[nodiscard]] LabAnswer answer(const LabRequest& request, const LabSite& site);

/// 404.
[[nodiscard]] LabAnswer not_found();

/// What is known of the model now, as an event: `data: {"version": "..."}` or `data: {"error": "..."}` with the stamp as its id.
[[nodiscard]] std::string event_of(const LabWatch& watch);

/// What stands on the status line.
[[nodiscard]] const char* reason_of(int status);

}  // namespace lustro::app
