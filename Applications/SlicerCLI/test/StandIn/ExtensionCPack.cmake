file(WRITE ${CMAKE_BINARY_DIR}/cpack.txt "included")
