// The context, the canvas and the camera.
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "peers/gl.hpp"
#include "truth/evaluate.hpp"

namespace lustro::peers {
namespace {

Vec3d unit(const Vec3d& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

}  // namespace

GlContext::GlContext() {
  const std::array attributes{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_DEPTH_BITS, 24, OSMESA_PROFILE, OSMESA_COMPAT_PROFILE, 0, 0};
  context_ = OSMesaCreateContextAttribs(attributes.data(), nullptr);
  if (context_ == nullptr) {
    throw std::runtime_error("OSMesa makes no context");
  }
}

GlContext::~GlContext() {
  OSMesaDestroyContext(context_);
}

void GlContext::begin(const Scene& scene) {
  width_ = scene.image.width;
  height_ = scene.image.height;
  buffer_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4, 0);
  if (OSMesaMakeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, width_, height_) != GL_TRUE) {
    throw std::runtime_error("OSMesa cannot draw here");
  }
  OSMesaPixelStore(OSMESA_Y_UP, 0);
  glViewport(0, 0, width_, height_);
  glDisable(GL_DITHER);
  (scene.shading.cull == Culling::none ? glDisable : glEnable)(GL_CULL_FACE);
  glCullFace(scene.shading.cull == Culling::front ? GL_FRONT : GL_BACK);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  const Vec3d background = truth::light_of(scene.image.background, scene.image.transfer);
  const auto shown = [&](double c) { return static_cast<float>(truth::stored(c, scene.image.transfer)); };
  glClearColor(shown(background.x), shown(background.y), shown(background.z), 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

ByteImage GlContext::end() {
  glFinish();
  if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
    throw std::runtime_error("OpenGL error " + std::to_string(error));
  }
  ByteImage image;
  image.width = width_;
  image.height = height_;
  image.channels = 4;
  image.pixels = buffer_;
  return image;
}

std::string gl_description() {
  const auto text = [](GLenum name) {
    const GLubyte* value = glGetString(name);
    return value != nullptr ? std::string(value, value + std::char_traits<char>::length(reinterpret_cast<const char*>(value)))
                            : std::string("?");
  };
  return text(GL_VERSION) + ", " + text(GL_RENDERER) + ", GLSL " + text(GL_SHADING_LANGUAGE_VERSION);
}

GlCamera gl_camera(const Scene& scene) {
  const Camera& camera = scene.camera;
  const Vec3d eye = camera.eye.value();
  const Vec3d backward = unit(eye - camera.target.value());
  const Vec3d right = unit(cross(camera.up.value_or(Vec3d{0, 1, 0}), backward));
  const Vec3d up = cross(backward, right);
  GlCamera result;
  const std::array<Vec3d, 3> axes{right, up, backward};
  for (int row = 0; row < 3; ++row) {
    const Vec3d& axis = axes[static_cast<std::size_t>(row)];
    result.eye_from_world(row, 0) = axis.x;
    result.eye_from_world(row, 1) = axis.y;
    result.eye_from_world(row, 2) = axis.z;
    result.eye_from_world(row, 3) = -dot(axis, eye);
  }
  const double near = camera.near.value();
  const double far = camera.far.value();
  const double aspect = static_cast<double>(scene.image.width) / scene.image.height;
  if (camera.projection == Projection::perspective) {  // gluPerspective
    const double f = 1 / std::tan(camera.fov * 3.14159265358979323846 / 360);
    result.clip_from_eye = {f / aspect, 0, 0, 0, 0, f, 0, 0, 0, 0, (far + near) / (near - far), 2 * far * near / (near - far), 0, 0, -1, 0};
  } else {  // glOrtho
    const double height = camera.height.value();
    result.clip_from_eye = {2 / (height * aspect),        0, 0, 0, 0, 2 / height, 0, 0, 0, 0, -2 / (far - near),
                            -(far + near) / (far - near), 0, 0, 0, 1};
  }
  return result;
}

std::array<float, 16> column_major(const std::array<double, 16>& row_major) {
  std::array<float, 16> result{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      result[4 * column + row] = static_cast<float>(row_major[4 * row + column]);
    }
  }
  return result;
}

bool is_mirrored(const Mat4& m) {
  return dot(Vec3d{m(0, 0), m(0, 1), m(0, 2)}, cross(Vec3d{m(1, 0), m(1, 1), m(1, 2)}, Vec3d{m(2, 0), m(2, 1), m(2, 2)})) < 0;
}

}  // namespace lustro::peers
