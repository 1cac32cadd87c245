# SPDX-License-Identifier: BSD-3-Clause
# VTK is always asked for by component: without components it wants Qt 5.
set(ANGIOMESH_VTK_CORE CommonCore CommonDataModel CommonExecutionModel FiltersCore)
set(ANGIOMESH_VTK_IO IOCore IOPLY IOGeometry IOXML IOLegacy)
set(ANGIOMESH_VTK_RENDER
    CommonMath RenderingCore RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2 RenderingFreeType
    RenderingAnnotation InteractionStyle FiltersSources)
set(ANGIOMESH_ITK ITKCommon ITKIOImageBase ITKIOGDCM ITKIOMeta ITKIONIFTI ITKIONRRD ITKCurvatureFlow
                  ITKDistanceMap ITKLevelSets ITKRegionGrowing ITKSmoothing ITKImageGradient ITKThresholding)
set(components ${ANGIOMESH_VTK_CORE} ${ANGIOMESH_VTK_IO})
if(ANGIOMESH_BUILD_GUI)
  list(APPEND components ${ANGIOMESH_VTK_RENDER})
endif()
find_package(VTK 9.1 REQUIRED COMPONENTS ${components})
find_package(ITK 5.2 REQUIRED COMPONENTS ${ANGIOMESH_ITK})
find_package(DCMTK REQUIRED CONFIG)
find_package(OpenMesh REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
find_package(TBB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nanoflann REQUIRED)
find_package(Threads REQUIRED)
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)

if(ANGIOMESH_BUILD_GUI)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Widgets OpenGLWidgets Svg LinguistTools)
endif()
if(ANGIOMESH_BUILD_TESTS)
  find_package(Qt6 6.4 REQUIRED COMPONENTS Core Test)
endif()

# angiomesh_vtk(RESULT component...): the VTK targets of these components.
function(angiomesh_vtk result)
  set(targets)
  foreach(component IN LISTS ARGN)
    list(APPEND targets VTK::${component})
  endforeach()
  set(${result} ${targets} PARENT_SCOPE)
endfunction()
