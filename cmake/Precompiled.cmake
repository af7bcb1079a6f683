# Headers of other libraries that most files include, read once for a whole build: most of a file's compile time is
# theirs. Sources still include what they use; the preset `debug` compiles without this (CMAKE_DISABLE_PRECOMPILE_HEADERS)
# and so shows an include that is missing.
set(stickslip_precompiled_source ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)

# stickslip_precompiled(NAME HEADERS… LIBRARIES…): a set of headers.
function(stickslip_precompiled name)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES" ${ARGN})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${stickslip_precompiled_source})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

set(stickslip_common_headers <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <set> <sstream> <string>
    <utility> <vector> <Eigen/Core> <fmt/format.h> <ginac/ginac.h>)
set(stickslip_common_libraries stickslip::options Eigen3::Eigen fmt::fmt PkgConfig::GINAC)
stickslip_precompiled(stickslip_headers HEADERS ${stickslip_common_headers} LIBRARIES ${stickslip_common_libraries})

# stickslip_precompile(TARGET…): these are compiled with them.
function(stickslip_precompile)
  foreach(target IN LISTS ARGN)
    target_precompile_headers(${target} REUSE_FROM stickslip_headers)
  endforeach()
endfunction()

# What computes nothing itself (statements, pages, tests) compiles in half the time with less optimisation.
set(stickslip_light $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>) # GCC 12 warns of its own library
