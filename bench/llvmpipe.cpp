// bench_llvmpipe SUBJECT SAMPLES [SECONDS]: the common scene by Mesa's llvmpipe beside ours, without and with back-face culling. Indexed
// triangles from vertex buffers into a renderbuffer, multisampled for 4 samples; a frame ends with glFinish. The pictures are compared first.
//
// Two programs are at hand: the shaders that `lustro glsl` prints, and plain ones that know this scene's lights; the faster is timed. With
// culling the program is one that lights front faces only. Times are taken to glFinish ("finish") and to the bytes read back ("bytes").
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "common/frames.hpp"
#include "common/gl_canvas.hpp"
#include "common/measure.hpp"

namespace lustro::bench {
namespace {

/// What the shaders of `lustro glsl` decide at run time, decided: two directional lights, then a point light that does not attenuate.
std::string plain_fragment_shader(bool two_sided) {
  return fmt::format(R"(#version 300 es
precision highp float;
in vec3 surface_position;
in vec3 surface_normal;
uniform vec3 scene_color;
uniform vec3 material_specular;
uniform float shininess;
uniform vec3 places[3];
uniform vec3 diffuses[3];
uniform vec3 speculars[3];
out vec4 fragment_color;
void main() {{
  vec3 n = normalize(surface_normal);
  {}
  vec3 v = normalize(-surface_position);
  vec3 color = scene_color;
  for (int i = 0; i < 3; ++i) {{
    vec3 l = i < 2 ? places[i] : normalize(places[i] - surface_position);
    float n_dot_l = dot(n, l);
    float r_dot_v = dot(2.0 * n_dot_l * n - l, v);
    float spec = n_dot_l > 0.0 && r_dot_v > 0.0 ? pow(r_dot_v, shininess) : 0.0;
    color += diffuses[i] * max(n_dot_l, 0.0) + speculars[i] * spec;
  }}
  fragment_color = vec4(color, 1.0);
}}
)",
                     two_sided ? "if (!gl_FrontFacing) n = -n;" : "");
}

enum class Shaders { mirror, plain };

/// llvmpipe's side: the mesh lies in buffers, a frame sets what turns, clears, draws and finishes.
class PeerFrames {
 public:
  PeerFrames(const Subject& subject, Scene scene)
      : subject_(subject),
        scene_(std::move(scene)),
        camera_(peers::gl_camera(scene_)),
        width_(scene_.image.width),
        height_(scene_.image.height) {
    Scene small = scene_;  // the context's own picture is not drawn to
    small.image.width = small.image.height = 16;
    context_.begin(small);
    resolved_ = Canvas(width_, height_, 1).name;
    drawn_ = scene_.image.samples > 1 ? Canvas(width_, height_, scene_.image.samples).name : resolved_;
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glViewport(0, 0, width_, height_);
    const Mesh& mesh = *scene_.objects.front().mesh;
    upload(GL_ARRAY_BUFFER, mesh.positions);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    upload(GL_ARRAY_BUFFER, mesh.normals);
    glEnableVertexAttribArray(1);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vec3f), nullptr);
    upload(GL_ELEMENT_ARRAY_BUFFER, mesh.triangles);
    bytes_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * 4);
  }

  void use(Shaders shaders, bool culls) {
    (culls ? glEnable : glDisable)(GL_CULL_FACE);
    GlslOptions options{.lighting = Lighting::phong, .two_sided = !culls, .transfer = Transfer::none, .max_lights = 3};
    if (shaders == Shaders::mirror) {
      program_ = peers::program_of(context_, options);
    } else {
      GLuint& program = plain_[culls ? 1 : 0];
      if (program == 0) {
        program = linked(glsl_shader(GlslStage::vertex, options), plain_fragment_shader(!culls));
      }
      program_ = program;
    }
    glUseProgram(program_);
    const peers::Uniforms uniforms(program_);
    peers::set_scene(uniforms, scene_, camera_);
    peers::set_material(uniforms, *scene_.objects.front().material, Transfer::none);
    if (shaders == Shaders::plain) {
      set_plain_scene(uniforms, scene_, camera_);
    }
    eye_from_object_ = glGetUniformLocation(program_, "eye_from_object");
  }

  void draw(int i) {
    const Mat4 eye_from_object = camera_.eye_from_world * turned(subject_, i);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glUniformMatrix4fv(eye_from_object_, 1, GL_FALSE, peers::column_major(eye_from_object.m).data());
    peers::Uniforms(program_).set_normal_matrix("normal_from_object", eye_from_object);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * scene_.objects.front().mesh->triangles.size()), GL_UNSIGNED_INT, nullptr);
    if (drawn_ != resolved_) {
      glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
      glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
      glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
      glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
    }
    glFinish();
  }

  void draw_and_read(int i) {
    draw(i);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, bytes_.data());
  }

  [[nodiscard]] ByteImage picture() const { return picture_of(bytes_, width_, height_); }

 private:
  const Subject& subject_;
  Scene scene_;
  peers::GlContext context_;
  peers::GlCamera camera_;
  int width_, height_;
  GLuint drawn_ = 0, resolved_ = 0, program_ = 0;
  std::array<GLuint, 2> plain_{};
  GLint eye_from_object_ = -1;
  std::vector<std::uint8_t> bytes_;
};

/// A pixel whose triangle or sample falls to another side may differ; surfaces may not. More samples lie elsewhere than llvmpipe's do.
double bound(int samples) {
  return samples > 1 ? 0.01 : 0.003;
}

std::string key_of(const Subject& subject, int samples, bool culls) {
  return fmt::format("llvmpipe/{}/{}/{}", subject.name, samples, culls ? "culled" : "all");
}

/// Picks the faster program; nothing if either draws another picture than ours.
bool choose(PeerFrames& peer, OurFrames& ours, bool culls, const std::string& key, int samples, std::string& check, Shaders& best) {
  double worst = 0;
  double covered = 0;
  for (const Shaders shaders : {Shaders::mirror, Shaders::plain}) {
    peer.use(shaders, culls);
    peer.draw_and_read(3);
    const Rendering& picture = ours.draw(3);
    covered = 100.0 * static_cast<double>(picture.stats.pixels_covered) / (static_cast<double>(picture.bytes.width) * picture.bytes.height);
    worst = std::max(worst, share_that_differs(picture.bytes, peer.picture()));
  }
  check = fmt::format("{:.3f} % of the pixels differ by more than 2/255 (bound {:.1f} %); {:.1f} % covered", 100 * worst, 100 * bound(samples),
                      covered);
  if (worst > bound(samples)) {
    report_failure(key, check);
    return false;
  }
  const auto draw_by = [&](Shaders shaders) {
    return [&peer, shaders, culls](int i) {
      peer.use(shaders, culls);
      peer.draw(i);
    };
  };
  const std::vector<Times> trial =
      in_turns({{"mirror", draw_by(Shaders::mirror)}, {"plain", draw_by(Shaders::plain)}}, {.rounds = 3, .turn_ms = 50, .most_seconds = 5});
  best = trial[0].min_ms < trial[1].min_ms ? Shaders::mirror : Shaders::plain;
  check += best == Shaders::plain ? "; plain shaders" : "; shaders of `lustro glsl`";
  return true;
}

int compare(const Subject& subject, int samples, double seconds) {
  const Scene scene = common_scene(subject, samples);
  OurFrames ours(subject, scene);
  PeerFrames peer(subject, scene);
  int status = 0;
  for (const bool culls : {false, true}) {
    const std::string key = key_of(subject, samples, culls);
    ours.cull(culls);
    std::string check;
    Shaders best = Shaders::mirror;
    if (!choose(peer, ours, culls, key, samples, check, best)) {
      status = 1;
      continue;
    }
    peer.use(best, culls);
    const std::vector<Side> sides{
        {"ours", [&](int i) { ours.draw(i); }}, {"finish", [&](int i) { peer.draw(i); }}, {"bytes", [&](int i) { peer.draw_and_read(i); }}};
    report(key, check, sides, in_turns(sides, {.most_seconds = seconds / 2}));
  }
  return status;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  const lustro::bench::Subject* subject = argc > 2 ? lustro::bench::find_subject(argv[1]) : nullptr;
  const int samples = subject != nullptr ? std::atoi(argv[2]) : 0;
  if (samples != 1 && samples != 4) {
    std::fprintf(stderr, "usage: bench_llvmpipe SUBJECT 1|4 [SECONDS]\n");
    return 2;
  }
  try {
    return lustro::bench::compare(*subject, samples, argc > 3 ? std::atof(argv[3]) : 40);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_llvmpipe: %s\n", e.what());
    return 1;
  }
}
