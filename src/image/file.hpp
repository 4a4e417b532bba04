// Whole files in and out. Writing is declared in lustro/image.hpp.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "lustro/result.hpp"

namespace lustro {

/// How many bytes of a file are looked at before the rest is read.
constexpr std::size_t kHeadBytes = 16;

/// All bytes of a file, a pipe or a device.
///
/// accept   called with the first bytes (up to kHeadBytes): an error ends the reading at once, so that /dev/zero is never swallowed
/// errors   io with the system's reason; limit above 8 GiB; what `accept` says
[[nodiscard]] Result<std::vector<std::byte>> read_file_bytes(const std::filesystem::path& file,
                                                             const std::function<Result<void>(std::span<const std::byte>)>& accept);

/// Removes what write_file_atomically() of a process that was killed has left in the folder.
void remove_temporaries(const std::filesystem::path& folder, int process);

}  // namespace lustro
