// Scene files and bare meshes with their meshes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <mutex>
#include <set>

#include "io_testing.hpp"
#include "lustro/image.hpp"
#include "lustro/scene.hpp"
#include "shared_dir.hpp"
#include "temporary_folder.hpp"
#include "texture/texture.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Two facets that share an edge, as an ASCII STL: one in the plane z = 0, the other ends at (0, y, z).
std::string facets(double z, double y) {
  std::string text = "solid s\n";
  const auto facet = [&](const std::string& a, const std::string& b, const std::string& c) {
    text += "facet normal 0 0 0\nouter loop\nvertex " + a + "\nvertex " + b + "\nvertex " + c + "\nendloop\nendfacet\n";
  };
  facet("0 0 0", "1 0 0", "0 -1 0");
  facet("1 0 0", "0 0 0", "0 " + std::to_string(y) + " " + std::to_string(z));
  return text + "endsolid s\n";
}

class LoadScene : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("lustro_load_scene_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "meshes");
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  /// The message of a failure, without the folder.
  std::string error_of(const fs::path& file) const {
    const auto scene = load_scene(file);
    return scene ? "" : without_folder(scene.error().text());
  }
  std::string without_folder(std::string text) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

  fs::path folder_;
};

TEST_F(LoadScene, MeshesLieRelativeToTheSceneFile) {
  write("meshes/a.obj", kTriangle);
  const auto file = write("scene.json", R"({"objects": [{"mesh": "meshes/a.obj"}, {"mesh": "primitive:cube"}]})");
  const auto loaded = load_scene(file);
  ASSERT_TRUE(loaded) << loaded.error().text();
  ASSERT_EQ(loaded->scene.objects.size(), 2U);
  EXPECT_EQ(loaded->scene.objects[0].mesh->triangles.size(), 1U);
  EXPECT_EQ(loaded->scene.objects[1].mesh->triangles.size(), 12U);
  EXPECT_EQ(loaded->scene.objects[0].source, "meshes/a.obj");
  EXPECT_FALSE(loaded->scene.shading.two_sided);
  EXPECT_TRUE(loaded->notes.empty());
}

TEST_F(LoadScene, AnAbsolutePathStands) {
  const auto mesh = write("meshes/a.obj", kTriangle);
  const auto file = write("scene.json", R"({"objects": [{"mesh": ")" + mesh.string() + R"("}]})");
  EXPECT_EQ(load_scene(file)->scene.objects[0].mesh->triangles.size(), 1U);
}

TEST_F(LoadScene, ABareMeshIsTheSceneWithThatObjectLitOnBothSides) {
  const auto file = write("a.obj", kTriangle);
  const auto loaded = load_scene(file);
  ASSERT_TRUE(loaded) << loaded.error().text();
  ASSERT_EQ(loaded->scene.objects.size(), 1U);
  EXPECT_EQ(loaded->scene.objects[0].source, "a.obj");
  EXPECT_EQ(loaded->scene.objects[0].mesh->triangles.size(), 1U);
  EXPECT_TRUE(loaded->scene.shading.two_sided);
  EXPECT_FALSE(loaded->scene.lights);
  EXPECT_FALSE(loaded->scene.camera.eye);
}

TEST_F(LoadScene, ScenesAndMeshesAreToldApartByContent) {
  const auto scene = write("scene.obj", "\xef\xbb\xbf \n\t{\"objects\": [{\"mesh\": \"primitive:plane\"}]}");
  EXPECT_EQ(load_scene(scene)->scene.objects[0].mesh->triangles.size(), 2U);
  const auto mesh = write("mesh.txt", kTriangle);
  EXPECT_EQ(load_scene(mesh)->scene.objects[0].mesh->triangles.size(), 1U);
  EXPECT_EQ(error_of(write("empty.json", "")), "empty.json:1:1: broken JSON: unexpected end of input, expected a value");
  EXPECT_EQ(error_of(write("list.json", "[]")), "list.json: found an empty list, expected a table {\"objects\": [...]}");
  EXPECT_TRUE(load_scene(write("a.gltf", R"({"asset": {"version": "2.0"}})"))->scene.objects.empty());
  EXPECT_TRUE(load_scene(write("b.json", R"({"asset": {"version": "2.0"}})"))->scene.objects.empty());
}

TEST_F(LoadScene, AFileThatTwoObjectsNameIsLoadedOnce) {
  write("meshes/a.obj", kTriangle);
  write("meshes/b.obj", kTriangle);
  const auto file = write("scene.json", R"({"objects": [{"mesh": "meshes/a.obj"}, {"mesh": "./meshes/../meshes/a.obj"}, {"mesh": "meshes/b.obj"},
      {"mesh": "primitive:torus:8"}, {"mesh": "primitive:torus:8"}, {"mesh": "primitive:torus:9"}]})");
  const auto loaded = load_scene(file);
  ASSERT_TRUE(loaded) << loaded.error().text();
  const auto& objects = loaded->scene.objects;
  EXPECT_EQ(objects[0].mesh, objects[1].mesh);
  EXPECT_NE(objects[0].mesh, objects[2].mesh);
  EXPECT_EQ(objects[3].mesh, objects[4].mesh);
  EXPECT_NE(objects[3].mesh, objects[5].mesh);
}

TEST_F(LoadScene, ObjectsThatHaveAMeshKeepIt) {
  Scene scene;
  const auto mesh = std::make_shared<const Mesh>();
  scene.objects.push_back({.source = "nowhere.obj", .mesh = mesh});
  ASSERT_TRUE(load_meshes(scene, folder_));
  EXPECT_EQ(scene.objects[0].mesh, mesh);
}

TEST_F(LoadScene, NormalsFollowTheSceneShading) {
  write("quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nvn 1 0 0\nf 1//1 2//1 3//1\nf 1//1 3//1 4//1\n");
  const auto normals = [&](const std::string& shading) {
    const auto file = write("scene.json", R"({"shading": {)" + shading + R"(}, "objects": [{"mesh": "quad.obj"}]})");
    const auto loaded = load_scene(file);
    EXPECT_TRUE(loaded) << loaded.error().text();
    return loaded->scene.objects[0].mesh->normals;
  };
  const auto stated = normals("");
  for (const Vec3f& normal : stated) {
    EXPECT_EQ(normal, (Vec3f{1, 0, 0}));  // the file's win
  }
  EXPECT_EQ(stated.size(), 4U);
  EXPECT_EQ(normals(R"("crease": 0)").size(), 4U);  // nothing to make
  const auto angle = normals(R"("recompute_normals": true)");
  const auto area = normals(R"("recompute_normals": true, "vertex_normals": "area")");
  EXPECT_EQ(angle.size(), 4U);
  EXPECT_NE(angle[0], (Vec3f{1, 0, 0}));
  EXPECT_NE(angle[0], area[0]);
  EXPECT_EQ(normals(R"("recompute_normals": true, "crease": 5)").size(), 6U);  // a sharp edge doubles its two vertices
}

TEST_F(LoadScene, StlEdgesAreSharpBeyondFortyDegreesUnlessTheSceneSaysOtherwise) {
  write("60.stl", facets(0.8660254, 0.5));
  write("30.stl", facets(0.5, 0.8660254));
  const auto vertices = [&](const std::string& mesh, const std::string& shading) {
    const auto file = write("scene.json", R"({"shading": {)" + shading + R"(}, "objects": [{"mesh": ")" + mesh + R"("}]})");
    const auto loaded = load_scene(file);
    EXPECT_TRUE(loaded) << loaded.error().text();
    return loaded->scene.objects[0].mesh->positions.size();
  };
  EXPECT_EQ(vertices("60.stl", ""), 6U);
  EXPECT_EQ(vertices("30.stl", ""), 4U);
  EXPECT_EQ(vertices("60.stl", R"("crease": 180)"), 4U);
  EXPECT_EQ(vertices("30.stl", R"("crease": 20)"), 6U);
}

TEST_F(LoadScene, ErrorsNameTheFileTheObjectAndTheMesh) {
  write("bad.obj", "v 0 0 0\nf 1 2 99\n");
  const auto scene_of = [&](const std::string& mesh) {
    return write("scene.json", R"({"objects": [{"mesh": "primitive:cube"}, {"mesh": ")" + mesh + R"("}]})");
  };
  EXPECT_TRUE(error_of(scene_of("bad.obj")).starts_with("scene.json: objects[1].mesh: bad.obj:2: ")) << error_of(scene_of("bad.obj"));
  EXPECT_TRUE(error_of(scene_of("missing.ply")).starts_with("scene.json: objects[1].mesh: missing.ply: ")) << error_of(scene_of("missing.ply"));
  EXPECT_TRUE(error_of(scene_of("primitive:spere")).starts_with("scene.json: objects[1].mesh: primitive:spere: "))
      << error_of(scene_of("primitive:spere"));
  EXPECT_TRUE(error_of(scene_of("primitive:sphere:2")).starts_with("scene.json: objects[1].mesh: primitive:sphere:2: "))
      << error_of(scene_of("primitive:sphere:2"));
  EXPECT_EQ(load_scene(scene_of("missing.ply")).error().kind, ErrorKind::io);
  EXPECT_EQ(load_scene(scene_of("bad.obj")).error().kind, ErrorKind::malformed);
  EXPECT_EQ(load_scene(scene_of("meshes")).error().kind, ErrorKind::io);  // a folder
  EXPECT_TRUE(error_of(folder_ / "bad.obj").starts_with("bad.obj:2: ")) << error_of(folder_ / "bad.obj");
  EXPECT_EQ(load_scene(folder_ / "nothing.json").error().kind, ErrorKind::io);
  EXPECT_EQ(load_scene(folder_ / "nothing.obj").error().kind, ErrorKind::io);
  EXPECT_EQ(load_scene(folder_).error().kind, ErrorKind::io);
  Scene scene;
  scene.objects.resize(1);
  EXPECT_EQ(load_meshes(scene, folder_).error().text(), "objects[0].mesh: is missing, expected a mesh file or primitive:NAME");
}

TEST_F(LoadScene, NotesComeOnceEachWithTheirFile) {
  write("lines.obj", std::string(kTriangle) + "l 1 2\n");
  write("more.obj", std::string(kTriangle) + "l 1 2\n");
  const auto file = write("scene.json", R"({"lights": [{"type": "point", "cutoff": 20}],
      "objects": [{"mesh": "lines.obj"}, {"mesh": "lines.obj"}, {"mesh": "more.obj"}]})");
  const auto loaded = load_scene(file);
  ASSERT_TRUE(loaded) << loaded.error().text();
  ASSERT_EQ(loaded->notes.size(), 3U);
  EXPECT_EQ(without_folder(loaded->notes[0].text()), "scene.json: lights[0].cutoff: changes nothing with a point light");
  EXPECT_TRUE(without_folder(loaded->notes[1].where).starts_with("lines.obj")) << loaded->notes[1].text();
  EXPECT_TRUE(without_folder(loaded->notes[2].where).starts_with("more.obj")) << loaded->notes[2].text();
}

TEST(ExampleScenes, LoadWithoutANote) {
  int loaded = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(LUSTRO_SOURCE_DIR) / "examples" / "scenes")) {
    const auto scene = load_scene(entry.path());
    ASSERT_TRUE(scene) << scene.error().text();
    EXPECT_TRUE(scene->notes.empty()) << scene->notes[0].text();
    for (const Object& object : scene->scene.objects) {
      EXPECT_FALSE(object.mesh->triangles.empty()) << object.source;
    }
    ++loaded;
  }
  EXPECT_GE(loaded, 5);
}

TEST(LoadSceneAssets, EveryRealMeshIsAScene) {
  LUSTRO_REQUIRE_SHARED();
  int loaded = 0;
  for (const char* folder : {"obj", "ply", "stl"}) {
    for (const auto& entry : fs::recursive_directory_iterator(shared_dir() / "assets" / folder)) {
      const std::string extension = entry.path().extension().string();
      if (!entry.is_regular_file() || fs::file_size(entry.path()) > 3000000 ||
          (extension != ".obj" && extension != ".ply" && extension != ".stl")) {
        continue;
      }
      const auto scene = load_scene(entry.path());
      EXPECT_TRUE(scene) << scene.error().text();
      ++loaded;
    }
  }
  EXPECT_GT(loaded, 10);
}

TEST(LoadSceneTextures, TexturesOfASceneFileAreReadByItsTransfer) {
  const TemporaryFolder folder;
  Image half(1, 1, 3);
  half.pixels = {0.6F, 0.6F, 0.6F};
  ASSERT_TRUE(write_image(folder.path / "half.png", half, {.transfer = Transfer::none}));
  for (const std::string transfer : {"srgb", "none"}) {
    folder.write("scene.json", R"({"image": {"transfer": ")" + transfer + R"("}, "materials": {"m": {"textures": {"diffuse": "half.png",
      "specular": "gone.png", "bump": "half.png", "displacement": "half.png", "reflection": {"picture": "half.png"}, "object_space": true}}},
      "objects": [{"mesh": "primitive:plane", "material": "m"}, {"mesh": "primitive:cube", "material": "m"}]})");
    const LoadedScene loaded = good(load_scene(folder.path / "scene.json"));
    const MaterialTextures& textures = loaded.scene.objects[0].material->textures;
    ASSERT_TRUE(textures.diffuse && textures.diffuse->texture && textures.bump && textures.bump->texture);
    EXPECT_NEAR(textures.diffuse->texture->texel(0, 0, 0)[0], transfer == "srgb" ? 0.3185F : 0.6F, 1e-3);
    EXPECT_NEAR(textures.bump->texture->texel(0, 0, 0)[0], 0.6F, 1e-3);
    EXPECT_TRUE(textures.normal_is_object_space);
    EXPECT_FALSE(textures.specular);
    ASSERT_TRUE(textures.displacement && textures.reflection && textures.reflection->faces[0]);
    EXPECT_EQ(textures.displacement->texture, textures.bump->texture);
    EXPECT_EQ(textures.reflection->faces[0]->texture, textures.diffuse->texture);
    EXPECT_EQ(textures.reflection->shape, ReflectionShape::sphere);
    EXPECT_EQ(loaded.scene.objects[1].material->textures, textures);  // one file, read once
    ASSERT_EQ(loaded.notes.size(), 1U);
    EXPECT_THAT(loaded.notes[0].text(), testing::HasSubstr("material \"m\": specular: the texture "));
    const Error strict = load_scene(folder.path / "scene.json", {.strict = true}).error();
    EXPECT_EQ(strict.kind, ErrorKind::io);
    EXPECT_EQ(strict.text(), (folder.path / "scene.json").string() + ": material \"m\": specular: the texture \"gone.png\" is missing");
    EXPECT_EQ(parse_scene(scene_json(loaded.scene))->objects[0].material->stated_textures, loaded.scene.objects[0].material->stated_textures);
  }
}

TEST(LoadSceneTextures, ACubeHasSixPicturesAndOneThatIsMissingIsLeftOut) {
  const TemporaryFolder folder;
  Image gray(1, 1, 3);
  for (const std::string name : {"r", "l", "t", "b", "f"}) {
    gray.pixels = {name == "r" ? 1.0F : 0.0F, 0, name == "f" ? 1.0F : 0.0F};
    ASSERT_TRUE(write_image(folder.path / (name + ".png"), gray, {.transfer = Transfer::none}));
  }
  folder.write("scene.json", R"({"objects": [{"mesh": "primitive:cube", "material": {"textures": {"reflection":
    {"shape": "cube", "right": "r.png", "left": "l.png", "top": "t.png", "bottom": "b.png", "front": "f.png", "back": "k.png"}}}}]})");
  const LoadedScene loaded = good(load_scene(folder.path / "scene.json"));
  const auto& map = loaded.scene.objects[0].material->textures.reflection;
  ASSERT_TRUE(map);
  EXPECT_EQ(map->shape, ReflectionShape::cube);
  ASSERT_TRUE(map->faces[0] && map->faces[4]);
  EXPECT_EQ(map->faces[0]->texture->texel(0, 0, 0)[0], 1);
  EXPECT_EQ(map->faces[4]->texture->texel(0, 0, 0)[2], 1);
  EXPECT_FALSE(map->faces[5]);
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_EQ(loaded.notes[0].text(), "objects[0].material.textures: reflection.back: the texture \"k.png\" is missing; drawn without it");
}

/// The files that loading names, by their names in the folder, sorted.
std::vector<std::string> files_of(const TemporaryFolder& folder, const std::string& entry, int threads = 0) {
  std::mutex mutex;
  std::set<std::string> names;
  const auto on_file = [&](const fs::path& file) {
    const std::scoped_lock lock(mutex);
    names.insert(file.lexically_normal().lexically_relative(folder.path).generic_string());
  };
  static_cast<void>(good(load_scene(folder.path / entry, {.threads = threads, .on_file = on_file})));
  return {names.begin(), names.end()};
}

TEST(LoadSceneFiles, AreNamedAsTheyAreOpened) {
  const TemporaryFolder folder;
  Image gray(1, 1, 3);
  fs::create_directories(folder.path / "s/tex");
  for (const char* const name : {"s/tex/wood.png", "s/sky.png", "s/own.png", "s/never.png"}) {
    ASSERT_TRUE(write_image(folder.path / name, gray, {}));
  }
  folder.write("meshes/a.obj", "mtllib mtl/a.mtl\nmtllib mtl/gone.mtl\nusemtl m\n" + std::string(kTriangle));
  folder.write("meshes/mtl/a.mtl", "newmtl m\nmap_Kd broken.png\nmap_Ks gone.png\nmap_Ke ../../../../outside.png\n");
  folder.write("meshes/mtl/broken.png", "no picture");
  folder.write("s/b.stl", facets(1, 1));
  fs::create_symlink("b.stl", folder.path / "s/c.stl");
  folder.write("s/scene.json",
               R"({"environment": {"file": "sky.png"}, "objects": [{"mesh": "../meshes/a.obj"}, {"mesh": "b.stl"}, {"mesh": "c.stl"},
    {"mesh": "primitive:cube", "material": {"textures": {"diffuse": "own.png", "bump": "tex/wood.png"}}}]})");
  for (const int threads : {1, 4}) {
    EXPECT_THAT(files_of(folder, "s/scene.json", threads),
                testing::ElementsAre("meshes/a.obj", "meshes/mtl/a.mtl", "meshes/mtl/broken.png", "meshes/mtl/gone.mtl", "s/b.stl", "s/c.stl",
                                     "s/own.png", "s/scene.json", "s/sky.png", "s/tex/wood.png"));
  }
  EXPECT_THAT(files_of(folder, "s/b.stl"), testing::ElementsAre("s/b.stl"));
}

TEST(LoadSceneFiles, OfAGltfAreItsBuffersAndPictures) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path / "g/data");
  for (const char* const name : {"g/data/a b.png", "g/data/unused.png"}) {
    ASSERT_TRUE(write_image(folder.path / name, Image(1, 1, 3), {}));
  }
  folder.write("g/data/a.bin", std::string(60, '\0'));
  folder.write("g/a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
    "buffers": [{"uri": "data/a.bin", "byteLength": 60}], "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": "data/a%20b.png"}, {"uri": "data/unused.png"}], "textures": [{"source": 0}, {"source": 1}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}]})");
  EXPECT_THAT(files_of(folder, "g/a.gltf"), testing::ElementsAre("g/a.gltf", "g/data/a b.png", "g/data/a.bin"));
  folder.write("scene.json", R"({"objects": [{"mesh": "g/a.gltf#nodes[0]"}]})");
  EXPECT_THAT(files_of(folder, "scene.json"), testing::ElementsAre("g/a.gltf", "g/data/a b.png", "g/data/a.bin", "scene.json"));
}

TEST(LoadSceneTextures, TexturesOutsideOfTheScenesTreeAreNotRead) {
  const TemporaryFolder folder;
  Image gray(1, 1, 3);
  ASSERT_TRUE(write_image(folder.path / "secret.png", gray, {}));
  std::filesystem::create_directories(folder.path / "a/b/c");
  folder.write("a/b/c/scene.json",
               R"({"objects": [{"mesh": "primitive:cube", "material": {"name": "m", "textures": {"diffuse": "../../../secret.png"}}}]})");
  const LoadedScene loaded = good(load_scene(folder.path / "a/b/c/scene.json"));
  EXPECT_FALSE(loaded.scene.objects[0].material->textures.diffuse);
  ASSERT_EQ(loaded.notes.size(), 1U);
  EXPECT_EQ(loaded.notes[0].text(),
            "material \"m\": diffuse: the texture \"../../../secret.png\" leads out of its folder and the one around it; drawn without it");
}

}  // namespace
}  // namespace lustro
