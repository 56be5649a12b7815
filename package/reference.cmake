# `cmake --build DIR --target reference`: the reference of the public headers, as HTML.
find_program(SPOKE_DOXYGEN doxygen)
mark_as_advanced(SPOKE_DOXYGEN)
if(SPOKE_DOXYGEN)
  configure_file(Doxyfile.in Doxyfile @ONLY)
  add_custom_target(reference
    COMMAND ${SPOKE_DOXYGEN} ${CMAKE_CURRENT_BINARY_DIR}/Doxyfile
    COMMAND ${CMAKE_COMMAND} -E echo "${PROJECT_BINARY_DIR}/reference/html/index.html"
    DEPENDS ${headers_stamp}
    WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
    COMMENT "Writing the reference of the public headers"
    VERBATIM)
else()
  add_custom_target(reference
    COMMAND ${CMAKE_COMMAND} -E echo "The reference needs doxygen: install it, and configure again"
    COMMAND ${CMAKE_COMMAND} -E false
    VERBATIM)
endif()
