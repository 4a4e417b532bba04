// Views packed by libmeshoptimizer, and our filters beside the library's.
#include "io/gltf_meshopt.hpp"

#include <cstring>
#include <random>

#include "gltf_testing.hpp"

#ifdef LUSTRO_HAS_MESHOPT
#include <meshoptimizer.h>

namespace lustro {
namespace {

using Filter = GltfMeshopt::Filter;

TEST(GltfMeshopt, AttributesAndIndicesComeBack) {
  std::mt19937 random(5);
  std::vector<float> values(300);
  for (float& value : values) {
    value = static_cast<float>(random() % 1000) / 8;
  }
  std::vector<unsigned char> packed(meshopt_encodeVertexBufferBound(100, 12));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), values.data(), 100, 12));
  const std::string_view bytes(reinterpret_cast<const char*>(packed.data()), packed.size());
  GltfMeshopt view;
  view.stride = 12;
  view.count = 100;
  const FileBytes back = good(unpack_meshopt(bytes, view));
  ASSERT_EQ(back.size, 1200U);
  EXPECT_EQ(std::memcmp(back.data.get(), values.data(), 1200), 0);
  for (std::size_t length = 0; length < bytes.size(); length += 7) {
    EXPECT_FALSE(unpack_meshopt(std::string(bytes.substr(0, length)), view)) << length;
  }
}

/// What the library's filter and ours make of random elements; ours may round the last bit otherwise.
template <class T, class Theirs>
void expect_same_filter(Filter filter, std::size_t stride, std::vector<T> elements, const Theirs& theirs, double tolerance) {
  GltfMeshopt view;
  view.stride = stride;
  view.count = elements.size() * sizeof(T) / stride;
  view.filter = filter;
  std::vector<T> ours = elements;
  undo_meshopt_filter(reinterpret_cast<char*>(ours.data()), view);
  theirs(elements.data(), view.count, stride);
  for (std::size_t i = 0; i < ours.size(); ++i) {
    ASSERT_NEAR(static_cast<double>(ours[i]), static_cast<double>(elements[i]), tolerance) << i;
  }
}

TEST(GltfMeshopt, FiltersDoWhatTheLibrarysDo) {
  std::mt19937 random(6);
  const auto whole = [&](int least, int most) { return least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)); };
  std::vector<std::int8_t> small;
  std::vector<std::int16_t> large;
  std::vector<std::int16_t> turns;
  for (int i = 0; i < 1000; ++i) {
    for (const int part : {whole(-127, 127), whole(-127, 127), 127, whole(-128, 127)}) {
      small.push_back(static_cast<std::int8_t>(part));
    }
    for (const int part : {whole(-2047, 2047), whole(-2047, 2047), 2047, whole(-32768, 32767)}) {
      large.push_back(static_cast<std::int16_t>(part));
    }
    for (const int part : {whole(-1023, 1023), whole(-1023, 1023), whole(-1023, 1023), 1020 + whole(0, 3)}) {
      turns.push_back(static_cast<std::int16_t>(part));
    }
  }
  expect_same_filter(Filter::octahedral, 4, small, meshopt_decodeFilterOct, 1);
  expect_same_filter(Filter::octahedral, 8, large, meshopt_decodeFilterOct, 1);
  expect_same_filter(Filter::quaternion, 8, turns, meshopt_decodeFilterQuat, 1);
  const std::vector<float> numbers{0, 1, -2.5F, 1000, 1e-6F, 3.25e8F, -1e20F, 0.1F};
  std::vector<float> packed(numbers.size());
  meshopt_encodeFilterExp(packed.data(), numbers.size(), 4, 23, numbers.data());
  expect_same_filter(Filter::exponential, 4, packed, meshopt_decodeFilterExp, 0);
}

TEST(GltfMeshopt, APackedViewIsReadAndItsFaultsAreNamed) {
  GltfMaker maker;
  const std::vector<float> positions{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::vector<std::uint8_t> packed(meshopt_encodeVertexBufferBound(3, 12));
  packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), positions.data(), 3, 12));
  maker.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  maker.json["extensionsRequired"] = {"EXT_meshopt_compression"};
  maker.bytes.assign(packed.begin(), packed.end());
  maker.json["bufferViews"] = {{{"buffer", 1},
                                {"byteLength", 36},
                                {"extensions",
                                 {{"EXT_meshopt_compression",
                                   {{"buffer", 0}, {"byteLength", packed.size()}, {"byteStride", 12}, {"count", 3}, {"mode", "ATTRIBUTES"}}}}}}};
  maker.json["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}};
  maker.add_node_with({{"attributes", {{"POSITION", 0}}}});
  const auto load = [&] {
    nlohmann::json whole = nlohmann::json::parse(maker.text());
    whole["buffers"].push_back({{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
    Result<GltfModel> model = parse_gltf(whole.dump(), "t.gltf", {}, {});
    return model ? gltf_whole_mesh(*model) : tl::unexpected(model.error());
  };
  EXPECT_EQ(good(load()).positions[1], (Vec3f{1, 0, 0}));
  nlohmann::json& view = maker.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"];
  const std::string path = "t.gltf: bufferViews[0].extensions.EXT_meshopt_compression";
  view["count"] = 4;
  EXPECT_EQ(bad(load()).where, path + ".count");
  view["count"] = 3;
  view["mode"] = "TRIANGLES";
  EXPECT_EQ(bad(load()).where, path + ".byteStride");
  view["mode"] = "ATTRIBUTES";
  view["filter"] = "ODD";
  EXPECT_EQ(bad(load()).where, path + ".filter");
  view.erase("filter");
  maker.bytes[0] = 1;
  EXPECT_EQ(bad(load()).text(), path + ": its bytes cannot be unpacked");
}

}  // namespace
}  // namespace lustro
#endif
