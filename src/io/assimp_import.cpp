// assimp's scene, believed in nothing that would make an index point outside. In a build without assimp: nothing is read.
#include "io/assimp_import.hpp"

#ifdef LUSTRO_HAS_ASSIMP
#include <assimp/DefaultIOSystem.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cmath>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "io/limits.hpp"
#include "io/note_book.hpp"
#include "io/text.hpp"

namespace lustro {
namespace {

namespace fs = std::filesystem;
constexpr std::uint32_t kNone = SourceMesh::kNone;
constexpr std::size_t kMostNodes = std::size_t{1} << 20U;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{1} << 30U;
constexpr float kOverAll = 1e30F;  // numbers beyond are no options of a map

std::string upper_case(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  return text;
}

/// Files inside of one folder, for reading.
class ConfinedFiles : public Assimp::DefaultIOSystem {
 public:
  explicit ConfinedFiles(fs::path folder) : folder_(std::move(folder)) {}

  bool Exists(const char* file) const override { return is_inside(file) && DefaultIOSystem::Exists(file); }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    return mode != nullptr && mode[0] == 'r' && std::string_view(mode).find('+') == std::string_view::npos && is_inside(file)
               ? DefaultIOSystem::Open(file, mode)
               : nullptr;
  }

 private:
  [[nodiscard]] bool is_inside(const char* file) const {
    std::error_code error;
    const fs::path real = fs::weakly_canonical(fs::absolute(file, error), error);
    if (error) {
      return false;
    }
    const auto [in_folder, rest] = std::mismatch(folder_.begin(), folder_.end(), real.begin(), real.end());
    return in_folder == folder_.end();
  }
  fs::path folder_;
};

Color color_of(const aiMaterial& from, const char* key, const Color& otherwise) {
  aiColor3D color;
  if (from.Get(key, 0, 0, color) != aiReturn_SUCCESS || !std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) {
    return otherwise;
  }
  return {{std::max(color.r, 0.0F), std::max(color.g, 0.0F), std::max(color.b, 0.0F)}, ColorSpace::encoded};
}

float value_of(const aiMaterial& from, const char* key, float low, float high, float otherwise) {
  float value = 0;
  return from.Get(key, 0, 0, value) == aiReturn_SUCCESS && std::isfinite(value) ? std::clamp(value, low, high) : otherwise;
}

/// A map as an MTL file states it, of the first picture of that kind.
void add_map(const aiMaterial& from, aiTextureType type, const char* statement, Color* color, NoteBook& notes, Material& material) {
  const auto is_stated = [&](const TextureMap& map) { return map.statement == statement; };
  aiString file;
  if (from.GetTextureCount(type) == 0 || std::ranges::any_of(material.maps, is_stated) || from.GetTexture(type, 0, &file) != aiReturn_SUCCESS) {
    return;
  }
  TextureMap map;
  map.statement = statement;
  map.file = to_utf8(file.C_Str());
  if (map.file.empty() || map.file.starts_with('*')) {
    notes.add(0, "pictures inside of the file are not read");
    return;
  }
  aiUVTransform uv;
  if (from.Get("$tex.uvtrafo", static_cast<unsigned>(type), 0, uv) == aiReturn_SUCCESS) {
    const auto is_small = [](const aiVector2D& v) { return std::abs(v.x) < kOverAll && std::abs(v.y) < kOverAll; };  // false for NaN
    if (is_small(uv.mScaling) && is_small(uv.mTranslation)) {
      map.scale = {uv.mScaling.x, uv.mScaling.y, 1};
      map.offset = {uv.mTranslation.x, uv.mTranslation.y, 0};
    }
    if (uv.mRotation != 0) {
      notes.add(0, "pictures are not turned on the surface");
    }
  }
  material.maps.push_back(std::move(map));
  if (color != nullptr) {
    *color = {{1, 1, 1}};
  }
}

Material material_of(const aiMaterial& from, NoteBook& notes) {
  Material material;
  aiString name;
  if (from.Get("?mat.name", 0, 0, name) == aiReturn_SUCCESS) {
    material.name = to_utf8(name.C_Str());
  }
  material.ambient = color_of(from, "$clr.ambient", material.ambient);
  material.diffuse = color_of(from, "$clr.diffuse", material.diffuse);
  material.specular = color_of(from, "$clr.specular", material.specular);
  material.specular.rgb = material.specular.rgb * value_of(from, "$mat.shinpercent", 0, 1, 1);
  material.emission = color_of(from, "$clr.emissive", material.emission);
  material.shininess = value_of(from, "$mat.shininess", 0, 10000, 0);
  material.opacity = value_of(from, "$mat.opacity", 0, 1, 1);
  const auto add = [&](aiTextureType type, const char* statement, Color* color = nullptr) {
    add_map(from, type, statement, color, notes, material);
  };
  add(aiTextureType_AMBIENT, "map_Ka", &material.ambient);
  add(aiTextureType_DIFFUSE, "map_Kd", &material.diffuse);
  add(aiTextureType_BASE_COLOR, "map_Kd", &material.diffuse);
  add(aiTextureType_SPECULAR, "map_Ks", &material.specular);
  add(aiTextureType_EMISSIVE, "map_Ke", &material.emission);
  add(aiTextureType_SHININESS, "map_Ns");
  add(aiTextureType_OPACITY, "map_d");
  add(aiTextureType_HEIGHT, "bump");
  add(aiTextureType_NORMALS, "norm");
  add(aiTextureType_DISPLACEMENT, "disp");
  return material;
}

struct Placed {
  const aiNode* node;
  aiMatrix4x4 matrix;
};

class SceneReader {
 public:
  SceneReader(const aiScene& scene, const std::string& file) : scene_(scene), file_(file), notes_(file) {}

  Result<SourceMesh> read();

 private:
  Result<void> add(const aiMesh& mesh, const aiMatrix4x4& matrix);
  void add_vertices(const aiMesh& mesh, const aiMatrix4x4& matrix);

  const aiScene& scene_;
  const std::string& file_;
  NoteBook notes_;
  SourceMesh mesh_;
  bool has_colors_ = false, has_alphas_ = false, lacks_normals_ = false;
};

void SceneReader::add_vertices(const aiMesh& mesh, const aiMatrix4x4& matrix) {
  const aiMatrix3x3 normal_matrix = aiMatrix3x3(matrix).Inverse().Transpose();
  for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
    const aiVector3D p = matrix * mesh.mVertices[v];
    mesh_.positions.push_back({p.x, p.y, p.z});
    if (mesh.HasNormals()) {
      const aiVector3D n = normal_matrix * mesh.mNormals[v];
      mesh_.normals.push_back({n.x, n.y, n.z});
    }
    if (mesh.HasTextureCoords(0)) {
      mesh_.uvs.push_back({mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y});
    }
    Vec3f color{1, 1, 1};
    float alpha = 1;
    if (mesh.HasVertexColors(0)) {
      const aiColor4D& c = mesh.mColors[0][v];
      const auto channel = [](float x) { return std::isnan(x) ? 1.0F : std::clamp(x, 0.0F, 1.0F); };
      color = {channel(c.r), channel(c.g), channel(c.b)};
      alpha = channel(c.a);
      has_colors_ = true;
      has_alphas_ = has_alphas_ || alpha < 1;
    }
    mesh_.colors.push_back(color);
    mesh_.alphas.push_back(alpha);
  }
}

Result<void> SceneReader::add(const aiMesh& mesh, const aiMatrix4x4& matrix) {
  const std::size_t first = mesh_.positions.size();
  const std::size_t first_normal = mesh_.normals.size();
  const std::size_t first_uv = mesh_.uvs.size();
  if (mesh.mNumVertices > kMostElements - first) {
    return fail(ErrorKind::limit, file_, fmt::format("more than {} vertices", kMostElements));
  }
  add_vertices(mesh, matrix);
  lacks_normals_ = lacks_normals_ || !mesh.HasNormals();
  const bool is_mirrored = aiMatrix3x3(matrix).Determinant() < 0;
  const auto object = static_cast<std::uint32_t>(mesh_.objects.size());
  mesh_.objects.push_back(to_utf8(mesh.mName.C_Str()));
  for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
    const aiFace& face = mesh.mFaces[f];
    if (face.mNumIndices < 3) {
      notes_.add(0, "points and lines are dropped");
      continue;
    }
    if (face.mNumIndices > kMostElements - mesh_.corner_position.size()) {
      return fail(ErrorKind::limit, file_, fmt::format("more than {} corners of faces", kMostElements));
    }
    for (unsigned i = 0; i < face.mNumIndices; ++i) {
      const unsigned index = face.mIndices[is_mirrored ? face.mNumIndices - 1 - i : i];
      if (index >= mesh.mNumVertices) {
        return fail(ErrorKind::malformed, file_, fmt::format("vertex index {} is outside 0..{}", index, mesh.mNumVertices));
      }
      mesh_.corner_position.push_back(static_cast<std::uint32_t>(first + index));
      mesh_.corner_normal.push_back(mesh.HasNormals() ? static_cast<std::uint32_t>(first_normal + index) : kNone);
      mesh_.corner_uv.push_back(mesh.HasTextureCoords(0) ? static_cast<std::uint32_t>(first_uv + index) : kNone);
    }
    mesh_.face_begin.push_back(static_cast<std::uint32_t>(mesh_.corner_position.size()));
    mesh_.face_object.push_back(object);
    mesh_.face_material.push_back(mesh.mMaterialIndex < scene_.mNumMaterials ? mesh.mMaterialIndex : kNone);
  }
  return {};
}

Result<SourceMesh> SceneReader::read() {
  for (unsigned i = 0; i < scene_.mNumMaterials; ++i) {
    mesh_.materials.push_back(material_of(*scene_.mMaterials[i], notes_));
  }
  std::vector<Placed> open;
  if (scene_.mRootNode != nullptr) {
    open.push_back({scene_.mRootNode, scene_.mRootNode->mTransformation});
  }
  for (std::size_t count = 0; !open.empty(); ++count) {
    if (count == kMostNodes) {
      return fail(ErrorKind::limit, file_, fmt::format("more than {} nodes", kMostNodes));
    }
    const Placed placed = open.back();
    open.pop_back();
    for (unsigned i = 0; i < placed.node->mNumMeshes; ++i) {
      if (placed.node->mMeshes[i] < scene_.mNumMeshes) {
        if (const Result<void> added = add(*scene_.mMeshes[placed.node->mMeshes[i]], placed.matrix); !added) {
          return tl::unexpected(added.error());
        }
      }
    }
    for (unsigned i = placed.node->mNumChildren; i-- > 0;) {  // the first comes next
      const aiNode* const child = placed.node->mChildren[i];
      open.push_back({child, placed.matrix * child->mTransformation});
    }
  }
  if (!has_colors_) {
    mesh_.colors.clear();
  }
  if (!has_alphas_) {
    mesh_.alphas.clear();
  }
  mesh_.weld_first = lacks_normals_ && !has_colors_;  // most formats come with vertices of their own for each face
  mesh_.notes = notes_.notes();
  return std::move(mesh_);
}

}  // namespace

bool assimp_reads(const std::filesystem::path& file) {
  try {
    const Assimp::Importer importer;
    return file.has_extension() && importer.IsExtensionSupported(file.extension().string());
  } catch (const std::exception&) {  // no memory, or a name that cannot be said
    return false;
  }
}

Result<SourceMesh> import_by_assimp(const std::filesystem::path& file) {
  const std::string name = file.string();
  try {
    std::error_code error;
    const fs::path real = fs::canonical(file, error);
    if (error) {
      return fail(ErrorKind::io, name, error.message());
    }
    if (fs::file_size(real, error) > kMostBytes) {
      return fail(ErrorKind::limit, name, "is larger than 1 GiB, the most that assimp is given");
    }
    Assimp::Importer importer;
    const std::string extension = real.extension().string();
    if (!importer.IsExtensionSupported(extension)) {
      return fail(ErrorKind::unsupported, name, "is of a format that assimp does not read, either");
    }
    importer.SetIOHandler(new ConfinedFiles(real.parent_path()));  // which the importer deletes
    const aiScene* const scene = importer.ReadFile(real.string(), aiProcess_ValidateDataStructure);
    if (scene == nullptr) {
      return fail(ErrorKind::malformed, name, fmt::format("assimp says: {}", shown(importer.GetErrorString())));
    }
    Result<SourceMesh> mesh = SceneReader(*scene, name).read();
    if (mesh) {
      mesh->format = upper_case(extension.substr(1)) + ", by assimp";
    }
    return mesh;
  } catch (const std::bad_alloc&) {
    return fail(ErrorKind::limit, name, "needs more memory than there is");
  } catch (const std::exception& problem) {
    return fail(ErrorKind::malformed, name, fmt::format("assimp says: {}", problem.what()));
  }
}

}  // namespace lustro
#else
namespace lustro {

bool assimp_reads(const std::filesystem::path&) {
  return false;
}

Result<SourceMesh> import_by_assimp(const std::filesystem::path& file) {
  return fail(ErrorKind::unsupported, file.string(), "is read by assimp alone, which this build of Lustro is without");
}

}  // namespace lustro
#endif
