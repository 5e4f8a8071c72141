# MoserHex::CompileSettings: what every user of the library needs. MoserHex::Warnings: our own code only.
add_library(moserhex_CompileSettings INTERFACE)
add_library(MoserHex::CompileSettings ALIAS moserhex_CompileSettings)
set_target_properties(moserhex_CompileSettings PROPERTIES EXPORT_NAME CompileSettings)
target_compile_features(moserhex_CompileSettings INTERFACE cxx_std_17)
# No contraction of a*b+c into fused operations: the same bytes from every build for the same instruction set.
target_compile_options(moserhex_CompileSettings INTERFACE
  $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-ffp-contract=off>)
if(MoserHex_SANITIZE)
  target_compile_options(moserhex_CompileSettings INTERFACE
    -fsanitize=${MoserHex_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(moserhex_CompileSettings INTERFACE -fsanitize=${MoserHex_SANITIZE})
endif()
if(MoserHex_COVERAGE)
  target_compile_options(moserhex_CompileSettings INTERFACE --coverage -fprofile-update=atomic)
  target_link_options(moserhex_CompileSettings INTERFACE --coverage)
endif()
install(TARGETS moserhex_CompileSettings EXPORT MoserHexTargets)

add_library(moserhex_Warnings INTERFACE)
add_library(MoserHex::Warnings ALIAS moserhex_Warnings)
target_compile_options(moserhex_Warnings INTERFACE
  $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang>:-Wall -Wextra -Wshadow -Wnon-virtual-dtor>
  $<$<BOOL:${MoserHex_WARNINGS_AS_ERRORS}>:-Werror>)
# No -Wpedantic: ITK's macros leave a second semicolon behind in every class that uses them.
# Named by static libraries that link it privately; carries nothing for a consumer.
set_target_properties(moserhex_Warnings PROPERTIES EXPORT_NAME Warnings)
install(TARGETS moserhex_Warnings EXPORT MoserHexTargets)
