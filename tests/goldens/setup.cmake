# The command draws the goldens and compares them; without it the tests skip.
if(TARGET lustro_command)
  add_dependencies(test_goldens lustro_command)
  target_compile_definitions(test_goldens PRIVATE LUSTRO_COMMAND="$<TARGET_FILE:lustro_command>")
endif()
