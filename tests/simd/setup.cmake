# The operations of simd/lanes.hpp once a row, as src/raster/row.cpp is compiled.
foreach(row IN LISTS lustro_rows)
  lustro_row_objects_of(lustro_lanes_${row} simd/lanes_probe.cpp ${row})
  target_include_directories(lustro_lanes_${row} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
  target_sources(test_simd PRIVATE $<TARGET_OBJECTS:lustro_lanes_${row}>)
  string(TOUPPER ${row} upper)
  target_compile_definitions(test_simd PRIVATE LUSTRO_HAS_${upper})
endforeach()
