// The version of the library. CMake reads the three numbers from here, so they exist once.
#pragma once

#define LUSTRO_VERSION_MAJOR 0
#define LUSTRO_VERSION_MINOR 1
#define LUSTRO_VERSION_PATCH 0
#define LUSTRO_VERSION "0.1.0"
