// What assimp reads for us, where it is built in (LUSTRO_WITH_ASSIMP); without it, messages that say so.
#include "io/assimp_import.hpp"

#include <fstream>

#include "io/io_testing.hpp"
#include "io/temporary_folder.hpp"
#include "lustro/scene.hpp"

namespace lustro {
namespace {

using testing::Contains;
using testing::HasSubstr;

// A square of one polygon in z = 0, moved up by 2 and doubled in x, red by a map.
const std::string kCollada = R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_images><image id="red"><init_from>red.pfm</init_from></image></library_images>
<library_effects><effect id="paint"><profile_COMMON>
 <newparam sid="s"><surface type="2D"><init_from>red</init_from></surface></newparam>
 <newparam sid="t"><sampler2D><source>s</source></sampler2D></newparam>
 <technique sid="common"><phong>
  <emission><color>0.125 0 0 1</color></emission><ambient><color>0.25 0.25 0.25 1</color></ambient>
  <diffuse><texture texture="t" texcoord="UV"/></diffuse><specular><color>0.5 0.5 0.5 1</color></specular>
  <shininess><float>30</float></shininess></phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="painted" name="painted"><instance_effect url="#paint"/></material></library_materials>
<library_geometries><geometry id="square" name="square"><mesh>
 <source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 1 1 0 0 1 0</float_array>
  <technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
 <source id="u"><float_array id="ua" count="8">0 0 1 0 1 1 0 1</float_array>
  <technique_common><accessor source="#ua" count="4" stride="2"><param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
 <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
 <polylist material="m" count="1"><input semantic="VERTEX" source="#v" offset="0"/><input semantic="TEXCOORD" source="#u" offset="1" set="0"/>
  <vcount>4</vcount><p>0 0 1 1 2 2 3 3</p></polylist></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node id="n" name="n"><matrix>2 0 0 0 0 1 0 2 0 0 1 0 0 0 0 1</matrix>
 <instance_geometry url="#square"><bind_material><technique_common><instance_material symbol="m" target="#painted">
 <bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material></technique_common></bind_material></instance_geometry>
 </node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>
)";

class AssimpImport : public testing::Test {
 protected:
  std::filesystem::path written(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path / name, std::ios::binary) << text;
    return folder_.path / name;
  }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_.path; }

 private:
  TemporaryFolder folder_;
};

TEST_F(AssimpImport, WithoutItAMessageSaysWhichBuildReadsTheFile) {
  if (assimp_reads("a.dae")) {
    GTEST_SKIP() << "assimp is built in";
  }
  const auto mesh = load_mesh_file(written("a.dae", kCollada));
  ASSERT_FALSE(mesh);
  EXPECT_EQ(mesh.error().kind, ErrorKind::unsupported);
  EXPECT_THAT(mesh.error().text(), HasSubstr("a build of Lustro with assimp (-DLUSTRO_WITH_ASSIMP=ON) reads files of this extension"));
  const auto other = load_mesh_file(written("a.txt", "no mesh"));
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().text(), testing::Not(HasSubstr("assimp")));
  EXPECT_FALSE(import_by_assimp(folder() / "a.dae"));
}

TEST_F(AssimpImport, ACollada) {
  if (!assimp_reads("a.dae")) {
    GTEST_SKIP() << "built without assimp";
  }
  written("red.pfm", std::string("PF\n1 1\n-1.0\n") + std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12));
  const SourceMesh mesh = good(load_mesh_file(written("a.dae", kCollada)));
  EXPECT_EQ(mesh.format, "DAE, by assimp");
  ASSERT_EQ(mesh.face_begin, (std::vector<std::uint32_t>{0, 4}));  // a polygon stays one
  const std::vector<Vec3f> corners{{0, 2, 0}, {2, 2, 0}, {2, 3, 0}, {0, 3, 0}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(mesh.positions[mesh.corner_position[i]], corners[i]);
    EXPECT_EQ(mesh.uvs[mesh.corner_uv[i]], (Vec2f{corners[i].x / 2, corners[i].y - 2}));
  }
  ASSERT_EQ(mesh.face_material.size(), 1U);
  const Material& material = mesh.materials.at(mesh.face_material[0]);
  EXPECT_EQ(material.name, "painted");
  EXPECT_EQ(material.ambient.rgb, (Vec3f{0.25F, 0.25F, 0.25F}));
  EXPECT_EQ(material.diffuse.rgb, (Vec3f{1, 1, 1}));
  EXPECT_EQ(material.specular.rgb, (Vec3f{0.5F, 0.5F, 0.5F}));
  EXPECT_EQ(material.emission.rgb, (Vec3f{0.125F, 0, 0}));
  EXPECT_EQ(material.shininess, 30);
  ASSERT_TRUE(material.textures.diffuse);
  EXPECT_TRUE(material.textures.diffuse->texture);
  const BuiltMesh built = good(build_mesh(mesh));
  EXPECT_EQ(built.mesh.triangles.size(), 2U);
  for (const Vec3f& normal : built.mesh.normals) {
    EXPECT_EQ(normal, (Vec3f{0, 0, 1}));
  }
}

TEST_F(AssimpImport, WhatIsBrokenIsAnErrorThatNamesTheFile) {
  if (!assimp_reads("a.dae")) {
    GTEST_SKIP() << "built without assimp";
  }
  for (std::size_t length = 0; length < kCollada.size(); length += 97) {
    const auto mesh = load_mesh_file(written("cut.dae", kCollada.substr(0, length)));
    if (!mesh) {
      EXPECT_THAT(mesh.error().text(), HasSubstr("cut.dae"));
    }
  }
  EXPECT_FALSE(load_mesh_file(written("bad.dae", kCollada.substr(0, 400))));
  EXPECT_FALSE(import_by_assimp(folder() / "none.dae"));
}

TEST_F(AssimpImport, FilesOutsideOfTheFolderAreNotRead) {
  if (!assimp_reads("a.dae")) {
    GTEST_SKIP() << "built without assimp";
  }
  std::filesystem::create_directory(folder() / "inner");
  std::string outside = kCollada;
  outside.replace(outside.find("red.pfm"), 7, "../../../etc/hostname");
  std::ofstream(folder() / "inner" / "a.dae") << outside;
  const SourceMesh mesh = good(load_mesh_file(folder() / "inner" / "a.dae"));
  EXPECT_FALSE(mesh.materials.at(mesh.face_material.at(0)).textures.diffuse);
  EXPECT_FALSE(mesh.notes.empty());
}

}  // namespace
}  // namespace lustro
