// The tree's scenes with maps. Pictures are made in code, of whole numbers, so that they have the same bits on every machine.
#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "truth/tree_parts.hpp"

namespace lustro::truth {
namespace {

constexpr std::array kProjections{Projection::perspective, Projection::orthographic};

/// A number of 0..255 that looks random: an integer hash of the texel's place.
std::uint32_t scattered(std::uint32_t x, std::uint32_t y, std::uint32_t c, std::uint32_t seed) {
  std::uint32_t h = x * 0x9E3779B1U + y * 0x85EBCA77U + c * 0xC2B2AE3DU + seed * 0x27D4EB2FU;
  h = (h ^ h >> 15) * 0x2C1B3C6DU;
  h = (h ^ h >> 12) * 0x297A2D39U;
  return (h ^ h >> 15) & 255U;
}

/// Blocks of 8-bit values between `low` and 255.
Image blocks(int width, int height, int channels, std::uint32_t seed, int block, std::uint32_t low) {
  Image image(width, height, channels);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < channels; ++c) {
        const std::uint32_t value =
            scattered(static_cast<std::uint32_t>(x / block), static_cast<std::uint32_t>(y / block), static_cast<std::uint32_t>(c), seed);
        image.at(x, y)[static_cast<std::size_t>(c)] = static_cast<float>(low + value * (255 - low) / 255) / 255;
      }
    }
  }
  return image;
}

/// Normals of low hills: 0.6 and 0.8 make unit vectors without a root.
Image hills(int size) {
  Image image(size, size, 3);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const int slope = static_cast<int>(scattered(static_cast<std::uint32_t>(x / 4), static_cast<std::uint32_t>(y / 4), 0, 77) % 5);
      const Vec3f n = std::array<Vec3f, 5>{
          {{0, 0, 1}, {0.6F, 0, 0.8F}, {-0.6F, 0, 0.8F}, {0, 0.6F, 0.8F}, {0, -0.6F, 0.8F}}}[static_cast<std::size_t>(slope)];
      const auto texel = image.at(x, y);
      texel[0] = n.x * 0.5F + 0.5F;
      texel[1] = n.y * 0.5F + 0.5F;
      texel[2] = n.z * 0.5F + 0.5F;
    }
  }
  return image;
}

TextureUse use_of(const Image& image, const Sampler& sampler = {}) {
  auto texture = make_texture(image, 1);
  if (!texture) {
    throw std::runtime_error(texture.error().text());
  }
  TextureUse use;
  use.texture = *std::move(texture);
  use.sampler = sampler;
  use.name = "made in code";
  return use;
}

/// Three repeats across, turned by exact decimals, moved.
constexpr std::array<float, 6> kTurned{2.4F, -1.8F, 0.3F, 1.8F, 2.4F, -0.2F};

/// Changes the textures of the curved objects and of the floor.
using Change = std::function<void(Material&)>;

class Branch {
 public:
  explicit Branch(std::vector<TreeScene>& tree) : tree_(tree) {}

  /// Both cameras; the lights, their attenuation, the transfer and the lighting turn from scene to scene.
  void add(const std::string& name, bool is_judged, const Change& change, const std::function<void(Scene&)>& adjust = {}) {
    for (const Projection projection : kProjections) {
      TreeScene entry = base_scene(0, projection);
      entry.name = (is_judged ? "textures/" : "pictures/") + name + "/" + word(projection);
      entry.is_judged = is_judged;
      Scene& scene = entry.scene;
      scene.image.transfer = turn_ % 2 == 0 ? Transfer::srgb : Transfer::none;
      scene.shading.lighting = turn_ % 3 == 0 ? Lighting::phong : Lighting::blinn_phong;
      scene.lights = light_kinds().back().lights(attenuations()[turn_ % attenuations().size()].value);
      ++turn_;
      for (Object& object : scene.objects) {
        object.source.clear();  // a scene file cannot state these pictures
        change(*object.material);
      }
      if (adjust) {
        adjust(scene);
      }
      tree_.push_back(std::move(entry));
    }
  }

 private:
  std::vector<TreeScene>& tree_;
  std::size_t turn_ = 0;
};

void add_judged(Branch& branch) {
  branch.add("colors", true, [](Material& m) {
    m.textures.ambient = use_of(blocks(16, 16, 3, 1, 1, 40));
    m.textures.diffuse = use_of(blocks(32, 16, 3, 2, 1, 40));
    m.textures.specular = use_of(blocks(13, 7, 3, 3, 1, 20));
    m.textures.emission = use_of(blocks(8, 8, 4, 4, 1, 0));
  });
  branch.add("minified", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(256, 256, 3, 5, 2, 0));
    m.textures.diffuse->uv_matrix = kTurned;
  });
  const std::array<std::pair<const char*, Wrap>, 4> wraps{{{"repeat", Wrap::repeat},
                                                           {"mirrored_repeat", Wrap::mirrored_repeat},
                                                           {"clamp_to_edge", Wrap::clamp_to_edge},
                                                           {"clamp_to_border", Wrap::clamp_to_border}}};
  for (const auto& [name, wrap] : wraps) {
    for (const TextureFilter filter : {TextureFilter::nearest, TextureFilter::linear}) {
      branch.add(std::string("wrap/") + name + (filter == TextureFilter::nearest ? "/nearest" : "/trilinear"), true,
                 [=, wrap = wrap](Material& m) {
                   Sampler sampler{.wrap_u = wrap, .wrap_v = wrap, .magnify = filter, .minify = filter, .border = {0.9F, 0.2F, 0.1F, 1}};
                   sampler.mip = filter == TextureFilter::nearest ? MipFilter::none : MipFilter::linear;
                   m.textures.diffuse = use_of(blocks(6, 5, 3, 6, 1, 30), sampler);
                   m.textures.diffuse->uv_matrix = kTurned;
                 });
    }
  }
  branch.add("wrap/differs_along_u_and_v", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(6, 5, 3, 6, 1, 30), {.wrap_u = Wrap::mirrored_repeat, .wrap_v = Wrap::clamp_to_edge});
    m.textures.diffuse->uv_matrix = kTurned;
  });
  branch.add("no_mips", true, [](Material& m) { m.textures.diffuse = use_of(blocks(16, 16, 3, 7, 1, 60), {.mip = MipFilter::none}); });
  branch.add("sharper", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(64, 64, 3, 7, 2, 60), {.lod_bias = -0.75F});
    m.textures.specular = use_of(blocks(64, 64, 3, 8, 2, 60), {.lod_bias = 1.5F});
  });
  branch.add("blended_along_v", true,
             [](Material& m) { m.textures.diffuse = use_of(blocks(9, 9, 3, 9, 1, 60), {.mip = MipFilter::none, .blend_u = false}); });
  branch.add("shininess", true, [](Material& m) {
    m.textures.shininess = use_of(blocks(8, 8, 3, 10, 1, 64));
    m.textures.shininess->channel = 1;
    m.textures.specular = use_of(blocks(8, 8, 1, 11, 1, 64));
  });
  branch.add("shininess_luminance", true, [](Material& m) {
    m.textures.shininess = use_of(blocks(8, 8, 3, 12, 1, 64));
    m.textures.shininess->channel = 4;
    m.textures.shininess->gain = {1.5F, 1.5F, 1.5F};
    m.textures.shininess->base = {0.25F, 0.25F, 0.25F};
  });
  branch.add("decal", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(16, 16, 3, 13, 1, 60));
    m.textures.decal = use_of(blocks(8, 8, 4, 14, 1, 0));
  });
  branch.add("gain_and_base", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(16, 16, 3, 15, 1, 0));
    m.textures.diffuse->gain = {0.5F, 1.5F, -0.75F};
    m.textures.diffuse->base = {0.25F, 0, 0.875F};
  });
  branch.add("leaves_outside", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(6, 6, 3, 16, 1, 0), {.wrap_u = Wrap::clamp_to_edge, .wrap_v = Wrap::clamp_to_edge});
    m.textures.diffuse->uv_matrix = kTurned;
    m.textures.diffuse->leaves_outside = true;
  });
  branch.add(
      "second_coordinates", true,
      [](Material& m) {
        m.textures.diffuse = use_of(blocks(12, 12, 3, 17, 1, 40));
        m.textures.diffuse->uv_set = 1;
        m.textures.specular = use_of(blocks(12, 12, 3, 18, 1, 40));
      },
      [](Scene& scene) {
        for (Object& object : scene.objects) {
          Mesh mesh = *object.mesh;
          for (const Vec2f& uv : mesh.uvs) {
            mesh.uvs1.push_back({1 - 2 * uv.y, 3 * uv.x});
          }
          object.mesh = std::make_shared<const Mesh>(std::move(mesh));
        }
      });
  branch.add("hdr", true, [](Material& m) {
    Image bright = blocks(8, 8, 3, 19, 1, 0);
    for (float& x : bright.pixels) {
      x = x * 3 - 0.5F;
    }
    m.textures.emission = use_of(bright);
    m.emission = {{0.25F, 0.25F, 0.25F}};
    m.textures.emission->base = {0.5F, 0.5F, 0.5F};
  });
  branch.add(
      "terms", true,
      [](Material& m) {
        m.textures.ambient = use_of(blocks(16, 16, 3, 20, 1, 40));
        m.textures.diffuse = use_of(blocks(16, 16, 3, 21, 1, 40));
        m.textures.specular = use_of(blocks(16, 16, 3, 22, 1, 40));
        m.textures.decal = use_of(blocks(8, 8, 4, 23, 1, 0));
      },
      [](Scene& scene) {
        scene.shading.terms.ambient = false;
        scene.shading.terms.emission = false;
      });
  branch.add("unlit", true, [](Material& m) {
    m.textures.diffuse = use_of(blocks(16, 16, 3, 24, 1, 0));
    m.lighting = Lighting::constant;
  });
}

void everything(Material& m) {
  m.textures.diffuse = use_of(blocks(64, 64, 3, 30, 2, 40));
  m.textures.specular = use_of(blocks(64, 64, 3, 31, 2, 40));
  m.textures.shininess = use_of(blocks(16, 16, 1, 32, 1, 64));
  m.textures.normal = use_of(hills(64));
  m.textures.bump = use_of(blocks(32, 32, 1, 33, 4, 0));
  m.textures.bump->gain = {0.02F, 0.02F, 0.02F};
}

void add_pictures(Branch& branch) {
  branch.add("normal", false, [](Material& m) {
    m.textures.normal = use_of(hills(64));
    m.textures.normal->uv_matrix = kTurned;
  });
  branch.add(
      "normal_mirrored", false, [](Material& m) { m.textures.normal = use_of(hills(32)); },
      [](Scene& scene) {
        for (Object& object : scene.objects) {
          object.matrix = scaling(-1, 1, 1) * object.matrix;
        }
        scene.shading.two_sided = true;
      });
  branch.add("normal_of_the_object", false, [](Material& m) {
    m.textures.normal = use_of(hills(64));
    m.textures.normal_is_object_space = true;
  });
  branch.add("bump", false, [](Material& m) {
    m.textures.bump = use_of(blocks(32, 32, 1, 40, 4, 0));
    m.textures.bump->gain = {0.03F, 0.03F, 0.03F};
  });
  branch.add("anisotropic", false, [](Material& m) {
    m.textures.diffuse = use_of(blocks(128, 128, 3, 41, 4, 0), {.anisotropy = 8});
    m.textures.diffuse->uv_matrix = kTurned;
  });
  branch.add("nearest_mips", false,
             [](Material& m) { m.textures.diffuse = use_of(blocks(128, 128, 3, 42, 4, 0), {.mip = MipFilter::nearest}); });
  branch.add("everything", false, everything);
  branch.add("everything_of_many_samples", false, everything, [](Scene& scene) { scene.image.samples = 8; });
  for (const Interpolation interpolation : {Interpolation::flat, Interpolation::gouraud}) {
    branch.add(std::string(word(interpolation)), false, everything, [=](Scene& scene) { scene.shading.interpolation = interpolation; });
  }
  for (const AlphaMode mode : {AlphaMode::mask, AlphaMode::blend}) {
    branch.add(
        mode == AlphaMode::mask ? "opacity_mask" : "opacity_blend", false,
        [=](Material& m) {
          m.textures.opacity = use_of(blocks(8, 8, 1, 50, 1, 0));
          m.textures.diffuse = use_of(blocks(8, 8, 3, 51, 1, 40));
          m.alpha_mode = mode;
        },
        [](Scene& scene) { scene.image.samples = 4; });
  }
}

}  // namespace

void add_textures(std::vector<TreeScene>& tree) {
  Branch branch(tree);
  add_judged(branch);
  add_pictures(branch);
}

}  // namespace lustro::truth
