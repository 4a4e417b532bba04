# The tests of the command run the very program that is installed.
add_dependencies(test_app lustro_command)
target_compile_definitions(test_app PRIVATE LUSTRO_COMMAND="$<TARGET_FILE:lustro_command>")
