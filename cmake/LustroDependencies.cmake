# What Lustro takes from others; the reasons stand in docs/design/dependencies.md.
find_package(PkgConfig REQUIRED)
find_package(tl-expected REQUIRED)
find_package(fmt REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenEXR 3 REQUIRED)
find_package(FastFloat REQUIRED)
pkg_check_modules(SPNG REQUIRED IMPORTED_TARGET spng)

add_library(lustro_public_dependencies INTERFACE)
target_link_libraries(lustro_public_dependencies INTERFACE tl::expected)

add_library(lustro_private_dependencies INTERFACE)
target_link_libraries(lustro_private_dependencies INTERFACE fmt::fmt nlohmann_json::nlohmann_json TBB::tbb OpenEXR::OpenEXR
                                                            FastFloat::fast_float PkgConfig::SPNG)
