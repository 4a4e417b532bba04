# Files of assets/ and src/ that the library carries inside itself, so that it needs no data folder at run time.
#
# They are converted at build time, again whenever the file or its converter changes, by CMake itself: no tool is needed that a fresh machine
# lacks. The results lie in generated/, named as sources name them from src/: #include "mesh/teapot.inc".
#
#   lustro_embed_bytes(TARGET FILE OUT)   the file's bytes as a list: inline constexpr unsigned char kText[] = { <newline> #include OUT <newline> };
#   lustro_embed_obj(TARGET FILE OUT)     an OBJ's records as LUSTRO_VERTEX(x, y, z) and LUSTRO_FACE(a, b, c), which the including source defines
set(LUSTRO_GENERATED_DIR ${PROJECT_BINARY_DIR}/generated)

function(lustro_embed converter target file out)
  cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE input)
  set(output ${LUSTRO_GENERATED_DIR}/${out})
  set(script ${PROJECT_SOURCE_DIR}/cmake/${converter})
  add_custom_command(OUTPUT ${output} COMMAND ${CMAKE_COMMAND} -D INPUT=${input} -D OUTPUT=${output} -P ${script}
                     DEPENDS ${input} ${script} COMMENT "Embedding ${file}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
  target_include_directories(${target} PRIVATE ${LUSTRO_GENERATED_DIR})
  set_source_files_properties(${output} PROPERTIES HEADER_FILE_ONLY ON)
endfunction()

function(lustro_embed_bytes target file out)
  lustro_embed(embed_bytes.cmake ${target} ${file} ${out})
endfunction()

function(lustro_embed_obj target file out)
  lustro_embed(embed_obj.cmake ${target} ${file} ${out})
endfunction()

lustro_embed_obj(lustro_core assets/utah_teapot/utah_teapot.obj mesh/teapot.inc)
