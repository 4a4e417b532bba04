// Mesh files: which parser reads them, and where an OBJ's libraries are found.
#include <fstream>

#include "io/assimp_import.hpp"
#include "io/mesh_format.hpp"
#include "io_testing.hpp"
#include "lustro/image.hpp"
#include "lustro/scene.hpp"
#include "temporary_folder.hpp"
#include "texture/texture.hpp"

namespace lustro {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl red\nf 1 2 3\n";
constexpr const char* kRed = "newmtl red\nKd 1 0 0\n";

SourceMesh load(const TemporaryFolder& folder, const std::string& name, const LoadOptions& options = {}) {
  return good(load_mesh_file(folder.path / name, options));
}

TEST(LoadMesh, ContentWinsOverTheExtension) {
  const TemporaryFolder folder;
  folder.write("a.stl", kObj);
  folder.write("a.obj", "ply\nformat ascii 1.0\nend_header\n");
  folder.write("a.ply", "solid\nendsolid\n");
  folder.write("noname", kObj);
  EXPECT_EQ(load(folder, "a.stl").format, "OBJ");
  EXPECT_EQ(load(folder, "a.obj").format, "PLY (ascii)");
  EXPECT_EQ(load(folder, "a.ply").format, "STL (ascii)");
  EXPECT_EQ(load(folder, "noname").format, "OBJ");
}

TEST(LoadMesh, TheExtensionDecidesWhereTheContentDoesNot) {
  const TemporaryFolder folder;
  folder.write("a.OBJ", "# nothing\n");
  folder.write("a.STL", std::string(84, '\0') + "more");
  EXPECT_EQ(load(folder, "a.OBJ").format, "OBJ");
  EXPECT_EQ(load(folder, "a.STL").format, "STL (binary)");
  folder.write("a.ply", "hello");
  EXPECT_EQ(bad(load_mesh_file(folder.path / "a.ply")).kind, ErrorKind::malformed);
}

TEST(LoadMesh, UnknownFormatsAreRefusedWithWhatWasSeenAndWhatIsRead) {
  const TemporaryFolder folder;
  folder.write("a.bin", "\x01\x02");
  folder.write("a.fbx", "Kaydara FBX Binary");
  folder.write("empty", "");
  const Error error = bad(load_mesh_file(folder.path / "a.bin"));
  EXPECT_EQ(error.kind, ErrorKind::unsupported);
  EXPECT_EQ(error.message, "is a file that begins with \"\\x01\\x02\": expected OBJ, PLY, STL, OFF, 3MF or glTF");
  if (!assimp_reads("a.fbx")) {
    EXPECT_EQ(
        bad(load_mesh_file(folder.path / "a.fbx")).message,
        "is an FBX file: expected OBJ, PLY, STL, OFF, 3MF or glTF; a build of Lustro with assimp (-DLUSTRO_WITH_ASSIMP=ON) reads files of this "
        "extension");
  }
  EXPECT_EQ(bad(load_mesh_file(folder.path / "empty")).message, "is an empty file: expected OBJ, PLY, STL, OFF, 3MF or glTF");
}

TEST(LoadMesh, GltfIsKnownByContentAndByName) {
  const TemporaryFolder folder;
  folder.write("a.bin", "glTF\x02");
  folder.write("a.gltf", "{}");
  EXPECT_EQ(bad(load_mesh_file(folder.path / "a.bin")).message, "the GLB header is cut short");
  EXPECT_EQ(bad(load_mesh_file(folder.path / "a.gltf")).where, (folder.path / "a.gltf").string() + ": asset");
}

TEST(LoadMesh, MissingFilesAndFoldersAreIoErrors) {
  const TemporaryFolder folder;
  EXPECT_EQ(bad(load_mesh_file(folder.path / "gone.obj")).kind, ErrorKind::io);
  EXPECT_EQ(bad(load_mesh_file(folder.path)).kind, ErrorKind::io);
  EXPECT_EQ(bad(load_mesh_file("")).kind, ErrorKind::io);
  EXPECT_EQ(bad(load_mesh_file(std::string(100000, 'x'))).kind, ErrorKind::io);
}

TEST(LoadMesh, LibrariesAreReadFromTheObjsFolder) {
  const TemporaryFolder folder;
  folder.write("sub/my red.mtl", kRed);
  folder.write("sub/deep/red.mtl", kRed);
  for (const std::string& name :
       std::vector<std::string>{"my red.mtl", "./my red.mtl", "deep/red.mtl", "deep\\red.mtl", ".\\deep\\red.mtl", "../sub/my red.mtl",
                                "C:\\models\\my red.mtl", "/models/my red.mtl", "lost/my red.mtl", "\"my red.mtl\"", "my red.mtl # comment"}) {
    folder.write("sub/a.obj", "mtllib " + name + "\n" + kObj);
    const SourceMesh mesh = load(folder, "sub/a.obj");
    EXPECT_THAT(mesh.notes, IsEmpty()) << name;
    ASSERT_EQ(mesh.materials.size(), 1U) << name;
    EXPECT_EQ(mesh.materials[0].diffuse.rgb, (Vec3f{1, 0, 0})) << name;
  }
}

TEST(LoadMesh, AMissingLibraryIsANoteWithTheReason) {
  const TemporaryFolder folder;
  folder.write("a.obj", std::string("mtllib red.mtl\n") + kObj);
  const SourceMesh mesh = load(folder, "a.obj");
  ASSERT_EQ(mesh.notes.size(), 2U);
  EXPECT_EQ(mesh.notes[0].text(),
            (folder.path / "a.obj").string() + ":1: the material library \"red.mtl\" is not read: cannot be opened: No such file or directory");
  EXPECT_THAT(mesh.notes[1].message, HasSubstr("\"red\" is not defined"));
}

TEST(LoadMesh, MapsAreLookedForBesideTheirLibrary) {
  const TemporaryFolder folder;
  folder.write("lib/a.mtl", "newmtl red\nmap_Kd wood.png\nmap_Ks tex\\wood.png\nmap_Ka D:\\x\\wood.png\nmap_Ns gone.png\n");
  std::filesystem::create_directories(folder.path / "lib/tex");
  ASSERT_TRUE(write_image(folder.path / "lib/wood.png", Image(3, 2, 3)));
  ASSERT_TRUE(write_image(folder.path / "lib/tex/wood.png", Image(5, 4, 3)));
  folder.write("a.obj", std::string("mtllib lib/a.mtl\n") + kObj);
  const SourceMesh mesh = load(folder, "a.obj");
  EXPECT_THAT(texts(mesh.notes),
              ElementsAre("lib/a.mtl: map_Ka: the texture \"D:\\x\\wood.png\" is an absolute path, which is not followed: the file of that name "
                          "beside the one that names it is used",
                          "lib/a.mtl: map_Ns: the texture \"gone.png\" is missing; drawn without it"));
  const MaterialTextures& textures = mesh.materials.at(0).textures;
  ASSERT_TRUE(textures.diffuse && textures.specular && textures.ambient);
  EXPECT_EQ(textures.diffuse->texture->width(), 3);
  EXPECT_EQ(textures.specular->texture->width(), 5);
  EXPECT_EQ(textures.ambient->texture, textures.diffuse->texture);  // one file, read once
  EXPECT_FALSE(textures.shininess);
  const auto strict = load_mesh_file(folder.path / "a.obj", {.strict = true});
  ASSERT_FALSE(strict);
  EXPECT_EQ(strict.error().text(), "lib/a.mtl: map_Ns: the texture \"gone.png\" is missing");
  EXPECT_EQ(strict.error().kind, ErrorKind::io);
}

TEST(LoadMesh, TheMeaningOfTrIsTheCallers) {
  const TemporaryFolder folder;
  folder.write("a.mtl", "newmtl red\nTr 0.25\n");
  folder.write("a.obj", std::string("mtllib a.mtl\n") + kObj);
  EXPECT_EQ(load(folder, "a.obj").materials[0].opacity, 0.75F);
  EXPECT_EQ(load(folder, "a.obj", {.transparency_is_tr = true}).materials[0].opacity, 0.25F);
}

TEST(LoadMesh, AFolderInThePlaceOfALibraryIsANote) {
  const TemporaryFolder folder;
  folder.write("red.mtl/inner", "");
  folder.write("a.obj", std::string("mtllib red.mtl\n") + kObj);
  EXPECT_THAT(load(folder, "a.obj").notes.at(0).message, HasSubstr("is a folder, not a file"));
}

}  // namespace
}  // namespace lustro
