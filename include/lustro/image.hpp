// Float images: what a renderer makes, what is written and compared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lustro/options.hpp"
#include "lustro/result.hpp"

namespace lustro {

/// width x height pixels of `channels` floats, interleaved, the top row first.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<float> pixels;

  Image() = default;
  Image(int width_, int height_, int channels_)
      : width(width_),
        height(height_),
        channels(channels_),
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) * static_cast<std::size_t>(channels_)) {}

  [[nodiscard]] std::span<float> at(int x, int y) { return {pixels.data() + offset(x, y), static_cast<std::size_t>(channels)}; }
  [[nodiscard]] std::span<const float> at(int x, int y) const { return {pixels.data() + offset(x, y), static_cast<std::size_t>(channels)}; }

 private:
  [[nodiscard]] std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * static_cast<std::size_t>(channels);
  }
};

/// A 64-bit hash of the floats, bit by bit: equal for equal pictures, on every machine. It is XXH64 of the pixels as they lie in memory (32-bit
/// little-endian floats, interleaved, the top row first) with the seed width + height 2^24 + channels 2^48.
[[nodiscard]] std::uint64_t hash_image(const Image& image);

/// One named image of a rendering: the picture's terms, depth, normals, ...
struct Layer {
  std::string name;                   ///< `diffuse`, `normal`, `light:0`, ...
  std::vector<std::string> channels;  ///< as an EXR file names them: {"R","G","B"}, {"X","Y","Z"}, {"Z"}
  Image image;
  std::vector<std::string> labels;  ///< for ids: the name of object or material i
};

/// The key `tone`: how a linear picture becomes one that can be stored. Floats are never toned: Rendering::color, EXR and PFM files are linear.
struct Tone {
  ToneOperator curve = ToneOperator::none;  ///< the key `operator`
  float exposure = 0;                       ///< stops: everything is first multiplied by 2^exposure; -100..100

  friend bool operator==(const Tone&, const Tone&) = default;
};

/// The colour picture (linear, alpha premultiplied) as it is written.
struct WriteOptions {
  int bits = 8;  ///< PNG: 8 or 16
  Transfer transfer = Transfer::srgb;
  Tone tone{};  ///< of pictures of floats that are stored as integers
  /// Of PNG: 0 (none) to 12 (small and slow), as libdeflate counts them. None: 8 bits by a packer of our own, which takes a few milliseconds a
  /// megapixel and makes files of about the size of libdeflate's level 6 on rendered pictures; 16 bits at level 6.
  std::optional<int> png_level{};
  int threads = 0;  ///< that make and pack a PNG, 0: one a core. The bytes do not depend on them
};

/// 8 bits per channel, interleaved, alpha not premultiplied: the very values that a PNG holds (which leaves out an alpha of 1 everywhere).
struct ByteImage {
  int width = 0;
  int height = 0;
  int channels = 0;
  std::vector<std::uint8_t> pixels;
};

/// Stored bytes of a linear, premultiplied RGBA (or RGB, or one-channel) image: unpremultiplied, toned, encoded, round(255 clamp(x, 0, 1)).
[[nodiscard]] ByteImage to_bytes(const Image& image, Transfer transfer, const Tone& tone = {});

/// Writes an image by its extension: .png (8 or 16 bit), .exr or .pfm (float, linear). Under a temporary name in the same folder, then renamed:
/// an existing file is replaced whole or not at all. Equal pixels give equal bytes. An alpha that is stored as 1 everywhere is left out of a
/// PNG; a PFM never has one.
///
/// errors  unsupported for another extension; usage for options out of range or an image of no size; io where the file cannot be written
[[nodiscard]] Result<void> write_image(const std::filesystem::path& file, const Image& image, const WriteOptions& options = {});

/// Writes the bytes of a picture (to_bytes(), Rendering::bytes) to a .png, byte for byte the file that the image they were made of becomes.
/// `options.transfer` says what the bytes mean, and should be what they were made with.
///
/// errors  as above; usage for other than 8 bits; unsupported for .exr and .pfm, which hold floats
[[nodiscard]] Result<void> write_image(const std::filesystem::path& file, const ByteImage& image, const WriteOptions& options = {});

/// The colour picture and its layers as one EXR file with named layers (`diffuse.R`, `normal.X`, ...), float, linear. A layer's labels are the
/// file's attribute NAME.labels, a vector of strings.
///
/// errors  usage where a layer has another size than the picture, or two channels one name; io
[[nodiscard]] Result<void> write_exr_layers(const std::filesystem::path& file, const Image& color, std::span<const Layer> layers);

/// Whether a layer holds numbers (depth, normals, ids, ...) and no light: its preview is stored as it stands, with Transfer::none.
[[nodiscard]] bool is_data_layer(const Layer& layer);

/// A layer as a picture that can be looked at, 0..1: depth scaled near = white, normals and positions mapped to 0..1, ids by a colour table;
/// terms and albedo as they are. The background is black. To be written with Transfer::none where is_data_layer() says so.
[[nodiscard]] Image layer_preview(const Layer& layer);

/// Bytes under a temporary name in the same folder, then renamed, with the permissions that the umask leaves. A symbolic link stays one: what it
/// points to is replaced. A device or a pipe is written to.
///
/// errors  io with the system's reason; no half-written file is left
[[nodiscard]] Result<void> write_file_atomically(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// An image file as linear floats, alpha premultiplied. At most 16384 x 16384 pixels. By content first, then by extension. One channel for gray,
/// three for colour, four with alpha.
///
///   PNG        any kind; gAMA and iCCP chunks are not applied          8 and 16 bits are decoded by `transfer`
///   JPEG       baseline, progressive, gray, CMYK; EXIF's orientation is not applied, no profile is
///   WebP       lossy and lossless, no animations
///   TGA, BMP   every kind that is in use: palettes, 8 to 32 bits, packed or not, from either side
///   HDR        Radiance's RGBE: linear                                 floats stand as they are
///   EXR        the colours; layers are not read
///   PFM        three channels or one
///
/// errors  io, malformed, unsupported, limit: each names the file and what is wrong. JPEG and WebP are unsupported in a build without their
///         libraries
[[nodiscard]] Result<Image> read_image(const std::filesystem::path& file, Transfer transfer = Transfer::srgb);

/// How two pictures differ. Both are compared as they would be stored: encoded by `transfer`, clamped to 0..1, over black. Gray counts as three
/// equal channels. Alpha is a fourth channel where it is not 1 everywhere in both; FLIP looks at the colours alone.
struct Comparison {
  double max = 0;   ///< largest absolute difference of a channel
  double mean = 0;  ///< mean absolute difference
  double rmse = 0;
  double psnr = 0;        ///< dB; infinity for equal pictures
  double share_over = 0;  ///< share of pixels in which a channel differs by more than the tolerance
  double flip = 0;        ///< mean FLIP error, 0..1 (Andersson et al. 2020, LDR, 67 pixels a degree)
  Image heatmap;          ///< H x W x 3, linear: FLIP error as a colour
};

/// The same result for any number of threads. A difference of exactly the tolerance is not over it (1e-6 is granted for the way through floats).
///
/// errors  usage where the sizes differ
[[nodiscard]] Result<Comparison> compare_images(const Image& a, const Image& b, double tolerance = 2.0 / 255,
                                                Transfer transfer = Transfer::srgb);

}  // namespace lustro
