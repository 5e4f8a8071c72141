# One recipe for every module: a library, its tests, its benchmarks, its install rules.
#
#   moserhex_add_module(
#     NAME            SphericalMap                 folder = target = include prefix = ctest label
#     LAYER           Core | Filtering | IO        which layer the module lives in
#     HEADERS         include/...                  installed
#     SOURCES         src/...                      none: header-only
#     LANE_SOURCES    src/... test/...             those of the sources and tests that compute on Lanes
#     DEPENDS         Geometry Numerics            public: modules by name, or ITK, VTK
#     PRIVATE_DEPENDS ...                          used in src/ only
#     TESTS           test/XGTest.cxx ...          one executable <NAME>Tests
#     TEST_DEPENDS    Analytic ...                 modules used by the tests and benchmarks only
#     BENCHMARKS      benchmark/XBenchmark.cxx)    one executable each
#
# Tests and benchmarks see src/, for the parts that have no public header, and benchmarks what helps the tests.
#
# Arrows point downwards only. Core sees nothing but Core; Filtering and IO are siblings on top of Core;
# Applications see all three. An arrow that points upwards or sideways stops the configuration.

set(MoserHex_LAYERS_BELOW_Core Core)
set(MoserHex_LAYERS_BELOW_Filtering Core Filtering)
set(MoserHex_LAYERS_BELOW_IO Core IO)
set(MoserHex_LAYERS_BELOW_Applications Core Filtering IO Applications)
set(MoserHex_EXTERNALS_OF_Core "")
set(MoserHex_EXTERNALS_OF_Filtering ITK)
set(MoserHex_EXTERNALS_OF_IO ITK VTK)
set(MoserHex_EXTERNALS_OF_Applications ITK)

# Stops unless every dependency of a target in LAYER exists and lies in the same layer or below.
function(moserhex_check_dependencies name layer)
  foreach(dependency IN LISTS ARGN)
    if(dependency MATCHES "^(ITK|VTK)$")
      if(NOT dependency IN_LIST MoserHex_EXTERNALS_OF_${layer})
        message(FATAL_ERROR "${name} (layer ${layer}) must not depend on ${dependency}.")
      endif()
      continue()
    endif()
    if(NOT TARGET MoserHex::${dependency})
      message(FATAL_ERROR "${name} depends on ${dependency}, which is not a module added before it.")
    endif()
    get_target_property(actual moserhex_${dependency} MOSERHEX_LAYER)
    if(NOT actual IN_LIST MoserHex_LAYERS_BELOW_${layer})
      message(FATAL_ERROR
        "Upward dependency: ${name} (layer ${layer}) on ${dependency} (layer ${actual}). "
        "Arrows point downwards only: Applications -> Filtering, IO -> Core.")
    endif()
  endforeach()
endfunction()

function(moserhex_add_module)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;LAYER"
    "HEADERS;SOURCES;LANE_SOURCES;DEPENDS;PRIVATE_DEPENDS;TESTS;TEST_DEPENDS;BENCHMARKS")
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "moserhex_add_module(${arg_NAME}): unknown arguments ${arg_UNPARSED_ARGUMENTS}")
  endif()
  moserhex_check_dependencies(${arg_NAME} ${arg_LAYER} ${arg_DEPENDS} ${arg_PRIVATE_DEPENDS})

  set(target moserhex_${arg_NAME})
  list(TRANSFORM arg_DEPENDS PREPEND "MoserHex::" OUTPUT_VARIABLE public)
  list(TRANSFORM arg_PRIVATE_DEPENDS PREPEND "MoserHex::" OUTPUT_VARIABLE private)
  list(TRANSFORM arg_TEST_DEPENDS PREPEND "MoserHex::" OUTPUT_VARIABLE test_only)
  if(arg_LANE_SOURCES)
    # No vector crosses a function that is not inlined, so the warning about how it would does not apply.
    set_source_files_properties(${arg_LANE_SOURCES} PROPERTIES COMPILE_OPTIONS -Wno-psabi)
  endif()
  if(arg_SOURCES)
    add_library(${target} STATIC ${arg_SOURCES} ${arg_HEADERS})
    target_link_libraries(${target} PUBLIC ${public} MoserHex::CompileSettings PRIVATE ${private} MoserHex::Warnings)
    set(visibility PUBLIC)
  else()
    add_library(${target} INTERFACE)
    target_link_libraries(${target} INTERFACE ${public} ${private} MoserHex::CompileSettings)
    set(visibility INTERFACE)
  endif()
  add_library(MoserHex::${arg_NAME} ALIAS ${target})
  target_include_directories(${target} ${visibility}
    $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${arg_NAME} MOSERHEX_LAYER ${arg_LAYER})

  install(TARGETS ${target} EXPORT MoserHexTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

  if(MoserHex_BUILD_TESTING AND arg_TESTS)
    moserhex_add_tests(NAME ${arg_NAME} LAYER ${arg_LAYER} SOURCES ${arg_TESTS}
      DEPENDS ${arg_NAME} ${arg_TEST_DEPENDS})
    target_include_directories(${arg_NAME}Tests PRIVATE src)
  endif()
  if(MoserHex_BUILD_BENCHMARKS AND arg_BENCHMARKS)
    foreach(source IN LISTS arg_BENCHMARKS)
      get_filename_component(benchmark ${source} NAME_WE)
      add_executable(${benchmark} ${source})
      target_link_libraries(${benchmark}
        PRIVATE ${target} ${test_only} MoserHex::Analytic MoserHex::Warnings benchmark::benchmark_main)
      target_include_directories(${benchmark} PRIVATE src test)
    endforeach()
  endif()
endfunction()

# moserhex_add_tests(NAME Common LAYER Core SOURCES test/XGTest.cxx DEPENDS Common LABELS slow TIMEOUT 300)
# makes the executable <NAME>Tests and registers each of its GoogleTests with ctest under the label NAME.
function(moserhex_add_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;LAYER;TIMEOUT" "SOURCES;DEPENDS;LABELS")
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 300)
  endif()
  if(NOT arg_LABELS)
    set(arg_LABELS unit)
  endif()
  set(sanitizer_reports "") # those of a child, too, whose end looks like that of a reader given a bad file
  if(MoserHex_SANITIZE)
    set(sanitizer_reports FAIL_REGULAR_EXPRESSION "Sanitizer:|runtime error:")
    math(EXPR arg_TIMEOUT "4 * ${arg_TIMEOUT}")
  endif()
  set(executable ${arg_NAME}Tests)
  add_executable(${executable} ${arg_SOURCES})
  list(TRANSFORM arg_DEPENDS PREPEND "MoserHex::" OUTPUT_VARIABLE libraries)
  target_link_libraries(${executable} PRIVATE ${libraries} MoserHex::Warnings GTest::gtest_main)
  target_compile_definitions(${executable} PRIVATE
    MOSERHEX_DEVELOPMENT_DATA="${MoserHex_DEVELOPMENT_DATA}")
  gtest_discover_tests(${executable} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 TEST_PREFIX ${arg_NAME}.
    PROPERTIES LABELS "${arg_NAME};${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} ${sanitizer_reports})
endfunction()
