// See check_scene.hpp. Single values are checked against the table of options, by its readers.
#include "scene/check_scene.hpp"

#include <fmt/format.h>

#include <cmath>

#include "scene/json_path.hpp"
#include "scene/text_values.hpp"
#include "scene/words.hpp"

namespace lustro {
namespace {

constexpr double kShortestDirection = 1e-30;
constexpr double kSmallestSine = 1e-6;  // of the angle between up and the view direction

tl::unexpected<Error> broken(const JsonPath& path, std::string message) {
  return fail(ErrorKind::malformed, path.text(), std::move(message));
}

std::string text_of(const Vec3d& v) {
  return fmt::format("[{}, {}, {}]", number_text(v.x), number_text(v.y), number_text(v.z));
}

Result<void> check_direction(const Vec3d& direction, const JsonPath& path) {
  if (!(length(direction) > kShortestDirection)) {
    return broken(path, fmt::format("{} has no direction, expected a vector that is not 0", text_of(direction)));
  }
  return {};
}

Result<void> check_camera(const Camera& camera, const JsonPath& path) {
  if (camera.near && camera.projection == Projection::perspective && *camera.near <= 0) {
    return broken(path / "near", fmt::format("{} is not more than 0, as a perspective camera needs", number_text(*camera.near)));
  }
  if (camera.near && camera.far && !(*camera.near < *camera.far)) {
    return broken(path / "near", fmt::format("{} is not less than far, {}", number_text(*camera.near), number_text(*camera.far)));
  }
  if (camera.up) {
    if (auto done = check_direction(*camera.up, path / "up"); !done) {
      return done;
    }
  }
  if (!camera.eye || !camera.target) {
    return {};
  }
  const Vec3d view = *camera.target - *camera.eye;
  if (!(length(view) > kShortestDirection)) {
    return broken(path / "target", fmt::format("{} is where the eye stands, expected another place", text_of(*camera.target)));
  }
  if (camera.up && length(cross(normalize(view), normalize(*camera.up))) < kSmallestSine) {
    return broken(path / "up", fmt::format("{} lies along the view from eye to target, expected another direction", text_of(*camera.up)));
  }
  return {};
}

bool has_direction(LightType type) {
  return type != LightType::point && type != LightType::sphere;
}

Result<void> check_light(const Light& light, const JsonPath& path) {
  if (has_direction(light.type)) {
    if (auto done = check_direction(light.direction, path / "direction"); !done) {
      return done;
    }
  }
  if (light.type == LightType::rectangle && light.x_axis) {
    if (auto done = check_direction(*light.x_axis, path / "x_axis"); !done) {
      return done;
    }
    if (length(cross(normalize(*light.x_axis), normalize(light.direction))) < kSmallestSine) {
      return broken(path / "x_axis", fmt::format("{} lies along direction, expected another way", text_of(*light.x_axis)));
    }
  }
  if (light.beam && !(*light.beam < light.cutoff)) {
    return broken(path / "beam", fmt::format("{} is not less than cutoff, {}", number_text(*light.beam), number_text(light.cutoff)));
  }
  const Attenuation& a = light.attenuation;
  if (!a.falloff && a.constant == 0 && a.linear == 0 && a.quadratic == 0) {
    return broken(path / "attenuation", "constant, linear and quadratic are all 0, expected one that is not");
  }
  return {};
}

Result<void> check_fog(const Fog& fog, const JsonPath& path) {
  if (fog.mode == FogMode::linear && !(fog.start < fog.end)) {
    return broken(path / "end", fmt::format("{} is not more than start, {}", number_text(fog.end), number_text(fog.start)));
  }
  return {};
}

Result<void> check_matrix(const Mat4& matrix, const JsonPath& path) {
  if (matrix(3, 0) != 0 || matrix(3, 1) != 0 || matrix(3, 2) != 0 || matrix(3, 3) != 1) {
    return broken(path, fmt::format("its last row is {}, {}, {}, {}, expected 0, 0, 0, 1 (a row-major matrix moves by its fourth column)",
                                    number_text(matrix(3, 0)), number_text(matrix(3, 1)), number_text(matrix(3, 2)), number_text(matrix(3, 3))));
  }
  return {};
}

bool differs(const Attenuation& a) {
  return a.constant != 1 || a.linear != 0 || a.quadratic != 0 || a.falloff || a.unclamped || a.range;
}

}  // namespace

Result<void> check_scene(const Scene& scene) {
  const JsonPath root;
  if (auto done = check_camera(scene.camera, root / "camera"); !done) {
    return done;
  }
  const JsonPath lights = root / "lights";
  for (std::size_t i = 0; scene.lights && i < scene.lights->size(); ++i) {
    if (auto done = check_light((*scene.lights)[i], lights[i]); !done) {
      return done;
    }
  }
  if (scene.fog) {
    if (auto done = check_fog(*scene.fog, root / "fog"); !done) {
      return done;
    }
  }
  const JsonPath objects = root / "objects";
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const JsonPath object = objects[i];
    if (auto done = check_matrix(scene.objects[i].matrix, object / "matrix"); !done) {
      return done;
    }
  }
  return {};
}

Notes unused_keys(const Scene& scene) {
  Notes notes;
  const auto unused = [&](const JsonPath& path, std::string_view with) {
    notes.push_back({path.text(), fmt::format("changes nothing with {}", with)});
  };
  const JsonPath root;
  const JsonPath camera = root / "camera";
  if (scene.camera.height && scene.camera.projection == Projection::perspective) {
    unused(camera / "height", "a perspective camera");
  }
  if (scene.camera.fov != Camera{}.fov && scene.camera.projection == Projection::orthographic) {
    unused(camera / "fov", "an orthographic camera");
  }
  const JsonPath lights = root / "lights";
  const Light standard;
  for (std::size_t i = 0; scene.lights && i < scene.lights->size(); ++i) {
    const Light& light = (*scene.lights)[i];
    const JsonPath path = lights[i];
    const std::string with = fmt::format("a {} light", word_of(light.type));
    if (light.type == LightType::directional && light.position != standard.position) {
      unused(path / "position", with);
    }
    if (!has_direction(light.type) && light.direction != standard.direction) {
      unused(path / "direction", with);
    }
    if ((light.type == LightType::directional || is_area(light.type)) && differs(light.attenuation)) {
      unused(path / "attenuation", with);
    }
    if (light.type != LightType::spot && light.cutoff != standard.cutoff) {
      unused(path / "cutoff", with);
    }
    if (light.type != LightType::spot && light.beam) {
      unused(path / "beam", with);
    }
    if (light.fade != standard.fade && (light.type != LightType::spot || !light.beam)) {
      unused(path / "fade", light.type == LightType::spot ? "a spot light that has no beam" : with);
    }
    if (light.type != LightType::spot && light.exponent != standard.exponent) {
      unused(path / "exponent", with);
    }
    if (light.type != LightType::rectangle && light.size != standard.size) {
      unused(path / "size", with);
    }
    if (light.type != LightType::rectangle && light.x_axis) {
      unused(path / "x_axis", with);
    }
    if (light.type != LightType::disk && light.type != LightType::sphere && light.radius != standard.radius) {
      unused(path / "radius", with);
    }
  }
  return notes;
}

}  // namespace lustro
