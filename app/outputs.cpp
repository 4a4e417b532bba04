// Output files: see outputs.hpp.
#include "outputs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "image/decode.hpp"
#include "image/png.hpp"
#include "report.hpp"
#include "scene_input.hpp"

namespace lustro::app {
namespace {

Result<void> check_output(const std::string& output) {
  if (output == kStdout) {
    return stdout_is_terminal() ? Result<void>(fail(ErrorKind::usage, "-o -", "a picture is not written to a terminal; name a file or a pipe"))
                                : Result<void>();
  }
  const std::filesystem::path file(output);
  if (format_of_name(file) == ImageFormat::unknown) {
    return fail(ErrorKind::unsupported, output, "pictures are written as .png, .exr or .pfm, and the name ends in none of them");
  }
  return check_place(output);
}

/// Whether the picture was drawn as bytes, of which nothing but 8-bit PNG can be made.
bool is_bytes(const Rendering& rendering) {
  return rendering.color.pixels.empty();
}

Result<void> write_stdout(const Rendering& rendering, const WriteOptions& options) {
  const Result<std::vector<std::byte>> bytes = is_bytes(rendering) ? encode_png(rendering.bytes, options) : encode_png(rendering.color, options);
  if (!bytes) {
    return tl::unexpected(bytes.error());
  }
  return print({reinterpret_cast<const char*>(bytes->data()), bytes->size()});
}

}  // namespace

void add_png_flags(CLI::App& app, PngFlags& flags, const std::string& group) {
  app.add_option("--bits", flags.bits, "Bits a channel of a PNG: 8 or 16 (default: 8)")->type_name("8|16")->group(group);
  app.add_option("--png-level", flags.png_level,
                 "Compression of PNG by libdeflate, 0 (none) to 12 (small and slow) (default: a fast packer of Lustro's own)")
      ->type_name("N")
      ->group(group);
}

Result<WriteOptions> write_options(const PngFlags& flags, Transfer transfer, int threads, const Tone& tone) {
  if (flags.bits != 8 && flags.bits != 16) {
    return fail(ErrorKind::usage, "--bits", fmt::format("{} is neither 8 nor 16", flags.bits));
  }
  if (flags.png_level && (*flags.png_level < 0 || *flags.png_level > 12)) {
    return fail(ErrorKind::usage, "--png-level", fmt::format("{} is outside 0..12", *flags.png_level));
  }
  return WriteOptions{.bits = flags.bits, .transfer = transfer, .tone = tone, .png_level = flags.png_level, .threads = threads};
}

std::string default_output(const std::string& argument) {
  if (is_primitive(argument)) {
    std::string name = argument.substr(argument.find(':') + 1);
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ':' || c == '/'; }, '-');
    return name + ".png";
  }
  return std::filesystem::path(argument).replace_extension(".png").string();
}

Result<void> check_place(const std::string& output) {
  const std::filesystem::path file(output);
  std::error_code ignored;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
  if (!std::filesystem::exists(folder, ignored)) {
    return fail(ErrorKind::io, output, fmt::format("there is no folder {}", folder.string()));
  }
  if (std::filesystem::is_directory(file, ignored)) {
    return fail(ErrorKind::io, output, "is a folder");
  }
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    return fail(ErrorKind::io, output, fmt::format("the folder {} cannot be written to: {}", folder.string(), std::strerror(errno)));
  }
  return {};
}

Result<void> check_outputs(const std::vector<std::string>& outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (std::find(outputs.begin(), outputs.begin() + static_cast<std::ptrdiff_t>(i), outputs[i]) !=
        outputs.begin() + static_cast<std::ptrdiff_t>(i)) {
      return fail(ErrorKind::usage, "-o", fmt::format("{} is named twice", outputs[i]));
    }
    if (const Result<void> checked = check_output(outputs[i]); !checked) {
      return checked;
    }
  }
  return {};
}

Result<void> check_default_output(const std::string& output) {
  using namespace std::string_view_literals;
  std::ifstream stream(output, std::ios::binary);
  std::string head(256, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  const bool is_there = stream.gcount() > 0 || std::filesystem::exists(output);
  if (is_there && head.find("tEXtSoftware\0Lustro"sv) == std::string::npos) {
    return fail(ErrorKind::usage, output,
                "is there already and was not drawn by Lustro; -o names another output, or this one if it may be replaced");
  }
  return {};
}

std::string layer_file(const std::string& output, const std::string& layer) {
  std::string name = layer;
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ':' || c == '/' || c == '\\'; }, '-');
  std::filesystem::path file(output);
  const std::string extension = file.extension().string();
  return file.replace_extension("." + name + extension).string();
}

void draw_what_is_written(const std::vector<std::string>& outputs, const PngFlags& flags, RenderOptions& options) {
  const bool only_bytes = flags.bits == 8 && std::all_of(outputs.begin(), outputs.end(), [](const std::string& output) {
                            return output == kStdout || format_of_name(output) == ImageFormat::png;
                          });
  options.store_color = !only_bytes;
  options.store_bytes = only_bytes;
}

std::vector<std::string> rewritable_outputs(const std::vector<std::string>& outputs) {
  std::vector<std::string> files;
  std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(files), [](const std::string& output) {
    std::error_code ignored;
    const std::filesystem::file_status status = std::filesystem::status(output, ignored);
    return output != kStdout && (!std::filesystem::exists(status) || std::filesystem::is_regular_file(status));
  });
  return files;
}

Result<std::vector<std::string>> write_outputs(const std::vector<std::string>& outputs, const Rendering& rendering,
                                               const WriteOptions& options) {
  std::vector<std::string> written;
  const auto write = [&](const std::string& file, const auto& write_file) -> Result<void> {
    Result<void> done = write_file();
    if (done) {
      written.push_back(file);
    }
    return done;
  };
  for (const std::string& output : outputs) {
    if (output == kStdout) {
      if (const Result<void> done = write(output, [&] { return write_stdout(rendering, options); }); !done) {
        return tl::unexpected(done.error());
      }
      continue;
    }
    const ImageFormat format = format_of_name(output);
    if (format == ImageFormat::exr) {
      if (const Result<void> done = write(output, [&] { return write_exr_layers(output, rendering.color, rendering.layers); }); !done) {
        return tl::unexpected(done.error());
      }
      continue;
    }
    const auto write_picture = [&] {
      return is_bytes(rendering) ? write_image(output, rendering.bytes, options) : write_image(output, rendering.color, options);
    };
    if (const Result<void> done = write(output, write_picture); !done) {
      return tl::unexpected(done.error());
    }
    for (const Layer& layer : rendering.layers) {
      const std::string file = layer_file(output, layer.name);
      const auto write_layer = [&] {
        // A PNG is looked at, a PFM is measured: the one shows the layer, the other holds its numbers.
        if (format != ImageFormat::png) {
          return write_image(file, layer.image, options);
        }
        WriteOptions preview = options;
        preview.tone = {};  // it is of the whole: what is toned part by part sums to something else
        if (is_data_layer(layer)) {
          preview.transfer = Transfer::none;  // 0.5 of a number is 0.5 of the range, no light to be encoded
        }
        return write_image(file, layer_preview(layer), preview);
      };
      if (const Result<void> done = write(file, write_layer); !done) {
        return tl::unexpected(done.error());
      }
    }
  }
  return written;
}

}  // namespace lustro::app
