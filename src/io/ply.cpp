// Reads the body of a PLY file, element by element, once written for ascii and for both byte orders.
#include "io/ply.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "io/colors.hpp"
#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/ply_direct.hpp"
#include "io/ply_header.hpp"
#include "io/ply_scalars.hpp"
#include "io/ply_values.hpp"

namespace lustro {

namespace {

constexpr std::uint32_t kNone = SourceMesh::kNone;

template <class Values>
class BodyReader {
 public:
  BodyReader(std::string_view bytes, const PlyHeader& header, const std::string& file)
      : header_(header), notes_(file), values_(bytes, header, file, notes_) {}

  Result<SourceMesh> read();

 private:
  bool check_counts();
  bool read_element(const PlyElement& element);
  bool read_vertices(const PlyElement& element);
  bool read_faces(const PlyElement& element);
  bool read_face(const PlyElement& element, PlyScalars& scalars);
  bool read_strips(const PlyElement& element);
  bool skip_element(const PlyElement& element);

  bool read_scalar(const PlyProperty& property, double& value);
  bool read_count(const PlyProperty& property, std::uint64_t& count);
  bool read_indices(const PlyProperty& property, bool may_restart);
  bool read_texcoords(const PlyProperty& property);
  bool skip_list(const PlyProperty& property);

  bool add_face();
  bool add_strips();
  void finish();

  bool error(ErrorKind kind, std::string place, std::string message) {
    error_ = Error{kind, std::move(place), std::move(message)};
    return false;
  }
  bool malformed(std::string message) { return error(ErrorKind::malformed, values_.place_of_value(), std::move(message)); }
  bool expected_value(const PlyProperty& property) {
    return malformed(fmt::format("expected a value of {} (element {}, number {} of {}), found {}", shown(property.name), shown(element_->name),
                                 index_ + 1, element_->count, values_.found()));
  }

  const PlyHeader& header_;
  NoteBook notes_;
  Values values_;
  SourceMesh mesh_;
  std::optional<Error> error_;

  const PlyElement* element_ = nullptr;  // at hand
  std::uint64_t index_ = 0;
  std::uint64_t vertex_count_ = 0;
  bool has_vertex_normals_ = false;
  bool has_vertex_uvs_ = false;
  std::size_t first_vertex_uv_ = 0;     // in mesh_.uvs: faces that stand before the vertices may have filled some
  std::vector<std::uint32_t> indices_;  // of the face or strips at hand
  std::vector<float> texcoords_;
};

template <class Values>
Result<SourceMesh> BodyReader<Values>::read() {
  bool is_good = check_counts();
  for (std::size_t i = 0; is_good && i < header_.elements.size(); ++i) {
    is_good = read_element(header_.elements[i]);
  }
  if (!is_good) {
    return tl::unexpected(std::move(*error_));
  }
  finish();
  return std::move(mesh_);
}

// Faces may stand before the vertices, so the number of vertices is settled first.
template <class Values>
bool BodyReader<Values>::check_counts() {
  bool has_vertices = false;
  for (const PlyElement& element : header_.elements) {
    const bool is_vertex = element.name == "vertex";
    if ((is_vertex || element.name == "face") && element.count > kMostElements) {
      return error(ErrorKind::limit, values_.place(),
                   fmt::format("the header states {} elements {}, and at most {} are read", element.count, shown(element.name), kMostElements));
    }
    if (is_vertex && has_vertices) {
      return error(ErrorKind::malformed, values_.place(), "the header states the element \"vertex\" twice");
    }
    has_vertices |= is_vertex;
    vertex_count_ = is_vertex ? element.count : vertex_count_;
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::read_element(const PlyElement& element) {
  element_ = &element;
  values_.begin_element();
  const std::size_t least = least_bytes(element, header_.encoding);
  // One byte more than there is: the last number of an ascii body needs nothing behind it.
  if (least != 0 && element.count > (values_.remaining() + 1) / least) {
    return error(ErrorKind::malformed, values_.place(),
                 fmt::format("the header states {} elements {} of {} bytes or more each, but only {} bytes follow", element.count,
                             shown(element.name), least, values_.remaining()));
  }
  if (element.name == "vertex") {
    return read_vertices(element);
  }
  if (least == 0) {
    return true;  // no properties: in the body there is nothing of it
  }
  if (element.name == "face") {
    return read_faces(element);
  }
  if (element.name == "tristrips") {
    return read_strips(element);
  }
  return skip_element(element);
}

template <class Values>
bool BodyReader<Values>::read_vertices(const PlyElement& element) {
  PlyScalars scalars(element);
  if (!scalars.has_position()) {
    return element.count == 0 || error(ErrorKind::malformed, values_.place(), "the header states no x, y and z of the element \"vertex\"");
  }
  const auto count = static_cast<std::size_t>(element.count);
  has_vertex_normals_ = scalars.has_normal();
  has_vertex_uvs_ = scalars.has_uv();
  first_vertex_uv_ = mesh_.uvs.size();
  mesh_.positions.reserve(count);
  mesh_.normals.reserve(has_vertex_normals_ ? count : 0);
  mesh_.uvs.reserve(first_vertex_uv_ + (has_vertex_uvs_ ? count : 0));
  mesh_.colors.reserve(scalars.has_color() ? count : 0);

  for (index_ = 0; index_ < element.count; ++index_) {
    values_.begin_element();
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      const PlyProperty& property = element.properties[i];
      double value = 0;
      if (property.count_type ? !skip_list(property) : !read_scalar(property, value)) {
        return false;
      }
      scalars.set(i, value);
    }
    values_.end_element();
    mesh_.positions.push_back(scalars.position());
    if (has_vertex_normals_) {
      mesh_.normals.push_back(scalars.normal());
    }
    if (has_vertex_uvs_) {
      mesh_.uvs.push_back(scalars.uv());
    }
    if (scalars.has_color()) {
      mesh_.colors.push_back(scalars.color());
    }
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::read_faces(const PlyElement& element) {
  PlyScalars scalars(element);
  for (index_ = 0; index_ < element.count; ++index_) {
    if (!read_face(element, scalars)) {
      return false;
    }
    if (indices_.size() < 3) {
      notes_.add(values_.line(), "faces with fewer than three corners are dropped");
      continue;
    }
    if (!add_face()) {
      return false;
    }
    if (scalars.has_color()) {
      mesh_.face_colors.resize(mesh_.face_count() - 1, Vec3f{1, 1, 1});
      mesh_.face_colors.push_back(scalars.color());
    }
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::read_face(const PlyElement& element, PlyScalars& scalars) {
  values_.begin_element();
  indices_.clear();
  texcoords_.clear();
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    bool is_good = true;
    if (!property.count_type) {
      double value = 0;
      is_good = read_scalar(property, value);
      scalars.set(i, value);
    } else if (is_ply_index_list(property)) {
      is_good = read_indices(property, false);
    } else if (property.name == "texcoord") {
      is_good = read_texcoords(property);
    } else {
      is_good = skip_list(property);
    }
    if (!is_good) {
      return false;
    }
  }
  values_.end_element();
  return true;
}

template <class Values>
bool BodyReader<Values>::read_strips(const PlyElement& element) {
  for (index_ = 0; index_ < element.count; ++index_) {
    values_.begin_element();
    indices_.clear();
    for (const PlyProperty& property : element.properties) {
      double value = 0;
      const bool is_good = is_ply_index_list(property) ? read_indices(property, true)
                           : property.count_type       ? skip_list(property)
                                                       : read_scalar(property, value);
      if (!is_good) {
        return false;
      }
    }
    values_.end_element();
    if (!add_strips()) {
      return false;
    }
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::skip_element(const PlyElement& element) {
  if (element.count != 0) {
    notes_.add(values_.line(), fmt::format("elements {} are skipped", shown(element.name)), static_cast<std::size_t>(element.count));
  }
  for (index_ = 0; index_ < element.count; ++index_) {
    values_.begin_element();
    for (const PlyProperty& property : element.properties) {
      if (property.count_type ? !skip_list(property) : !values_.skip(property.type, 1)) {
        return error_ ? false : expected_value(property);
      }
    }
    values_.end_element();
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::read_scalar(const PlyProperty& property, double& value) {
  return values_.read(property.type, value) || expected_value(property);
}

template <class Values>
bool BodyReader<Values>::read_count(const PlyProperty& property, std::uint64_t& count) {
  double value = 0;
  if (!values_.read(*property.count_type, value)) {
    return expected_value(property);
  }
  const auto most = static_cast<double>(values_.remaining() + 1);
  if (!(value >= 0 && value <= most) || value != std::floor(value)) {
    return malformed(fmt::format("a list {} of {} entries, and {} bytes follow", shown(property.name), value, values_.remaining()));
  }
  count = static_cast<std::uint64_t>(value);
  return true;
}

template <class Values>
bool BodyReader<Values>::read_indices(const PlyProperty& property, bool may_restart) {
  std::uint64_t count = 0;
  if (!read_count(property, count)) {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    double value = 0;
    if (!read_scalar(property, value)) {
      return false;
    }
    if (may_restart && value == -1) {
      indices_.push_back(kNone);
      continue;
    }
    if (!(value >= 0 && value < static_cast<double>(vertex_count_)) || value != std::floor(value)) {
      return malformed(vertex_count_ == 0 ? fmt::format("vertex index {}, but the header states no vertices", value)
                                          : fmt::format("vertex index {} is outside 0..{}", value, vertex_count_ - 1));
    }
    indices_.push_back(static_cast<std::uint32_t>(value));
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::read_texcoords(const PlyProperty& property) {
  std::uint64_t count = 0;
  if (!read_count(property, count)) {
    return false;
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    double value = 0;
    if (!read_scalar(property, value)) {
      return false;
    }
    texcoords_.push_back(static_cast<float>(value));
  }
  return true;
}

template <class Values>
bool BodyReader<Values>::skip_list(const PlyProperty& property) {
  std::uint64_t count = 0;
  return read_count(property, count) && (values_.skip(property.type, count) || expected_value(property));
}

// The face at hand, of indices_ and texcoords_.
template <class Values>
bool BodyReader<Values>::add_face() {
  const std::size_t corner = mesh_.corner_position.size();
  if (indices_.size() > kMostElements - corner || texcoords_.size() / 2 > kMostElements - mesh_.uvs.size()) {
    return error(ErrorKind::limit, values_.place(), fmt::format("more than {} corners of faces", kMostElements));
  }
  mesh_.corner_position.insert(mesh_.corner_position.end(), indices_.begin(), indices_.end());
  mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
  if (texcoords_.size() == 2 * indices_.size()) {
    mesh_.corner_uv.resize(corner, kNone);
    for (std::size_t i = 0; i < texcoords_.size(); i += 2) {
      mesh_.corner_uv.push_back(static_cast<std::uint32_t>(mesh_.uvs.size()));
      mesh_.uvs.push_back({texcoords_[i], texcoords_[i + 1]});
    }
  } else if (!texcoords_.empty()) {
    notes_.add(values_.line(), "lists texcoord that do not hold two numbers a corner are skipped");
  }
  return true;
}

// Every other triangle of a strip runs the other way round. Triangles that name a vertex twice only lead to where the strip goes on.
template <class Values>
bool BodyReader<Values>::add_strips() {
  const std::vector<std::uint32_t> strips = std::exchange(indices_, {});
  texcoords_.clear();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    if (strips[i] == kNone) {
      begin = i + 1;
      continue;
    }
    if (i < begin + 2) {
      continue;
    }
    const bool is_turned = (i - begin) % 2 == 1;
    const std::uint32_t a = strips[i - (is_turned ? 1 : 2)];
    const std::uint32_t b = strips[i - (is_turned ? 2 : 1)];
    const std::uint32_t c = strips[i];
    if (a != b && b != c && c != a) {
      indices_.assign({a, b, c});
      if (!add_face()) {
        return false;
      }
    }
  }
  return true;
}

template <class Values>
void BodyReader<Values>::finish() {
  values_.begin_element();
  if (values_.remaining() != 0) {
    notes_.add(values_.line(), "data behind the last element are skipped");
  }
  const std::size_t corners = mesh_.corner_position.size();
  if (has_vertex_normals_) {
    mesh_.corner_normal = mesh_.corner_position;
  }
  if (has_vertex_uvs_ || !mesh_.corner_uv.empty()) {
    mesh_.corner_uv.resize(corners, kNone);
    for (std::size_t i = 0; has_vertex_uvs_ && i < corners; ++i) {
      if (mesh_.corner_uv[i] == kNone) {
        mesh_.corner_uv[i] = mesh_.corner_position[i] + static_cast<std::uint32_t>(first_vertex_uv_);
      }
    }
  }
  if (!mesh_.face_colors.empty()) {
    mesh_.face_colors.resize(mesh_.face_count(), Vec3f{1, 1, 1});
    settle_colors(mesh_.face_colors, "face", notes_);
  }
  settle_colors(mesh_.colors, "vertex", notes_);
  mesh_.format = ply_format_name(header_.encoding);
  mesh_.notes = notes_.notes();
}

}  // namespace

Result<SourceMesh> parse_ply(std::string_view bytes, const std::string& file) {
  if (std::optional<PlainMesh> plain = read_plain_ply(ByteSource(bytes), false, 0)) {
    return to_source(*std::move(plain));
  }
  return parse_any_ply(bytes, file);
}

Result<SourceMesh> parse_any_ply(std::string_view bytes, const std::string& file) {
  const Result<PlyHeader> header = parse_ply_header(bytes, file);
  if (!header) {
    return tl::unexpected(header.error());
  }
  constexpr bool kIsLittle = std::endian::native == std::endian::little;
  switch (header->encoding) {
    case PlyEncoding::ascii:
      return BodyReader<PlyTextValues>(bytes, *header, file).read();
    case PlyEncoding::little_endian:
      return BodyReader<PlyByteValues<!kIsLittle>>(bytes, *header, file).read();
    case PlyEncoding::big_endian:
      return BodyReader<PlyByteValues<kIsLittle>>(bytes, *header, file).read();
  }
  return fail(ErrorKind::unsupported, file, "has an unknown encoding");
}

}  // namespace lustro
