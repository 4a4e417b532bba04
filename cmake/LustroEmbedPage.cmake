# A built page inside a program.
#
#   lustro_embed_page(TARGET FOLDER)   TARGET defines lustro::app::embedded_page() with the files of FOLDER, made at build time and again when they change;
#                                      with an empty FOLDER, or one that is not there, the page is empty
function(lustro_embed_page target folder)
  set(files "")
  if(folder)
    file(GLOB_RECURSE files CONFIGURE_DEPENDS LIST_DIRECTORIES false ${folder}/*)
  endif()
  if(NOT files)
    set(folder "")
  endif()
  set(output ${LUSTRO_GENERATED_DIR}/app/${target}_page.cpp)
  set(script ${PROJECT_SOURCE_DIR}/cmake/embed_page.cmake)
  set(header ${PROJECT_SOURCE_DIR}/app/lab_page.hpp)
  # A page that is gone leaves no file that is newer than the table: the list itself is a dependency.
  file(CONFIGURE OUTPUT ${output}.files CONTENT "${files}\n" @ONLY)
  add_custom_command(OUTPUT ${output} COMMAND ${CMAKE_COMMAND} -D FOLDER=${folder} -D OUTPUT=${output} -D HEADER=${header} -P ${script}
                     DEPENDS ${files} ${script} ${output}.files COMMENT "Embedding the page of ${target}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
