// See bsdf.hpp.
#include "path/bsdf.hpp"

#include <algorithm>
#include <cmath>

#include "path/fresnel.hpp"
#include "path/sampling.hpp"

namespace lustro {
namespace {

constexpr int kMirror = 3, kFresnelMirror = 5, kClear = 6, kFresnelClear = 7;
constexpr float kLeastCosineShare = 0.1F;  // of a lobe alone: what it misses (N.V < 0, H beyond the horizon) is found by the cosine

float alpha2_of(float n) {
  return 2.0F / (n + 2.0F);
}

// About how much of the light a lobe of k_s = 1 reflects: it decides how often it is sampled, and nothing else.
float weight_of_lobe(Lighting lighting, bool normalized, float n) {
  if (normalized || lighting == Lighting::ggx) {
    return 1;
  }
  return std::min(1.0F, (lighting == Lighting::phong ? 2.0F : 8.0F) / (n + 1.0F));
}

}  // namespace

Bsdf::Bsdf(const SurfacePoint& point, const ShadingMaterial& material, const Shading& shading, bool is_front)
    : point_(point), lighting_(material.lighting), normalized_(shading.normalized), has_specular_term_(shading.terms.specular) {
  const Surface<float>& s = point.surface;
  const Vec3f& k_s = point.k.specular;
  const float n_dot_v = dot(s.normal, s.to_eye);
  facing_normal_ = n_dot_v < 0 ? -s.normal : s.normal;
  cosine_ = std::min(std::abs(n_dot_v), 1.0F);
  const int illumination = material.stated.illumination.value_or(2);
  const bool has_mirror = illumination >= kMirror && illumination <= kFresnelClear;
  if (has_mirror) {
    ratio_ = is_front ? material.stated.refraction : 1.0F / material.stated.refraction;
    const Fresnel fresnel = fresnel_dielectric(cosine_, ratio_);
    const Vec3f& passing = material.stated.transmission.rgb;
    const bool by_fresnel = illumination == kFresnelMirror || illumination == kFresnelClear;
    mirror_ = by_fresnel ? k_s * fresnel.reflected : k_s;
    if (illumination == kFresnelClear) {
      refraction_ = passing * (1.0F - fresnel.reflected);
    } else if (illumination == kClear) {
      const auto left = [](float k) { return std::max(1.0F - k, 0.0F); };
      refraction_ = fresnel.cosine_behind > 0 ? passing * Vec3f{left(k_s.x), left(k_s.y), left(k_s.z)} : Vec3f{};
    }
    cosine_behind_ = fresnel.cosine_behind;
  } else if (lighting_ != Lighting::lambert && has_specular_term_) {
    specular_ = k_s;
  }

  const float diffuse = luminance_of(point.k.diffuse);
  if (!has_mirror && specular_ == Vec3f{}) {
    cosine_share_ = diffuse > 0 ? 1.0F : 0.0F;
    return;
  }
  const float lobe = luminance_of(specular_) * weight_of_lobe(lighting_, normalized_, point.k.shininess.n);
  const float mirror = luminance_of(mirror_);
  const float refraction = luminance_of(refraction_);
  const float rough = diffuse + lobe;
  const float all = (rough + mirror) + refraction;
  if (!(all > 0)) {
    return;
  }
  const float cosine_of_rough = lobe > 0 ? std::max(diffuse / rough, kLeastCosineShare) : 1.0F;
  cosine_share_ = rough / all * cosine_of_rough;
  lobe_share_ = rough / all * (1.0F - cosine_of_rough);
  mirror_share_ = mirror / all;
  refraction_share_ = refraction / all;
}

Reflected Bsdf::reflected(const Vec3f& to_light) const {
  const Surface<float>& s = point_.surface;
  if (!(dot(point_.geometric_normal, to_light) > 0)) {
    return {};  // below the surface, whatever its interpolated normal says
  }
  const Reflection<float> k{{}, point_.k.diffuse, specular_};
  const Incident<float> in{to_light, 0, 1, 1, 1};
  LightTerms<float> terms;
  switch (lighting_) {
    case Lighting::constant:
      return {};
    case Lighting::lambert:
      terms = reflect_light<Lighting::lambert>(s, k, point_.k.shininess, in, normalized_);
      break;
    case Lighting::phong:
      terms = reflect_light<Lighting::phong>(s, k, point_.k.shininess, in, normalized_);
      break;
    case Lighting::blinn_phong:
      terms = reflect_light<Lighting::blinn_phong>(s, k, point_.k.shininess, in, normalized_);
      break;
    case Lighting::ggx:
      terms = reflect_ggx(s, k, specular_, has_specular_term_ ? Vec3f{1, 1, 1} : Vec3f{}, point_.k.shininess, in);
      break;
  }
  return {terms.diffuse, terms.specular};
}

float Bsdf::lobe_density(const Vec3f& to_light) const {
  const Surface<float>& s = point_.surface;
  const float n = point_.k.shininess.n;
  if (lighting_ == Lighting::phong) {
    return power_cosine_density(n, r_dot_v(s, to_light));
  }
  const Vec3f sum = to_light + s.to_eye;
  const float size = length(sum);
  if (!(size > 0)) {
    return 0;
  }
  const Vec3f half = sum * (1.0F / size);
  const float n_dot_h = dot(s.normal, half);
  const float v_dot_h = dot(s.to_eye, half);
  const float of_half = lighting_ == Lighting::ggx ? ggx_normal_density(alpha2_of(n), n_dot_h) : power_cosine_density(n, n_dot_h);
  return v_dot_h > 0 ? of_half / (4.0F * v_dot_h) : 0.0F;
}

float Bsdf::density(const Vec3f& to_light) const {
  const float cosine = dot(point_.surface.normal, to_light);
  float density = cosine > 0 ? cosine_share_ * (cosine * kInversePiF) : 0.0F;
  if (lobe_share_ > 0) {
    density += lobe_share_ * lobe_density(to_light);
  }
  return density;
}

Vec3f Bsdf::sample_lobe(const Vec2f& u) const {
  const Surface<float>& s = point_.surface;
  const float n = point_.k.shininess.n;
  if (lighting_ == Lighting::phong) {
    return Frame3(normalize(reflect_about(s.normal, s.to_eye))).world(sample_power_cosine(n, u));
  }
  const Vec3f local = lighting_ == Lighting::ggx ? sample_ggx_normal(alpha2_of(n), u) : sample_power_cosine(n, u);
  const Vec3f half = Frame3(s.normal).world(local);
  return dot(half, s.to_eye) > 0 ? reflect_about(half, s.to_eye) : Vec3f{};  // one that faces away mirrors nothing
}

ScatterSample Bsdf::sample_rough(const Vec3f& direction) const {
  ScatterSample sample{.direction = direction};
  const float density = this->density(direction);
  const Reflected value = reflected(direction);
  if (!(density > 0)) {
    return sample;
  }
  const float scale = kInversePiF / density;
  sample.weight = {value.diffuse * scale, value.specular * scale};
  sample.density = density;
  return sample;
}

ScatterSample Bsdf::sample_mirror() const {
  ScatterSample sample{.direction = normalize(reflect_about(facing_normal_, point_.surface.to_eye)), .is_delta = true};
  const float side = dot(point_.geometric_normal, point_.surface.to_eye);
  if (dot(point_.geometric_normal, sample.direction) * side > 0) {  // not into the surface, whatever its interpolated normal says
    sample.weight.specular = mirror_ * (1.0F / mirror_share_);
    sample.density = mirror_share_;
  }
  return sample;
}

ScatterSample Bsdf::sample_refraction() const {
  const Vec3f& to_eye = point_.surface.to_eye;
  ScatterSample sample{.direction = refracted(to_eye, facing_normal_, cosine_, cosine_behind_, ratio_), .is_delta = true, .passes = true};
  const float side = dot(point_.geometric_normal, to_eye);
  if (cosine_behind_ > 0 && dot(point_.geometric_normal, sample.direction) * side < 0) {
    // What comes from the denser side is spread over a wider angle: L / n^2 stays the same (Veach 1997, 5.2).
    sample.weight.specular = refraction_ * (1.0F / (refraction_share_ * (ratio_ * ratio_)));
    sample.density = refraction_share_;
  }
  return sample;
}

// The cosine alone: k_d cos over its density cos / pi, in our units.
ScatterSample Bsdf::sample_diffuse(const Vec2f& u) const {
  const Vec3f local = sample_cosine(u);
  ScatterSample sample{.direction = Frame3(point_.surface.normal).world(local)};
  if (dot(point_.geometric_normal, sample.direction) > 0) {
    sample.weight.diffuse = point_.k.diffuse;
    sample.density = local.z * kInversePiF;
  }
  return sample;
}

ScatterSample Bsdf::sample(float choice, const Vec2f& u) const {
  if (cosine_share_ == 1 && lighting_ == Lighting::lambert) {
    return sample_diffuse(u);
  }
  if (choice < cosine_share_) {
    return sample_rough(Frame3(point_.surface.normal).world(sample_cosine(u)));
  }
  choice -= cosine_share_;
  if (choice < lobe_share_) {
    const Vec3f direction = sample_lobe(u);
    return direction == Vec3f{} ? ScatterSample{} : sample_rough(normalize(direction));
  }
  choice -= lobe_share_;
  if (choice < mirror_share_) {
    return sample_mirror();
  }
  return refraction_share_ > 0 ? sample_refraction() : ScatterSample{};
}

}  // namespace lustro
