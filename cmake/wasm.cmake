# Emscripten's own toolchain file, wherever emcc lies: Debian's package emscripten, or an SDK whose emcc is on the path. Programs run under Node.
find_program(EMCC emcc REQUIRED)
find_program(EM_CONFIG em-config REQUIRED)
execute_process(COMMAND ${EM_CONFIG} EMSCRIPTEN_ROOT OUTPUT_VARIABLE EMSCRIPTEN_ROOT_PATH OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)

# Functions report by Result<T>, but what libraries throw is caught: by WebAssembly's own exceptions, which cost nothing where none is thrown.
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -include ${CMAKE_CURRENT_LIST_DIR}/old_libcxx.hpp")

# Debian's emcc looks for its JavaScript parser where Debian's own Node would find it; another Node must be told.
if(EXISTS /usr/share/nodejs/acorn AND NOT DEFINED ENV{NODE_PATH})
  set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)
endif()
