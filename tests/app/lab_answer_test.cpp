// What the lab's server answers: its headers, whom it answers at all, and what it never gives away.
#include "app/lab_answer.hpp"

#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"

namespace {

using namespace lustro::app;
using namespace lustro::testing;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr int kPort = 8123;

class LabAnswers : public CommandTest {
 protected:
  void SetUp() override {
    write_text(work() / "a b.obj", square_obj());
    write_text(work() / "secret.txt", "secret");
    auto begun = LabWatch::begin((work() / "a b.obj").string(), {});
    ASSERT_TRUE(begun) << begun.error().text();
    watch_.emplace(*std::move(begun));
  }
  LabAnswer ask(LabRequest request, bool with_model = true) const {
    if (request.host.empty()) {
      request.host = "127.0.0.1:8123";
    }
    return answer(request, {&page_, with_model ? &*watch_ : nullptr, kPort});
  }
  LabAnswer get(const std::string& target) const { return ask({.target = target}); }
  static std::string text_of(const LabAnswer& answered) {
    const auto* const text = std::get_if<std::string>(&answered.body);
    return text != nullptr ? *text : std::string(std::get<std::string_view>(answered.body));
  }

  LabPage page_{embedded_page()};
  std::optional<LabWatch> watch_;
};

TEST_F(LabAnswers, EveryAnswerIsolatesThePageAndForbidsOtherHosts) {
  for (const char* const target : {"/", "/api/model", "/api/events", "/api/files/a%20b.obj", "/nothing", "/%", "/api/nothing"}) {
    for (const char* const method : {"GET", "HEAD", "POST"}) {
      const LabAnswer answered = ask({.method = method, .target = target});
      EXPECT_EQ(answered.header("Cross-Origin-Opener-Policy"), "same-origin");
      EXPECT_EQ(answered.header("Cross-Origin-Embedder-Policy"), "require-corp");
      EXPECT_EQ(answered.header("Cross-Origin-Resource-Policy"), "same-origin");
      EXPECT_EQ(answered.header("X-Content-Type-Options"), "nosniff");
      EXPECT_EQ(answered.header("Referrer-Policy"), "no-referrer");
      EXPECT_THAT(
          std::string(answered.header("Content-Security-Policy")),
          AllOf(HasSubstr("default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self' blob:; style-src 'self' 'unsafe-inline'; "
                          "img-src 'self' blob: data:; connect-src 'self'; "),
                HasSubstr("frame-ancestors 'none'"), Not(HasSubstr("http")), Not(HasSubstr("*"))));
    }
  }
}

TEST_F(LabAnswers, ThePageIsPackedForWhoTakesIt) {
  const LabAnswer packed = ask({.target = "/", .accept_encoding = "br, gzip;q=0.5"});
  EXPECT_EQ(packed.status, 200);
  EXPECT_EQ(packed.header("Content-Encoding"), "gzip");
  EXPECT_EQ(packed.header("Content-Type"), "text/html; charset=utf-8");
  EXPECT_EQ(packed.header("Vary"), "Accept-Encoding");
  const std::string original = file_text(std::filesystem::path(LUSTRO_SOURCE_DIR) / "tests/app/lab_page/index.html");
  EXPECT_EQ(gunzip(text_of(packed), original.size()), original);
  for (const char* const encodings : {"", "identity", "gzip;q=0", "gzip; q=0.000, br", "x-gzip"}) {
    const LabAnswer plain = ask({.target = "/index.html", .accept_encoding = encodings});
    EXPECT_EQ(plain.header("Content-Encoding"), "") << encodings;
    EXPECT_EQ(text_of(plain), original);
    EXPECT_EQ(plain.header("Vary"), "Accept-Encoding");
  }
  EXPECT_EQ(ask({.target = "/assets/font-Q1w2E3r4.woff2", .accept_encoding = "gzip"}).header("Content-Encoding"), "");
}

TEST_F(LabAnswers, HashedNamesAreKeptForeverAndTheRestIsAskedForAgain) {
  const LabAnswer script = get("/assets/index-Bx3kq9Zc.js");
  EXPECT_EQ(script.header("Cache-Control"), "public, max-age=31536000, immutable");
  EXPECT_EQ(script.header("Content-Type"), "text/javascript; charset=utf-8");
  const LabAnswer index = get("/");
  EXPECT_EQ(index.header("Cache-Control"), "no-cache");
  const std::string etag(index.header("ETag"));
  ASSERT_GT(etag.size(), 10U);
  for (const std::string& known : {etag, "W/" + etag, "\"other\", " + etag, std::string("*")}) {
    const LabAnswer again = ask({.target = "/", .if_none_match = known});
    EXPECT_EQ(again.status, 304) << known;
    EXPECT_EQ(again.header("ETag"), etag);
    EXPECT_EQ(text_of(again), "");
  }
  EXPECT_EQ(ask({.target = "/", .if_none_match = "\"other\""}).status, 200);
  EXPECT_EQ(get("/engine/lustro.wasm").header("Content-Type"), "application/wasm");
  EXPECT_EQ(get("/engine/lustro.wasm").header("Cache-Control"), "no-cache");
}

TEST_F(LabAnswers, OnlyWhoNamesThisServerIsAnswered) {
  for (const char* const host : {"127.0.0.1:8123", "localhost:8123", "LocalHost:8123", "[::1]:8123"}) {
    EXPECT_EQ(ask({.host = host}).status, 200) << host;
  }
  for (const char* const host :
       {"evil.example:8123", "127.0.0.1", "127.0.0.1:8124", "localhost", "127.0.0.1:8123.evil.example", "evil.example", "127.0.0.2:8123", " "}) {
    const LabAnswer refused = ask({.host = host});
    EXPECT_EQ(refused.status, 403) << host;
    EXPECT_THAT(text_of(refused), HasSubstr("http://127.0.0.1:8123/"));
  }
  EXPECT_EQ(answer({}, {&page_, nullptr, kPort}).status, 403);  // no host at all
  EXPECT_EQ(answer({.host = "localhost"}, {&page_, nullptr, 80}).status, 200);
}

TEST_F(LabAnswers, TheModelIsForOurOwnPage) {
  for (const char* const target : {"/api/model", "/api/files/a%20b.obj", "/api/events"}) {
    for (const char* const site : {"cross-site", "same-site"}) {
      EXPECT_EQ(ask({.target = target, .fetch_site = site}).status, 403) << target;
    }
    for (const char* const site : {"same-origin", "none", ""}) {
      EXPECT_EQ(ask({.target = target, .fetch_site = site}).status, 200) << target;
    }
  }
  EXPECT_EQ(ask({.target = "/", .fetch_site = "cross-site"}).status, 200);  // a link leads here
}

TEST_F(LabAnswers, NothingIsChangedByARequest) {
  for (const char* const method : {"POST", "PUT", "DELETE", "OPTIONS", ""}) {
    const LabAnswer refused = ask({.method = method});
    EXPECT_EQ(refused.status, 405);
    EXPECT_EQ(refused.header("Allow"), "GET, HEAD");
  }
}

TEST_F(LabAnswers, TheModelIsListed) {
  const LabAnswer model = get("/api/model");
  EXPECT_EQ(model.status, 200);
  EXPECT_EQ(model.header("Content-Type"), "application/json");
  EXPECT_EQ(model.header("Cache-Control"), "no-store");
  const auto json = nlohmann::json::parse(text_of(model));
  EXPECT_EQ(json["entry"], "a b.obj");
  ASSERT_EQ(json["files"].size(), 1U);
  EXPECT_EQ(json["files"][0]["path"], "a b.obj");
  EXPECT_EQ(json["files"][0]["size"], square_obj().size());
  EXPECT_EQ(json["files"][0]["version"], watch_->model().files[0].version);
  EXPECT_EQ(json["version"], watch_->model().version);
  EXPECT_FALSE(json.contains("error"));
}

TEST_F(LabAnswers, WithoutAModelThereIsNothingToList) {
  EXPECT_EQ(ask({.target = "/api/model"}, false).status, 204);
  EXPECT_EQ(ask({.target = "/api/events"}, false).status, 204);
  EXPECT_EQ(ask({.target = "/api/files/a%20b.obj"}, false).status, 404);
  EXPECT_EQ(ask({.target = "/"}, false).status, 200);
}

TEST_F(LabAnswers, AFileOfTheModelIsSentAsBytes) {
  const LabAnswer file = get("/api/files/a%20b.obj");
  EXPECT_EQ(file.status, 200);
  EXPECT_EQ(file.header("Content-Type"), "application/octet-stream");
  EXPECT_EQ(file.header("Cache-Control"), "no-cache");
  EXPECT_EQ(std::get<FileBody>(file.body).file, work() / "a b.obj");
  EXPECT_EQ(get("/api/files/a%20b.obj?v=1").status, 200);
  const std::string etag(file.header("ETag"));
  EXPECT_EQ(etag, "\"" + watch_->model().files[0].version + "\"");
  EXPECT_EQ(ask({.target = "/api/files/a%20b.obj", .if_none_match = etag}).status, 304);
  // A file that is another one meanwhile has no tag until the watch has seen it.
  write_text(work() / "a b.obj", square_obj() + "# more\n");
  const LabAnswer newer = ask({.target = "/api/files/a%20b.obj", .if_none_match = etag});
  EXPECT_EQ(newer.status, 200);
  EXPECT_EQ(newer.header("ETag"), "");
  std::filesystem::remove(work() / "a b.obj");
  EXPECT_EQ(get("/api/files/a%20b.obj").status, 404);
}

TEST_F(LabAnswers, NoOtherFileCanBeHad) {
  const std::string secret = (work() / "secret.txt").string();
  for (const std::string& target : {std::string("/api/files/secret.txt"),
                                    std::string("/api/files/../work/secret.txt"),
                                    std::string("/api/files/../../etc/passwd"),
                                    std::string("/api/files/..%2f..%2fetc%2fpasswd"),
                                    std::string("/api/files/%2e%2e/%2e%2e/etc/passwd"),
                                    "/api/files/" + secret,
                                    "/api/files" + secret,
                                    std::string("/api/files//etc/passwd"),
                                    std::string("/api/files/%2fetc%2fpasswd"),
                                    std::string("/api/files/..%5csecret.txt"),
                                    std::string("/api/files/"),
                                    std::string("/api/files"),
                                    std::string("/api/files/a%20b.obj%00.txt"),
                                    std::string("/api/files/./a%20b.obj"),
                                    std::string("/../../etc/passwd"),
                                    std::string("/%2e%2e/%2e%2e/etc/passwd"),
                                    std::string("//etc/passwd"),
                                    std::string("/assets/"),
                                    std::string("/assets"),
                                    std::string("/api/"),
                                    std::string("/.hidden"),
                                    std::string("/%252e%252e/secret.txt")}) {
    const LabAnswer refused = get(target);
    EXPECT_EQ(refused.status, 404) << target;
    EXPECT_EQ(text_of(refused), "there is no such file\n");  // and nothing of the request in it
  }
  for (const char* const target : {"", "index.html", "http://127.0.0.1:8123/", "*", "/%", "/%4", "/%zz", "/a%"}) {
    EXPECT_EQ(get(target).status, 400) << target;
  }
}

TEST_F(LabAnswers, EventsBeginWithWhatWasMissed) {
  const auto first = [&](LabRequest request) {
    const LabAnswer events = ask(std::move(request));
    EXPECT_EQ(events.status, 200);
    EXPECT_EQ(events.header("Content-Type"), "text/event-stream");
    EXPECT_EQ(events.header("Cache-Control"), "no-store");
    return std::get<EventStream>(events.body).first;
  };
  const std::string version = watch_->model().version;
  const std::string event = "id: " + version + "\ndata: {\"version\":\"" + version + "\"}\n\n";
  EXPECT_EQ(event_of(*watch_), event);
  EXPECT_EQ(first({.target = "/api/events"}), "retry: 1000\n\n");
  EXPECT_EQ(first({.target = "/api/events?version=" + version}), "retry: 1000\n\n");
  EXPECT_EQ(first({.target = "/api/events?version=0"}), "retry: 1000\n\n" + event);
  EXPECT_EQ(first({.target = "/api/events", .last_event_id = "0"}), "retry: 1000\n\n" + event);
  EXPECT_EQ(first({.target = "/api/events?version=0", .last_event_id = version}), "retry: 1000\n\n");
}

TEST_F(LabAnswers, AModelThatIsBrokenSaysSo) {
  write_text(work() / "a b.obj", "f 1 2 \"3\n");
  EXPECT_FALSE(watch_->look());
  ASSERT_TRUE(watch_->look());
  const auto json = nlohmann::json::parse(text_of(get("/api/model")));
  EXPECT_THAT(json["error"].get<std::string>(), HasSubstr("a b.obj:1: "));
  EXPECT_EQ(json["version"], watch_->model().version);
  const std::string event = event_of(*watch_);
  EXPECT_THAT(event, HasSubstr("\ndata: {\"error\":\""));
  EXPECT_EQ(std::count(event.begin(), event.end(), '\n'), 3);
}

}  // namespace
