// OpenGL as a second judge: Mesa draws the same scenes, by its fixed function and by our shaders. At most 0.3 % of the pixels may differ by more
// than 2/255, and each of those must lie at an edge. Without OSMesa (libosmesa6-dev) the tests skip.
#include <gtest/gtest.h>

#ifndef LUSTRO_HAS_OSMESA

TEST(OpenGL, IsNotHere) {
  GTEST_SKIP() << "built without OSMesa (Debian: libosmesa6-dev), so OpenGL does not judge";
}

#else

#include <algorithm>
#include <cctype>
#include <cstdio>

#include "lustro/lustro.hpp"
#include "peers/gl.hpp"
#include "peers/peer_scenes.hpp"
#include "peers/picture_difference.hpp"
#include "truth/scene_tree.hpp"

namespace lustro::peers {
namespace {

using Draw = ByteImage (*)(GlContext&, const Scene&);

/// What LeakSanitizer finds in Mesa is Mesa's.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libOSMesa\nleak:libLLVM\n";
}

/// Compares scene after scene, says how each one did and keeps the worst as a picture.
class Judge {
 public:
  Judge(std::string name, Draw draw) : name_(std::move(name)), draw_(draw) {}

  /// Whether the next scene is one that is looked at.
  [[nodiscard]] bool wants_next() { return count_++ % truth::scene_stride() == 0; }

  void look_at(const std::string& scene_name, const Scene& scene, bool is_told) {
    const ByteImage peer = draw_(context_, scene);
    const PictureDifference d = compare_with_peer(scene, peer);
    if (is_told) {
      std::printf("%-10s %-70s %6.3f %% over 2/255, %ld away from edges, worst there %d\n", name_.c_str(), scene_name.c_str(), 100 * d.share(),
                  d.strays, d.worst);
    }
    EXPECT_LE(d.share(), 0.003) << name_ << " " << scene_name;
    EXPECT_EQ(d.strays, 0) << name_ << " " << scene_name << " " << d.stray;
    ++scenes_;
    pixels_ += d.pixels;
    over_ += d.over;
    worst_ = std::max(worst_, d.worst);
    const long badness = d.strays * 1000000 + d.over;
    if (badness >= worst_badness_) {
      worst_badness_ = badness;
      worst_name_ = scene_name;
      worst_ours_ = d.ours;
      worst_peer_ = peer;
    }
  }

  /// The sum, and the worst scene as `ours | peer | 8 x difference`.
  void conclude() const {
    ASSERT_GT(scenes_, 0);
    std::string file = name_ + "_" + worst_name_ + ".png";
    std::replace_if(
        file.begin(), file.end(), [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-'; }, '_');
    write_triple(std::filesystem::path(LUSTRO_PEERS_DIR) / file, worst_ours_, worst_peer_);
    std::printf("%s: %d scenes, %.4f %% of the pixels over 2/255, worst away from edges %d/255; the worst scene is %s/%s\n", name_.c_str(),
                scenes_, 100.0 * static_cast<double>(over_) / static_cast<double>(pixels_), worst_, LUSTRO_PEERS_DIR, file.c_str());
  }

 private:
  std::string name_;
  Draw draw_;
  GlContext context_;
  std::size_t count_ = 0;
  int scenes_ = 0;
  long pixels_ = 0, over_ = 0, worst_badness_ = -1;
  int worst_ = 0;
  std::string worst_name_;
  ByteImage worst_ours_, worst_peer_;
};

class OpenGL : public testing::TestWithParam<std::string> {};

TEST_P(OpenGL, FixedFunctionDrawsTheSameGouraud) {
  Judge judge("fixed", draw_with_fixed_function);
  for (const PeerScene& peer : fixed_function_scenes(GetParam())) {
    for (const Lighting lighting : {Lighting::blinn_phong, Lighting::lambert}) {
      for (const bool two_sided : {false, true}) {
        if (!judge.wants_next()) {
          continue;
        }
        Scene scene = peer.scene;
        scene.shading.lighting = lighting;
        scene.shading.two_sided = two_sided;
        judge.look_at(peer.name + (lighting == Lighting::lambert ? "/lambert" : "/blinn-phong") + (two_sided ? "/two_sided" : ""), scene, true);
      }
    }
  }
  judge.conclude();
}

// OpenGL's flat shading shows the colour of one vertex, ours that of the centre: the same where neither light nor eye is near.
TEST_P(OpenGL, FixedFunctionDrawsTheSameFlatFacesUnderDistantLightAndEye) {
  Judge judge("fixed", draw_with_fixed_function);
  for (const PeerScene& peer : fixed_function_scenes(GetParam())) {
    const auto& lights = *peer.scene.lights;
    const bool is_distant = std::all_of(lights.begin(), lights.end(), [](const Light& light) { return light.type == LightType::directional; });
    if (is_distant && peer.scene.camera.projection == Projection::orthographic) {
      Scene scene = peer.scene;
      scene.shading.interpolation = Interpolation::flat;
      judge.look_at(peer.name + "/flat", scene, true);
    }
  }
  judge.conclude();
}

TEST_P(OpenGL, ShadersDrawTheSame) {
  Judge judge("glsl", draw_with_glsl);
  std::vector<PeerScene> scenes = fixed_function_scenes(GetParam());
  for (PeerScene& scene : shader_scenes(GetParam())) {
    scenes.push_back(std::move(scene));
  }
  std::size_t turn = 0;
  for (const PeerScene& peer : scenes) {
    for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud, Interpolation::phong}) {
      for (const Lighting lighting : {Lighting::phong, Lighting::blinn_phong, Lighting::lambert}) {
        if ((lighting == Lighting::lambert && turn % 4 != 0) || !judge.wants_next()) {
          ++turn;
          continue;
        }
        Scene scene = peer.scene;
        scene.shading.interpolation = interpolation;
        scene.shading.lighting = lighting;
        scene.shading.two_sided = turn % 3 == 1;
        scene.shading.normalized = turn % 5 == 2;
        if (turn % 7 == 3) {
          scene.fog = Fog{.mode = static_cast<FogMode>(turn % 3), .density = 0.15, .start = 2, .end = 7, .color = {{0.5F, 0.6F, 0.7F}}};
        }
        judge.look_at(peer.name +
                          (lighting == Lighting::lambert ? "/lambert/"
                           : lighting == Lighting::phong ? "/phong/"
                                                         : "/blinn-phong/") +
                          (interpolation == Interpolation::flat      ? "flat"
                           : interpolation == Interpolation::gouraud ? "gouraud"
                                                                     : "phong") +
                          (scene.shading.two_sided ? "/two_sided" : "") + (scene.shading.normalized ? "/normalized" : "") +
                          (scene.fog ? "/fog" : ""),
                      scene, true);
        ++turn;
      }
    }
  }
  judge.conclude();
}

std::vector<std::string> all_subjects() {
  return subjects();
}
INSTANTIATE_TEST_SUITE_P(Each, OpenGL, testing::ValuesIn(all_subjects()), [](const auto& param) { return param.param; });

/// What the shaders have no words for.
bool is_beyond_shaders(const Scene& scene) {
  const ImageSettings& image = scene.image;
  if (image.samples != 1 || image.transparent || image.background_alpha != 1 || scene.shading.normals == NormalInterpolation::slerp) {
    return true;
  }
  return std::any_of(scene.objects.begin(), scene.objects.end(), [](const Object& object) {
    // Mesa's pow() is a polynomial whose error the exponent multiplies.
    const Material material = object.material.value_or(Material{});
    return !object.mesh->colors.empty() || !object.mesh->materials.empty() || material.shininess > 200 || material.opacity < 1 ||
           material.textures != MaterialTextures{};
  });
}

TEST(OpenGLTree, ShadersDrawTheTreeOfScenes) {
  Judge judge("glsl", draw_with_glsl);
  for (const truth::TreeScene* entry : truth::chosen_scenes()) {
    if (!is_beyond_shaders(entry->scene)) {
      judge.look_at("tree/" + entry->name, entry->scene, false);
    }
  }
  judge.conclude();
}

TEST(OpenGLTree, SaysWhichMesaJudges) {
  Scene scene;
  GlContext context;
  context.begin(scene);
  std::printf("%s\n", gl_description().c_str());
  EXPECT_NE(gl_description().find("Mesa"), std::string::npos);
}

}  // namespace
}  // namespace lustro::peers

#endif
