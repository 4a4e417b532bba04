// The keys of a material's `textures`, of one texture and of a reflection map.
#include <array>

#include "scene/fields.hpp"

namespace lustro {
namespace {

constexpr Range kColor{.lower = 0};
constexpr Range kAnisotropy{.lower = 1, .upper = 16};
constexpr Range kBias{.lower = -16, .upper = 16};
constexpr Range kUvSet{.lower = 0, .upper = 1};
constexpr Range kTurn{.lower = -360, .upper = 360};
constexpr Range kBounded{.lower = -1e9, .upper = 1e9};  // products of these are finite as floats

constexpr std::array kTexturesFields{
    Field<StatedTextures>{"ambient", "", at<&StatedTextures::ambient>, "colour, times k_a"},
    Field<StatedTextures>{"diffuse", "", at<&StatedTextures::diffuse>, "colour, times k_d"},
    Field<StatedTextures>{"specular", "", at<&StatedTextures::specular>, "colour, times k_s"},
    Field<StatedTextures>{"emission", "", at<&StatedTextures::emission>, "colour, times k_e"},
    Field<StatedTextures>{"shininess", "", at<&StatedTextures::shininess>, "one value, times n"},
    Field<StatedTextures>{"opacity", "", at<&StatedTextures::opacity>, "one value, times the opacity"},
    Field<StatedTextures>{"decal", "", at<&StatedTextures::decal>, "colour, laid over k_a and k_d by its alpha"},
    Field<StatedTextures>{"bump", "", at<&StatedTextures::bump>, "one value, a height in units of the surface that tilts the normal"},
    Field<StatedTextures>{"normal", "", at<&StatedTextures::normal>, "normals, rgb * 2 - 1 in the tangent frame"},
    Field<StatedTextures>{"displacement", "", at<&StatedTextures::displacement>,
                          "one value, a height in units of the mesh that moves the surface"},
    Field<StatedTextures>{"reflection", "", at<&StatedTextures::reflection>, "colours, times k_s, in the direction that the surface mirrors"},
    Field<StatedTextures>{"object_space", "", at<&StatedTextures::object_space>,
                          "the normals of `normal` are the object's, and of no tangent frame"},
};

constexpr std::array kTextureFields{
    Field<StatedTexture>{"file", "", at<&StatedTexture::file>, "the picture, relative to the scene file", "", {}, "must be stated"},
    Field<StatedTexture>{"wrap", "", at<&StatedTexture::wrap>, "what stands beside the picture's edge; a list of two words: along u and v"},
    Field<StatedTexture>{"magnify", "", at<&StatedTexture::magnify>, "how texels become a value where they are larger than pixels"},
    Field<StatedTexture>{"minify", "", at<&StatedTexture::minify>, "the same where they are smaller"},
    Field<StatedTexture>{"mip", "", at<&StatedTexture::mip>, "how mip levels are chosen"},
    Field<StatedTexture>{"anisotropy", "", at<&StatedTexture::anisotropy>, "looks taken at most where a surface is seen at a slant", "",
                         kAnisotropy},
    Field<StatedTexture>{"lod_bias", "", at<&StatedTexture::lod_bias>, "is added to the mip level: below 0 sharper, above 0 softer", "", kBias},
    Field<StatedTexture>{"border", "", color_at<&StatedTexture::border, &StatedTexture::border_alpha>,
                         "of wrap clamp_to_border; a fourth number is its alpha", "", kColor},
    Field<StatedTexture>{"offset", "", at<&StatedTexture::offset>, "is added to (u, v), last", "", kBounded},
    Field<StatedTexture>{"scale", "", at<&StatedTexture::scale>, "multiplies (u, v), first", "", kBounded},
    Field<StatedTexture>{"rotation", "", at<&StatedTexture::rotation>, "turns (u, v) about (0, 0), counter-clockwise", "degrees", kTurn},
    Field<StatedTexture>{"matrix", "", at<&StatedTexture::matrix>, "[a, b, c, d, e, f]: (u, v) becomes (a u + b v + c, d u + e v + f)", "",
                         kBounded, "offset, scale and rotation"},
    Field<StatedTexture>{"v_down", "", at<&StatedTexture::v_down>,
                         "v counts from the picture's top, as in glTF; else from its bottom, as in OBJ"},
    Field<StatedTexture>{"uv_set", "", at<&StatedTexture::uv_set>, "which of the mesh's texture coordinates", "", kUvSet},
    Field<StatedTexture>{"gain", "", at<&StatedTexture::gain>, "a value is multiplied by this", "", kBounded},
    Field<StatedTexture>{"base", "", at<&StatedTexture::base>, "and this is added", "", kBounded},
    Field<StatedTexture>{"channel", "", at<&StatedTexture::channel>, "of a picture for one value"},
    Field<StatedTexture>{"once", "", at<&StatedTexture::once>, "outside of 0..1 the material is as without the texture"},
};

constexpr std::array kReflectionFields{
    Field<StatedReflection>{"shape", "", at<&StatedReflection::shape>, "how the pictures surround the scene"},
    Field<StatedReflection>{"picture", "", at<&StatedReflection::picture>, "of a sphere", "", {}, "must be stated of a sphere"},
    Field<StatedReflection>{"right", "", at<&StatedReflection::right>, "of a cube: seen along +x", "", {}, "must be stated of a cube"},
    Field<StatedReflection>{"left", "", at<&StatedReflection::left>, "along -x", "", {}, "as `right`"},
    Field<StatedReflection>{"top", "", at<&StatedReflection::top>, "along +y", "", {}, "as `right`"},
    Field<StatedReflection>{"bottom", "", at<&StatedReflection::bottom>, "along -y", "", {}, "as `right`"},
    Field<StatedReflection>{"front", "", at<&StatedReflection::front>, "along +z", "", {}, "as `right`"},
    Field<StatedReflection>{"back", "", at<&StatedReflection::back>, "along -z", "", {}, "as `right`"},
};

}  // namespace

template <>
std::span<const Field<StatedTextures>> fields<StatedTextures>() {
  return kTexturesFields;
}

template <>
std::span<const Field<StatedTexture>> fields<StatedTexture>() {
  return kTextureFields;
}

template <>
std::span<const Field<StatedReflection>> fields<StatedReflection>() {
  return kReflectionFields;
}

Material material_with(StatedTextures textures) {
  Material material;
  const auto whiten = [](const std::optional<StatedTexture>& texture, Color& color) {
    if (texture) {
      color = {{1, 1, 1}};
    }
  };
  whiten(textures.ambient, material.ambient);
  whiten(textures.diffuse, material.diffuse);
  whiten(textures.specular, material.specular);
  whiten(textures.emission, material.emission);
  material.stated_textures = std::move(textures);
  return material;
}

}  // namespace lustro
