// Hostile input: every prefix, every byte changed, and texts that would take a careless parser minutes. Each parser must give a consistent mesh
// or an error.
#include <array>
#include <functional>
#include <random>

#include "io/mtl.hpp"
#include "io/obj.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"
#include "io_testing.hpp"

namespace lustro {
namespace {

const std::string kObj =
    "\xEF\xBB\xBF# c\r\nmtllib a b.mtl c.mtl # d\no name\nv 0 0 0 1 0 0\nv 1 0 0 1\nv 1e0 1 0\nv -1 nan 0 1 0.5 0.5 0.5\nvt 0 1\nvn 0 0 1\n"
    "g a b\ns 1\nusemtl red\nf 1/1/1 2//1 \\\n3/1 -1\ns off\nf 1 2 3\nl 1 2\ncurv 0 1\nwhat 1\nf 1 2\n";
const std::string kMtl =
    "# c\nnewmtl a b\nKa 0.1 0.2 0.3\r\nKd .5\nKs 1 1 1 # x\nKe 2 2 2\nNs 10\nNi 1.5\nd -halo 0.5\nTr 0.1\nillum 4\nPr 0.5\n"
    "map_Kd -s 1 2 3 -o 0.5 -mm 0 1 -clamp on my file.png -bm 2\nbump \"x.png\"\nTf 1 1 1\nsharpness 5\nwhat\nnewmtl a b\nillum 0\n";
const std::string kPlyHead =
    "element vertex 3\nproperty float x\nproperty float y\nproperty double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nelement tristrips 1\nproperty list int int "
    "vertex_indices\nelement junk 1\nproperty list char short a\nend_header\n";
const std::string kPlyText =
    "ply\ncomment c\nformat ascii 1.0\n" + kPlyHead + "0 0 0 1 2 3\n1 0 0 1 2 3\n1 1 0 1 2 3\n3 0 1 2 6 0 0 1 0 1 1\n4 0 1 2 -1\n2 5 6\n";

std::string binary_ply(bool is_big) {
  std::string bytes = std::string("ply\r\nformat binary_") + (is_big ? "big" : "little") + "_endian 1.0\r\n";
  for (const char c : kPlyHead) {
    bytes += c == '\n' ? std::string("\r\n") : std::string(1, c);
  }
  const auto add = [&](std::string_view little) {  // the number's bytes, the lowest first
    bytes += is_big ? std::string(little.rbegin(), little.rend()) : std::string(little);
  };
  const std::string_view one("\0\0\x80\x3F", 4);
  const std::string_view zero("\0\0\0\0\0\0\0\0", 8);
  for (int i = 0; i < 3; ++i) {
    add(i > 0 ? one : zero.substr(0, 4));
    add(i > 1 ? one : zero.substr(0, 4));
    add(zero);
    bytes += "abc";
  }
  const auto add_int = [&](int value, std::size_t size) {
    std::string little;
    for (std::size_t i = 0; i < size; ++i) {
      little += static_cast<char>((static_cast<unsigned>(value) >> (8 * i)) & 0xFFU);
    }
    add(little);
  };
  add_int(3, 1);
  for (const int index : {0, 1, 2}) {
    add_int(index, 4);
  }
  add_int(6, 1);
  for (int i = 0; i < 6; ++i) {
    add(one);
  }
  for (const int value : {4, 0, 1, 2, -1}) {
    add_int(value, 4);
  }
  add_int(2, 1);
  add_int(5, 2);
  add_int(6, 2);
  return bytes;
}

const std::string kStlText =
    "# c\nsolid a b # d\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 nan\nvertex 1 1 0\nendloop\nendfacet\nendsolid "
    "a\nsolid\nfacet\nouter "
    "loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

std::string binary_stl() {
  std::string bytes = "solid not text";
  bytes.resize(80, '\0');
  bytes += std::string("\x02\0\0\0", 4);
  for (int i = 0; i < 100; ++i) {
    bytes += static_cast<char>(37 * i);
  }
  return bytes;
}

struct Sample {
  std::string name;
  std::string bytes;
  std::function<bool(const std::string&)> parse;  // true for a value
};

bool check(const Result<SourceMesh>& mesh) {
  if (mesh) {
    expect_consistent(*mesh);
    return true;
  }
  EXPECT_FALSE(mesh.error().where.empty());
  EXPECT_FALSE(mesh.error().message.empty());
  return false;
}

bool parse_obj_with_library(const std::string& bytes) {
  ObjOptions options;
  options.read_library = [](const std::string& name) -> Result<std::string> {
    return name == "c.mtl" ? Result<std::string>(kMtl) : Result<std::string>(fail(ErrorKind::io, name, "missing"));
  };
  return check(parse_obj(bytes, "m.obj", options));
}
bool parse_ply_file(const std::string& bytes) {
  return check(parse_ply(bytes, "m.ply"));
}
bool parse_stl_file(const std::string& bytes) {
  return check(parse_stl(bytes, "m.stl"));
}
bool parse_mtl_file(const std::string& bytes) {
  const Result<MtlFile> file = parse_mtl(bytes, "m.mtl");
  for (std::size_t i = 0; file && i < file->materials.size(); ++i) {
    const Material& m = file->materials[i];
    EXPECT_TRUE(m.opacity >= 0 && m.opacity <= 1 && m.shininess >= 0 && m.shininess <= 10000);
    EXPECT_TRUE(is_finite(m.diffuse.rgb) && m.diffuse.rgb.x >= 0);
  }
  return file.has_value();
}

std::vector<Sample> samples() {
  return {{"obj", kObj, parse_obj_with_library},         {"mtl", kMtl, parse_mtl_file},
          {"ply ascii", kPlyText, parse_ply_file},       {"ply little", binary_ply(false), parse_ply_file},
          {"ply big", binary_ply(true), parse_ply_file}, {"stl ascii", kStlText, parse_stl_file},
          {"stl binary", binary_stl(), parse_stl_file}};
}

TEST(Hostile, TheSamplesThemselvesAreGood) {
  for (const Sample& sample : samples()) {
    EXPECT_TRUE(sample.parse(sample.bytes)) << sample.name;
  }
  EXPECT_EQ(good(parse_ply(binary_ply(true), "m")).positions, good(parse_ply(kPlyText, "m")).positions);
  EXPECT_EQ(good(parse_ply(binary_ply(false), "m")).corner_position, good(parse_ply(kPlyText, "m")).corner_position);
}

TEST(Hostile, EveryPrefixIsAValueOrAnError) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    std::size_t values = 0;
    for (std::size_t length = 0; length < sample.bytes.size(); ++length) {
      const std::string prefix(sample.bytes, 0, length);  // a copy of its own: a sanitizer sees reads behind it
      values += sample.parse(prefix) ? 1U : 0U;
    }
    EXPECT_LT(values, sample.bytes.size());
    if (sample.name.starts_with("ply") || sample.name == "stl binary") {
      EXPECT_LE(values, 1U);  // a cut header or body is never taken for the whole (but an ascii file may lack its last line's end)
    }
  }
}

TEST(Hostile, EveryByteChangedIsAValueOrAnError) {
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    std::string bytes = sample.bytes;
    for (char& byte : bytes) {
      const char before = byte;
      for (const char value : {'\0', '\n', '\r', ' ', '#', '-', '/', '\\', '0', '9', 'f', '\x7F', '\x80', '\xFF'}) {
        byte = value;
        static_cast<void>(sample.parse(bytes));
      }
      byte = before;
    }
  }
}

TEST(Hostile, BytesRemovedAndDoubledAreAValueOrAnError) {
  std::mt19937 random(7);
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    for (int round = 0; round < 3000; ++round) {
      std::string bytes = sample.bytes;
      const std::size_t at = random() % bytes.size();
      const std::size_t length = 1 + random() % 12;
      if (random() % 2 == 0) {
        bytes.erase(at, length);
      } else {
        bytes.insert(random() % bytes.size(), bytes.substr(at, length));
      }
      static_cast<void>(sample.parse(bytes));
    }
  }
}

// --- time: what must take milliseconds takes minutes where something is quadratic -----------------------------------

std::string repeated(const std::string& text, std::size_t times) {
  std::string out;
  out.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) {
    out += text;
  }
  return out;
}
std::string numbered(const std::string& before, const std::string& behind, std::size_t times) {
  std::string out;
  for (std::size_t i = 0; i < times; ++i) {
    out += before + std::to_string(i) + behind;
  }
  return out;
}

TEST(Hostile, LongTextsTakeTimeInProportion) {
  const std::size_t many = 200'000;
  const std::string triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  const std::string long_name(1'000'000, 'x');
  const std::vector<std::string> texts{
      triangle + numbered("g group", "\nf 1 2 3\n", many),
      triangle + "o " + long_name + "\n" + numbered("g group", "\nf 1 2 3\n", many),
      triangle + numbered("usemtl m", "\nf 1 2 3\n", many),
      triangle + numbered("s group", "\nf 1 2 3\n", many),
      numbered("mtllib l", ".mtl\n", many),
      "mtllib " + numbered("l", ".mtl ", many) + "\n",
      "mtllib " + numbered("l", " ", many) + "\n",
      numbered("word", " 1 2 3\n", many) + triangle,
      repeated("l 1 2\n", many),
      triangle + "f" + repeated(" 1 2 3", many) + "\n",
      triangle + "f 1 2 3" + repeated(" \\\n 1", many) + "\n",
      numbered("f 1 1 ", "\n", many) + repeated("v 0 0 0\n", many),
      repeated("f 1/1 1\n", many) + triangle + "vt 0 0\n",
      repeated("\r", many) + triangle,
      repeated("# \\\n", many),
      "v " + std::string(1'000'000, '1') + " 0 0\n",
      "v 0." + std::string(1'000'000, '3') + "e-5 0 0\n",
      std::string(1'000'000, '\\'),
      std::string(1'000'000, ' '),
      repeated("v nan( 0 0\n", 10) + std::string(1'000'000, 'n'),
  };
  for (const std::string& text : texts) {
    SCOPED_TRACE(text.substr(0, 60));
    static_cast<void>(check(parse_obj(text, "m.obj")));
  }
}

TEST(Hostile, LongMaterialFilesTakeTimeInProportion) {
  const std::size_t many = 200'000;
  for (const std::string& text : {numbered("newmtl m", "\n", many), repeated("newmtl m\n", many), "newmtl m\n" + numbered("word", "\n", many),
                                  "newmtl m\n" + numbered("map_Kd f", "\n", many),
                                  "newmtl m\nmap_Kd" + repeated(" -clamp on", many) + " x.png" + repeated(" -clamp on", many) + "\n",
                                  "newmtl m\nmap_Kd" + repeated(" -s", many) + "\n", "newmtl m\nmap_Kd x" + repeated(" -bm 1 y", many) + "\n",
                                  "newmtl m\nmap_Kd -type " + std::string(1'000'000, 'x') + repeated(" -type sphere", many) + "\n"}) {
    SCOPED_TRACE(text.substr(0, 60));
    static_cast<void>(parse_mtl_file(text));
  }
}

TEST(Hostile, LongPlyAndStlFilesTakeTimeInProportion) {
  const std::size_t many = 200'000;
  static_cast<void>(parse_ply_file("ply\nformat ascii 1.0\n" + numbered("element e", " 0\n", many) + "end_header\n"));
  static_cast<void>(parse_ply_file("ply\nformat ascii 1.0\n" + numbered("element e", " 4000000000\n", many) + "end_header\n"));
  static_cast<void>(parse_ply_file("ply\nformat ascii 1.0\nelement e 1\n" + numbered("property list uchar int p", "\n", many) + "end_header\n" +
                                   repeated("0 ", many)));
  static_cast<void>(parse_ply_file("ply\nformat ascii 1.0\nelement vertex 1\nproperty char x\nproperty char y\nproperty char z\nend_header\n" +
                                   repeated("comment\n", many) + "0 0 0\n"));
  static_cast<void>(parse_ply_file("ply\n" + repeated("comment x\n", many)));
  static_cast<void>(parse_stl_file(repeated("solid a\nendsolid\n", many)));
  static_cast<void>(parse_stl_file(repeated("solid a\nfacet\nouter loop\nendloop\nendfacet\nendsolid\n", many)));
  static_cast<void>(parse_stl_file("solid " + std::string(1'000'000, 'x') + "\n" + repeated("# c\n", many)));
}

}  // namespace
}  // namespace lustro
