// Interpolation, lighting, fog and transfer in double precision. Where the text of the scene file's contract leaves room, a comment marked
// "reading" says which meaning is taken.
#include "truth/evaluate.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "texture/sampler_oracle.hpp"

namespace lustro::truth {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vec3d unit(const Vec3d& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? v * (1 / size) : v;
}

double cosine(double degrees) {
  return std::cos(degrees * kPi / 180);
}

/// IEC 61966-2-1
double decoded(double stored_value) {
  return stored_value <= 0.04045 ? stored_value / 12.92 : std::pow((stored_value + 0.055) / 1.055, 2.4);
}

Vec3d linear(const Vec3f& rgb, bool is_encoded) {
  const Vec3d c = vec_cast<double>(rgb);
  return is_encoded ? Vec3d{decoded(c.x), decoded(c.y), decoded(c.z)} : c;
}

/// The material's coefficients at a point, terms that are switched off left out.
struct Coefficients {
  Vec3d ambient, diffuse, specular, emission;
  double shininess = 0;
  Lighting lighting = Lighting::phong;
};

class Judge {
 public:
  Judge(const Scene& scene, const World& world, double x, double y, const Hit& hit)
      : scene_(scene), world_(world), x_(x), y_(y), hit_(hit), placed_(world.object(hit.object)), front_(world.is_front(x, y, hit)) {
    const auto& triangle = placed_.mesh->triangles[static_cast<std::size_t>(hit.triangle)];
    std::copy(triangle.begin(), triangle.end(), corners_.begin());
  }

  [[nodiscard]] Seen seen() const {
    Seen result;
    result.position = mix([&](std::size_t i) { return placed_.positions[corners_[i]]; }, hit_.weights);
    switch (scene_.shading.interpolation) {
      case Interpolation::flat:
        result.normal = faced(placed_.face_normals[static_cast<std::size_t>(hit_.triangle)]);
        // reading: the face has one colour, so its vertices' colours are averaged, as its centre averages their positions
        result.color = light(mix([&](std::size_t i) { return placed_.positions[corners_[i]]; }, kCenter), result.normal, coefficients(kCenter));
        break;
      case Interpolation::gouraud:
        result.color = mix(
            [&](std::size_t i) {
              std::array<double, 3> corner{};
              corner[i] = 1;
              const Vec3d c = light(placed_.positions[corners_[i]], faced(placed_.normals[corners_[i]]), coefficients(corner));
              return Vec3d{std::clamp(c.x, 0.0, 1.0), std::clamp(c.y, 0.0, 1.0), std::clamp(c.z, 0.0, 1.0)};
            },
            hit_.weights);
        break;
      case Interpolation::phong:
        result.normal = faced(interpolated_normal());
        result.color = light(result.position, result.normal, coefficients(hit_.weights));
        break;
    }
    result.color = fogged(result.color, length(result.position - world_.eye()));
    return result;
  }

 private:
  static constexpr std::array<double, 3> kCenter{1.0 / 3, 1.0 / 3, 1.0 / 3};

  static Vec3d mix(const std::function<Vec3d(std::size_t)>& at, const std::array<double, 3>& weights) {
    return at(0) * weights[0] + at(1) * weights[1] + at(2) * weights[2];
  }

  [[nodiscard]] Vec3d faced(const Vec3d& normal) const { return scene_.shading.two_sided && !front_ ? normal * -1.0 : normal; }

  [[nodiscard]] Vec3d in_light(const Color& color) const { return light_of(color, scene_.image.transfer); }

  /// reading: normals are unit at the vertices, in world space, before they are interpolated.
  [[nodiscard]] Vec3d interpolated_normal() const {
    const auto normal = [&](std::size_t i) { return placed_.normals[corners_[i]]; };
    Vec3d n = unit(mix(normal, hit_.weights));
    if (scene_.shading.normals == NormalInterpolation::lerp) {
      return n;
    }
    // The spherical weighted average: the point whose tangent vectors to the three normals, weighted, cancel (Buss and Fillmore 2001).
    for (int step = 0; step < 200; ++step) {
      const Vec3d pull = mix(
          [&](std::size_t i) {
            const Vec3d across = normal(i) - n * dot(normal(i), n);
            const double sine = std::sqrt(dot(across, across));
            return sine > 0 ? across * (std::atan2(sine, dot(normal(i), n)) / sine) : Vec3d{};
          },
          hit_.weights);
      const double angle = std::sqrt(dot(pull, pull));
      if (angle < 1e-15) {
        break;
      }
      n = unit(n * std::cos(angle) + pull * (std::sin(angle) / angle));
    }
    return n;
  }

  [[nodiscard]] Coefficients coefficients(const std::array<double, 3>& weights) const {
    const Object& object = scene_.objects[static_cast<std::size_t>(hit_.object)];
    const Mesh& mesh = *placed_.mesh;
    Material material;
    if (object.material) {
      material = *object.material;
    } else if (!mesh.materials.empty()) {
      material = mesh.materials[mesh.triangle_material.empty() ? 0 : mesh.triangle_material[static_cast<std::size_t>(hit_.triangle)]];
    }
    Vec3d vertex_color{1, 1, 1};
    if (!mesh.colors.empty()) {  // reading: colours become light before they are interpolated
      vertex_color = mix([&](std::size_t i) { return linear(mesh.colors[corners_[i]], scene_.image.transfer == Transfer::srgb); }, weights);
    }
    const TermSet& terms = scene_.shading.terms;
    const Lighting lighting = material.lighting.value_or(scene_.shading.lighting);
    const Vec3d black{};
    Coefficients k{.ambient = terms.ambient ? in_light(material.ambient) * vertex_color : black,
                   .diffuse = terms.diffuse ? in_light(material.diffuse) * vertex_color : black,
                   .specular = terms.specular || lighting == Lighting::ggx ? in_light(material.specular) : black,
                   .emission = terms.emission ? in_light(material.emission) : black,
                   .shininess = static_cast<double>(material.shininess),
                   .lighting = lighting};
    apply_maps(material.textures, k);
    return k;
  }

  /// What a map says at the point: texel * gain + base of the colours, and the alpha; nothing where it leaves the material as it is.
  [[nodiscard]] std::optional<Rgba> value(const TextureUse& use) const {
    const Mesh& mesh = *placed_.mesh;
    const auto coordinates = [&](double dx, double dy) {
      const Hit at = world_.cast_at(x_ + dx, y_ + dy, hit_.object, hit_.triangle);
      const Vec3d uv = mix(
          [&](std::size_t i) {
            const Vec2f stated = (use.uv_set == 0 ? mesh.uvs : mesh.uvs1)[corners_[i]];
            return Vec3d{static_cast<double>(stated.x), static_cast<double>(stated.y), 0};
          },
          at.weights);
      const auto m = [&](std::size_t i) { return static_cast<double>(use.uv_matrix[i]); };
      return std::array{m(0) * uv.x + m(1) * uv.y + m(2), m(3) * uv.x + m(4) * uv.y + m(5)};
    };
    constexpr double kStep = 1e-3;  // pixels, for central differences
    const auto [u, v] = coordinates(0, 0);
    const auto [left_u, left_v] = coordinates(-kStep, 0);
    const auto [right_u, right_v] = coordinates(kStep, 0);
    const auto [upper_u, upper_v] = coordinates(0, -kStep);
    const auto [lower_u, lower_v] = coordinates(0, kStep);
    if (use.leaves_outside && (u < 0 || u > 1 || v < 0 || v > 1)) {
      return {};
    }
    constexpr double kPixel = 0.5 / kStep;
    Rgba texel = SamplerOracle(*use.texture, use.sampler)
                     .sample({u, v, (right_u - left_u) * kPixel, (right_v - left_v) * kPixel, (lower_u - upper_u) * kPixel,
                              (lower_v - upper_v) * kPixel});
    const Vec3d gain = vec_cast<double>(use.gain);
    const Vec3d base = vec_cast<double>(use.base);
    return Rgba{texel[0] * gain.x + base.x, texel[1] * gain.y + base.y, texel[2] * gain.z + base.z, texel[3]};
  }

  void apply_maps(const MaterialTextures& maps, Coefficients& k) const {
    const auto multiply = [&](const std::optional<TextureUse>& use, Vec3d& color) {
      if (const std::optional<Rgba> factor = use ? value(*use) : std::nullopt) {
        color = color * Vec3d{(*factor)[0], (*factor)[1], (*factor)[2]};
      }
    };
    multiply(maps.ambient, k.ambient);
    multiply(maps.diffuse, k.diffuse);
    multiply(maps.specular, k.specular);
    multiply(maps.emission, k.emission);
    if (const std::optional<Rgba> factor = maps.shininess ? value(*maps.shininess) : std::nullopt) {
      const Rgba& f = *factor;
      const double one = maps.shininess->channel < 3 ? f[maps.shininess->channel] : 0.2126 * f[0] + 0.7152 * f[1] + 0.0722 * f[2];
      k.shininess = std::clamp(k.shininess * one, 0.0, 10000.0);
    }
    if (const std::optional<Rgba> decal = maps.decal ? value(*maps.decal) : std::nullopt) {
      const auto lay_over = [&](Vec3d& color) { color = color + (Vec3d{(*decal)[0], (*decal)[1], (*decal)[2]} - color) * (*decal)[3]; };
      if (scene_.shading.terms.ambient) {
        lay_over(k.ambient);
      }
      if (scene_.shading.terms.diffuse) {
        lay_over(k.diffuse);
      }
    }
  }

  /// I = k_e + k_a I_a + sum_i f_i s_i [ k_a l_a + k_d l_d max(N.L, 0) + k_s l_s spec ]
  [[nodiscard]] Vec3d light(const Vec3d& point, const Vec3d& normal, const Coefficients& k) const {
    if (k.lighting == Lighting::constant) {
      return k.diffuse;  // reading: it counts as the diffuse term, and is black without it
    }
    const bool is_flat_view = scene_.camera.projection == Projection::orthographic;
    const Vec3d to_eye = is_flat_view ? world_.forward() * -1.0 : unit(world_.eye() - point);
    Vec3d sum = k.emission + k.ambient * in_light(scene_.ambient);
    for (const Light& light : *scene_.lights) {
      const bool is_directional = light.type == LightType::directional;
      const Vec3d to_light = unit(is_directional ? light.direction * -1.0 : light.position - point);
      const double strength = is_directional ? 1 : attenuation(light.attenuation, length(light.position - point)) * spot(light, to_light);
      const double n_dot_l = dot(normal, to_light);
      Vec3d part = k.ambient * in_light(light.ambient) + k.diffuse * in_light(light.diffuse) * std::max(n_dot_l, 0.0);
      if (k.lighting == Lighting::ggx) {
        part = k.ambient * in_light(light.ambient) + microfacets(k, light, normal, to_light, to_eye);
      } else if (n_dot_l > 0) {
        part = part + k.specular * in_light(light.specular) * highlight(k, normal, to_light, to_eye, n_dot_l);
      }
      sum = sum + part * strength;
    }
    return sum;
  }

  /// glTF 2.0, appendix B.2.3 and B.3, times pi; the metallic mix is stated by the coefficients. The specular term's switch takes l_s alone.
  [[nodiscard]] Vec3d microfacets(const Coefficients& k, const Light& light, const Vec3d& n, const Vec3d& l, const Vec3d& v) const {
    const double n_dot_l = dot(n, l);
    if (n_dot_l <= 0) {
      return {};
    }
    const Vec3d h = unit(l + v);
    const double a = 2 / (k.shininess + 2);
    const auto smith = [a](double c) { return 2 * c / (c + std::sqrt(a + (1 - a) * c * c)); };
    const double n_dot_v = std::max(std::abs(dot(n, v)), 1e-12);
    const double g = smith(n_dot_l) * smith(n_dot_v);
    const double d = a / (kPi * std::pow(dot(n, h) * dot(n, h) * (a - 1) + 1, 2));
    const double x = std::pow(1 - std::abs(dot(v, h)), 5);
    const Vec3d one{1, 1, 1};
    const Vec3d f0{std::min(k.specular.x, 1.0), std::min(k.specular.y, 1.0), std::min(k.specular.z, 1.0)};
    const Vec3d f = f0 * (1 - x) + one * x;
    const Vec3d l_s = scene_.shading.terms.specular ? in_light(light.specular) : Vec3d{};
    return k.diffuse * in_light(light.diffuse) * (one - f) * n_dot_l + l_s * f * (kPi * d * g / (4 * n_dot_l * n_dot_v) * n_dot_l);
  }

  static double attenuation(const Attenuation& a, double d) {
    const double f = a.falloff ? 1 / std::pow(d, *a.falloff) : 1 / (a.constant + a.linear * d + a.quadratic * d * d);
    const double limited = a.unclamped ? f : std::min(f, 1.0);
    return a.range ? limited * std::clamp(1 - std::pow(d / *a.range, 4), 0.0, 1.0) : limited;
  }

  static double spot(const Light& light, const Vec3d& to_light) {
    if (light.type != LightType::spot) {
      return 1;
    }
    const double cs = dot(unit(light.direction), to_light * -1.0);
    if (cs < cosine(light.cutoff)) {
      return 0;
    }
    double s = std::pow(cs, light.exponent);
    if (light.beam) {                                                      // reading: the beam's fade multiplies the exponent's
      const double least = light.fade == SpotFade::quadratic ? 0.001 : 0;  // KHR_lights_punctual divides by max(0.001, ...)
      const double t = std::clamp((cs - cosine(light.cutoff)) / std::max(cosine(*light.beam) - cosine(light.cutoff), least), 0.0, 1.0);
      s *= light.fade == SpotFade::quadratic ? t * t : t * t * (3 - 2 * t);
    }
    return s;
  }

  /// x^0 is 1, also for x = 0.
  [[nodiscard]] double highlight(const Coefficients& k, const Vec3d& n, const Vec3d& l, const Vec3d& v, double n_dot_l) const {
    const double e = k.shininess;
    double lobe = 0;
    double normalization = 1;  // of the lobe's integral over the hemisphere, times pi; a lobe that is a BRDF is weighted by N.L
    if (k.lighting == Lighting::phong) {
      const Vec3d r = n * (2 * dot(n, l)) - l;
      lobe = std::pow(std::max(dot(r, v), 0.0), e);
      normalization = (e + 2) / (2 * kPi) * kPi;
    } else if (k.lighting == Lighting::blinn_phong) {
      lobe = std::pow(std::max(dot(n, unit(l + v)), 0.0), e);
      normalization = (e + 2) * (e + 4) / (8 * kPi * (std::pow(2, -e / 2) + e)) * kPi;
    }
    return scene_.shading.normalized ? lobe * normalization * n_dot_l : lobe;
  }

  /// c is the Euclidean distance to the eye, also with an orthographic camera (reading: to the camera's stated eye).
  [[nodiscard]] Vec3d fogged(const Vec3d& color, double c) const {
    if (!scene_.fog) {
      return color;
    }
    const Fog& fog = *scene_.fog;
    double f = 1;
    switch (fog.mode) {
      case FogMode::linear:
        f = (fog.end - c) / (fog.end - fog.start);
        break;
      case FogMode::exp:
        f = std::exp(-fog.density * c);
        break;
      case FogMode::exp2:
        f = std::exp(-(fog.density * c) * (fog.density * c));
        break;
    }
    f = std::clamp(f, 0.0, 1.0);
    return color * f + in_light(fog.color) * (1 - f);
  }

  const Scene& scene_;
  const World& world_;
  double x_, y_;
  const Hit& hit_;
  const World::Placed& placed_;
  bool front_;
  std::array<std::size_t, 3> corners_{};
};

}  // namespace

Seen see(const Scene& scene, const World& world, double x, double y, const Hit& hit) {
  if (hit.object >= 0) {
    return Judge(scene, world, x, y, hit).seen();
  }
  const ImageSettings& image = scene.image;
  const double alpha = image.transparent ? 0 : static_cast<double>(image.background_alpha);
  return {.color = light_of(image.background, image.transfer) * alpha, .alpha = alpha, .position = {}, .normal = {}};
}

Vec3d light_of(const Color& color, Transfer transfer) {
  return linear(color.rgb, color.space == ColorSpace::encoded && transfer == Transfer::srgb);
}

double stored(double value, Transfer transfer) {
  const double x = std::clamp(value, 0.0, 1.0);
  if (transfer == Transfer::none) {
    return x;
  }
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

}  // namespace lustro::truth
