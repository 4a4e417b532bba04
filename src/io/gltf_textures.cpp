// See gltf_textures.hpp. Pictures first, in parallel; then what each material makes of them; then the pictures that are made, in parallel.
#include "io/gltf_textures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/gltf_bake.hpp"
#include "io/gltf_pictures.hpp"
#include "io/map_texture.hpp"
#include "parallel/parallel_for.hpp"
#include "scene/add_note.hpp"

namespace lustro {
namespace {

constexpr std::uint64_t kMostBakedTexels = std::uint64_t{1} << 28U;

/// A texture slot of a material, as the document has it.
struct Slot {
  std::string_view key;
  std::optional<GltfTextureUse> GltfMaterial::*use;
  TextureContent content;
};

constexpr Slot kBase{"baseColorTexture", &GltfMaterial::base_map, TextureContent::color};
constexpr Slot kMetallicRoughness{"metallicRoughnessTexture", &GltfMaterial::metallic_roughness_map, TextureContent::data};
constexpr Slot kNormal{"normalTexture", &GltfMaterial::normal_map, TextureContent::data};
constexpr Slot kOcclusion{"occlusionTexture", &GltfMaterial::occlusion_map, TextureContent::data};
constexpr Slot kEmissive{"emissiveTexture", &GltfMaterial::emissive_map, TextureContent::color};
constexpr Slot kSpecular{"specularTexture", &GltfMaterial::specular_map, TextureContent::data};
constexpr Slot kSpecularColor{"specularColorTexture", &GltfMaterial::specular_color_map, TextureContent::color};
constexpr Slot kGlossy{"specularGlossinessTexture", &GltfMaterial::specular_glossiness_map, TextureContent::color};
constexpr std::array kSlots{kBase, kMetallicRoughness, kNormal, kOcclusion, kEmissive, kSpecular, kSpecularColor, kGlossy};

/// Where the roles come from, in the order of GltfRole, and which channels they read.
struct Source {
  Slot slot;
  std::array<bool, 4> channels{};
};
constexpr std::array<Source, kGltfRoles> kSources{{{kBase, {true, true, true, false}},
                                                   {kMetallicRoughness, {false, false, true, false}},
                                                   {kMetallicRoughness, {false, true, false, false}},
                                                   {kSpecular, {false, false, false, true}},
                                                   {kSpecularColor, {true, true, true, false}},
                                                   {kGlossy, {true, true, true, false}},
                                                   {kGlossy, {false, false, false, true}},
                                                   {kOcclusion, {true, false, false, false}}}};

constexpr std::size_t at(GltfRole role) {
  return static_cast<std::size_t>(role);
}

/// Whether a material that is drawn as it is looks at the slot.
bool is_used(const GltfMaterial& material, const Slot& slot) {
  return (material.*slot.use).has_value() && (!material.is_unlit || slot.use == kBase.use) &&
         (slot.use != kMetallicRoughness.use || !material.is_specular_glossiness);
}

GltfTextures::PictureKey key_of(const GltfDocument& document, const GltfTextureUse& use, const Slot& slot, Transfer transfer) {
  return {document.textures[use.texture].image, slot.content, slot.content == TextureContent::color ? transfer : Transfer::none};
}

/// Reads what the cache does not have.
void read_pictures(const GltfFile& file, std::span<const GltfMaterial> materials, const LoadOptions& options, GltfTextures& cache) {
  std::vector<std::pair<const GltfTextures::PictureKey*, GltfPicture*>> jobs;
  for (const GltfMaterial& material : materials) {
    for (const Slot& slot : kSlots) {
      if (!is_used(material, slot)) {
        continue;
      }
      const GltfTextures::PictureKey key = key_of(file.document, *(material.*slot.use), slot, options.transfer);
      if (std::get<0>(key) == kGltfNone) {
        continue;
      }
      const auto [entry, is_new] = cache.pictures.try_emplace(key);
      if (is_new) {
        jobs.emplace_back(&entry->first, &entry->second);
      }
    }
  }
  const auto read = [&](std::size_t i, int threads) {
    const auto& [key, picture] = jobs[i];
    *picture = read_gltf_picture(file, *key, cache.budget.limits(file.image_limits), threads);
  };
  TextureBudget::in_order(jobs.size(), options.threads, read, [&](std::size_t i) {
    const auto& [key, picture] = jobs[i];
    if (!picture->error) {
      picture->error = cache.budget.take(*picture->texture, fmt::format("{}: images[{}]", file.name, std::get<0>(*key)));
    }
    if (picture->error) {
      picture->texture = nullptr;
    }
  });
}

/// A picture that is made, and where it goes.
struct Order {
  std::size_t material = 0;
  std::optional<TextureUse> MaterialTextures::*slot = nullptr;
  std::vector<double> key;
};

/// All that is shared while materials are made.
struct Workshop {
  const GltfFile& file;
  const LoadOptions& options;
  GltfTextures& cache;
  Notes& notes;
  std::map<std::vector<double>, GltfBake> bakes{};
  std::vector<Order> orders{};
};

bool is_same_place(const GltfDocument& document, const GltfTextureUse& a, const GltfTextureUse& b) {
  const auto sampler = [&](const GltfTextureUse& use) {
    const std::uint32_t index = document.textures[use.texture].sampler;
    return index == kGltfNone ? Sampler{} : document.samplers[index];
  };
  const Sampler sa = sampler(a);
  const Sampler sb = sampler(b);
  return a.uv_set == b.uv_set && a.uv_matrix == b.uv_matrix && sa.wrap_u == sb.wrap_u && sa.wrap_v == sb.wrap_v;
}

/// One material on its way.
class Maker {
 public:
  Maker(Workshop& shop, const GltfMaterialUse& use, GltfMaterial stated, std::size_t place)
      : shop_(shop),
        path_(use.material == kGltfNone ? std::string("materials") : fmt::format("materials[{}]", use.material)),
        stated_(std::move(stated)),
        place_(place) {}

  Result<Material> make() {
    for (const Slot& slot : kSlots) {
      if (const Result<void> found = find(slot); !found) {
        return tl::unexpected(found.error());
      }
    }
    material_ = classic_material(stated_, shop_.options.gltf_shading);
    set_opacity();
    if (stated_.is_unlit) {
      set_unlit();
      return std::move(material_);
    }
    fold_what_does_not_vary();
    if (stated_.is_specular_glossiness) {
      drive(GltfTarget::diffuse, {GltfRole::base, GltfRole::glossy_specular});
      drive(GltfTarget::specular, {GltfRole::glossy_specular});
      drive(GltfTarget::shininess, {GltfRole::glossiness});
      drive(GltfTarget::ambient, {GltfRole::base, GltfRole::glossy_specular, GltfRole::occlusion});
    } else {
      drive(GltfTarget::diffuse, {GltfRole::base, GltfRole::metallic});
      drive(GltfTarget::specular, {GltfRole::base, GltfRole::metallic, GltfRole::specular, GltfRole::specular_color});
      drive(GltfTarget::shininess, {GltfRole::roughness});
      drive(GltfTarget::ambient, {GltfRole::base, GltfRole::occlusion});
    }
    set_emission_and_normal();
    return std::move(material_);
  }

 private:
  using Roles = std::vector<GltfRole>;

  /// The picture of a slot; a slot that cannot be had is taken from the material, with a note.
  Result<void> find(const Slot& slot) {
    std::optional<GltfTextureUse>& use = stated_.*slot.use;
    if (!is_used(stated_, slot)) {
      use.reset();
      return {};
    }
    const GltfTextures::PictureKey key = key_of(shop_.file.document, *use, slot, shop_.options.transfer);
    Error error;
    if (std::get<0>(key) == kGltfNone) {
      error = {ErrorKind::unsupported, fmt::format("{}: textures[{}]", shop_.file.name, use->texture), "has no picture of a kind that is read"};
    } else if (use->uv_set > 1) {
      error = {ErrorKind::unsupported, fmt::format("{}: {}", shop_.file.name, path_),
               fmt::format("{} asks for TEXCOORD_{}, and 0 and 1 are read", slot.key, use->uv_set)};
    } else if (const GltfPicture& picture = shop_.cache.pictures.at(key); picture.error) {
      error = *picture.error;
    } else {
      pictures_.emplace_back(slot.use, &picture);
      return {};
    }
    if (shop_.options.strict) {
      return fail(error.kind, error.where, fmt::format("{} ({} of {})", error.message, slot.key, path_));
    }
    add_note(shop_.notes, {error.where, error.message + "; drawn without it"});
    use.reset();
    if (slot.use == kEmissive.use) {
      stated_.emissive = {0, 0, 0};
    }
    return {};
  }

  [[nodiscard]] const GltfPicture* picture(const Slot& slot) const {
    const auto found = std::find_if(pictures_.begin(), pictures_.end(), [&](const auto& entry) { return entry.first == slot.use; });
    return found == pictures_.end() ? nullptr : found->second;
  }

  [[nodiscard]] TextureUse texture_use(const Slot& slot) const {
    const GltfTextureUse& stated = *(stated_.*slot.use);
    const GltfTexture& texture = shop_.file.document.textures[stated.texture];
    TextureUse use;
    use.texture = picture(slot)->texture;
    use.sampler = texture.sampler == kGltfNone ? Sampler{} : shop_.file.document.samplers[texture.sampler];
    use.uv_set = static_cast<std::uint8_t>(stated.uv_set);
    use.uv_matrix = stated.uv_matrix;
    use.name = picture_name(shop_.file.document, texture.image);
    return use;
  }

  void set_opacity() {
    const GltfPicture* base = picture(kBase);
    if (stated_.alpha == GltfMaterial::Alpha::opaque || base == nullptr) {
      return;
    }
    if (base->lowest[3] == base->highest[3]) {
      material_.opacity *= base->lowest[3];
      return;
    }
    material_.textures.opacity = texture_use(kBase);
    material_.textures.opacity->channel = 3;
  }

  void set_unlit() {
    if (picture(kBase) != nullptr) {
      material_.textures.diffuse = texture_use(kBase);
    }
  }

  void set_emission_and_normal() {
    if (picture(kEmissive) != nullptr && material_.emission.rgb != Vec3f{}) {
      material_.textures.emission = texture_use(kEmissive);
    }
    if (picture(kNormal) != nullptr) {
      material_.textures.normal = texture_use(kNormal);
      tilt_normals(*material_.textures.normal, static_cast<float>(stated_.normal_map->amount));
    }
  }

  /// Roles whose channels are the same in all texels become factors.
  void fold_what_does_not_vary() {
    factors_ = surface_of(stated_);
    strength_ = stated_.occlusion_map ? stated_.occlusion_map->amount : 1;
    for (std::size_t i = 0; i < kGltfRoles; ++i) {
      const auto role = static_cast<GltfRole>(i);
      const GltfPicture* from = picture(kSources[i].slot);
      if (from == nullptr || (role == GltfRole::metallic && factors_.metallic == 0)) {
        continue;
      }
      varies_[i] = false;
      for (std::size_t c = 0; c < 4; ++c) {
        varies_[i] = varies_[i] || (kSources[i].channels[c] && from->lowest[c] != from->highest[c]);
      }
      if (!varies_[i]) {
        const std::array<float, 4>& t = from->lowest;
        apply_texel(factors_, role, {widened(t[0]), widened(t[1]), widened(t[2]), widened(t[3])}, strength_);
      }
    }
  }

  static double widened(float value) { return static_cast<double>(value); }

  /// What the roles' pictures say on the whole.
  void apply_average(GltfSurface& surface, GltfRole role) const {
    const Texture& texture = *picture(kSources[at(role)].slot)->texture;
    const std::array<float, 4> t = texture.texel(texture.levels().size() - 1, 0, 0);
    apply_texel(surface, role, {widened(t[0]), widened(t[1]), widened(t[2]), widened(t[3])}, strength_);
  }

  void set_color(GltfTarget target, const std::array<double, 3>& rgb) {
    Color& to = target == GltfTarget::ambient ? material_.ambient : target == GltfTarget::diffuse ? material_.diffuse : material_.specular;
    to = {{static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])}, ColorSpace::linear};
  }

  /// Gives a coefficient its number or its picture.
  void drive(GltfTarget target, Roles roles) {
    if (target == GltfTarget::specular && factors_.metallic == 0 && !varies_[at(GltfRole::metallic)]) {
      std::erase(roles, GltfRole::base);  // the colour of what is no metal has no part in its highlight
    }
    std::erase_if(roles, [&](GltfRole role) { return !varies_[at(role)]; });
    GltfSurface factors = factors_;
    leave_out_what_lies_elsewhere(roles, factors);
    const bool is_straight = roles.size() == 1 && (roles[0] == GltfRole::base || roles[0] == GltfRole::glossy_specular) &&
                             !(roles[0] == GltfRole::glossy_specular && target != GltfTarget::specular);
    if (is_straight) {
      use_picture_itself(target, roles[0], factors);
    } else if (roles.empty() || !order(target, roles, factors)) {
      for (const GltfRole role : roles) {
        apply_average(factors, role);
      }
      set_number(target, factors);
    }
  }

  void set_number(GltfTarget target, const GltfSurface& factors) {
    const ClassicSurface classic = classic_surface(factors);
    if (target == GltfTarget::shininess) {
      material_.shininess = static_cast<float>(classic.shininess);
    } else {
      set_color(target, color_of(classic, target));
    }
  }

  /// Only pictures that lie on the surface as the first one does can be looked at together.
  void leave_out_what_lies_elsewhere(Roles& roles, GltfSurface& factors) {
    if (roles.empty()) {
      return;
    }
    const Slot& leader = kSources[at(roles[0])].slot;
    std::erase_if(roles, [&](GltfRole role) {
      const Slot& slot = kSources[at(role)].slot;
      if (is_same_place(shop_.file.document, *(stated_.*leader.use), *(stated_.*slot.use))) {
        return false;
      }
      apply_average(factors, role);
      add_note(shop_.notes,
               {fmt::format("{}: {}", shop_.file.name, path_),
                fmt::format("its {} lies elsewhere on the surface than its {}: where both count, its average does", slot.key, leader.key)});
      return true;
    });
  }

  /// value = c0 + (c1 - c0) texel
  void use_picture_itself(GltfTarget target, GltfRole role, const GltfSurface& factors) {
    GltfSurface black = factors;
    apply_texel(black, role, {0, 0, 0, 0}, strength_);
    const std::array<double, 3> c0 = color_of(classic_surface(black), target);
    const std::array<double, 3> c1 = color_of(classic_surface(factors), target);
    TextureUse use = texture_use(kSources[at(role)].slot);
    if (c0 == std::array<double, 3>{0, 0, 0}) {
      set_color(target, c1);
    } else {
      set_color(target, {1, 1, 1});
      use.gain = {static_cast<float>(c1[0] - c0[0]), static_cast<float>(c1[1] - c0[1]), static_cast<float>(c1[2] - c0[2])};
      use.base = {static_cast<float>(c0[0]), static_cast<float>(c0[1]), static_cast<float>(c0[2])};
    }
    material_.textures.*slot_of(target) = std::move(use);
  }

  static std::optional<TextureUse> MaterialTextures::*slot_of(GltfTarget target) {
    return target == GltfTarget::ambient    ? &MaterialTextures::ambient
           : target == GltfTarget::diffuse  ? &MaterialTextures::diffuse
           : target == GltfTarget::specular ? &MaterialTextures::specular
                                            : &MaterialTextures::shininess;
  }

  /// Has a picture made; false where too much is made already.
  bool order(GltfTarget target, const Roles& roles, const GltfSurface& factors) {
    const Slot& leader = kSources[at(roles[0])].slot;
    TextureUse use = texture_use(leader);
    GltfBake bake{.target = target, .factors = factors, .occlusion_strength = strength_};
    bake.wrap_u = use.sampler.wrap_u;
    bake.wrap_v = use.sampler.wrap_v;
    if (target == GltfTarget::shininess) {
      set_exponents(roles[0], bake, use);
    } else {
      set_color(target, {1, 1, 1});
    }
    std::vector<double> key{static_cast<double>(target), strength_, bake.shininess_unit, static_cast<double>(bake.wrap_u),
                            static_cast<double>(bake.wrap_v)};
    for (const GltfRole role : roles) {
      const Slot& slot = kSources[at(role)].slot;
      const std::uint32_t image = shop_.file.document.textures[(stated_.*slot.use)->texture].image;
      bake.pictures[at(role)] = picture(slot)->texture;
      key.insert(key.end(), {static_cast<double>(role), static_cast<double>(image)});
      if (const std::string name = picture_name(shop_.file.document, image); use.name.find(name) == std::string::npos) {
        use.name += " + " + name;
      }
    }
    const GltfSurface& f = bake.factors;
    if (target == GltfTarget::shininess) {
      key.insert(key.end(), {f.roughness, f.glossiness, f.is_specular_glossiness ? 1.0 : 0.0});
    } else {
      key.insert(key.end(), {f.metallic, f.ior, f.specular, f.occlusion, f.is_specular_glossiness ? 1.0 : 0.0});
      key.insert(key.end(), f.base.begin(), f.base.end());
      key.insert(key.end(), f.specular_color.begin(), f.specular_color.end());
      key.insert(key.end(), f.glossy_specular.begin(), f.glossy_specular.end());
    }
    key.push_back(shop_.options.transfer == Transfer::none ? 0 : 1);
    if (!shop_.cache.baked.contains(key) && !shop_.bakes.contains(key)) {
      if (shop_.cache.baked_texels + texels_of(bake) > kMostBakedTexels) {
        add_note(shop_.notes, {shop_.file.name, "its materials combine their pictures in too many ways: some count by their average"});
        return false;
      }
      shop_.cache.baked_texels += texels_of(bake);
      shop_.bakes.emplace(key, std::move(bake));
    }
    material_.textures.*slot_of(target) = std::move(use);
    shop_.orders.push_back({place_, slot_of(target), std::move(key)});
    return true;
  }

  /// Exponents are stored in units of the highest, as long as the steps of 16 bits are fine enough; the material's own number is that of the
  /// average roughness, which holds where maps of exponents are left out.
  void set_exponents(GltfRole role, GltfBake& bake, TextureUse& use) {
    constexpr double kFineEnough = 600;
    const GltfPicture& from = *picture(kSources[at(role)].slot);
    GltfSurface smoothest = bake.factors;
    const bool is_gloss = role == GltfRole::glossiness;
    const double extreme = is_gloss ? widened(from.highest[3]) : widened(from.lowest[1]);
    apply_texel(smoothest, role, {extreme, extreme, extreme, extreme}, strength_);
    const double highest = classic_surface(smoothest).shininess;
    bake.shininess_unit = highest > 0 && highest <= kFineEnough ? highest : 1;
    GltfSurface average = bake.factors;
    apply_average(average, role);
    const double typical = std::max(classic_surface(average).shininess, 1.0);
    material_.shininess = static_cast<float>(typical);
    const auto gain = static_cast<float>(bake.shininess_unit / typical);
    use.gain = {gain, gain, gain};
    use.channel = 0;
  }

  Workshop& shop_;
  std::string path_;
  GltfMaterial stated_;
  std::size_t place_;
  Material material_;
  std::vector<std::pair<std::optional<GltfTextureUse> GltfMaterial::*, const GltfPicture*>> pictures_;
  GltfSurface factors_;
  double strength_ = 1;
  std::array<bool, kGltfRoles> varies_{};
};

Result<void> bake_all(Workshop& shop) {
  std::vector<std::pair<std::shared_ptr<const Texture>*, const GltfBake*>> jobs;
  for (const auto& [key, bake] : shop.bakes) {
    jobs.emplace_back(&shop.cache.baked[key], &bake);
  }
  std::vector<std::optional<Error>> errors(jobs.size());
  parallel_jobs(jobs.size(), shop.options.threads, [&](std::size_t i, int threads) {
    Result<std::shared_ptr<const Texture>> made = bake_gltf(*jobs[i].second, threads);
    if (made) {
      *jobs[i].first = *std::move(made);
    } else {
      errors[i] = std::move(made).error();
    }
  });
  for (const std::optional<Error>& error : errors) {
    if (error) {
      return fail(error->kind, shop.file.name, error->message);
    }
  }
  return {};
}

}  // namespace

Result<std::vector<Material>> gltf_materials(const GltfFile& file, std::span<const GltfMaterialUse> uses, const LoadOptions& options,
                                             GltfTextures& cache, Notes& notes) {
  std::vector<GltfMaterial> stated;
  for (const GltfMaterialUse& use : uses) {
    stated.push_back(material_of(file.document, use));
  }
  read_pictures(file, stated, options, cache);
  Workshop shop{file, options, cache, notes};
  std::vector<Material> materials;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    Result<Material> made = Maker(shop, uses[i], std::move(stated[i]), i).make();
    if (!made) {
      return tl::unexpected(std::move(made).error());
    }
    materials.push_back(*std::move(made));
  }
  if (const Result<void> done = bake_all(shop); !done) {
    return tl::unexpected(done.error());
  }
  for (const Order& order : shop.orders) {
    (materials[order.material].textures.*order.slot)->texture = cache.baked.at(order.key);
  }
  return materials;
}

}  // namespace lustro
