# MoserHex::Cairo: draws pictures to files (LGPL-2.1 or MPL-1.1; linked as a shared library).
find_path(MoserHex_cairo_INCLUDE_DIR cairo/cairo-svg.h DOC "Folder that holds cairo/cairo-svg.h")
find_library(MoserHex_cairo_LIBRARY cairo DOC "The Cairo library, shared")
if(NOT MoserHex_cairo_INCLUDE_DIR OR NOT MoserHex_cairo_LIBRARY)
  message(FATAL_ERROR
    "Cairo is missing. Install Debian's libcairo2-dev, or set MoserHex_cairo_INCLUDE_DIR and MoserHex_cairo_LIBRARY.")
endif()
mark_as_advanced(MoserHex_cairo_INCLUDE_DIR MoserHex_cairo_LIBRARY)
add_library(MoserHex_Cairo INTERFACE)
add_library(MoserHex::Cairo ALIAS MoserHex_Cairo)
target_include_directories(MoserHex_Cairo SYSTEM INTERFACE ${MoserHex_cairo_INCLUDE_DIR})
target_link_libraries(MoserHex_Cairo INTERFACE ${MoserHex_cairo_LIBRARY})
