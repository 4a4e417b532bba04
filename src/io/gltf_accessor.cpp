// See gltf_accessor.hpp. That every byte lies inside its view was checked when the document was read.
#include "io/gltf_accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>

namespace lustro {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little endian, and its numbers are copied as they lie");

template <class T>
T load(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

float float_at(const char* from, GltfComponent component, bool is_normalized) {
  switch (component) {
    case GltfComponent::int8: {
      const auto value = static_cast<float>(load<std::int8_t>(from));
      return is_normalized ? std::max(value / 127, -1.0F) : value;
    }
    case GltfComponent::uint8: {
      const auto value = static_cast<float>(load<std::uint8_t>(from));
      return is_normalized ? value / 255 : value;
    }
    case GltfComponent::int16: {
      const auto value = static_cast<float>(load<std::int16_t>(from));
      return is_normalized ? std::max(value / 32767, -1.0F) : value;
    }
    case GltfComponent::uint16: {
      const auto value = static_cast<float>(load<std::uint16_t>(from));
      return is_normalized ? value / 65535 : value;
    }
    case GltfComponent::uint32:
      return static_cast<float>(load<std::uint32_t>(from));
    case GltfComponent::float32:
      break;
  }
  return load<float>(from);
}

std::uint32_t whole_at(const char* from, GltfComponent component) {
  switch (component) {
    case GltfComponent::uint8:
      return load<std::uint8_t>(from);
    case GltfComponent::uint16:
      return load<std::uint16_t>(from);
    default:
      return load<std::uint32_t>(from);
  }
}

/// Calls f(place in the result, bytes) for each number of one element.
template <class F>
void visit_element(const GltfAccessor& accessor, const char* element, std::size_t first, F&& f) {
  const std::size_t size = size_of(accessor.component);
  if (accessor.type < GltfType::mat2) {
    for (std::size_t k = 0; k < accessor.components(); ++k) {
      f(first + k, element + k * size);
    }
    return;
  }
  const std::size_t rows = accessor.type == GltfType::mat2 ? 2 : accessor.type == GltfType::mat3 ? 3 : 4;
  const std::size_t column = (rows * size + 3) / 4 * 4;
  for (std::size_t k = 0; k < rows * rows; ++k) {
    f(first + k, element + k / rows * column + k % rows * size);
  }
}

template <class F>
void visit_dense(const GltfFile& file, const GltfAccessor& accessor, F&& f) {
  if (accessor.view == kGltfNone) {
    return;
  }
  const GltfView& view = file.document.views[accessor.view];
  const auto stride = static_cast<std::size_t>(view.stride != 0 ? view.stride : accessor.element_bytes());
  const char* begin = file.views[accessor.view].data() + accessor.offset;
  for (std::size_t i = 0; i < accessor.count; ++i) {
    visit_element(accessor, begin + i * stride, i * accessor.components(), f);
  }
}

template <class F>
Result<void> visit_sparse(const GltfFile& file, std::uint32_t index, F&& f) {
  const GltfAccessor& accessor = file.document.accessors[index];
  if (!accessor.sparse) {
    return {};
  }
  const GltfSparse& sparse = *accessor.sparse;
  const char* indices = file.views[sparse.index_view].data() + sparse.index_offset;
  const char* values = file.views[sparse.value_view].data() + sparse.value_offset;
  std::uint64_t least = 0;
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::uint32_t at = whole_at(indices + i * size_of(sparse.index_component), sparse.index_component);
    if (at >= accessor.count || at < least) {
      return file.fail_at(fmt::format("accessors[{}].sparse.indices", index),
                          fmt::format("element {} is {}, expected {}..{} (they rise)", i, at, least, accessor.count - 1));
    }
    least = std::uint64_t{at} + 1;
    visit_element(accessor, values + i * accessor.element_bytes(), at * accessor.components(), f);
  }
  return {};
}

}  // namespace

Result<std::vector<float>> read_floats(GltfFile& file, std::uint32_t index) {
  const GltfAccessor& accessor = file.document.accessors[index];
  const std::uint64_t count = accessor.count * accessor.components();
  if (const Result<void> taken = file.take(count, fmt::format("accessors[{}].count", index)); !taken) {
    return tl::unexpected(taken.error());
  }
  std::vector<float> values(static_cast<std::size_t>(count));
  const auto set = [&](std::size_t at, const char* from) { values[at] = float_at(from, accessor.component, accessor.is_normalized); };
  visit_dense(file, accessor, set);
  if (const Result<void> done = visit_sparse(file, index, set); !done) {
    return tl::unexpected(done.error());
  }
  return values;
}

Result<std::vector<std::uint32_t>> read_whole(GltfFile& file, std::uint32_t index) {
  const GltfAccessor& accessor = file.document.accessors[index];
  const std::uint64_t count = accessor.count * accessor.components();
  if (const Result<void> taken = file.take(count, fmt::format("accessors[{}].count", index)); !taken) {
    return tl::unexpected(taken.error());
  }
  std::vector<std::uint32_t> values(static_cast<std::size_t>(count));
  const auto set = [&](std::size_t at, const char* from) { values[at] = whole_at(from, accessor.component); };
  visit_dense(file, accessor, set);
  if (const Result<void> done = visit_sparse(file, index, set); !done) {
    return tl::unexpected(done.error());
  }
  return values;
}

Result<void> add_weighted(GltfFile& file, std::uint32_t index, double weight, std::vector<double>& to) {
  const GltfAccessor& accessor = file.document.accessors[index];
  const auto value = [&](const char* from) { return static_cast<double>(float_at(from, accessor.component, accessor.is_normalized)); };
  if (accessor.sparse && accessor.view == kGltfNone) {
    if (const Result<void> taken = file.take(accessor.sparse->count * accessor.components(), fmt::format("accessors[{}].sparse", index));
        !taken) {
      return taken;
    }
    return visit_sparse(file, index, [&](std::size_t at, const char* from) { to[at] += weight * value(from); });
  }
  if (accessor.view == kGltfNone) {
    return {};
  }
  const Result<std::vector<float>> values = read_floats(file, index);
  if (!values) {
    return tl::unexpected(values.error());
  }
  for (std::size_t i = 0; i < to.size(); ++i) {
    to[i] += weight * static_cast<double>((*values)[i]);
  }
  return {};
}

}  // namespace lustro
