// `lustro convert`: formats, moves, normals, scenes, and what it refuses.
#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"

namespace {

using namespace lustro::testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class ConvertCommand : public CommandTest {
 protected:
  nlohmann::json info(const std::string& file) {
    const Outcome outcome = lustro({"info", file, "--json"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return outcome.json();
  }
};

TEST_F(ConvertCommand, EveryFormatComesToEveryOther) {
  for (const std::string from : {"a.obj", "a.ply", "a.stl"}) {
    ASSERT_EQ(lustro({"convert", "primitive:torus:12", from, "--no-normals"}).code, 0);
    for (const std::string to : {"b.obj", "b.ply", "b.stl"}) {
      const Outcome outcome = lustro({"convert", from, to, "--json"});
      ASSERT_EQ(outcome.code, 0) << outcome.err;
      const auto json = outcome.json();
      EXPECT_EQ(json["triangles"], info("primitive:torus:12")["drawn"]["triangles"]);
      EXPECT_EQ(info(to)["drawn"]["triangles"], json["triangles"]);
      EXPECT_EQ(info(to)["surface"]["closed"], true) << from << " to " << to;
      EXPECT_EQ(info(to)["bounds"], info("primitive:torus:12")["bounds"]);
    }
  }
}

TEST_F(ConvertCommand, ThePictureOfWhatIsWrittenIsThePictureOfWhatWasRead) {
  ASSERT_EQ(lustro({"convert", "primitive:teapot", "a.ply"}).code, 0);
  ASSERT_EQ(lustro({"convert", "a.ply", "b.obj"}).code, 0);
  const Outcome read = lustro({"hash", "a.ply", "--size", "64x48", "--samples", "1"});
  EXPECT_EQ(read.code, 0) << read.err;
  EXPECT_EQ(read.out, lustro({"hash", "b.obj", "--size", "64x48", "--samples", "1"}).out);
}

TEST_F(ConvertCommand, ScaleAndUpMoveThePositions) {
  write_text(work() / "m.obj", "v 0 0 0\nv 1 2 3\nv 0 2 0\nf 1 2 3\n");
  ASSERT_EQ(lustro({"convert", "m.obj", "up.ply", "--ascii", "--scale", "0.5", "--up", "z-to-y", "--no-normals"}).code, 0);
  EXPECT_THAT(file_text(work() / "up.ply"), HasSubstr("end_header\n0 0 -0\n0.5 1.5 -1\n0 0 -1\n3 0 1 2\n"));
  ASSERT_EQ(lustro({"convert", "up.ply", "down.ply", "--ascii", "--scale", "2", "--up", "y-to-z", "--no-normals"}).code, 0);
  EXPECT_THAT(file_text(work() / "down.ply"), HasSubstr("end_header\n0 0 0\n1 2 3\n0 2 0\n3 0 1 2\n"));
}

TEST_F(ConvertCommand, NormalsAreWrittenAsDrawnUnlessLeftOut) {
  ASSERT_EQ(lustro({"convert", "primitive:cube", "a.stl"}).code, 0);
  EXPECT_EQ(lustro({"convert", "a.stl", "b.ply", "--json"}).json()["vertices"], 24);  // facets stay sharp
  EXPECT_EQ(lustro({"convert", "a.stl", "b.ply", "--crease", "180", "--json"}).json()["vertices"], 8);
  EXPECT_EQ(lustro({"convert", "a.stl", "c.ply", "--no-normals", "--json"}).json()["vertices"], 8);
  EXPECT_THAT(file_text(work() / "b.ply"), HasSubstr("property float nx"));
  EXPECT_THAT(file_text(work() / "c.ply"), ::testing::Not(HasSubstr("property float nx")));
}

TEST_F(ConvertCommand, ASceneBecomesItsObjectsWhereTheyStand) {
  write_text(work() / "square.obj", square_obj());
  write_text(
      work() / "scene.json",
      R"({"objects": [{"mesh": "square.obj", "material": "jade"}, {"mesh": "square.obj", "matrix": [1,0,0,5, 0,1,0,0, 0,0,1,0, 0,0,0,1]}]})");
  const Outcome outcome = lustro({"convert", "scene.json", "all.obj"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("camera, lights and shading are left out"));
  const auto json = info("all.obj");
  EXPECT_EQ(json["bounds"]["upper"], nlohmann::json({6, 1, 0}));
  EXPECT_EQ(json["drawn"]["triangles"], 4);
  EXPECT_THAT(file_text(work() / "all.mtl"), HasSubstr("newmtl jade"));
}

TEST_F(ConvertCommand, WhatTheTargetCannotHoldIsAWarning) {
  write_text(work() / "m.obj", "mtllib m.mtl\nusemtl a\n" + square_obj());
  write_text(work() / "m.mtl", "newmtl a\nKd 1 0 0\n");
  EXPECT_THAT(lustro({"convert", "m.obj", "m.stl"}).err, HasSubstr("warning: m.stl: STL holds triangles alone: materials are left out"));
  EXPECT_EQ(lustro({"convert", "m.obj", "m.stl", "-q"}).err, "");
}

TEST_F(ConvertCommand, GlbIsBinaryGltf) {
  write_text(work() / "m.obj", square_obj());
  const Outcome outcome = lustro({"convert", "m.obj", "m.glb"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(file_text(work() / "m.glb"), ::testing::StartsWith("glTF"));
}

TEST_F(ConvertCommand, RefusesWhatMakesNoSense) {
  write_text(work() / "m.obj", square_obj());
  write_text(work() / "points.obj", "v 0 0 0\n");
  EXPECT_EQ(lustro({"convert", "m.obj", "m.txt"}).code, 5);
  EXPECT_EQ(lustro({"convert", "m.obj", "b.obj", "--ascii"}).code, 2);
  EXPECT_EQ(lustro({"convert", "m.obj", "b.ply", "--scale", "0"}).code, 2);
  EXPECT_EQ(lustro({"convert", "m.obj", "b.ply", "--crease", "200"}).code, 2);
  EXPECT_EQ(lustro({"convert", "m.obj", "b.ply", "--up", "x-to-y"}).code, 2);
  EXPECT_EQ(lustro({"convert", "m.obj", "b.ply", "--no-normals", "--crease", "20"}).code, 2);
  EXPECT_EQ(lustro({"convert", "points.obj", "b.ply"}).code, 7);
  EXPECT_EQ(lustro({"convert", "none.obj", "b.ply"}).code, 3);
  EXPECT_THAT(files(), ElementsAre("m.obj", "points.obj"));
}

}  // namespace
