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

}  // namespace lustro::bench
