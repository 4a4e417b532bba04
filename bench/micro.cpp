// bench_micro: small parts by themselves (Google Benchmark; `--help` lists its flags). Each checks its answer before it is timed and skips with
// the reason where the answer is wrong.
#include <benchmark/benchmark.h>

#include <cmath>

#include "common/subjects.hpp"
#include "image/png.hpp"
#include "image/srgb.hpp"
#include "lustro/lustro.hpp"
#include "math/power.hpp"
#include "mesh/clusters.hpp"
#include "shade/lighting.hpp"

namespace lustro::bench {
namespace {

std::vector<float> between_0_and_1(std::size_t count) {
  std::vector<float> values;
  for (std::size_t i = 0; i < count; ++i) {
    values.push_back((static_cast<float>(i) + 0.5F) / static_cast<float>(count));
  }
  return values;
}

void count_items(benchmark::State& state, std::size_t items) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(items));
}

/// x^n of a thousand floats, scalar; compilers make lanes of it where they can.
void power_of_floats(benchmark::State& state, float n) {
  const std::vector<float> x = between_0_and_1(1024);
  std::vector<float> y(x.size());
  const auto work = [&] {
    for (std::size_t i = 0; i < x.size(); ++i) {
      y[i] = power(x[i], n);
    }
  };
  work();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double right = std::pow(static_cast<double>(x[i]), static_cast<double>(n));
    const double allowed = (6e-8 * static_cast<double>(n) + 1e-6 * (1 + std::abs(std::log2(right)))) * right + 2e-30;  // 0 below 2^-99
    if (std::abs(static_cast<double>(y[i]) - right) > allowed) {
      state.SkipWithError("power() is not x^n");
      return;
    }
  }
  for ([[maybe_unused]] auto _ : state) {
    work();
    benchmark::DoNotOptimize(y.data());
    benchmark::ClobberMemory();
  }
  count_items(state, x.size());
}
BENCHMARK_CAPTURE(power_of_floats, by_squaring, 24.0F);
BENCHMARK_CAPTURE(power_of_floats, by_logarithm, 24.5F);

/// The lighting equation, three lights, one point at a time.
void lighting_of_points(benchmark::State& state) {
  const Surface<float> ahead{{0, 0, -2}, {0, 0, 1}, {0, 0, 1}};
  const Coefficients<float> material{{0.1F, 0.1F, 0.1F}, {0.5F, 0.5F, 0.5F}, {0.4F, 0.4F, 0.4F}, {0, 0, 0}, 24};
  ShadingLight light;
  light.travel = {0, 0, -1};
  light.diffuse = light.specular = {0.25F, 0.25F, 0.25F};
  const std::vector<ShadingLight> lights(3, light);
  const auto lit = [&](const Surface<float>& s) {
    return light_surface(Lighting::phong, s, material, Vec3f{1, 1, 1}, lights, false, [](auto&&...) {}).sum();
  };
  if (std::abs(lit(ahead).x - (0.1F + 3 * 0.25F * (0.5F + 0.4F))) > 1e-6F) {  // light, eye and normal are one direction
    state.SkipWithError("the lighting equation is not what it is on paper");
    return;
  }
  std::vector<Surface<float>> surfaces;
  for (const float t : between_0_and_1(1024)) {
    surfaces.push_back({{t, 0, -2}, {0.6F * t, 0, std::sqrt(1 - 0.36F * t * t)}, {0, 0, 1}});
  }
  for ([[maybe_unused]] auto _ : state) {
    for (const Surface<float>& s : surfaces) {
      benchmark::DoNotOptimize(lit(s));
    }
  }
  count_items(state, surfaces.size());
}
BENCHMARK(lighting_of_points);

/// Bytes of 8-bit sRGB by the table; checked against the function that the table stands for.
void srgb_bytes(benchmark::State& state) {
  const std::vector<float> x = between_0_and_1(4096);
  std::vector<std::uint8_t> bytes(x.size());
  const SrgbTable& table = srgb_table();
  for (const float v : x) {
    if (srgb_byte(table, v) != quantize8(srgb_encode(v))) {
      state.SkipWithError("the table is not the function");
      return;
    }
  }
  for ([[maybe_unused]] auto _ : state) {
    for (std::size_t i = 0; i < x.size(); ++i) {
      bytes[i] = srgb_byte(table, x[i]);
    }
    benchmark::DoNotOptimize(bytes.data());
    benchmark::ClobberMemory();
  }
  count_items(state, x.size());
}
BENCHMARK(srgb_bytes);

/// The clusters of 70 k triangles, one thread; checked: every triangle is in one of them.
void make_clusters_of_70k(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(70'000);
  const Clusters clusters = make_clusters(mesh, ClusterUse::often, 1);
  std::vector<bool> seen(mesh.triangles.size(), false);
  std::size_t count = 0;
  for (const Cluster& c : clusters.clusters) {
    for (std::uint32_t t = 0; t < c.triangles; ++t) {
      const std::size_t triangle = clusters.triangles[c.first_triangle + t];
      count += triangle < seen.size() && !seen[triangle] ? 1U : 0U;
      seen.at(triangle) = true;
    }
  }
  if (count != mesh.triangles.size()) {
    state.SkipWithError("a triangle is in no cluster");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(make_clusters(mesh, ClusterUse::often, 1));
  }
  count_items(state, mesh.triangles.size());
}
BENCHMARK(make_clusters_of_70k)->Unit(benchmark::kMillisecond);

/// A whole covered picture by one row of kernels, one thread: the cost of a lit pixel. Checked: the bytes of the scalar row.
void lit_pixels(benchmark::State& state, Target target) {
  const Subject& subject = *find_subject("2k");
  Scene scene = common_scene(subject, 1);
  scene.image.width = 640;
  scene.image.height = 360;
  Renderer renderer;
  Rendering picture;
  RenderOptions options{.threads = 1, .target = Target::scalar, .store_color = false, .store_bytes = true};
  bool works = renderer.render(scene, options, picture).has_value();
  const std::vector<std::uint8_t> right = picture.bytes.pixels;
  options.target = target;
  works = works && renderer.render(scene, options, picture).has_value();
  if (!works || picture.bytes.pixels != right || picture.stats.pixels_covered != right.size() / 4) {
    state.SkipWithError("the row does not draw the scalar row's picture");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    (void)renderer.render(scene, options, picture);
  }
  count_items(state, right.size() / 4);
}

/// The common picture at 640 x 360 as a PNG, one thread; checked: it reads back as itself.
void png_of_a_picture(benchmark::State& state) {
  Scene scene = common_scene(*find_subject("5k"), 4);
  scene.image.width = 640;
  scene.image.height = 360;
  const Result<Rendering> picture = render(scene, {.store_bytes = true});
  const auto encoded = [&] { return encode_png(picture->bytes, {.transfer = Transfer::none, .threads = 1}); };
  const auto file = picture ? encoded() : fail(ErrorKind::empty, "", "no picture");
  const auto back = file ? decode_png(*file, "", Transfer::none) : fail(ErrorKind::empty, "", "no file");
  bool same = back.has_value() && back->channels == 3;
  for (std::size_t i = 0; same && i < back->pixels.size(); ++i) {
    same = quantize8(back->pixels[i]) == picture->bytes.pixels[i / 3 * 4 + i % 3];
  }
  if (!same) {
    state.SkipWithError("the file does not hold the picture");
    return;
  }
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(encoded());
  }
  count_items(state, picture->bytes.pixels.size() / 4);
}
BENCHMARK(png_of_a_picture)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace lustro::bench

int main(int argc, char** argv) {
  for (const lustro::Target target : lustro::available_targets()) {
    benchmark::RegisterBenchmark(("lit_pixels/" + std::string(lustro::target_name(target))).c_str(), lustro::bench::lit_pixels, target)
        ->Unit(benchmark::kMillisecond);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
