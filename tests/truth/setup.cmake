# The tree of scenes and the judge in double precision; other test programs may add them too.
target_sources(test_truth PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/truth/evaluate.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/golden_hash.cpp
                                  ${CMAKE_CURRENT_SOURCE_DIR}/truth/scene_tree.cpp
                                  ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_parts.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_textures.cpp ${CMAKE_CURRENT_SOURCE_DIR}/truth/tree_variations.cpp
                                  ${CMAKE_CURRENT_SOURCE_DIR}/truth/world.cpp)
