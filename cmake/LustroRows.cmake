# The rows of kernels: src/raster/row.cpp once for each instruction set of this processor family, with Highway's vectors fixed to it.
#
# A row's object may not leak inline functions to the rest of the program, or a machine without its instructions could run them:
# scripts/check_image_path looks for that.
set(lustro_row_objects "")
set(lustro_row_flags_scalar -DHWY_COMPILE_ONLY_SCALAR)
set(lustro_row_flags_sse4 -msse4.2 -mpclmul -maes)
set(lustro_row_flags_avx2 -mavx2 -mbmi -mbmi2 -mfma -mf16c -mlzcnt -mpclmul -maes)
set(lustro_row_flags_avx512 ${lustro_row_flags_avx2} -mavx512f -mavx512cd -mavx512bw -mavx512dq -mavx512vl -mprefer-vector-width=512)
set(lustro_row_flags_neon -march=armv8-a+crypto) # Highway asks for AES, which no kernel uses
set(lustro_row_flags_wasm -msimd128)

if(EMSCRIPTEN)
  set(lustro_rows scalar wasm)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64)$")
  set(lustro_rows scalar sse4 avx2 avx512)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64)$")
  set(lustro_rows scalar neon)
else()
  set(lustro_rows scalar)
endif()
set(LUSTRO_ROWS "" CACHE STRING "The rows to build, where a build shall be quick; empty: all of the processor's")
if(LUSTRO_ROWS)
  set(lustro_rows ${LUSTRO_ROWS})
endif()

# Compiles a source for a row.
function(lustro_row_objects_of library source row)
  add_library(${library} OBJECT ${source})
  lustro_flags(${library})
  target_include_directories(${library} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${library} PRIVATE lustro_public_dependencies lustro_row_dependencies)
  target_compile_definitions(${library} PRIVATE LUSTRO_ROW=${row})
  target_compile_options(${library} PRIVATE ${lustro_row_flags_${row}})
  target_compile_options(${library} PRIVATE $<$<NOT:$<CONFIG:Release,RelWithDebInfo,MinSizeRel>>:-O2>) # what is not inlined would leak
  if(NOT row STREQUAL scalar)
    target_compile_definitions(${library} PRIVATE HWY_COMPILE_ONLY_STATIC)
  endif()
endfunction()

foreach(row IN LISTS lustro_rows)
  set(library lustro_row_${row})
  lustro_row_objects_of(${library} src/raster/row.cpp ${row})
  set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  list(APPEND lustro_row_objects $<TARGET_OBJECTS:${library}>)
  string(TOUPPER ${row} upper)
  set_property(SOURCE src/raster/target.cpp APPEND PROPERTY COMPILE_DEFINITIONS LUSTRO_HAS_${upper})
endforeach()
