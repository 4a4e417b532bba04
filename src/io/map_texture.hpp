// What an MTL map statement means for drawing.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "lustro/material.hpp"
#include "texture/slots.hpp"

namespace lustro {

/// A map statement as the use of a texture that is yet to be read.
struct MapUse {
  const TextureSlot* slot = nullptr;
  ReflectionShape shape{};                        ///< of a reflection map
  std::size_t face = 0;                           ///< which of ReflectionMap::faces
  TextureUse use{};                               ///< all but its texture
  bool states_channel = false;                    ///< -imfchan; else the picture decides
  bool may_be_normals = false;                    ///< `bump`: the picture may turn out to be a normal map
  float bump_multiplier = 1, gain = 1, base = 0;  ///< of such a picture, as stated
  char alpha_of_decal = 0;                        ///< of `decal`: the channel that becomes the texture's alpha; 0 is its own alpha
};

/// What else decides over the meaning of a map statement.
struct MapSurroundings {
  bool transparency_is_tr = false;
  Transfer transfer = Transfer::srgb;
  std::optional<int> illumination{};  ///< of the material
};

/// Coordinates: uv' = uv s + o, as three.js and Blender read -s and -o; then v is turned to go down. A map without clamping repeats.
///
///   map_Ka Kd Ks Ke    colours that multiply their coefficient
///   map_Ns, map_d      one value, of the channel that -imfchan states, by default the luminance; of map_d the picture's alpha where it has one
///   map_Tr             1 - map_d (with `transparency_is_tr`: map_d)
///   decal              colour and, as its alpha, the matte or the channel that -imfchan states
///   bump, map_bump     height: (value gain + base) bm
///   norm, map_norm, map_Kn   normals of the tangent frame; -bm multiplies their tilt
///   -clamp on          nothing outside of 0..1
///   disp, map_disp     height along the vertex normal: value gain + base
///   refl, map_refl     -type sphere, or one of the six of a cube; without -type a sphere. Not with an illumination model below 3
///   -blendu off        the nearest texel along u; -blendv along v; with both off no mip levels either
///   -boost x           mip levels finer by x
///   -cc on             nothing more than the scene's transfer does, which decodes colours
///   -mm, -bm, -o, -s   as above; the third number of -o and -s belongs to solid textures
///
/// Not done, and said by `note`: -t, -texres, -imfchan z, -cc where colours are not decoded; all other statements (nothing is returned for
/// these).
/// source  Ramey, Rose, Tyerman, MTL material format, options for texture map statements
[[nodiscard]] std::optional<MapUse> use_of_map(const TextureMap& map, const MapSurroundings& around,
                                               const std::function<void(std::string)>& note);

/// The same of a texture that a scene file states. `once` and wrapping are independent of each other. transfer  of the scene, for the border
[[nodiscard]] MapUse use_of_stated(const StatedTexture& stated, const TextureSlot& slot, Transfer transfer);

/// -bm for normals: their tilt, x and y, is multiplied.
void tilt_normals(TextureUse& use, float factor);

}  // namespace lustro
