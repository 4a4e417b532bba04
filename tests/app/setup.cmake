# The tests of the command run the very program that is installed; its parts are tested as the library that they are in the build.
add_dependencies(test_app lustro_command)
target_compile_definitions(test_app PRIVATE LUSTRO_COMMAND="$<TARGET_FILE:lustro_command>")
target_link_libraries(test_app PRIVATE lustro_app)
# What `lustro lab` holds when it was built with a page: a small one of the tests, in the test program and in a command of its own.
include(LustroEmbedPage)
lustro_embed_page(test_app ${CMAKE_CURRENT_SOURCE_DIR}/app/lab_page)
add_executable(lustro_with_page ${PROJECT_SOURCE_DIR}/app/main.cpp)
lustro_flags(lustro_with_page)
lustro_embed_page(lustro_with_page ${CMAKE_CURRENT_SOURCE_DIR}/app/lab_page)
target_link_libraries(lustro_with_page PRIVATE lustro_app)
add_dependencies(test_app lustro_with_page)
target_compile_definitions(test_app PRIVATE LUSTRO_LAB_COMMAND="$<TARGET_FILE:lustro_with_page>")
