# Arb::Arb — real ball arithmetic. Serves Arb 2 (Debian's flint-arb beside FLINT 2, or plain arb)
# and FLINT 3, which has Arb inside.
find_path(FLINT_INCLUDE_DIR flint/fmpq.h)
find_library(FLINT_LIBRARY flint)
find_path(ARB_INCLUDE_DIR NAMES flint/arb.h arb.h)
if(ARB_INCLUDE_DIR AND EXISTS ${ARB_INCLUDE_DIR}/flint/arb.h)
  set(ARB_LIBRARY ${FLINT_LIBRARY})
else()
  find_library(ARB_LIBRARY NAMES flint-arb arb)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Arb
  REQUIRED_VARS ARB_LIBRARY ARB_INCLUDE_DIR FLINT_LIBRARY FLINT_INCLUDE_DIR)

if(Arb_FOUND AND NOT TARGET Arb::Arb)
  add_library(Arb::Arb INTERFACE IMPORTED)
  set(_arb_libraries ${ARB_LIBRARY} ${FLINT_LIBRARY})
  list(REMOVE_DUPLICATES _arb_libraries)
  target_link_libraries(Arb::Arb INTERFACE ${_arb_libraries})
  target_include_directories(Arb::Arb SYSTEM INTERFACE ${ARB_INCLUDE_DIR} ${FLINT_INCLUDE_DIR})
endif()
mark_as_advanced(ARB_INCLUDE_DIR ARB_LIBRARY FLINT_INCLUDE_DIR FLINT_LIBRARY)
