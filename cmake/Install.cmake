# SPDX-License-Identifier: BSD-3-Clause
# Programs, libraries, headers and the package that find_package(Angiomesh) finds.
include(CMakePackageConfigHelpers)

set(ANGIOMESH_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Angiomesh)
# What is offered stands in include/angiomesh; what these headers include by the path from the root
# of the project lies beside them and is no interface.
set(inner_dir ${CMAKE_INSTALL_INCLUDEDIR}/angiomesh/internal)

# The headers that FILE includes by a path from the root of the project, and so on.
function(angiomesh_collect_headers file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${file})
  file(STRINGS ${PROJECT_SOURCE_DIR}/${file} lines REGEX "^#include \"(core|io)/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^#include \"([^\"]+)\".*" "\\1" header "${line}")
    get_property(known GLOBAL PROPERTY ANGIOMESH_INNER_HEADERS)
    if(NOT header IN_LIST known)
      set_property(GLOBAL APPEND PROPERTY ANGIOMESH_INNER_HEADERS ${header})
      angiomesh_collect_headers(${header})
    endif()
  endforeach()
endfunction()
file(GLOB offered CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} include/angiomesh/*.h)
foreach(header IN LISTS offered)
  angiomesh_collect_headers(${header})
endforeach()
get_property(inner GLOBAL PROPERTY ANGIOMESH_INNER_HEADERS)

set_target_properties(angiomesh_core PROPERTIES EXPORT_NAME core)
set_target_properties(angiomesh_io PROPERTIES EXPORT_NAME io)
install(TARGETS angiomesh_core angiomesh_io EXPORT AngiomeshTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${inner_dir})
install(FILES ${offered} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/angiomesh COMPONENT Development)
foreach(header IN LISTS inner)
  get_filename_component(folder ${header} DIRECTORY)
  install(FILES ${header} DESTINATION ${inner_dir}/${folder} COMPONENT Development)
endforeach()
install(EXPORT AngiomeshTargets NAMESPACE Angiomesh:: DESTINATION ${ANGIOMESH_PACKAGE_DIR}
        COMPONENT Development)

list(JOIN ANGIOMESH_ITK " " ANGIOMESH_ITK_LIST)
list(JOIN ANGIOMESH_VTK_CORE " " ANGIOMESH_VTK_LIST)
list(JOIN ANGIOMESH_VTK_IO " " vtk_io)
string(APPEND ANGIOMESH_VTK_LIST " ${vtk_io}")
configure_package_config_file(cmake/AngiomeshConfig.cmake.in
                              ${CMAKE_BINARY_DIR}/AngiomeshConfig.cmake
                              INSTALL_DESTINATION ${ANGIOMESH_PACKAGE_DIR})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/AngiomeshConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/AngiomeshConfig.cmake
              ${CMAKE_BINARY_DIR}/AngiomeshConfigVersion.cmake
        DESTINATION ${ANGIOMESH_PACKAGE_DIR} COMPONENT Development)

foreach(program angiomesh-cli angiomesh)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()
if(TARGET angiomesh-pictures)
  install(TARGETS angiomesh-pictures
          RUNTIME DESTINATION ${CMAKE_INSTALL_LIBEXECDIR}/angiomesh)
endif()
if(TARGET angiomesh)
  install(FILES resources/angiomesh.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
  install(FILES resources/angiomesh.svg
          DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
endif()
install(FILES README.md LICENSE THIRD_PARTY.md CHANGELOG.md CONTRIBUTING.md SECURITY.md CITATION.cff
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN "*.in" EXCLUDE)
install(FILES bench/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/bench)
