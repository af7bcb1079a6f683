# What other projects get: find_package(stickslip), or add_subdirectory, and headers as <stickslip/numeric/orbits.hpp>.
#
# Sources include each other by paths from the root of the tree. The public headers among them are laid out under
# include/stickslip in the build tree, with these paths made into <stickslip/…>; consumers, and the installation, get
# those. A public header that includes one that is not public is refused here.
include(CMakePackageConfigHelpers)

set(stickslip_include ${PROJECT_BINARY_DIR}/include)
set(stickslip_installed_cmake ${CMAKE_INSTALL_LIBDIR}/cmake/stickslip)

# stickslip_package(TARGET [HEADERS…]): installs the library, with these headers of the folder as its public ones.
function(stickslip_package target)
  file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  foreach(header IN LISTS ARGN)
    set_property(GLOBAL APPEND PROPERTY stickslip_public ${room}/${header})
  endforeach()
  string(REGEX REPLACE "^stickslip_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} INTERFACE $<BUILD_INTERFACE:${stickslip_include}>
                                                 $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(${target} INTERFACE cxx_std_20)
  install(TARGETS ${target} EXPORT stickslip ARCHIVE COMPONENT development)
endfunction()

# stickslip_pkg_config(NAME WHAT REQUIRES LIBRARIES): the file by which pkg-config finds stickslip-NAME.
function(stickslip_pkg_config name what requires libraries)
  get_target_property(arb Arb::Arb INTERFACE_LINK_LIBRARIES)
  list(TRANSFORM arb REPLACE ".*/lib([^/]*)\\.(so|a)$" "-l\\1")
  list(JOIN arb " " arb)
  cmake_path(APPEND libdir "\${prefix}" ${CMAKE_INSTALL_LIBDIR})
  cmake_path(APPEND includedir "\${prefix}" ${CMAKE_INSTALL_INCLUDEDIR})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/stickslip.pc.in stickslip-${name}.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/stickslip-${name}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
          COMPONENT development)
endfunction()

# When all rooms are known: their public headers as consumers include them.
function(stickslip_lay_out_headers)
  get_property(public GLOBAL PROPERTY stickslip_public)
  foreach(header IN LISTS public)
    set(source ${PROJECT_SOURCE_DIR}/${header})
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${source})
    file(STRINGS ${source} includes REGEX "^#include \"")
    foreach(include IN LISTS includes)
      string(REGEX REPLACE "^#include \"(.*)\"$" "\\1" path ${include})
      if(NOT path IN_LIST public)
        message(FATAL_ERROR "${header} is public and includes ${path}, which is not")
      endif()
    endforeach()
    file(READ ${source} text)
    string(REGEX REPLACE "#include \"([^\"\n]*)\"" "#include <stickslip/\\1>" text "${text}")
    file(CONFIGURE OUTPUT ${stickslip_include}/stickslip/${header} CONTENT "${text}" @ONLY)
  endforeach()
  file(CONFIGURE OUTPUT ${stickslip_include}/stickslip/version.hpp @ONLY CONTENT
"// The version of the package.
#pragma once

#define STICKSLIP_VERSION_MAJOR @PROJECT_VERSION_MAJOR@
#define STICKSLIP_VERSION_MINOR @PROJECT_VERSION_MINOR@
#define STICKSLIP_VERSION_PATCH @PROJECT_VERSION_PATCH@
#define STICKSLIP_VERSION \"@PROJECT_VERSION@\"
")
endfunction()

# The headers, and the files by which CMake and pkg-config find the package.
function(stickslip_install_package)
  install(DIRECTORY ${stickslip_include}/stickslip DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)

  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/stickslipConfig.cmake.in stickslipConfig.cmake
    INSTALL_DESTINATION ${stickslip_installed_cmake} NO_SET_AND_CHECK_MACRO)
  # Before 1.0.0 a minor version may change what it likes.
  write_basic_package_version_file(stickslipConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/stickslipConfig.cmake ${PROJECT_BINARY_DIR}/stickslipConfigVersion.cmake
                ${PROJECT_SOURCE_DIR}/cmake/FindArb.cmake ${PROJECT_SOURCE_DIR}/cmake/FindGLPK.cmake
          DESTINATION ${stickslip_installed_cmake} COMPONENT development)
  install(EXPORT stickslip NAMESPACE stickslip:: FILE stickslipTargets.cmake
          DESTINATION ${stickslip_installed_cmake} COMPONENT development)
  stickslip_pkg_config(numeric "Periodic orbits of dry-friction oscillators, proved in balls; simulation"
                       "eigen3 fmt gmpxx tbb" "-lstickslip_numeric")
  stickslip_pkg_config(symbolic "Identities of dry-friction oscillators derived, decided, printed as LaTeX"
                       "eigen3 fmt gmpxx tbb ginac cln" "-lstickslip_symbolic")
  stickslip_pkg_config(proofs "Statements of a paper as claims, proved by a small kernel"
                       "stickslip-symbolic stickslip-numeric" "-lstickslip_proofs -lstickslip_tactics -lstickslip_kernel -lglpk")
endfunction()
