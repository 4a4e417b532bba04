// Which property of a PLY element fills which number of a mesh, by the names that writers use.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include "io/ply_header.hpp"
#include "lustro/vec.hpp"

namespace lustro {

/// What a scalar property fills.
enum class PlyPlace : std::size_t { x, y, z, nx, ny, nz, u, v, red, green, blue, nowhere };

inline constexpr std::array<std::pair<std::string_view, PlyPlace>, 28> kPlyNames{{
    {"x", PlyPlace::x},
    {"y", PlyPlace::y},
    {"z", PlyPlace::z},
    {"nx", PlyPlace::nx},
    {"ny", PlyPlace::ny},
    {"nz", PlyPlace::nz},
    {"normal_x", PlyPlace::nx},
    {"normal_y", PlyPlace::ny},
    {"normal_z", PlyPlace::nz},
    {"u", PlyPlace::u},
    {"v", PlyPlace::v},
    {"s", PlyPlace::u},
    {"t", PlyPlace::v},
    {"texture_u", PlyPlace::u},
    {"texture_v", PlyPlace::v},
    {"texture_s", PlyPlace::u},
    {"texture_t", PlyPlace::v},
    {"texcoord_u", PlyPlace::u},
    {"texcoord_v", PlyPlace::v},
    {"red", PlyPlace::red},
    {"green", PlyPlace::green},
    {"blue", PlyPlace::blue},
    {"r", PlyPlace::red},
    {"g", PlyPlace::green},
    {"b", PlyPlace::blue},
    {"diffuse_red", PlyPlace::red},
    {"diffuse_green", PlyPlace::green},
    {"diffuse_blue", PlyPlace::blue},
}};

[[nodiscard]] inline PlyPlace place_of(const PlyProperty& property) {
  for (const auto& [name, place] : kPlyNames) {
    if (name == property.name && !property.count_type) {
      return place;
    }
  }
  return PlyPlace::nowhere;
}

/// What a value is divided by: integers of uvs and colours stand for 0..1. What other types hold is meant as it stands.
[[nodiscard]] inline float divisor_of(const PlyProperty& property, PlyPlace place) {
  if (place < PlyPlace::u || (property.type != PlyType::uint8 && property.type != PlyType::uint16)) {
    return 1;
  }
  return property.type == PlyType::uint8 ? 255.0F : 65535.0F;
}

/// The scalars of one element as they are read.
class PlyScalars {
 public:
  explicit PlyScalars(const PlyElement& element) {
    divisors_.fill(1);
    for (const PlyProperty& property : element.properties) {
      const auto place = static_cast<std::size_t>(place_of(property));
      places_.push_back(place);
      is_stated_[place] = true;
      if (const float divisor = divisor_of(property, place_of(property)); divisor != 1) {
        divisors_[place] = divisor;
      }
    }
  }

  /// The value of the element's property of that number.
  void set(std::size_t property, double value) { values_[places_[property]] = static_cast<float>(value); }

  [[nodiscard]] bool has_position() const { return has(PlyPlace::x) && has(PlyPlace::y) && has(PlyPlace::z); }
  [[nodiscard]] bool has_normal() const { return has(PlyPlace::nx) && has(PlyPlace::ny) && has(PlyPlace::nz); }
  [[nodiscard]] bool has_uv() const { return has(PlyPlace::u) && has(PlyPlace::v); }
  [[nodiscard]] bool has_color() const { return has(PlyPlace::red) && has(PlyPlace::green) && has(PlyPlace::blue); }

  [[nodiscard]] Vec3f position() const { return {at(PlyPlace::x), at(PlyPlace::y), at(PlyPlace::z)}; }
  [[nodiscard]] Vec3f normal() const { return {at(PlyPlace::nx), at(PlyPlace::ny), at(PlyPlace::nz)}; }
  [[nodiscard]] Vec2f uv() const { return {at(PlyPlace::u), at(PlyPlace::v)}; }
  [[nodiscard]] Vec3f color() const { return {at(PlyPlace::red), at(PlyPlace::green), at(PlyPlace::blue)}; }

 private:
  static constexpr std::size_t kPlaces = static_cast<std::size_t>(PlyPlace::nowhere) + 1;
  [[nodiscard]] bool has(PlyPlace place) const { return is_stated_[static_cast<std::size_t>(place)]; }
  [[nodiscard]] float at(PlyPlace place) const { return values_[static_cast<std::size_t>(place)] / divisors_[static_cast<std::size_t>(place)]; }

  std::vector<std::size_t> places_;  // one a property
  std::array<bool, kPlaces> is_stated_{};
  std::array<float, kPlaces> divisors_{};
  std::array<float, kPlaces> values_{};
};

}  // namespace lustro
