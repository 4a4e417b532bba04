// The files of the lab's page: those inside the program (of this test: tests/app/lab_page), and those of a folder.
#include "app/lab_page.hpp"

#include <gmock/gmock.h>

#include "app/run_command.hpp"

namespace {

using namespace lustro::app;
using lustro::testing::file_text;
using lustro::testing::write_text;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

const fs::path kFixture = fs::path(LUSTRO_SOURCE_DIR) / "tests/app/lab_page";

TEST(LabPage, TheProgramHoldsEveryFileOfTheBuiltPageInOrder) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embedded_page()) {
    names.emplace_back(file.name);
  }
  EXPECT_THAT(names, ElementsAre("assets/font-Q1w2E3r4.woff2", "assets/index-Bx3kq9Zc.js", "assets/style-abc_-123.css", "engine/lustro.wasm",
                                 "index.html"));  // and nothing that is hidden
}

TEST(LabPage, UnpacksToTheFilesThatWerePacked) {
  const LabPage page(embedded_page());
  for (const EmbeddedFile& file : embedded_page()) {
    const std::string original = file_text(kFixture / file.name);
    const auto plain = page.find(file.name, false);
    ASSERT_TRUE(plain) << file.name;
    EXPECT_FALSE(plain->is_gzip);
    EXPECT_EQ(plain->content(), original) << file.name;
    EXPECT_EQ(file.plain, original.size());
    EXPECT_EQ(plain->etag, file.etag);
  }
}

TEST(LabPage, PacksWhatBecomesSmallerAndLeavesTheRest) {
  const LabPage page(embedded_page());
  const auto html = page.find("index.html", true);
  ASSERT_TRUE(html && html->is_gzip);
  EXPECT_LT(html->content().size(), file_text(kFixture / "index.html").size() / 2);
  EXPECT_EQ(gunzip(html->content(), file_text(kFixture / "index.html").size()), file_text(kFixture / "index.html"));
  EXPECT_EQ(html->content().substr(4, 4), std::string_view("\0\0\0\0", 4));  // no time in it
  const auto font = page.find("assets/font-Q1w2E3r4.woff2", true);
  ASSERT_TRUE(font);
  EXPECT_FALSE(font->is_gzip);
}

TEST(LabPage, ABrokenPackIsNothing) {
  const std::string plain = file_text(kFixture / "index.html");
  const std::string packed(LabPage(embedded_page()).find("index.html", true)->content());
  ASSERT_TRUE(gunzip(packed, plain.size()));
  EXPECT_FALSE(gunzip(packed, plain.size() + 1));
  EXPECT_FALSE(gunzip(packed, plain.size() - 1));
  EXPECT_FALSE(gunzip(packed, std::size_t{1} << 40U));
  EXPECT_FALSE(gunzip("", 0));
  for (const std::size_t at : {std::size_t{0}, std::size_t{3}, packed.size() / 2, packed.size() - 8, packed.size() - 1}) {
    std::string broken = packed;
    broken[at] = static_cast<char>(broken[at] ^ 1);
    EXPECT_FALSE(gunzip(broken, plain.size())) << at;
  }
}

TEST(LabPage, KnowsOnlyItsOwnNames) {
  const LabPage page(embedded_page());
  for (const char* const name :
       {"", "index", "index.htm", "assets", "assets/", "./index.html", "assets/../index.html", "/index.html", ".hidden"}) {
    EXPECT_FALSE(page.find(name, true)) << name;
  }
}

class LabPageFolder : public lustro::testing::CommandTest {};

TEST_F(LabPageFolder, IsReadAnewAndNeverLeft) {
  fs::create_directories(folder / "page/assets");
  write_text(folder / "page/index.html", "one");
  write_text(folder / "page/assets/a.js", "a");
  write_text(folder / "page/.secret", "hidden");
  write_text(folder / "secret.txt", "outside");
  fs::create_symlink("../secret.txt", folder / "page/link.txt");
  fs::create_symlink("index.html", folder / "page/inner.html");
  const auto page = lab_page((folder / "page").string(), {});
  ASSERT_TRUE(page) << page.error().text();
  EXPECT_EQ(page->find("index.html", true)->content(), "one");
  const std::string etag = page->find("index.html", true)->etag;
  write_text(folder / "page/index.html", "two");
  EXPECT_EQ(page->find("index.html", true)->content(), "two");
  EXPECT_NE(page->find("index.html", true)->etag, etag);
  EXPECT_EQ(page->find("assets/a.js", true)->content(), "a");
  EXPECT_EQ(page->find("inner.html", true)->content(), "two");
  for (const char* const name :
       {"../secret.txt", "assets/../../secret.txt", "link.txt", ".secret", "assets", "", "assets//a.js", "./index.html"}) {
    EXPECT_FALSE(page->find(name, true)) << name;
  }
  EXPECT_FALSE(page->find((folder / "secret.txt").string(), true));
  EXPECT_FALSE(page->find(std::string("index.html\0.js", 14), true));
}

TEST_F(LabPageFolder, WithoutAPageTheErrorSaysHowToBuildOne) {
  const auto none = lab_page("", {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().kind, lustro::ErrorKind::unsupported);
  EXPECT_THAT(none.error().text(), HasSubstr("holds no page: scripts/lab builds"));
  const auto empty = lab_page(folder.string(), embedded_page());
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().kind, lustro::ErrorKind::io);
  EXPECT_THAT(empty.error().text(), HasSubstr(folder.string() + ": holds no index.html"));
}

TEST(LabPageNames, HaveTheirTypes) {
  EXPECT_EQ(content_type_of("index.html"), "text/html; charset=utf-8");
  EXPECT_EQ(content_type_of("assets/index-Bx3kq9Zc.js"), "text/javascript; charset=utf-8");
  EXPECT_EQ(content_type_of("a.css"), "text/css; charset=utf-8");
  EXPECT_EQ(content_type_of("engine/lustro.wasm"), "application/wasm");
  EXPECT_EQ(content_type_of("a.woff2"), "font/woff2");
  EXPECT_EQ(content_type_of("icon.svg"), "image/svg+xml");
  EXPECT_EQ(content_type_of("a.js.exe"), "application/octet-stream");
}

TEST(LabPageNames, ThatHoldAHashAreThoseOfVite) {
  for (const char* const name :
       {"assets/index-Bx3kq9Zc.js", "assets/a-b-_-3kq9Zc.woff2", "assets/index-Bx3kq9Zc.js.map", "assets/KaTeX_Main-Regular-B22Nviop.woff2"}) {
    EXPECT_TRUE(is_hashed_name(name)) << name;
  }
  for (const char* const name : {"index.html", "index-Bx3kq9Zc.js", "assets/index.js", "assets/-Bx3kq9Zc", "assets/Bx3kq9Zc.js",
                                 "assets/a-Bx3kq9Z!.js", "engine/lustro.wasm", "assets/a-123.js", "assets/"}) {
    EXPECT_FALSE(is_hashed_name(name)) << name;
  }
}

}  // namespace
