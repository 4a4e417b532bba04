// What libc++ lacked before version 15 (Debian's Emscripten brings version 13) of the standard C++20 that Lustro uses. Included in front of
// every source of the build for WebAssembly; with a newer Emscripten it is empty.
#pragma once

#include <algorithm>
#include <bit>
#include <iterator>
#include <type_traits>
#include <utility>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
namespace std {
template <class To, class From>
requires(sizeof(To) == sizeof(From) && is_trivially_copyable_v<To> && is_trivially_copyable_v<From>) [[nodiscard]] constexpr To
    bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
}  // namespace std
#endif

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
namespace std::ranges {
template <class Range, class Predicate>
[[nodiscard]] constexpr bool any_of(const Range& range, Predicate predicate) {
  return std::any_of(std::begin(range), std::end(range), std::move(predicate));
}
template <class Range, class Predicate>
[[nodiscard]] constexpr bool all_of(const Range& range, Predicate predicate) {
  return std::all_of(std::begin(range), std::end(range), std::move(predicate));
}
template <class Range, class Value>
[[nodiscard]] constexpr auto find(Range&& range, const Value& value) {
  return std::find(std::begin(range), std::end(range), value);
}
template <class Range, class Value, class Field>
[[nodiscard]] constexpr auto find(Range&& range, const Value& value, Field field) {
  return std::find_if(std::begin(range), std::end(range), [&](const auto& element) { return element.*field == value; });
}
template <class Range, class Output, class Function>
constexpr void transform(const Range& range, Output out, Function function) {
  std::transform(std::begin(range), std::end(range), out, std::move(function));
}
}  // namespace std::ranges
#endif
