// Written meshes: what is read back is what was written, bit for bit where the format holds it.
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "io/mesh_writers.hpp"
#include "io/obj.hpp"
#include "io/ply.hpp"
#include "io/stl.hpp"
#include "io_testing.hpp"
#include "lustro/mesh_file.hpp"
#include "lustro/scene.hpp"
#include "temporary_folder.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Any finite float: tiny, huge, negative zero.
float any_float(std::mt19937& random) {
  for (;;) {
    const auto bits = static_cast<std::uint32_t>(random());
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    if (std::isfinite(x)) {
      return x;
    }
  }
}

Mesh any_mesh(std::uint32_t seed, bool has_uvs, bool has_colors) {
  std::mt19937 random(seed);
  Mesh mesh;
  for (int v = 0; v < 100; ++v) {
    mesh.positions.push_back({any_float(random), any_float(random), any_float(random)});
    mesh.normals.push_back({any_float(random), any_float(random), any_float(random)});
    if (has_uvs) {
      mesh.uvs.push_back({any_float(random), any_float(random)});
    }
    if (has_colors) {
      const auto byte = [&random] { return static_cast<float>(random() % 256) / 255.0F; };
      mesh.colors.push_back({byte(), byte(), byte()});
    }
  }
  mesh.positions[0] = {-0.0F, std::numeric_limits<float>::denorm_min(), std::numeric_limits<float>::max()};
  for (int t = 0; t < 200; ++t) {
    mesh.triangles.push_back(
        {static_cast<std::uint32_t>(random() % 100), static_cast<std::uint32_t>(random() % 100), static_cast<std::uint32_t>(random() % 100)});
  }
  return mesh;
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

void expect_same(const SourceMesh& read, const Mesh& written) {
  expect_consistent(read);
  EXPECT_TRUE(same_bits(read.positions, written.positions));
  EXPECT_TRUE(same_bits(read.normals, written.normals));
  EXPECT_TRUE(same_bits(read.uvs, written.uvs));
  EXPECT_TRUE(same_bits(read.colors, written.colors));
  ASSERT_EQ(read.face_count(), written.triangles.size());
  for (std::size_t t = 0; t < written.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t corner = 3 * t + i;
      ASSERT_EQ(read.corner_position[corner], written.triangles[t][i]);
      ASSERT_TRUE(read.corner_normal.empty() || read.corner_normal[corner] == written.triangles[t][i]);
      ASSERT_TRUE(read.corner_uv.empty() || read.corner_uv[corner] == written.triangles[t][i]);
    }
  }
}

TEST(WriteMesh, PlyAndObjAreReadBackToTheSameBits) {
  const TemporaryFolder folder;
  for (const bool has_uvs : {false, true}) {
    for (const bool has_colors : {false, true}) {
      const Mesh mesh = any_mesh(has_uvs ? 1 : 2, has_uvs, has_colors);
      for (const auto& [name, ascii] : {std::pair("a.ply", false), std::pair("a.ply", true), std::pair("a.obj", false)}) {
        const Notes notes = good(write_mesh(folder.path / name, mesh, {.ascii = ascii}));
        EXPECT_THAT(notes, IsEmpty());
        const SourceMesh read = good(load_mesh_file(folder.path / name));
        expect_same(read, mesh);
        EXPECT_THAT(read.notes, IsEmpty()) << name;
      }
    }
  }
}

TEST(WriteMesh, ObjHoldsColorsBetweenBytes) {
  Mesh mesh = any_mesh(3, false, true);
  mesh.colors[0] = {0.1234567F, 1e-9F, 0};
  expect_same(good(parse_obj(obj_bytes(mesh, "").bytes, "m.obj")), mesh);
  const MeshBytes ply = ply_bytes(mesh, false);
  EXPECT_THAT(texts(ply.notes), ElementsAre("colours are rounded to 8 bits"));
  EXPECT_NEAR(good(parse_ply(ply.bytes, "m.ply")).colors[0].x, 0.1234567F, 0.5 / 255);
}

TEST(WriteMesh, PlyIsWrittenAsItsHeaderSays) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.5F, 0}};
  mesh.colors = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.alphas = {1, 0, 1};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(ply_bytes(mesh, true).bytes,
            "ply\nformat ascii 1.0\ncomment written by Lustro\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n"
            "property list uchar int vertex_indices\nend_header\n0 0 0 255 0 0 255\n1 0 0 0 255 0 0\n0 0.5 0 0 0 255 255\n3 0 1 2\n");
}

TEST(WriteMesh, StlHoldsThePositionsOfEachCorner) {
  const Mesh mesh = any_mesh(4, false, false);
  for (const bool ascii : {false, true}) {
    const SourceMesh read = good(parse_stl(good(stl_bytes(mesh, ascii)).bytes, "m.stl"));
    expect_consistent(read);
    ASSERT_EQ(read.positions.size(), 3 * mesh.triangles.size());
    for (std::size_t i = 0; i < read.positions.size(); ++i) {
      const Vec3f& stated = mesh.positions[mesh.triangles[i / 3][i % 3]];
      ASSERT_EQ(std::memcmp(&read.positions[i], &stated, sizeof stated), 0) << i;
    }
    EXPECT_EQ(read.format, ascii ? "STL (ascii)" : "STL (binary)");
    EXPECT_THAT(read.notes, IsEmpty());
  }
}

TEST(WriteMesh, StlStatesTheNormalOfTheFacet) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 4}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 0, 1}};
  EXPECT_EQ(good(stl_bytes(mesh, true)).bytes,
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 3 0\nendloop\nendfacet\n"
            "facet normal 1 0 0\nouter loop\nvertex 0 0 0\nvertex 0 3 0\nvertex 0 0 4\nendloop\nendfacet\n"
            "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 2 0 0\nendloop\nendfacet\nendsolid\n");
}

Mesh two_materials() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 2}, {0, 2, 1}};
  mesh.triangle_material = {1, 0, 0};
  Material red;
  red.name = "red paint";
  red.ambient = {{0.1F, 0.2F, 0.3F}, ColorSpace::encoded};
  red.diffuse = {{0.8F, 0, 0}, ColorSpace::encoded};
  red.specular = {{0.5F, 0.25F, 2}, ColorSpace::encoded};
  red.emission = {{0, 0.5F, 0}, ColorSpace::encoded};
  red.transmission = {{0.5F, 1, 1}, ColorSpace::encoded};
  red.shininess = 33.3F;
  red.opacity = 0.75F;
  red.refraction = 1.5F;
  red.sharpness = 100;
  red.halo = true;
  red.illumination = 1;
  red.lighting = Lighting::lambert;
  TextureMap map;
  map.statement = "map_Kd";
  map.file = "wood floor.png";
  map.blend_u = map.blend_v = false;
  map.color_correction = map.clamp = true;
  map.boost = 2;
  map.bump_multiplier = 0.5F;
  map.base = 0.1F;
  map.gain = 0.9F;
  map.offset = {1, 2, 3};
  map.scale = {4, 5, 6};
  map.turbulence = {0, 0, 0.5F};
  map.texture_resolution = 512;
  map.channel = 'r';
  map.type = "sphere";
  red.maps = {map};
  Material plain;
  plain.name = "plain";
  plain.illumination = 2;
  for (Color* color : {&plain.ambient, &plain.diffuse, &plain.specular, &plain.emission, &plain.transmission}) {
    color->space = ColorSpace::encoded;
  }
  mesh.materials = {red, plain};
  return mesh;
}

TEST(WriteMesh, MaterialsComeBackWithAllTheirStatements) {
  const TemporaryFolder folder;
  folder.write("wood floor.png", "");
  const Mesh mesh = two_materials();
  EXPECT_THAT(good(write_mesh(folder.path / "m.obj", mesh)), IsEmpty());
  const SourceMesh read = good(load_mesh_file(folder.path / "m.obj"));
  ASSERT_EQ(read.materials.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    Material stated = read.materials[i];
    stated.textures = mesh.materials[i].textures;  // what a loaded map adds
    for (TextureMap& map : stated.maps) {
      EXPECT_EQ(map.library, "m.mtl");
      map.library.clear();
    }
    stated.transmission.space = mesh.materials[i].transmission.space;
    stated.emission.space = mesh.materials[i].emission.space;
    EXPECT_EQ(stated, mesh.materials[i]) << i;
  }
  EXPECT_THAT(read.face_material, ElementsAre(1, 0, 0));
}

TEST(WriteMesh, MapsAreNamedFromTheWrittenFile) {
  const TemporaryFolder folder;
  folder.write("in/maps/wood floor.png", "");
  std::filesystem::create_directories(folder.path / "out");
  Mesh mesh = two_materials();
  mesh.materials[0].maps[0].file = "maps\\wood floor.png";
  EXPECT_THAT(good(write_mesh(folder.path / "out" / "m.obj", mesh, {.texture_folder = folder.path / "in"})), IsEmpty());
  EXPECT_EQ(good(load_mesh_file(folder.path / "out" / "m.obj")).materials.at(0).maps.at(0).file, "../in/maps/wood floor.png");
}

TEST(WriteMesh, NamesOfMaterialsFitOnALineAndDiffer) {
  std::vector<Material> materials(5);
  materials[0].name = " a # b\nnewmtl c\\";
  materials[1].name = "x";
  materials[2].name = "x";
  materials[3].name = "";
  EXPECT_THAT(material_names(materials), ElementsAre("a _ b_newmtl c_", "x", "x_2", "material", "material_2"));
}

TEST(WriteMesh, LinearColorsAreEncodedForMtl) {
  Mesh mesh = two_materials();
  mesh.materials[0].diffuse = {{0.2140411F, 0, 1}, ColorSpace::linear};
  EXPECT_THAT(mtl_bytes(mesh, [](const std::string& name) { return name; }).bytes, HasSubstr("Kd 0.4999"));
}

TEST(WriteMesh, WhatAFormatCannotHoldIsSaid) {
  const TemporaryFolder folder;
  Mesh mesh = two_materials();
  mesh.uvs = mesh.uvs1 = {{0, 0}, {1, 0}, {0, 1}};
  mesh.alphas = {1, 0.5F, 1};
  mesh.materials[1].lighting = Lighting::blinn_phong;
  const auto said = [&](const char* name) {
    std::vector<std::string> messages;
    for (const Note& note : good(write_mesh(folder.path / name, mesh))) {
      EXPECT_EQ(note.where, (folder.path / name).string());
      messages.push_back(note.message);
    }
    return messages;
  };
  EXPECT_THAT(said("m.ply"), ElementsAre("colours are rounded to 8 bits", "PLY holds no materials: 2 are left out",
                                         "PLY holds one set of texture coordinates: the second is left out"));
  EXPECT_THAT(said("m.STL"), ElementsAre("STL holds triangles alone: texture coordinates, opacities, materials are left out"));
  EXPECT_THAT(said("m.obj"), ElementsAre("OBJ holds no opacities of vertices: they are left out",
                                         "OBJ holds one set of texture coordinates: the second is left out",
                                         "MTL does not tell Phong, Blinn and GGX apart: the lighting of 1 materials is left out"));
}

TEST(WriteMesh, AMeshThatContradictsItselfIsNotWritten) {
  const TemporaryFolder folder;
  const auto refused = [&](const auto& spoil) {
    Mesh mesh = two_materials();
    spoil(mesh);
    const Error error = bad(write_mesh(folder.path / "m.ply", mesh));
    EXPECT_EQ(error.kind, ErrorKind::usage);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "m.ply"));
    return error.message;
  };
  EXPECT_EQ(refused([](Mesh& m) { m.triangles[1][2] = 3; }), "a triangle names vertex 3 of 3");
  EXPECT_EQ(refused([](Mesh& m) { m.triangle_material[1] = 2; }), "a triangle names material 2 of 2");
  EXPECT_EQ(refused([](Mesh& m) { m.triangle_material.pop_back(); }), "3 triangles, and materials for 2");
  EXPECT_EQ(refused([](Mesh& m) { m.normals.resize(2); }), "an attribute of the mesh does not have one value for each of the 3 vertices");
}

TEST(WriteMesh, OtherExtensionsAreUnsupportedAndMissingFoldersAreErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(bad(write_mesh(folder.path / "m.off", two_materials())).kind, ErrorKind::unsupported);
  EXPECT_EQ(bad(write_mesh(folder.path / "no" / "m.ply", two_materials())).kind, ErrorKind::io);
}

}  // namespace
}  // namespace lustro
