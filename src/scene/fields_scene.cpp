// The scene's own keys, and those of `shading`, of a material and of an object.
#include <array>

#include "scene/fields.hpp"

namespace lustro {
namespace {

constexpr Range kColor{.lower = 0};
constexpr Range kCrease{.lower = 0, .upper = 180};
constexpr Range kExponent{.lower = 0, .upper = 10000};
constexpr Range kIllumination{.lower = 0, .upper = 10};
constexpr Range kRefraction{.lower = 0.001, .upper = 10};
constexpr Range kUnit{.lower = 0, .upper = 1};

constexpr std::array kSceneFields{
    Field<Scene>{"image", "", at<&Scene::image>, "the picture's size and how it is stored"},
    Field<Scene>{"camera", "", at<&Scene::camera>, "from where the scene is seen", "", {}, "frames the whole scene"},
    Field<Scene>{"shading", "", at<&Scene::shading>, "how surfaces are lit"},
    Field<Scene>{"ambient", "--ambient", at<&Scene::ambient>, "the scene's ambient light I_a", "", kColor},
    Field<Scene>{"lights",
                 "--light",
                 at<&Scene::lights>,
                 "the lights, in any number; an empty list is no light",
                 "",
                 {},
                 "a default rig that moves with the camera"},
    Field<Scene>{"fog", "--fog", at<&Scene::fog>, "what distance does to colours", "", {}, "no fog"},
    Field<Scene>{"environment", "--environment", at<&Scene::environment>, "light from infinitely far away, all around", "", {}, "none"},
    Field<Scene>{"shadow", "--shadows", at<&Scene::shadow>, "lights do not reach what lies behind something", "", {}, "no shadows"},
    Field<Scene>{"occlusion",
                 "--occlusion",
                 at<&Scene::occlusion>,
                 "light from all around does not reach what something stands close to",
                 "",
                 {},
                 "no occlusion"},
    Field<Scene>{"ground",
                 "--ground",
                 at<&Scene::ground>,
                 "a floor that shows nothing but the shadows on it; it switches shadows on",
                 "",
                 {},
                 "no floor"},
    Field<Scene>{
        "materials", "", nowhere, "materials by name, for the objects: a library material's name or a table of coefficients", "", {}, "none"},
    Field<Scene>{"objects", "", at<&Scene::objects>, "what is drawn; the only key that must be there", "", {}, "must be stated"},
};

constexpr std::array kShadingFields{
    Field<Shading>{"lighting", "--lighting", at<&Shading::lighting>, "how a point is lit"},
    Field<Shading>{"interpolation", "--interpolation", at<&Shading::interpolation>, "where the lighting is evaluated"},
    Field<Shading>{"normals", "--normals", at<&Shading::normals>, "how interpolation phong interpolates the normal"},
    Field<Shading>{"vertex_normals", "--vertex-normals", at<&Shading::vertex_normals>,
                   "how missing vertex normals are made from the faces' normals"},
    Field<Shading>{"crease", "--crease", at<&Shading::crease>, "faces that meet at more than this do not share a normal", "degrees", kCrease,
                   "180 (all smooth); 40 for STL"},
    Field<Shading>{"recompute_normals", "--recompute-normals", at<&Shading::recompute_normals>,
                   "makes new vertex normals even where the file has some"},
    Field<Shading>{"terms", "--terms", at<&Shading::terms>, "the parts of the lighting sum that are kept"},
    Field<Shading>{"two_sided",
                   "--two-sided",
                   at<&Shading::two_sided>,
                   "lights the back of a face with its normals turned round",
                   "",
                   {},
                   "false; true for a bare mesh"},
    Field<Shading>{"cull", "--cull", at<&Shading::cull>, "which side of a face is not drawn"},
    Field<Shading>{"normalized", "--normalized", at<&Shading::normalized>, "energy-normalised highlights, times N.L"},
};

constexpr std::array kMaterialFields{
    Field<Material>{"name", "", at<&Material::name>, "what layers and `explain` call it", "", {}, "its key in `materials`"},
    Field<Material>{"ambient", "", at<&Material::ambient>, "k_a", "", kColor},
    Field<Material>{"diffuse", "", at<&Material::diffuse>, "k_d", "", kColor},
    Field<Material>{"specular", "", at<&Material::specular>, "k_s", "", kColor},
    Field<Material>{"emission", "", at<&Material::emission>, "k_e", "", kColor},
    Field<Material>{"shininess", "", at<&Material::shininess>, "the exponent n of the highlight", "", kExponent},
    Field<Material>{"opacity", "", at<&Material::opacity>, "the share of what lies behind that it hides", "", kUnit},
    Field<Material>{"alpha_mode", "", at<&Material::alpha_mode>, "what the opacity means"},
    Field<Material>{"alpha_cutoff", "", at<&Material::alpha_cutoff>, "of alpha_mode mask: where the opacity is less there is nothing", "",
                    kUnit},
    Field<Material>{"lighting", "", at<&Material::lighting>, "this material's own way of being lit", "", {}, "that of `shading`"},
    Field<Material>{"cull", "", at<&Material::cull>, "faces of this material that are left out", "", {}, "that of `shading`"},
    Field<Material>{"illumination", "", at<&Material::illumination>,
                    "how the path tracer mirrors and refracts, as MTL's illum: 3 a mirror of k_s, 5 by Fresnel, 6 clear, 7 by Fresnel", "",
                    kIllumination, "no mirror"},
    Field<Material>{"refraction", "", at<&Material::refraction>, "index of refraction, of illumination 5, 6 and 7", "", kRefraction},
    Field<Material>{"transmission", "", at<&Material::transmission>, "what passes into the material, of illumination 6 and 7", "", kColor},
    Field<Material>{"textures", "", at<&Material::stated_textures>, "pictures of what varies over the surface", "", {}, "none"},
};

constexpr std::array kObjectFields{
    Field<Object>{"mesh", "", at<&Object::source>, "a mesh file, relative to the scene file, or `primitive:NAME`", "", {}, "must be stated"},
    Field<Object>{"name", "", at<&Object::name>, "what messages, layers and `explain` call it", "", {}, "the mesh"},
    Field<Object>{"material",
                  "--material",
                  at<&Object::material>,
                  "a name of `materials`, a library material, or a table of coefficients",
                  "",
                  {},
                  "the mesh's own"},
    Field<Object>{"matrix", "", at<&Object::matrix>, "world from object: 16 numbers, row-major, for column vectors"},
};

}  // namespace

template <>
std::span<const Field<Scene>> fields<Scene>() {
  return kSceneFields;
}

template <>
std::span<const Field<Shading>> fields<Shading>() {
  return kShadingFields;
}

template <>
std::span<const Field<Material>> fields<Material>() {
  return kMaterialFields;
}

template <>
std::span<const Field<Object>> fields<Object>() {
  return kObjectFields;
}

}  // namespace lustro
