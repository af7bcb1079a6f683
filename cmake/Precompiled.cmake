# What makes compiling quick.
#
# Headers of other libraries that most files include are read once for a whole build: most of a file's compile time is
# theirs. Sources still include what they use; the preset `debug` compiles without this (CMAKE_DISABLE_PRECOMPILE_HEADERS)
# and so shows an include that is missing.
set(stickslip_precompiled_source ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)

# stickslip_precompiled(NAME HEADERS… LIBRARIES…): a set of headers, for targets that link these libraries.
function(stickslip_precompiled name)
  cmake_parse_arguments(arg "" "" "HEADERS;LIBRARIES" ${ARGN})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${stickslip_precompiled_source})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <set>
    <sstream> <string> <utility> <vector> ${arg_HEADERS})
endfunction()

# GiNaC's header needs GiNaC's library wherever it is included.
stickslip_precompiled(stickslip_numeric_headers HEADERS <Eigen/Core> <fmt/format.h> LIBRARIES Eigen3::Eigen fmt::fmt)
stickslip_precompiled(stickslip_symbolic_headers HEADERS <Eigen/Core> <fmt/format.h> <ginac/ginac.h>
                      LIBRARIES Eigen3::Eigen fmt::fmt PkgConfig::GINAC)

# What computes nothing itself (statements, pages, tests) compiles in half the time with less optimisation. GCC 12 then
# warns of its own library.
set(stickslip_light $<$<CONFIG:Release>:-O1> $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow>)
