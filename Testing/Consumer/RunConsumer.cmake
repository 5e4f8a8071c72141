# cmake -DBUILD_FOLDER=... -DPROJECT_FOLDER=... -DWORK_FOLDER=... -DGENERATOR=... -DBUILD_TYPE=... -DCXX_COMPILER=...
#       -DEigen3_DIR=... -DCORE_ONLY=... -P RunConsumer.cmake

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "Failed (${failed}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_FOLDER})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${WORK_FOLDER}/prefix --config ${BUILD_TYPE})

set(eigen "")
if(Eigen3_DIR)
  set(eigen -DEigen3_DIR=${Eigen3_DIR})
endif()
run(${CMAKE_COMMAND} -S ${PROJECT_FOLDER} -B ${WORK_FOLDER}/build -G ${GENERATOR}
  -DCMAKE_BUILD_TYPE=${BUILD_TYPE} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
  -DCMAKE_PREFIX_PATH=${WORK_FOLDER}/prefix ${eigen})
run(${CMAKE_COMMAND} --build ${WORK_FOLDER}/build --config ${BUILD_TYPE})

run(${WORK_FOLDER}/build/core_consumer)
if(NOT CORE_ONLY)
  run(${WORK_FOLDER}/build/itk_consumer)
  run(${WORK_FOLDER}/prefix/bin/moserhex --version)
endif()
