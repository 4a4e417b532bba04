// The shorter way through usual PLY files gives what the general way gives: the same meshes, errors and notes.
#include "io/ply_direct.hpp"

#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <random>

#include "io/ply.hpp"
#include "io_testing.hpp"
#include "lustro/scene.hpp"
#include "mesh/build.hpp"
#include "mesh/same_bits.hpp"
#include "shared_dir.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

std::string le(std::uint64_t value, std::size_t bytes, bool is_swapped) {
  std::string out;
  for (std::size_t i = 0; i < bytes; ++i) {
    out += static_cast<char>(value >> (8 * (is_swapped ? bytes - 1 - i : i)) & 0xFFU);
  }
  return out;
}

/// A file as some writer or other makes it: any scalars in any order, names known and unknown.
std::string random_file(std::mt19937& engine, std::size_t vertices, std::size_t faces) {
  const auto random = [&](std::uint32_t below) { return static_cast<std::uint32_t>(engine()) % below; };
  const bool is_big = random(3) == 0;
  std::string text = is_big ? "ply\nformat binary_big_endian 1.0\n" : "ply\nformat binary_little_endian 1.0\n";
  constexpr std::array<std::pair<const char*, std::size_t>, 8> kTypes{
      {{"float", 4}, {"double", 8}, {"uchar", 1}, {"char", 1}, {"ushort", 2}, {"short", 2}, {"int", 4}, {"uint", 4}}};
  struct Property {
    std::size_t type;
  };
  std::vector<Property> properties;
  text += "element vertex " + std::to_string(vertices) + "\n";
  const auto state = [&](const std::string& name, std::size_t type) {
    text += std::string("property ") + kTypes[type].first + ' ' + name + '\n';
    properties.push_back({type});
  };
  const auto group = [&](std::initializer_list<const char*> names, std::size_t usual) {
    const std::size_t type = random(3) == 0 ? random(8) : usual;
    for (const char* name : names) {
      if (random(8) == 0) {
        state("extra" + std::to_string(random(3)), random(8));
      }
      if (random(30) != 0) {
        state(name, random(20) == 0 ? random(8) : type);
      }
    }
  };
  group({"x", "y", "z"}, 0);
  if (random(2) == 0) {
    group({"nx", "ny", "nz"}, 0);
  }
  if (random(2) == 0) {
    group({"red", "green", "blue"}, 2);
  }
  if (random(3) == 0) {
    group({"s", "t"}, 0);
  }
  text += "element face " + std::to_string(faces) + "\n";
  const bool has_flag = random(4) == 0;
  text += has_flag ? "property uchar flag\n" : "";
  text += std::string("property list ") + (random(10) == 0 ? "int" : "uchar") + (random(2) == 0 ? " int" : " uint") + " vertex_indices\n";
  const bool has_wide_count = text.find("list int") != std::string::npos;
  const bool has_quality = random(4) == 0;
  text += has_quality ? "property float quality\n" : "";
  text += "end_header\n";
  for (std::size_t i = 0; i < vertices; ++i) {
    for (const Property& property : properties) {
      const double value = static_cast<double>(random(200)) / (property.type < 2 ? 7.0 : 1.0);
      const std::uint64_t raw = property.type == 0   ? std::bit_cast<std::uint32_t>(static_cast<float>(value))
                                : property.type == 1 ? std::bit_cast<std::uint64_t>(value)
                                                     : static_cast<std::uint64_t>(value);
      text += le(raw, kTypes[property.type].second, is_big);
    }
  }
  for (std::size_t f = 0; f < faces; ++f) {
    const bool is_odd = random(2000) == 0;
    const std::size_t corners = is_odd ? random(6) : 3;
    text += has_flag ? std::string(1, static_cast<char>(f)) : "";
    text += le(corners, has_wide_count ? 4 : 1, is_big);
    for (std::size_t c = 0; c < corners; ++c) {
      text += le(random(4000) == 0 ? static_cast<std::uint32_t>(-1) : random(static_cast<std::uint32_t>(vertices)), 4, is_big);
    }
    text += has_quality ? le(std::bit_cast<std::uint32_t>(0.5F), 4, is_big) : "";
  }
  if (random(20) == 0) {
    text += "x";
  }
  return text;
}

TEST(PlyDirect, EqualsTheGeneralWayOnRandomFiles) {
  std::mt19937 engine(17);
  int plain = 0;
  for (int round = 0; round < 1500 && !testing::Test::HasFailure(); ++round) {
    SCOPED_TRACE(round);
    std::string text = random_file(engine, 1 + engine() % 50, engine() % 80);
    if (round % 4 == 3) {  // damage
      for (int i = 0; i < 3; ++i) {
        text[engine() % text.size()] = static_cast<char>(engine());
      }
    }
    if (round % 16 == 15) {
      text.resize(engine() % text.size());
    }
    plain += read_plain_ply(ByteSource(text), false, 2) ? 1 : 0;
    expect_same(parse_ply(text, "m.ply"), parse_any_ply(text, "m.ply"));
  }
  EXPECT_GT(plain, 300);
}

TEST(PlyDirect, AFileReadByThreadsEqualsItsBytes) {
  const TemporaryFolder folder;
  std::mt19937 engine(18);
  int plain = 0;
  for (int round = 0; round < 8 && !testing::Test::HasFailure(); ++round) {
    const std::string text = random_file(engine, 150'000, round % 2 == 0 ? 200'000 : 0);
    folder.write("m.ply", text);
    const auto expected = parse_any_ply(text, (folder.path / "m.ply").string());
    for (const int threads : {1, 2, 3, 7}) {
      expect_same(load_mesh_file(folder.path / "m.ply", {.transparency_is_tr = false, .adjust = {}, .threads = threads}), expected);
    }
    plain += read_plain_ply(*ByteSource::open(folder.path / "m.ply"), false, 2) ? 1 : 0;
  }
  EXPECT_GT(plain, 1);
}

TEST(PlyDirect, AMeshForDrawingIsTheSameWhateverItsWay) {
  const TemporaryFolder folder;
  std::mt19937 engine(19);
  int plain = 0;
  for (int round = 0; round < 60 && !testing::Test::HasFailure(); ++round) {
    const std::size_t scale = round < 50 ? 1 : 400;
    const std::string text = random_file(engine, (10 + engine() % 100) * scale, engine() % 160 * scale);
    const auto general = parse_any_ply(text, "m.ply");
    const auto sorted = read_plain_ply(ByteSource(text), true, 3);
    if (general && sorted) {
      ++plain;
      for (const bool recompute : {false, true}) {
        const NormalOptions options{.recompute = recompute};
        expect_same(build_plain(*sorted, options, 3), *build_general(SourceMesh(*general), options, 1));
      }
    }
  }
  EXPECT_GT(plain, 15);
}

TEST(PlyDirect, EqualsTheGeneralWayOnAllAssets) {
  LUSTRO_REQUIRE_SHARED();
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(shared_dir() / "assets")) {
    if (entry.path().extension() == ".ply") {
      SCOPED_TRACE(entry.path());
      const auto bytes = good(read_file(entry.path()));
      expect_same(load_mesh_file(entry.path()), parse_any_ply(bytes.view(), entry.path().string()));
      ++files;
    }
  }
  EXPECT_GT(files, 10);
}

TEST(PlyDirect, AHeaderLongerThanItsHeadIsLeftToTheGeneralWay) {
  std::string text = "ply\nformat binary_little_endian 1.0\n";
  for (int i = 0; i < 3000; ++i) {
    text += "comment a line of about thirty bytes\n";
  }
  text +=
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nelement face 0\nproperty list uchar int "
      "vertex_index\nend_header\n";
  text += std::string(12, '\0');
  EXPECT_FALSE(read_plain_ply(ByteSource(text), false, 1).has_value());
  EXPECT_EQ(good(parse_ply(text, "m")).positions.size(), 1U);
}

}  // namespace
}  // namespace lustro
