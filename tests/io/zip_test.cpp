// ZIP archives: parts come out as they went in, and no number of the archive is believed.
#include "io/zip.hpp"

#include "io_testing.hpp"
#include "zip_writer.hpp"

namespace lustro {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kMost = 1U << 20U;

std::string part_of(const std::string& bytes, const std::string& name, std::uint64_t most = kMost) {
  const ZipArchive archive = good(open_zip(bytes, "a.zip"));
  return good(read_zip_part(archive, name, most));
}
Error error_of(const std::string& bytes, const std::string& name = "a", std::uint64_t most = kMost) {
  const Result<ZipArchive> archive = open_zip(bytes, "a.zip");
  return archive ? bad(read_zip_part(*archive, name, most)) : archive.error();
}
std::string changed(std::string bytes, std::size_t at, const std::string& to) {
  return bytes.replace(at, to.size(), to);
}

const std::string kText = std::string(1000, 'x') + "end";

TEST(Zip, PartsComeOutAsTheyWentIn) {
  const std::string bytes = zip({{"a", kText}, {"b/c.txt", "stored", false}, {"d", kText, true, true}, {"empty", ""}, {"nothing", "", false}});
  EXPECT_EQ(part_of(bytes, "a"), kText);
  EXPECT_EQ(part_of(bytes, "b/c.txt"), "stored");
  EXPECT_EQ(part_of(bytes, "d"), kText);  // ZIP64 sizes
  EXPECT_EQ(part_of(bytes, "empty"), "");
  EXPECT_EQ(part_of(bytes, "nothing"), "");
  std::string commented = changed(bytes, bytes.size() - 2, little(7, 2)) + "comment";
  EXPECT_EQ(part_of(commented, "a"), kText);
}

TEST(Zip, TheDirectoryOfZip64IsFound) {
  std::string bytes = zip({{"a", kText}});
  const std::size_t end = bytes.size() - 22;
  const std::string begin = bytes.substr(end + 16, 4) + std::string(4, '\0');
  bytes = bytes.substr(0, end) + "PK\x06\x06" + little(44, 8) + little(45, 2) + little(45, 2) + little(0, 8) + little(1, 8) + little(1, 8) +
          little(0, 8) + begin + "PK\x06\x07" + little(0, 4) + little(end, 8) + little(1, 4) + "PK\x05\x06" + little(0, 4) + little(0xFFFF, 2) +
          little(0xFFFF, 2) + little(0xFFFFFFFF, 4) + little(0xFFFFFFFF, 4) + little(0, 2);
  EXPECT_EQ(part_of(bytes, "a"), kText);
}

TEST(Zip, ClaimsAreCheckedBeforeMemoryIsTaken) {
  const std::string bytes = zip({{"a", kText}});
  const std::size_t entry = bytes.find("PK\x01\x02");
  EXPECT_EQ(error_of(bytes, "a", 1002).text(), "a.zip: a: unpacks to 1003 bytes, and at most 1002 are read");
  EXPECT_EQ(error_of(bytes, "a", 1002).kind, ErrorKind::limit);
  EXPECT_THAT(error_of(changed(bytes, entry + 24, little(4000000000, 4))).text(), HasSubstr("bytes claim to unpack to 4000000000"));
  EXPECT_THAT(error_of(changed(bytes, entry + 24, little(1004, 4))).text(), HasSubstr("do not unpack to the 1004 bytes"));
  EXPECT_THAT(error_of(changed(bytes, entry + 24, little(1002, 4))).text(), HasSubstr("do not unpack to the 1002 bytes"));
  EXPECT_THAT(error_of(changed(bytes, entry + 20, little(4000, 4))).text(), HasSubstr("reach beyond the archive's"));
  EXPECT_THAT(error_of(changed(bytes, entry + 42, little(4000, 4))).text(), HasSubstr("its header at byte 4000 is not there"));
  EXPECT_THAT(error_of(changed(bytes, entry + 16, little(1, 4))).text(), HasSubstr("CRC-32"));
  EXPECT_THAT(error_of(changed(zip({{"a", "stored", false}}), zip({{"a", "stored", false}}).find("PK\x01\x02") + 24, little(7, 4))).text(),
              HasSubstr("6 bytes claim to unpack to 7"));
}

TEST(Zip, WhatIsNotReadIsSaid) {
  const std::string bytes = zip({{"a", kText}});
  const std::size_t entry = bytes.find("PK\x01\x02");
  EXPECT_EQ(error_of(changed(bytes, entry + 8, little(1, 2))).text(), "a.zip: a: is encrypted");
  EXPECT_EQ(error_of(changed(bytes, entry + 10, little(12, 2))).text(), "a.zip: a: is packed by method 12, expected 0 (stored) or 8 (deflate)");
  EXPECT_EQ(error_of(bytes, "b").text(), "a.zip: b: is not in the ZIP archive");
  EXPECT_EQ(error_of("PK\x03\x04").text(), "a.zip: byte 4: the ZIP archive ends without a directory: it is cut short");
}

TEST(Zip, EveryPrefixAndEveryChangedByteIsAnArchiveOrAnError) {
  const std::string bytes = zip({{"a", "some text, some text", true}, {"b", "x", false, true}});
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    EXPECT_FALSE(open_zip(std::string_view(bytes).substr(0, length), "a.zip").has_value()) << length;
  }
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const int value : {0, 1, 0x7F, 0xFF}) {
      const std::string spoilt = changed(bytes, at, std::string(1, static_cast<char>(value)));
      if (const Result<ZipArchive> archive = open_zip(spoilt, "a.zip")) {
        for (const auto& [name, part] : archive->parts) {
          const Result<std::string> read = read_zip_part(*archive, name, kMost);
          EXPECT_TRUE(!read || *read == "some text, some text" || *read == "x") << at;
        }
      }
    }
  }
}

}  // namespace
}  // namespace lustro
