# MoserHex::VTK: the VTK modules the IO layer uses. None of them needs a display.
set(MoserHex_VTK_COMPONENTS
  CommonCore CommonDataModel CommonExecutionModel CommonMisc FiltersVerdict IOCore IOGeometry IOLegacy IOPLY IOXML)
find_package(VTK 9.1 QUIET REQUIRED COMPONENTS ${MoserHex_VTK_COMPONENTS})
if(NOT TARGET MoserHex::VTK)
  add_library(MoserHex::VTK INTERFACE IMPORTED GLOBAL)
  set_target_properties(MoserHex::VTK PROPERTIES INTERFACE_LINK_LIBRARIES "${VTK_LIBRARIES}")
endif()
