# cmake -DBUILD_FOLDER=... -DPROJECT_FOLDER=... -DEXAMPLES_FOLDER=... -DWORK_FOLDER=... -DGENERATOR=... -DBUILD_TYPE=... -DCXX_COMPILER=...
#       -DEigen3_DIR=... -DCORE_ONLY=... -P RunConsumer.cmake

function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${WORK_FOLDER} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "Failed (${failed}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
file(MAKE_DIRECTORY ${WORK_FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${WORK_FOLDER}/prefix --config ${BUILD_TYPE})

set(eigen "")
if(Eigen3_DIR)
  set(eigen -DEigen3_DIR=${Eigen3_DIR})
endif()
function(build_project source binary)
  run(${CMAKE_COMMAND} -S ${source} -B ${binary} -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DCMAKE_PREFIX_PATH=${WORK_FOLDER}/prefix ${eigen})
  run(${CMAKE_COMMAND} --build ${binary} --config ${BUILD_TYPE})
endfunction()

build_project(${PROJECT_FOLDER} ${WORK_FOLDER}/build)
run(${WORK_FOLDER}/build/core_consumer)
if(NOT CORE_ONLY)
  run(${WORK_FOLDER}/build/itk_consumer)
  run(${WORK_FOLDER}/prefix/bin/moserhex --version)
endif()

build_project(${EXAMPLES_FOLDER} ${WORK_FOLDER}/examples)
run(${WORK_FOLDER}/examples/SphereMap)
if(NOT CORE_ONLY)
  run(${WORK_FOLDER}/prefix/bin/moserhex sample ${WORK_FOLDER}/sample --quiet)
  run(${WORK_FOLDER}/examples/MeshLabelmap ${WORK_FOLDER}/sample/prostate.nrrd 1 ${WORK_FOLDER}/prostate.vtu)
  run(${WORK_FOLDER}/examples/OwnStage ${WORK_FOLDER}/sample/prostate.nrrd 1 ${WORK_FOLDER}/own.vtu)
endif()
