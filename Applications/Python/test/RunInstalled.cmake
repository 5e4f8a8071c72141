# cmake -DBUILD_FOLDER=... -DPREFIX=... -DMODULE_FOLDER=... -DPYTHON=... -DCONFIG=... -DEXAMPLE=... -P RunInstalled.cmake
# Installs into a prefix of its own; a fresh interpreter imports the package from there and runs an example.
function(run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${PREFIX} RESULT_VARIABLE failed)
  if(failed)
    message(FATAL_ERROR "Failed (${failed}): ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${PREFIX})
file(MAKE_DIRECTORY ${PREFIX})
run(${CMAKE_COMMAND} --install ${BUILD_FOLDER} --prefix ${PREFIX} --config ${CONFIG})
if(IS_ABSOLUTE ${MODULE_FOLDER})
  set(ENV{PYTHONPATH} ${MODULE_FOLDER})
else()
  set(ENV{PYTHONPATH} ${PREFIX}/${MODULE_FOLDER})
endif()
set(ENV{PYTHONDONTWRITEBYTECODE} 1)
run(${PYTHON} -c "
import os, moserhex
assert moserhex.__file__.startswith(os.environ['PYTHONPATH']), moserhex.__file__
assert os.path.exists(os.path.join(os.path.dirname(moserhex.__file__), 'py.typed'))")
run(${PYTHON} ${EXAMPLE} ${PREFIX}/ellipsoid.vtu)
