# lustro_embed_text(target file ...): each text file src/FOLDER/FILE becomes FOLDER/FILE.inc, a raw string literal that a .cpp of the target
# may #include.
function(lustro_embed_text target)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded)
  foreach(file IN LISTS ARGN)
    file(READ ${file} text)
    string(REGEX REPLACE "^src/" "" name ${file})
    file(CONFIGURE OUTPUT ${folder}/${name}.inc CONTENT "R\"text(${text})text\"\n" @ONLY)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endforeach()
  target_include_directories(${target} PRIVATE ${folder})
endfunction()

lustro_embed_text(lustro_core src/shade/lighting.glsl src/shade/fog.glsl src/shade/vertex.glsl src/shade/fragment.glsl)
