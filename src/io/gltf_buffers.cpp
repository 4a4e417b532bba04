// `buffers`, `bufferViews` and `accessors`: that each lies inside what it names, by the numbers that the document states.
#include <fmt/format.h>

#include "io/gltf_document.hpp"

namespace lustro {
namespace {

using Json = nlohmann::json;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 48U;  // so that sums of two, and counts times strides, stay far from overflow
constexpr std::uint64_t kMostCount = 0xFFFFFFFEU;

GltfComponent read_component(GltfReader& reader, const Json& parent, std::string_view key) {
  const std::uint64_t code = reader.needed_whole(parent, key, {});
  if ((code < 5120 || code > 5126 || code == 5124) && !reader.failed()) {
    reader.fail(parent, key, fmt::format("{} is no component type: 5120, 5121, 5122, 5123, 5125 or 5126", code));
  }
  return reader.failed() ? GltfComponent::float32 : static_cast<GltfComponent>(code);
}

void read_buffers(GltfReader& reader, const Json& root, bool has_binary, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "buffers")) {
    GltfBuffer buffer;
    buffer.length = reader.needed_whole(json, "byteLength", {1, kMostBytes});
    if (const Json* uri = GltfReader::find(json, "uri"); uri != nullptr) {
      static_cast<void>(reader.text(json, "uri"));
      buffer.uri = reader.failed() ? nullptr : &uri->get_ref<const std::string&>();
    }
    if (const Json* meshopt = reader.extension(json, "EXT_meshopt_compression")) {
      buffer.is_fallback = reader.boolean(*meshopt, "fallback", false) && buffer.uri == nullptr;
    }
    const bool is_chunk = document.buffers.empty() && has_binary;
    if (buffer.uri == nullptr && !is_chunk && !buffer.is_fallback) {
      reader.fail(json, "uri", "is missing, and there is no binary chunk in its place");
    }
    document.buffers.push_back(buffer);
  }
}

/// `offset` and `length` of the keys, inside the buffer.
void read_range(GltfReader& reader, const Json& json, const GltfDocument& document, std::uint32_t buffer, std::uint64_t& offset,
                std::uint64_t& length) {
  offset = reader.whole(json, "byteOffset", {0, kMostBytes}, 0);
  length = reader.needed_whole(json, "byteLength", {1, kMostBytes});
  if (reader.failed()) {
    return;
  }
  const std::uint64_t size = document.buffers[buffer].length;
  if (offset > size || length > size - offset) {
    reader.fail(json, offset > size ? "byteOffset" : "byteLength",
                fmt::format("bytes {}..{} are outside buffers[{}], which has {}", offset, offset + length, buffer, size));
  }
}

GltfMeshopt read_meshopt(GltfReader& reader, const Json& json, const GltfView& view, const GltfDocument& document) {
  GltfMeshopt packed;
  packed.buffer = reader.needed_index(json, "buffer", document.buffers.size(), "buffers");
  if (reader.failed()) {
    return packed;
  }
  read_range(reader, json, document, packed.buffer, packed.offset, packed.length);
  packed.stride = reader.needed_whole(json, "byteStride", {1, 256});
  packed.count = reader.needed_whole(json, "count", {0, kMostCount});
  const std::string mode = reader.text(json, "mode");
  const std::string filter = reader.text(json, "filter");
  if (reader.failed()) {
    return packed;
  }
  using Mode = GltfMeshopt::Mode;
  using Filter = GltfMeshopt::Filter;
  if (document.buffers[packed.buffer].is_fallback) {
    reader.fail(json, "buffer", fmt::format("buffers[{}] is a fallback without bytes", packed.buffer));
  }
  if (mode != "ATTRIBUTES" && mode != "TRIANGLES" && mode != "INDICES") {
    reader.fail(json, "mode", "is none of ATTRIBUTES, TRIANGLES, INDICES");
  }
  packed.mode = mode == "TRIANGLES" ? Mode::triangles : mode == "INDICES" ? Mode::indices : Mode::attributes;
  if (!filter.empty() && filter != "NONE" && filter != "OCTAHEDRAL" && filter != "QUATERNION" && filter != "EXPONENTIAL") {
    reader.fail(json, "filter", "is none of NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL");
  }
  packed.filter = filter == "OCTAHEDRAL"    ? Filter::octahedral
                  : filter == "QUATERNION"  ? Filter::quaternion
                  : filter == "EXPONENTIAL" ? Filter::exponential
                                            : Filter::none;
  const auto stride_is = [&](bool is_good, std::string_view expected) {
    if (!is_good) {
      reader.fail(json, "byteStride", fmt::format("{} does not fit: expected {}", packed.stride, expected));
    }
  };
  if (packed.mode == Mode::attributes) {
    stride_is(packed.stride % 4 == 0, "a multiple of 4 for attributes");
    if (packed.filter == Filter::octahedral) {
      stride_is(packed.stride == 4 || packed.stride == 8, "4 or 8 for the filter OCTAHEDRAL");
    } else if (packed.filter == Filter::quaternion) {
      stride_is(packed.stride == 8, "8 for the filter QUATERNION");
    }
  } else {
    stride_is(packed.stride == 2 || packed.stride == 4, "2 or 4 for indices");
    if (packed.filter != Filter::none) {
      reader.fail(json, "filter", "belongs to ATTRIBUTES alone");
    }
    if (packed.mode == Mode::triangles && packed.count % 3 != 0) {
      reader.fail(json, "count", fmt::format("{} is no multiple of 3", packed.count));
    }
  }
  if (packed.count * packed.stride != view.length) {
    reader.fail(json, "count", fmt::format("{} elements of {} bytes are not the {} of the view", packed.count, packed.stride, view.length));
  }
  constexpr std::uint64_t kMostRatio = 64;  // a byte of header for 64 bytes that do not change; of an index less
  constexpr std::uint64_t kSlack = 4096;
  if (view.length > kMostRatio * packed.length + kSlack) {
    reader.fail(json, "byteLength", fmt::format("{} bytes cannot hold {}", packed.length, view.length));
  }
  return packed;
}

void read_views(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "bufferViews")) {
    GltfView view;
    view.buffer = reader.needed_index(json, "buffer", document.buffers.size(), "buffers");
    if (reader.failed()) {
      return;
    }
    read_range(reader, json, document, view.buffer, view.offset, view.length);
    view.stride = reader.whole(json, "byteStride", {4, 252}, 0);
    if (view.stride % 4 != 0) {
      reader.fail(json, "byteStride", fmt::format("{} is no multiple of 4", view.stride));
    }
    const std::uint64_t target = reader.whole(json, "target", {}, 34962);
    if (target != 34962 && target != 34963) {
      reader.fail(json, "target", fmt::format("{} is neither 34962 nor 34963", target));
    }
    if (const Json* meshopt = reader.extension(json, "EXT_meshopt_compression"); meshopt != nullptr && !reader.failed()) {
      view.meshopt = read_meshopt(reader, *meshopt, view, document);
    } else if (document.buffers[view.buffer].is_fallback) {
      reader.fail(json, "buffer", fmt::format("buffers[{}] is a fallback without bytes", view.buffer));
    }
    document.views.push_back(view);
  }
}

/// That `count` elements from `offset` on lie inside the view, on multiples of the component's size.
void check_inside(GltfReader& reader, const Json& place, const GltfDocument& document, std::uint32_t view_index, std::uint64_t offset,
                  std::uint64_t count, std::uint64_t element, std::uint64_t component, bool has_stride) {
  if (reader.failed()) {
    return;
  }
  const GltfView& view = document.views[view_index];
  const std::uint64_t stride = has_stride && view.stride != 0 ? view.stride : element;
  if (stride < element) {
    reader.fail(place, fmt::format("its elements have {} bytes, and bufferViews[{}] has a byteStride of {}", element, view_index, stride));
    return;
  }
  if (offset % component != 0 || (view.offset + offset) % component != 0 || stride % component != 0) {
    reader.fail(place, "byteOffset",
                fmt::format("{} (bufferViews[{}] begins at {}) is no multiple of {}, the bytes of a component", offset, view_index, view.offset,
                            component));
    return;
  }
  const std::uint64_t end = offset + (count - 1) * stride + element;
  if (end > view.length) {
    reader.fail(place, offset >= view.length ? "byteOffset" : "count",
                fmt::format("{} elements end at byte {} of bufferViews[{}], which has {}", count, end, view_index, view.length));
  }
}

GltfSparse read_sparse(GltfReader& reader, const Json& json, const GltfAccessor& accessor, const GltfDocument& document) {
  GltfSparse sparse;
  sparse.count = reader.needed_whole(json, "count", {1, accessor.count});
  for (const char* part : {"indices", "values"}) {
    if (GltfReader::find(json, part) == nullptr) {
      reader.fail(json, part, "is missing, expected a table {...}");
    }
  }
  const Json& indices = reader.table(json, "indices");
  const Json& values = reader.table(json, "values");
  if (reader.failed()) {
    return sparse;
  }
  sparse.index_view = reader.needed_index(indices, "bufferView", document.views.size(), "bufferViews");
  sparse.index_offset = reader.whole(indices, "byteOffset", {0, kMostBytes}, 0);
  sparse.index_component = read_component(reader, indices, "componentType");
  if (sparse.index_component != GltfComponent::uint8 && sparse.index_component != GltfComponent::uint16 &&
      sparse.index_component != GltfComponent::uint32) {
    reader.fail(indices, "componentType", "is no unsigned integer: 5121, 5123 or 5125");
  }
  sparse.value_view = reader.needed_index(values, "bufferView", document.views.size(), "bufferViews");
  sparse.value_offset = reader.whole(values, "byteOffset", {0, kMostBytes}, 0);
  const std::size_t index_bytes = size_of(sparse.index_component);
  check_inside(reader, indices, document, sparse.index_view, sparse.index_offset, sparse.count, index_bytes, index_bytes, false);
  check_inside(reader, values, document, sparse.value_view, sparse.value_offset, sparse.count, accessor.element_bytes(),
               size_of(accessor.component), false);
  return sparse;
}

void read_accessors(GltfReader& reader, const Json& root, GltfDocument& document) {
  for (const Json& json : reader.tables(root, "accessors")) {
    GltfAccessor accessor;
    accessor.view = reader.index(json, "bufferView", document.views.size(), "bufferViews");
    accessor.offset = reader.whole(json, "byteOffset", {0, kMostBytes}, 0);
    accessor.component = read_component(reader, json, "componentType");
    accessor.count = reader.needed_whole(json, "count", {1, kMostCount});
    accessor.is_normalized = reader.boolean(json, "normalized", false);
    const std::string type = reader.text(json, "type");
    if (reader.failed()) {
      return;
    }
    bool is_known = false;
    for (const GltfType known :
         {GltfType::scalar, GltfType::vec2, GltfType::vec3, GltfType::vec4, GltfType::mat2, GltfType::mat3, GltfType::mat4}) {
      if (type == name_of(known)) {
        accessor.type = known;
        is_known = true;
      }
    }
    if (!is_known) {
      reader.fail(json, "type", "is none of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4");
    }
    if (accessor.is_normalized && (accessor.component == GltfComponent::float32 || accessor.component == GltfComponent::uint32)) {
      reader.fail(json, "normalized", fmt::format("is true, but components are {}", name_of(accessor.component)));
    }
    for (const char* key : {"min", "max"}) {
      const Json& limits = reader.list(json, key);
      if (!limits.empty() && limits.size() != accessor.components()) {
        reader.fail(limits, fmt::format("is a list of {}, expected {} as for {}", limits.size(), accessor.components(), type));
      }
      for (const Json& limit : limits) {
        if (!limit.is_number()) {
          reader.fail(limit, "is no number");
        }
      }
    }
    if (accessor.view != kGltfNone) {
      check_inside(reader, json, document, accessor.view, accessor.offset, accessor.count, accessor.element_bytes(), size_of(accessor.component),
                   true);
    } else if (accessor.offset != 0) {
      reader.fail(json, "byteOffset", "is stated without a bufferView");
    }
    if (const Json* sparse = GltfReader::find(json, "sparse"); sparse != nullptr && !reader.failed()) {
      accessor.sparse = read_sparse(reader, reader.table(json, "sparse"), accessor, document);
    }
    document.accessors.push_back(accessor);
  }
}

}  // namespace

std::size_t size_of(GltfComponent component) {
  switch (component) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    case GltfComponent::uint32:
    case GltfComponent::float32:
      break;
  }
  return 4;
}

std::size_t count_of(GltfType type) {
  constexpr std::array<std::size_t, 7> kCounts{1, 2, 3, 4, 4, 9, 16};
  return kCounts[static_cast<std::size_t>(type)];
}

std::string_view name_of(GltfType type) {
  constexpr std::array<std::string_view, 7> kNames{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  return kNames[static_cast<std::size_t>(type)];
}

std::string_view name_of(GltfComponent component) {
  constexpr std::array<std::string_view, 7> kNames{"BYTE", "UNSIGNED_BYTE", "SHORT", "UNSIGNED_SHORT", "?", "UNSIGNED_INT", "FLOAT"};
  return kNames[static_cast<std::size_t>(component) - 5120];
}

std::size_t GltfAccessor::element_bytes() const {
  const std::size_t size = size_of(component);
  if (type == GltfType::mat2 || type == GltfType::mat3 || type == GltfType::mat4) {
    const std::size_t rows = type == GltfType::mat2 ? 2 : type == GltfType::mat3 ? 3 : 4;
    return (rows * size + 3) / 4 * 4 * rows;
  }
  return components() * size;
}

void read_gltf_buffers(GltfReader& reader, const Json& root, bool has_binary, GltfDocument& document) {
  read_buffers(reader, root, has_binary, document);
  if (!reader.failed()) {
    read_views(reader, root, document);
  }
  if (!reader.failed()) {
    read_accessors(reader, root, document);
  }
}

}  // namespace lustro
