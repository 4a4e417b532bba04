// bench_path rays SCENE [SECONDS]: the rays per second that our paths shoot beside Embree's own, asked for rays that are made before.
// bench_path draw SCENE: draws on command, for bench/equal_quality.py, which takes turns with Mitsuba. A line `SPP SEED FILE` on standard input
// (FILE
// `-`: none) brings a line of JSON with the milliseconds, and the picture as floats, four a pixel.
#include <embree3/rtcore.h>
#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "common/measure.hpp"
#include "lustro/render.hpp"
#include "lustro/scene.hpp"
#include "parallel/parallel_for.hpp"
#include "path/emitters.hpp"
#include "path/random.hpp"
#include "path/rays.hpp"
#include "path/sampling.hpp"
#include "path/surface_point.hpp"
#include "scene/prepare.hpp"

namespace lustro::bench {
namespace {

Scene loaded(const char* file) {
  auto scene = load_scene(file);
  if (!scene) {
    throw std::runtime_error(scene.error().text());
  }
  return std::move(scene->scene);
}

Rendering draw(const Scene& scene, int samples, std::uint32_t seed) {
  RenderOptions options;
  options.engine = Engine::path;
  options.path = {.samples = samples, .seed = seed};
  auto drawn = render(scene, options);
  if (!drawn) {
    throw std::runtime_error(drawn.error().text());
  }
  return *std::move(drawn);
}

int serve(const Scene& scene) {
  int samples = 0;
  std::uint32_t seed = 0;
  std::string file;
  while (std::cin >> samples >> seed >> file) {
    const std::clock_t processor = std::clock();
    const auto begin = std::chrono::steady_clock::now();
    const Rendering drawn = draw(scene, samples, seed);
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const double processor_ms = static_cast<double>(std::clock() - processor) * 1e3 / CLOCKS_PER_SEC;
    if (file != "-") {
      std::ofstream out(file, std::ios::binary);
      out.write(reinterpret_cast<const char*>(drawn.color.pixels.data()),
                static_cast<std::streamsize>(drawn.color.pixels.size() * sizeof(float)));
    }
    std::printf("%s\n", nlohmann::json{{"ms", ms}, {"processor_ms", processor_ms}, {"rays", drawn.stats.rays}}.dump().c_str());
    std::fflush(stdout);
  }
  return 0;
}

/// A ray and what is asked of it.
struct Question {
  Ray ray;
  bool is_shadow = false;
};

// Rays as paths shoot them: from each pixel on from surface to surface by the cosine, and from each of those to a place of a lamp.
std::vector<std::vector<Question>> questions_of(const PreparedScene& scene, const RayScene& rays) {
  constexpr int kTile = 16;
  constexpr int kSamples = 8;
  constexpr int kBounces = 5;
  const Emitters emitters(scene);
  const int tiles = scene.view.width / kTile;
  std::vector<std::vector<Question>> questions(static_cast<std::size_t>(tiles) * static_cast<std::size_t>(scene.view.height / kTile));
  parallel_for(questions.size(), 0, [&](std::size_t tile) {
    const int left = static_cast<int>(tile) % tiles * kTile;
    const int top = static_cast<int>(tile) / tiles * kTile;
    for (int i = 0; i < kTile * kTile * kSamples; ++i) {
      const int pixel = i / kSamples;
      const PathRandom random(static_cast<std::uint32_t>(tile) * kTile * kTile + static_cast<std::uint32_t>(pixel),
                              static_cast<std::uint32_t>(i), 1);
      const Vec2f jitter = random.pair(0);
      Ray ray{
          {},
          scene.view.point_at(static_cast<float>(left + pixel % kTile) + jitter.x, static_cast<float>(top + pixel / kTile) + jitter.y, 1.0F)};
      ray.direction = normalize(ray.direction);
      for (std::uint32_t bounce = 0; bounce < kBounces; ++bounce) {
        questions[tile].push_back({ray, false});
        RayHit hit;
        if (!rays.closest(ray, hit)) {
          break;
        }
        const SurfacePlace place = place_of(scene, hit, rays.met(hit), ray.direction, true);
        const Vec3f normal = place.is_front ? place.geometric_normal : -place.geometric_normal;
        const Vec3f origin = place.position + normal * place.offset;
        const EmitterSample light = emitters.sample(origin, random.pair(3 * bounce + 1));
        if (light.density > 0 && dot(light.to_light, normal) > 0) {
          questions[tile].push_back({{origin, light.to_light, 0, light.distance * 0.999F}, true});
        }
        ray = {origin, Frame3(normal).world(sample_cosine(random.pair(3 * bounce + 2)))};
      }
    }
  });
  return questions;
}

// Embree's own rate: nothing is done with the answers but to count them.
class RawRays {
 public:
  explicit RawRays(const PreparedScene& scene) : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    for (const Instance& instance : scene.instances) {
      const Mesh& mesh = *instance.mesh;
      RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
      auto* const positions = static_cast<Vec3f*>(
          rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(Vec3f), mesh.positions.size()));
      void* const triangles = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, mesh.triangles.size());
      if (positions == nullptr || triangles == nullptr) {
        throw std::runtime_error("Embree has no room for the mesh");
      }
      std::transform(mesh.positions.begin(), mesh.positions.end(), positions, [&](const Vec3f& p) { return instance.relative_from_object(p); });
      std::memcpy(triangles, mesh.triangles.data(), mesh.triangles.size() * 12);
      rtcCommitGeometry(geometry);
      rtcAttachGeometry(scene_, geometry);
      rtcReleaseGeometry(geometry);
    }
    rtcCommitScene(scene_);
  }
  ~RawRays() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  RawRays(const RawRays&) = delete;
  RawRays& operator=(const RawRays&) = delete;

  std::size_t ask(const std::vector<std::vector<Question>>& questions) const {
    std::atomic<std::size_t> hits{0};
    parallel_for(questions.size(), 0, [&](std::size_t tile) {
      std::size_t met = 0;
      RTCIntersectContext context{};
      rtcInitIntersectContext(&context);
      for (const Question& q : questions[tile]) {
        const Ray& r = q.ray;
        RTCRayHit query{
            {r.origin.x, r.origin.y, r.origin.z, r.nearest, r.direction.x, r.direction.y, r.direction.z, 0, r.farthest, 0xFFFFFFFFU, 0, 0}, {}};
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        if (q.is_shadow) {
          rtcOccluded1(scene_, &context, &query.ray);
          met += query.ray.tfar < 0 ? 1 : 0;
        } else {
          rtcIntersect1(scene_, &context, &query);
          met += query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
        }
      }
      hits += met;
    });
    return hits;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

int compare_rates(const Scene& scene, double seconds) {
  const auto prepared = prepare(scene);
  if (!prepared) {
    throw std::runtime_error(prepared.error().text());
  }
  const auto rays = RayScene::make(*prepared);
  if (!rays) {
    throw std::runtime_error(rays.error().text());
  }
  const auto questions = questions_of(*prepared, *rays);
  const RawRays raw(*prepared);
  std::size_t count = 0;
  std::size_t ours = 0;
  for (const auto& tile : questions) {
    count += tile.size();
    for (const Question& q : tile) {
      RayHit hit;
      ours += (q.is_shadow ? rays->is_blocked(q.ray) : rays->closest(q.ray, hit)) ? 1U : 0U;
    }
  }
  const std::string key = "path/rays";
  if (const std::size_t theirs = raw.ask(questions); theirs != ours) {
    report_failure(key, fmt::format("{} rays meet something, by Embree alone {}", ours, theirs));
    return 1;
  }
  constexpr int kSamples = 16;
  std::uint64_t shot = 0;
  const std::vector<Side> sides{{"ours", [&](int i) { shot = draw(scene, kSamples, static_cast<std::uint32_t>(i)).stats.rays; }},
                                {"embree", [&](int) { static_cast<void>(raw.ask(questions)); }}};
  const std::vector<Times> times = in_turns(sides, {.most_seconds = seconds});
  const double our_rate = static_cast<double>(shot) / times[0].min_ms * 1e-3;
  const double raw_rate = static_cast<double>(count) / times[1].min_ms * 1e-3;
  report(key, fmt::format("ours {:.1f} M rays a second, Embree alone {:.1f}; of {} rays as many meet something", our_rate, raw_rate, count),
         sides, times);
  return 0;
}

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  using namespace lustro::bench;
  const std::string what = argc > 2 ? argv[1] : "";
  if (what != "rays" && what != "draw") {
    std::fprintf(stderr, "usage: bench_path rays SCENE [SECONDS], bench_path draw SCENE\n");
    return 2;
  }
  try {
    const lustro::Scene scene = loaded(argv[2]);
    return what == "draw" ? serve(scene) : compare_rates(scene, argc > 3 ? std::atof(argv[3]) : 20);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "bench_path: %s\n", e.what());
    return 1;
  }
}
