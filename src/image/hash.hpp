// XXH64, a fast hash of bytes that is published, stable and in every language's library. For telling pictures apart, not for secrets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace lustro {

/// XXH64 of the bytes.
/// source  Collet, xxHash fast digest algorithm, section XXH64 (https://github.com/Cyan4973/xxHash/blob/dev/doc/xxhash_spec.md)
[[nodiscard]] std::uint64_t xxh64(std::span<const std::byte> bytes, std::uint64_t seed);

}  // namespace lustro
