# SPDX-License-Identifier: BSD-3-Clause
# Programs, libraries, headers and the package that find_package(Angiomesh) finds.
include(CMakePackageConfigHelpers)

set(ANGIOMESH_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Angiomesh)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/angiomesh)

set_target_properties(angiomesh_core PROPERTIES EXPORT_NAME core)
set_target_properties(angiomesh_io PROPERTIES EXPORT_NAME io)
install(TARGETS angiomesh_core angiomesh_io EXPORT AngiomeshTargets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT Development
        INCLUDES DESTINATION ${header_dir})
install(DIRECTORY core io DESTINATION ${header_dir} COMPONENT Development
        FILES_MATCHING PATTERN "*.h")
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
install(FILES README.md LICENSE THIRD_PARTY.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
