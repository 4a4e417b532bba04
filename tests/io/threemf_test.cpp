// 3MF packages: placing, units, materials and colours in values from paper, and what hostile ones are refused for.
#include "io/threemf.hpp"

#include "io_testing.hpp"
#include "zip_writer.hpp"

namespace lustro {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kHead =
    R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
 xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06">
<resources>
)";  // the resources begin in line 5
constexpr const char* kMesh = R"(<mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1.5" z="0"/></vertices>
<triangles>)";
constexpr const char* kMeshEnd = "</triangles></mesh></object>\n";
const std::string kTriangle = std::string(kMesh) + R"(<triangle v1="0" v2="1" v3="2"/>)" + kMeshEnd;

std::string model(const std::string& resources, const std::string& build) {
  return kHead + resources + "</resources>\n<build>" + build + "</build></model>";
}
std::string package(const std::string& model_xml) {
  return zip({{"[Content_Types].xml", "<Types/>"},
              {"_rels/.rels", R"(<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Id="r" )"
                              R"(Target="/3D/a.model" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
              {"3D/a.model", model_xml}});
}
SourceMesh threemf(const std::string& model_xml) {
  SourceMesh mesh = good(parse_threemf(package(model_xml), "m.3mf"));
  expect_consistent(mesh);
  return mesh;
}
Error error_of(const std::string& model_xml, const ThreeMfLimits& limits = {}) {
  return bad(parse_threemf(package(model_xml), "m.3mf", limits));
}

TEST(ThreeMf, AnItemOfTheBuildIsPlacedByItsTransform) {
  const SourceMesh mesh =
      threemf(model(R"(<object id="1" name="part">)" + kTriangle, R"(<item objectid="1" transform="0 2 0 -2 0 0 0 0 2 10 20 30"/>)"));
  // x goes to 2y, y to -2x
  EXPECT_THAT(mesh.positions, ElementsAre(Vec3f{10, 20, 30}, Vec3f{10, 22, 30}, Vec3f{7, 20, 30}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.objects, ElementsAre("part"));
  EXPECT_THAT(mesh.notes, IsEmpty());
  EXPECT_THAT(mesh.colors, IsEmpty());
  EXPECT_THAT(mesh.face_material, IsEmpty());
  EXPECT_EQ(mesh.format, "3MF");
}

TEST(ThreeMf, ComponentsAreMovedWithWhatHoldsThem) {
  const SourceMesh mesh = threemf(model(
      R"(<object id="1" name="a">)" + kTriangle +
          R"(<object id="2" name="b"><components><component objectid="1"/><component objectid="1" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>)",
      R"(<item objectid="2" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/><item objectid="1"/>)"));
  ASSERT_EQ(mesh.face_count(), 3U);
  EXPECT_EQ(mesh.positions[1], (Vec3f{0, 1, 0}));
  EXPECT_EQ(mesh.positions[3], (Vec3f{0, 5, 0}));  // moved by 5 along x, then turned
  EXPECT_EQ(mesh.positions[7], (Vec3f{1, 0, 0}));
  EXPECT_THAT(mesh.face_object, ElementsAre(0, 1, 2));
  EXPECT_THAT(mesh.objects, ElementsAre("a", "a", "a"));
}

TEST(ThreeMf, AMirroredItemIsTurnedRound) {
  const SourceMesh mesh = threemf(model(R"(<object id="1">)" + kTriangle, R"(<item objectid="1" transform="-1 0 0 0 1 0 0 0 1 0 0 0"/>)"));
  EXPECT_EQ(mesh.positions[mesh.corner_position[1]], (Vec3f{0, 1.5F, 0}));
  EXPECT_EQ(mesh.positions[mesh.corner_position[2]], (Vec3f{-1, 0, 0}));
}

TEST(ThreeMf, LengthsAreMillimetres) {
  std::string xml = model(R"(<object id="1">)" + kTriangle, R"(<item objectid="1"/>)");
  xml.replace(xml.find("millimeter"), 10, "inch");
  const SourceMesh mesh = threemf(xml);
  EXPECT_EQ(mesh.positions[1], (Vec3f{25.4F, 0, 0}));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.3mf: 3D/a.model: lengths are converted from inch to millimetres"));
  xml.replace(xml.find("\"inch\""), 6, "\"ell\"");
  EXPECT_EQ(error_of(xml).text(), "m.3mf: 3D/a.model:2: unit \"ell\" is none of micron, millimeter, centimeter, inch, foot, meter");
}

TEST(ThreeMf, BaseMaterialsBecomeMaterials) {
  const SourceMesh mesh = threemf(model(
      std::string(
          R"(<basematerials id="7"><base name="red" displaycolor="#FF0000"/><base name="glass" displaycolor="#00ff8080"/></basematerials>)") +
          R"(<object id="1" pid="7" pindex="1">)" + kMesh +
          R"(<triangle v1="0" v2="1" v3="2"/><triangle v1="0" v2="1" v3="2" pid="7" p1="0"/>)" + kMeshEnd,
      R"(<item objectid="1"/>)"));
  ASSERT_EQ(mesh.materials.size(), 2U);
  EXPECT_THAT(mesh.face_material, ElementsAre(1, 0));
  EXPECT_EQ(mesh.materials[0].name, "red");
  EXPECT_EQ(mesh.materials[0].diffuse, (Color{{1, 0, 0}, ColorSpace::encoded}));
  EXPECT_EQ(mesh.materials[0].ambient, (Color{{0.25F, 0, 0}, ColorSpace::linear}));
  EXPECT_EQ(mesh.materials[1].diffuse, (Color{{0, 1, 128 / 255.0F}, ColorSpace::encoded}));
  EXPECT_EQ(mesh.materials[1].opacity, 128 / 255.0F);
}

TEST(ThreeMf, ColorsBelongToFacesOrToCorners) {
  const SourceMesh mesh = threemf(model(
      std::string(R"(<m:colorgroup id="3"><m:color color="#FF0000FF"/><m:color color="#0000FF"/></m:colorgroup><object id="1">)") + kMesh +
          R"(<triangle v1="0" v2="1" v3="2" pid="3" p1="0"/><triangle v1="0" v2="1" v3="2" pid="3" p1="0" p2="1" p3="1"/><triangle v1="0" v2="1" v3="2"/>)" +
          kMeshEnd,
      R"(<item objectid="1"/>)"));
  EXPECT_THAT(mesh.face_colors, ElementsAre(Vec3f{1, 0, 0}, Vec3f{1, 1, 1}, Vec3f{1, 1, 1}));
  EXPECT_THAT(mesh.corner_position, ElementsAre(0, 1, 2, 3, 4, 5, 0, 1, 2));  // a vertex for each of its colours
  EXPECT_THAT(mesh.colors, ElementsAre(Vec3f{1, 1, 1}, Vec3f{1, 1, 1}, Vec3f{1, 1, 1}, Vec3f{1, 0, 0}, Vec3f{0, 0, 1}, Vec3f{0, 0, 1}));
  EXPECT_EQ(mesh.positions[4], mesh.positions[1]);
  EXPECT_THAT(mesh.notes, IsEmpty());
}

TEST(ThreeMf, ComponentsMayLieInOtherParts) {
  std::string bytes = zip(
      {{"3D/3dmodel.model", model(R"(<object id="1"><components><component p:path="/3D/Objects/o.model" objectid="1"/></components></object>)",
                                  R"(<item objectid="1"/>)")},
       {"3D/Objects/o.model", model(R"(<object id="1">)" + kTriangle, "")}});  // the usual name, where there is no relationship
  EXPECT_EQ(good(parse_threemf(bytes, "m.3mf")).face_count(), 1U);
}

TEST(ThreeMf, WhatIsIgnoredIsNoted) {
  const SourceMesh mesh = threemf(model(
      std::string(R"(<m:texture2dgroup id="3" texid="1"/><m:colorgroup id="4"><m:color color="#FF000080"/></m:colorgroup><object id="1">)") +
          kMesh +
          R"(<triangle v1="0" v2="1" v3="2" pid="3" p1="0"/><triangle v1="0" v2="1" v3="2" pid="4" p1="0"/><triangle v1="0" v2="1" v3="2" pid="9"/>)" +
          kMeshEnd,
      R"(<item objectid="1"/>)"));
  EXPECT_THAT(texts(mesh.notes), ElementsAre("m.3mf: 3D/a.model:5: properties of the kind texture2dgroup are ignored",
                                             "m.3mf: 3D/a.model: opacities of colours are ignored",
                                             "m.3mf: 3D/a.model: triangles name groups of properties that are not there, and have none"));
  EXPECT_THAT(texts(threemf(model("", "")).notes), ElementsAre("m.3mf: 3D/a.model: the build has no items: there is nothing to show"));
}

TEST(ThreeMf, ErrorsNamePartAndLine) {
  const auto message = [](const std::string& resources, const std::string& build) { return error_of(model(resources, build)).text(); };
  const std::string object = R"(<object id="1">)" + kTriangle;
  EXPECT_EQ(message(object, R"(<item objectid="2"/>)"), "m.3mf: 3D/a.model:8: object 2 is not in the model");
  EXPECT_EQ(message(std::string(R"(<object id="1">)") + kMesh + R"(<triangle v1="0" v2="1" v3="3"/>)" + kMeshEnd, ""),
            "m.3mf: 3D/a.model:6: vertex index 3 is outside 0..2");
  EXPECT_EQ(message(R"(<object id="1"><mesh><vertices><vertex x="0" y="1e" z="0"/>)", ""),
            "m.3mf: 3D/a.model:5: vertex needs y, a number, found \"1e\"");
  EXPECT_EQ(message(R"(<object id="1"><mesh><vertices><vertex x="0" y="nan" z="0"/>)", ""),
            "m.3mf: 3D/a.model:5: vertex needs y, a number, found \"nan\"");
  EXPECT_EQ(message(object + object, ""), "m.3mf: 3D/a.model:7: object 1 is there twice");
  EXPECT_EQ(message("<object/>", ""), "m.3mf: 3D/a.model:5: object needs id, a whole number, found nothing");
  EXPECT_EQ(message(object, R"(<item objectid="1" transform="1 2 3"/>)"), "m.3mf: 3D/a.model:8: transform needs 12 numbers, found \"1 2 3\"");
  EXPECT_EQ(message(R"(<m:colorgroup id="1"><m:color color="red"/>)", ""),
            "m.3mf: 3D/a.model:5: color needs color, #rrggbb or #rrggbbaa, found \"red\"");
  EXPECT_THAT(message("<object id=\"1\">", ""), HasSubstr("m.3mf: 3D/a.model:5: the XML is broken: mismatched tag"));
  EXPECT_EQ(message(std::string(R"(<m:colorgroup id="3"><m:color color="#000000"/></m:colorgroup><object id="1">)") + kMesh +
                        R"(<triangle v1="0" v2="1" v3="2" pid="3" p1="1"/>)" + kMeshEnd,
                    R"(<item objectid="1"/>)"),
            "m.3mf: 3D/a.model: object 1: property 1 of group 3 is outside of its 1");
}

TEST(ThreeMf, RequiredExtensionsThatAreNotReadAreUnsupported) {
  std::string xml = model("", "");
  xml.replace(xml.find(" unit"), 5, R"( requiredextensions="m p" unit)");
  threemf(xml);
  xml.replace(xml.find("\"m p\""), 5, R"("m b" xmlns:b="http://schemas.microsoft.com/3dmanufacturing/beamlattice/2017/02")");
  EXPECT_EQ(error_of(xml).kind, ErrorKind::unsupported);
  EXPECT_THAT(error_of(xml).text(), HasSubstr("requires the extension"));
}

TEST(ThreeMf, EntitiesAreRefused) {
  const std::string bomb = "<?xml version=\"1.0\"?>\n<!DOCTYPE m [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;\">]>\n<model>&b;</model>";
  EXPECT_EQ(error_of(bomb).text(), "m.3mf: 3D/a.model:2: a document type declaration, and with it entities, is not allowed");
}

TEST(ThreeMf, ObjectsThatHoldThemselvesAreErrors) {
  EXPECT_EQ(error_of(model(R"(<object id="1"><components><component objectid="2"/></components></object>
<object id="2"><components><component objectid="1"/></components></object>)",
                           R"(<item objectid="1"/>)"))
                .text(),
            "m.3mf: 3D/a.model:6: object 1 holds itself");
}

TEST(ThreeMf, WhatMultipliesItselfIsRefusedBeforeItIsPlaced) {
  std::string resources = R"(<object id="1">)" + kTriangle;
  for (int i = 2; i <= 40; ++i) {  // 2^39 triangles
    resources += "<object id=\"" + std::to_string(i) + "\"><components>";
    for (int j = 0; j < 2; ++j) {
      resources += "<component objectid=\"" + std::to_string(i - 1) + "\"/>";
    }
    resources += "</components></object>";
  }
  EXPECT_EQ(error_of(model(resources, R"(<item objectid="40"/>)")).kind, ErrorKind::limit);
  EXPECT_EQ(threemf(model(resources, R"(<item objectid="5"/>)")).face_count(), 16U);
  EXPECT_EQ(error_of(model(resources, R"(<item objectid="5"/>)"), {.triangles = 15}).kind, ErrorKind::limit);
  EXPECT_EQ(error_of(model(resources, R"(<item objectid="5"/><item objectid="5"/>)"), {.uses = 31}).kind, ErrorKind::limit);
  std::string chain = R"(<object id="1">)" + kTriangle;
  for (int i = 2; i <= 100; ++i) {
    chain +=
        "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" + std::to_string(i - 1) + "\"/></components></object>";
  }
  EXPECT_THAT(error_of(model(chain, R"(<item objectid="100"/>)")).text(), HasSubstr("components are nested deeper than 64"));
  EXPECT_THAT(error_of(model(chain, R"(<item objectid="60"/><item objectid="100"/>)")).text(),
              HasSubstr("components are nested deeper than 64"));
  EXPECT_EQ(threemf(model(chain, R"(<item objectid="64"/>)")).face_count(), 1U);
  EXPECT_EQ(error_of(model(chain, ""), {.bytes = 1000}).kind, ErrorKind::limit);
}

TEST(ThreeMf, OtherArchivesAreUnsupported) {
  EXPECT_EQ(bad(parse_threemf(zip({{"a.usdc", "x"}}), "m.3mf")).text(), "m.3mf: is a ZIP archive without a 3MF model");
  EXPECT_EQ(error_of("<html/>").text(), "m.3mf: 3D/a.model:1: expected the element model of 3MF, found \"html\"");
}

}  // namespace
}  // namespace lustro
