# What makes compiling quick.
#
# Headers of other libraries that most files include are read once for a whole build: most of a file's compile time is
# theirs. Sources still include what they use; the preset `debug` compiles without this (CMAKE_DISABLE_PRECOMPILE_HEADERS)
# and so shows an include that is missing.
set(stickslip_precompiled_source ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)

# What computes nothing itself (statements, formulas, pages, tests) compiles in two thirds of the time with less optimisation.
# GCC takes the optimisation from the precompiled headers, whatever a target says: those of such targets are light, too.
set(stickslip_light $<$<CONFIG:Release>:-Og>)

# stickslip_precompiled(NAME [LIGHT] HEADERS… LIBRARIES…): a set of headers, for targets that link these libraries.
function(stickslip_precompiled name)
  cmake_parse_arguments(arg "LIGHT" "" "HEADERS;LIBRARIES" ${ARGN})
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${stickslip_precompiled_source})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
  if(arg_LIGHT)
    target_compile_options(${name} PRIVATE ${stickslip_light})
  endif()
  target_precompile_headers(${name} PRIVATE <algorithm> <array> <cmath> <functional> <map> <memory> <optional> <set>
    <sstream> <string> <utility> <vector> ${arg_HEADERS})
endfunction()

# Each room's set has those of the rooms below it; report/ makes its own, where there is that room. GiNaC's header needs
# GiNaC's library wherever it is included.
set(stickslip_numeric_set <Eigen/Core> <fmt/format.h> <tbb/parallel_for.h>)
set(stickslip_symbolic_set ${stickslip_numeric_set} <ginac/ginac.h>)
set(stickslip_report_set ${stickslip_symbolic_set} <nlohmann/json.hpp>)
set(stickslip_numeric_needs Eigen3::Eigen fmt::fmt TBB::tbb)
set(stickslip_symbolic_needs ${stickslip_numeric_needs} PkgConfig::GINAC)
set(stickslip_report_needs ${stickslip_symbolic_needs} nlohmann_json::nlohmann_json)
stickslip_precompiled(stickslip_numeric_headers HEADERS ${stickslip_numeric_set} LIBRARIES ${stickslip_numeric_needs})
stickslip_precompiled(stickslip_symbolic_headers LIGHT
                      HEADERS ${stickslip_symbolic_set} LIBRARIES ${stickslip_symbolic_needs})

option(STICKSLIP_EACH_ALONE "Compile each source alone, as the preset debug does" "${CMAKE_DISABLE_PRECOMPILE_HEADERS}")

# stickslip_together(TARGET NAME SOURCES…): these sources of the target are compiled as one, so that the headers and
# templates which they share are read once. Their unnamed namespaces are then one, and no local variable can be told from
# a name in another source: the preset `debug` compiles each alone, and warns of shadows.
function(stickslip_together target name)
  if(STICKSLIP_EACH_ALONE)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  target_compile_options(${target} PRIVATE -Wno-shadow)
  set_source_files_properties(${ARGN} PROPERTIES UNITY_GROUP ${name})
endfunction()

# stickslip_in_eights(TARGET [MIXED] SOURCES…): sources that follow each other are compiled together, by eights: those of one
# folder and of folders within it, or with MIXED whatever folders they are in.
function(stickslip_in_eights target)
  cmake_parse_arguments(arg "MIXED" "" "" ${ARGN})
  set(count 0)
  set(group 0)
  set(last "")
  foreach(source IN LISTS arg_UNPARSED_ARGUMENTS)
    cmake_path(GET source PARENT_PATH folder)
    string(REGEX REPLACE "/.*" "" folder "${folder}")
    if(arg_MIXED)
      set(folder mixed)
    endif()
    if(NOT "${folder}" STREQUAL "${last}" OR count EQUAL 8)
      math(EXPR group "${group} + 1")
      set(count 0)
    endif()
    stickslip_together(${target} group${group} ${source})
    math(EXPR count "${count} + 1")
    set(last "${folder}")
  endforeach()
endfunction()
