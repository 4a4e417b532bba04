# `cmake --install`: library, headers, command, CMake package and pkg-config file.
