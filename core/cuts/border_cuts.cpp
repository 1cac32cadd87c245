// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/border_cuts.h"

#include <algorithm>
#include <array>
#include <set>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/cuts/border_slant.h"
#include "core/cuts/clip_reference.h"
#include "core/image/voxels.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// One of the outermost planes of voxel centres.
struct BorderPlane {
  std::size_t axis = 0, u = 1, v = 2;  ///< across it, and its own two
  int layer = 0;
  Vector3d normal;
  double areaMm2 = 0.0, voxelMm = 0.0;  ///< of a voxel in it: u x v, and the shorter of them
};

/// The openings as parts of the planes that are connected.
class BorderFinder {
 public:
  explicit BorderFinder(const Volume<float>& phi) : phi_(phi), grid_(phi.geometry) {
    const EndPlanes ends(grid_);
    for (int n = 0; n < 6; ++n) {
      BorderPlane plane;
      plane.axis = static_cast<std::size_t>(n / 2);
      plane.u = (plane.axis + 1) % 3;
      plane.v = (plane.axis + 2) % 3;
      plane.layer = n % 2 == 0 ? 0 : grid_.size[plane.axis] - 1;
      plane.normal = ends.normal(n);
      const double u = grid_.spacing[static_cast<Eigen::Index>(plane.u)];
      const double v = grid_.spacing[static_cast<Eigen::Index>(plane.v)];
      plane.areaMm2 = u * v;
      plane.voxelMm = std::min(u, v);
      taken_[static_cast<std::size_t>(n)].assign(static_cast<std::size_t>(grid_.size[plane.u]) *
                                                     static_cast<std::size_t>(grid_.size[plane.v]),
                                                 0);
      planes_[static_cast<std::size_t>(n)] = plane;
    }
  }

  std::vector<Port> run() {
    std::vector<Port> openings;
    for (std::size_t n = 0; n < planes_.size(); ++n) {
      const BorderPlane& plane = planes_[n];
      Index3 p{};
      p[plane.axis] = plane.layer;
      for (p[plane.v] = 0; p[plane.v] < grid_.size[plane.v]; ++p[plane.v])
        for (p[plane.u] = 0; p[plane.u] < grid_.size[plane.u]; ++p[plane.u])
          if (valueAt(p) < 0.0 && placeOf(n, p) == 0) openings.push_back(openingAt(n, p));
    }
    return openings;
  }

 private:
  struct Node {
    std::size_t plane;
    Index3 voxel;
  };

  [[nodiscard]] double valueAt(const Index3& p) const {
    return static_cast<double>(phi_.at(p[0], p[1], p[2]));
  }
  char& placeOf(std::size_t n, const Index3& p) {
    const BorderPlane& plane = planes_[n];
    return taken_[n][static_cast<std::size_t>(p[plane.u]) +
                     static_cast<std::size_t>(grid_.size[plane.u]) *
                         static_cast<std::size_t>(p[plane.v])];
  }
  void take(std::size_t n, const Index3& p, std::vector<Node>& found) {
    char& taken = placeOf(n, p);
    if (taken == 0) found.push_back({n, p});
    taken = 1;
  }

  // Of what is beside the inside, the share that the distance leaves.
  Port openingAt(std::size_t first, const Index3& voxel) {
    std::vector<Node> found;
    take(first, voxel, found);
    Vector3d moment = Vector3d::Zero(), normal = Vector3d::Zero();
    double area = 0.0;
    for (std::size_t n = 0; n < found.size(); ++n) {
      const Node node = found[n];
      const BorderPlane& plane = planes_[node.plane];
      const Index3& p = node.voxel;
      const double part =
          plane.areaMm2 * std::clamp(0.5 - valueAt(p) / plane.voxelMm, 0.0, 1.0) * halves(node);
      area += part;
      moment += part * voxelCentre(grid_, p);
      normal += part * plane.normal;
      if (valueAt(p) < 0.0) takeAround(node, found);
    }
    Port port;
    port.centreLps = moment / area;
    port.normalLps = normal.normalized();
    port.areaMm2 = area;
    port.atBorder = true;
    return port;
  }

  // Of a voxel at an edge of the plane only the half within it counts.
  [[nodiscard]] double halves(const Node& node) const {
    const BorderPlane& plane = planes_[node.plane];
    double part = 1.0;
    for (const std::size_t a : {plane.u, plane.v})
      if (node.voxel[a] == 0 || node.voxel[a] == grid_.size[a] - 1) part *= 0.5;
    return part;
  }

  void takeAround(const Node& node, std::vector<Node>& found) {
    const BorderPlane& plane = planes_[node.plane];
    for (int dv = -1; dv <= 1; ++dv)
      for (int du = -1; du <= 1; ++du) {
        Index3 q = node.voxel;
        q[plane.u] += du;
        q[plane.v] += dv;
        if (grid_.contains(q[0], q[1], q[2])) take(node.plane, q, found);
      }
  }

  const Volume<float>& phi_;
  const Geometry& grid_;
  std::array<BorderPlane, 6> planes_;
  std::array<std::vector<char>, 6> taken_;
};

/// The names that go by places; by the names of ports there are none yet.
std::vector<std::string> placesIn(const PortParams& params) {
  std::vector<std::string> places;
  for (const std::string& text : params.names)
    if (parsePortNaming(text).placeLps) places.push_back(text);
  return places;
}

}  // namespace

std::vector<Port> borderOpenings(const Volume<float>& phi) { return BorderFinder(phi).run(); }

std::vector<std::string> addBorderCuts(const SplineField& field, const Volume<float>& phi,
                                       CutAway& away, const PortParams& params,
                                       const Progress& progress) {
  std::vector<std::string> remarks;
  std::vector<CutPlane> planes = away.planes();
  std::vector<std::string> names = away.names;
  std::set<std::string> taken(names.begin(), names.end());
  std::vector<Port> openings = borderOpenings(phi);
  PortParams named;
  named.names = placesIn(params);
  (void)namePorts(named, openings);
  int number = 1;
  for (const Port& opening : openings) {
    progress.check();
    if (!away.empty() && away.takenAt(opening.centreLps)) continue;
    const std::optional<BorderSlant> slant = borderSlant(field, phi, opening);
    if (!slant || !slant->flagged()) continue;
    while (taken.count("across_" + std::to_string(number)) != 0) ++number;
    const std::string name =
        opening.name.empty() ? "across_" + std::to_string(number) : opening.name;
    planes.push_back({slant->centreLps, slant->axisLps});
    names.push_back(name);
    try {
      away = checkedCutAway(field, phi, planes, names, progress);
      taken.insert(name);
    } catch (const InputError& error) {
      planes.pop_back();
      names.pop_back();
      remarks.push_back("the opening at the border at " + placeText(opening.centreLps) +
                        " was not cut: " + error.cause());
    }
  }
  return remarks;
}

}  // namespace angiomesh
