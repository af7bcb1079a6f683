# CVODE::CVODE — SUNDIALS CVODE with serial vectors and the fixed-point solver: what a non-stiff problem needs.
find_path(CVODE_INCLUDE_DIR cvode/cvode.h)
find_library(CVODE_LIBRARY sundials_cvode)
find_library(CVODE_NVECTOR_LIBRARY sundials_nvecserial)
find_library(CVODE_SOLVER_LIBRARY sundials_sunnonlinsolfixedpoint)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(CVODE
  REQUIRED_VARS CVODE_LIBRARY CVODE_NVECTOR_LIBRARY CVODE_SOLVER_LIBRARY CVODE_INCLUDE_DIR)

if(CVODE_FOUND AND NOT TARGET CVODE::CVODE)
  add_library(CVODE::CVODE INTERFACE IMPORTED)
  target_link_libraries(CVODE::CVODE INTERFACE
    ${CVODE_LIBRARY} ${CVODE_NVECTOR_LIBRARY} ${CVODE_SOLVER_LIBRARY})
  target_include_directories(CVODE::CVODE SYSTEM INTERFACE ${CVODE_INCLUDE_DIR})
endif()
mark_as_advanced(CVODE_INCLUDE_DIR CVODE_LIBRARY CVODE_NVECTOR_LIBRARY CVODE_SOLVER_LIBRARY)
