// Reading whole files, and every way in which that fails.
#include "io/read_file.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "io_testing.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

TEST(ReadFile, GivesEveryByte) {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xFF", 5);
  folder.write("x", bytes);
  EXPECT_EQ(good(read_file(folder.path / "x")).view(), bytes);
  folder.write("empty", "");
  EXPECT_EQ(good(read_file(folder.path / "empty")).view(), "");
}

TEST(ReadFile, FailuresNameTheFileAndTheSystemsReason) {
  const TemporaryFolder folder;
  const Error missing = bad(read_file(folder.path / "gone.obj"));
  EXPECT_EQ(missing.kind, ErrorKind::io);
  EXPECT_EQ(missing.text(), (folder.path / "gone.obj").string() + ": cannot be opened: No such file or directory");
  EXPECT_EQ(bad(read_file(folder.path)).message, "is a folder, not a file");
  EXPECT_EQ(bad(read_file(folder.path)).kind, ErrorKind::io);
}

TEST(ReadFile, AFileWithoutPermissionIsAnError) {
  const TemporaryFolder folder;
  folder.write("x", "bytes");
  fs::permissions(folder.path, fs::perms::owner_all | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(folder.path / "x", fs::perms::none);
  const bool is_superuser = ::geteuid() == 0;  // who may read everything, and so becomes nobody for a moment
  if (is_superuser && ::seteuid(65534) != 0) {
    GTEST_SKIP() << "the superuser may read everything";
  }
  const Result<FileBytes> bytes = read_file(folder.path / "x");
  if (is_superuser) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(bad(bytes).kind, ErrorKind::io);
  EXPECT_EQ(bad(bytes).message, "cannot be opened: Permission denied");
}

TEST(ReadFile, APipeDoesNotHang) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo((folder.path / "pipe").c_str(), 0600), 0);
  EXPECT_EQ(bad(read_file(folder.path / "pipe")).message, "is not a regular file");
}

TEST(ReadFile, AFileLargerThanTheMemoryIsRefusedAtOnce) {
  const TemporaryFolder folder;
  folder.write("x", "");
  std::error_code problem;
  fs::resize_file(folder.path / "x", std::uintmax_t{1} << 43U, problem);  // 8 TiB that take no room
  if (problem) {
    GTEST_SKIP() << "this file system has no such large files";
  }
  EXPECT_EQ(bad(read_file(folder.path / "x")).kind, ErrorKind::limit);
}

TEST(ByteSource, GivesAnyPartOfAFileAsOfMemory) {
  const TemporaryFolder folder;
  std::string bytes;
  for (std::size_t i = 0; i < 5'000'000; ++i) {
    bytes += static_cast<char>(i * i >> 7U);
  }
  folder.write("x", bytes);
  const Result<ByteSource> file = ByteSource::open(folder.path / "x");
  ASSERT_TRUE(file.has_value());
  const ByteSource memory{std::string_view(bytes)};
  for (const ByteSource* source : {&*file, &memory}) {
    EXPECT_EQ(source->size(), bytes.size());
    std::string room(1000, ' ');
    EXPECT_EQ(source->read(0, 1000, room.data()), bytes.substr(0, 1000));
    EXPECT_EQ(source->read(4'999'990, 10, room.data()), bytes.substr(4'999'990));
    EXPECT_EQ(source->read(4'999'991, 10, room.data()), "");
    EXPECT_EQ(source->read(5'000'001, 0, room.data()), "");
    for (const int threads : {1, 2, 5}) {
      EXPECT_EQ(good(source->read_all(threads)).view(), bytes);
    }
  }
}

TEST(ByteSource, AFileThatIsShortenedMeanwhileEndsWhereItEnds) {
  const TemporaryFolder folder;
  folder.write("x", std::string(4'000'000, 'a'));
  const Result<ByteSource> source = ByteSource::open(folder.path / "x");
  ASSERT_TRUE(source.has_value());
  fs::resize_file(folder.path / "x", 2'500'001);
  EXPECT_EQ(source->size(), 4'000'000U);
  std::string room(100, ' ');
  EXPECT_EQ(source->read(3'000'000, 100, room.data()), "");
  EXPECT_EQ(good(source->read_all(3)).view(), std::string(2'500'001, 'a'));
}

}  // namespace
}  // namespace lustro
