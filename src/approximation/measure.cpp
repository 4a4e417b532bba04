// Pictures in the order in which approximations are given up, and what each of them is worth.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "approximation/faceted.hpp"
#include "lustro/approximation.hpp"

namespace lustro {
namespace {

/// A picture, and half of the difference between the two that it is the mean of: its standard error, with luminances as they stand. Local
/// pictures have none.
struct Drawn {
  Image image;
  PictureError noise{};
};

PictureError halved(PictureError e) {
  return {e.rmse / 2, e.flip / 2, e.luminance / 2, std::abs(e.bias) / 2};
}

/// Errors that have nothing to do with each other.
PictureError together(const PictureError& a, const PictureError& b) {
  return {std::hypot(a.rmse, b.rmse), std::hypot(a.flip, b.flip), std::hypot(a.luminance, b.luminance), std::hypot(a.bias, b.bias)};
}

Image mean_of(Image a, const Image& b) {
  std::transform(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), a.pixels.begin(), [](float x, float y) { return (x + y) * 0.5F; });
  return a;
}

Image difference_of(Image a, const Image& b) {
  std::transform(a.pixels.begin(), a.pixels.end(), b.pixels.begin(), a.pixels.begin(), [](float x, float y) { return x - y; });
  return a;
}

Image opaque_rgb(const Image& layer) {
  Image image(layer.width, layer.height, 4);
  const auto step = static_cast<std::size_t>(layer.channels);
  for (std::size_t i = 0; i < image.pixels.size() / 4; ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      image.pixels[4 * i + c] = layer.pixels[step * i + c];
    }
    image.pixels[4 * i + 3] = 1;
  }
  return image;
}

bool is_black(const Image& image) {
  const auto step = static_cast<std::size_t>(image.channels);
  for (std::size_t i = 0; i < image.pixels.size(); i += step) {
    if (image.pixels[i] != 0 || image.pixels[i + 1] != 0 || image.pixels[i + 2] != 0) {
      return false;
    }
  }
  return true;
}

/// The scene with normals of its own on every triangle. Objects that share a mesh share the new one.
Result<Scene> faceted_scene(Scene scene) {
  std::map<const Mesh*, std::shared_ptr<const Mesh>> made;
  for (Object& object : scene.objects) {
    std::shared_ptr<const Mesh>& mesh = made[object.mesh.get()];
    if (mesh == nullptr) {
      Result<Mesh> apart = faceted(*object.mesh);
      if (!apart) {
        return tl::unexpected(std::move(apart).error());
      }
      mesh = std::make_shared<const Mesh>(*std::move(apart));
    }
    object.mesh = mesh;
  }
  return scene;
}

TermSet only(AovKind term) {
  return {.ambient = term == AovKind::ambient,
          .diffuse = term == AovKind::diffuse,
          .specular = term == AovKind::specular,
          .emission = term == AovKind::emission};
}

/// Draws, and counts on the way.
class Painter {
 public:
  Painter(const ApproximationOptions& options, int true_pictures, ApproximationReport& report)
      : options_(options), shares_(2 * true_pictures), report_(report) {}

  Result<Rendering> local(const Scene& scene, std::vector<Aov> aovs = {}) const {
    return render(scene, {.threads = options_.threads, .aovs = std::move(aovs)});
  }
  Result<Drawn> local_picture(const Scene& scene) const {
    return local(scene).map([](Rendering&& rendering) { return Drawn{std::move(rendering.color)}; });
  }

  /// bounces  1: direct light alone
  Result<Drawn> truth(const Scene& scene, int bounces) {
    std::array<Image, 2> halves;
    for (std::size_t i = 0; i < 2; ++i) {
      RenderOptions options{.threads = options_.threads, .aovs = {}, .engine = Engine::path, .path = options_.path};
      options.path.samples = options_.path.samples / 2;
      options.path.seconds = options_.path.seconds / shares_;
      options.path.seed = 2 * options_.path.seed + static_cast<std::uint32_t>(i);
      options.path.bounces = bounces;
      if (options_.progress) {
        options.progress = [&](double share) { options_.progress((done_ + share) / shares_); };
      }
      Result<Rendering> rendering = render(scene, options);
      if (!rendering) {
        return tl::unexpected(std::move(rendering).error());
      }
      done_ += 1;
      report_.rays += rendering->stats.rays;
      samples_ += rendering->stats.samples;
      halves[i] = std::move(rendering->color);
    }
    Drawn drawn;
    const Result<PictureError> noise = picture_error(halves[0], halves[1], 0, scene.image.transfer, scene.image.tone);
    if (!noise) {
      return tl::unexpected(noise.error());
    }
    drawn.noise = halved(*noise);
    drawn.image = mean_of(std::move(halves[0]), halves[1]);
    return drawn;
  }

  /// Since it was last asked.
  int samples() { return std::exchange(samples_, 0); }

 private:
  const ApproximationOptions& options_;
  double shares_;
  double done_ = 0;
  int samples_ = 0;
  ApproximationReport& report_;
};

/// What is compared with what.
class Judge {
 public:
  Judge(const Scene& scene, double luminance) : scene_(scene), luminance_(luminance) {}

  Result<PictureError> error(const Image& a, const Image& b) const {
    return picture_error(a, b, luminance_, scene_.image.transfer, scene_.image.tone);
  }
  /// With luminances over the truth's.
  PictureError noise(PictureError e) const {
    const double scale = luminance_ > 0 ? 1 / luminance_ : 1;
    e.luminance *= scale;
    e.bias *= scale;
    return e;
  }
  Result<void> add_cause(ApproximationCause cause, const Drawn& before, const Drawn& after, ApproximationReport& report) const {
    return error(before.image, after.image).map([&](const PictureError& e) {
      report.causes.push_back({cause, true, before.image, after.image, e, noise(together(before.noise, after.noise))});
    });
  }
  Result<void> add_term(AovKind term, const Image& local, Drawn&& truth, ApproximationReport& report) const {
    return error(local, truth.image).map([&](const PictureError& e) {
      report.terms.push_back({term, local, std::move(truth.image), e, noise(truth.noise)});
    });
  }

 private:
  const Scene& scene_;
  double luminance_;
};

}  // namespace

std::string_view cause_name(ApproximationCause cause) {
  constexpr std::array<std::string_view, kApproximationCauses> kNames{"interpolation", "mesh-normals", "ambient", "shadows", "interreflection"};
  return kNames[static_cast<std::size_t>(cause)];
}

std::string_view cause_text(ApproximationCause cause) {
  constexpr std::array<std::string_view, kApproximationCauses> kTexts{
      "light is found at faces or vertices, and not at every pixel", "normals are interpolated over flat triangles",
      "a constant stands for the light that comes from other surfaces", "lights shine through everything, and areas shine as points",
      "surfaces do not light each other, and mirrors and glass show nothing"};
  return kTexts[static_cast<std::size_t>(cause)];
}

Result<ApproximationReport> measure_approximations(const Scene& scene, const ApproximationOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.path.samples < 2) {
    return fail(ErrorKind::usage, "", fmt::format("{} samples: at least 2 are needed, to tell the noise", options.path.samples));
  }
  if (scene.ground) {
    Scene without = scene;
    without.ground.reset();
    auto measured = measure_approximations(without, options);
    if (measured) {
      measured->notes.push_back({"ground", "shows shadows and is no surface: it is left out of both pictures"});
    }
    return measured;
  }
  ApproximationReport report;
  constexpr std::array kTerms{AovKind::ambient, AovKind::diffuse, AovKind::specular, AovKind::emission};
  const bool is_local_at_pixels = scene.shading.interpolation == Interpolation::phong;

  Painter sketch(options, 1, report);
  Result<Rendering> local = sketch.local(scene, {{AovKind::ambient}, {AovKind::diffuse}, {AovKind::specular}, {AovKind::emission}});
  if (!local) {
    return tl::unexpected(std::move(local).error());
  }
  report.notes = std::move(local->notes);
  std::vector<std::pair<AovKind, Image>> layers;
  for (std::size_t i = 0; i < kTerms.size(); ++i) {
    if (!is_black(local->layers[i].image)) {
      layers.emplace_back(kTerms[i], opaque_rgb(local->layers[i].image));
    }
  }
  const bool has_ambient = !layers.empty() && layers.front().first == AovKind::ambient;
  const auto direct_terms = static_cast<int>(layers.size()) - (has_ambient ? 1 : 0);
  Painter painter(options, 2 + direct_terms, report);

  Scene at_pixels = scene;
  at_pixels.shading.interpolation = Interpolation::phong;
  Scene without_ambient = at_pixels;
  without_ambient.shading.terms.ambient = false;

  Result<Drawn> truth = painter.truth(at_pixels, options.path.bounces);
  if (!truth) {
    return tl::unexpected(truth.error());
  }
  report.samples = painter.samples();
  const Judge judge(scene, mean_luminance(truth->image));
  const Result<Drawn> direct = painter.truth(without_ambient, 1);
  const Result<Drawn> lit = painter.local_picture(at_pixels);
  const Result<Drawn> dark = painter.local_picture(without_ambient);
  const Result<Scene> facets = faceted_scene(at_pixels);
  const Result<Drawn> on_facets = facets ? painter.local_picture(*facets) : tl::unexpected(facets.error());
  for (const Result<Drawn>* drawn : {&direct, &lit, &dark, &on_facets}) {
    if (!*drawn) {
      return tl::unexpected(drawn->error());
    }
  }
  report.local = std::move(local->color);
  const Drawn stated{report.local};
  using Cause = ApproximationCause;
  const std::array<std::tuple<Cause, const Drawn*, const Drawn*, bool>, kApproximationCauses> steps{
      {{Cause::interpolation, &stated, &*lit, !is_local_at_pixels},
       {Cause::mesh_normals, &*lit, &*on_facets, scene.shading.interpolation != Interpolation::flat},
       {Cause::ambient, &*lit, &*dark, has_ambient},
       {Cause::shadows, &*dark, &*direct, true},
       {Cause::interreflection, &*direct, &*truth, true}}};
  for (const auto& [cause, before, after, applies] : steps) {
    if (!applies) {
      report.causes.push_back({cause, false, {}, {}, {}, {}});
    } else if (const Result<void> added = judge.add_cause(cause, *before, *after, report); !added) {
      return tl::unexpected(added.error());
    }
  }
  const Result<PictureError> error = judge.error(report.local, truth->image);
  if (!error) {
    return tl::unexpected(error.error());
  }
  report.error = *error;
  report.noise = judge.noise(truth->noise);

  for (const auto& [term, layer] : layers) {
    Drawn beside;
    if (term == AovKind::ambient) {  // what the truth has beyond direct light
      beside = {opaque_rgb(difference_of(truth->image, direct->image)), together(truth->noise, direct->noise)};
    } else {
      Scene alone = at_pixels;
      alone.shading.terms = only(term);
      alone.image.background = {{0, 0, 0}};
      if (alone.environment) {
        alone.environment->visible = false;
      }
      Result<Drawn> drawn = painter.truth(alone, 1);
      if (!drawn) {
        return tl::unexpected(std::move(drawn).error());
      }
      beside = *std::move(drawn);
      beside.image = opaque_rgb(beside.image);
    }
    if (const Result<void> added = judge.add_term(term, layer, std::move(beside), report); !added) {
      return tl::unexpected(added.error());
    }
  }
  report.truth = std::move(truth->image);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace lustro
