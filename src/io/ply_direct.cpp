// Every offset follows from the header, so each thread reads and decodes pieces of its own; whatever is unusual ends the attempt.
#include "io/ply_direct.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstring>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "io/limits.hpp"
#include "io/ply_header.hpp"
#include "io/ply_scalars.hpp"
#include "mesh/first_use.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {

namespace {

constexpr std::size_t kHead = std::size_t{1} << 16U;        // a longer header is not a usual one
constexpr std::size_t kPieceBytes = std::size_t{1} << 18U;  // fits a core's own cache, and the system reads it at full speed

/// A scalar of a record.
struct Field {
  std::size_t offset = 0;
  PlyType type = PlyType::float32;
  float divisor = 1;
};

/// A vector of a record, from its scalars.
template <std::size_t N>
struct Fields {
  std::array<Field, N> fields;
  bool is_stated = false;
  bool is_copy = false;  ///< the bytes are those of N floats in a row
};

struct Layout {
  bool is_swapped = false;
  std::size_t vertices = 0;
  std::size_t vertex_bytes = 0;
  std::size_t first_vertex = 0;  ///< byte
  Fields<3> position, normal, color;
  Fields<2> uv;
  std::size_t faces = 0;
  std::size_t face_bytes = 0;
  std::size_t first_face = 0;  ///< byte
  std::size_t count = 0;       ///< of a face: offset of the byte that holds the number of corners
};

template <std::size_t N>
Fields<N> fields_of(const std::array<std::optional<Field>, static_cast<std::size_t>(PlyPlace::nowhere)>& at, PlyPlace first, bool is_swapped) {
  Fields<N> vector;
  vector.is_stated = true;
  for (std::size_t i = 0; i < N; ++i) {
    const std::optional<Field>& field = at[static_cast<std::size_t>(first) + i];
    vector.is_stated = vector.is_stated && field.has_value();
    vector.fields[i] = field.value_or(Field{});
  }
  vector.is_copy = vector.is_stated && !is_swapped;
  for (std::size_t i = 0; i < N; ++i) {
    vector.is_copy = vector.is_copy && vector.fields[i].type == PlyType::float32 && vector.fields[i].offset == vector.fields[0].offset + 4 * i;
  }
  return vector;
}

bool lay_out_vertices(const PlyElement& element, Layout& layout) {
  std::array<std::optional<Field>, static_cast<std::size_t>(PlyPlace::nowhere)> at;
  for (const PlyProperty& property : element.properties) {
    if (property.count_type) {
      return false;
    }
    const PlyPlace place = place_of(property);
    if (place != PlyPlace::nowhere) {
      std::optional<Field>& field = at[static_cast<std::size_t>(place)];
      if (field) {
        return false;  // one number under two names
      }
      field = Field{layout.vertex_bytes, property.type, divisor_of(property, place)};
    }
    layout.vertex_bytes += size_of(property.type);
  }
  layout.position = fields_of<3>(at, PlyPlace::x, layout.is_swapped);
  layout.normal = fields_of<3>(at, PlyPlace::nx, layout.is_swapped);
  layout.uv = fields_of<2>(at, PlyPlace::u, layout.is_swapped);
  layout.color = fields_of<3>(at, PlyPlace::red, layout.is_swapped);
  // Colours outside 0..1 are settled, with a note, by who reads the others.
  return layout.position.is_stated && (!layout.color.is_stated || std::all_of(layout.color.fields.begin(), layout.color.fields.end(),
                                                                              [](const Field& f) { return f.divisor != 1; }));
}

bool lay_out_faces(const PlyElement& element, Layout& layout) {
  bool has_list = false;
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type) {
      if (place_of(property) >= PlyPlace::red && place_of(property) != PlyPlace::nowhere) {
        return false;
      }
      layout.face_bytes += size_of(property.type);
      continue;
    }
    if (has_list || !is_ply_index_list(property) || size_of(*property.count_type) != 1 ||
        (property.type != PlyType::int32 && property.type != PlyType::uint32)) {
      return false;
    }
    has_list = true;
    layout.count = layout.face_bytes;
    layout.face_bytes += 13;
  }
  return has_list;
}

std::optional<Layout> layout_of(const PlyHeader& header, std::size_t file_bytes) {
  if (header.encoding == PlyEncoding::ascii || header.elements.size() != 2 || header.elements[0].name != "vertex" ||
      header.elements[1].name != "face") {
    return std::nullopt;
  }
  const PlyElement& vertex = header.elements[0];
  const PlyElement& face = header.elements[1];
  Layout layout;
  layout.is_swapped = (header.encoding == PlyEncoding::little_endian) != (std::endian::native == std::endian::little);
  if (vertex.count > kMostElements || face.count > kMostElements / 3 || !lay_out_vertices(vertex, layout) || !lay_out_faces(face, layout)) {
    return std::nullopt;
  }
  layout.vertices = static_cast<std::size_t>(vertex.count);
  layout.faces = static_cast<std::size_t>(face.count);
  layout.first_vertex = header.body;
  const std::size_t rest = file_bytes - header.body;
  if (layout.vertices > rest / layout.vertex_bytes) {
    return std::nullopt;
  }
  const std::size_t face_rest = rest - layout.vertices * layout.vertex_bytes;
  layout.first_face = file_bytes - face_rest;
  const bool is_exact = face_rest % layout.face_bytes == 0 && face_rest / layout.face_bytes == layout.faces;
  return is_exact ? std::optional(layout) : std::nullopt;
}

template <class T>
double number_at(const char* at, bool is_swapped) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), at, sizeof(T));
  if (is_swapped) {
    std::reverse(raw.begin(), raw.end());
  }
  return static_cast<double>(std::bit_cast<T>(raw));
}

float value_of(const char* record, const Field& field, bool is_swapped) {
  const char* const at = record + field.offset;
  const auto number = [&] {
    switch (field.type) {
      case PlyType::int8:
        return number_at<std::int8_t>(at, is_swapped);
      case PlyType::uint8:
        return number_at<std::uint8_t>(at, is_swapped);
      case PlyType::int16:
        return number_at<std::int16_t>(at, is_swapped);
      case PlyType::uint16:
        return number_at<std::uint16_t>(at, is_swapped);
      case PlyType::int32:
        return number_at<std::int32_t>(at, is_swapped);
      case PlyType::uint32:
        return number_at<std::uint32_t>(at, is_swapped);
      case PlyType::float32:
        return number_at<float>(at, is_swapped);
      case PlyType::float64:
        return number_at<double>(at, is_swapped);
    }
    return 0.0;
  };
  return static_cast<float>(number()) / field.divisor;
}

/// Fills one attribute of the vertices from `first` on, of which `bytes` holds `count`. The vertex v becomes number_of[v], where that is stated.
template <std::size_t N, class V>
void decode(std::string_view bytes, const Layout& layout, const Fields<N>& vector, std::size_t first, std::size_t count,
            const std::uint32_t* number_of, std::vector<V>& to) {
  static_assert(sizeof(V) == N * sizeof(float));
  if (!vector.is_stated) {
    return;
  }
  const char* record = bytes.data();
  for (std::size_t v = first; v < first + count; ++v) {
    V& value = to[number_of == nullptr ? v : number_of[v]];
    if (vector.is_copy) {
      std::memcpy(&value, record + vector.fields[0].offset, sizeof(V));
    } else {
      std::array<float, N> numbers{};
      for (std::size_t i = 0; i < N; ++i) {
        numbers[i] = value_of(record, vector.fields[i], layout.is_swapped);
      }
      value = std::bit_cast<V>(numbers);
    }
    record += layout.vertex_bytes;
  }
}

template <bool kIsSwapped>
bool decode_faces(std::string_view bytes, const Layout& layout, std::span<std::array<std::uint32_t, 3>> to) {
  const char* record = bytes.data() + layout.count;
  const std::size_t stride = layout.face_bytes;
  std::uint32_t largest = 0;
  unsigned wrong_counts = 0;
  for (std::array<std::uint32_t, 3>& triangle : to) {
    wrong_counts |= static_cast<unsigned char>(record[0]) ^ 3U;
    std::memcpy(triangle.data(), record + 1, sizeof triangle);
    if constexpr (kIsSwapped) {
      for (std::uint32_t& index : triangle) {
        index = __builtin_bswap32(index);
      }
    }
    largest = std::max({largest, triangle[0], triangle[1], triangle[2]});
    record += stride;
  }
  return wrong_counts == 0 && (to.empty() || largest < layout.vertices);
}

/// Calls body(bytes, first, count) for pieces of `count` records of `size` bytes from byte `begin` on; false where one cannot be read or is
/// refused.
template <class Body>
bool for_records(const ByteSource& source, std::size_t begin, std::size_t size, std::size_t count, int threads, const Body& body) {
  std::atomic<bool> is_good = true;
  const std::size_t step = std::max<std::size_t>(1, kPieceBytes / size);
  parallel_slices(
      count, threads,
      [&](std::size_t first, std::size_t end) {
        const BigArray<char> room = make_big_array<char>(step * size);
        for (std::size_t at = first; at < end && is_good; at += step) {
          const std::size_t records = std::min(step, end - at);
          const std::string_view bytes = source.read(begin + at * size, records * size, room.get());
          if (bytes.size() != records * size || !body(bytes, at, records)) {
            is_good = false;
          }
        }
      },
      4 * step);
  return is_good;
}

bool read_faces(const ByteSource& source, const Layout& layout, int threads, PlainMesh& mesh) {
  resize_big(mesh.triangles, layout.faces);
  return for_records(source, layout.first_face, layout.face_bytes, layout.faces, threads,
                     [&](std::string_view bytes, std::size_t first, std::size_t count) {
                       const std::span to = std::span(mesh.triangles).subspan(first, count);
                       return layout.is_swapped ? decode_faces<true>(bytes, layout, to) : decode_faces<false>(bytes, layout, to);
                     });
}

bool read_vertices(const ByteSource& source, const Layout& layout, const std::uint32_t* number_of, int threads, PlainMesh& mesh) {
  const auto take = [&](auto& list, bool is_stated) { resize_big(list, is_stated ? layout.vertices : 0); };
  take(mesh.positions, true);
  take(mesh.normals, layout.normal.is_stated);
  take(mesh.uvs, layout.uv.is_stated);
  take(mesh.colors, layout.color.is_stated);
  return for_records(source, layout.first_vertex, layout.vertex_bytes, layout.vertices, threads,
                     [&](std::string_view bytes, std::size_t first, std::size_t count) {
                       decode<3>(bytes, layout, layout.position, first, count, number_of, mesh.positions);
                       decode<3>(bytes, layout, layout.normal, first, count, number_of, mesh.normals);
                       decode<2>(bytes, layout, layout.uv, first, count, number_of, mesh.uvs);
                       decode<3>(bytes, layout, layout.color, first, count, number_of, mesh.colors);
                       return true;
                     });
}

}  // namespace

std::optional<PlainMesh> read_plain_ply(const ByteSource& source, bool is_sorted, int threads) {
  std::string room(std::min(kHead, source.size()), '\0');
  const std::string_view head = source.read(0, room.size(), room.data());
  const Result<PlyHeader> header = parse_ply_header(head, "");
  if (!header || (header->body >= head.size() && head.size() < source.size())) {
    return std::nullopt;
  }
  const std::optional<Layout> layout = layout_of(*header, source.size());
  if (!layout) {
    return std::nullopt;
  }
  PlainMesh mesh;
  if (!read_faces(source, *layout, threads, mesh)) {
    return std::nullopt;
  }
  FirstUse numbers;  // freed before the normals are made
  if (is_sorted) {
    numbers = number_by_first_use(mesh.triangles, layout->vertices, threads);
    renumber(mesh.triangles, numbers, threads);
    mesh.used = numbers.used;
  }
  if (!read_vertices(source, *layout, is_sorted && !numbers.is_sorted ? numbers.new_of_old.get() : nullptr, threads, mesh)) {
    return std::nullopt;
  }
  mesh.format = ply_format_name(header->encoding);
  return mesh;
}

}  // namespace lustro
