# MoserHex as an extension of 3D Slicer: what Slicer's build of extensions and its index want to know.
#
# Slicer passes <extension>_BUILD_SLICER_EXTENSION=ON and Slicer_DIR, a build tree of Slicer, which also says where its ITK
# and VTK are: so this comes before they are looked for. moserhex_finish_slicer_extension() is for the end of the top level.

set(MoserHex_REPOSITORY_URL "" CACHE STRING "URL of the public repository, for the description of the Slicer extension")
set(MoserHex_REPOSITORY_REVISION main CACHE STRING "Branch, tag or hash of it, for the same")
if(Slicer_DIR)
  option(MoserHex_BUILD_SLICER_EXTENSION "Build as an extension of 3D Slicer, needs Slicer_DIR" ON)
else()
  option(MoserHex_BUILD_SLICER_EXTENSION "Build as an extension of 3D Slicer, needs Slicer_DIR" OFF)
endif()

set(EXTENSION_NAME MoserHex)
set(EXTENSION_CATEGORY "Segmentation")
set(EXTENSION_HOMEPAGE "${MoserHex_REPOSITORY_URL}")
set(EXTENSION_CONTRIBUTORS "The MoserHex authors")
set(EXTENSION_DESCRIPTION
  "Structured hexahedral meshes of organs: a one-to-one map of a label onto a cube in which every element has the same volume and none is inverted")
set(EXTENSION_DEPENDS "NA")
set(extension_files "${MoserHex_REPOSITORY_URL}/raw/${MoserHex_REPOSITORY_REVISION}")
set(EXTENSION_ICONURL "${extension_files}/Applications/SlicerCLI/Extension/MoserHex.png")
string(CONCAT EXTENSION_SCREENSHOTURLS
  "${extension_files}/Documentation/Pictures/mesh-in-label.png "
  "${extension_files}/Documentation/Pictures/shells.png "
  "${extension_files}/Documentation/Pictures/scaled-jacobian.png "
  "${extension_files}/Documentation/Pictures/same-place.png")
if(MoserHex_REPOSITORY_URL)
  configure_file(Applications/SlicerCLI/Extension/MoserHex.json ${PROJECT_BINARY_DIR}/MoserHex.json @ONLY)
endif()

if(MoserHex_BUILD_SLICER_EXTENSION)
  if(NOT MoserHex_REPOSITORY_URL)
    message(WARNING "MoserHex_REPOSITORY_URL is empty: the extension's home page, icon and pictures have no address.")
  endif()
  find_package(Slicer REQUIRED)
  include(${Slicer_USE_FILE})
endif()

# A macro: Slicer's files read and set variables of the top level.
macro(moserhex_finish_slicer_extension)
  if(MoserHex_BUILD_SLICER_EXTENSION)
    include(${Slicer_EXTENSION_GENERATE_CONFIG})
    include(${Slicer_EXTENSION_CPACK})
  endif()
endmacro()
