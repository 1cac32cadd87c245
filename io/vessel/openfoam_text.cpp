// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/openfoam_text.h"

#include <cmath>

#include "core/base/formatted.h"

namespace angiomesh {
namespace {

std::string vector(const Eigen::Vector3d& v) {
  return "(" + shortestText(v.x()) + " " + shortestText(v.y()) + " " + shortestText(v.z()) + ")";
}

std::string dictionary(const std::string& object, const std::string& content) {
  return "FoamFile\n{\n    version 2.0;\n    format ascii;\n    class dictionary;\n    object " +
         object + ";\n}\n\n" + content;
}

std::string blockMeshDict(const OpenFoamMesh& mesh) {
  std::string text = "scale 1;\n\nvertices\n(\n";
  // Around the low face, then around the high one.
  for (int v = 0; v < 8; ++v) {
    const bool x = v % 4 == 1 || v % 4 == 2, y = v % 4 >= 2, z = v >= 4;
    text += "    " +
            vector({x ? mesh.high.x() : mesh.low.x(), y ? mesh.high.y() : mesh.low.y(),
                    z ? mesh.high.z() : mesh.low.z()}) +
            "\n";
  }
  text += ");\n\nblocks\n(\n    hex (0 1 2 3 4 5 6 7) (";
  for (std::size_t a = 0; a < 3; ++a) text += (a > 0 ? " " : "") + std::to_string(mesh.cells[a]);
  return text +
         ") simpleGrading (1 1 1)\n);\n\nedges ();\n\n"
         "// Nothing of this patch is left when the vessel has been cut out.\n"
         "boundary\n(\n    background\n    {\n        type patch;\n        faces\n        (\n"
         "            (0 3 2 1) (4 5 6 7) (0 1 5 4) (3 7 6 2) (0 4 7 3) (1 2 6 5)\n        );\n"
         "    }\n);\n";
}

constexpr const char* kFeatures = R"(vessel.stl
{
    extractionMethod extractFromSurface;
    extractFromSurfaceCoeffs
    {
        // The rims of the ports are sharper than this, degrees.
        includedAngle 150;
    }
    writeObj no;
}
)";

constexpr const char* kSnapControls = R"(snapControls
{
    nSmoothPatch 3;
    tolerance 2;
    nSolveIter 100;
    nRelaxIter 5;
    nFeatureSnapIter 10;
    implicitFeatureSnap false;
    explicitFeatureSnap true;
    multiRegionFeatureSnap true;
}

// addLayers above switches layers along the wall on.
addLayersControls
{
    relativeSizes true;
    layers
    {
        wall
        {
            nSurfaceLayers 3;
        }
    }
    expansionRatio 1.2;
    finalLayerThickness 0.4;
    minThickness 0.1;
    nGrow 0;
    featureAngle 120;
    slipFeatureAngle 30;
    nRelaxIter 5;
    nSmoothSurfaceNormals 1;
    nSmoothNormals 3;
    nSmoothThickness 10;
    maxFaceThicknessRatio 0.5;
    maxThicknessToMedialRatio 0.3;
    minMedianAxisAngle 90;
    nBufferCellsNoExtrude 0;
    nLayerIter 50;
}

meshQualityControls
{
    maxNonOrtho 65;
    maxBoundarySkewness 20;
    maxInternalSkewness 4;
    maxConcave 80;
    minVol 1e-30;
    minTetQuality 1e-15;
    minArea -1;
    minTwist 0.02;
    minDeterminant 0.001;
    minFaceWeight 0.05;
    minVolRatio 0.01;
    minTriangleTwist -1;
    nSmoothScale 4;
    errorReduction 0.75;
    relaxed
    {
        maxNonOrtho 75;
    }
}

mergeTolerance 1e-6;
)";

std::string levelPair(int least, int most) {
  return "level (" + std::to_string(least) + " " + std::to_string(most) + ");";
}

std::string snappyHexMeshDict(const OpenFoamMesh& mesh) {
  std::string names, regions;
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    const std::string& name = mesh.patches[patch];
    const int level = mesh.levels[patch];
    names += "            " + name + " { name " + name + "; }\n";
    regions += "                " + name + "\n                {\n                    " +
               levelPair(level, patch == 0 ? mesh.finest : level) +
               "\n                    patchInfo { type " + (patch == 0 ? "wall" : "patch") +
               "; }\n                }\n";
  }
  const std::string wallLevel = std::to_string(mesh.levels.front());
  return "castellatedMesh true;\nsnap true;\naddLayers false;\n\ngeometry\n{\n    vessel.stl\n"
         "    {\n        type triSurfaceMesh;\n        name vessel;\n        regions\n        {\n" +
         names +
         "        }\n    }\n}\n\ncastellatedMeshControls\n{\n    maxLocalCells 10000000;\n"
         "    maxGlobalCells 50000000;\n    minRefinementCells 0;\n    nCellsBetweenLevels 3;\n"
         "    features\n    (\n        {\n            file \"vessel.eMesh\";\n            level " +
         wallLevel +
         ";\n        }\n    );\n    refinementSurfaces\n    {\n        vessel\n        {\n"
         "            " +
         levelPair(mesh.levels.front(), mesh.finest) + "\n            regions\n            {\n" +
         regions +
         "            }\n        }\n    }\n"
         "    // Cells at which the wall turns by more are refined to the second level: vessels\n"
         "    // have 11 cells across where that level allows it, whatever their width.\n"
         "    resolveFeatureAngle 10;\n    refinementRegions {}\n    locationInMesh " +
         vector(mesh.inside) + ";\n    allowFreeStandingZoneFaces false;\n}\n\n" + kSnapControls;
}

constexpr const char* kControl = R"(application simpleFoam;
startFrom startTime;
startTime 0;
stopAt endTime;
endTime 1000;
deltaT 1;
writeControl timeStep;
writeInterval 100;
purgeWrite 2;
writeFormat ascii;
writePrecision 10;
writeCompression off;
timeFormat general;
timePrecision 6;
runTimeModifiable true;
)";

constexpr const char* kSchemes = R"(ddtSchemes
{
    default steadyState;
}

gradSchemes
{
    default cellLimited Gauss linear 1;
}

divSchemes
{
    default none;
    div(phi,U) bounded Gauss linearUpwind grad(U);
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}

laplacianSchemes
{
    default Gauss linear limited 0.5;
}

interpolationSchemes
{
    default linear;
}

snGradSchemes
{
    default limited 0.5;
}
)";

constexpr const char* kSolution = R"(solvers
{
    p
    {
        solver GAMG;
        smoother GaussSeidel;
        tolerance 1e-7;
        relTol 0.01;
    }
    U
    {
        solver smoothSolver;
        smoother symGaussSeidel;
        tolerance 1e-8;
        relTol 0.1;
    }
}

SIMPLE
{
    nNonOrthogonalCorrectors 1;
    consistent yes;
    residualControl
    {
        p 1e-4;
        U 1e-5;
    }
}

relaxationFactors
{
    equations
    {
        U 0.9;
    }
}
)";

constexpr const char* kAllrun = R"(#!/bin/sh
# Fills the vessel with cells. The output of each step is in log.STEP.
cd "${0%/*}" || exit 1
# Debian's package does not say where its own files are.
if [ -z "$WM_PROJECT_DIR" ] && [ -d /usr/share/openfoam/etc ]; then
  export WM_PROJECT_DIR=/usr/share/openfoam
fi

run() {
  echo "$*"
  "$@" > "log.$1" 2>&1 || {
    echo "$1 failed, see log.$1" >&2
    exit 1
  }
}

run surfaceCheck constant/triSurface/vessel.stl
run surfaceFeatureExtract
run blockMesh
run snappyHexMesh -overwrite
run checkMesh
if ! grep -q '^Mesh OK' log.checkMesh; then
  echo "checkMesh finds faults, see log.checkMesh" >&2
  exit 1
fi
)";

std::string readme(const OpenFoamMesh& mesh) {
  std::string list;
  for (std::size_t patch = 0; patch < mesh.patches.size(); ++patch) {
    list += "- " + mesh.patches[patch];
    list += patch > 0 ? formatted(": %.4g mm across, as a circle of the same area\n",
                                  1e3 * mesh.diameters[patch - 1])
                      : ": the wall\n";
  }
  const std::string cells =
      formatted("%.4g mm in the background mesh, %.4g mm at level %d", 1e3 * mesh.cell,
                1e3 * std::ldexp(mesh.cell, -mesh.finest), mesh.finest);
  return "A vessel for OpenFOAM (openfoam.com, v1912 or later), written by Angiomesh\n\n"
         "    ./Allrun\n\n"
         "fills it with cells. The surface is constant/triSurface/vessel.stl, in metres, in the\n"
         "patient's frame (x to the left, y to the back, z to the head). Its patches:\n\n" +
         list + "\nCells are cubes of " + cells +
         ";\n"
         "each port has about 11 of them across. To change that, change the numbers of cells in\n"
         "system/blockMeshDict or the levels in system/snappyHexMeshDict.\n\n"
         "What flows is yours to say: 0/U and 0/p with a boundary condition for each patch above,\n"
         "constant/transportProperties and constant/turbulenceProperties. system/ is set for\n"
         "simpleFoam without a turbulence model.\n";
}

}  // namespace

std::map<std::string, std::string> openFoamTexts(const OpenFoamMesh& mesh) {
  return {{"Allrun", kAllrun},
          {"README.txt", readme(mesh)},
          {"system/blockMeshDict", dictionary("blockMeshDict", blockMeshDict(mesh))},
          {"system/controlDict", dictionary("controlDict", kControl)},
          {"system/fvSchemes", dictionary("fvSchemes", kSchemes)},
          {"system/fvSolution", dictionary("fvSolution", kSolution)},
          {"system/snappyHexMeshDict", dictionary("snappyHexMeshDict", snappyHexMeshDict(mesh))},
          {"system/surfaceFeatureExtractDict", dictionary("surfaceFeatureExtractDict", kFeatures)}};
}

}  // namespace angiomesh
