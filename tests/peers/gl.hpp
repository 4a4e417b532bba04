// OpenGL without a window: Mesa's OSMesa, which draws with llvmpipe into memory.
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/scene.hpp"

namespace lustro::peers {

/// A compatibility context: fixed function and GLSL side by side.
class GlContext {
 public:
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

  /// Makes a cleared picture of the scene's size and background current, with depth test, no culling and dithering off.
  void begin(const Scene& scene);
  /// What was drawn, the top row first, RGBA.
  [[nodiscard]] ByteImage end();

  std::map<std::string, GLuint> programs;  ///< by their text: each is compiled once

 private:
  OSMesaContext context_;
  std::vector<unsigned char> buffer_;
  int width_ = 0, height_ = 0;
};

/// Version and renderer, for the log.
[[nodiscard]] std::string gl_description();

/// Row-major matrices of the camera, made from what it states (eye, target, near and far must be stated).
struct GlCamera {
  Mat4 eye_from_world;
  std::array<double, 16> clip_from_eye{};  ///< row-major
};
[[nodiscard]] GlCamera gl_camera(const Scene& scene);

/// Column-major, as OpenGL takes it.
[[nodiscard]] std::array<float, 16> column_major(const std::array<double, 16>& row_major);

/// A determinant below 0 turns the winding round, and the front with it.
[[nodiscard]] bool is_mirrored(const Mat4& matrix);

/// The fixed function: Gouraud with a local viewer (perspective) or the constant viewer (orthographic), Blinn-Phong or Lambert, up to 8 lights
/// with polynomial attenuation; `flat` where all vertices of a face get the same colour.
[[nodiscard]] ByteImage draw_with_fixed_function(GlContext& context, const Scene& scene);

/// The shaders of glsl_shader(), the very text that `lustro glsl` prints.
[[nodiscard]] ByteImage draw_with_glsl(GlContext& context, const Scene& scene);

}  // namespace lustro::peers
