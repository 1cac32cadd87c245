// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QProcess>
#include <QStandardPaths>
#include <QString>
#include <QTemporaryDir>
#include <cmath>
#include <fstream>
#include <vector>

#include "io/mesh/mesh_io.h"
#include "tests/io/io_test.h"

// Programs that fill surfaces, if they are installed: what a flow solver's mesher says of a surface
// counts more than what we say of it.
namespace angiomesh::test {

inline bool isInstalled(const char* program) {
  return !QStandardPaths::findExecutable(program).isEmpty();
}

/// Runs the program in `folder`; its output is added to `log`. False when it cannot be run, takes
/// longer than five minutes or fails.
inline bool runProgram(const QString& program, const QStringList& arguments, const fs::path& folder,
                       QString& log) {
  QProcess process;
  process.setWorkingDirectory(QString::fromStdString(folder.string()));
  process.setProcessChannelMode(QProcess::MergedChannels);
  process.start(program, arguments);
  constexpr int kMilliseconds = 300000;
  const bool ended = process.waitForFinished(kMilliseconds);
  log += QString::fromLocal8Bit(process.readAll());
  return ended && process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
}

/// What a mesh file of Gmsh (format 2, text) holds.
struct GmshMesh {
  std::vector<Eigen::Vector3d> points;  ///< by their numbers, which begin at 1
  std::size_t triangles = 0, tetrahedra = 0;
  double volume = 0.0;       ///< of the tetrahedra
  double leastVolume = 0.0;  ///< of one of them
};

inline GmshMesh readGmsh(const fs::path& path) {
  GmshMesh mesh;
  std::ifstream in(path);
  std::string word;
  std::size_t count = 0, number = 0;
  while (in >> word && word != "$Nodes") continue;
  in >> count;
  mesh.points.resize(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    Eigen::Vector3d p;
    in >> number >> p.x() >> p.y() >> p.z();
    if (number >= mesh.points.size()) mesh.points.resize(number + 1);
    mesh.points[number] = p;
  }
  while (in >> word && word != "$Elements") continue;
  in >> count;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr std::size_t kTriangle = 2, kTetrahedron = 4;
    std::size_t type = 0, tags = 0, tag = 0;
    in >> number >> type >> tags;
    for (std::size_t t = 0; t < tags; ++t) in >> tag;
    std::vector<std::size_t> corners(type == kTetrahedron ? 4 : type == kTriangle ? 3 : type);
    if (type == 1) corners.resize(2);
    if (type == 15) corners.resize(1);
    for (std::size_t& corner : corners) in >> corner;
    if (type == kTriangle) ++mesh.triangles;
    if (type != kTetrahedron) continue;
    const auto at = [&](std::size_t c) { return mesh.points.at(corners[c]); };
    const double volume = (at(1) - at(0)).dot((at(2) - at(0)).cross(at(3) - at(0))) / 6.0;
    mesh.leastVolume = mesh.tetrahedra == 0 ? volume : std::min(mesh.leastVolume, volume);
    mesh.volume += volume;
    ++mesh.tetrahedra;
  }
  return mesh;
}

/// Whether Gmsh fills the closed surface of an STL file with tetrahedra as it is, without a repair:
/// all of its triangles stay, and the tetrahedra, each the right way round, fill its volume. `log`
/// says what happened. Gmsh must be installed.
inline bool fillsWithTetrahedra(const fs::path& stl, QString& log) {
  const QTemporaryDir scratch;
  const fs::path folder = scratch.path().toStdString();
  fs::copy_file(stl, folder / "surface.stl");
  save(folder / "fill.geo",
       "Merge \"surface.stl\";\nsides() = Surface{:};\nSurface Loop(1) = sides();\n"
       "Volume(1) = {1};\n");
  if (!runProgram("gmsh", {"-3", "fill.geo", "-o", "filled.msh", "-format", "msh2"}, folder, log))
    return false;
  const LoadedMesh surface = loadMesh(stl);
  const double scale = surface.unit == LengthUnit::Metre ? 1e-9 : 1.0;
  const double wanted = scale * enclosedVolumeMm3(surface.mesh);
  const GmshMesh filled = readGmsh(folder / "filled.msh");
  log += QString("%1 of %2 triangles, %3 tetrahedra, volume %4 instead of %5, least %6\n")
             .arg(filled.triangles)
             .arg(surface.mesh.triangles.size())
             .arg(filled.tetrahedra)
             .arg(filled.volume)
             .arg(wanted)
             .arg(filled.leastVolume);
  return filled.triangles == surface.mesh.triangles.size() && filled.tetrahedra > 0 &&
         filled.leastVolume > 0.0 && std::fabs(filled.volume / wanted - 1.0) < 1e-6;
}

}  // namespace angiomesh::test
