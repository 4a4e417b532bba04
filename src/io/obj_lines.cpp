// A line is read at full speed until something unusual is met; then it is taken back.
#include "io/obj_lines.hpp"

#include <fast_float/fast_float.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "io/fast_numbers.hpp"
#include "io/text.hpp"

namespace lustro {

namespace {

/// So many bytes to a piece at least, on average: a text that changes its form with every line is read as what it is, and takes little memory.
constexpr std::size_t kLeastBytes = 256;

constexpr std::int64_t kNoNeed = std::numeric_limits<std::int64_t>::min();

bool is_space(char c) {
  return c == ' ' || c == '\t';
}

void skip_spaces(const char*& p) {
  while (is_space(*p)) {
    ++p;
  }
}

/// Whether the line end at p might join the lines: a backslash stands before it.
bool may_be_joint(const char* begin, const char* p) {
  const char* const before = p != begin && p[-1] == '\r' ? p - 1 : p;
  return before != begin && before[-1] == '\\';
}

/// As TextCursor counts them: LF, CRLF and lone CR, joining lines or not.
std::size_t count_line_ends(const char* begin, const char* end) {
  std::size_t count = 0;
  for (const char* p = begin; p != end; ++p) {
    count += *p == '\n' || (*p == '\r' && (p + 1 == end || p[1] != '\n')) ? 1U : 0U;
  }
  return count;
}

/// Moves over blanks and the end of the line; false where anything else stands there. The text ends with an end of line.
bool take_line_end(const char*& p) {
  skip_spaces(p);
  if (*p == '\r' && p[1] == '\n') {
    ++p;
  }
  if (*p != '\n' && *p != '\r') {
    return false;
  }
  ++p;
  return true;
}

class PartReader {
 public:
  PartReader(std::string_view text, const char* begin, const char* end, ObjPart& part)
      : text_(text),
        text_end_(text.data() + text.size()),
        at_(begin),
        end_(end),
        part_(part),
        most_pieces_(16 + static_cast<std::size_t>(end - begin) / kLeastBytes) {}

  void read() {
    // The last line of a text may lack its end, without which nothing would stop us.
    const char* closed = end_;
    while (closed != at_ && (closed[-1] != '\n' || may_be_joint(at_, closed - 1))) {
      --closed;
    }
    while (at_ != closed && part_.pieces.size() < most_pieces_) {
      if (!read_line()) {
        leave_line();
      }
    }
    if (at_ != end_) {
      const std::size_t lines = part_.lines + count_line_ends(at_, end_);
      leave(end_);
      part_.lines = lines;
    }
    close_piece();
  }

 private:
  bool read_line() {
    const char* p = at_;
    skip_spaces(p);
    switch (*p) {
      case 'v':
        if (is_space(p[1])) {
          return read_record<3>(p + 2, ObjPiece::vertex, part_.positions);
        }
        if (p[1] == 'n' && is_space(p[2])) {
          return read_record<3>(p + 3, ObjPiece::normal, part_.normals);
        }
        return p[1] == 't' && is_space(p[2]) && read_record<2>(p + 3, ObjPiece::uv, part_.uvs);
      case 'f':
        return is_space(p[1]) && read_face(p + 2);
      case '#':
        while (*p != '\n' && *p != '\r') {
          ++p;
        }
        break;
      default:
        break;
    }
    if (!take_line_end(p)) {
      return false;
    }
    open_piece();
    next_line(p);
    return true;
  }

  bool read_number(const char*& p, float& value) const {
    skip_spaces(p);
    const char* const begin = p;
    if (read_short_float(p, text_end_, value) && (is_space(*p) || *p == '\n' || *p == '\r')) {
      return true;
    }
    p = begin;
    if (*p == '+') {
      return false;
    }
    const auto [stop, code] = fast_float::from_chars(p, end_, value);
    if (code != std::errc() || !(is_space(*stop) || *stop == '\n' || *stop == '\r')) {
      return false;
    }
    p = stop;
    return true;
  }

  template <std::size_t N, class Vector>
  bool read_record(const char* p, ObjPiece::Kind kind, ObjList<Vector>& list) {
    std::array<float, 3> numbers{};
    for (std::size_t i = 0; i < N; ++i) {
      if (!read_number(p, numbers[i])) {
        return false;
      }
    }
    if (!take_line_end(p) && (N == 3 || !read_number(p, numbers[2]) || !take_line_end(p))) {
      return false;
    }
    open_piece();
    if constexpr (N == 3) {
      list.push({numbers[0], numbers[1], numbers[2]});
    } else {
      list.push({numbers[0], numbers[1]});
    }
    ++piece_->records[kind];
    next_line(p);
    return true;
  }

  /// The corners' form is that of the first one.
  bool read_face(const char* p) {
    skip_spaces(p);
    std::int32_t first = 0;
    const char* q = p;
    if (!read_short_integer(q, text_end_, first)) {
      return false;
    }
    if (*q != '/') {
      return read_face_of<false, false>(p, first < 0);
    }
    ++q;
    if (*q == '/') {
      return read_face_of<false, true>(p, first < 0);
    }
    std::int32_t second = 0;
    if (!read_short_integer(q, text_end_, second)) {
      return false;
    }
    return *q == '/' ? read_face_of<true, true>(p, first < 0) : read_face_of<true, false>(p, first < 0);
  }

  template <bool kHasUv, bool kHasNormal>
  bool read_face_of(const char* p, bool is_relative) {
    const std::array<std::size_t, 3> records{part_.positions.size, part_.uvs.size, part_.normals.size};
    std::array<std::int32_t, 3> smallest{};
    std::array<std::int32_t, 3> largest{};
    smallest.fill(std::numeric_limits<std::int32_t>::max());
    largest.fill(std::numeric_limits<std::int32_t>::min());
    std::size_t corners = 0;
    const auto take = [&](ObjPiece::Kind kind) {
      std::int32_t index = 0;
      if (!read_short_integer(p, text_end_, index)) {
        return false;
      }
      ObjList<std::uint32_t>& list = part_.corners[kind];
      list.data[list.size + corners] = static_cast<std::uint32_t>(index + (is_relative ? static_cast<std::int32_t>(records[kind]) : -1));
      smallest[kind] = std::min(smallest[kind], index);
      largest[kind] = std::max(largest[kind], index);
      return true;
    };
    do {
      if (!take(ObjPiece::vertex)) {
        return false;
      }
      if constexpr (kHasUv) {
        if (*p != '/' || !take_slash(p) || !take(ObjPiece::uv)) {
          return false;
        }
      }
      if constexpr (kHasNormal) {
        if constexpr (!kHasUv) {
          if (*p != '/' || !take_slash(p)) {
            return false;
          }
        }
        if (*p != '/' || !take_slash(p) || !take(ObjPiece::normal)) {
          return false;
        }
      }
      ++corners;
      if (!is_space(*p)) {
        break;
      }
      skip_spaces(p);
    } while (*p != '\n' && *p != '\r');
    if (!take_line_end(p) || corners < 3) {
      return false;
    }
    const auto is_good = [&](ObjPiece::Kind kind) { return is_relative ? largest[kind] < 0 : smallest[kind] > 0; };
    if (!is_good(ObjPiece::vertex) || (kHasUv && !is_good(ObjPiece::uv)) || (kHasNormal && !is_good(ObjPiece::normal))) {
      return false;
    }
    open_piece();
    if (piece_->faces != 0 && (piece_->is_relative != is_relative || piece_->names_uvs != kHasUv || piece_->names_normals != kHasNormal)) {
      close_piece();
      open_piece();
    }
    if (piece_->faces == 0) {
      piece_->is_relative = is_relative;
      piece_->names_uvs = kHasUv;
      piece_->names_normals = kHasNormal;
      piece_->first_face_line = part_.lines;
    }
    const auto add = [&](ObjPiece::Kind kind) {
      const std::int64_t farthest = is_relative ? -std::int64_t{smallest[kind]} : std::int64_t{largest[kind]};
      piece_->needed[kind] = std::max(piece_->needed[kind], farthest - static_cast<std::int64_t>(records[kind]));
      part_.corners[kind].size += corners;
    };
    add(ObjPiece::vertex);
    if constexpr (kHasUv) {
      add(ObjPiece::uv);
    }
    if constexpr (kHasNormal) {
      add(ObjPiece::normal);
    }
    part_.face_end.push(static_cast<std::uint32_t>(part_.corners[ObjPiece::vertex].size));
    ++piece_->faces;
    next_line(p);
    return true;
  }

  static bool take_slash(const char*& p) {
    ++p;
    return true;
  }

  void next_line(const char* p) {
    at_ = p;
    ++part_.lines;
  }

  void open_piece() {
    if (piece_ == nullptr || !piece_->is_usual) {
      begin_piece(true);
    }
  }

  void begin_piece(bool is_usual) {
    close_piece();
    piece_ = &part_.pieces.emplace_back();
    piece_->is_usual = is_usual;
    piece_->begin = at_;
    piece_->first_line = part_.lines;
    piece_->first_record = {part_.positions.size, part_.uvs.size, part_.normals.size};
    piece_->first_face = part_.face_end.size;
    piece_->first_corner = part_.corners[ObjPiece::vertex].size;
    piece_->first_uv_corner = part_.corners[ObjPiece::uv].size;
    piece_->first_normal_corner = part_.corners[ObjPiece::normal].size;
    piece_->needed.fill(kNoNeed);
  }

  void close_piece() {
    if (piece_ != nullptr) {
      piece_->end = at_;
      piece_->corners = part_.corners[ObjPiece::vertex].size - piece_->first_corner;
      piece_ = nullptr;
    }
  }

  /// The line at hand, and those that are joined to it.
  void leave_line() {
    TextCursor cursor({text_.data(), static_cast<std::size_t>(end_ - text_.data())}, {.hash_comments = true, .joined_lines = true});
    cursor.go_to(at_, part_.lines);
    cursor.next_line();
    const std::size_t lines = cursor.line();
    leave(cursor.here());
    part_.lines = lines;
  }

  void leave(const char* to) {
    if (piece_ == nullptr || piece_->is_usual) {
      begin_piece(false);
    }
    at_ = to;
  }

  std::string_view text_;
  const char* text_end_;
  const char* at_;
  const char* end_;
  ObjPart& part_;
  std::size_t most_pieces_;
  ObjPiece* piece_ = nullptr;
};

}  // namespace

void ObjPart::clear(std::size_t bytes) {
  // The shortest lines and corners: `v 0 0 0`, `vt 0 0`, `f 1 2 3`, `1`, each with what ends it.
  pieces.clear();
  positions.clear(bytes / 8);
  uvs.clear(bytes / 7);
  normals.clear(bytes / 9);
  for (ObjList<std::uint32_t>& list : corners) {
    list.clear(bytes / 2);
  }
  face_end.clear(bytes / 8);
  lines = 0;
}

ObjEstimate estimate_obj(std::string_view text) {
  constexpr std::size_t kSamples = 256;
  constexpr std::size_t kSampleBytes = 1024;
  if (text.size() < 2 * kSamples * kSampleBytes) {
    return {};
  }
  ObjEstimate sum;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    std::string_view sample = text.substr(text.size() / kSamples * i, kSampleBytes);
    const std::size_t begin = sample.find('\n');
    const std::size_t end = sample.rfind('\n');
    if (begin == end) {
      continue;
    }
    sample = sample.substr(begin + 1, end - begin);
    seen += sample.size();
    while (!sample.empty()) {
      const std::size_t size = sample.find('\n') + 1;
      const std::string_view line = sample.substr(0, size);
      sample.remove_prefix(size);
      if (line.starts_with("v ")) {
        ++sum.positions;
      } else if (line.starts_with("vn ")) {
        ++sum.normals;
      } else if (line.starts_with("vt ")) {
        ++sum.uvs;
      } else if (line.starts_with("f ")) {
        ++sum.faces;
        sum.corners += std::max<std::size_t>(3, static_cast<std::size_t>(std::count(line.begin(), line.end() - 2, ' ')));
        const std::size_t slash = line.find('/');
        sum.names_uvs |= slash != std::string_view::npos && line[slash + 1] != '/';
        sum.names_normals |= slash != std::string_view::npos &&
                             (line[slash + 1] == '/' || line.substr(0, line.find(' ', slash)).find('/', slash + 1) != std::string_view::npos);
      }
    }
  }
  const auto scale = [&](std::size_t& count) {
    const double whole = static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(seen, 1)) * static_cast<double>(text.size());
    count = std::min(static_cast<std::size_t>(whole * 1.1) + (count == 0 ? 0 : 1000), text.size() / 4);
  };
  scale(sum.positions);
  scale(sum.uvs);
  scale(sum.normals);
  scale(sum.faces);
  scale(sum.corners);
  return sum;
}

const char* end_of_obj_part(std::string_view text, const char* begin, std::size_t size) {
  const char* const end = text.data() + text.size();
  if (static_cast<std::size_t>(end - begin) <= size) {
    return end;
  }
  for (const char* p = begin + size; p != end; ++p) {
    p = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
    if (p == nullptr) {
      return end;
    }
    if (!may_be_joint(begin, p)) {
      return p + 1;
    }
  }
  return end;
}

void read_obj_part(std::string_view text, const char* begin, const char* end, ObjPart& part) {
  part.clear(static_cast<std::size_t>(end - begin));
  PartReader(text, begin, end, part).read();
}

}  // namespace lustro
