// Layers by name.
#include "reference/aov.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>

namespace lustro {
namespace {

struct Row {
  AovKind kind;
  std::string_view name;
  std::array<std::string_view, 3> channels;
};
constexpr std::array kRows{
    Row{AovKind::ambient, "ambient", {"R", "G", "B"}},   Row{AovKind::diffuse, "diffuse", {"R", "G", "B"}},
    Row{AovKind::specular, "specular", {"R", "G", "B"}}, Row{AovKind::emission, "emission", {"R", "G", "B"}},
    Row{AovKind::fog, "fog", {"R", "G", "B"}},           Row{AovKind::background, "background", {"R", "G", "B"}},
    Row{AovKind::light, "light", {"R", "G", "B"}},       Row{AovKind::scene, "scene", {"R", "G", "B"}},
    Row{AovKind::depth, "depth", {"Z", "", ""}},         Row{AovKind::normal, "normal", {"X", "Y", "Z"}},
    Row{AovKind::position, "position", {"X", "Y", "Z"}}, Row{AovKind::albedo, "albedo", {"R", "G", "B"}},
    Row{AovKind::object, "object", {"ID", "", ""}},      Row{AovKind::material, "material", {"ID", "", ""}},
    Row{AovKind::triangle, "triangle", {"ID", "", ""}},  Row{AovKind::barycentrics, "barycentrics", {"U", "V", "W"}},
    Row{AovKind::mask, "mask", {"A", "", ""}},           Row{AovKind::variance, "variance", {"R", "G", "B"}},
};
constexpr auto kNames = [] {
  std::array<std::string_view, kRows.size()> names;
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    names[i] = kRows[i].name;
  }
  return names;
}();

const Row& row_of(AovKind kind) {
  return *std::find_if(kRows.begin(), kRows.end(), [kind](const Row& row) { return row.kind == kind; });
}

Result<Aov> parse_aov(std::string_view word) {
  const std::string_view name = word.substr(0, word.find(':'));
  const auto row = std::find_if(kRows.begin(), kRows.end(), [name](const Row& r) { return r.name == name; });
  if (row == kRows.end()) {
    return fail(ErrorKind::usage, "", fmt::format("\"{}\" is no layer; known are {}", word, fmt::join(kNames, ", ")));
  }
  Aov aov{row->kind, -1};
  if (name.size() == word.size()) {
    return aov;
  }
  const std::string_view number = word.substr(name.size() + 1);
  if (aov.kind == AovKind::light && number == "*") {
    return aov;
  }
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), aov.light);
  if (aov.kind != AovKind::light || error != std::errc{} || end != number.data() + number.size() || aov.light < 0) {
    return fail(ErrorKind::usage, "", fmt::format("\"{}\" is no layer; a number follows only light, as in light:0 or light:*", word));
  }
  return aov;
}

}  // namespace

Result<std::vector<Aov>> parse_aovs(std::string_view list) {
  std::vector<Aov> aovs;
  while (!list.empty()) {
    const std::size_t comma = list.find(',');
    auto aov = parse_aov(list.substr(0, comma));
    if (!aov) {
      return tl::unexpected(aov.error());
    }
    aovs.push_back(*aov);
    list = comma == std::string_view::npos ? std::string_view{} : list.substr(comma + 1);
  }
  if (aovs.empty()) {
    return fail(ErrorKind::usage, "", fmt::format("no layer is named; known are {}", fmt::join(kNames, ", ")));
  }
  return aovs;
}

std::span<const std::string_view> aov_names() {
  return kNames;
}

Result<std::vector<Aov>> unfold_aovs(std::span<const Aov> aovs, const PreparedScene& scene) {
  const int lights = static_cast<int>(scene.lights.size());
  std::vector<Aov> result;
  for (const Aov& aov : aovs) {
    if (aov.kind == AovKind::light && aov.light < 0) {
      for (int i = 0; i < lights; ++i) {
        result.push_back({AovKind::light, i});
      }
    } else if (aov.kind == AovKind::light && aov.light >= lights) {
      return fail(ErrorKind::usage, "", fmt::format("light:{} does not exist; the scene has {} lights, counted from 0", aov.light, lights));
    } else {
      result.push_back(aov);
    }
  }
  return result;
}

Layer make_layer(const Aov& aov, const PreparedScene& scene) {
  const Row& row = row_of(aov.kind);
  Layer layer;
  layer.name = aov.kind == AovKind::light ? fmt::format("light:{}", aov.light) : std::string(row.name);
  for (const std::string_view channel : row.channels) {
    if (!channel.empty()) {
      layer.channels.emplace_back(channel);
    }
  }
  layer.image = Image(scene.view.width, scene.view.height, static_cast<int>(layer.channels.size()));
  if (aov.kind == AovKind::object) {
    layer.labels = scene.object_names;
  } else if (aov.kind == AovKind::material) {
    for (const ShadingMaterial& material : scene.materials) {
      layer.labels.push_back(material.stated.name);
    }
  }
  return layer;
}

void store_aov(const Aov& aov, const PreparedScene& scene, const Pixel& pixel, std::span<float> out) {
  const bool covered = pixel.coverage > 0;
  const auto store = [&out](const Vec3f& v) {
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
  };
  const auto id = [covered](std::uint32_t value) { return covered ? static_cast<float>(value) : -1.0F; };
  const Fragment& f = pixel.dominant;
  switch (aov.kind) {
    case AovKind::ambient:
      store(pixel.terms.ambient);
      break;
    case AovKind::diffuse:
      store(pixel.terms.diffuse);
      break;
    case AovKind::specular:
      store(pixel.terms.specular);
      break;
    case AovKind::emission:
      store(pixel.terms.emission);
      break;
    case AovKind::fog:
      store(pixel.fog);
      break;
    case AovKind::background:
      store(pixel.background);
      break;
    case AovKind::light:
      store(pixel.light_parts[static_cast<std::size_t>(aov.light)]);
      break;
    case AovKind::scene:
      store(pixel.scene_part);
      break;
    case AovKind::depth:
      out[0] = covered ? f.depth : std::numeric_limits<float>::infinity();
      break;
    case AovKind::normal:
      store(f.normal);
      break;
    case AovKind::position:
      store(covered ? vec_cast<float>(vec_cast<double>(f.position) + scene.view.eye) : Vec3f{});
      break;
    case AovKind::albedo:
      store(pixel.albedo);
      break;
    case AovKind::object:
      out[0] = id(scene.instances[f.instance].object);
      break;
    case AovKind::material:
      out[0] = id(f.material);
      break;
    case AovKind::triangle:
      out[0] = id(f.triangle);
      break;
    case AovKind::barycentrics:
      store(f.weights);
      break;
    case AovKind::mask:
      out[0] = pixel.coverage;
      break;
    case AovKind::variance:  // of a picture without noise
      store({});
      break;
  }
}

}  // namespace lustro
