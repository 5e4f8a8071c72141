# Slicer writes a description of the extension here: these variables.
if(NOT stand_in_used)
  message(FATAL_ERROR "Slicer_USE_FILE was not included")
endif()
set(description "")
foreach(name NAME CATEGORY HOMEPAGE CONTRIBUTORS DESCRIPTION ICONURL SCREENSHOTURLS DEPENDS)
  string(APPEND description "set(EXTENSION_${name} [==[${EXTENSION_${name}}]==])\n")
endforeach()
file(WRITE ${CMAKE_BINARY_DIR}/extension.cmake "${description}")
