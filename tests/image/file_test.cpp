#include "image/file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <thread>

#include "image/support.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

Result<void> accept_all(std::span<const std::byte>) {
  return {};
}

TEST(WriteFile, WritesTheBytesAndNothingElse) {
  const TemporaryFolder folder;
  const auto content = bytes_of_text("some\0bytes");
  ASSERT_TRUE(write_file_atomically(folder.path() / "a.bin", content));
  EXPECT_EQ(bytes_of(folder.path() / "a.bin"), content);
  EXPECT_EQ(folder.count(), 1U);
  ASSERT_TRUE(write_file_atomically(folder.path() / "empty", {}));
  EXPECT_EQ(fs::file_size(folder.path() / "empty"), 0U);
}

TEST(WriteFile, ReplacesAnExistingFileWhole) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.bin";
  ASSERT_TRUE(write_file_atomically(file, bytes_of_text("a long first content")));
  ASSERT_TRUE(write_file_atomically(file, bytes_of_text("short")));
  EXPECT_EQ(bytes_of(file), bytes_of_text("short"));
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, ThePermissionsAreThoseOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  const auto ok = write_file_atomically(folder.path() / "a", bytes_of_text("x"));
  ::umask(before);
  ASSERT_TRUE(ok);
  EXPECT_EQ(fs::status(folder.path() / "a").permissions(), static_cast<fs::perms>(0640));
}

TEST(WriteFile, FailuresNameTheFileAndTheReasonAndLeaveNothing) {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "missing" / "a.png";
  const auto no_folder = write_file_atomically(missing, bytes_of_text("x"));
  ASSERT_FALSE(no_folder);
  EXPECT_EQ(no_folder.error().kind, ErrorKind::io);
  EXPECT_EQ(no_folder.error().text(), missing.string() + ": cannot be written: No such file or directory");

  fs::create_directory(folder.path() / "target");
  const auto is_folder = write_file_atomically(folder.path() / "target", bytes_of_text("x"));
  ASSERT_FALSE(is_folder);
  EXPECT_EQ(is_folder.error().text(), (folder.path() / "target").string() + ": cannot be written: it is a folder");
  EXPECT_FALSE(write_file_atomically(folder.path() / "new" / "", bytes_of_text("x")));
  EXPECT_FALSE(write_file_atomically("", bytes_of_text("x")));
  const auto under_a_file = write_file_atomically(fs::path("/dev/null") / "a", bytes_of_text("x"));
  ASSERT_FALSE(under_a_file);
  EXPECT_THAT(under_a_file.error().text(), testing::HasSubstr("Not a directory"));
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, AWriteProtectedFolderOrFileIsRespected) {
  if (::geteuid() == 0) {
    GTEST_SKIP() << "root may write everywhere";
  }
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  ASSERT_TRUE(write_file_atomically(file, bytes_of_text("old")));
  fs::permissions(file, static_cast<fs::perms>(0444));
  EXPECT_FALSE(write_file_atomically(file, bytes_of_text("new")));
  fs::permissions(folder.path(), static_cast<fs::perms>(0555));
  EXPECT_FALSE(write_file_atomically(folder.path() / "b", bytes_of_text("new")));
  fs::permissions(folder.path(), static_cast<fs::perms>(0755));
  EXPECT_EQ(bytes_of(file), bytes_of_text("old"));
  EXPECT_EQ(folder.count(), 1U);
}

/// Ends the process: with 7 when the write failed as it should.
[[noreturn]] void write_beyond_the_limit(const fs::path& file) {
  const rlimit limit{4096, 4096};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  ::signal(SIGXFSZ, SIG_IGN);
  const auto result = write_file_atomically(file, std::vector<std::byte>(100000));
  ::_exit(!result && result.error().text() == file.string() + ": cannot be written: File too large" ? 7 : 1);
}

TEST(WriteFileDeathTest, AFailedWriteKeepsTheOldFile) {
  // the new content cannot be written whole: a file may not grow beyond the limit of the process
  const TemporaryFolder folder;
  const auto file = folder.path() / "a";
  ASSERT_TRUE(write_file_atomically(file, bytes_of_text("old")));
  EXPECT_EXIT(write_beyond_the_limit(file), testing::ExitedWithCode(7), "");
  EXPECT_EQ(bytes_of(file), bytes_of_text("old"));
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, AFullDeviceIsReportedAndADeviceIsNeverReplaced) {
  if (!fs::is_character_file("/dev/full")) {
    GTEST_SKIP() << "needs /dev/full";
  }
  const auto full = write_file_atomically("/dev/full", bytes_of_text("x"));
  ASSERT_FALSE(full);
  EXPECT_EQ(full.error().text(), "/dev/full: cannot be written: No space left on device");
  EXPECT_TRUE(write_file_atomically("/dev/null", bytes_of_text("x")));
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, APipeTakesTheBytes) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::vector<std::byte> seen;
  std::thread reader([&] { seen = bytes_of(pipe); });
  const auto ok = write_file_atomically(pipe, bytes_of_text("through the pipe"));
  reader.join();
  EXPECT_TRUE(ok);
  EXPECT_EQ(seen, bytes_of_text("through the pipe"));
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WriteFile, ASymbolicLinkStaysAndItsTargetIsReplaced) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "store");
  fs::create_symlink("store/real", folder.path() / "link");  // relative to where the link lies, and not there yet
  fs::create_symlink(folder.path() / "link", folder.path() / "chain");
  ASSERT_TRUE(write_file_atomically(folder.path() / "link", bytes_of_text("one")));
  EXPECT_EQ(bytes_of(folder.path() / "store" / "real"), bytes_of_text("one"));
  ASSERT_TRUE(write_file_atomically(folder.path() / "chain", bytes_of_text("two")));
  EXPECT_EQ(bytes_of(folder.path() / "store" / "real"), bytes_of_text("two"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
  EXPECT_TRUE(fs::is_symlink(folder.path() / "chain"));
  fs::create_symlink("circle", folder.path() / "circle");
  const auto circle = write_file_atomically(folder.path() / "circle", bytes_of_text("x"));
  ASSERT_FALSE(circle);
  EXPECT_THAT(circle.error().text(), testing::HasSubstr("Too many levels of symbolic links"));
}

TEST(WriteFile, ManyThreadsDoNotDisturbEachOther) {
  const TemporaryFolder folder;
  std::vector<std::thread> threads;
  for (int t = 0; t < 8; ++t) {
    threads.emplace_back([&, t] {
      for (int i = 0; i < 25; ++i) {
        const std::string name = "file" + std::to_string(t % 4);  // two threads a file
        EXPECT_TRUE(write_file_atomically(folder.path() / name, std::vector<std::byte>(5000, static_cast<std::byte>(t))));
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(folder.count(), 4U);
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    const auto bytes = bytes_of(entry.path());
    ASSERT_EQ(bytes.size(), 5000U);
    EXPECT_EQ(bytes, std::vector<std::byte>(5000, bytes[0]));  // whole, from one of the two
  }
}

TEST(ReadFile, GivesEveryByteOfFilesOfAnySize) {
  const TemporaryFolder folder;
  for (const std::size_t size : {0U, 1U, 15U, 16U, 17U, 65536U, 65537U, 200001U}) {
    std::vector<std::byte> content(size);
    std::mt19937 random(static_cast<unsigned>(size));
    std::ranges::generate(content, [&] { return static_cast<std::byte>(random() & 0xFF); });
    ASSERT_TRUE(write_file_atomically(folder.path() / "a", content));
    const auto back = read_file_bytes(folder.path() / "a", accept_all);
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, content) << size;
  }
}

TEST(ReadFile, ReadsAPipeWhoseLengthNobodyKnows) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  const std::vector<std::byte> content(300000, std::byte{42});
  std::thread writer([&] { EXPECT_TRUE(write_file_atomically(pipe, content)); });
  const auto back = read_file_bytes(pipe, accept_all);
  writer.join();
  ASSERT_TRUE(back);
  EXPECT_EQ(*back, content);
}

TEST(ReadFile, FailuresNameTheFileAndTheReason) {
  const TemporaryFolder folder;
  const auto missing = folder.path() / "missing";
  EXPECT_EQ(read_file_bytes(missing, accept_all).error().text(), missing.string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(read_file_bytes(folder.path(), accept_all).error().text(), folder.path().string() + ": is a folder, and a file was expected");
}

TEST(ReadFile, AnEndlessDeviceIsRefusedByItsFirstBytes) {
  const auto result = read_image("/dev/zero");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().text(), "/dev/zero: is no image that is known: PNG, JPEG, WebP, TGA, BMP, Radiance HDR, EXR and PFM are read");
}

}  // namespace
}  // namespace lustro
