// Hashes as text: see hash_text.hpp.
#include "hash_text.hpp"

#include <fmt/format.h>

#include <charconv>

namespace lustro::app {

constexpr std::size_t kDigits = 16;

std::string hash_text(std::uint64_t hash) {
  return fmt::format("{:016x}", hash);
}

Result<std::uint64_t> parse_hash(std::string_view text) {
  std::uint64_t hash = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, fault] = std::from_chars(text.data(), end, hash, 16);
  if (text.size() != kDigits || fault != std::errc() || stop != end) {
    return fail(ErrorKind::usage, "", fmt::format("`{}` is not {} hexadecimal digits, as `lustro hash` prints them", text, kDigits));
  }
  return hash;
}

}  // namespace lustro::app
