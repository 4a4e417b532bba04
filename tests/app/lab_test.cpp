// `lustro lab` as a browser sees it: the program is started, asked through a socket, and ended.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <csignal>

#include "app/lab_page.hpp"
#include "app/run_command.hpp"
#include "app/scenes.hpp"

namespace {

using namespace lustro::testing;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::MatchesRegex;
using ::testing::Not;
using ::testing::StartsWith;

namespace fs = std::filesystem;

/// A connection to a port of this machine. Whoever waits longer than ten seconds waits for nothing.
class Connection {
 public:
  explicit Connection(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    const timeval patience{10, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    is_open_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() { ::close(socket_); }

  [[nodiscard]] bool is_open() const { return is_open_; }
  void send(const std::string& text) const {
    ASSERT_EQ(::send(socket_, text.data(), text.size(), MSG_NOSIGNAL), static_cast<ssize_t>(text.size()));
  }
  /// Reads on until the text holds the words, or, without words, until the other side closes.
  std::string read_until(const std::string& words = {}) {
    char buffer[65536];
    while (words.empty() || text_.find(words) == std::string::npos) {
      const ssize_t got = ::recv(socket_, buffer, sizeof(buffer), 0);
      if (got <= 0) {
        EXPECT_TRUE(words.empty() && got == 0) << "after: " << text_;
        break;
      }
      text_.append(buffer, static_cast<std::size_t>(got));
    }
    return std::exchange(text_, {});
  }

 private:
  int socket_;
  bool is_open_ = false;
  std::string text_;
};

struct Response {
  int status = 0;
  std::string head;
  std::string body;
};

class Lab : public CommandTest {
 protected:
  void SetUp() override {
    if (run_program({LUSTRO_LAB_COMMAND, "lab", "none.obj"}).err.find("without libevent") != std::string::npos) {
      GTEST_SKIP() << "this build cannot serve";
    }
  }
  void TearDown() override { EXPECT_THAT(end(SIGKILL), AnyOf(-1, 128 + SIGKILL)); }

  /// Starts `lustro lab WORDS...` with a page inside, and waits until it says where it is.
  std::string start(std::vector<std::string> words, std::vector<std::string> environment = {}) {
    words.insert(words.begin(), {LUSTRO_LAB_COMMAND, "lab"});
    environment.insert(environment.begin(), {"env", "-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", "-u", "BROWSER"});
    words.insert(words.begin(), environment.begin(), environment.end());
    int ends[2];
    EXPECT_EQ(::pipe2(ends, O_CLOEXEC), 0);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, (folder / "stderr").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::posix_spawn_file_actions_addchdir_np(&actions, work().c_str());
    std::vector<char*> argv;
    for (std::string& word : words) {
      argv.push_back(word.data());
    }
    argv.push_back(nullptr);
    EXPECT_EQ(::posix_spawnp(&process_, argv[0], &actions, nullptr, argv.data(), environ), 0);
    ::posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    std::string line;
    for (char c = 0; ::read(ends[0], &c, 1) == 1;) {
      line += c;
      if (c == '\n') {
        break;
      }
    }
    ::close(ends[0]);
    const std::size_t colon = line.rfind("127.0.0.1:");
    port_ = colon == std::string::npos ? 0 : std::stoi(line.substr(colon + std::string("127.0.0.1:").size()));
    EXPECT_NE(port_, 0) << line << file_text(folder / "stderr");
    return line;
  }
  /// The exit code after a signal; -1 where there is no process.
  int end(int signal) {
    if (process_ <= 0) {
      return -1;
    }
    ::kill(process_, signal);
    int status = 0;
    ::waitpid(std::exchange(process_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  Response ask(const std::string& request_line, const std::string& headers = {}) {
    Connection connection(port_);
    connection.send(request_line + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\nConnection: close\r\n" + headers + "\r\n");
    const std::string all = connection.read_until();
    const std::size_t blank = all.find("\r\n\r\n");
    if (!all.starts_with("HTTP/1.1 ") || blank == std::string::npos) {
      ADD_FAILURE() << "no answer: " << all;
      return {};
    }
    return {std::stoi(all.substr(9)), all.substr(0, blank + 2), all.substr(blank + 4)};
  }

  pid_t process_ = 0;
  int port_ = 0;
};

TEST_F(Lab, ServesThePageThatIsInsideTheProgram) {
  EXPECT_THAT(start({"--port", "0", "--no-open"}), MatchesRegex("lustro lab: http://127\\.0\\.0\\.1:[0-9]+/\n"));
  const Response index = ask("GET /");
  const std::string original = file_text(fs::path(LUSTRO_SOURCE_DIR) / "tests/app/lab_page/index.html");
  EXPECT_EQ(index.status, 200);
  EXPECT_EQ(index.body, original);
  EXPECT_THAT(index.head, HasSubstr("\r\nContent-Length: " + std::to_string(original.size()) + "\r\n"));
  EXPECT_THAT(index.head, HasSubstr("\r\nContent-Type: text/html; charset=utf-8\r\n"));
  EXPECT_THAT(index.head, HasSubstr("\r\nCross-Origin-Opener-Policy: same-origin\r\n"));
  EXPECT_THAT(index.head, HasSubstr("\r\nCross-Origin-Embedder-Policy: require-corp\r\n"));
  EXPECT_THAT(index.head, HasSubstr("\r\nContent-Security-Policy: default-src 'self';"));
  const Response packed = ask("GET /", "Accept-Encoding: gzip, deflate, br\r\n");
  EXPECT_THAT(packed.head, HasSubstr("\r\nContent-Encoding: gzip\r\n"));
  EXPECT_EQ(lustro::app::gunzip(packed.body, original.size()), original);
  const Response head = ask("HEAD /");
  EXPECT_EQ(head.status, 200);
  EXPECT_THAT(head.head, HasSubstr("\r\nContent-Length: " + std::to_string(original.size()) + "\r\n"));
  EXPECT_THAT(head.body, IsEmpty());
  const std::size_t tag = index.head.find("ETag: ");
  const Response known = ask("GET /", "If-None-Match: " + index.head.substr(tag + 6, index.head.find("\r\n", tag) - tag - 6) + "\r\n");
  EXPECT_EQ(known.status, 304);
  EXPECT_THAT(known.body, IsEmpty());
  EXPECT_EQ(ask("GET /api/model").status, 204);
  EXPECT_EQ(ask("GET /missing").status, 404);
  EXPECT_EQ(ask("POST /").status, 405);
  EXPECT_EQ(end(SIGTERM), 0);
  EXPECT_THAT(file_text(folder / "stderr"), IsEmpty());
}

TEST_F(Lab, ServesAFolderWhileItIsWorkedOn) {
  fs::create_directories(work() / "page");
  write_text(work() / "page/index.html", "one");
  start({"--page", "page", "--port", "0"});
  EXPECT_EQ(ask("GET /").body, "one");
  write_text(work() / "page/index.html", "two");
  EXPECT_EQ(ask("GET /").body, "two");
}

TEST_F(Lab, ServesTheModelAndNothingElseOfItsFolder) {
  write_text(work() / "a b.obj", square_obj());
  write_text(work() / "secret.obj", square_obj());
  start({"a b.obj", "--port", "0"});
  const auto json = nlohmann::json::parse(ask("GET /api/model").body);
  EXPECT_EQ(json["entry"], "a b.obj");
  EXPECT_EQ(json["files"].size(), 1U);
  const Response file = ask("GET /api/files/a%20b.obj");
  EXPECT_EQ(file.body, square_obj());
  EXPECT_THAT(file.head, HasSubstr("\r\nContent-Type: application/octet-stream\r\n"));
  const Response head = ask("HEAD /api/files/a%20b.obj");
  EXPECT_THAT(head.head, HasSubstr("\r\nContent-Length: " + std::to_string(square_obj().size()) + "\r\n"));
  EXPECT_THAT(head.body, IsEmpty());
  for (const char* const target : {"/api/files/secret.obj", "/api/files/../../etc/passwd", "/api/files/%2e%2e/%2e%2e/etc/passwd",
                                   "/api/files/..%2F..%2Fetc%2Fpasswd", "/api/files//etc/passwd", "/../../../../etc/passwd"}) {
    EXPECT_EQ(ask(std::string("GET ") + target).status, 404) << target;
  }
}

TEST_F(Lab, SendsAFileOfManyPieces) {
  std::string big = square_obj();
  while (big.size() < 3'000'000) {
    big += "# one more line that says nothing, " + std::to_string(big.size()) + "\n";
  }
  write_text(work() / "big.obj", big);
  start({"big.obj", "--port", "0"});
  EXPECT_EQ(ask("GET /api/files/big.obj").body, big);
  // On one connection, one after the other.
  Connection connection(port_);
  for (int i = 0; i < 3; ++i) {
    connection.send("GET /api/files/big.obj HTTP/1.1\r\nHost: localhost:" + std::to_string(port_) + "\r\n\r\n");
    EXPECT_THAT(connection.read_until(big.substr(big.size() - 60)), HasSubstr("\r\n\r\n" + big.substr(0, 1000)));
  }
}

TEST_F(Lab, AFileThatShrinksOrAReaderThatLeavesEndsOneConnection) {
  std::string big = square_obj();
  big.append(24'000'000, '#');
  big += "\n";
  write_text(work() / "big.obj", big);
  start({"big.obj", "--port", "0"});
  const std::string request = "GET /api/files/big.obj HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n\r\n";
  {
    Connection leaving(port_);
    leaving.send(request);
    leaving.read_until("\r\n\r\n");
  }
  Connection staying(port_);
  staying.send(request);
  const std::string begin = staying.read_until("\r\n\r\n");
  EXPECT_THAT(begin, HasSubstr("\r\nContent-Length: " + std::to_string(big.size()) + "\r\n"));
  fs::resize_file(work() / "big.obj", 1000);
  EXPECT_LT(begin.size() + staying.read_until().size(), big.size());  // and it ends
  EXPECT_EQ(ask("GET /").status, 200);
  EXPECT_EQ(end(SIGTERM), 0);
}

TEST_F(Lab, RefusesWhoDoesNotNameItAndWhoSaysTooMuch) {
  write_text(work() / "a.obj", square_obj());
  start({"a.obj", "--port", "0"});
  for (const std::string& host : {std::string("evil.example:") + std::to_string(port_), std::string("127.0.0.1"), std::string("127.0.0.1:1")}) {
    Connection connection(port_);
    connection.send("GET /api/model HTTP/1.1\r\nHost: " + host + "\r\nConnection: close\r\n\r\n");
    EXPECT_THAT(connection.read_until(), StartsWith("HTTP/1.1 403 "));
  }
  EXPECT_EQ(ask("GET /api/model", "Sec-Fetch-Site: cross-site\r\n").status, 403);
  EXPECT_EQ(ask("GET /api/model", "Sec-Fetch-Site: same-origin\r\n").status, 200);
  EXPECT_EQ(ask("GET /api/model", "X: " + std::string(20000, 'x') + "\r\n").status, 400);
  EXPECT_EQ(ask("GET /" + std::string(20000, 'x')).status, 400);
  EXPECT_EQ(ask("POST /", "Content-Length: 100000\r\n").status, 413);
  {
    Connection connection(port_);
    connection.send("no HTTP at all\r\n\r\n");
    EXPECT_THAT(connection.read_until(), Not(HasSubstr(" 200 ")));
  }
  EXPECT_EQ(ask("GET /").status, 200);  // it is still there
}

TEST_F(Lab, TellsWhenAFileChanges) {
  write_text(work() / "a.obj", "mtllib a.mtl\n" + square_obj());
  write_text(work() / "a.mtl", "newmtl m\n");
  start({"a.obj", "--port", "0"});
  const std::string version = nlohmann::json::parse(ask("GET /api/model").body)["version"];
  Connection events(port_);
  events.send("GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\n\r\n");
  EXPECT_THAT(events.read_until("retry: 1000\n\n"), HasSubstr("\r\nContent-Type: text/event-stream\r\n"));
  fs::last_write_time(work() / "a.mtl", fs::last_write_time(work() / "a.mtl") + std::chrono::hours(1));
  const std::string changed = events.read_until("\"}\n\n");
  const std::string next = nlohmann::json::parse(ask("GET /api/model").body)["version"];
  EXPECT_NE(next, version);
  EXPECT_THAT(changed, HasSubstr("data: {\"version\":\"" + next + "\"}\n\n"));
  write_text(work() / "a.obj", "f 1 2 3\n");
  EXPECT_THAT(events.read_until("\"}\n\n"), HasSubstr("data: {\"error\":\"a.obj:1: "));
  fs::remove(work() / "a.obj");
  EXPECT_THAT(events.read_until("\"}\n\n"), HasSubstr("data: {\"error\":\"a.obj: cannot be opened"));
  write_text(work() / "a.obj", square_obj());
  EXPECT_THAT(events.read_until("\"}\n\n"), HasSubstr("data: {\"version\":\""));
  Connection late(port_);  // one that has missed something is told at once
  late.send("GET /api/events HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port_) + "\r\nLast-Event-ID: " + version + "\r\n\r\n");
  EXPECT_THAT(late.read_until("\"}\n\n"), HasSubstr("data: {\"version\":\""));
  EXPECT_EQ(end(SIGINT), 0);  // while two listen
}

TEST_F(Lab, APortThatIsTakenIsAnErrorOnlyWhereItIsStated) {
  start({"--port", "0"});
  const Outcome taken = run_program({LUSTRO_LAB_COMMAND, "lab", "--no-open", "--port", std::to_string(port_)});
  EXPECT_EQ(taken.code, 3);
  EXPECT_THAT(taken.err, HasSubstr("--port: port " + std::to_string(port_) + " cannot be had: another program has it"));
  EXPECT_THAT(taken.out, IsEmpty());
  const int first = port_;
  ASSERT_EQ(end(SIGTERM), 0);
  start({"--port", std::to_string(first)});  // and it is free at once when it is given back
  EXPECT_EQ(port_, first);
  EXPECT_EQ(end(SIGHUP), 0);
}

TEST_F(Lab, WithoutAPortTakesTheFirstThatIsFree) {
  const int taken = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);  // by us, unless somebody else has it
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(8000);
  static_cast<void>(::bind(taken, reinterpret_cast<const sockaddr*>(&address), sizeof(address)));
  static_cast<void>(::listen(taken, 1));
  start({});
  EXPECT_GT(port_, 8000);
  EXPECT_LT(port_, 8100);
  ::close(taken);
}

TEST_F(Lab, AsJsonSaysWhereItIsInOneLine) {
  write_text(work() / "a.obj", square_obj());
  const auto line = nlohmann::json::parse(start({"a.obj", "--port", "0", "--json"}));
  EXPECT_EQ(line["url"], "http://127.0.0.1:" + std::to_string(port_) + "/");
  EXPECT_EQ(line["port"], port_);
  EXPECT_EQ(line["entry"], "a.obj");
}

TEST_F(Lab, OpensTheBrowserWhereThereIsADisplay) {
  write_text(work() / "browser", "#!/bin/sh\nprintf '%s' \"$1\" > opened.tmp && mv opened.tmp opened\necho x > fifo\n");
  fs::permissions(work() / "browser", fs::perms::owner_all);
  ASSERT_EQ(::mkfifo((work() / "fifo").c_str(), 0600), 0);
  start({"--port", "0"}, {"DISPLAY=:99", "BROWSER=./browser"});
  EXPECT_EQ(file_text(work() / "fifo"), "x\n");  // waits for the browser
  EXPECT_EQ(file_text(work() / "opened"), "http://127.0.0.1:" + std::to_string(port_) + "/");
  EXPECT_EQ(ask("GET /").status, 200);
  EXPECT_EQ(end(SIGTERM), 0);
}

TEST_F(Lab, OpensNoneWithoutADisplayOrWhereItMayNot) {
  write_text(work() / "browser", "#!/bin/sh\ntouch opened\n");
  fs::permissions(work() / "browser", fs::perms::owner_all);
  start({"--port", "0"}, {"BROWSER=./browser"});
  EXPECT_EQ(end(SIGTERM), 0);
  start({"--port", "0", "--no-open"}, {"DISPLAY=:99", "BROWSER=./browser"});
  EXPECT_EQ(end(SIGTERM), 0);
  EXPECT_FALSE(fs::exists(work() / "opened"));
  start({"--port", "0"}, {"DISPLAY=:99", "BROWSER=/nowhere/browser"});  // no reason to fail
  EXPECT_EQ(ask("GET /").status, 200);
  EXPECT_EQ(end(SIGTERM), 0);
}

TEST_F(Lab, AWrongLineIsRefusedAtTheStart) {
  write_text(work() / "broken.obj", "f 1 2 3\n");
  const auto refused = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {LUSTRO_LAB_COMMAND, "lab", "--no-open"});
    return run_program(words);
  };
  const Outcome missing = refused({"none.obj"});
  EXPECT_EQ(missing.code, 3);
  EXPECT_THAT(missing.err, HasSubstr("error: none.obj: cannot be opened"));
  const Outcome broken = refused({"broken.obj"});
  EXPECT_EQ(broken.code, 4);
  EXPECT_EQ(broken.err, lustro({"render", "broken.obj", "-o", "out.png"}).err);
  EXPECT_EQ(refused({"--port", "65536"}).code, 2);
  EXPECT_EQ(refused({"--port", "-1"}).code, 2);
  EXPECT_EQ(refused({"--port", "many"}).code, 2);
  const Outcome no_page = refused({"--page", "nowhere"});
  EXPECT_EQ(no_page.code, 3);
  EXPECT_THAT(no_page.err, HasSubstr("nowhere: holds no index.html"));
}

}  // namespace
