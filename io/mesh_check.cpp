// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <cstdio>
#include <limits>

#include "core/base/error.h"
#include "core/surface/outward.h"
#include "io/mesh_io.h"
#include "io/mesh_place.h"
#include "io/point_merger.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

struct Expected {
  TriMesh mesh;  ///< as the file has to hold it, back in LPS mm
  bool outward = true;
};

Expected expectedMesh(const TriMesh& mesh, const fs::path& path, const MeshWriteOptions& options) {
  TriMesh moved = mesh;
  turnOutward(moved);
  toFilePlace(moved.points, options.frame, options.unit);
  if (meshExtension(path) == ".stl") {
    TriMesh merged;
    PointMerger merger(merged.points);
    for (auto t : moved.triangles) {
      for (std::uint32_t& corner : t) {
        const Eigen::Vector3d& p = moved.points[corner];
        const bool binary = options.encoding == MeshEncoding::Binary;
        const Eigen::Vector3d q = binary ? inSinglePrecision(p) : p;
        corner = merger.add(q.x(), q.y(), q.z());
      }
      merged.triangles.push_back(t);
    }
    moved = std::move(merged);
  }
  toPatientPlace(moved.points, options.frame, options.unit);
  Expected expected;
  // Merging may have closed what was a heap of triangles.
  expected.outward = turnOutward(moved).turnedParts == 0;
  expected.mesh = std::move(moved);
  return expected;
}

Eigen::AlignedBox3d boxOf(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  return box;
}

std::string boxText(const Eigen::AlignedBox3d& box) {
  char text[200];
  std::snprintf(text, sizeof text, "%.9g, %.9g, %.9g to %.9g, %.9g, %.9g mm", box.min().x(),
                box.min().y(), box.min().z(), box.max().x(), box.max().y(), box.max().z());
  return text;
}

const char* yesOrNo(bool value) { return value ? "yes" : "no"; }

}  // namespace

MeshFileFacts checkMeshFile(const TriMesh& mesh, const fs::path& path,
                            const MeshWriteOptions& options) {
  const auto compare = [&](const std::string& what, const auto& found, const auto& wanted,
                           bool equal) {
    if (!equal)
      throw IoError("the written file does not hold the mesh (" + what + ": " + found +
                        " instead of " + wanted + ")",
                    path.string(), "write it again, to another place or in another format");
  };
  const auto number = [&](const std::string& what, std::size_t found, std::size_t wanted) {
    compare(what, std::to_string(found), std::to_string(wanted), found == wanted);
  };
  const auto flag = [&](const std::string& what, bool found, bool wanted) {
    compare(what, yesOrNo(found), yesOrNo(wanted), found == wanted);
  };
  const auto [wanted, outward] = expectedMesh(mesh, path, options);
  const LoadedMesh loaded = loadMesh(path);
  number("vertices", loaded.mesh.points.size(), wanted.points.size());
  number("triangles", loaded.mesh.triangles.size(), wanted.triangles.size());
  compare("frame", frameWord(loaded.frame), frameWord(options.frame),
          loaded.frameStated && loaded.frame == options.frame);
  compare("unit", unitWord(loaded.unit), unitWord(options.unit),
          loaded.unitStated && loaded.unit == options.unit);
  flag("normals", loaded.hasNormals, options.normals);
  flag("quality", loaded.hasQuality, options.quality);
  if (!options.parts.empty()) number("parts", loaded.parts.size(), options.parts.size());
  const Eigen::AlignedBox3d box = boxOf(loaded.mesh), wantedBox = boxOf(wanted);
  const double reach =
      std::max(wantedBox.min().cwiseAbs().maxCoeff(), wantedBox.max().cwiseAbs().maxCoeff());
  // The written numbers read back as the same bits; only the change of unit rounds.
  const double tolerance = 4.0 * std::numeric_limits<double>::epsilon() * reach;
  compare("box", boxText(box), boxText(wantedBox),
          (box.min() - wantedBox.min()).cwiseAbs().maxCoeff() <= tolerance &&
              (box.max() - wantedBox.max()).cwiseAbs().maxCoeff() <= tolerance);
  MeshFileFacts facts;
  facts.closed = isClosed(loaded.mesh);
  flag("closed", facts.closed, isClosed(wanted));
  flag("facing outward", loaded.warnings.empty(), outward);
  facts.vertices = loaded.mesh.points.size();
  facts.triangles = loaded.mesh.triangles.size();
  facts.unit = loaded.unit;
  facts.frame = loaded.frame;
  facts.size = box.sizes() / (loaded.unit == LengthUnit::Metre ? 1e3 : 1.0);
  return facts;
}

}  // namespace angiomesh
