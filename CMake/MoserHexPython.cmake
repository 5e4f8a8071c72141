# MoserHex_BUILD_PYTHON: whether Applications/Python is built. Included before the modules, whose code must be
# position-independent then.
#
# Debian's Python goes before any other in the PATH: python3-dev and pybind11-dev belong to it.
set(MoserHex_PYTHON_EXECUTABLE "" CACHE FILEPATH
  "Python that the module is for; empty: /usr/bin/python3, else the one in the PATH")
set(python_missing "")
if(MoserHex_CORE_ONLY)
  set(python_missing "Core alone is built")
elseif(MoserHex_SANITIZE)
  set(python_missing "the interpreter has no sanitizer")
else()
  if(MoserHex_PYTHON_EXECUTABLE)
    set(Python3_EXECUTABLE ${MoserHex_PYTHON_EXECUTABLE})
  elseif(EXISTS /usr/bin/python3)
    set(Python3_EXECUTABLE /usr/bin/python3)
  endif()
  find_package(Python3 3.9 QUIET COMPONENTS Interpreter Development.Module)
  if(NOT Python3_Interpreter_FOUND OR NOT Python3_Development.Module_FOUND)
    set(python_missing "no Python 3.9 with development files, Debian's python3-dev")
  else()
    find_package(pybind11 2.6 QUIET CONFIG)
    if(NOT pybind11_FOUND)
      set(python_missing "no pybind11, Debian's pybind11-dev")
    endif()
  endif()
endif()

include(CMakeDependentOption)
cmake_dependent_option(MoserHex_BUILD_PYTHON "Build the Python module" ON "NOT python_missing" OFF)
if(MoserHex_BUILD_PYTHON)
  message(STATUS "Python module: for ${Python3_EXECUTABLE} (${Python3_VERSION}), pybind11 ${pybind11_VERSION}")
  # What the static libraries define cannot be replaced at run time: calls within a file stay direct.
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
  target_compile_options(moserhex_CompileSettings INTERFACE
    $<BUILD_INTERFACE:$<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-semantic-interposition>>)
elseif(python_missing)
  message(STATUS "Python module: left out (${python_missing})")
else()
  message(STATUS "Python module: left out (MoserHex_BUILD_PYTHON is OFF)")
endif()
