// The budget's account, with its message.
#include "io/texture_budget.hpp"

#include <fmt/format.h>

namespace lustro {

std::optional<Error> TextureBudget::take(const Texture& texture, const std::string& where) {
  const std::uint64_t bytes = texture.byte_count();
  if (bytes > left_) {
    return Error{ErrorKind::limit, where,
                 fmt::format("{} x {} texels with their smaller levels take {} bytes; of the {} that all textures may take together {} are left",
                             texture.width(), texture.height(), bytes, most_, left_)};
  }
  left_ -= bytes;
  return std::nullopt;
}

}  // namespace lustro
