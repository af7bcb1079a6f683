# GLPK::GLPK — linear programming.
find_path(GLPK_INCLUDE_DIR glpk.h)
find_library(GLPK_LIBRARY glpk)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GLPK REQUIRED_VARS GLPK_LIBRARY GLPK_INCLUDE_DIR)

if(GLPK_FOUND AND NOT TARGET GLPK::GLPK)
  add_library(GLPK::GLPK INTERFACE IMPORTED)
  target_link_libraries(GLPK::GLPK INTERFACE ${GLPK_LIBRARY})
  target_include_directories(GLPK::GLPK SYSTEM INTERFACE ${GLPK_INCLUDE_DIR})
endif()
mark_as_advanced(GLPK_INCLUDE_DIR GLPK_LIBRARY)
