// bench_llvmpipe_textured SUBJECT [SECONDS]: the common scene under a diffuse, a specular and a normal map of 1024 x 1024 texels, trilinear, by
// Mesa's llvmpipe beside ours, and ours without the maps. The pictures are compared first.
#include <cstdio>
#include <cstdlib>

#include "common/frames.hpp"
#include "common/gl_canvas.hpp"
#include "common/measure.hpp"
#include "common/textured.hpp"

namespace lustro::bench {
namespace {

constexpr const char* kVertexShader = R"(#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 tangent;
uniform mat4 eye_from_object;
uniform mat4 clip_from_eye;
uniform mat3 normal_from_object;
out vec3 surface_position;
out vec3 surface_normal;
out vec2 surface_uv;
out vec4 surface_tangent;
void main() {
  vec4 eye = eye_from_object * vec4(position, 1.0);
  surface_position = eye.xyz;
  surface_normal = normal_from_object * normal;
  surface_uv = uv;
  surface_tangent = vec4(mat3(eye_from_object) * tangent.xyz, tangent.w);
  gl_Position = clip_from_eye * eye;
}
)";

// Two directional lights, then a point light that does not attenuate.
constexpr const char* kFragmentShader = R"(#version 300 es
precision highp float;
in vec3 surface_position;
in vec3 surface_normal;
in vec2 surface_uv;
in vec4 surface_tangent;
uniform sampler2D diffuse_map;
uniform sampler2D specular_map;
uniform sampler2D normal_map;
uniform vec3 scene_color;
uniform float shininess;
uniform vec3 places[3];
uniform vec3 diffuses[3];
uniform vec3 speculars[3];
out vec4 fragment_color;
void main() {
  vec3 bitangent = (surface_tangent.w < 0.0 ? -1.0 : 1.0) * cross(surface_normal, surface_tangent.xyz);
  vec3 stated = texture(normal_map, surface_uv).xyz * 2.0 - 1.0;
  vec3 n = normalize(stated.x * surface_tangent.xyz + stated.y * bitangent + stated.z * surface_normal);
  if (!gl_FrontFacing) n = -n;
  vec3 kd = texture(diffuse_map, surface_uv).xyz;
  vec3 ks = texture(specular_map, surface_uv).xyz;
  vec3 v = normalize(-surface_position);
  vec3 color = scene_color;
  for (int i = 0; i < 3; ++i) {
    vec3 l = i < 2 ? places[i] : normalize(places[i] - surface_position);
    float n_dot_l = dot(n, l);
    float r_dot_v = dot(2.0 * n_dot_l * n - l, v);
    float spec = n_dot_l > 0.0 && r_dot_v > 0.0 ? pow(r_dot_v, shininess) : 0.0;
    color += kd * diffuses[i] * max(n_dot_l, 0.0) + ks * speculars[i] * spec;
  }
  fragment_color = vec4(color, 1.0);
}
)";

/// llvmpipe's side: the mesh and the maps lie in its memory, a frame sets what turns, clears, draws, finishes and reads.
class PeerFrames {
 public:
  PeerFrames(const Subject& subject, const Scene& scene, const Maps& maps)
      : subject_(subject), camera_(peers::gl_camera(scene)), width_(scene.image.width), height_(scene.image.height) {
    Scene small = scene;  // the context's own picture is not drawn to
    small.image.width = small.image.height = 16;
    context_.begin(small);
    glBindFramebuffer(GL_FRAMEBUFFER, Canvas(width_, height_, 1).name);
    glViewport(0, 0, width_, height_);
    glDisable(GL_CULL_FACE);
    const Mesh& mesh = *scene.objects.front().mesh;
    corners_ = static_cast<GLsizei>(3 * mesh.triangles.size());
    attribute(0, 3, mesh.positions);
    attribute(1, 3, mesh.normals);
    attribute(2, 2, mesh.uvs);
    attribute(3, 4, mesh.tangents);
    upload(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    bytes_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
    program_ = linked(kVertexShader, kFragmentShader);
    glUseProgram(program_);
    bind(maps.diffuse, 0, "diffuse_map");
    bind(maps.specular, 1, "specular_map");
    bind(maps.normal, 2, "normal_map");
    const peers::Uniforms uniforms(program_);
    peers::set_scene(uniforms, scene, camera_);
    set_plain_scene(uniforms, scene, camera_);
    eye_from_object_ = glGetUniformLocation(program_, "eye_from_object");
  }

  void draw(int i) {
    const Mat4 eye_from_object = camera_.eye_from_world * turned(subject_, i);
    glUniformMatrix4fv(eye_from_object_, 1, GL_FALSE, peers::column_major(eye_from_object.m).data());
    peers::Uniforms(program_).set_normal_matrix("normal_from_object", eye_from_object);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, corners_, GL_UNSIGNED_INT, nullptr);
    glFinish();
  }
  void draw_and_read(int i) {
    draw(i);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
  }
  [[nodiscard]] ByteImage picture() const { return picture_of(bytes_, width_, height_); }

 private:
  template <class T>
  static void attribute(GLuint location, GLint size, const std::vector<T>& values) {
    upload(GL_ARRAY_BUFFER, values);
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, sizeof(T), nullptr);
  }
  void bind(const ByteImage& image, int unit, const char* name) const {
    GLuint texture = 0;
    glGenTextures(1, &texture);
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGB, GL_UNSIGNED_BYTE, image.pixels.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    peers::Uniforms(program_).set(name, unit);
  }
  const Subject& subject_;
  peers::GlContext context_;
  peers::GlCamera camera_;
  int width_, height_;
  GLsizei corners_ = 0;
  GLuint program_ = 0;
  GLint eye_from_object_ = -1;
  std::vector<std::uint8_t> bytes_;
};

int compare(const Subject& subject, double seconds) {
  // llvmpipe blends mip levels only in a part of the way between two, and takes its derivatives from groups of four pixels.
  constexpr double kBound = 0.01;
  const Maps maps = make_maps();
  const Scene scene = textured_scene(subject, maps);
  OurFrames ours(subject, scene);
  OurFrames plain(subject, common_scene(subject, 1));
  PeerFrames peer(subject, scene, maps);
  const std::string key = fmt::format("llvmpipe/{}/1/textured", subject.name);
  peer.draw_and_read(3);
  const Rendering& picture = ours.draw(3);
  const double differs = share_that_differs(picture.bytes, peer.picture());
  const std::string check = fmt::format("{:.3f} % of the pixels differ by more than 2/255 (bound {:.1f} %)", 100 * differs, 100 * kBound);
  if (differs > kBound) {
    report_failure(key, check);
    return 1;
  }
  const std::vector<Side> sides{{"ours", [&](int i) { ours.draw(i); }},
                                {"plain", [&](int i) { plain.draw(i); }},
                                {"finish", [&](int i) { peer.draw(i); }},
                                {"bytes", [&](int i) { peer.draw_and_read(i); }}};
  report(key, check, sides, in_turns(sides, {.most_seconds = seconds}));
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  const lustro::bench::Subject* subject = argc > 1 ? lustro::bench::find_subject(argv[1]) : nullptr;
  if (subject == nullptr || subject->fills_the_picture) {
    std::fprintf(stderr, "usage: bench_llvmpipe_textured SUBJECT [SECONDS]\n");
    return 2;
  }
  try {
    return lustro::bench::compare(*subject, argc > 2 ? std::atof(argv[2]) : 40);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_llvmpipe_textured: %s\n", e.what());
    return 1;
  }
}
