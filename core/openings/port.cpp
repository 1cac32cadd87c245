// SPDX-License-Identifier: BSD-3-Clause
#include "core/openings/port.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/base/formatted.h"
#include "core/mesh/flat_area.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/triangle_shape.h"

namespace angiomesh {
namespace {

// A rim is a polygon: of twelve sides it holds 4.5 % less than its circle, and smoothing gives that
// back.
constexpr double kLargestShare = 0.1;
constexpr double kLargestTurn = 2.0;  // degrees

/// The rims are in a port's plane to this share of its diameter, what single precision leaves.
constexpr double kHair = 1e-4;

/// Of the open ones among `rims`, those of the port.
Port openPort(const Port& port, const std::vector<RimEdge>& rims, const TriMesh& mesh) {
  FlatArea area(port.normalLps);
  for (const RimEdge& edge : rims) {
    const Eigen::Vector3d &a = mesh.points[edge.from], &b = mesh.points[edge.to];
    if (edge.open && port.opensAt(a) && port.opensAt(b)) area.add(a, b);
  }
  if (!(area.areaMm2() > 0.0)) return {port.name, port.centreLps, port.normalLps, 0.0};
  return {port.name, area.centre(), port.normalLps, area.areaMm2()};
}

}  // namespace

double Port::equivalentDiameterMm() const { return angiomesh::equivalentDiameterMm(areaMm2); }

bool Port::opensAt(const Eigen::Vector3d& pointLps) const {
  const double size = equivalentDiameterMm();
  const Eigen::Vector3d d = pointLps - centreLps;
  return d.norm() < 3.0 * size && std::fabs(d.dot(normalLps)) < kHair * size;
}

std::vector<Port> measurePatches(const TriMesh& mesh, std::size_t count) {
  std::vector<Port> patches(count);
  std::vector<Eigen::Vector3d> about(count), moment(count, Eigen::Vector3d::Zero()),
      twice(count, Eigen::Vector3d::Zero());
  std::vector<double> sum(count, 0.0);
  for (std::size_t t = 0; t < mesh.patch.size(); ++t) {
    if (mesh.patch[t] == 0 || mesh.patch[t] > count) continue;
    const std::size_t n = mesh.patch[t] - 1U;
    const auto& corners = mesh.triangles[t];
    const Eigen::Vector3d &a = mesh.points[corners[0]], &b = mesh.points[corners[1]],
                          &c = mesh.points[corners[2]];
    // About a point of the patch: coordinates of patients may be large.
    if (sum[n] == 0.0) about[n] = a;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    const double area = 0.5 * normal.norm();
    twice[n] += normal;
    moment[n] += area * ((a + b + c) / 3.0 - about[n]);
    sum[n] += area;
  }
  for (std::size_t n = 0; n < count; ++n) {
    if (!(sum[n] > 0.0)) continue;
    patches[n].areaMm2 = sum[n];
    patches[n].centreLps = about[n] + moment[n] / sum[n];
    patches[n].normalLps = twice[n].normalized();
  }
  return patches;
}

std::vector<Port> measuredPorts(const std::vector<Port>& ports, const TriMesh& mesh) {
  std::vector<Port> measured = measurePatches(mesh, ports.size());
  std::optional<std::vector<RimEdge>> rims;
  for (std::size_t n = 0; n < ports.size(); ++n) {
    if (!(measured[n].areaMm2 > 0.0)) {
      if (!rims) rims = rimEdges(mesh);
      measured[n] = openPort(ports[n], *rims, mesh);
    }
    measured[n].name = ports[n].name;
    measured[n].atBorder = ports[n].atBorder;
    measured[n].slant = ports[n].slant;
  }
  return measured;
}

std::vector<std::string> portFaults(const std::vector<Port>& expected, const TriMesh& mesh) {
  const std::vector<Port> found = measuredPorts(expected, mesh);
  std::vector<std::string> faults;
  for (std::size_t n = 0; n < expected.size(); ++n) {
    const Port &was = expected[n], &is = found[n];
    const double turn =
        angleDegrees(is.normalLps.cross(was.normalLps).norm(), is.normalLps.dot(was.normalLps));
    std::string text;
    if (!(is.areaMm2 > 0.0))
      text = "is not there any more";
    else if (std::fabs(is.areaMm2 - was.areaMm2) > kLargestShare * was.areaMm2)
      text = formatted("has an area of %.4g mm2 instead of %.4g mm2", is.areaMm2, was.areaMm2);
    else if ((is.centreLps - was.centreLps).norm() > kLargestShare * was.equivalentDiameterMm())
      text = formatted("has its centre %.3g mm from where it was",
                       (is.centreLps - was.centreLps).norm());
    else if (turn > kLargestTurn)
      text = formatted("has turned by %.2f degrees", turn);
    if (!text.empty()) faults.push_back("the port '" + was.name + "' " + text);
  }
  return faults;
}

}  // namespace angiomesh
