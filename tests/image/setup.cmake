# PNGs of the command, read by Python's zlib (and by PIL, where it is installed).
find_package(Python3 COMPONENTS Interpreter)
if(Python3_Interpreter_FOUND AND TARGET lustro_command)
  add_test(NAME image/python_reads_png COMMAND ${Python3_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/image/check_png.py $<TARGET_FILE:lustro_command>)
endif()
