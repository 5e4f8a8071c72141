# moserhex_bundle_web(FOLDER web OUTPUT X.cxx FILES package.json package-lock.json build.js src/...)
#
# Copies the files of FOLDER into the build, installs the npm packages that package-lock.json names there, and makes the C++
# source OUTPUT of the bundles (node build.js OUTPUT). Nothing is written to the source folder. MoserHex_WEB_FOLDER is where
# all this lies; the target moserhex_web has it done.
find_program(MoserHex_NODE NAMES node nodejs DOC "Node.js")
find_program(MoserHex_NPM npm DOC "npm, the package manager of Node.js")
mark_as_advanced(MoserHex_NODE MoserHex_NPM)
if(NOT MoserHex_NODE OR NOT MoserHex_NPM)
  message(FATAL_ERROR
    "The HTML reports need Node.js and npm to be built. Install Debian's nodejs and npm, or configure with "
    "-DMoserHex_BUILD_REPORTS=OFF: then mesh, batch, collect and atlas write no pages.")
endif()

function(moserhex_bundle_web)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "FOLDER;OUTPUT" "FILES")
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/web)
  foreach(file IN LISTS arg_FILES)
    configure_file(${arg_FOLDER}/${file} ${folder}/${file} COPYONLY)
  endforeach()
  set(installed ${folder}/node_modules/.package-lock.json) # npm writes it last
  set(only_run ON)
  if(MoserHex_BUILD_TESTING)
    set(only_run OFF)
  endif()
  add_custom_command(OUTPUT ${installed}
    COMMAND ${CMAKE_COMMAND} -DNPM=${MoserHex_NPM} -DONLY_RUN=${only_run} -P ${PROJECT_SOURCE_DIR}/CMake/MoserHexNpmInstall.cmake
    COMMAND ${CMAKE_COMMAND} -E touch ${installed}
    DEPENDS ${folder}/package.json ${folder}/package-lock.json
    WORKING_DIRECTORY ${folder} COMMENT "Installing the npm packages of the reports" VERBATIM)
  set(sources ${arg_FILES})
  list(TRANSFORM sources PREPEND ${folder}/)
  add_custom_command(OUTPUT ${arg_OUTPUT}
    COMMAND ${MoserHex_NODE} build.js ${arg_OUTPUT}
    DEPENDS ${installed} ${sources}
    WORKING_DIRECTORY ${folder} COMMENT "Bundling the scripts of the reports" VERBATIM)
  add_custom_target(moserhex_web DEPENDS ${arg_OUTPUT})
  set(MoserHex_WEB_FOLDER ${folder} CACHE INTERNAL "Where the scripts of the reports are bundled")
endfunction()
