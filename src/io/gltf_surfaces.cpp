// `samplers`, `images`, `textures` and `materials` with the extensions that say what a surface looks like.
#include <fmt/format.h>

#include "io/gltf_document.hpp"
#include "math/trig.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

constexpr NumberRange kShare{0, 1};
constexpr NumberRange kNotNegative{.lower = 0};

Wrap read_wrap(GltfReader& reader, const Json& json, std::string_view key) {
  switch (const std::uint64_t code = reader.whole(json, key, {}, 10497)) {
    case 33071:
      return Wrap::clamp_to_edge;
    case 33648:
      return Wrap::mirrored_repeat;
    case 10497:
      break;
    default:
      reader.fail(json, key, fmt::format("{} is none of 33071, 33648, 10497", code));
  }
  return Wrap::repeat;
}

void read_samplers(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "samplers")) {
    Sampler sampler;
    sampler.wrap_u = read_wrap(reader, json, "wrapS");
    sampler.wrap_v = read_wrap(reader, json, "wrapT");
    const std::uint64_t magnify = reader.whole(json, "magFilter", {}, 9729);
    if (magnify != 9728 && magnify != 9729) {
      reader.fail(json, "magFilter", fmt::format("{} is neither 9728 nor 9729", magnify));
    }
    sampler.magnify = magnify == 9728 ? TextureFilter::nearest : TextureFilter::linear;
    const std::uint64_t minify = reader.whole(json, "minFilter", {}, 9987);
    if (minify != 9728 && minify != 9729 && (minify < 9984 || minify > 9987)) {
      reader.fail(json, "minFilter", fmt::format("{} is none of 9728, 9729, 9984..9987", minify));
    }
    sampler.minify = minify % 2 == 0 ? TextureFilter::nearest : TextureFilter::linear;
    sampler.mip = minify < 9984 ? MipFilter::none : minify < 9986 ? MipFilter::nearest : MipFilter::linear;
    document.samplers.push_back(sampler);
  }
}

void read_images(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "images")) {
    GltfImage image;
    image.name = reader.text(json, "name");
    image.view = reader.index(json, "bufferView", document.views.size(), "bufferViews");
    static_cast<void>(reader.text(json, "mimeType"));
    if (const Json* uri = GltfReader::find(json, "uri")) {
      static_cast<void>(reader.text(json, "uri"));
      image.uri = reader.failed() ? nullptr : &uri->get_ref<const std::string&>();
    }
    if ((image.uri == nullptr) == (image.view == kGltfNone)) {
      reader.fail(json, image.uri == nullptr ? "is missing both uri and bufferView" : "states both uri and bufferView");
    }
    document.images.push_back(image);
  }
}

void read_textures(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "textures")) {
    GltfTexture texture;
    texture.sampler = reader.index(json, "sampler", document.samplers.size(), "samplers");
    texture.image = reader.index(json, "source", document.images.size(), "images");
    if (const Json* webp = reader.extension(json, "EXT_texture_webp")) {
      texture.image = reader.needed_index(*webp, "source", document.images.size(), "images");
    }
    document.textures.push_back(texture);
  }
}

std::optional<GltfTextureUse> read_use(GltfReader& reader, const Json& parent, std::string_view key, const GltfDocument& document,
                                       std::string_view amount_key = {}) {
  if (GltfReader::find(parent, key) == nullptr) {
    return std::nullopt;
  }
  const Json& json = reader.table(parent, key);
  if (reader.failed()) {
    return std::nullopt;
  }
  GltfTextureUse use;
  use.texture = reader.needed_index(json, "index", document.textures.size(), "textures");
  std::uint64_t set = reader.whole(json, "texCoord", {0, 255}, 0);
  if (!amount_key.empty()) {
    use.amount = reader.number(json, amount_key, {}, 1);
  }
  if (const Json* transform = reader.extension(json, "KHR_texture_transform")) {
    const auto offset = reader.numbers<2>(*transform, "offset", {0, 0});
    const auto scale = reader.numbers<2>(*transform, "scale", {1, 1});
    const double rotation = reader.number(*transform, "rotation", {-1000, 1000}, 0);
    set = reader.whole(*transform, "texCoord", {0, 255}, set);
    const double c = cosine(rotation);
    const double s = sine(rotation);
    // Counter-clockwise for who looks at the picture, whose v goes down.
    use.uv_matrix = {static_cast<float>(c * scale[0]),  static_cast<float>(s * scale[1]), static_cast<float>(offset[0]),
                     static_cast<float>(-s * scale[0]), static_cast<float>(c * scale[1]), static_cast<float>(offset[1])};
  }
  use.uv_set = static_cast<std::uint32_t>(set);
  return use;
}

void read_extensions(GltfReader& reader, const Json& json, const GltfDocument& document, GltfMaterial& material) {
  material.is_unlit = reader.extension(json, "KHR_materials_unlit") != nullptr;
  if (const Json* strength = reader.extension(json, "KHR_materials_emissive_strength")) {
    material.emissive_strength = reader.number(*strength, "emissiveStrength", kNotNegative, 1);
  }
  if (const Json* ior = reader.extension(json, "KHR_materials_ior")) {
    material.ior = reader.number(*ior, "ior", kNotNegative, 1.5);
    if (material.ior > 0 && material.ior < 1) {
      reader.fail(*ior, "ior", fmt::format("{} is outside 1.. (or 0)", material.ior));
    }
  }
  if (const Json* specular = reader.extension(json, "KHR_materials_specular")) {
    material.specular = reader.number(*specular, "specularFactor", kShare, 1);
    material.specular_color = reader.numbers<3>(*specular, "specularColorFactor", {1, 1, 1}, kNotNegative);
    material.specular_map = read_use(reader, *specular, "specularTexture", document);
    material.specular_color_map = read_use(reader, *specular, "specularColorTexture", document);
  }
  if (const Json* glossy = reader.extension(json, "KHR_materials_pbrSpecularGlossiness")) {
    material.is_specular_glossiness = true;
    material.base = reader.numbers<4>(*glossy, "diffuseFactor", {1, 1, 1, 1}, kShare);
    material.glossy_specular = reader.numbers<3>(*glossy, "specularFactor", {1, 1, 1}, kShare);
    material.glossiness = reader.number(*glossy, "glossinessFactor", kShare, 1);
    material.base_map = read_use(reader, *glossy, "diffuseTexture", document);
    material.metallic_roughness_map = {};
    material.specular_glossiness_map = read_use(reader, *glossy, "specularGlossinessTexture", document);
  }
}

GltfMaterial read_material(GltfReader& reader, const Json& json, const GltfDocument& document) {
  GltfMaterial material;
  material.name = reader.text(json, "name");
  const Json& metal = reader.table(json, "pbrMetallicRoughness");
  material.base = reader.numbers<4>(metal, "baseColorFactor", {1, 1, 1, 1}, kShare);
  material.metallic = reader.number(metal, "metallicFactor", kShare, 1);
  material.roughness = reader.number(metal, "roughnessFactor", kShare, 1);
  material.base_map = read_use(reader, metal, "baseColorTexture", document);
  material.metallic_roughness_map = read_use(reader, metal, "metallicRoughnessTexture", document);
  material.normal_map = read_use(reader, json, "normalTexture", document, "scale");
  material.occlusion_map = read_use(reader, json, "occlusionTexture", document, "strength");
  material.emissive_map = read_use(reader, json, "emissiveTexture", document);
  material.emissive = reader.numbers<3>(json, "emissiveFactor", {0, 0, 0}, kShare);
  const std::string alpha = reader.text(json, "alphaMode");
  if (!alpha.empty() && alpha != "OPAQUE" && alpha != "MASK" && alpha != "BLEND") {
    reader.fail(json, "alphaMode", "is none of OPAQUE, MASK, BLEND");
  }
  material.alpha = alpha == "MASK" ? GltfMaterial::Alpha::mask : alpha == "BLEND" ? GltfMaterial::Alpha::blend : GltfMaterial::Alpha::opaque;
  material.alpha_cutoff = reader.number(json, "alphaCutoff", kNotNegative, 0.5);
  material.is_double_sided = reader.boolean(json, "doubleSided", false);
  read_extensions(reader, json, document, material);
  return material;
}

}  // namespace

void read_gltf_materials(GltfReader& reader, const Json& root, GltfDocument& document) {
  read_samplers(reader, root, document);
  read_images(reader, root, document);
  read_textures(reader, root, document);
  for (const Json& json : reader.tables(root, "materials")) {
    if (reader.failed()) {
      return;
    }
    document.materials.push_back(read_material(reader, json, document));
  }
}

}  // namespace lustro
