// One loop of events: connections, signals and two timers. See lab_server.hpp.
#include "lab_server.hpp"

#ifdef LUSTRO_HAS_EVENT
#include <arpa/inet.h>
#include <event2/buffer.h>
#include <event2/event.h>
#include <event2/http.h>
#include <event2/keyvalq_struct.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <list>
#include <memory>
#include <utility>
#include <vector>

#include "io/read_file.hpp"
#include "lab_answer.hpp"

namespace lustro::app {
namespace {

constexpr int kFirstPort = 8000, kLastPort = 8099;  // where none is stated
constexpr timeval kLook{0, 300'000};
constexpr timeval kKeepAlive{15, 0};
constexpr int kPatienceSeconds = 60;          // with a connection on which nothing comes
constexpr int kLongPatienceSeconds = 604800;  // with one on which we send
constexpr std::size_t kMostHeaders = 16384, kMostBody = 1024, kPiece = std::size_t{1} << 18U;

template <auto free>
struct Free {
  template <class T>
  void operator()(T* thing) const {
    free(thing);
  }
};
using Base = std::unique_ptr<event_base, Free<event_base_free>>;
using Event = std::unique_ptr<event, Free<event_free>>;
using Buffer = std::unique_ptr<evbuffer, Free<evbuffer_free>>;
using Http = std::unique_ptr<evhttp, Free<evhttp_free>>;

/// A socket that listens on loopback, or the number of the error.
struct Listener {
  int socket = -1;
  int port = 0;
  int error = 0;
};

Listener listen_on(int port) {
  Listener listener;
  const auto give_up = [&] {
    listener.error = errno;
    if (listener.socket >= 0) {
      ::close(listener.socket);
      listener.socket = -1;
    }
    return listener;
  };
  listener.socket = ::socket(AF_INET, SOCK_STREAM, 0);
  if (listener.socket < 0 || evutil_make_socket_nonblocking(listener.socket) != 0 || evutil_make_socket_closeonexec(listener.socket) != 0) {
    return give_up();
  }
  const int yes = 1;  // what an earlier server's connections have left behind does not keep the port
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  socklen_t size = sizeof(address);
  if (::setsockopt(listener.socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof(yes)) != 0 ||
      ::bind(listener.socket, reinterpret_cast<const sockaddr*>(&address), size) != 0 || ::listen(listener.socket, SOMAXCONN) != 0 ||
      ::getsockname(listener.socket, reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    return give_up();
  }
  listener.port = ntohs(address.sin_port);
  return listener;
}

Result<Listener> find_port(std::optional<int> port) {
  Listener listener = listen_on(port.value_or(kFirstPort));
  for (int next = kFirstPort + 1; !port && listener.error == EADDRINUSE && next <= kLastPort; ++next) {
    listener = listen_on(next);
  }
  if (listener.error == 0) {
    return listener;
  }
  const std::string problem = listener.error == EADDRINUSE ? "another program has it" : std::strerror(listener.error);
  return port ? fail(ErrorKind::io, "--port", fmt::format("port {} cannot be had: {}", *port, problem))
              : fail(ErrorKind::io, "lab", fmt::format("none of the ports {} to {} can be had: {}", kFirstPort, kLastPort, problem));
}

std::string header_of(evhttp_request* request, const char* name) {
  const char* const value = evhttp_find_header(evhttp_request_get_input_headers(request), name);
  return value == nullptr ? std::string() : value;
}

const char* method_of(evhttp_request* request) {
  switch (evhttp_request_get_command(request)) {
    case EVHTTP_REQ_GET:
      return "GET";
    case EVHTTP_REQ_HEAD:
      return "HEAD";
    default:
      return "";  // none that is answered
  }
}

class Server {
 public:
  Server(const LabPage& page, LabWatch* watch) : watch_(watch), site_{&page, watch, 0} {}

  Result<void> run(std::optional<int> port, const std::function<Result<void>(int)>& started) {
    base_.reset(event_base_new());
    http_.reset(base_ == nullptr ? nullptr : evhttp_new(base_.get()));
    if (http_ == nullptr) {
      return fail(ErrorKind::limit, "lab", "the system grants no events");
    }
    evhttp_set_gencb(http_.get(), &Server::on_request, this);
    evhttp_set_allowed_methods(http_.get(), 0xFFFF);  // those that are not answered are refused in our words
    evhttp_set_max_headers_size(http_.get(), kMostHeaders);
    evhttp_set_max_body_size(http_.get(), kMostBody);
    evhttp_set_timeout(http_.get(), kPatienceSeconds);
    const Result<Listener> listener = find_port(port);
    if (!listener) {
      return tl::unexpected(listener.error());
    }
    if (evhttp_accept_socket(http_.get(), listener->socket) != 0) {
      ::close(listener->socket);
      return fail(ErrorKind::io, "lab", "the system takes no connections");
    }
    site_.port = listener->port;
    std::vector<Event> events;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      events.push_back(signal_event(number));
    }
    if (watch_ != nullptr) {
      events.push_back(timer(kLook, &Server::on_look));
      events.push_back(timer(kKeepAlive, &Server::on_keep_alive));
    }
    if (const Result<void> done = started(listener->port); !done) {
      return done;
    }
    ::signal(SIGPIPE, SIG_IGN);  // a page that is closed while it is sent something
    event_base_dispatch(base_.get());
    http_.reset();  // before what its connections refer to
    return {};
  }

 private:
  /// An answer that takes longer than its request: a file that is being sent, or a stream of events.
  struct Ongoing {
    Server* server = nullptr;
    evhttp_request* request = nullptr;
    std::optional<ByteSource> file;  // nothing: events
    std::size_t sent = 0;
    std::list<Ongoing>::iterator place;
  };

  Event signal_event(int number) {
    Event made(evsignal_new(base_.get(), number, &Server::on_signal, this));
    evsignal_add(made.get(), nullptr);
    return made;
  }
  Event timer(const timeval& interval, event_callback_fn call) {
    Event made(event_new(base_.get(), -1, EV_PERSIST, call, this));
    event_add(made.get(), &interval);
    return made;
  }

  static void on_signal(evutil_socket_t, short, void* self) { event_base_loopbreak(static_cast<Server*>(self)->base_.get()); }
  static void on_look(evutil_socket_t, short, void* self) {
    Server& server = *static_cast<Server*>(self);
    if (server.watch_->look()) {
      server.tell(event_of(*server.watch_));
    }
  }
  static void on_keep_alive(evutil_socket_t, short, void* self) { static_cast<Server*>(self)->tell(":\n\n"); }
  static void on_request(evhttp_request* request, void* self) { static_cast<Server*>(self)->take(request); }

  /// Sends every stream of events a text.
  void tell(const std::string& text) {
    for (Ongoing& stream : ongoing_) {
      if (!stream.file) {
        send_piece(stream, text, nullptr);
      }
    }
  }

  static void send_piece(Ongoing& ongoing, std::string_view text, void (*then)(evhttp_connection*, void*)) {
    const Buffer buffer(evbuffer_new());
    evbuffer_add(buffer.get(), text.data(), text.size());
    evhttp_send_reply_chunk_with_cb(ongoing.request, buffer.get(), then, &ongoing);
  }

  void take(evhttp_request* request) {
    const LabRequest asked{.method = method_of(request),
                           .target = evhttp_request_get_uri(request),
                           .host = header_of(request, "Host"),
                           .accept_encoding = header_of(request, "Accept-Encoding"),
                           .if_none_match = header_of(request, "If-None-Match"),
                           .fetch_site = header_of(request, "Sec-Fetch-Site"),
                           .last_event_id = header_of(request, "Last-Event-ID")};
    LabAnswer answered = answer(asked, site_);
    const bool is_head = asked.method == "HEAD";
    if (const FileBody* const body = std::get_if<FileBody>(&answered.body)) {
      Result<ByteSource> file = ByteSource::open(body->file);
      if (file) {
        put_headers(request, answered, file->size());
        return is_head || file->size() == 0 ? send_whole(request, answered.status, {}) : send_file(request, answered.status, *std::move(file));
      }
      answered = not_found();
    }
    if (const EventStream* const stream = std::get_if<EventStream>(&answered.body)) {
      put_headers(request, answered, std::nullopt);
      return is_head ? send_whole(request, answered.status, {}) : send_events(request, answered.status, stream->first);
    }
    const std::string* const text = std::get_if<std::string>(&answered.body);
    const std::string_view content = text != nullptr ? std::string_view(*text) : std::get<std::string_view>(answered.body);
    const bool has_content = answered.status != 204 && answered.status != 304;
    put_headers(request, answered, has_content ? std::optional(content.size()) : std::nullopt);
    send_whole(request, answered.status, is_head ? std::string_view() : content);
  }

  static void put_headers(evhttp_request* request, const LabAnswer& answered, std::optional<std::size_t> size) {
    evkeyvalq* const headers = evhttp_request_get_output_headers(request);
    for (const auto& [name, value] : answered.headers) {
      evhttp_add_header(headers, name.c_str(), value.c_str());
    }
    if (size) {
      evhttp_add_header(headers, "Content-Length", std::to_string(*size).c_str());
    }
  }

  static void send_whole(evhttp_request* request, int status, std::string_view content) {
    const Buffer buffer(evbuffer_new());
    evbuffer_add(buffer.get(), content.data(), content.size());
    evhttp_send_reply(request, status, reason_of(status), buffer.get());
  }

  /// The connection's end ends the answer, too.
  Ongoing& keep(evhttp_request* request) {
    ongoing_.push_back({.server = this, .request = request, .file = std::nullopt, .sent = 0, .place = {}});
    Ongoing& ongoing = ongoing_.back();
    ongoing.place = std::prev(ongoing_.end());
    evhttp_connection* const connection = evhttp_request_get_connection(request);
    evhttp_connection_set_timeout(connection, kLongPatienceSeconds);  // the same for both directions, and nothing comes from there
    evhttp_connection_set_closecb(connection, &Server::on_close, &ongoing);
    return ongoing;
  }
  static void on_close(evhttp_connection*, void* argument) {
    Ongoing& ongoing = *static_cast<Ongoing*>(argument);
    evhttp_request* const request = ongoing.request;
    forget(ongoing);
    if (evhttp_request_get_connection(request) == nullptr) {  // the other side left, and libevent has left the request to us: this frees it
      evhttp_send_reply_end(request);
    }
  }
  static void forget(Ongoing& ongoing) { ongoing.server->ongoing_.erase(ongoing.place); }

  void send_events(evhttp_request* request, int status, const std::string& first) {
    Ongoing& stream = keep(request);
    evhttp_send_reply_start(request, status, reason_of(status));
    send_piece(stream, first, nullptr);
  }

  void send_file(evhttp_request* request, int status, ByteSource file) {
    Ongoing& sending = keep(request);
    sending.file.emplace(std::move(file));
    evhttp_send_reply_start(request, status, reason_of(status));
    send_more(nullptr, &sending);
  }

  /// The next piece of the file, whenever the one before is on its way.
  static void send_more(evhttp_connection*, void* argument) {
    Ongoing& sending = *static_cast<Ongoing*>(argument);
    const std::size_t count = std::min(kPiece, sending.file->size() - sending.sent);
    std::vector<char> room(count);
    const std::string_view piece = sending.file->read(sending.sent, count, room.data());
    sending.sent += piece.size();
    if (!piece.empty()) {
      return send_piece(sending, piece, &Server::send_more);
    }
    evhttp_request* const request = sending.request;
    if (sending.sent < sending.file->size()) {  // it became shorter: the connection ends early, so that nobody takes this for the whole file
      evhttp_add_header(evhttp_request_get_output_headers(request), "Connection", "close");
    }
    evhttp_connection* const connection = evhttp_request_get_connection(request);
    evhttp_connection_set_closecb(connection, nullptr, nullptr);
    evhttp_connection_set_timeout(connection, kPatienceSeconds);
    forget(sending);
    evhttp_send_reply_end(request);
  }

  LabWatch* watch_;
  LabSite site_;
  std::list<Ongoing> ongoing_;
  Base base_;
  Http http_;  // ends before what it refers to
};

}  // namespace

Result<void> check_server() {
  return {};
}

Result<void> serve_lab(const LabPage& page, LabWatch* watch, std::optional<int> port, const std::function<Result<void>(int port)>& started) {
  return Server(page, watch).run(port, started);
}

}  // namespace lustro::app

#else

namespace lustro::app {

Result<void> check_server() {
  return fail(ErrorKind::unsupported, "lab", "this build of Lustro cannot serve: it is without libevent (Debian: libevent-dev)");
}

Result<void> serve_lab(const LabPage&, LabWatch*, std::optional<int>, const std::function<Result<void>(int port)>&) {
  return check_server();
}

}  // namespace lustro::app

#endif
