// The rules of the lab's server: see lab_answer.hpp.
//
// Other programs of this machine and pages of other sites can reach a server on loopback. So a request must name this very server (a foreign
// page whose own name leads here is refused: DNS rebinding), the model is given to our page alone (Sec-Fetch-Site, and CORP for browsers that do
// not say it), and nothing can be changed.
#include "lab_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "image/lower_case.hpp"
#include "io/percent.hpp"
#include "json_out.hpp"

namespace lustro::app {
namespace {

constexpr std::string_view kPolicy =
    "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; img-src 'self' blob: "
    "data:; connect-src 'self'; object-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
constexpr std::string_view kFiles = "/api/files/";
constexpr std::string_view kText = "text/plain; charset=utf-8";

LabAnswer begin(int status, std::string_view type) {
  LabAnswer answer{.status = status};
  answer.headers = {{"Cross-Origin-Opener-Policy", "same-origin"},   {"Cross-Origin-Embedder-Policy", "require-corp"},
                    {"Cross-Origin-Resource-Policy", "same-origin"}, {"Content-Security-Policy", std::string(kPolicy)},
                    {"X-Content-Type-Options", "nosniff"},           {"Referrer-Policy", "no-referrer"}};
  if (!type.empty()) {
    answer.headers.emplace_back("Content-Type", type);
  }
  return answer;
}

LabAnswer refuse(int status, std::string text) {
  LabAnswer answer = begin(status, kText);
  answer.headers.emplace_back("Cache-Control", "no-store");
  answer.body = std::move(text) + "\n";
  return answer;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) {
    text.remove_suffix(1);
  }
  return text;
}

/// Whether one of the parts between commas is as wanted.
template <class Wanted>
bool any_part(std::string_view list, Wanted&& wanted) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    if (wanted(trimmed(list.substr(begin, end - begin)))) {
      return true;
    }
    begin = end + 1;
  }
  return false;
}

/// RFC 9110, 12.5.3, as far as browsers and tools go: gzip is named, and not with a weight of zero.
bool takes_gzip(const std::string& accept_encoding) {
  return any_part(lower_case(accept_encoding), [](std::string_view part) {
    const std::size_t semicolon = part.find(';');
    if (trimmed(part.substr(0, semicolon)) != "gzip") {
      return false;
    }
    const std::string_view weight = semicolon == std::string_view::npos ? std::string_view() : trimmed(part.substr(semicolon + 1));
    return !weight.starts_with("q=0") || weight.find_first_of("123456789") != std::string_view::npos;
  });
}

/// Whether the browser has what the tag stands for.
bool matches(const std::string& if_none_match, const std::string& etag) {
  return any_part(if_none_match,
                  [&](std::string_view part) { return part == "*" || part == etag || (part.starts_with("W/") && part.substr(2) == etag); });
}

bool names_us(const std::string& host, int port) {
  const std::string name = lower_case(host);
  const std::string suffix = fmt::format(":{}", port);
  constexpr std::array<std::string_view, 3> kNames{"localhost", "127.0.0.1", "[::1]"};
  return std::any_of(kNames.begin(), kNames.end(),
                     [&](std::string_view ours) { return name == std::string(ours) + suffix || (port == 80 && name == ours); });
}

/// The value of `version` in a query.
std::string_view stated_version(std::string_view query) {
  constexpr std::string_view kKey = "version=";
  return query.starts_with(kKey) ? query.substr(kKey.size()) : std::string_view();
}

LabAnswer model_answer(const LabWatch& watch) {
  const LabModel& model = watch.model();
  Json files = Json::array();
  for (const LabFile& file : model.files) {
    files.push_back({{"path", file.path}, {"size", file.size}, {"version", file.version}});
  }
  Json json{{"entry", model.entry}, {"files", std::move(files)}, {"version", model.version}};
  if (!watch.problem().empty()) {
    json["error"] = watch.problem();
  }
  LabAnswer answer = begin(200, "application/json");
  answer.headers.emplace_back("Cache-Control", "no-store");
  answer.body = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  return answer;
}

LabAnswer file_answer(const LabRequest& request, const LabWatch& watch, std::string_view path) {
  const LabFile* const file = watch.model().find(path);
  if (file == nullptr) {
    return not_found();
  }
  const bool is_text = file->file.empty();
  const FileState now = is_text ? file->state : state_of(file->file);
  if (!is_text && !now.is_there) {
    return not_found();
  }
  const bool is_current = now == file->state;  // else its content must not be taken for that of the version
  const std::string etag = "\"" + file->version + "\"";
  const bool is_known = is_current && matches(request.if_none_match, etag);
  LabAnswer answer = begin(is_known ? 304 : 200, is_known ? "" : "application/octet-stream");
  answer.headers.emplace_back("Cache-Control", "no-cache");
  if (is_current) {
    answer.headers.emplace_back("ETag", etag);
  }
  if (is_known) {
    return answer;
  }
  if (is_text) {
    answer.body = std::string_view(file->text);
  } else {
    answer.body = FileBody{file->file};
  }
  return answer;
}

LabAnswer events_answer(const LabRequest& request, const LabWatch& watch, std::string_view query) {
  LabAnswer answer = begin(200, "text/event-stream");
  answer.headers.emplace_back("Cache-Control", "no-store");
  EventStream stream{"retry: 1000\n\n"};
  const std::string_view seen = request.last_event_id.empty() ? stated_version(query) : std::string_view(request.last_event_id);
  if (!seen.empty() && seen != watch.stamp()) {
    stream.first += event_of(watch);
  }
  answer.body = std::move(stream);
  return answer;
}

LabAnswer api_answer(const LabRequest& request, const LabSite& site, std::string_view path, std::string_view query) {
  if (!request.fetch_site.empty() && request.fetch_site != "same-origin" && request.fetch_site != "none") {
    return refuse(403, "the model is for the lab's own page");
  }
  const bool is_model = path == "/api/model", is_events = path == "/api/events";
  if (!is_model && !is_events && !path.starts_with(kFiles)) {
    return not_found();
  }
  if (site.watch == nullptr) {
    if (!is_model && !is_events) {
      return not_found();
    }
    LabAnswer none = begin(204, "");
    none.headers.emplace_back("Cache-Control", "no-store");
    return none;
  }
  return is_model    ? model_answer(*site.watch)
         : is_events ? events_answer(request, *site.watch, query)
                     : file_answer(request, *site.watch, path.substr(kFiles.size()));
}

LabAnswer page_answer(const LabRequest& request, const LabPage& page, std::string_view path) {
  const std::string_view name = path == "/" ? std::string_view("index.html") : path.substr(1);
  std::optional<PageFile> file = page.find(name, takes_gzip(request.accept_encoding));
  if (!file) {
    return not_found();
  }
  const bool is_known = matches(request.if_none_match, file->etag);
  LabAnswer answer = begin(is_known ? 304 : 200, is_known ? std::string_view() : content_type_of(name));
  answer.headers.emplace_back("Cache-Control", is_hashed_name(name) ? "public, max-age=31536000, immutable" : "no-cache");
  answer.headers.emplace_back("ETag", file->etag);
  answer.headers.emplace_back("Vary", "Accept-Encoding");
  if (is_known) {
    return answer;
  }
  if (file->is_gzip) {
    answer.headers.emplace_back("Content-Encoding", "gzip");
  }
  if (file->bytes.empty()) {
    answer.body = std::move(file->owned);
  } else {
    answer.body = file->bytes;
  }
  return answer;
}

}  // namespace

LabAnswer not_found() {
  return refuse(404, "there is no such file");
}

std::string_view LabAnswer::header(std::string_view name) const {
  const auto found = std::find_if(headers.begin(), headers.end(), [&](const auto& header) { return header.first == name; });
  return found == headers.end() ? std::string_view() : found->second;
}

LabAnswer answer(const LabRequest& request, const LabSite& site) {
  if (!names_us(request.host, site.port)) {
    return refuse(403, fmt::format("this server is http://127.0.0.1:{}/, and answers to no other name", site.port));
  }
  if (request.method != "GET" && request.method != "HEAD") {
    LabAnswer refused = refuse(405, "only GET and HEAD are answered");
    refused.headers.emplace_back("Allow", "GET, HEAD");
    return refused;
  }
  const std::string_view target = request.target;
  const std::size_t question = std::min(target.find('?'), target.size());
  const std::optional<std::string> path = without_percent(target.substr(0, question));
  if (!path || !path->starts_with('/')) {
    return refuse(400, "the address is broken");
  }
  const std::string_view query = question < target.size() ? target.substr(question + 1) : std::string_view();
  return path->starts_with("/api/") ? api_answer(request, site, *path, query) : page_answer(request, *site.page, *path);
}

std::string event_of(const LabWatch& watch) {
  const Json data = watch.problem().empty() ? Json{{"version", watch.model().version}} : Json{{"error", watch.problem()}};
  return fmt::format("id: {}\ndata: {}\n\n", watch.stamp(), data.dump(-1, ' ', false, Json::error_handler_t::replace));
}

const char* reason_of(int status) {
  switch (status) {
    case 200:
      return "OK";
    case 204:
      return "No Content";
    case 304:
      return "Not Modified";
    case 400:
      return "Bad Request";
    case 403:
      return "Forbidden";
    case 404:
      return "Not Found";
    case 405:
      return "Method Not Allowed";
    default:
      return "Internal Server Error";
  }
}

}  // namespace lustro::app
