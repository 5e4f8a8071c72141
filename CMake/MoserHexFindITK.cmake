# MoserHex::ITK: the ITK modules the library uses, listed so that nothing else is linked.
# Included by the build and by the installed package file.
set(MoserHex_ITK_COMPONENTS
  ITKCommon ITKIOImageBase ITKIONRRD ITKIONIFTI ITKIOMeta ITKIOMeshBase ITKLevelSets ITKFiniteDifference
  ITKImageFilterBase ITKMesh ITKTransform ITKIOTransformBase ITKIOTransformInsightLegacy ITKIOTransformHDF5
  ITKIOTransformMatlab)
# Debian's ITK prints a screen of messages about GDCM files it does not need; they mean nothing here.
set(moserhex_log_level "${CMAKE_MESSAGE_LOG_LEVEL}")
set(CMAKE_MESSAGE_LOG_LEVEL ERROR)
find_package(ITK 5.2 QUIET REQUIRED COMPONENTS ${MoserHex_ITK_COMPONENTS})
set(CMAKE_MESSAGE_LOG_LEVEL "${moserhex_log_level}")
if(NOT TARGET MoserHex::ITK)
  add_library(MoserHex::ITK INTERFACE IMPORTED GLOBAL)
  set_target_properties(MoserHex::ITK PROPERTIES
    INTERFACE_LINK_LIBRARIES "${ITK_LIBRARIES}"
    INTERFACE_INCLUDE_DIRECTORIES "${ITK_INCLUDE_DIRS}"
    INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${ITK_INCLUDE_DIRS}")
endif()
