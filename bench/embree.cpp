// bench_embree SUBJECT [SECONDS]: Embree's primary rays alone beside our whole frame, lit and in bytes. One ray through the middle of each pixel
// in packets of 16 (4 x 4 pixels), marked coherent, on all cores; the BVH (high quality) is built before and not counted. Compared first: the
// number of rays that hit with the number of pixels that we cover.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#if defined(__SSE__)
#include <xmmintrin.h>
#endif

#include "common/frames.hpp"
#include "common/measure.hpp"
#include "parallel/parallel_for.hpp"

namespace lustro::bench {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3d unit(const Vec3d& v) {
  return v * (1 / std::sqrt(dot(v, v)));
}

/// How a packet is handed over.
enum class Packets { of_16, stream };

/// Embree's side: the mesh stands still, the rays turn the other way.
class Rays {
 public:
  Rays(const Subject& subject, const Scene& scene)
      : subject_(subject), image_(scene.image), device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    const Mesh& mesh = *scene.objects.front().mesh;
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.positions.size());
    void* triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size());
    if (positions == nullptr || triangles == nullptr) {
      throw std::runtime_error("Embree has no room for the mesh");
    }
    std::memcpy(positions, mesh.positions.data(), mesh.positions.size() * sizeof(Vec3f));
    std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * 12);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
    if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
      throw std::runtime_error("Embree builds no BVH");
    }
    const Camera& camera = scene.camera;
    eye_ = camera.eye.value();
    backward_ = unit(eye_ - camera.target.value());
    right_ = unit(cross(camera.up.value(), backward_));
    up_ = cross(backward_, right_);
    half_height_ = std::tan(camera.fov * kPi / 360);
    near_ = static_cast<float>(camera.near.value());
  }
  ~Rays() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Rays(const Rays&) = delete;
  Rays& operator=(const Rays&) = delete;

  /// Shoots frame `i` and counts what is hit.
  std::size_t shoot(int i, Packets packets) const {
    const Frame frame = frame_of(i);
    const auto tiles_x = static_cast<std::size_t>((image_.width + kTile - 1) / kTile);
    const auto tiles_y = static_cast<std::size_t>((image_.height + kTile - 1) / kTile);
    std::atomic<std::size_t> hits{0};
    parallel_for(tiles_x * tiles_y, 0, [&](std::size_t tile) {
      flush_denormals();
      hits += shoot_tile(frame, static_cast<int>(tile % tiles_x) * kTile, static_cast<int>(tile / tiles_x) * kTile, packets);
    });
    return hits;
  }

 private:
  static constexpr int kTile = 64;  // pixels

  /// Origin and directions in the mesh's own space.
  struct Frame {
    Vec3f eye, corner, right, down;  ///< the ray of pixel (x, y): corner + (x + 1/2) right + (y + 1/2) down
  };

  static void flush_denormals() {  // as Embree's manual asks
#if defined(__SSE__)
    _mm_setcsr(_mm_getcsr() | 0x8040U);
#endif
  }

  [[nodiscard]] Frame frame_of(int i) const {
    const Mat4 m = turned(subject_, i);
    const auto back = [&](const Vec3d& v) {  // the transpose of a rotation
      return Vec3f{static_cast<float>(m(0, 0) * v.x + m(1, 0) * v.y + m(2, 0) * v.z),
                   static_cast<float>(m(0, 1) * v.x + m(1, 1) * v.y + m(2, 1) * v.z),
                   static_cast<float>(m(0, 2) * v.x + m(1, 2) * v.y + m(2, 2) * v.z)};
    };
    const double step = 2 * half_height_ / image_.height;
    const Vec3d corner = right_ * (-0.5 * step * image_.width) + up_ * half_height_ - backward_;
    return {back(eye_), back(corner), back(right_ * step), back(up_ * -step)};
  }

  std::size_t shoot_tile(const Frame& frame, int x0, int y0, Packets packets) const {
    RTCIntersectContext context{};
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    alignas(64) std::array<RTCRayHit16, kTile / 4> row;  // NOLINT(cppcoreguidelines-pro-type-member-init): fill() sets all that counts
    std::size_t hits = 0;
    for (int y = y0; y < std::min(y0 + kTile, image_.height); y += 4) {
      std::size_t count = 0;
      for (int x = x0; x < std::min(x0 + kTile, image_.width); x += 4) {
        fill(frame, x, y, row[count++]);
      }
      if (packets == Packets::of_16) {
        alignas(64) std::array<int, 16> valid{};
        valid.fill(-1);
        for (std::size_t p = 0; p < count; ++p) {
          rtcIntersect16(valid.data(), scene_, &context, &row[p]);
        }
      } else {
        shoot_stream(context, row, count);
      }
      for (std::size_t p = 0; p < count; ++p) {
        for (const unsigned id : row[p].hit.geomID) {
          hits += id != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
      }
    }
    return hits;
  }

  void shoot_stream(RTCIntersectContext& context, std::array<RTCRayHit16, kTile / 4>& row, std::size_t count) const {
    for (std::size_t p = 0; p < count; ++p) {
      RTCRayHit16& r = row[p];
      RTCRayHitNp pointers{{r.ray.org_x, r.ray.org_y, r.ray.org_z, r.ray.tnear, r.ray.dir_x, r.ray.dir_y, r.ray.dir_z, r.ray.time, r.ray.tfar,
                            r.ray.mask, r.ray.id, r.ray.flags},
                           {r.hit.Ng_x, r.hit.Ng_y, r.hit.Ng_z, r.hit.u, r.hit.v, r.hit.primID, r.hit.geomID, {r.hit.instID[0]}}};
      rtcIntersectNp(scene_, &context, &pointers, 16);
    }
  }

  void fill(const Frame& frame, int x0, int y0, RTCRayHit16& packet) const {
    for (unsigned i = 0; i < 16; ++i) {
      const float x = static_cast<float>(x0 + static_cast<int>(i % 4)) + 0.5F;
      const float y = static_cast<float>(y0 + static_cast<int>(i / 4)) + 0.5F;
      packet.ray.org_x[i] = frame.eye.x;
      packet.ray.org_y[i] = frame.eye.y;
      packet.ray.org_z[i] = frame.eye.z;
      packet.ray.dir_x[i] = frame.corner.x + frame.right.x * x + frame.down.x * y;
      packet.ray.dir_y[i] = frame.corner.y + frame.right.y * x + frame.down.y * y;
      packet.ray.dir_z[i] = frame.corner.z + frame.right.z * x + frame.down.z * y;
      packet.ray.tnear[i] = near_;  // the direction's depth is 1
      packet.ray.tfar[i] = 1e30F;
      packet.ray.time[i] = 0;
      packet.ray.mask[i] = 0xFFFFFFFFU;
      packet.ray.id[i] = 0;
      packet.ray.flags[i] = 0;
      packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
      packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
  }

  const Subject& subject_;
  ImageSettings image_;
  RTCDevice device_;
  RTCScene scene_;
  Vec3d eye_, backward_, right_, up_;
  double half_height_ = 0;
  float near_ = 0;
};

int compare(const Subject& subject, double seconds) {
  constexpr double kBound = 0.001;
  const std::string key = "embree/" + subject.name;
  const Scene scene = common_scene(subject, 1);
  OurFrames ours(subject, scene);
  const Rays rays(subject, scene);
  const auto covered = static_cast<double>(ours.draw(3).stats.pixels_covered);
  double worst = 0;
  for (const Packets packets : {Packets::of_16, Packets::stream}) {
    worst = std::max(worst, std::abs(static_cast<double>(rays.shoot(3, packets)) - covered) / covered);
  }
  const std::string check =
      fmt::format("{:.0f} pixels covered, Embree's hits differ by {:.4f} % (bound {:.1f} %)", covered, 100 * worst, 100 * kBound);
  if (worst > kBound) {
    report_failure(key, check);
    return 1;
  }
  const std::vector<Side> sides{{"ours", [&](int i) { ours.draw(i); }},
                                {"packets", [&](int i) { (void)rays.shoot(i, Packets::of_16); }},
                                {"stream", [&](int i) { (void)rays.shoot(i, Packets::stream); }}};
  report(key, check, sides, in_turns(sides, {.most_seconds = seconds}));
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  const lustro::bench::Subject* subject = argc > 1 ? lustro::bench::find_subject(argv[1]) : nullptr;
  if (subject == nullptr) {
    std::fprintf(stderr, "usage: bench_embree SUBJECT [SECONDS]\n");
    return 2;
  }
  try {
    return lustro::bench::compare(*subject, argc > 2 ? std::atof(argv[2]) : 20);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_embree: %s\n", e.what());
    return 1;
  }
}
