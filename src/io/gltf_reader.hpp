// Typed reading of a glTF document. The first thing that is wrong is kept with its JSON path; what is read after it is a default, so that the
// code that reads has no branches for errors and asks once, at its end.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "lustro/result.hpp"

namespace lustro {

/// An index that is not stated.
inline constexpr std::uint32_t kGltfNone = 0xFFFFFFFFU;

/// What a whole number may be.
struct WholeRange {
  std::uint64_t lower = 0;
  std::uint64_t upper = std::uint64_t{1} << 53U;  ///< what a double still counts
};

/// What a number may be; it is finite as a float, too.
struct NumberRange {
  double lower = -3.4028234663852886e38;
  double upper = 3.4028234663852886e38;
};

class GltfReader {
 public:
  using Json = nlohmann::json;

  /// root  stays where it is while it is read
  explicit GltfReader(const Json& root) : root_(root) {}

  [[nodiscard]] bool failed() const { return error_.has_value(); }
  /// `where` is the JSON path.
  [[nodiscard]] const Error& error() const { return *error_; }

  /// Keeps the error, unless there is one already. `place` is a value of the document.
  void fail(const Json& place, std::string message, ErrorKind kind = ErrorKind::malformed);
  /// The same at a key, which the table may lack.
  void fail(const Json& table, std::string_view key, std::string message, ErrorKind kind = ErrorKind::malformed);

  /// The value of a key; nullptr where the table lacks it.
  [[nodiscard]] static const Json* find(const Json& table, std::string_view key);

  /// A table, a list; an empty one where the key is absent.
  [[nodiscard]] const Json& table(const Json& parent, std::string_view key);
  [[nodiscard]] const Json& list(const Json& parent, std::string_view key);
  /// As list(), of tables alone.
  [[nodiscard]] const Json& tables(const Json& parent, std::string_view key);
  /// The table that an extension states here; nullptr where it states none.
  [[nodiscard]] const Json* extension(const Json& parent, std::string_view name);

  [[nodiscard]] std::uint64_t whole(const Json& parent, std::string_view key, const WholeRange& range, std::uint64_t absent);
  [[nodiscard]] std::uint64_t needed_whole(const Json& parent, std::string_view key, const WholeRange& range);
  [[nodiscard]] double number(const Json& parent, std::string_view key, const NumberRange& range, double absent);
  [[nodiscard]] double needed_number(const Json& parent, std::string_view key, const NumberRange& range);
  [[nodiscard]] bool boolean(const Json& parent, std::string_view key, bool absent);
  [[nodiscard]] std::string text(const Json& parent, std::string_view key);

  /// An index below `count`, of things that messages call `what`; kGltfNone where it is absent.
  [[nodiscard]] std::uint32_t index(const Json& parent, std::string_view key, std::size_t count, std::string_view what);
  [[nodiscard]] std::uint32_t needed_index(const Json& parent, std::string_view key, std::size_t count, std::string_view what);
  /// The same of a value itself.
  [[nodiscard]] std::uint32_t index_of(const Json& value, std::size_t count, std::string_view what);

  template <std::size_t N>
  [[nodiscard]] std::array<double, N> numbers(const Json& parent, std::string_view key, const std::array<double, N>& absent,
                                              const NumberRange& range = {}) {
    std::array<double, N> result = absent;
    read_numbers(parent, key, result.data(), N, range);
    return result;
  }

 private:
  void read_numbers(const Json& parent, std::string_view key, double* to, std::size_t count, const NumberRange& range);
  void missing(const Json& parent, std::string_view key, std::string_view expected);
  void expected(const Json& value, std::string_view expected);
  [[nodiscard]] std::uint64_t whole_of(const Json& value, const WholeRange& range);
  [[nodiscard]] double number_of(const Json& value, const NumberRange& range);

  const Json& root_;
  std::optional<Error> error_;
};

}  // namespace lustro
