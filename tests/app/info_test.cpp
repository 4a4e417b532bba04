// `lustro info`: counts, surface, materials, repairs.
#include <gmock/gmock.h>

#include "app/run_command.hpp"
#include "app/scenes.hpp"
#include "shared_dir.hpp"

namespace {

using namespace lustro::testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class InfoCommand : public CommandTest {};

TEST_F(InfoCommand, ACubeIsClosedAndHasItsVolume) {
  const Outcome outcome = lustro({"info", "primitive:cube", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  EXPECT_EQ(json["drawn"]["triangles"], 12);
  EXPECT_EQ(json["surface"]["closed"], true);
  EXPECT_EQ(json["surface"]["oriented"], true);
  EXPECT_EQ(json["surface"]["pieces"], 1);
  EXPECT_EQ(json["surface"]["positions"], 8);
  EXPECT_EQ(json["surface"]["edges"], 18);  // 12 of the cube, 6 diagonals
  EXPECT_DOUBLE_EQ(json["surface"]["area"], 24);
  EXPECT_DOUBLE_EQ(json["surface"]["volume"], 8);
  EXPECT_EQ(json["bounds"]["lower"], nlohmann::json({-1, -1, -1}));
}

TEST_F(InfoCommand, TellsStatedFromDrawnAndOpenFromClosed) {
  write_text(work() / "m.obj", "o first\n" + square_obj() + "o second\nv 5 5 5\nv 6 5 5\nv 5 6 5\nf 5 6 7\nf 5 5 6\n");
  const Outcome outcome = lustro({"info", "m.obj", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  EXPECT_EQ(json["stated"]["vertices"], 7);
  EXPECT_EQ(json["stated"]["faces"], 3);
  EXPECT_EQ(json["stated"]["triangles"], 4);
  EXPECT_EQ(json["drawn"]["triangles"], 3);  // the degenerate one is gone
  EXPECT_EQ(json["objects"], nlohmann::json({"first", "second"}));
  EXPECT_EQ(json["surface"]["closed"], false);
  EXPECT_EQ(json["surface"]["pieces"], 2);
  EXPECT_EQ(json["surface"]["boundary_edges"], 7);
  EXPECT_EQ(json["surface"]["volume"], nullptr);
  EXPECT_EQ(json["notes"].size(), 1U);
  const Outcome text = lustro({"info", "m.obj"});
  EXPECT_THAT(text.out, HasSubstr("7 vertices, 3 faces (4 triangles)"));
  EXPECT_THAT(text.out, HasSubstr("open, 2 pieces"));
}

TEST_F(InfoCommand, ThreeFacesAtAnEdgeAndAFaceTurnedRoundAreSeen) {
  write_text(work() / "fan.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 0 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
  EXPECT_EQ(lustro({"info", "fan.obj", "--json"}).json()["surface"]["nonmanifold_edges"], 1);
  write_text(work() / "turned.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 4 3\n");
  const auto turned = lustro({"info", "turned.obj", "--json"}).json();
  EXPECT_EQ(turned["surface"]["misoriented_edges"], 1);
  EXPECT_EQ(turned["surface"]["oriented"], false);
}

TEST_F(InfoCommand, MaterialsComeWithTheirCoefficientsAndMaps) {
  write_text(work() / "m.mtl", "newmtl red\nKd 0.6 0.1 0.1\nKs 0.5 0.5 0.5\nNs 20\nillum 2\nmap_Kd red.png\n");
  write_text(work() / "m.obj", "mtllib m.mtl\nusemtl red\n" + square_obj());
  const Outcome outcome = lustro({"info", "m.obj", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto material = outcome.json()["materials"][0];
  EXPECT_EQ(material["name"], "red");
  EXPECT_EQ(material["diffuse"]["rgb"], nlohmann::json({0.6, 0.1, 0.1}));
  EXPECT_EQ(material["diffuse"]["space"], "srgb");
  EXPECT_EQ(material["shininess"], 20.0);
  EXPECT_EQ(material["illumination"], 2);
  EXPECT_EQ(material["maps"][0]["file"], "red.png");
  EXPECT_THAT(lustro({"info", "m.obj"}).out, HasSubstr("map_Kd red.png"));
}

TEST_F(InfoCommand, ASceneIsToldAsAScene) {
  write_text(work() / "square.obj", square_obj());
  write_text(work() / "scene.json", square_scene());
  const Outcome outcome = lustro({"info", "scene.json", "--json"});
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto json = outcome.json();
  EXPECT_EQ(json["kind"], "scene");
  EXPECT_EQ(json["width"], 32);
  EXPECT_EQ(json["triangles"], 2);
  EXPECT_EQ(json["lights"].size(), 2U);
  EXPECT_EQ(json["lights"][1]["name"], "lamp");
  EXPECT_EQ(json["objects"][0]["materials"][0]["name"], "jade");
  EXPECT_THAT(lustro({"info", "scene.json"}).out, HasSubstr("square.obj: 4 vertices, 2 triangles, material jade"));
}

TEST_F(InfoCommand, NamesFromAFileDoNotCommandTheTerminal) {
  write_text(work() / "m.obj", "o evil\x1b[2Jname\n" + square_obj());
  const Outcome outcome = lustro({"info", "m.obj"});
  EXPECT_EQ(outcome.out.find('\x1b'), std::string::npos);
}

TEST_F(InfoCommand, AFileThatIsNotThereIsAnErrorOfInput) {
  const Outcome outcome = lustro({"info", "absent.ply"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.out, IsEmpty());
}

TEST_F(InfoCommand, TheBunnyHasTheCountsOfItsScan) {
  LUSTRO_REQUIRE_SHARED();
  const auto json = lustro({"info", (lustro::shared_dir() / "assets/ply/stanford_bunny/bun_zipper.ply").string(), "--json"}).json();
  EXPECT_EQ(json["stated"]["vertices"], 35947);
  EXPECT_EQ(json["stated"]["triangles"], 69451);
  EXPECT_EQ(json["surface"]["closed"], false);  // five holes in its base
  EXPECT_EQ(json["surface"]["boundary_edges"], 223);
}

}  // namespace
