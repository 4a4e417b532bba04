// A picture by paths that was interrupted ends with the bits of one that was not; files that do not fit are refused.
#include "path/state.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "image/hash.hpp"
#include "lustro/image.hpp"
#include "path_testing.hpp"

namespace lustro {
namespace {

using ::testing::HasSubstr;

PathState example() {
  PathState state{.width = 3, .height = 2, .samples = 5, .rays = 1234567890123, .fingerprint = 0x0123456789ABCDEF, .probe = 77, .pixels = {}};
  for (int i = 0; i < 6; ++i) {
    const double d = i + 0.25;
    state.pixels.push_back({{d, 2 * d, 1e-300 * d}, {d * d, 4 * d, 0}, 1e20 * d, 1.0 / 3, i % 2 == 1});
  }
  return state;
}

// With a checksum that is right for what was changed.
std::vector<std::byte> sealed(std::vector<std::byte> bytes) {
  const std::uint64_t sum = xxh64(std::span(bytes).first(bytes.size() - 8), 0);
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[bytes.size() - 8 + i] = static_cast<std::byte>(sum >> (8 * i));
  }
  return bytes;
}

std::string refusal(const std::vector<std::byte>& bytes, int width = 3, int height = 2) {
  const auto state = decode_path_state(bytes, "x", width, height);
  return state ? "" : state.error().text();
}

TEST(PathState, BytesHoldAllOfIt) {
  const PathState state = example();
  const std::vector<std::byte> bytes = encode_path_state(state);
  EXPECT_EQ(bytes.size(), 44U + 6 * 65 + 8);
  const auto read = decode_path_state(bytes, "x", 3, 2);
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->samples, 5);
  EXPECT_EQ(read->rays, state.rays);
  EXPECT_EQ(read->fingerprint, state.fingerprint);
  EXPECT_EQ(read->probe, state.probe);
  EXPECT_EQ(hash_sums(read->pixels), hash_sums(state.pixels));
  EXPECT_EQ(encode_path_state(*read), bytes);
}

TEST(PathState, BytesThatDoNotFitAreRefused) {
  const std::vector<std::byte> good = encode_path_state(example());
  EXPECT_THAT(refusal({}), HasSubstr("begins with LUSTROP1"));
  EXPECT_THAT(refusal({good.begin(), good.begin() + 12}), HasSubstr("byte 12"));
  EXPECT_THAT(refusal(good, 2, 3), HasSubstr("3 x 2 pixels, not 2 x 3"));
  EXPECT_THAT(refusal({good.begin(), good.end() - 1}), HasSubstr("441 bytes, expected 442"));
  for (std::size_t i = 16; i < good.size(); ++i) {
    std::vector<std::byte> bytes = good;
    bytes[i] ^= std::byte{4};
    EXPECT_THAT(refusal(bytes), HasSubstr("damaged")) << i;
  }
  std::vector<std::byte> bytes = good;
  bytes[16] = std::byte{0};
  EXPECT_THAT(refusal(sealed(bytes)), HasSubstr("byte 16: 0 paths a pixel"));
  PathState endless = example();
  endless.pixels[1].squares[2] = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(encode_path_state(endless)), HasSubstr("byte 108: a pixel's sums"));
  PathState negative = example();
  negative.pixels[0].color[0] = -1;
  EXPECT_THAT(refusal(encode_path_state(negative)), HasSubstr("byte 44: a pixel's sums"));
}

TEST(PathState, AnAbsentFileIsNoState) {
  const auto state = read_path_state(std::filesystem::path(::testing::TempDir()) / "lustro_there_is_none", 3, 2);
  ASSERT_TRUE(state);
  EXPECT_FALSE(state->has_value());
}

TEST(PathState, FingerprintsTellWhatPathsBring) {
  Scene scene = look({0, 0, 5}, 1);
  scene.objects.push_back(object(square(0.5F), lambert(0.5F)));
  const PathOptions options;
  const std::uint64_t print = path_fingerprint(scene, options);
  Scene other = scene;
  other.objects[0].material->diffuse = gray(0.51F);
  EXPECT_NE(path_fingerprint(other, options), print);
  other = scene;
  other.camera.eye = Vec3d{0, 0, 6};
  EXPECT_NE(path_fingerprint(other, options), print);
  EXPECT_NE(path_fingerprint(scene, {.bounces = 3}), print);
  EXPECT_NE(path_fingerprint(scene, {.seed = 3}), print);
  other = scene;
  other.image.tone.exposure = 2;
  EXPECT_EQ(path_fingerprint(other, {.samples = 9}), print);
}

class Resuming : public ::testing::Test {
 protected:
  void SetUp() override {
    LUSTRO_REQUIRE_PATHS();
    scene_.objects.push_back(object(primitive("sphere"), highlight(Lighting::phong, 0.5F, 20)));
    scene_.objects.push_back(object(square(2), lambert(0.7F), moved(0, 0, -1)));
    scene_.environment = white_sky();
    options_.engine = Engine::path;
    options_.aovs = {{.kind = AovKind::variance}};
    std::filesystem::remove(file_);
  }
  void TearDown() override { std::filesystem::remove(file_); }

  [[nodiscard]] Result<Rendering> draw(int samples, int threads, bool resumes) const {
    RenderOptions options = options_;
    options.threads = threads;
    options.path.samples = samples;
    options.path.resume = resumes ? file_ : std::filesystem::path();
    return render(scene_, options);
  }

  Scene scene_ = look({0, 0, 5}, 3);
  RenderOptions options_;
  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) / ("lustro_" + std::to_string(::testing::UnitTest::GetInstance()->random_seed()) +
                                                     ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Resuming, PreviewsAreThePicturesOfSoManyPaths) {
  const auto whole = draw(41, 2, false);
  ASSERT_TRUE(whole) << whole.error().text();
  std::vector<int> seen;
  options_.path.preview_seconds = 0;
  options_.path.preview = [&](const Rendering& so_far) -> Result<void> {
    options_.path.preview = nullptr;
    const auto same = draw(so_far.stats.samples, 1, false);
    seen.push_back(so_far.stats.samples);
    EXPECT_EQ(so_far.color.pixels, same->color.pixels);
    EXPECT_EQ(so_far.layers[0].image.pixels, same->layers[0].image.pixels);
    EXPECT_EQ(so_far.stats.pixels_covered, same->stats.pixels_covered);
    EXPECT_EQ(so_far.stats.error, same->stats.error);
    return {};
  };
  const RenderOptions shown = options_;
  RenderOptions asked = shown;
  asked.threads = 2;
  asked.path.samples = 41;
  const auto drawn = render(scene_, asked);
  ASSERT_TRUE(drawn);
  EXPECT_EQ(seen.front(), 1);  // a first look soon
  EXPECT_LT(seen.back(), 41);  // the last one is the result
  EXPECT_EQ(drawn->color.pixels, whole->color.pixels);

  asked.path.preview = [](const Rendering&) -> Result<void> { return fail(ErrorKind::io, "full", "is full"); };
  const auto failed = render(scene_, asked);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().text(), "full: is full");
}

TEST_F(Resuming, APictureThatWasInterruptedEndsWithTheBitsOfOneThatWasNot) {
  const auto whole = draw(41, 2, false);
  ASSERT_TRUE(whole);
  int before = 0;
  for (const int samples : {1, 18, 41}) {
    const auto part = draw(samples, samples % 3 + 1, true);
    ASSERT_TRUE(part) << part.error().text();
    EXPECT_EQ(part->stats.samples, samples);
    EXPECT_EQ(part->stats.samples_resumed, before);
    before = samples;
    if (samples == 41) {
      EXPECT_EQ(part->color.pixels, whole->color.pixels);
      EXPECT_EQ(part->layers[0].image.pixels, whole->layers[0].image.pixels);
      EXPECT_EQ(part->stats.rays, whole->stats.rays);
      EXPECT_EQ(part->stats.error, whole->stats.error);
      EXPECT_EQ(part->stats.pixels_covered, whole->stats.pixels_covered);
    }
  }
  const auto again = draw(7, 1, true);  // what is there is not thrown away
  ASSERT_TRUE(again);
  EXPECT_EQ(again->stats.samples, 41);
  EXPECT_EQ(again->color.pixels, whole->color.pixels);
}

TEST_F(Resuming, AnotherSceneAndOtherFilesAreRefused) {
  ASSERT_TRUE(draw(4, 1, true));
  options_.path.seed = 1;
  auto refused = draw(8, 1, true);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::usage);
  EXPECT_THAT(refused.error().text(), HasSubstr("another scene, or to other flags"));
  options_.path.seed = 0;
  scene_.objects[1].mesh = square(1.9F);  // the scene's text is the same
  refused = draw(8, 1, true);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().text(), HasSubstr("saw another picture"));
}

TEST_F(Resuming, AFileThatCannotBeWrittenIsKnownAtOnce) {
  file_ = "/there is no folder/of this name";
  const auto refused = draw(1 << 20, 1, true);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::io);
}

}  // namespace
}  // namespace lustro
