// The project's own shaders, run by OpenGL: `#version 300 es` as it stands (GL_ARB_ES3_compatibility).
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "peers/gl.hpp"
#include "shade/glsl.hpp"
#include "truth/evaluate.hpp"

namespace lustro::peers {
namespace {

GLuint compile(GLenum stage, const std::string& text) {
  const GLuint shader = glCreateShader(stage);
  const char* source = text.c_str();
  glShaderSource(shader, 1, &source, nullptr);
  glCompileShader(shader);
  GLint is_compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &is_compiled);
  if (is_compiled == 0) {
    std::string log(4096, '\0');
    glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    throw std::runtime_error("a shader does not compile: " + log + "\n" + text);
  }
  return shader;
}

/// The program of these options; each is compiled once.
GLuint program_of(GlContext& context, const GlslOptions& options) {
  const std::string vertex = glsl_shader(GlslStage::vertex, options);
  const std::string fragment = glsl_shader(GlslStage::fragment, options);
  GLuint& program = context.programs[vertex + fragment];
  if (program == 0) {
    program = glCreateProgram();
    glAttachShader(program, compile(GL_VERTEX_SHADER, vertex));
    glAttachShader(program, compile(GL_FRAGMENT_SHADER, fragment));
    glLinkProgram(program);
    GLint is_linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
    if (is_linked == 0) {
      std::string log(4096, '\0');
      glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
      throw std::runtime_error("shaders do not link: " + log);
    }
  }
  return program;
}

/// Uniforms by name; one that the shader does not use has the location -1, which OpenGL ignores.
class Uniforms {
 public:
  explicit Uniforms(GLuint program) : program_(program) {}
  void set(const std::string& name, int value) const { glUniform1i(at(name), value); }
  void set(const std::string& name, double value) const { glUniform1f(at(name), static_cast<float>(value)); }
  void set(const std::string& name, const Vec3d& v) const {
    glUniform3f(at(name), static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z));
  }
  void set(const std::string& name, const std::array<double, 16>& row_major) const {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, column_major(row_major).data());
  }
  /// The inverse transpose of the upper left of a matrix.
  void set_normal_matrix(const std::string& name, const Mat4& m) const {
    const std::array<Vec3d, 3> rows{Vec3d{m(0, 0), m(0, 1), m(0, 2)}, Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)}};
    const double determinant = dot(rows[0], cross(rows[1], rows[2]));
    const std::array<Vec3d, 3> cofactors{cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])};
    std::array<float, 9> values{};
    for (std::size_t row = 0; row < 3; ++row) {
      const Vec3d c = cofactors[row] * (1 / determinant);
      values[row] = static_cast<float>(c.x);
      values[3 + row] = static_cast<float>(c.y);
      values[6 + row] = static_cast<float>(c.z);
    }
    glUniformMatrix3fv(at(name), 1, GL_FALSE, values.data());
  }

 private:
  [[nodiscard]] GLint at(const std::string& name) const { return glGetUniformLocation(program_, name.c_str()); }
  GLuint program_;
};

Vec3d turn(const Mat4& m, const Vec3d& direction) {
  const Vec3d d = transform_point(m, direction) - transform_point(m, Vec3d{0, 0, 0});
  return d * (1 / std::sqrt(dot(d, d)));
}

double cosine(double degrees) {
  return std::cos(degrees * 3.14159265358979323846 / 180);
}

void set_light(const Uniforms& uniforms, const std::string& name, const Light& light, const Mat4& eye_from_world, Transfer transfer) {
  uniforms.set(name + ".type", static_cast<int>(light.type));
  uniforms.set(name + ".position", transform_point(eye_from_world, light.position));
  uniforms.set(name + ".travel", turn(eye_from_world, light.direction));
  uniforms.set(name + ".ambient", truth::light_of(light.ambient, transfer));
  uniforms.set(name + ".diffuse", truth::light_of(light.diffuse, transfer));
  uniforms.set(name + ".specular", truth::light_of(light.specular, transfer));
  const Attenuation& a = light.attenuation;
  const double p = a.falloff.value_or(0);
  const bool is_polynomial = p == 0 || p == 1 || p == 2;
  Vec3d coefficients{a.constant, a.linear, a.quadratic};
  if (a.falloff) {
    coefficients = {p == 0 ? 1.0 : 0.0, p == 1 ? 1.0 : 0.0, p == 2 ? 1.0 : 0.0};
  }
  uniforms.set(name + ".attenuation", coefficients);
  uniforms.set(name + ".falloff", is_polynomial ? 0 : p);
  uniforms.set(name + ".attenuation_limit", a.unclamped ? 1e30 : 1.0);
  uniforms.set(name + ".cos_cutoff", cosine(light.cutoff));
  uniforms.set(name + ".range_scale", a.range ? 1 / *a.range : 0);
  uniforms.set(name + ".cos_beam", light.beam ? cosine(*light.beam) : 0);
  const double least = light.fade == SpotFade::quadratic ? 0.001 : 0;  // KHR_lights_punctual
  uniforms.set(name + ".beam_scale", light.beam ? 1 / std::max(cosine(*light.beam) - cosine(light.cutoff), least) : 0);
  uniforms.set(name + ".fades_quadratically", light.fade == SpotFade::quadratic ? 1 : 0);
  uniforms.set(name + ".exponent", light.exponent);
}

void set_scene(const Uniforms& uniforms, const Scene& scene, const GlCamera& camera) {
  const Transfer transfer = scene.image.transfer;
  uniforms.set("clip_from_eye", camera.clip_from_eye);
  uniforms.set("view_to_eye", Vec3d{0, 0, 1});
  uniforms.set("ambient_light", truth::light_of(scene.ambient, transfer));
  uniforms.set("light_count", static_cast<int>(scene.lights->size()));
  for (std::size_t i = 0; i < scene.lights->size(); ++i) {
    set_light(uniforms, "lights[" + std::to_string(i) + "]", (*scene.lights)[i], camera.eye_from_world, transfer);
  }
  if (scene.fog) {
    uniforms.set("fog.mode", static_cast<int>(scene.fog->mode));
    uniforms.set("fog.density", scene.fog->density);
    uniforms.set("fog.end", scene.fog->end);
    uniforms.set("fog.range_scale", 1 / (scene.fog->end - scene.fog->start));
    uniforms.set("fog.color", truth::light_of(scene.fog->color, transfer));
  }
}

void set_material(const Uniforms& uniforms, const Material& material, Transfer transfer) {
  uniforms.set("material.ambient", truth::light_of(material.ambient, transfer));
  uniforms.set("material.diffuse", truth::light_of(material.diffuse, transfer));
  uniforms.set("material.specular", truth::light_of(material.specular, transfer));
  uniforms.set("material.emission", truth::light_of(material.emission, transfer));
  uniforms.set("material.shininess", static_cast<double>(material.shininess));
}

void attribute(GLuint location, const std::vector<Vec3f>& values) {
  glEnableVertexAttribArray(location);
  glVertexAttribPointer(location, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), values.data());
}

/// Every face with vertices of its own, which carry its normal and its centre.
void draw_flat(const Mesh& mesh) {
  std::vector<Vec3f> positions;
  std::vector<Vec3f> normals;
  std::vector<Vec3f> centers;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Vec3d, 3> p{vec_cast<double>(mesh.positions[a]), vec_cast<double>(mesh.positions[b]), vec_cast<double>(mesh.positions[c])};
    for (const Vec3d& corner : p) {
      positions.push_back(vec_cast<float>(corner));
      normals.push_back(vec_cast<float>(normalize(cross(p[1] - p[0], p[2] - p[0]))));
      centers.push_back(vec_cast<float>((p[0] + p[1] + p[2]) * (1.0 / 3)));
    }
  }
  attribute(0, positions);
  attribute(1, normals);
  attribute(2, centers);
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(positions.size()));
  glDisableVertexAttribArray(2);
}

void draw_smooth(const Mesh& mesh) {
  attribute(0, mesh.positions);
  attribute(1, mesh.normals);
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * mesh.triangles.size()), GL_UNSIGNED_INT, mesh.triangles.data());
}

}  // namespace

ByteImage draw_with_glsl(GlContext& context, const Scene& scene) {
  context.begin(scene);
  const GlCamera camera = gl_camera(scene);
  for (const Object& object : scene.objects) {
    if (!object.mesh->colors.empty() || (!object.material && !object.mesh->materials.empty())) {
      throw std::runtime_error("the shaders know one material and no vertex colours");
    }
    const Material material = object.material.value_or(Material{});
    const GLuint program = program_of(context, {.lighting = material.lighting.value_or(scene.shading.lighting),
                                                .interpolation = scene.shading.interpolation,
                                                .projection = scene.camera.projection,
                                                .terms = scene.shading.terms,
                                                .two_sided = scene.shading.two_sided,
                                                .normalized = scene.shading.normalized,
                                                .fog = scene.fog.has_value(),
                                                .transfer = scene.image.transfer,
                                                .max_lights = std::max(static_cast<int>(scene.lights->size()), 8)});
    glUseProgram(program);
    const Uniforms uniforms(program);
    set_scene(uniforms, scene, camera);
    set_material(uniforms, material, scene.image.transfer);
    const Mat4 eye_from_object = camera.eye_from_world * object.matrix;
    uniforms.set("eye_from_object", eye_from_object.m);
    uniforms.set_normal_matrix("normal_from_object", eye_from_object);
    glFrontFace(is_mirrored(object.matrix) ? GL_CW : GL_CCW);
    if (scene.shading.interpolation == Interpolation::flat) {
      draw_flat(*object.mesh);
    } else {
      draw_smooth(*object.mesh);
    }
  }
  glDisableVertexAttribArray(0);
  glDisableVertexAttribArray(1);
  glUseProgram(0);
  return context.end();
}

}  // namespace lustro::peers
