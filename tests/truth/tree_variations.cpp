// The variations of the tree: what its core keeps fixed, one thing at a time, over interpolations and cameras where both matter.
#include <array>
#include <cstddef>
#include <functional>
#include <utility>

#include "truth/tree_parts.hpp"

namespace lustro::truth {
namespace {

constexpr std::array kInterpolations{Interpolation::flat, Interpolation::gouraud, Interpolation::phong};
constexpr std::array kProjections{Projection::perspective, Projection::orthographic};

using Change = std::function<void(Scene&)>;

/// Adds scenes under one name; the geometry turns from scene to scene.
class Branch {
 public:
  explicit Branch(std::vector<TreeScene>& tree) : tree_(tree) {}

  /// One scene. `geometry` names what `change` does to meshes, matrices, camera or size, and is empty when it touches none of them.
  void add(const std::string& name, std::size_t place, Projection projection, const std::string& geometry, const Change& change) {
    TreeScene entry = base_scene(place, projection);
    entry.name = "variations/" + name + "/" + word(projection);
    if (!geometry.empty()) {
      entry.geometry += "/" + geometry;
    }
    entry.scene.image.transfer = turn_ % 2 == 0 ? Transfer::srgb : Transfer::none;
    entry.scene.lights = light_kinds().back().lights(attenuations()[turn_ % attenuations().size()].value);
    ++turn_;
    change(entry.scene);
    tree_.push_back(std::move(entry));
  }

  /// All interpolations by all cameras; Phong's lighting where the interpolation is `flat`, Blinn-Phong's else.
  void add_all(const std::string& name, std::size_t place, const std::string& geometry, const Change& change) {
    for (const Interpolation interpolation : kInterpolations) {
      for (const Projection projection : kProjections) {
        add(name + "/" + word(interpolation), place, projection, geometry, [&](Scene& scene) {
          scene.shading.interpolation = interpolation;
          scene.shading.lighting = interpolation == Interpolation::flat ? Lighting::phong : Lighting::blinn_phong;
          change(scene);
        });
      }
    }
  }

 private:
  std::vector<TreeScene>& tree_;
  std::size_t turn_ = 0;
};

void set_mesh(Object& object, const std::string& source) {
  object.source = source;
  object.mesh = tree_mesh(source);
}

/// The first object's mesh with a colour at each vertex that follows its place.
void color_vertices(Scene& scene) {
  Mesh mesh = *scene.objects[0].mesh;
  mesh.colors.clear();
  for (const Vec3f& p : mesh.positions) {
    const auto ramp = [](float x) { return std::min(std::max(0.5F + 0.5F * x, 0.0F), 1.0F); };
    mesh.colors.push_back({ramp(p.x), ramp(p.y), ramp(-p.z)});
  }
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  scene.objects[0].source.clear();
}

/// The first object with three materials of its own, in stripes; two of them name their lighting.
void stripe_materials(Scene& scene) {
  Mesh mesh = *scene.objects[0].mesh;
  Material plain{.name = "plain", .diffuse = {{0.7F, 0.6F, 0.2F}, ColorSpace::encoded}, .specular = {{0.5F, 0.5F, 0.5F}}, .shininess = 9};
  Material unlit = plain;
  unlit.name = "unlit";
  unlit.lighting = Lighting::constant;
  unlit.diffuse = {{0.3F, 0.6F, 0.5F}, ColorSpace::encoded};
  Material matte = plain;
  matte.name = "matte";
  matte.lighting = Lighting::lambert;
  matte.emission = {{0.1F, 0, 0.05F}};
  mesh.materials = {plain, unlit, matte};
  mesh.triangle_material.clear();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    mesh.triangle_material.push_back(static_cast<std::uint32_t>(i / 20 % 3));
  }
  scene.objects[0].mesh = std::make_shared<const Mesh>(std::move(mesh));
  scene.objects[0].source.clear();
  scene.objects[0].material.reset();
}

void add_sides(Branch& branch) {
  for (const bool two_sided : {false, true}) {
    const std::string side = two_sided ? "two_sided" : "one_sided";
    branch.add_all(side + "/plane_from_below", 0, "below", [=](Scene& scene) {
      scene.camera.eye = Vec3d{1.2, -2.4, 3.2};
      scene.shading.two_sided = two_sided;
    });
    branch.add_all(side + "/cut_open", 2, "near", [=](Scene& scene) {
      scene.camera.near = 3.7;  // the near plane opens the objects
      scene.shading.two_sided = two_sided;
    });
    branch.add_all(side + "/mirrored", 2, "mirrored", [=](Scene& scene) {
      for (Object& object : scene.objects) {
        object.matrix = scaling(-1, 1, 1) * object.matrix;
      }
      scene.shading.two_sided = two_sided;
    });
  }
}

void add_culling(Branch& branch) {
  for (const Culling cull : {Culling::back, Culling::front}) {
    const std::string side = cull == Culling::back ? "cull_back" : "cull_front";
    branch.add_all(side + "/plane_from_below", 0, "below", [=](Scene& scene) {
      scene.camera.eye = Vec3d{1.2, -2.4, 3.2};
      scene.shading.cull = cull;
      scene.shading.two_sided = true;
    });
    branch.add_all(side + "/cut_open", 2, "near", [=](Scene& scene) {
      scene.camera.near = 3.7;  // the near plane opens the objects
      scene.shading.cull = cull;
      scene.shading.two_sided = true;
    });
    branch.add_all(side + "/mirrored", 2, "mirrored", [=](Scene& scene) {
      for (Object& object : scene.objects) {
        object.matrix = scaling(-1, 1, 1) * object.matrix;
      }
      scene.shading.cull = cull;
    });
  }
}

void add_matrices(Branch& branch) {
  branch.add_all("matrix/mirrored_and_stretched", 0, "mirror_z",
                 [](Scene& scene) { scene.objects[0].matrix = scaling(0.8, 1.2, -0.5) * turned(0); });
  branch.add_all("matrix/shear", 1, "shear", [](Scene& scene) {
    Mat4 shear;
    shear(0, 1) = 0.7;
    shear(2, 1) = -0.4;
    for (Object& object : scene.objects) {
      object.matrix = shear * object.matrix;
    }
  });
  branch.add_all("matrix/flattened", 2, "flattened", [](Scene& scene) { scene.objects[0].matrix = turned(2) * scaling(1.4, 0.05, 1.4); });
  branch.add_all("matrix/tiny", 0, "tiny", [](Scene& scene) {
    const Mat4 tiny = scaling(1e-4, 1e-4, 1e-4);
    for (Object& object : scene.objects) {
      object.matrix = tiny * object.matrix;
    }
    scene.camera.eye = *scene.camera.eye * 1e-4;
    scene.camera.target = *scene.camera.target * 1e-4;
    scene.camera.near = 0.5e-4;
    scene.camera.far = 20e-4;
    if (scene.camera.height) {
      scene.camera.height = *scene.camera.height * 1e-4;
    }
    for (Light& light : *scene.lights) {
      light.position = light.position * 1e-4;
      light.attenuation = {};
    }
  });
  branch.add_all("matrix/far_from_the_origin", 0, "far_away", [](Scene& scene) {
    const Vec3d away{4000, -2500, 6000};
    for (Object& object : scene.objects) {
      object.matrix = translation(away.x, away.y, away.z) * object.matrix;
    }
    scene.camera.eye = *scene.camera.eye + away;
    scene.camera.target = *scene.camera.target + away;
    for (Light& light : *scene.lights) {
      light.position = light.position + away;
    }
  });
}

void add_cameras(Branch& branch) {
  branch.add_all("camera/portrait", 1, "portrait", [](Scene& scene) {
    scene.image.width = 50;
    scene.image.height = 90;
    scene.camera.up = Vec3d{0.5, 1, -0.3};
  });
  branch.add_all("camera/odd_size", 0, "odd", [](Scene& scene) {
    scene.image.width = 77;
    scene.image.height = 53;
  });
  for (const Interpolation interpolation : kInterpolations) {
    const auto set = [=](double fov, double distance) {
      return [=](Scene& scene) {
        scene.shading.interpolation = interpolation;
        scene.camera.fov = fov;
        const Vec3d back = *scene.camera.eye - *scene.camera.target;
        scene.camera.eye = *scene.camera.target + back * distance;
        scene.camera.near = distance < 1 ? 0.01 : 3.5 * distance;
        scene.camera.far = distance < 1 ? 20 : 6 * distance;
      };
    };
    branch.add("camera/fov_120/" + std::string(word(interpolation)), 0, Projection::perspective, "fov_120", set(120, 0.4));
    branch.add("camera/fov_2/" + std::string(word(interpolation)), 2, Projection::perspective, "fov_2", set(2, 20));
  }
  // Inside a sphere, over a floor that reaches behind the eye: every triangle near the eye is clipped.
  branch.add_all("camera/inside", 0, "inside", [](Scene& scene) {
    set_mesh(scene.objects[0], "primitive:sphere:12");
    scene.objects[0].matrix = scaling(8, 8, 8);
    scene.camera.near = 0.1;
    scene.shading.two_sided = true;
  });
  branch.add_all("camera/far_plane", 0, "far_plane", [](Scene& scene) { scene.camera.far = 4.2; });
  branch.add_all("camera/looking_down", 1, "down", [](Scene& scene) {
    scene.camera.eye = Vec3d{0, 4, 0};
    scene.camera.target = Vec3d{0, 0, 0};
    scene.camera.up = Vec3d{0, 0, -1};
  });
}

void add_equation(Branch& branch) {
  for (const Lighting model : {Lighting::phong, Lighting::blinn_phong}) {
    branch.add_all("normalized/" + std::string(word(model)), 0, "", [=](Scene& scene) {
      scene.shading.lighting = model;
      scene.shading.normalized = true;
    });
    for (const float shininess : {0.0F, 0.5F, 1.0F, 2.0F, 60.5F, 128.0F, 1000.0F, 10000.0F}) {
      for (const bool normalized : {false, true}) {
        branch.add("shininess/" + std::string(word(model)) + (normalized ? "/normalized/" : "/plain/") +
                       std::to_string(static_cast<int>(shininess * 10)),
                   2, Projection::perspective, "", [=](Scene& scene) {
                     scene.shading.lighting = model;
                     scene.shading.normalized = normalized;
                     for (Object& object : scene.objects) {
                       object.material->shininess = shininess;
                     }
                   });
      }
    }
  }
  const std::array<std::pair<const char*, TermSet>, 9> term_sets{{{"no_ambient", {false, true, true, true}},
                                                                  {"no_diffuse", {true, false, true, true}},
                                                                  {"no_specular", {true, true, false, true}},
                                                                  {"no_emission", {true, true, true, false}},
                                                                  {"only_ambient", {true, false, false, false}},
                                                                  {"only_diffuse", {false, true, false, false}},
                                                                  {"only_specular", {false, false, true, false}},
                                                                  {"only_emission", {false, false, false, true}},
                                                                  {"nothing", {false, false, false, false}}}};
  for (const auto& [name, terms] : term_sets) {
    branch.add_all(std::string("terms/") + name, 0, "", [terms = terms](Scene& scene) { scene.shading.terms = terms; });
  }
  branch.add_all("lights/none", 1, "", [](Scene& scene) { scene.lights = std::vector<Light>{}; });
  branch.add_all("lights/forty", 1, "", [](Scene& scene) {
    std::vector<Light> lights;
    for (int i = 0; i < 40; ++i) {
      Light light = (*scene.lights)[static_cast<std::size_t>(i) % scene.lights->size()];
      light.position = light.position + Vec3d{0.1 * (i % 7) - 0.3, 0.05 * (i % 5), 0.1 * (i % 3)};
      light.diffuse.rgb = light.diffuse.rgb * 0.15F;
      light.specular.rgb = light.specular.rgb * 0.15F;
      light.ambient.rgb = light.ambient.rgb * 0.15F;
      lights.push_back(light);
    }
    scene.lights = lights;
  });
  branch.add_all("lights/bright", 2, "", [](Scene& scene) {  // `gouraud` clamps at the vertex, the others at the end
    for (Light& light : *scene.lights) {
      light.diffuse.rgb = light.diffuse.rgb * 6.0F;
      light.specular.rgb = light.specular.rgb * 6.0F;
    }
  });
  branch.add_all("lights/inside_an_object", 0, "", [](Scene& scene) {
    for (Light& light : *scene.lights) {
      light.position = {-0.7, 0.1, 0.9};
    }
  });
  for (const double cutoff : {1.0, 5.0, 20.0, 60.0, 89.0, 90.0}) {
    branch.add_all("lights/cutoff_" + std::to_string(static_cast<int>(cutoff)), 0, "", [=](Scene& scene) {
      for (Light& light : *scene.lights) {
        light.cutoff = cutoff;
        light.beam.reset();
        light.exponent = 0;
      }
    });
  }
  branch.add_all("lights/beam_of_0", 0, "", [](Scene& scene) {
    for (Light& light : *scene.lights) {
      light.beam = 0;
    }
  });
  branch.add_all("lights/narrow_exponent", 0, "", [](Scene& scene) {
    for (Light& light : *scene.lights) {
      light.exponent = 400;
    }
  });
  branch.add_all("lights/long_directions", 0, "", [](Scene& scene) {
    for (Light& light : *scene.lights) {
      light.direction = light.direction * 250.0;
    }
  });
}

void add_surfaces(Branch& branch) {
  for (std::size_t place = 0; place < geometry_count(); ++place) {
    for (const Projection projection : kProjections) {
      branch.add("slerp/" + std::to_string(place), place, projection, "",
                 [](Scene& scene) { scene.shading.normals = NormalInterpolation::slerp; });
    }
  }
  for (const bool two_sided : {false, true}) {
    for (const Projection projection : kProjections) {  // 4 x 3 faces to the sphere: neighbouring normals lie far apart
      branch.add(two_sided ? "slerp/coarse_two_sided" : "slerp/coarse", 0, projection, "coarse", [=](Scene& scene) {
        scene.shading.normals = NormalInterpolation::slerp;
        scene.shading.two_sided = two_sided;
        scene.camera.near = 3.4;
        set_mesh(scene.objects[0], "primitive:sphere:4");
        set_mesh(scene.objects[1], "primitive:torus:4");
      });
    }
  }
  for (const VertexNormals weights : {VertexNormals::uniform, VertexNormals::area}) {
    branch.add_all(weights == VertexNormals::uniform ? "normals/uniform" : "normals/area", 2, "", [=](Scene& scene) {
      scene.shading.vertex_normals = weights;
      for (Object& object : scene.objects) {
        object.mesh = tree_mesh(object.source, scene.shading);
      }
    });
  }
  for (const Transfer transfer : {Transfer::none, Transfer::srgb}) {
    const std::string name = transfer == Transfer::none ? "/none" : "/srgb";
    branch.add_all("vertex_colors" + name, 0, "", [=](Scene& scene) {
      scene.image.transfer = transfer;
      color_vertices(scene);
    });
    branch.add_all("stripes" + name, 0, "", [=](Scene& scene) {
      scene.image.transfer = transfer;
      stripe_materials(scene);
    });
    branch.add_all("stripes_and_vertex_colors" + name, 2, "", [=](Scene& scene) {
      scene.image.transfer = transfer;
      stripe_materials(scene);
      color_vertices(scene);
      scene.fog = Fog{.mode = FogMode::exp, .density = 0.15, .color = {{0.4F, 0.5F, 0.6F}, ColorSpace::encoded}};
    });
    for (const char* material : {"gold", "jade", "red_plastic", "pewter"}) {
      branch.add_all("library/" + std::string(material) + name, 2, "", [=](Scene& scene) {
        scene.image.transfer = transfer;
        scene.objects[0].material = library_material(material);
      });
    }
  }
  branch.add_all("default_material", 1, "", [](Scene& scene) { scene.objects[0].material.reset(); });
  for (const Lighting model : {Lighting::constant, Lighting::lambert, Lighting::phong, Lighting::blinn_phong}) {
    branch.add_all("own_lighting/" + std::string(word(model)), 0, "", [=](Scene& scene) {
      scene.objects[0].material->lighting = model;
      scene.shading.terms.ambient = model != Lighting::constant;
    });
  }
}

void add_picture(Branch& branch) {
  const std::array<std::pair<const char*, Fog>, 6> fogs{
      {{"linear", {.mode = FogMode::linear, .start = 3, .end = 6, .color = {{0.5F, 0.6F, 0.7F}}}},
       {"linear_ends_inside", {.mode = FogMode::linear, .start = 3.9, .end = 4.4, .color = {{0.5F, 0.6F, 0.7F}, ColorSpace::encoded}}},
       {"exp", {.mode = FogMode::exp, .density = 0.2, .color = {{0.5F, 0.6F, 0.7F}}}},
       {"exp_dense", {.mode = FogMode::exp, .density = 30, .color = {{0.5F, 0.6F, 0.7F}}}},
       {"exp2", {.mode = FogMode::exp2, .density = 0.2, .color = {{0.2F, 0.3F, 0.8F}, ColorSpace::encoded}}},
       {"exp2_thin", {.mode = FogMode::exp2, .density = 0.01, .color = {{0.2F, 0.3F, 0.8F}}}}}};
  for (const auto& [name, fog] : fogs) {
    branch.add_all(std::string("fog/") + name, 0, "", [fog = fog](Scene& scene) { scene.fog = fog; });
  }
  for (const int samples : {2, 4, 8, 16}) {
    branch.add_all("samples/" + std::to_string(samples), 0, "", [=](Scene& scene) { scene.image.samples = samples; });
  }
  branch.add_all("background/encoded", 1, "", [](Scene& scene) { scene.image.background = {{0.8F, 0.4F, 0.1F}, ColorSpace::encoded}; });
  branch.add_all("background/half", 1, "", [](Scene& scene) { scene.image.background_alpha = 0.5F; });
  branch.add_all("background/transparent", 1, "", [](Scene& scene) {
    scene.image.transparent = true;
    scene.image.samples = 4;
  });
}

/// GGX at every place of the equation, with every term missing once, and with every width of the lobe.
void add_microfacets(Branch& branch) {
  const auto ggx = [](Scene& scene) { scene.shading.lighting = Lighting::ggx; };
  for (std::size_t place = 0; place < 3; ++place) {
    branch.add_all("ggx/place_" + std::to_string(place), place, "", ggx);
  }
  const std::array<std::pair<const char*, TermSet>, 3> term_sets{
      {{"no_diffuse", {true, false, true, true}}, {"no_specular", {true, true, false, true}}, {"only_specular", {false, false, true, false}}}};
  for (const auto& [name, terms] : term_sets) {
    branch.add_all(std::string("ggx/terms/") + name, 0, "", [&, terms = terms](Scene& scene) {
      ggx(scene);
      scene.shading.terms = terms;
    });
  }
  for (const float shininess : {0.0F, 0.5F, 2.0F, 60.5F, 1000.0F, 10000.0F}) {
    branch.add("ggx/shininess/" + std::to_string(static_cast<int>(shininess * 10)), 2, Projection::perspective, "", [&](Scene& scene) {
      ggx(scene);
      for (Object& object : scene.objects) {
        object.material->shininess = shininess;
      }
    });
  }
  branch.add_all("ggx/mirrors", 1, "", [&](Scene& scene) {  // all that comes is reflected, and of the cube more than comes
    ggx(scene);
    scene.objects[0].material->specular = {{1.5F, 1, 0.5F}};
    scene.objects[1].material->specular = {{1, 1, 1}};
  });
}

/// What KHR_lights_punctual adds to a light.
void add_light_ends(Branch& branch) {
  for (const double range : {0.9, 1.6, 4.0}) {
    branch.add_all("lights/range_" + std::to_string(static_cast<int>(range * 10)), 0, "", [=](Scene& scene) {
      for (Light& light : *scene.lights) {
        light.attenuation.range = range;
      }
    });
  }
  for (const double beam : {0.0, 20.0, 41.99}) {  // of the last the cosines lie nearer than 0.001
    branch.add_all("lights/quadratic_" + std::to_string(static_cast<int>(beam)), 0, "", [=](Scene& scene) {
      for (Light& light : *scene.lights) {
        light.cutoff = 42;
        light.beam = beam;
        light.fade = SpotFade::quadratic;
      }
    });
  }
}

}  // namespace

void add_variations(std::vector<TreeScene>& tree) {
  Branch branch(tree);
  add_sides(branch);
  add_matrices(branch);
  add_cameras(branch);
  add_equation(branch);
  add_surfaces(branch);
  add_picture(branch);
  add_culling(branch);
  add_microfacets(branch);
  add_light_ends(branch);
}

}  // namespace lustro::truth
