// OpenGL beside what tests/peers has of it: framebuffers, buffers and programs as frames in a row want them. Each program includes it once.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "lustro/image.hpp"
#include "peers/gl_glsl.cpp"  // NOLINT(bugprone-suspicious-include): its programs and uniforms are what is used here

namespace lustro::bench {

inline GLuint linked(const std::string& vertex, const std::string& fragment) {
  const GLuint program = glCreateProgram();
  glAttachShader(program, peers::compile(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, peers::compile(GL_FRAGMENT_SHADER, fragment));
  glLinkProgram(program);
  GLint is_linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_linked);
  if (is_linked == 0) {
    throw std::runtime_error("shaders do not link");
  }
  return program;
}

/// A framebuffer of renderbuffers.
class Canvas {
 public:
  Canvas(int width, int height, int samples) {
    glGenFramebuffers(1, &name);
    glBindFramebuffer(GL_FRAMEBUFFER, name);
    attach(GL_COLOR_ATTACHMENT0, GL_RGBA8, width, height, samples);
    attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, samples);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      throw std::runtime_error("llvmpipe has no such framebuffer");
    }
  }
  GLuint name = 0;

 private:
  static void attach(GLenum where, GLenum format, int width, int height, int samples) {
    GLuint buffer = 0;
    glGenRenderbuffers(1, &buffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    if (samples > 1) {
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
      GLint given = 0;
      glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
      if (given != samples) {
        throw std::runtime_error("llvmpipe gives another number of samples");
      }
    } else {
      glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
    }
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, where, GL_RENDERBUFFER, buffer);
  }
};

/// A buffer with these values, bound.
template <class T>
void upload(GLenum target, const std::vector<T>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(T)), values.data(), GL_STATIC_DRAW);
}

/// What glReadPixels() read as RGBA bytes, the top row first.
inline ByteImage picture_of(const std::vector<std::uint8_t>& bytes, int width, int height) {
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::runtime_error(fmt::format("OpenGL error {}", error));
  }
  ByteImage image{width, height, 4, {}};
  const std::size_t row = static_cast<std::size_t>(width) * 4;
  for (auto y = static_cast<std::size_t>(height); y-- > 0;) {
    const auto* begin = bytes.data() + y * row;
    image.pixels.insert(image.pixels.end(), begin, begin + row);
  }
  return image;
}

/// The uniforms of shaders that know the common scene's lights: what no light brings, and each light's place and products with the material.
inline void set_plain_scene(const peers::Uniforms& uniforms, const Scene& scene, const peers::GlCamera& camera) {
  const auto light_of = [](const Color& c) { return truth::light_of(c, Transfer::none); };
  const auto times = [](const Vec3d& a, const Vec3d& b) { return Vec3d{a.x * b.x, a.y * b.y, a.z * b.z}; };
  const Material& material = *scene.objects.front().material;
  Vec3d color = times(light_of(material.ambient), light_of(scene.ambient)) + light_of(material.emission);
  for (std::size_t i = 0; i < scene.lights->size(); ++i) {
    const Light& light = (*scene.lights)[i];
    const std::string at = fmt::format("[{}]", i);
    color = color + times(light_of(material.ambient), light_of(light.ambient));
    uniforms.set("places" + at, light.type == LightType::directional ? peers::turn(camera.eye_from_world, light.direction) * -1.0
                                                                     : transform_point(camera.eye_from_world, light.position));
    uniforms.set("diffuses" + at, times(light_of(material.diffuse), light_of(light.diffuse)));
    uniforms.set("speculars" + at, times(light_of(material.specular), light_of(light.specular)));
  }
  uniforms.set("scene_color", color);
  uniforms.set("shininess", static_cast<double>(material.shininess));
}

}  // namespace lustro::bench
