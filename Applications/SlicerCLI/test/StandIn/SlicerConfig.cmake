# A stand-in for a build tree of 3D Slicer, with those of its variables that an extension uses.
set(Slicer_USE_FILE ${CMAKE_CURRENT_LIST_DIR}/UseSlicer.cmake)
set(Slicer_EXTENSION_GENERATE_CONFIG ${CMAKE_CURRENT_LIST_DIR}/GenerateExtensionConfig.cmake)
set(Slicer_EXTENSION_CPACK ${CMAKE_CURRENT_LIST_DIR}/ExtensionCPack.cmake)
set(Slicer_CLIMODULES_BIN_DIR lib/Slicer-0.0/cli-modules)
set(Slicer_INSTALL_CLIMODULES_BIN_DIR lib/Slicer-0.0/cli-modules)
