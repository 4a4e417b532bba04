# The tree of scenes that the truth is tested with.
target_sources(test_raster PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/truth/scene_tree.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_parts.cpp
                                   ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_textures.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_variations.cpp)
