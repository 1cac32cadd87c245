// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/centreline/skeleton_graph.h"
#include "tests/core/analytic.h"

using namespace angiomesh;
using Eigen::Vector3d;
using Voxels = std::vector<std::uint32_t>;

namespace {

const Vector3d kCentre(24, 24, 24);

/// Vessels on a grid of 49^3 voxels of 1 mm, and paths in them that the test chooses.
struct Vessels {
  Volume<float> phi;
  VoxelSet set;
  CentreLines lines;

  template <class F>
  explicit Vessels(F f)
      : phi(analytic::clamped(analytic::cube(49), f)), set(labelled(phi), 1), lines(phi, set) {}

  static Volume<std::int32_t> labelled(const Volume<float>& phi) {
    Volume<std::int32_t> labels(phi.geometry, 0);
    for (std::size_t n = 0; n < labels.voxels.size(); ++n)
      labels.voxels[n] = phi.voxels[n] < 0.0F ? 1 : 0;
    return labels;
  }

  /// The voxel so far from the middle of the volume.
  [[nodiscard]] std::uint32_t at(const Vector3d& offset) const {
    return set.numberAt(kCentre + offset).value();
  }
  [[nodiscard]] Vector3d offsetOf(std::uint32_t voxel) const {
    return set.position(voxel) - kCentre;
  }
  /// Appends the voxels on the straight way to a place.
  void go(Voxels& points, const Vector3d& to) const {
    const Vector3d from = offsetOf(points.back()), way = to - from;
    const int steps = static_cast<int>(way.cwiseAbs().maxCoeff());
    for (int n = 1; n <= steps; ++n)
      points.push_back(at((from + way * n / steps).array().round().matrix()));
  }
  [[nodiscard]] Voxels path(const std::vector<Vector3d>& corners) const {
    Voxels points{at(corners.front())};
    for (std::size_t n = 1; n < corners.size(); ++n) go(points, corners[n]);
    return points;
  }
};

}  // namespace

class TestSkeletonGraph : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// However far along the trunk a path goes beside its line before it joins: the joint is where
  /// the branch comes in.
  void jointsAreMovedToTheMiddleOfTheParting() {
    const Vessels vessels([](const Vector3d& x) {
      return std::min(analytic::tube(x, kCentre, Vector3d::UnitZ(), 4.2),
                      analytic::capsule(x, kCentre, kCentre + Vector3d(22, 0, 0), 2.2));
    });
    for (const double late : {-9.0, -6.0, -3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0, 6.0, 9.0})
      for (const bool upwards : {true, false}) {
        CentreLines::Path trunk, branch;
        const double end = upwards ? 24.0 : -24.0;
        trunk.points = vessels.path({{0, 0, -end}, {0, 0, end}});
        const double side = std::copysign(1.0, late);
        branch.points = vessels.path({{21, 0, 0}, {3, 0, 0}, {1, 0, late - side}, {0, 0, late}});
        branch.back.joins = true;
        const ChainGraph graph = chainsOf(vessels.lines, vessels.set, {trunk, branch});
        QCOMPARE(graph.nodes.size(), std::size_t{4});
        QCOMPARE(graph.chains.size(), std::size_t{3});
        for (const ChainGraph::Node& node : graph.nodes)
          if (node.kind == NodeKind::Junction) {
            QCOMPARE(node.chains, 3);
            QCOMPARE(vessels.offsetOf(node.voxel), Vector3d(0, 0, 0));
          }
      }
  }

  /// Where two ways around a ring meet at the wall of a wide place the line goes straight from its
  /// middle, not out to the wall and back.
  void ringsAreClosedStraight() {
    const double wide = 4.4, up = 15.0, out = 13.0;
    const std::vector<Vector3d> ring{{0, 0, 0}, {out, 0, 0}, {out, 0, up}, {0, 0, up}};
    const Vessels vessels([&](const Vector3d& x) {
      double value = std::min(analytic::ball(x, kCentre, wide),
                              analytic::tube(x, kCentre, Vector3d::UnitZ(), 2.2));
      for (std::size_t n = 0; n + 1 < ring.size(); ++n)
        value =
            std::min(value, analytic::capsule(x, kCentre + ring[n], kCentre + ring[n + 1], 2.2));
      return value;
    });
    CentreLines::Path trunk, branch;
    trunk.points = vessels.path({{0, 0, -24}, {0, 0, 24}});
    branch.points = {vessels.at({0, 0, 0})};
    branch.points.push_back(vessels.at({0, 3, 3}));  // at the wall
    for (const Vector3d& corner : {Vector3d(2, 1, 1), Vector3d(3, 0, 0), ring[1], ring[2], ring[3]})
      vessels.go(branch.points, corner);
    branch.front.joins = branch.back.joins = true;
    const ChainGraph graph = chainsOf(vessels.lines, vessels.set, {trunk, branch});
    QCOMPARE(graph.nodes.size(), std::size_t{4});
    QCOMPARE(graph.chains.size(), std::size_t{4});
    int steps = 0;
    for (const Chain& chain : graph.chains)
      for (const std::uint32_t voxel : chain.voxels) {
        const Vector3d offset = vessels.offsetOf(voxel);
        QCOMPARE(offset.y(), 0.0);
        if (offset.x() > 0.0 && offset.z() == 0.0) ++steps;
      }
    QCOMPARE(steps, static_cast<int>(out));
  }
};

QTEST_APPLESS_MAIN(TestSkeletonGraph)
#include "tst_skeleton_graph.moc"
