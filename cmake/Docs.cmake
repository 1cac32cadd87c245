# SPDX-License-Identifier: BSD-3-Clause
# The target `docs`: the API pages and those of docs/, by Doxygen, in docs/html of the build folder.
find_package(Doxygen QUIET)
if(DOXYGEN_FOUND)
  configure_file(docs/Doxyfile.in ${CMAKE_BINARY_DIR}/docs/Doxyfile @ONLY)
  add_custom_target(docs COMMAND Doxygen::doxygen ${CMAKE_BINARY_DIR}/docs/Doxyfile
                    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM)
else()
  add_custom_target(docs COMMAND ${CMAKE_COMMAND} -E echo
                    "Doxygen was not found: install the Debian package doxygen and configure again"
                    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
