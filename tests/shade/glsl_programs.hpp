// The shaders of src/shade as C++ structs, one for each choice of options that the tests need.
#pragma once

#include "shade/glsl_shim.hpp"

namespace lustro::glsl_programs {

using namespace glsl;

// clang-format off
#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define PHONG
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct PhongFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define BLINN_PHONG
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct BlinnPhongFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define PHONG
#define NORMALIZED
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct NormalizedPhongFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define BLINN_PHONG
#define NORMALIZED
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct NormalizedBlinnPhongFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define EMISSION
#define LAMBERT
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct LambertFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define DIFFUSE
#define CONSTANT
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct ConstantFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define GGX
#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct GgxFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

// Everything that a fragment can do at once.
#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define BLINN_PHONG
#define PHONG_INTERPOLATION
#define POSITION
#define ORTHOGRAPHIC
#define TWO_SIDED
#define FOG
#define SRGB
#include "shade/glsl_begin.hpp"
struct RichFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define PHONG_INTERPOLATION
#define POSITION
#include "shade/glsl_begin.hpp"
struct PhongVertex : BuiltIns {
#include "shade/vertex.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define PHONG
#define GOURAUD
#define PER_VERTEX
#define TWO_SIDED
#include "shade/glsl_begin.hpp"
struct GouraudVertex : BuiltIns {
#include "shade/vertex.glsl"
};
#include "shade/glsl_end.hpp"

#define GOURAUD
#define PER_VERTEX
#define TWO_SIDED
#include "shade/glsl_begin.hpp"
struct GouraudFragment : BuiltIns {
#include "shade/fragment.glsl"
};
#include "shade/glsl_end.hpp"

#define AMBIENT
#define DIFFUSE
#define SPECULAR
#define EMISSION
#define BLINN_PHONG
#define FLAT
#define PER_VERTEX
#define TWO_SIDED
#include "shade/glsl_begin.hpp"
struct FlatVertex : BuiltIns {
#include "shade/vertex.glsl"
};
#include "shade/glsl_end.hpp"
// clang-format on

}  // namespace lustro::glsl_programs
