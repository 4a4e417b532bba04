// The lighting that OpenGL 1 had in hardware (OpenGL 2.1 specification, 2.14.1), as Mesa draws it today.
#include <stdexcept>

#include "peers/gl.hpp"
#include "truth/evaluate.hpp"

namespace lustro::peers {
namespace {

using Four = std::array<float, 4>;

Four four(const Vec3d& v, float w) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), w};
}

void set_light(GLenum name, const Light& light, Transfer transfer) {
  if (light.beam || light.attenuation.falloff || light.exponent > 128) {
    throw std::runtime_error("the fixed function has no beam, no falloff and no exponent over 128");
  }
  const auto set = [&](GLenum parameter, const Four& value) { glLightfv(name, parameter, value.data()); };
  glEnable(name);
  set(GL_AMBIENT, four(truth::light_of(light.ambient, transfer), 1));
  set(GL_DIFFUSE, four(truth::light_of(light.diffuse, transfer), 1));
  set(GL_SPECULAR, four(truth::light_of(light.specular, transfer), 1));
  const bool is_directional = light.type == LightType::directional;
  set(GL_POSITION, is_directional ? four(light.direction * -1.0, 0) : four(light.position, 1));
  glLightf(name, GL_SPOT_CUTOFF, 180);
  if (light.type == LightType::spot) {
    set(GL_SPOT_DIRECTION, four(light.direction, 0));
    glLightf(name, GL_SPOT_CUTOFF, static_cast<float>(light.cutoff));
    glLightf(name, GL_SPOT_EXPONENT, static_cast<float>(light.exponent));
  }
  glLightf(name, GL_CONSTANT_ATTENUATION, static_cast<float>(light.attenuation.constant));
  glLightf(name, GL_LINEAR_ATTENUATION, static_cast<float>(light.attenuation.linear));
  glLightf(name, GL_QUADRATIC_ATTENUATION, static_cast<float>(light.attenuation.quadratic));
}

void set_material(const Material& material, const Scene& scene) {
  const Transfer transfer = scene.image.transfer;
  const auto set = [&](GLenum parameter, const Color& color, bool is_on) {
    glMaterialfv(GL_FRONT_AND_BACK, parameter, four(is_on ? truth::light_of(color, transfer) : Vec3d{}, 1).data());
  };
  const TermSet& terms = scene.shading.terms;
  set(GL_AMBIENT, material.ambient, terms.ambient);
  set(GL_DIFFUSE, material.diffuse, terms.diffuse);
  set(GL_SPECULAR, material.specular, terms.specular && scene.shading.lighting != Lighting::lambert);
  set(GL_EMISSION, material.emission, terms.emission);
  glMaterialf(GL_FRONT_AND_BACK, GL_SHININESS, material.shininess);
}

void draw_smooth(const Mesh& mesh) {
  glVertexPointer(3, GL_FLOAT, sizeof(Vec3f), mesh.positions.data());
  glNormalPointer(GL_FLOAT, sizeof(Vec3f), mesh.normals.data());
  if (!mesh.colors.empty()) {  // they take the place of both coefficients, which must be 1
    glEnable(GL_COLOR_MATERIAL);
    glColorMaterial(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE);
    glEnableClientState(GL_COLOR_ARRAY);
    glColorPointer(3, GL_FLOAT, sizeof(Vec3f), mesh.colors.data());
  }
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangles.size()), GL_UNSIGNED_INT, mesh.triangles.data());
  glDisableClientState(GL_COLOR_ARRAY);
  glDisable(GL_COLOR_MATERIAL);
}

void draw_flat(const Mesh& mesh) {
  glBegin(GL_TRIANGLES);
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Vec3f, 3> p{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    const Vec3f normal = normalize(cross(p[1] - p[0], p[2] - p[0]));
    glNormal3f(normal.x, normal.y, normal.z);
    for (const Vec3f& corner : p) {
      glVertex3f(corner.x, corner.y, corner.z);
    }
  }
  glEnd();
}

}  // namespace

ByteImage draw_with_fixed_function(GlContext& context, const Scene& scene) {
  const Shading& shading = scene.shading;
  if (shading.interpolation == Interpolation::phong || shading.lighting == Lighting::phong || scene.lights.value().size() > 8) {
    throw std::runtime_error("the fixed function has no such shading");
  }
  context.begin(scene);
  const GlCamera camera = gl_camera(scene);
  const bool is_flat = shading.interpolation == Interpolation::flat;
  glUseProgram(0);
  glShadeModel(is_flat ? GL_FLAT : GL_SMOOTH);
  glEnable(GL_LIGHTING);
  glEnable(GL_NORMALIZE);
  glLightModelfv(GL_LIGHT_MODEL_AMBIENT, four(truth::light_of(scene.ambient, scene.image.transfer), 1).data());
  glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, scene.camera.projection == Projection::perspective ? 1 : 0);
  glLightModeli(GL_LIGHT_MODEL_TWO_SIDE, shading.two_sided ? 1 : 0);

  glMatrixMode(GL_PROJECTION);
  glLoadMatrixf(column_major(camera.clip_from_eye).data());
  glMatrixMode(GL_MODELVIEW);
  glLoadMatrixf(column_major(camera.eye_from_world.m).data());
  for (GLenum i = 0; i < 8; ++i) {
    glDisable(GL_LIGHT0 + i);
  }
  GLenum name = GL_LIGHT0;
  for (const Light& light : *scene.lights) {
    set_light(name++, light, scene.image.transfer);
  }
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  for (const Object& object : scene.objects) {
    glFrontFace(is_mirrored(object.matrix) ? GL_CW : GL_CCW);
    glLoadMatrixf(column_major((camera.eye_from_world * object.matrix).m).data());
    set_material(object.material.value_or(Material{}), scene);
    if (is_flat) {
      draw_flat(*object.mesh);
    } else {
      draw_smooth(*object.mesh);
    }
  }
  glDisableClientState(GL_VERTEX_ARRAY);
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisable(GL_LIGHTING);
  return context.end();
}

}  // namespace lustro::peers
