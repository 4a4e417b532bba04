// Where a rendering goes: the names after -o, checked before anything is drawn, and the files that they become.
#pragma once

#include <CLI/App.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lustro/image.hpp"
#include "lustro/render.hpp"

namespace lustro::app {

/// `-`: a PNG on standard output.
inline constexpr const char* kStdout = "-";

/// `--bits` and `--png-level`, of every command that writes PNG.
struct PngFlags {
  int bits = 8;
  std::optional<int> png_level;
};

void add_png_flags(CLI::App& app, PngFlags& flags, const std::string& group);

/// errors  usage for a number out of range
[[nodiscard]] Result<WriteOptions> write_options(const PngFlags& flags, Transfer transfer, int threads, const Tone& tone = {});

/// `bunny.png` beside `models/bunny.ply`; `teapot.png` in the current folder for `primitive:teapot`.
[[nodiscard]] std::string default_output(const std::string& argument);

/// Whether all the outputs can be written, as far as can be said before drawing.
/// errors  usage where a name is given twice, unsupported for an extension, io where a folder is missing or may not be written to
[[nodiscard]] Result<void> check_outputs(const std::vector<std::string>& outputs);

/// Whether a file can be written there, as far as can be said before.
/// errors  io
[[nodiscard]] Result<void> check_place(const std::string& output);

/// The default output takes the place of a picture that Lustro drew, never of another file: beside a mesh lie its textures.
/// errors  usage where such a file is there
[[nodiscard]] Result<void> check_default_output(const std::string& output);

/// `out.png` and layer `light:0` make `out.light-0.png`.
[[nodiscard]] std::string layer_file(const std::string& output, const std::string& layer);

/// Asks for the picture as bytes where only such are written, which spares its floats.
void draw_what_is_written(const std::vector<std::string>& outputs, const PngFlags& flags, RenderOptions& options);

/// Those of the outputs that may be written again and again: files, and no pipes, devices or standard output, which would get one picture after
/// another.
[[nodiscard]] std::vector<std::string> rewritable_outputs(const std::vector<std::string>& outputs);

/// Writes the picture and its layers: an .exr holds all layers, .png and .pfm take one file a layer. Returns the names of what was written.
[[nodiscard]] Result<std::vector<std::string>> write_outputs(const std::vector<std::string>& outputs, const Rendering& rendering,
                                                             const WriteOptions& options);

}  // namespace lustro::app
