# `cmake --install`: library, headers, command, CMake package, pkg-config file, completions and man page.
option(LUSTRO_INSTALL "Make the rules of `cmake --install`" ${PROJECT_IS_TOP_LEVEL})
if(NOT LUSTRO_INSTALL)
  return()
endif()
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/lustro)
get_target_property(library_type lustro TYPE)

# --- library and headers -----------------------------------------------------------------------------------------------------------
# A static library hands its private libraries on to whoever links it; a shared one has linked them already.
set(exported lustro lustro_public_dependencies)
if(library_type STREQUAL "STATIC_LIBRARY")
  list(APPEND exported lustro_private_dependencies)
endif()
set_target_properties(lustro_public_dependencies PROPERTIES EXPORT_NAME public_dependencies)
set_target_properties(lustro_private_dependencies PROPERTIES EXPORT_NAME private_dependencies)
install(TARGETS ${exported} EXPORT lustroTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/lustro DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

# --- find_package(lustro) ------------------------------------------------------------------------------------------------------------
install(EXPORT lustroTargets NAMESPACE lustro:: DESTINATION ${package_dir})
configure_package_config_file(cmake/lustroConfig.cmake.in lustroConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(lustroConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lustroConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/lustroConfigVersion.cmake DESTINATION ${package_dir})

# --- pkg-config ------------------------------------------------------------------------------------------------------------------------
# Nobody links the static library without what it needs, so there it is required openly: `pkg-config --libs lustro` is enough, with and
# without --static.
list(JOIN LUSTRO_PKG_CONFIG_REQUIRES ", " required)
set(pc_requires "")
set(pc_without_file "")
set(pc_requires_private "")
set(pc_libs "-lstdc++ -lm")
if(library_type STREQUAL "STATIC_LIBRARY")
  set(pc_requires "Requires: ${required}")
  # Those that have no file for pkg-config.
  if(meshoptimizer_FOUND)
    string(APPEND pc_without_file " -lmeshoptimizer")
  endif()
  if(embree_FOUND)
    string(APPEND pc_without_file " -lembree3")
  endif()
else()
  set(pc_requires_private "Requires.private: ${required}")
endif()
cmake_path(APPEND pc_libdir "\${prefix}" "${CMAKE_INSTALL_LIBDIR}") # an absolute folder stays as it is
cmake_path(APPEND pc_includedir "\${prefix}" "${CMAKE_INSTALL_INCLUDEDIR}")
# The prefix is where the file lies, so that an installation may be moved and `cmake --install --prefix` be used.
if(IS_ABSOLUTE "${CMAKE_INSTALL_LIBDIR}")
  set(pc_prefix ${CMAKE_INSTALL_PREFIX})
else()
  file(RELATIVE_PATH pc_prefix /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  string(REGEX REPLACE "/$" "" pc_prefix "\${pcfiledir}/${pc_prefix}")
endif()
configure_file(cmake/lustro.pc.in lustro.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/lustro.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# --- the command, what shells complete, its man page -------------------------------------------------------------------------------------
if(NOT LUSTRO_BUILD_APP)
  return()
endif()
file(RELATIVE_PATH library_from_command /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
set_target_properties(lustro_command PROPERTIES INSTALL_RPATH "$ORIGIN/${library_from_command}")
install(TARGETS lustro_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

# The command writes its own completions and man page from its table of options, so they are what was built.
if(CMAKE_CROSSCOMPILING OR NOT EXISTS ${PROJECT_SOURCE_DIR}/app/commands/completions.cpp)
  message(STATUS "Completions and man page are not made here")
  return()
endif()
set(written_dir ${CMAKE_CURRENT_BINARY_DIR}/written)
function(install_what_the_command_writes file destination) # the rest are the command's arguments
  add_custom_command(
    OUTPUT ${written_dir}/${file}
    COMMAND ${CMAKE_COMMAND} -E make_directory ${written_dir}
    COMMAND lustro_command ${ARGN} > ${written_dir}/${file}.part
    COMMAND ${CMAKE_COMMAND} -E rename ${written_dir}/${file}.part ${written_dir}/${file}
    DEPENDS lustro_command
    COMMENT "Writing ${file}"
    VERBATIM)
  set_property(GLOBAL APPEND PROPERTY lustro_written ${written_dir}/${file})
  install(FILES ${written_dir}/${file} DESTINATION ${destination})
endfunction()
install_what_the_command_writes(lustro ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completions bash)
install_what_the_command_writes(_lustro ${CMAKE_INSTALL_DATADIR}/zsh/site-functions completions zsh)
install_what_the_command_writes(lustro.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completions fish)
install_what_the_command_writes(lustro.1 ${CMAKE_INSTALL_MANDIR}/man1 man)
get_property(written GLOBAL PROPERTY lustro_written)
add_custom_target(lustro_written ALL DEPENDS ${written})
