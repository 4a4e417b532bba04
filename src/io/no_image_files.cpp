// In the place of image/decode.cpp where the core stands alone, without the libraries that image files take.
#include "image/decode_texture.hpp"

namespace lustro {

Result<Image> decode_texture_image(std::span<const std::byte> /*bytes*/, const std::string& where, TextureContent /*content*/,
                                   Transfer /*transfer*/, const ImageLimits& /*limits*/) {
  return fail(ErrorKind::unsupported, where, "is a picture in a file, and the core alone reads none");
}

}  // namespace lustro
