// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/study_ports.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "app/session/mesh_files.h"
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/cuts/cuts.h"
#include "core/field/wall_field.h"
#include "io/mesh/mesh_io.h"
#include "io/vessel/ports_file.h"

namespace angiomesh::cli {
namespace {

using Eigen::Vector3d;

constexpr const char* kName = "here";
constexpr int kTries = 100;
constexpr double kLargestTilt = 0.6;  // radians

/// Vertices where two planes meet: no mesher chooses the angle there.
std::vector<char> rimCorners(const TriMesh& mesh) {
  std::vector<std::set<std::uint16_t>> patches(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (!mesh.patch.empty() && mesh.patch[t] != 0)
      for (const std::uint32_t v : mesh.triangles[t]) patches[v].insert(mesh.patch[t]);
  std::vector<char> corner(mesh.points.size(), 0);
  for (std::size_t v = 0; v < corner.size(); ++v) corner[v] = patches[v].size() > 1 ? 1 : 0;
  return corner;
}

double leastAngle(const TriMesh& mesh) {
  const std::vector<char> corner = rimCorners(mesh);
  const std::vector<TriangleShape> shapes = shapesOf(mesh);
  double least = 180.0;
  for (std::size_t t = 0; t < shapes.size(); ++t) {
    const auto& c = mesh.triangles[t];
    if (corner[c[0]] == 0 && corner[c[1]] == 0 && corner[c[2]] == 0)
      least = std::min(least, shapes[t].minAngle);
  }
  return least;
}

double offPlane(const TriMesh& mesh, const Port& port) {
  double most = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (mesh.patch[t] == 1)
      for (const std::uint32_t v : mesh.triangles[t])
        most = std::max(most, std::fabs((mesh.points[v] - port.centreLps).dot(port.normalLps)));
  return most;
}

/// Whether the same port is among others: what a cut elsewhere must not change.
bool isAmong(const Port& port, const std::vector<Port>& ports) {
  return std::any_of(ports.begin(), ports.end(), [&](const Port& other) {
    return (other.centreLps - port.centreLps).norm() < 0.02 * port.equivalentDiameterMm() &&
           std::fabs(other.areaMm2 / port.areaMm2 - 1.0) < 0.02;
  });
}

/// Formats that do not give the ports back.
std::size_t faultsOfFormats(const TriMesh& mesh, const std::vector<Port>& ports,
                            const std::filesystem::path& surface) {
  std::size_t faults = 0;
  for (const char* extension : {".ply", ".vtp", ".obj", ".stl"}) {
    MeshWriteOptions write;
    write.patchNames = patchNamesOf(ports);
    if (std::string(extension) != ".vtp") write.encoding = MeshEncoding::Ascii;
    std::filesystem::path path = surface;
    path.replace_extension(extension);
    writeMesh(mesh, path, write);
    const LoadedMesh back = loadMesh(path);
    if (back.patchNames != write.patchNames || !portFaults(ports, back.mesh).empty()) ++faults;
    if (path != surface) std::filesystem::remove(path);
  }
  return faults;
}

}  // namespace

PortStudy::PortStudy(Source source, const Parameters& params, const Progress& progress)
    : pipeline_(std::move(source)), params_(params), uncut_(pipeline_.run(params, {}, progress)) {
  field_ = std::make_unique<SplineField>(wallField(*uncut_.surface->phi, params.surface.spline));
  skeleton_ = skeletonOf(*uncut_.surface->phi, progress);
}

double PortStudy::uncutMinAngle() const { return leastAngle(*uncut_.smoothed); }

// On a centre line, or beside it in the vessel; across it, or tilted.
std::string PortStudy::randomCut(std::uint64_t seed, std::uint64_t& counter) const {
  const auto uniform = [&] { return randomUniform(seed, counter++); };
  std::size_t points = 0;
  for (const SkeletonBranch& branch : skeleton_.branches) points += branch.points.size() - 1;
  if (points == 0)
    throw NumericError("the segmentation has no centre line", "study ports", "give another image");
  auto at = std::min(points - 1, static_cast<std::size_t>(uniform() * static_cast<double>(points)));
  const SkeletonBranch* branch = skeleton_.branches.data();
  while (at + 1 >= branch->points.size()) {
    at -= branch->points.size() - 1;
    ++branch;
  }
  const SkeletonPoint& here = branch->points[at];
  const Vector3d axis = (branch->points[at + 1].pointLps - here.pointLps).normalized();
  const Vector3d side =
      Eigen::AngleAxisd(2.0 * std::numbers::pi * uniform(), axis) * Vector3d(axis.unitOrthogonal());
  GivenCut cut;
  cut.name = kName;
  cut.pointLps = here.pointLps + 0.5 * uniform() * here.inscribedMm * side;
  const bool given = uniform() < 0.5;
  const double tilt = kLargestTilt * uniform();
  const double sign = uniform() < 0.5 ? -1.0 : 1.0;
  const Vector3d across =
      Eigen::AngleAxisd(2.0 * std::numbers::pi * uniform(), axis) * Vector3d(axis.unitOrthogonal());
  if (given) cut.normalLps = sign * (std::cos(tilt) * axis + std::sin(tilt) * across);
  return cutText(cut);
}

PortCase PortStudy::run(std::uint64_t seed, int number, const std::filesystem::path& surface,
                        const Progress& progress) {
  PortCase made;
  std::uint64_t counter = static_cast<std::uint64_t>(number) << 20U;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    made.cut = randomCut(seed, counter);
    Parameters params = params_;
    params.ports.cuts = {made.cut};
    std::vector<double> areas;
    try {
      for (const double rho : {0.3, 0.5, 0.4}) {
        params.surface.sizing.rho = rho;
        RunOptions options;
        options.until = rho == 0.4 ? Step::Quality : Step::Smooth;
        const RunResult result = pipeline_.run(params, options, progress);
        if (result.surface->sectionAreasMm2.empty())
          throw InputError("the part that the cut ends is left out", "study ports",
                           "keep all components");
        if (result.ports.empty() || result.ports[0].name != kName) {
          ++made.nameFaults;
          continue;
        }
        areas.push_back(result.ports[0].areaMm2);
        if (rho != 0.4) continue;
        measure(result, made);
        made.nameFaults += faultsOfFormats(*result.smoothed, result.ports, surface);
      }
    } catch (const InputError& error) {
      // The place is in the first half of the message.
      const std::string why = error.what();
      ++refusals_[why.substr(0, why.find(" at L"))];
      ++made.refused;
      continue;
    }
    const auto [least, most] = std::minmax_element(areas.begin(), areas.end());
    if (!areas.empty()) made.spreadPercent = 100.0 * (*most / *least - 1.0);
    return made;
  }
  throw NumericError("no place could be cut in " + std::to_string(kTries) + " attempts",
                     "study ports", "give another image");
}

void PortStudy::measure(const RunResult& result, PortCase& made) const {
  const TriMesh& mesh = *result.smoothed;
  const Port& port = result.ports[0];
  made.triangles = mesh.triangles.size();
  made.offPlaneMm = offPlane(mesh, port);
  made.areaErrorPercent = 100.0 * (port.areaMm2 / result.surface->sectionAreasMm2[0] - 1.0);
  made.minAngle = leastAngle(mesh);
  made.intersections = result.quality->mesh.selfIntersections;
  const std::size_t before = uncut_.surface->origin.unverified();
  const std::size_t after = result.surface->origin.unverified();
  made.unverified = after > before ? after - before : 0;
  std::vector<std::string> remarks;
  const CutAway away = makeCuts(*field_, *uncut_.surface->phi, result.params.ports, remarks);
  const Section& section = away.sections[0];
  const double reach = section.radiusMm + 2.0 * field_->geometry().voxelMm();
  for (const Vector3d& p : mesh.points)
    if ((p - section.centreLps).norm() > reach && away.takenAt(p)) ++made.leaks;
  for (const Port& was : uncut_.ports)
    if (!away.takenAt(was.centreLps) && !isAmong(was, result.ports)) ++made.leaks;
}

}  // namespace angiomesh::cli
