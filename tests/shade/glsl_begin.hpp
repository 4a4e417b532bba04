// From here to glsl_end.hpp the compiler reads GLSL (glsl_shim.hpp). No include guard: it opens every shader.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#ifdef __clang__
#pragma clang diagnostic ignored "-Wkeyword-macro"
#endif
#define LUSTRO_GLSL_JOIN2(a, b) a##b
#define LUSTRO_GLSL_JOIN(a, b) LUSTRO_GLSL_JOIN2(a, b)
#define precision using LUSTRO_GLSL_JOIN(Precision, __LINE__) =
#define layout(binding)
#define highp
#define uniform
#define flat
#define in
#define out
#define const static constexpr
#define float Float
