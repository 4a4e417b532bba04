// See gltf_pose.hpp. Interpolation by appendix C of the specification, in double, without libm.
#include "io/gltf_pose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "io/gltf_accessor.hpp"
#include "math/trig.hpp"
#include "scene/nearest.hpp"

namespace lustro {
namespace {

using Path = GltfChannel::Path;
using Interpolation = GltfChannel::Interpolation;

/// Between which keys a moment lies: the earlier key and the share of the way to the next.
struct Moment {
  std::size_t key = 0;
  double share = 0;
  double span = 0;  ///< seconds between the two keys; 0 on or outside the ends
};

Result<Moment> moment_of(const GltfFile& file, std::uint32_t accessor, const std::vector<float>& keys, double time) {
  for (std::size_t k = 1; k < keys.size(); ++k) {
    if (!(keys[k] > keys[k - 1])) {
      return file.fail_at(fmt::format("accessors[{}]", accessor),
                          fmt::format("key {} of an animation is at {} s, and the one before at {} s: they must rise", k, keys[k], keys[k - 1]));
    }
  }
  if (!std::isfinite(keys.front()) || !std::isfinite(keys.back())) {
    return file.fail_at(fmt::format("accessors[{}]", accessor), "a key of an animation is not finite");
  }
  const auto after = std::upper_bound(keys.begin(), keys.end(), time, [](double t, float key) { return t < static_cast<double>(key); });
  Moment moment;
  if (after == keys.begin()) {
    return moment;
  }
  moment.key = static_cast<std::size_t>(after - keys.begin()) - 1;
  if (after != keys.end()) {
    const auto begin = static_cast<double>(keys[moment.key]);
    moment.span = static_cast<double>(*after) - begin;
    moment.share = (time - begin) / moment.span;
  }
  return moment;
}

double dot4(const double* a, const double* b) {
  return ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]) + a[3] * b[3];
}

/// The shorter way round (Shoemake 1985); nearly equal quaternions by a straight line.
std::vector<double> slerp(const double* a, const double* b, double share) {
  const double cosine_between = dot4(a, b);
  const double sign = cosine_between < 0 ? -1 : 1;
  double weight_a = 1 - share;
  double weight_b = share;
  if (const double angle = arccosine(std::abs(cosine_between)); angle > 1e-4) {
    weight_a = sine((1 - share) * angle) / sine(angle);
    weight_b = sine(share * angle) / sine(angle);
  }
  std::vector<double> result(4);
  for (std::size_t i = 0; i < 4; ++i) {
    result[i] = weight_a * a[i] + sign * weight_b * b[i];
  }
  return result;
}

/// The value of a channel at a time, `width` numbers.
Result<std::vector<double>> value_at(GltfFile& file, const GltfChannel& channel, std::size_t width, double time) {
  const Result<std::vector<float>> keys = read_floats(file, channel.input);
  if (!keys) {
    return tl::unexpected(keys.error());
  }
  const Result<Moment> moment = moment_of(file, channel.input, *keys, time);
  if (!moment) {
    return tl::unexpected(moment.error());
  }
  const Result<std::vector<float>> read = read_floats(file, channel.output);
  if (!read) {
    return tl::unexpected(read.error());
  }
  const std::vector<double> values(read->begin(), read->end());
  const bool is_cubic = channel.interpolation == Interpolation::cubic;
  const auto value = [&](std::size_t key, std::size_t part) { return values.data() + (is_cubic ? 3 * key + part : key) * width; };
  const double* from = value(moment->key, 1);
  if (moment->span == 0 || channel.interpolation == Interpolation::step) {
    return std::vector<double>(from, from + width);
  }
  const double* to = value(moment->key + 1, 1);
  const double t = moment->share;
  if (channel.interpolation == Interpolation::linear && channel.path == Path::rotation) {
    return slerp(from, to, t);
  }
  std::vector<double> result(width);
  for (std::size_t i = 0; i < width; ++i) {
    if (!is_cubic) {
      result[i] = from[i] + (to[i] - from[i]) * t;
      continue;
    }
    const double t2 = t * t;
    const double t3 = t2 * t;
    const double leaving = value(moment->key, 2)[i] * moment->span;
    const double arriving = value(moment->key + 1, 0)[i] * moment->span;
    result[i] = (((2 * t3 - 3 * t2 + 1) * from[i] + (t3 - 2 * t2 + t) * leaving) + (3 * t2 - 2 * t3) * to[i]) + (t3 - t2) * arriving;
  }
  return result;
}

template <std::size_t N>
void assign(std::array<double, N>& to, const std::vector<double>& from) {
  std::copy_n(from.begin(), N, to.begin());
}

Result<void> animate(GltfFile& file, const GltfAnimation& animation, double time, std::vector<GltfNode>& nodes) {
  for (const GltfChannel& channel : animation.channels) {
    GltfNode& node = nodes[channel.node];
    const std::size_t width = channel.path == Path::rotation  ? 4
                              : channel.path == Path::weights ? file.document.meshes[node.mesh].primitives.front().targets.size()
                                                              : 3;
    const Result<std::vector<double>> value = value_at(file, channel, width, time);
    if (!value) {
      return tl::unexpected(value.error());
    }
    switch (channel.path) {
      case Path::translation:
        assign(node.translation, *value);
        break;
      case Path::rotation:
        assign(node.rotation, *value);
        break;
      case Path::scale:
        assign(node.scale, *value);
        break;
      case Path::weights:
        node.weights = *value;
    }
  }
  return {};
}

std::vector<std::string> animation_names(const GltfFile& file) {
  std::vector<std::string> names;
  for (const GltfAnimation& animation : file.document.animations) {
    names.push_back(animation.name);
  }
  return names;
}

}  // namespace

std::optional<std::size_t> find_named(const std::vector<std::string>& names, const std::string& wanted) {
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  if (error == std::errc() && end == wanted.data() + wanted.size() && index < names.size()) {
    return index;
  }
  const auto found = std::find(names.begin(), names.end(), wanted);
  return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  constexpr std::size_t kMost = 20;
  for (std::size_t i = 0; i < std::min(names.size(), kMost); ++i) {
    text += fmt::format("{}{}{}", text.empty() ? "" : ", ", i, names[i].empty() ? std::string() : " " + quote(names[i]));
  }
  return names.size() > kMost ? text + ", ..." : text;
}

Mat4 matrix_of(const std::array<double, 3>& translation, const std::array<double, 4>& rotation, const std::array<double, 3>& scale) {
  const double size = std::sqrt(dot4(rotation.data(), rotation.data()));
  const double x = rotation[0] / size;
  const double y = rotation[1] / size;
  const double z = rotation[2] / size;
  const double w = rotation[3] / size;
  Mat4 m;
  m(0, 0) = (1 - 2 * (y * y + z * z)) * scale[0];
  m(1, 0) = 2 * (x * y + z * w) * scale[0];
  m(2, 0) = 2 * (x * z - y * w) * scale[0];
  m(0, 1) = 2 * (x * y - z * w) * scale[1];
  m(1, 1) = (1 - 2 * (x * x + z * z)) * scale[1];
  m(2, 1) = 2 * (y * z + x * w) * scale[1];
  m(0, 2) = 2 * (x * z + y * w) * scale[2];
  m(1, 2) = 2 * (y * z - x * w) * scale[2];
  m(2, 2) = (1 - 2 * (x * x + y * y)) * scale[2];
  for (int row = 0; row < 3; ++row) {
    m(row, 3) = translation[static_cast<std::size_t>(row)];
  }
  return m;
}

Result<double> duration_of(GltfFile& file, const GltfAnimation& animation) {
  double last = 0;
  for (const GltfChannel& channel : animation.channels) {
    const Result<std::vector<float>> keys = read_floats(file, channel.input);
    if (!keys) {
      return tl::unexpected(keys.error());
    }
    last = std::max(last, static_cast<double>(keys->back()));
  }
  return last;
}

Result<GltfPose> pose_of(GltfFile& file, const std::optional<double>& time, const std::string& animation) {
  std::vector<GltfNode> nodes = file.document.nodes;
  if (!animation.empty() || time) {
    const std::vector<std::string> names = animation_names(file);
    const std::optional<std::size_t> chosen = find_named(names, animation.empty() ? "0" : animation);
    if (!chosen && !animation.empty()) {
      return fail(ErrorKind::usage, file.name,
                  names.empty() ? fmt::format("has no animation {}: it has none at all", quote(animation))
                                : fmt::format("has no animation {}, only {}", quote(animation), listed(names)));
    }
    if (!chosen) {
      file.document.notes.push_back({{}, "has no animation: the time changes nothing"});
    } else if (const Result<void> done = animate(file, file.document.animations[*chosen], time.value_or(0), nodes); !done) {
      return tl::unexpected(done.error());
    }
  }
  GltfPose pose;
  pose.world.resize(nodes.size());
  pose.weights.resize(nodes.size());
  for (const std::uint32_t i : file.document.order) {
    const GltfNode& node = nodes[i];
    const Mat4 local = node.matrix ? *node.matrix : matrix_of(node.translation, node.rotation, node.scale);
    const std::uint32_t parent = file.document.parents[i];
    pose.world[i] = parent == kGltfNone ? local : pose.world[parent] * local;
    if (!std::all_of(pose.world[i].m.begin(), pose.world[i].m.end(), [](double x) { return std::abs(x) < 3.4e38; })) {
      return file.fail_at(fmt::format("nodes[{}]", i), "its place in the world is not finite");
    }
    if (node.mesh != kGltfNone) {
      pose.weights[i] = node.weights.empty() ? file.document.meshes[node.mesh].weights : node.weights;
    }
  }
  return pose;
}

}  // namespace lustro
