# Third-party libraries as targets MoserHex::ITK, MoserHex::VTK, MoserHex::Eigen.
#
# One Eigen per process: an ITK built with its own Eigen (Debian's is 3.3.9) must not meet the system's 3.4 in one
# program. So Core uses ITK's copy whenever ITK is part of the build, and the system's otherwise.

find_package(Threads REQUIRED)
if(NOT MoserHex_CORE_ONLY)
  include(MoserHexFindITK)
  include(MoserHexFindVTK)
endif()
include(MoserHexFindEigen)
include(MoserHexFindKissfft)
if(MoserHex_BUILD_TESTING)
  find_package(GTest REQUIRED)
endif()
if(MoserHex_BUILD_BENCHMARKS)
  find_package(benchmark REQUIRED)
endif()
