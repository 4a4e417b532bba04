# Compiler flags that every target shares.
#
# -ffp-contract=off is part of the promise of equal bits: without it a compiler may fuse a multiplication and an addition on one machine
# and not on the other. It is public to the build, not to users of the library.
function(lustro_flags target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion
                                           -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual -Wdouble-promotion
                                           $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>) # GCC 12 sees overlaps in `"-" + string` (its bug 105651)
  if(LUSTRO_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(LUSTRO_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LUSTRO_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(${target} PRIVATE -fsanitize=${LUSTRO_SANITIZE})
  endif()
  if(LUSTRO_BUILD_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# Builds are repeated far more often than they change.
find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
