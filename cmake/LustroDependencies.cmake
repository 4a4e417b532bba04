# What Lustro takes from others; the reasons stand in docs/design/dependencies.md.
add_library(lustro_public_dependencies INTERFACE) # what our headers include
add_library(lustro_core_dependencies INTERFACE)   # what the core's sources include and link
add_library(lustro_row_dependencies INTERFACE)    # what the rows of kernels include
add_library(lustro_private_dependencies INTERFACE) # all that the library links, and the headers that its sources and tests include

# --- what runs loops ---------------------------------------------------------------------------------------------------------------
set(lustro_threads "")
if(LUSTRO_THREADS STREQUAL "tbb")
  find_package(TBB REQUIRED)
  set(lustro_threads TBB::tbb)
elseif(LUSTRO_THREADS STREQUAL "std")
  find_package(Threads REQUIRED)
  set(lustro_threads Threads::Threads)
  target_compile_definitions(lustro_core_dependencies INTERFACE LUSTRO_THREADS_STD)
elseif(LUSTRO_THREADS STREQUAL "off")
  target_compile_definitions(lustro_core_dependencies INTERFACE LUSTRO_THREADS_OFF)
else()
  message(FATAL_ERROR "LUSTRO_THREADS is \"${LUSTRO_THREADS}\"; known are tbb, std, off")
endif()

# --- the core alone ----------------------------------------------------------------------------------------------------------------
# Its libraries are headers, the same for every processor: a cross compiler is shown these folders, and nothing else of this machine's.
if(LUSTRO_CORE_ONLY)
  set(headers ${PROJECT_BINARY_DIR}/headers)
  file(MAKE_DIRECTORY ${headers})
  foreach(header tl/expected.hpp fmt/format.h nlohmann/json.hpp fast_float/fast_float.h hwy/highway.h)
    cmake_path(GET header PARENT_PATH folder)
    find_path(LUSTRO_${folder}_HEADERS ${header} PATHS /usr/include /usr/local/include REQUIRED NO_CMAKE_FIND_ROOT_PATH
              DOC "The folder that holds ${header}")
    file(CREATE_LINK ${LUSTRO_${folder}_HEADERS}/${folder} ${headers}/${folder} SYMBOLIC)
  endforeach()
  target_include_directories(lustro_public_dependencies SYSTEM INTERFACE ${headers})
  target_compile_definitions(lustro_core_dependencies INTERFACE "FMT_STATIC_THOUSANDS_SEPARATOR=','") # no locales: they are half a megabyte
  target_link_libraries(lustro_core_dependencies INTERFACE ${lustro_threads})

  # Of fmt 9 we know what to compile once; another one is compiled wherever it is included.
  file(STRINGS ${headers}/fmt/core.h version_line REGEX "define FMT_VERSION")
  if(version_line MATCHES "FMT_VERSION 9[0-9][0-9][0-9][0-9]$")
    set(lustro_fmt_source cmake/fmt.cpp)
  else()
    target_compile_definitions(lustro_core_dependencies INTERFACE FMT_HEADER_ONLY)
  endif()
  return()
endif()

# --- the library -------------------------------------------------------------------------------------------------------------------
find_package(PkgConfig REQUIRED)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(OpenEXR 3 REQUIRED)
find_package(FastFloat REQUIRED)
pkg_check_modules(HWY REQUIRED libhwy)
pkg_check_modules(SPNG REQUIRED IMPORTED_TARGET spng)
pkg_check_modules(DEFLATE REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)

# Without these the library makes no animations of their kinds, and reads no pictures of theirs, and says so.
pkg_check_modules(JPEG IMPORTED_TARGET libjpeg)
pkg_check_modules(WEBP IMPORTED_TARGET libwebpmux libwebp)
pkg_check_modules(GIF IMPORTED_TARGET libgif)
pkg_check_modules(EXPAT IMPORTED_TARGET expat) # without it no 3MF

# Without these two it reads no glTF whose meshes they packed, and says so.
pkg_check_modules(DRACO IMPORTED_TARGET draco)
find_package(meshoptimizer CONFIG QUIET)

# Without it there is no path tracer, and the library says so.
if(LUSTRO_WITH_EMBREE STREQUAL "ON")
  find_package(embree 3 REQUIRED)
elseif(LUSTRO_WITH_EMBREE STREQUAL "AUTO")
  find_package(embree 3 QUIET)
endif()

# Off unless asked for: what it reads is not fuzzed by us.
if(LUSTRO_WITH_ASSIMP)
  pkg_check_modules(ASSIMP REQUIRED IMPORTED_TARGET assimp)
endif()

target_link_libraries(lustro_public_dependencies INTERFACE tl::expected)
target_include_directories(lustro_row_dependencies SYSTEM INTERFACE ${HWY_INCLUDE_DIRS})

# Headers alone are needed only to build the library itself; what is linked is needed by whoever links it when it is static.
set(core_libraries fmt::fmt ${lustro_threads} $<BUILD_INTERFACE:nlohmann_json::nlohmann_json> $<BUILD_INTERFACE:FastFloat::fast_float>)
target_link_libraries(lustro_core_dependencies INTERFACE ${core_libraries})
target_link_libraries(lustro_private_dependencies INTERFACE ${core_libraries} OpenEXR::OpenEXR PkgConfig::SPNG PkgConfig::DEFLATE PkgConfig::FREETYPE)

foreach(library JPEG WEBP GIF DRACO ASSIMP)
  if(${library}_FOUND)
    target_link_libraries(lustro_private_dependencies INTERFACE PkgConfig::${library})
    target_compile_definitions(lustro_private_dependencies INTERFACE $<BUILD_INTERFACE:LUSTRO_HAS_${library}>)
  endif()
endforeach()

# Importers belong to the core, where these libraries are linked in a full build only.
if(EXPAT_FOUND)
  foreach(dependencies lustro_core_dependencies lustro_private_dependencies)
    target_link_libraries(${dependencies} INTERFACE PkgConfig::EXPAT PkgConfig::DEFLATE)
  endforeach()
endif()

if(meshoptimizer_FOUND)
  target_link_libraries(lustro_private_dependencies INTERFACE meshoptimizer::meshoptimizer)
  target_compile_definitions(lustro_private_dependencies INTERFACE $<BUILD_INTERFACE:LUSTRO_HAS_MESHOPT>)
endif()

if(embree_FOUND)
  target_link_libraries(lustro_private_dependencies INTERFACE embree)
  target_compile_definitions(lustro_private_dependencies INTERFACE $<BUILD_INTERFACE:LUSTRO_HAS_EMBREE>)
endif()

# The same for pkg-config, by the names of their .pc files; cmake/lustroConfig.cmake.in finds them for CMake.
set(LUSTRO_PKG_CONFIG_REQUIRES fmt OpenEXR spng libdeflate freetype2)
if(LUSTRO_THREADS STREQUAL "tbb")
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES tbb)
endif()
if(JPEG_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES libjpeg)
endif()
if(EXPAT_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES expat)
endif()
if(WEBP_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES libwebpmux libwebp)
endif()
if(GIF_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES libgif)
endif()
if(DRACO_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES draco)
endif()
if(ASSIMP_FOUND)
  list(APPEND LUSTRO_PKG_CONFIG_REQUIRES assimp)
endif()
