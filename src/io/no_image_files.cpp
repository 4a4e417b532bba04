// In the place of image/decode.cpp and image/file.cpp where the core stands alone, without the libraries that image files take.
#include "image/decode_texture.hpp"
#include "image/file.hpp"
#include "lustro/image.hpp"

namespace lustro {

Result<Image> decode_texture_image(std::span<const std::byte> /*bytes*/, const std::string& where, TextureContent /*content*/,
                                   Transfer /*transfer*/, const ImageLimits& /*limits*/) {
  return fail(ErrorKind::unsupported, where, "is a picture in a file, and the core alone reads none");
}

Result<std::vector<std::byte>> read_file_bytes(const std::filesystem::path& file,
                                               const std::function<Result<void>(std::span<const std::byte>)>& /*accept*/) {
  return fail(ErrorKind::unsupported, file.string(), "the core alone reads no such files");
}

Result<void> write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> /*bytes*/) {
  return fail(ErrorKind::unsupported, file.string(), "the core alone writes no files");
}

}  // namespace lustro
