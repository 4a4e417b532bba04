# Animations are read back by the libraries' own decoders.
pkg_check_modules(WEBPDEMUX QUIET IMPORTED_TARGET libwebpdemux)
if(WEBPDEMUX_FOUND AND WEBP_FOUND)
  target_link_libraries(test_image PRIVATE PkgConfig::WEBPDEMUX)
  target_compile_definitions(test_image PRIVATE LUSTRO_HAS_WEBPDEMUX)
endif()
