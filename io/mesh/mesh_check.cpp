// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <limits>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/mesh/outward.h"
#include "core/openings/port.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_io.h"
#include "io/mesh/mesh_patch.h"
#include "io/mesh/mesh_place.h"
#include "io/mesh/point_merger.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

struct Expected {
  TriMesh mesh;  ///< as the file has to hold it, back in LPS mm
  std::vector<std::string> patchNames;
  bool outward = true;
};

/// As a file of the format gives them back.
void settlePatches(const MeshWriteOptions& options, const fs::path& path, Expected& expected) {
  TriMesh& mesh = expected.mesh;
  // The only solid of an ASCII STL file has a name, too.
  const bool named = meshFormatOf(path)->holdsNames(options.encoding) &&
                     (!mesh.patch.empty() || meshExtension(path) == ".stl");
  std::vector<std::uint32_t> groups(mesh.patch.begin(), mesh.patch.end());
  groups.resize(mesh.triangles.size());
  PatchSet set;
  if (named) set = patchesOfGroups(groups, patchNamesFor(mesh, options.patchNames));
  mesh.patch = std::move(set.patch);
  expected.patchNames = std::move(set.names);
}

Expected expectedMesh(const TriMesh& mesh, const fs::path& path, const MeshWriteOptions& options) {
  TriMesh moved = mesh;
  turnOutward(moved);
  toFilePlace(moved.points, options.frame, options.unit);
  const bool isStl = meshExtension(path) == ".stl";
  if (isStl) {
    TriMesh merged;
    PointMerger merger(merged.points);
    constexpr std::uint32_t unknown = 0xffffffffU;
    std::vector<std::uint32_t> number(moved.points.size(), unknown);
    const bool binary = options.encoding == MeshEncoding::Binary;
    for (auto& t : moved.triangles)
      for (std::uint32_t& corner : t) {
        std::uint32_t& known = number[corner];
        if (known == unknown) {
          const Eigen::Vector3d& p = moved.points[corner];
          const Eigen::Vector3d q = binary ? inSinglePrecision(p) : p;
          known = merger.add(q.x(), q.y(), q.z());
        }
        corner = known;
      }
    merged.triangles = std::move(moved.triangles);
    merged.patch = std::move(moved.patch);
    moved = std::move(merged);
  }
  toPatientPlace(moved.points, options.frame, options.unit);
  Expected expected;
  // Merging may have closed what was a heap of triangles, and a change of unit rounds.
  if (isStl || options.unit != LengthUnit::Millimetre)
    expected.outward = turnOutward(moved).turnedParts == 0;
  expected.mesh = std::move(moved);
  settlePatches(options, path, expected);
  return expected;
}

/// Whether the triangles, some with an area, have about the normal: then it and the centre are
/// those of an opening and no rounding.
bool facesOneWay(const TriMesh& mesh, const std::vector<std::uint32_t>& triangles,
                 const Eigen::Vector3d& normal) {
  constexpr double kLeastShare = 0.5;
  double along = 0.0, all = 0.0;
  for (const std::uint32_t t : triangles) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Eigen::Vector3d area =
        (mesh.points[b] - mesh.points[a]).cross(mesh.points[c] - mesh.points[a]);
    along += area.dot(normal);
    all += area.norm();
  }
  return all > 0.0 && along >= kLeastShare * all;
}

/// What differs between the patches, empty: nothing.
std::string patchFault(const Expected& wanted, const LoadedMesh& found) {
  const auto listOf = [](const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list += (list.empty() ? "" : " ") + name;
    return list.empty() ? std::string("none") : list;
  };
  if (found.patchNames != wanted.patchNames)
    return "patches: " + listOf(found.patchNames) + " instead of " + listOf(wanted.patchNames);
  if (found.mesh.patch.empty() != wanted.mesh.patch.empty()) return "patches of the triangles";
  const std::size_t count = wanted.patchNames.size();
  if (wanted.mesh.patch.empty()) return {};
  const auto was = trianglesByPatch(wanted.mesh, count), is = trianglesByPatch(found.mesh, count);
  for (std::size_t patch = 0; patch < count; ++patch)
    if (is[patch].size() != was[patch].size())
      return "triangles of " + wanted.patchNames[patch] + ": " + std::to_string(is[patch].size()) +
             " instead of " + std::to_string(was[patch].size());
  // Patches may be anything; those that are openings are compared as such.
  const std::vector<Port> measured = measurePatches(wanted.mesh, count - 1);
  std::vector<std::uint16_t> portOf(count, 0);
  std::vector<Port> ports;
  for (std::size_t n = 0; n < measured.size(); ++n) {
    if (!facesOneWay(wanted.mesh, was[n + 1], measured[n].normalLps)) continue;
    ports.push_back(measured[n]);
    ports.back().name = wanted.patchNames[n + 1];
    portOf[n + 1] = static_cast<std::uint16_t>(ports.size());
  }
  TriMesh openings = found.mesh;
  for (std::uint16_t& patch : openings.patch) patch = portOf[patch];
  const std::vector<std::string> faults = portFaults(ports, openings);
  return faults.empty() ? std::string() : faults.front();
}

Eigen::AlignedBox3d boxOf(const TriMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : mesh.points) box.extend(p);
  return box;
}

std::string boxText(const Eigen::AlignedBox3d& box) {
  return formatted("%.9g, %.9g, %.9g to %.9g, %.9g, %.9g mm", box.min().x(), box.min().y(),
                   box.min().z(), box.max().x(), box.max().y(), box.max().z());
}

const char* yesOrNo(bool value) { return value ? "yes" : "no"; }

}  // namespace

MeshFileFacts checkMeshFile(const TriMesh& mesh, const fs::path& path,
                            const MeshWriteOptions& options) {
  const auto differ = [&](const std::string& what) {
    throw IoError("the written file does not hold the mesh (" + what + ")", path.string(),
                  "write it again, to another place or in another format");
  };
  const auto compare = [&](const std::string& what, const auto& found, const auto& wanted,
                           bool equal) {
    if (!equal) differ(what + ": " + found + " instead of " + wanted);
  };
  const auto number = [&](const std::string& what, std::size_t found, std::size_t wanted) {
    compare(what, std::to_string(found), std::to_string(wanted), found == wanted);
  };
  const auto flag = [&](const std::string& what, bool found, bool wanted) {
    compare(what, yesOrNo(found), yesOrNo(wanted), found == wanted);
  };
  const Expected expected = expectedMesh(mesh, path, options);
  const TriMesh& wanted = expected.mesh;
  MeshReadOptions asItIs;
  asItIs.keepPoints = asItIs.keepTurns = true;
  const LoadedMesh loaded = loadMesh(path, asItIs);
  number("vertices", loaded.mesh.points.size(), wanted.points.size());
  number("triangles", loaded.mesh.triangles.size(), wanted.triangles.size());
  compare("frame", frameWord(loaded.frame), frameWord(options.frame),
          loaded.frameStated && loaded.frame == options.frame);
  compare("unit", unitWord(loaded.unit), unitWord(options.unit),
          loaded.unitStated && loaded.unit == options.unit);
  flag("normals", loaded.hasNormals, options.normals);
  flag("quality", loaded.hasQuality, options.quality);
  const Eigen::AlignedBox3d box = boxOf(loaded.mesh), wantedBox = boxOf(wanted);
  const double reach =
      std::max(wantedBox.min().cwiseAbs().maxCoeff(), wantedBox.max().cwiseAbs().maxCoeff());
  // The written numbers read back as the same bits; only the change of unit rounds.
  const double tolerance = 4.0 * std::numeric_limits<double>::epsilon() * reach;
  compare("box", boxText(box), boxText(wantedBox),
          (box.min() - wantedBox.min()).cwiseAbs().maxCoeff() <= tolerance &&
              (box.max() - wantedBox.max()).cwiseAbs().maxCoeff() <= tolerance);
  if (const std::string fault = patchFault(expected, loaded); !fault.empty()) differ(fault);
  MeshFileFacts facts;
  facts.closed = isClosed(loaded.mesh);
  if (loaded.mesh.triangles != wanted.triangles) flag("closed", facts.closed, isClosed(wanted));
  flag("facing outward", loaded.turnedParts == 0, expected.outward);
  facts.vertices = loaded.mesh.points.size();
  facts.triangles = loaded.mesh.triangles.size();
  facts.unit = loaded.unit;
  facts.frame = loaded.frame;
  facts.size = box.sizes() / (loaded.unit == LengthUnit::Metre ? 1e3 : 1.0);
  return facts;
}

}  // namespace angiomesh
