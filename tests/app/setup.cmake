# The tests of the command run the very program that is installed; its parts are tested as the library that they are in the build.
add_dependencies(test_app lustro_command)
target_compile_definitions(test_app PRIVATE LUSTRO_COMMAND="$<TARGET_FILE:lustro_command>")
target_link_libraries(test_app PRIVATE lustro_app)
