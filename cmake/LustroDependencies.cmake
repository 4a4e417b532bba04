# What Lustro takes from others; the reasons stand in docs/design/dependencies.md.
find_package(PkgConfig REQUIRED)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenEXR 3 REQUIRED)
find_package(FastFloat REQUIRED)
pkg_check_modules(SPNG REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)

# Without these two the library makes no animations of their kinds, and says so.
pkg_check_modules(WEBP IMPORTED_TARGET libwebpmux libwebp)
pkg_check_modules(GIF IMPORTED_TARGET libgif)

add_library(lustro_public_dependencies INTERFACE)
target_link_libraries(lustro_public_dependencies INTERFACE tl::expected)

# Headers alone are needed only to build the library itself; what is linked is needed by whoever links it when it is static.
add_library(lustro_private_dependencies INTERFACE)
target_link_libraries(lustro_private_dependencies INTERFACE fmt::fmt TBB::tbb OpenEXR::OpenEXR PkgConfig::SPNG PkgConfig::DEFLATE PkgConfig::FREETYPE
                      $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> $<BUILD_INTERFACE:FastFloat::fast_float>)

foreach(library WEBP GIF)
  if(${library}_FOUND)
    target_link_libraries(lustro_private_dependencies INTERFACE PkgConfig::${library})
    target_compile_definitions(lustro_private_dependencies INTERFACE $<BUILD_INTERFACE:LUSTRO_HAS_${library}>)
  endif()
endforeach()

# The same for pkg-config, by the names of their .pc files; cmake/lustroConfig.cmake.in finds them for CMake.
set(LUSTRO_PKG_CONFIG_REQUIRES fmt tbb OpenEXR spng libdeflate freetype2)
if(WEBP_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES libwebpmux libwebp)
endif()
if(GIF_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES libgif)
endif()
