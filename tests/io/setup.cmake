# Tests of what needs a library that may be missing.
if(NOT EXPAT_FOUND)
  set(threemf_tests ${test_files})
  list(FILTER threemf_tests INCLUDE REGEX "/(threemf|xml|zip)[a-z_]*_test\\.cpp$")
  set_source_files_properties(${threemf_tests} PROPERTIES HEADER_FILE_ONLY ON)
endif()
