# find_package(MoserHex) gives the targets MoserHex::<Module>.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/MoserHex)
configure_package_config_file(CMake/MoserHexConfig.cmake.in ${PROJECT_BINARY_DIR}/MoserHexConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/MoserHexConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/MoserHexConfig.cmake
  ${PROJECT_BINARY_DIR}/MoserHexConfigVersion.cmake
  CMake/MoserHexFindITK.cmake
  CMake/MoserHexFindVTK.cmake
  CMake/MoserHexFindEigen.cmake
  DESTINATION ${package_dir})
install(EXPORT MoserHexTargets NAMESPACE MoserHex:: DESTINATION ${package_dir})
