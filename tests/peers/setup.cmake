# The OpenGL peer is built where Mesa's OSMesa is (Debian: libosmesa6-dev, libgl-dev); else test_peers says that it skips.
find_path(OSMESA_INCLUDE_DIR GL/osmesa.h)
find_library(OSMESA_LIBRARY OSMesa)
if(OSMESA_INCLUDE_DIR AND OSMESA_LIBRARY)
  target_sources(test_peers PRIVATE
    ${CMAKE_CURRENT_SOURCE_DIR}/peers/gl_context.cpp ${CMAKE_CURRENT_SOURCE_DIR}/peers/gl_fixed_function.cpp ${CMAKE_CURRENT_SOURCE_DIR}/peers/gl_glsl.cpp
    ${CMAKE_CURRENT_SOURCE_DIR}/peers/peer_scenes.cpp ${CMAKE_CURRENT_SOURCE_DIR}/peers/picture_difference.cpp
    ${CMAKE_CURRENT_SOURCE_DIR}/truth/evaluate.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/scene_tree.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_parts.cpp
    ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_textures.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_variations.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/world.cpp)
  target_include_directories(test_peers SYSTEM PRIVATE ${OSMESA_INCLUDE_DIR})
  target_compile_definitions(test_peers PRIVATE LUSTRO_HAS_OSMESA LUSTRO_PEERS_DIR="${CMAKE_BINARY_DIR}/peers")
  target_link_libraries(test_peers PRIVATE ${OSMESA_LIBRARY})
endif()

# Mitsuba 3 judges the path tracer where it is installed (scripts/setup mitsuba), else the test says that it skips.
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND AND LUSTRO_BUILD_APP AND embree_FOUND AND NOT LUSTRO_SANITIZE)
  add_test(NAME peers/mitsuba COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/peers/mitsuba_test.py $<TARGET_FILE:lustro_command> ${LUSTRO_SHARED_DIR}/assets)
  set_tests_properties(peers/mitsuba PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 300)
endif()
