// An OBJ that is cut into parts and read by threads is the same mesh, with the same notes, or the same error, as one that is read line by line.
#include "io/obj_lines.hpp"

#include <cstring>
#include <filesystem>
#include <random>

#include "io/obj.hpp"
#include "io/read_file.hpp"
#include "io_testing.hpp"
#include "mesh/same_bits.hpp"
#include "shared_dir.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

void expect_equal_ways(const std::string& text) {
  const auto expected = parse_obj_line_by_line(text, "m.obj");
  for (const std::size_t part_bytes : {std::size_t{16}, std::size_t{100}, std::size_t{1000}, std::size_t{1} << 19U}) {
    SCOPED_TRACE(part_bytes);
    ObjOptions options;
    options.threads = text.size() % 16 == 0 ? 3 : 1;  // now and then: to start threads takes longer than to read such texts
    options.part_bytes = part_bytes;
    expect_same(parse_obj(text, "m.obj", options), expected);
  }
}

/// Lines as exporters write them, and as nobody should.
class RandomObj {
 public:
  explicit RandomObj(std::mt19937& engine) : engine_(engine) {
    newline_ = one_of({"\n", "\n", "\n", "\r\n", "\r"});
    oddity_ = one_of({"0", "0", "20", "200"});
    form_ = random(4);
    is_relative_ = random(3) == 0;
  }

  std::string make() {
    std::string text = random(20) == 0 ? "\xEF\xBB\xBF" : "";
    const std::uint32_t blocks = 1 + random(6);
    for (std::uint32_t b = 0; b < blocks; ++b) {
      text += one_of({"", "", "# a comment", "g part", "o thing", "s 1", "s off", "usemtl red", "usemtl blue", "   "}) + newline_;
      const std::uint32_t records = random(30);
      for (std::uint32_t i = 0; i < records; ++i) {
        text += line("v", 3);
        if (form_ % 2 == 1) {
          text += line("vt", 2);
        }
        if (form_ >= 2) {
          text += line("vn", 3);
        }
      }
      counts_ += records;
      for (std::uint32_t i = random(60); i > 0 && counts_ != 0; --i) {
        text += face();
      }
    }
    if (random(4) == 0) {
      text.resize(text.size() - newline_.size());
    }
    return text;
  }

 private:
  std::uint32_t random(std::uint32_t below) { return static_cast<std::uint32_t>(engine_()) % below; }
  bool is_odd() { return random(10000) < static_cast<std::uint32_t>(std::stoi(oddity_)); }
  std::string one_of(std::initializer_list<const char*> list) { return list.begin()[random(static_cast<std::uint32_t>(list.size()))]; }
  std::string blank() { return is_odd() ? one_of({"  ", "\t", " \\\n", "\\\r\n ", "\v", "\f"}) : " "; }

  std::string number() {
    if (is_odd()) {
      return one_of({"nan", "inf", "1.#QNAN", "+1", "-", "1e5", "1e-50", "1e50", ".5", "5.", "-.5", "-0", "0x1", "1,5", "1#", "1/2", "++1"});
    }
    std::string digits = random(2) == 0 ? "-" : "";
    digits += std::to_string(random(10) == 0 ? random(4'000'000'000U) : random(20));
    if (random(8) != 0) {
      digits += '.';
      for (std::uint32_t i = random(12); i > 0; --i) {
        digits += static_cast<char>('0' + random(10));
      }
    }
    return digits;
  }

  std::string end() { return (is_odd() ? one_of({" ", "\t ", " # note", "#", " 7", " \\\n", "x"}) : std::string()) + newline_; }

  std::string line(const std::string& word, std::uint32_t numbers) {
    std::string text = is_odd() ? one_of({"l 1 2", "vp 1", "bevel on", "# odd \\", "what is this", "mtllib no.mtl"}) + newline_ : "";
    text += is_odd() ? " " : "";
    text += word;
    numbers = is_odd() ? random(9) : (numbers == 2 && random(9) == 0 ? 3 : numbers);
    for (std::uint32_t i = 0; i < numbers; ++i) {
      text += blank() + number();
    }
    return text + end();
  }

  std::string index() {
    if (is_odd()) {
      return one_of({"0", "99999", "-99999", "12345678901234567890", "x", "", "1.5", "+1", "1", "-1"});
    }
    const std::uint32_t i = 1 + random(counts_);
    return is_relative_ ? "-" + std::to_string(i) : std::to_string(i);
  }

  std::string face() {
    std::string text = is_odd() ? "fo" : "f";
    const std::uint32_t corners = is_odd() ? random(5) : random(5) == 0 ? 3 + random(3) : 3;
    const std::uint32_t form = is_odd() ? random(4) : form_;
    for (std::uint32_t c = 0; c < corners; ++c) {
      text += blank() + index();
      text += form == 0 ? "" : form == 1 ? "/" + index() : form == 2 ? "//" + index() : "/" + index() + "/" + index();
      text += is_odd() ? "/" : "";
    }
    return text + end();
  }

  std::mt19937& engine_;
  std::string newline_;
  std::string oddity_;
  std::uint32_t form_ = 0;
  std::uint32_t counts_ = 0;
  bool is_relative_ = false;
};

TEST(ObjLines, RandomFilesAreReadAsLineByLine) {
  std::mt19937 engine(31);
  int good_files = 0;
  for (int round = 0; round < 3000 && !testing::Test::HasFailure(); ++round) {
    const std::string text = RandomObj(engine).make();
    SCOPED_TRACE(text);
    expect_equal_ways(text);
    good_files += parse_obj(text, "m.obj") ? 1 : 0;
  }
  EXPECT_GT(good_files, 1000);
}

TEST(ObjLines, DamagedFilesAreReadAsLineByLine) {
  std::mt19937 engine(32);
  constexpr std::string_view kBytes = "\n\r \\#/-+.0123456789vfntgse\t";
  for (int round = 0; round < 1500 && !testing::Test::HasFailure(); ++round) {
    std::string text = RandomObj(engine).make() + "f 1 1 1\n";
    for (int i = 0; i < 4; ++i) {
      text[engine() % text.size()] = kBytes[engine() % kBytes.size()];
    }
    SCOPED_TRACE(text);
    expect_equal_ways(text);
  }
}

TEST(ObjLines, AssetsAreReadAsLineByLine) {
  LUSTRO_REQUIRE_SHARED();
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(shared_dir() / "assets")) {
    if (entry.path().extension() == ".obj") {
      SCOPED_TRACE(entry.path());
      const auto bytes = good(read_file(entry.path()));
      const auto expected = parse_obj_line_by_line(bytes.view(), "m.obj");
      for (const std::size_t part_bytes : {std::size_t{5000}, std::size_t{1} << 19U}) {
        ObjOptions options;
        options.part_bytes = part_bytes;
        expect_same(parse_obj(bytes.view(), "m.obj", options), expected);
      }
      ++files;
    }
  }
  EXPECT_GT(files, 10);
}

TEST(ObjLines, EveryNumberIsTheNearestFloat) {
  std::mt19937 engine(33);
  std::string text;
  std::vector<std::string> written;
  for (int i = 0; i < 300'000; ++i) {
    std::string number = engine() % 2 == 0 ? "-" : "";
    for (std::uint64_t d = 1 + engine() % 8; d > 0; --d) {
      number += static_cast<char>('0' + engine() % 10);
    }
    number += '.';
    for (std::uint64_t d = engine() % 10; d > 0; --d) {
      number += static_cast<char>('0' + engine() % 10);
    }
    if (i % 3 == 0) {  // exactly between two floats, or a hair beside that
      const auto mantissa = (engine() % (1U << 23U)) | (1U << 23U);
      number = std::to_string(mantissa / 2 + 4'000'000) + (mantissa % 2 == 0 ? ".25" : ".75") + (i % 2 == 0 ? "" : "0000001");
    }
    written.push_back(number);
    text += (i % 3 == 0 ? "\nv " : " ") + number;
  }
  text += "\n\n\n                                    \n";
  const SourceMesh mesh = good(parse_obj(text, "m.obj"));
  ASSERT_EQ(mesh.positions.size(), written.size() / 3);
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    ASSERT_EQ(mesh.positions[i].x, std::strtof(written[3 * i].c_str(), nullptr)) << written[3 * i];
    ASSERT_EQ(mesh.positions[i].y, std::strtof(written[3 * i + 1].c_str(), nullptr)) << written[3 * i + 1];
    ASSERT_EQ(mesh.positions[i].z, std::strtof(written[3 * i + 2].c_str(), nullptr)) << written[3 * i + 2];
  }
}

TEST(ObjLines, UsualLinesAreReadAsUsual) {
  std::string text;
  for (int i = 0; i < 100; ++i) {
    text += "v 1.5 -2 0.25\r\n  vn 0 0 1 \nvt 0.5 0.5\n\n# comment\nf 1/1/1 1/1/1 1/1/1\n";
  }
  ObjPart part;
  read_obj_part(text, text.data(), text.data() + text.size() / 2, part);  // a text that goes on behind the part
  ASSERT_FALSE(part.pieces.empty());
  EXPECT_TRUE(part.pieces.front().is_usual);
  read_obj_part(text, text.data(), text.data() + text.size(), part);
  ASSERT_LE(part.pieces.size(), 2U);  // the last line is too near to the end for eight bytes at a step
  EXPECT_GE(part.pieces.front().faces, 99U);
  EXPECT_EQ(part.lines, 600U);
}

}  // namespace
}  // namespace lustro
