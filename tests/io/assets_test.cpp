// Every mesh of the shared test assets, with the counts that their README states.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "io/io_testing.hpp"
#include "lustro/scene.hpp"
#include "shared_dir.hpp"

namespace lustro {
namespace {

struct Row {
  std::string file;
  std::size_t triangles = 0;
  std::size_t vertices = 0;
};

// The first two rows state what a reader counts that does not know comments among the data, and the README calls both files `not standard`: 0 /
// 1 for the PLY (it stops at the comment behind the first vertex), 5 / 15 for the STL (355 bytes of text, taken as binary: (355 - 84) / 50
// facets). Both texts hold one triangle, and that is what we read. Of the glTF file we keep the vertices that are drawn.
const std::map<std::string, Row> kReadOtherwise{
    {"ply/online3dviewer/single_triangle_with_comments.ply", {"", 1, 3}},
    {"stl/online3dviewer/single_triangle_with_comments.stl", {"", 1, 3}},
    {"gltf/MeshPrimitiveModes/glTF/MeshPrimitiveModes.gltf", {"", 16, 21}},  // 28 vertices belong to points and lines
};

std::vector<Row> stated_rows() {
  std::ifstream readme(shared_dir() / "assets" / "README.md");
  const std::regex pattern(R"(\| `((?:obj|ply|stl|gltf|malformed)/[^`]+)` \|[^|]*\| (\d+) / (\d+) \|.*)");
  std::vector<Row> rows;
  for (std::string line; std::getline(readme, line);) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) {
      rows.push_back({match[1], std::stoul(match[2]), std::stoul(match[3])});
    }
  }
  return rows;
}

TEST(Assets, EveryMeshHasTheCountsThatItsReadmeStates) {
  LUSTRO_REQUIRE_SHARED();
  const std::vector<Row> rows = stated_rows();
  ASSERT_GE(rows.size(), 130U);
  for (Row row : rows) {
    SCOPED_TRACE(row.file);
    if (const auto known = kReadOtherwise.find(row.file); known != kReadOtherwise.end()) {
      row.triangles = known->second.triangles;
      row.vertices = known->second.vertices;
    }
    const Result<SourceMesh> mesh = load_mesh_file(shared_dir() / "assets" / row.file);
    ASSERT_TRUE(mesh) << mesh.error().text();
    EXPECT_EQ(mesh->stated_triangle_count(), row.triangles);
    EXPECT_EQ(mesh->positions.size(), row.vertices);
  }
}

TEST(Assets, EveryMeshFileIsInTheReadme) {  // so that the test above sees all of them
  LUSTRO_REQUIRE_SHARED();
  std::map<std::string, int> stated;
  for (const Row& row : stated_rows()) {
    ++stated[row.file];
  }
  const std::filesystem::path root = shared_dir() / "assets";
  for (const char* folder : {"obj", "ply", "stl", "gltf"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
      const std::string name = entry.path().lexically_relative(root).string();
      const std::string extension = entry.path().extension().string();
      if (extension == ".obj" || extension == ".ply" || extension == ".stl" || extension == ".STL" || extension == ".gltf" ||
          extension == ".glb") {
        EXPECT_EQ(stated[name], 1) << name;
      }
    }
  }
}

TEST(Assets, EveryArrayOfEveryMeshFitsTheOthers) {
  LUSTRO_REQUIRE_SHARED();
  for (const Row& row : stated_rows()) {
    SCOPED_TRACE(row.file);
    const Result<SourceMesh> mesh = load_mesh_file(shared_dir() / "assets" / row.file);
    ASSERT_TRUE(mesh);
    const std::size_t faces = mesh->face_count();
    const std::size_t corners = mesh->corner_position.size();
    EXPECT_EQ(mesh->face_begin.back(), corners);
    for (const auto* per_face : {&mesh->face_smoothing, &mesh->face_material, &mesh->face_object}) {
      EXPECT_TRUE(per_face->empty() || per_face->size() == faces);
    }
    for (const auto* per_corner : {&mesh->corner_uv, &mesh->corner_normal}) {
      EXPECT_TRUE(per_corner->empty() || per_corner->size() == corners);
    }
    EXPECT_TRUE(mesh->colors.empty() || mesh->colors.size() == mesh->positions.size());
    EXPECT_TRUE(mesh->face_colors.empty() || mesh->face_colors.size() == faces);
  }
}

TEST(Assets, EveryGltfFileIsAlsoASceneWithAsManyTriangles) {
  LUSTRO_REQUIRE_SHARED();
  int seen = 0;
  for (const Row& row : stated_rows()) {
    if (!row.file.starts_with("gltf/")) {
      continue;
    }
    SCOPED_TRACE(row.file);
    ++seen;
    const Result<LoadedScene> loaded = load_scene(shared_dir() / "assets" / row.file);
    ASSERT_TRUE(loaded) << loaded.error().text();
    std::size_t triangles = 0;
    for (const Object& object : loaded->scene.objects) {
      triangles += object.mesh->triangles.size();
    }
    EXPECT_EQ(triangles, row.triangles);
  }
  EXPECT_GT(seen, 30);
}

TEST(Assets, TheDuckIsTheSameHoweverItIsPacked) {
  LUSTRO_REQUIRE_SHARED();
  const auto load = [](const char* name) { return load_mesh_file(shared_dir() / "assets" / "gltf" / "Duck" / name).value(); };
  const SourceMesh duck = load("glTF/Duck.gltf");
  EXPECT_EQ(load("glTF-Binary/Duck.glb").positions, duck.positions);
  const auto bounds = [](const SourceMesh& mesh) { return build_mesh(mesh)->mesh.bounds(); };
  for (const char* packed : {"glTF-Draco/Duck.gltf", "glTF-Quantized/Duck.gltf"}) {  // whose positions are rounded
    const Bounds box = bounds(load(packed));
    const double size = length(bounds(duck).upper - bounds(duck).lower);
    EXPECT_LT(length(box.lower - bounds(duck).lower), 1e-3 * size) << packed;
    EXPECT_LT(length(box.upper - bounds(duck).upper), 1e-3 * size) << packed;
  }
}

TEST(Assets, TheSameMeshInTwoEncodingsIsTheSame) {
  LUSTRO_REQUIRE_SHARED();
  const auto load = [](const char* name) { return load_mesh_file(shared_dir() / "assets" / name).value(); };
  const SourceMesh ascii = load("ply/stanford_bunny/bun_zipper.ply");
  const SourceMesh big = load("ply/stanford_bunny/bun_zipper_be.ply");
  EXPECT_EQ(ascii.positions, big.positions);
  EXPECT_EQ(ascii.corner_position, big.corner_position);
  EXPECT_EQ(ascii.format, "PLY (ascii)");
  EXPECT_EQ(big.format, "PLY (binary, big endian)");

  const SourceMesh text = load("ply/online3dviewer/cube_rgb.ply");
  const SourceMesh binary = load("ply/online3dviewer/cube_rgb_binary.ply");
  EXPECT_EQ(text.positions, binary.positions);
  EXPECT_EQ(text.uvs, binary.uvs);
  EXPECT_EQ(text.corner_uv, binary.corner_uv);
  EXPECT_EQ(text.face_colors, binary.face_colors);
  EXPECT_EQ(binary.face_colors.front(), (Vec3f{204.0F / 255, 0, 0}));
}

TEST(Assets, NoMeshOfTheFeaturesWarnsWithoutAReason) {
  LUSTRO_REQUIRE_SHARED();
  for (const char* name :
       {"obj/armadillo/armadillo.obj", "obj/cornell_box/CornellBox-Original.obj", "obj/features/negative_indices.obj",
        "obj/obj2gltf/box-groups/box-groups.obj", "obj/online3dviewer/cube with white spaces.obj", "obj/skull/skull.obj",
        "obj/spot/spot_triangulated.obj", "obj/utah_teapot/utah_teapot.obj", "ply/features/crlf.ply", "ply/features/metadata.ply",
        "ply/lucy/lucy_100k.ply", "ply/stanford_bunny/bun_zipper.ply", "stl/features/unit_cube.STL", "stl/features/multibody.stl",
        "stl/stanford_bunny/bunny.stl", "malformed/empty.obj", "malformed/empty.ply", "malformed/empty.stl"}) {
    const SourceMesh mesh = load_mesh_file(shared_dir() / "assets" / name).value();
    EXPECT_THAT(texts(mesh.notes), testing::IsEmpty()) << name;
  }
}

TEST(Assets, TexturesOfTheModelsAreFoundAndRead) {
  LUSTRO_REQUIRE_SHARED();
  struct Expected {
    const char* name;
    std::size_t textures;
    std::vector<std::string> notes;
  };
  const std::vector<Expected> models{{"obj/armchair/armchair.obj", 2, {}},
                                     {"obj/pizza/pizza.obj", 1, {}},
                                     {"obj/spider/spider.obj", 5, {}},
                                     {"obj/online3dviewer/texture_parameters.obj", 4, {}},
                                     {"obj/online3dviewer/two_materials_same_texture.obj", 2, {}},
                                     {"obj/obj2gltf/box-textured/box-textured.obj", 1, {}}};
  for (const Expected& expected : models) {
    const SourceMesh mesh = load_mesh_file(shared_dir() / "assets" / expected.name).value();
    std::size_t count = 0;
    for (const Material& material : mesh.materials) {
      count += material.textures.diffuse && material.textures.diffuse->texture != nullptr ? 1U : 0U;
    }
    EXPECT_EQ(count, expected.textures) << expected.name;
    EXPECT_THAT(texts(mesh.notes), testing::ElementsAreArray(expected.notes)) << expected.name;
  }
}

}  // namespace
}  // namespace lustro
