// KHR_draco_mesh_compression through libdraco; without it, an error that says so.
#include "io/gltf_draco.hpp"

#ifdef LUSTRO_HAS_DRACO
#include <draco/compression/decode.h>
#include <fmt/format.h>

#include <exception>
#include <limits>
#endif

namespace lustro {

#ifdef LUSTRO_HAS_DRACO

namespace {

/// What the largest whole number of a type stands for where it is normalised.
float divisor_of(draco::DataType type) {
  switch (type) {
    case draco::DT_INT8:
      return 127;
    case draco::DT_UINT8:
      return 255;
    case draco::DT_INT16:
      return 32767;
    case draco::DT_UINT16:
      return 65535;
    default:
      return 1;
  }
}

Result<std::vector<float>> values_of(const draco::Mesh& mesh, const DracoWish& wish) {
  const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(wish.id);
  if (attribute == nullptr) {
    return fail(ErrorKind::malformed, wish.name, fmt::format("the packed mesh has no attribute with the id {}", wish.id));
  }
  if (attribute->num_components() != static_cast<int>(wish.components)) {
    return fail(ErrorKind::malformed, wish.name,
                fmt::format("the packed attribute {} has {} components, expected {}", wish.id, attribute->num_components(), wish.components));
  }
  const float divisor = wish.is_normalized && !attribute->normalized() ? divisor_of(attribute->data_type()) : 1;
  std::vector<float> values(mesh.num_points() * wish.components);
  for (std::uint32_t i = 0; i < mesh.num_points(); ++i) {
    const draco::AttributeValueIndex index = attribute->mapped_index(draco::PointIndex(i));
    float* to = values.data() + i * wish.components;
    if (index.value() >= attribute->size() || !attribute->ConvertValue<float>(index, static_cast<std::int8_t>(wish.components), to)) {
      return fail(ErrorKind::malformed, wish.name, fmt::format("the packed attribute {} has no value for point {}", wish.id, i));
    }
    for (std::size_t k = 0; k < wish.components; ++k) {
      to[k] /= divisor;
    }
  }
  return values;
}

Result<DracoMesh> unpack(std::string_view bytes, std::span<const DracoWish> wishes, std::uint64_t most_values) {
  draco::DecoderBuffer buffer;
  buffer.Init(bytes.data(), bytes.size());
  draco::Decoder decoder;
  draco::StatusOr<std::unique_ptr<draco::Mesh>> decoded = decoder.DecodeMeshFromBuffer(&buffer);
  if (!decoded.ok() || decoded.value() == nullptr) {
    return fail(ErrorKind::malformed, {}, fmt::format("its bytes cannot be unpacked: {}", decoded.status().error_msg_string()));
  }
  const draco::Mesh& mesh = *decoded.value();
  DracoMesh result;
  result.points = mesh.num_points();
  std::uint64_t values = 3 * std::uint64_t{mesh.num_faces()};
  for (const DracoWish& wish : wishes) {
    values += std::uint64_t{mesh.num_points()} * wish.components;
  }
  if (values > most_values) {
    return fail(ErrorKind::limit, {}, fmt::format("unpacks to {} numbers, more than the {} that are granted", values, most_values));
  }
  result.indices.reserve(3 * std::size_t{mesh.num_faces()});
  for (std::uint32_t f = 0; f < mesh.num_faces(); ++f) {
    for (const draco::PointIndex& corner : mesh.face(draco::FaceIndex(f))) {
      if (corner.value() >= mesh.num_points()) {
        return fail(ErrorKind::malformed, {}, fmt::format("packed triangle {} names point {} of {}", f, corner.value(), mesh.num_points()));
      }
      result.indices.push_back(corner.value());
    }
  }
  for (const DracoWish& wish : wishes) {
    Result<std::vector<float>> list = values_of(mesh, wish);
    if (!list) {
      return tl::unexpected(list.error());
    }
    result.values.push_back(std::move(*list));
  }
  return result;
}

}  // namespace

Result<DracoMesh> unpack_draco(std::string_view bytes, std::span<const DracoWish> wishes, std::uint64_t most_values) {
  try {
    return unpack(bytes, wishes, most_values);
  } catch (const std::exception& problem) {
    return fail(ErrorKind::limit, {}, fmt::format("its bytes cannot be unpacked: {}", problem.what()));
  }
}

#else

Result<DracoMesh> unpack_draco(std::string_view, std::span<const DracoWish>, std::uint64_t) {
  return fail(ErrorKind::unsupported, {}, "KHR_draco_mesh_compression is not read: this build of Lustro is without libdraco");
}

#endif

}  // namespace lustro
