// A glTF 2.0 document as plain structs (Khronos, glTF 2.0 specification, ISO/IEC 12113:2022): every index is inside its list, every number in
// its range, every accessor inside its view, every view inside its buffer as stated. What the buffers really hold is io/gltf_file.hpp's concern.
#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/gltf_reader.hpp"
#include "lustro/result.hpp"
#include "lustro/texture.hpp"
#include "lustro/vec.hpp"

namespace lustro {

enum class GltfComponent : std::uint16_t { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };
enum class GltfType : std::uint8_t { scalar, vec2, vec3, vec4, mat2, mat3, mat4 };

[[nodiscard]] std::size_t size_of(GltfComponent component);
[[nodiscard]] std::size_t count_of(GltfType type);  ///< of components
[[nodiscard]] std::string_view name_of(GltfType type);
[[nodiscard]] std::string_view name_of(GltfComponent component);

struct GltfBuffer {
  std::uint64_t length = 0;
  const std::string* uri = nullptr;  ///< in the JSON tree; nullptr: the binary chunk, or nothing but a fallback
  bool is_fallback = false;          ///< EXT_meshopt_compression: its bytes are nowhere, and nobody reads them
};

/// EXT_meshopt_compression of a view.
struct GltfMeshopt {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0, count = 0;
  enum class Mode : std::uint8_t { attributes, triangles, indices } mode = Mode::attributes;
  enum class Filter : std::uint8_t { none, octahedral, quaternion, exponential } filter = Filter::none;
};

struct GltfView {
  std::uint32_t buffer = 0;
  std::uint64_t offset = 0, length = 0;
  std::uint64_t stride = 0;  ///< 0: elements follow each other
  std::optional<GltfMeshopt> meshopt{};
};

struct GltfSparse {
  std::uint64_t count = 0;
  std::uint32_t index_view = 0;
  std::uint64_t index_offset = 0;
  GltfComponent index_component = GltfComponent::uint32;
  std::uint32_t value_view = 0;
  std::uint64_t value_offset = 0;
};

struct GltfAccessor {
  std::uint32_t view = kGltfNone;  ///< kGltfNone: zeros
  std::uint64_t offset = 0;
  std::uint64_t count = 0;
  GltfComponent component = GltfComponent::float32;
  GltfType type = GltfType::scalar;
  bool is_normalized = false;
  std::optional<GltfSparse> sparse{};

  [[nodiscard]] std::size_t components() const { return count_of(type); }
  [[nodiscard]] std::size_t element_bytes() const;  ///< columns of matrices begin at multiples of four bytes
};

/// The accessors of a primitive or of one of its morph targets.
struct GltfAttributes {
  std::uint32_t position = kGltfNone, normal = kGltfNone, tangent = kGltfNone, color = kGltfNone;
  std::array<std::uint32_t, 2> uvs{kGltfNone, kGltfNone};
  std::vector<std::uint32_t> joints{}, weights{};  ///< as many
};

enum class GltfMode : std::uint8_t { points, lines, line_loop, line_strip, triangles, triangle_strip, triangle_fan };

/// KHR_draco_mesh_compression of a primitive.
struct GltfDraco {
  struct Attribute {
    std::string name;            ///< `POSITION`
    std::uint32_t accessor = 0;  ///< that states its type and count
    std::uint32_t id = 0;        ///< within the packed mesh
  };
  std::uint32_t view = 0;
  std::vector<Attribute> attributes{};
};

struct GltfPrimitive {
  GltfAttributes attributes{};
  std::uint32_t indices = kGltfNone;
  std::uint32_t material = kGltfNone;
  GltfMode mode = GltfMode::triangles;
  std::vector<GltfAttributes> targets{};
  std::optional<GltfDraco> draco{};
};

struct GltfMesh {
  std::string name;
  std::vector<GltfPrimitive> primitives;
  std::vector<double> weights;  ///< of the morph targets
};

struct GltfNode {
  std::string name;
  std::vector<std::uint32_t> children;
  std::uint32_t mesh = kGltfNone, skin = kGltfNone, camera = kGltfNone, light = kGltfNone;
  std::optional<Mat4> matrix{};
  std::array<double, 3> translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};
  std::vector<double> weights;                                              ///< empty: the mesh's
  std::array<std::uint32_t, 3> instances{kGltfNone, kGltfNone, kGltfNone};  ///< EXT_mesh_gpu_instancing: translations, rotations, scales
  bool is_instanced = false;
};

struct GltfSkin {
  std::uint32_t inverse_bind = kGltfNone;
  std::vector<std::uint32_t> joints;
};

struct GltfCamera {
  std::string name;
  bool is_perspective = true;
  double yfov = 0, ymag = 0, znear = 0;
  std::optional<double> zfar{};
};

/// KHR_lights_punctual.
struct GltfLight {
  std::string name;
  enum class Kind : std::uint8_t { directional, point, spot } kind = Kind::point;
  std::array<double, 3> color{1, 1, 1};
  double intensity = 1;  ///< candela, or lux for a directional light
  std::optional<double> range{};
  double inner = 0, outer = 0;  ///< half angles, radians
};

struct GltfChannel {
  enum class Path : std::uint8_t { translation, rotation, scale, weights } path = Path::translation;
  enum class Interpolation : std::uint8_t { linear, step, cubic } interpolation = Interpolation::linear;
  std::uint32_t node = 0;
  std::uint32_t sampler = 0;
  std::uint32_t input = 0, output = 0;  ///< accessors
};

struct GltfAnimation {
  std::string name;
  std::vector<GltfChannel> channels;
};

/// A texture as a material uses it, by KHR_texture_transform where it is stated.
struct GltfTextureUse {
  std::uint32_t texture = 0;
  std::uint32_t uv_set = 0;
  std::array<float, 6> uv_matrix{1, 0, 0, 0, 1, 0};
  double amount = 1;  ///< `scale` of a normal texture, `strength` of an occlusion texture
};

struct GltfMaterial {
  std::string name;
  std::array<double, 4> base{1, 1, 1, 1};
  double metallic = 1, roughness = 1;
  std::array<double, 3> emissive{0, 0, 0};
  double emissive_strength = 1;
  double ior = 1.5;
  double specular = 1;
  std::array<double, 3> specular_color{1, 1, 1};
  bool is_specular_glossiness = false;  ///< then `base` is the diffuse colour, and these two hold
  std::array<double, 3> glossy_specular{1, 1, 1};
  double glossiness = 1;
  std::optional<GltfTextureUse> base_map{}, metallic_roughness_map{}, normal_map{}, occlusion_map{}, emissive_map{};
  std::optional<GltfTextureUse> specular_map{}, specular_color_map{}, specular_glossiness_map{};
  enum class Alpha : std::uint8_t { opaque, mask, blend } alpha = Alpha::opaque;
  double alpha_cutoff = 0.5;
  bool is_double_sided = false;
  bool is_unlit = false;
};

struct GltfTexture {
  std::uint32_t image = kGltfNone;
  std::uint32_t sampler = kGltfNone;
};

struct GltfImage {
  std::string name;
  const std::string* uri = nullptr;  ///< in the JSON tree; nullptr: in a view
  std::uint32_t view = kGltfNone;
};

struct GltfDocument {
  std::vector<GltfBuffer> buffers;
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<GltfMesh> meshes;
  std::vector<GltfNode> nodes;
  std::vector<GltfSkin> skins;
  std::vector<GltfCamera> cameras;
  std::vector<GltfLight> lights;
  std::vector<GltfAnimation> animations;
  std::vector<GltfMaterial> materials;
  std::vector<GltfTexture> textures;
  std::vector<GltfImage> images;
  std::vector<Sampler> samplers;
  std::vector<std::uint32_t> parents;  ///< N; kGltfNone for a root
  std::vector<std::uint32_t> order;    ///< N; every node behind its parent
  std::vector<std::uint32_t> roots;    ///< what the default scene draws
  Notes notes;                         ///< `where` is a JSON path
  bool has_quantization = false;       ///< KHR_mesh_quantization is declared
};

/// Reads and checks a document.
/// root        stays alive as long as the result
/// has_binary  whether a binary chunk follows it
/// errors      malformed, unsupported (another version, an extension that is required and not known); `where` is the JSON path
[[nodiscard]] Result<GltfDocument> read_gltf_document(const nlohmann::json& root, bool has_binary);

// Its parts, in the order in which they are read: each may rely on the lists before it.
void read_gltf_buffers(GltfReader& reader, const nlohmann::json& root, bool has_binary, GltfDocument& document);  // gltf_buffers.cpp
void read_gltf_materials(GltfReader& reader, const nlohmann::json& root, GltfDocument& document);                 // gltf_surfaces.cpp
void read_gltf_meshes(GltfReader& reader, const nlohmann::json& root, GltfDocument& document);                    // gltf_meshes.cpp
void read_gltf_nodes(GltfReader& reader, const nlohmann::json& root, GltfDocument& document);                     // gltf_nodes.cpp

/// The names of the extensions that are read.
[[nodiscard]] bool is_known_gltf_extension(std::string_view name);

}  // namespace lustro
