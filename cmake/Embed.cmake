# stickslip_embed(VARIABLE HEADER FUNCTION FILES…): makes a source file, whose path VARIABLE gets, with the FUNCTION that
# HEADER declares: pairs of the name and the text of each file, which are then a part of the library.
function(stickslip_embed variable header function)
  set(rows "")
  foreach(file IN LISTS ARGN)
    cmake_path(GET file FILENAME name)
    file(READ ${file} text)
    string(APPEND rows "      {\"${name}\", R\"embedded(${text})embedded\"},\n")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  endforeach()
  string(REGEX REPLACE ".*:" "" name ${function})
  set(${variable} ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp PARENT_SCOPE)
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp @ONLY CONTENT "#include \"@header@\"

#include <type_traits>

decltype(@function@()) @function@() {
  static const std::remove_cvref_t<decltype(@function@())> files{
@rows@  };
  return files;
}
")
endfunction()
