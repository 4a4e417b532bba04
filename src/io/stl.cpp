// Tells the two kinds of STL apart and reads the binary one.
#include "io/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/stl_ascii.hpp"
#include "io/text.hpp"
#include "parallel/big_memory.hpp"
#include "parallel/slices.hpp"

namespace lustro {

namespace {

constexpr std::size_t kHeaderBytes = 80;
constexpr std::size_t kFirstFacet = kHeaderBytes + 4;
constexpr std::size_t kFacetBytes = 50;

std::uint32_t read_uint32(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return std::endian::native == std::endian::little ? value : __builtin_bswap32(value);
}

Vec3f read_vector(std::string_view bytes, std::size_t at) {
  return {std::bit_cast<float>(read_uint32(bytes, at)), std::bit_cast<float>(read_uint32(bytes, at + 4)),
          std::bit_cast<float>(read_uint32(bytes, at + 8))};
}

// No control bytes but those of text within the first kilobyte.
bool looks_like_text(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 1024);
  return std::all_of(head.begin(), head.end(), [](char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte >= 0x20U && byte != 0x7FU) || (byte >= 0x09U && byte <= 0x0DU);
  });
}

Result<SourceMesh> parse_binary(std::string_view bytes, const std::string& file, int threads) {
  if (bytes.size() < kFirstFacet) {
    return fail(ErrorKind::malformed, at_byte(file, bytes.size()),
                fmt::format("the file ends here: expected ascii STL (solid ...) or {} bytes of a binary header", kFirstFacet));
  }
  const std::size_t count = read_uint32(bytes, kHeaderBytes);
  if (count > kMostElements / 3) {
    return fail(ErrorKind::limit, at_byte(file, kHeaderBytes),
                fmt::format("the header states {} facets, and at most {} are read", count, kMostElements / 3));
  }
  const std::size_t end = kFirstFacet + kFacetBytes * count;
  if (end > bytes.size()) {
    return fail(ErrorKind::malformed, at_byte(file, kHeaderBytes),
                fmt::format("the header states {} facets, which need {} bytes, but the file has {}", count, end, bytes.size()));
  }
  NoteBook notes(file);
  if (end < bytes.size()) {
    notes.add(0, fmt::format("{} bytes behind the {} facets that the header states are ignored", bytes.size() - end, count));
  }
  SourceMesh mesh;
  mesh.format = "STL (binary)";
  mesh.weld_first = true;
  mesh.notes = notes.notes();
  resize_big(mesh.positions, 3 * count);
  resize_big(mesh.corner_position, 3 * count);
  resize_big(mesh.face_begin, count + 1);
  parallel_slices(count, threads, [&](std::size_t begin, std::size_t stop) {
    for (std::size_t facet = begin; facet < stop; ++facet) {
      const std::size_t at = kFirstFacet + kFacetBytes * facet;  // normal, three vertices, two attribute bytes
      for (std::size_t corner = 0; corner < 3; ++corner) {
        mesh.corner_position[3 * facet + corner] = static_cast<std::uint32_t>(3 * facet + corner);
        mesh.positions[3 * facet + corner] = read_vector(bytes, at + 12 * (corner + 1));
      }
      mesh.face_begin[facet + 1] = static_cast<std::uint32_t>(3 * facet + 3);
    }
  });
  return mesh;
}

}  // namespace

bool has_binary_stl_size(std::string_view bytes) {
  return bytes.size() >= kFirstFacet && bytes.size() == kFirstFacet + kFacetBytes * std::size_t{read_uint32(bytes, kHeaderBytes)};
}

bool is_binary_stl(std::string_view bytes) {
  if (has_binary_stl_size(bytes)) {
    return true;
  }
  if (!looks_like_text(bytes)) {
    return true;
  }
  TextCursor text(bytes, {});
  text.skip_space();
  return !same_word(text.word(), "solid");
}

bool is_ascii_stl(std::string_view bytes) {
  if (is_binary_stl(bytes)) {
    return false;
  }
  TextCursor text(bytes, {});
  text.skip_space();
  text.next_line();
  text.skip_space();
  const std::string_view second = text.word();
  return same_word(second, "facet") || same_word(second, "endsolid");
}

Result<SourceMesh> parse_stl(std::string_view bytes, const std::string& file, int threads) {
  return is_binary_stl(bytes) ? parse_binary(bytes, file, threads) : parse_stl_text(bytes, file);
}

}  // namespace lustro
