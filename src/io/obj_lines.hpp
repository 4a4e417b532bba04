// The usual lines of an OBJ, read by many threads at once: a part of the text becomes arrays that do not depend on what stands before it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "lustro/vec.hpp"
#include "parallel/big_memory.hpp"

namespace lustro {

/// Lines of one part that follow each other and are alike.
struct ObjPiece {
  enum Kind : std::size_t { vertex, uv, normal };  ///< of records, and of the indices into them

  bool is_usual = true;        ///< else no line of it has been looked at
  bool is_relative = false;    ///< its faces count back; else their indices are absolute
  bool names_uvs = false;      ///< its faces do
  bool names_normals = false;  ///< its faces do
  const char* begin = nullptr;
  const char* end = nullptr;
  std::size_t first_line = 0;                 ///< of the part, from 0
  std::size_t first_face_line = 0;            ///< of the part, from 0
  std::array<std::size_t, 3> first_record{};  ///< by Kind: in the arrays of the part
  std::array<std::size_t, 3> records{};       ///< by Kind: how many
  std::size_t first_face = 0, faces = 0;      ///< in face_end
  std::size_t first_corner = 0, corners = 0;  ///< of the part
  std::size_t first_uv_corner = 0;            ///< in corners[uv]
  std::size_t first_normal_corner = 0;        ///< in corners[normal]

  /// By Kind: how many records must stand before the part for the piece's indices to be inside of what stands before them.
  std::array<std::int64_t, 3> needed{};
};

/// A list with room for all that a text of known length can state: it grows without a question.
template <class T>
struct ObjList {
  BigArray<T> data;
  std::size_t size = 0;
  std::size_t room = 0;

  void clear(std::size_t most) {
    size = 0;
    if (room < most) {
      data = {};
      data = make_big_array<T>(most);
      room = most;
    }
  }
  void push(const T& value) { data[size++] = value; }
};

/// One part of the text. Used again and again: its memory is touched once.
struct ObjPart {
  std::vector<ObjPiece> pieces;  ///< in their order; together they are the part
  ObjList<Vec3f> positions;
  ObjList<Vec2f> uvs;
  ObjList<Vec3f> normals;
  std::array<ObjList<std::uint32_t>, 3> corners;  ///< by Kind: absolute, or (relative) to the first record of the part; may be negative
  ObjList<std::uint32_t> face_end;                ///< in corners[vertex]
  std::size_t lines = 0;

  void clear(std::size_t bytes);
};

/// What a text holds, about.
struct ObjEstimate {
  std::size_t positions = 0;
  std::size_t uvs = 0;
  std::size_t normals = 0;
  std::size_t faces = 0;
  std::size_t corners = 0;
  bool names_uvs = false;
  bool names_normals = false;
};

/// Looks at lines here and there. So the mesh's arrays are made once and large enough, and need not be moved while they grow; a wrong estimate
/// costs time or addresses, but no memory that is used.
[[nodiscard]] ObjEstimate estimate_obj(std::string_view text);

/// The end of the part that begins at `begin` and is about `size` bytes long: behind an end of line that ends its statement for sure.
[[nodiscard]] const char* end_of_obj_part(std::string_view text, const char* begin, std::size_t size);

/// Reads a part. Usual are records of three plain numbers (`vt`: two or three) and faces whose corners are all of one form; everything else,
/// right or wrong, is left as it stands. text  the whole text; the part's end is where a line ends
void read_obj_part(std::string_view text, const char* begin, const char* end, ObjPart& part);

}  // namespace lustro
