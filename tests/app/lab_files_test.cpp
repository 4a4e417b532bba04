// Which files a model is made of, and whether they change.
#include "app/lab_files.hpp"

#include <gmock/gmock.h>

#include <chrono>

#include "app/lab_watch.hpp"
#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "lustro/image.hpp"

namespace {

using namespace lustro::app;
using namespace lustro::testing;
using lustro::ErrorKind;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace fs = std::filesystem;

class LabFiles : public CommandTest {
 protected:
  void picture(const std::string& name) const {
    fs::create_directories((work() / name).parent_path());
    ASSERT_TRUE(lustro::write_image(work() / name, lustro::Image(1, 1, 3), {}));
  }
  void text(const std::string& name, const std::string& content) const {
    fs::create_directories((work() / name).parent_path());
    write_text(work() / name, content);
  }
  LabModel model(const std::string& entry) const {
    FileStates states;
    auto read = read_lab_model((work() / entry).string(), {}, states);
    EXPECT_TRUE(read) << read.error().text();
    return read ? *std::move(read) : LabModel{};
  }
  static std::vector<std::string> paths(const LabModel& model) {
    std::vector<std::string> all;
    for (const LabFile& file : model.files) {
      all.push_back(file.path);
      EXPECT_EQ(file.size, file.file.empty() ? file.text.size() : fs::file_size(file.file));
      EXPECT_EQ(file.version.size(), 16U);
    }
    return all;
  }
  /// A time that no file has yet: versions rest on it, not on how fast a test is.
  void touch(const std::string& name) {
    time_ += std::chrono::hours(1);
    fs::last_write_time(work() / name, time_);
  }

 private:
  fs::file_time_type time_ = fs::file_time_type::clock::now();
};

TEST_F(LabFiles, OfAnObjAreItsMaterialsAndTheirPictures) {
  text("m/a.obj", "mtllib lib/a.mtl\nusemtl m\n" + square_obj());
  text("m/lib/a.mtl", "newmtl m\nmap_Kd ../tex/wood.png\nmap_Ks gone.png\nmap_Ke ../../far.png\n");
  picture("m/tex/wood.png");
  picture("far.png");
  picture("m/unused.png");
  text("m/other.obj", square_obj());
  const LabModel found = model("m/a.obj");
  EXPECT_EQ(found.entry, "a.obj");
  EXPECT_THAT(paths(found), ElementsAre("a.obj", "lib/a.mtl", "tex/wood.png"));
  EXPECT_EQ(found.notes.size(), 2U);  // what gone.png and far.png, outside of the library's tree, are missing for
}

TEST_F(LabFiles, OfAGltfAreItsBuffersAndPictures) {
  text("a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "scene": 0, "nodes": [{"mesh": 0}],
    "buffers": [{"uri": "data/a.bin", "byteLength": 60}], "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0], "max": [0, 0, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
    "images": [{"uri": "data/a%20b.png"}], "textures": [{"source": 0}], "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}]})");
  text("data/a.bin", std::string(60, '\0'));
  picture("data/a b.png");
  EXPECT_THAT(paths(model("a.gltf")), ElementsAre("a.gltf", "data/a b.png", "data/a.bin"));
}

TEST_F(LabFiles, OfASceneFileMayLieBesideItsFolder) {
  text("scenes/a/scene.json", R"({"environment": {"file": "../sky.png"}, "objects": [{"mesh": "../../meshes/a.obj"}, {"mesh": "primitive:cube",
    "material": {"textures": {"diffuse": "own.png"}}}]})");
  text("meshes/a.obj", "mtllib a.mtl\n" + square_obj());
  text("meshes/a.mtl", "newmtl m\n");
  picture("scenes/sky.png");
  picture("scenes/a/own.png");
  const LabModel found = model("scenes/a/scene.json");
  EXPECT_EQ(found.entry, "scenes/a/scene.json");
  EXPECT_THAT(paths(found), ElementsAre("meshes/a.mtl", "meshes/a.obj", "scenes/a/own.png", "scenes/a/scene.json", "scenes/sky.png"));
  ASSERT_NE(found.find("meshes/a.obj"), nullptr);
  EXPECT_EQ(file_text(found.find("meshes/a.obj")->file), file_text(work() / "meshes/a.obj"));
  EXPECT_EQ(found.find("../a.obj"), nullptr);
}

TEST_F(LabFiles, OfAPrimitiveAreASceneThatNamesIt) {
  FileStates states;
  const auto found = read_lab_model("primitive:teapot", {}, states);
  ASSERT_TRUE(found);
  EXPECT_THAT(paths(*found), ElementsAre("scene.json"));
  const auto scene = lustro::parse_scene(found->files[0].text);
  ASSERT_TRUE(scene);
  EXPECT_EQ(scene->objects[0].source, "primitive:teapot");
  EXPECT_TRUE(scene->shading.two_sided);  // as a bare mesh is drawn
  EXPECT_THAT(states, IsEmpty());
}

TEST_F(LabFiles, AreNothingThatModelsAreNotMadeOf) {
  text("private/key", "secret");
  text(".hidden/a.mtl", "newmtl m\n");
  text("m/a.obj", "mtllib ../private/key\nmtllib ../.hidden/a.mtl\n" + square_obj());
  const LabModel found = model("m/a.obj");
  EXPECT_THAT(paths(found), ElementsAre("m/a.obj"));
  std::string notes;
  for (const auto& note : found.notes) {
    notes += note.text() + "\n";
  }
  EXPECT_THAT(notes, HasSubstr("private/key: is not given to the page: its name does not end"));
  EXPECT_THAT(notes, HasSubstr(".hidden/a.mtl: is not given to the page: it is hidden"));
}

TEST_F(LabFiles, AnAbsoluteMeshIsRefused) {
  text("a.obj", square_obj());
  text("scene.json", R"({"objects": [{"mesh": ")" + (work() / "a.obj").string() + R"("}]})");
  FileStates states;
  const auto refused = read_lab_model((work() / "scene.json").string(), {}, states);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::unsupported);
  EXPECT_THAT(refused.error().text(), HasSubstr("scene.json: objects[0].mesh: "));
  EXPECT_THAT(refused.error().text(), HasSubstr("is an absolute path"));
}

TEST_F(LabFiles, AWrongFileIsTheErrorOfRender) {
  text("a.obj", "f 1 2 3\n");
  for (const char* const name : {"a.obj", "none.obj"}) {
    FileStates states;
    const auto wrong = read_lab_model((work() / name).string(), {}, states);
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().text(), lustro::load_scene(work() / name).error().text());
    EXPECT_EQ(states.size(), 1U) << "it is watched";
  }
}

class LabWatched : public LabFiles {
 protected:
  void SetUp() override {
    text("a.obj", "mtllib a.mtl\n" + square_obj());
    text("a.mtl", "newmtl m\n");
  }
  LabWatch begin() {
    auto begun = LabWatch::begin((work() / "a.obj").string(), {});
    EXPECT_TRUE(begun) << begun.error().text();
    return *std::move(begun);
  }
};

TEST_F(LabWatched, AChangeCountsWhenTheFileIsQuiet) {
  LabWatch watch = begin();
  const std::string before = watch.stamp();
  EXPECT_EQ(before, watch.model().version);
  EXPECT_FALSE(watch.look());
  touch("a.mtl");
  EXPECT_FALSE(watch.look());  // it may be half written
  touch("a.mtl");
  EXPECT_FALSE(watch.look());  // it is being written
  EXPECT_EQ(watch.stamp(), before);
  EXPECT_TRUE(watch.look());
  EXPECT_NE(watch.stamp(), before);
  EXPECT_EQ(watch.stamp(), watch.model().version);
  EXPECT_FALSE(watch.look());
  EXPECT_FALSE(watch.look());
}

TEST_F(LabWatched, OnlyTheVersionOfWhatHasChangedIsAnother) {
  LabWatch watch = begin();
  const LabModel before = watch.model();
  touch("a.obj");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_NE(watch.model().find("a.obj")->version, before.find("a.obj")->version);
  EXPECT_EQ(watch.model().find("a.mtl")->version, before.find("a.mtl")->version);
  EXPECT_NE(watch.model().version, before.version);
}

TEST_F(LabWatched, AFileThatIsNamedAnewIsFollowed) {
  LabWatch watch = begin();
  picture("new.png");
  text("a.mtl", "newmtl m\nmap_Kd new.png\n");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.mtl", "a.obj", "new.png"));
  touch("new.png");
  EXPECT_FALSE(watch.look());
  EXPECT_TRUE(watch.look());
}

TEST_F(LabWatched, WhatBreaksIsSaidAndItsMendingToo) {
  LabWatch watch = begin();
  const std::string before = watch.model().version;
  text("a.obj", "mtllib a.mtl\nf 1 2 3\n");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(watch.problem(), HasSubstr("a.obj:2: "));
  EXPECT_THAT(watch.stamp(), HasSubstr("error-"));
  EXPECT_EQ(watch.model().version, before);  // what was good stays
  EXPECT_FALSE(watch.look());
  text("a.obj", square_obj());
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(watch.problem(), IsEmpty());
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.obj"));
}

TEST_F(LabWatched, AnEntryThatVanishesMayComeBack) {
  LabWatch watch = begin();
  fs::remove(work() / "a.obj");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(watch.problem(), HasSubstr("a.obj: cannot be opened"));
  EXPECT_FALSE(watch.look());
  text("a.obj", square_obj());
  EXPECT_FALSE(watch.look());
  EXPECT_TRUE(watch.look());
  EXPECT_THAT(watch.problem(), IsEmpty());
}

TEST_F(LabWatched, AMaterialFileThatVanishesMayComeBack) {
  LabWatch watch = begin();
  fs::remove(work() / "a.mtl");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(watch.problem(), IsEmpty());  // an OBJ without its MTL is a model with a note
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.obj"));
  text("a.mtl", "newmtl other\n");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.mtl", "a.obj"));
}

TEST_F(LabWatched, APictureThatVanishesMayComeBack) {
  picture("wood.png");
  text("a.mtl", "newmtl m\nmap_Kd wood.png\n");
  LabWatch watch = begin();
  fs::remove(work() / "wood.png");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.mtl", "a.obj"));
  picture("wood.png");
  EXPECT_FALSE(watch.look());
  ASSERT_TRUE(watch.look());
  EXPECT_THAT(paths(watch.model()), ElementsAre("a.mtl", "a.obj", "wood.png"));
}

TEST_F(LabWatched, OneOfSeveralMeshesMayBreakAndBeMended) {
  text("b.obj", square_obj());
  text("scene.json", R"({"objects": [{"mesh": "b.obj"}, {"mesh": "a.obj"}]})");
  auto watch = LabWatch::begin((work() / "scene.json").string(), {});
  ASSERT_TRUE(watch);
  text("b.obj", "f 1 2 3\n");  // a.obj is not even opened now
  EXPECT_FALSE(watch->look());
  ASSERT_TRUE(watch->look());
  EXPECT_THAT(watch->problem(), HasSubstr("b.obj:1: "));
  text("b.obj", square_obj());
  EXPECT_FALSE(watch->look());
  ASSERT_TRUE(watch->look());
  EXPECT_THAT(paths(watch->model()), ElementsAre("a.mtl", "a.obj", "b.obj", "scene.json"));
  touch("a.mtl");
  EXPECT_FALSE(watch->look());
  EXPECT_TRUE(watch->look());
}

TEST_F(LabWatched, AFileThatIsSavedByRenamingIsAnother) {
  LabWatch watch = begin();
  const std::string before = watch.stamp();
  text("a.mtl.new", "newmtl n\n");  // as long as before
  fs::last_write_time(work() / "a.mtl.new", fs::last_write_time(work() / "a.mtl"));
  fs::rename(work() / "a.mtl.new", work() / "a.mtl");
  EXPECT_FALSE(watch.look());
  EXPECT_TRUE(watch.look());
  EXPECT_NE(watch.stamp(), before);
}

}  // namespace
