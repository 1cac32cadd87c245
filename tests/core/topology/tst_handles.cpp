// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/contour/marching_cubes.h"
#include "core/quality/mesh_quality.h"
#include "core/topology/close_handles.h"
#include "core/topology/handles.h"
#include "core/topology/voxel_topology.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

using Function = std::function<double(const Eigen::Vector3d&)>;

const Eigen::Vector3d kAlongX(1.0, 0.0, 0.0), kAlongY(0.0, 1.0, 0.0), kAlongZ(0.0, 0.0, 1.0);

/// A tube along z with a channel of one voxel through it along x.
Volume<float> tubeWithAHole(const Geometry& g, double radius, const Index3& at) {
  const Eigen::Vector3d c = voxelCentre(g, at);
  return clamped(g, [&](const auto& x) {
    return std::max(tube(x, c, kAlongZ, radius), -tube(x, c, kAlongX, 0.3));
  });
}

/// Independent values, the fewer of them inside the larger `seed` is.
Volume<float> anything(std::uint64_t seed) {
  Volume<float> phi(oblique(17, 15, 16));
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    phi.voxels[i] =
        static_cast<float>(randomNormal(seed, i) + 0.25 * static_cast<double>(seed) - 0.4);
  return phi;
}

/// Euler's number of the voxels as closed cubes, which is that of 26-connected objects.
int eulerOf(const Volume<float>& phi) {
  const Geometry& g = phi.geometry;
  const auto inside = [&](int i, int j, int k) {
    return g.contains(i, j, k) && phi.at(i, j, k) < 0.0F;
  };
  int euler = 0;
  // A cell of the doubled grid is there when a voxel around it is.
  for (int k = 0; k <= 2 * g.size[2]; ++k)
    for (int j = 0; j <= 2 * g.size[1]; ++j)
      for (int i = 0; i <= 2 * g.size[0]; ++i) {
        bool there = false;
        for (int c = (k % 2 != 0 ? k / 2 : k / 2 - 1); c <= k / 2; ++c)
          for (int b = (j % 2 != 0 ? j / 2 : j / 2 - 1); b <= j / 2; ++b)
            for (int a = (i % 2 != 0 ? i / 2 : i / 2 - 1); a <= i / 2; ++a)
              there = there || inside(a, b, c);
        if (there) euler += (i % 2 + j % 2 + k % 2) % 2 == 0 ? 1 : -1;
      }
  return euler;
}

}  // namespace

class TestHandles : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreads(0); }

  void topologicalNumbers() {
    const auto bit = [](int i, int j, int k) {
      return VoxelBits{1} << (static_cast<int>(kMiddle27) + i + 3 * j + 9 * k);
    };
    QCOMPARE(voxelTopology(0).object, 0);
    QCOMPARE(voxelTopology(0).background, 1);
    QCOMPARE(voxelTopology((1U << 27) - 1).background, 0);
    QVERIFY(voxelTopology(bit(1, 1, 1)).simple());
    const VoxelTopology two = voxelTopology(bit(1, 0, 0) | bit(-1, 1, 1));
    QCOMPARE(two.object, 2);
    QCOMPARE(two.background, 1);
    VoxelBits plate = 0;
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i)
        if (i != 0 || j != 0) plate |= bit(i, j, 0);
    const VoxelTopology hole = voxelTopology(plate);
    QCOMPARE(hole.object, 1);
    QCOMPARE(hole.background, 2);
    // Corners in the background that share no face with the middle are no part of it.
    QVERIFY(voxelTopology(((1U << 27) - 1) & ~bit(1, 1, 1) & ~bit(1, 0, 0)).simple());
  }

  void roundBodiesHaveNone() {
    const Geometry g = cube(30);
    const Eigen::Vector3d c = centreOf(g);
    QVERIFY(handlesOf(clamped(g, [&](const auto& x) { return ball(x, c, 9.3); })).empty());
    QVERIFY(handlesOf(clamped(g, [&](const auto& x) {
              return std::min(tube(x, c, kAlongZ, 3.2), tube(x, c, {0.6, 0.0, 0.8}, 2.1));
            })).empty());
    // A cavity is no handle.
    QVERIFY(handlesOf(clamped(g, [&](const auto& x) {
              return std::max(ball(x, c, 11.0), -ball(x, c, 4.0));
            })).empty());
    QVERIFY(handlesOf(clamped(g, [](const auto&) { return 1.0; })).empty());
    QVERIFY(handlesOf(clamped(g, [](const auto&) { return -1.0; })).empty());
  }

  void aRingHasOneAsLongAsItsInside() {
    for (const Geometry& g : {cube(48), oblique(90, 80, 60)}) {
      const Eigen::Vector3d c = centreOf(g);
      const double ring = 13.0, r = 3.1;
      const std::vector<Handle> found =
          handlesOf(clamped(g, [&](const auto& x) { return torus(x, c, ring, r); }));
      QCOMPARE(found.size(), std::size_t{1});
      const Handle& one = found[0];
      QVERIFY(!one.lengthIsLeast);
      // Steps between voxels are up to a tenth longer than a curve.
      QVERIFY2(one.lengthMm > 2 * M_PI * (ring - r) * 0.98 && one.lengthMm < 2 * M_PI * ring * 1.1,
               qPrintable(QString::number(one.lengthMm)));
      const double depth = std::min(r, 5.0 * g.voxelMm());  // phi is clamped
      QVERIFY(std::fabs(one.depthMm - depth) < 0.6 * g.spacing.norm());
      QVERIFY(one.kind == HandleKind::Loop);
      QVERIFY(std::fabs(torus(one.placeLps, c, ring, r)) < r);
      QVERIFY((one.centreLps - c).norm() < 1.5);
    }
  }

  void theLoopClosesWhereItIsThinnest() {
    const Geometry g = cube(48);
    const Eigen::Vector3d c = centreOf(g);
    const std::vector<Handle> found = handlesOf(clamped(g, [&](const Eigen::Vector3d& x) {
      const Eigen::Vector3d d = x - c;
      return torus(x, c, 13.0,
                   3.0 - 1.5 * std::exp(-(d - Eigen::Vector3d(0, 13, 0)).squaredNorm() / 20.0));
    }));
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY((found[0].placeLps - c - Eigen::Vector3d(0, 13, 0)).norm() < 3.0);
    QVERIFY(found[0].depthMm < 1.6);
  }

  void twoRingsHaveTwo() {
    const Geometry g = cube(60);
    const Eigen::Vector3d c = centreOf(g);
    const Eigen::Vector3d aside(10.5, 0.0, 0.0);
    const std::vector<Handle> joined = handlesOf(clamped(g, [&](const auto& x) {
      return std::min(torus(x, c + aside, 11.0, 2.6), torus(x, c - aside, 11.0, 3.4));
    }));
    QCOMPARE(joined.size(), std::size_t{2});
    QCOMPARE(joined[0].component, 1);
    QCOMPARE(joined[1].component, 1);
    const Eigen::Vector3d far(14.5, 0.0, 0.0);
    const std::vector<Handle> apart = handlesOf(clamped(g, [&](const auto& x) {
      return std::min(torus(x, c + far, 9.0, 2.6), torus(x, c - far, 9.0, 3.4));
    }));
    QCOMPARE(apart.size(), std::size_t{2});
    QCOMPARE(apart[0].component + apart[1].component, 3);
  }

  // Beside noise, whose holes open and fill while it grows, a ring keeps the one that it has, found
  // before those or after.
  void holesThatFillTakeNoneElsewhere() {
    Geometry g = cube(17);
    g.size[2] = 36;
    for (const double radius : {1.0, 2.0})
      for (std::uint64_t seed = 0; seed < 6; ++seed) {
        Volume<float> phi = clamped(g, [&](const Eigen::Vector3d& x) {
          return torus(x, {8.0, 8.0, 30.0}, 5.0, radius);
        });
        for (std::size_t i = 0; i < g.offset(0, 0, 20); ++i)
          phi.voxels[i] = static_cast<float>(randomNormal(seed, i) - 0.4);
        const std::vector<Handle> handles = handlesOf(phi);
        QCOMPARE(std::count_if(handles.begin(), handles.end(),
                               [](const Handle& h) { return h.placeLps.z() > 23.0; }),
                 1);
      }
  }

  void aHoleThroughAVesselIsShort() {
    const Geometry g = cube(32);
    // In a wide one the section is deepest far from the hole, and the loop shortest beside it.
    const std::vector<Handle> wide = handlesOf(tubeWithAHole(g, 7.7, {15, 16, 14}));
    QCOMPARE(wide.size(), std::size_t{1});
    QVERIFY(wide[0].depthMm > 2.5 && wide[0].lengthMm < 8.0);
    const std::vector<Handle> found = handlesOf(tubeWithAHole(g, 3.7, {15, 16, 14}));
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(isBelow(found[0].lengthMm, 8.0));
    QVERIFY(found[0].kind == HandleKind::Hole);
    const Eigen::Vector3d d = found[0].centreLps - Eigen::Vector3d(15, 16, 14);
    QVERIFY(std::hypot(d.y(), d.z()) < 1.5);
  }

  /// Two vessels that come from one and touch again.
  void vesselsThatTouchCloseALongLoopWithAThinSection() {
    const Geometry g = cube(50);
    const Function fork = [&](const Eigen::Vector3d& x) {
      return std::min(
          {tube(x, {17, 25, 25}, kAlongZ, 3.0), tube(x, {31, 25, 25}, kAlongZ, 3.0),
           std::max(tube(x, {25, 25, 8}, kAlongX, 3.0), std::fabs(x.x() - 24.0) - 8.0)});
    };
    QVERIFY(handlesOf(clamped(g, fork)).empty());
    Volume<float> phi = clamped(g, fork);
    for (int i = 17; i <= 31; ++i) {
      float& value = phi.at(i, 25, 40);
      value = std::min(value, -0.2F);
    }
    const std::vector<Handle> found = handlesOf(phi);
    QCOMPARE(found.size(), std::size_t{1});
    QVERIFY(found[0].depthMm < 0.3 && found[0].kind == HandleKind::Thin);
    QVERIFY(found[0].lengthMm > 50.0 && found[0].lengthMm < 90.0);
    QVERIFY((found[0].placeLps - Eigen::Vector3d(24, 25, 40)).norm() < 5.0);
  }

  /// As many as Euler's number says, on anything.
  void countsAgreeWithEulersNumber() {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      const Volume<float> phi = anything(seed);
      const Geometry& g = phi.geometry;
      const Components inside = connectedComponents(insideMask(phi));
      Volume<std::uint8_t> outside(g);
      for (std::size_t i = 0; i < phi.voxels.size(); ++i)
        outside.voxels[i] = phi.voxels[i] < 0.0F ? 0 : 1;
      // Cavities: parts of the background that do not reach the border.
      const Components around = connectedComponents(outside, false);
      std::vector<bool> reaches(around.sizes.size(), false);
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        for (std::size_t a = 0; a < 3; ++a)
          if (around.labels.voxels[i] > 0 && (p[a] == 0 || p[a] == g.size[a] - 1))
            reaches[static_cast<std::size_t>(around.labels.voxels[i] - 1)] = true;
      }
      const auto cavities = static_cast<int>(std::count(reaches.begin(), reaches.end(), false));
      const int expected = static_cast<int>(inside.sizes.size()) + cavities - eulerOf(phi);
      QCOMPARE(static_cast<int>(handlesOf(phi).size()), expected);
    }
  }

  void closesAHoleAndLeavesTheRest() {
    const Geometry g = cube(32);
    const Volume<float> before = tubeWithAHole(g, 3.7, {15, 16, 14});
    Volume<float> phi = before;
    const std::vector<HandleChange> done = closeSmallHandles(phi, {});
    QCOMPARE(done.size(), std::size_t{1});
    QVERIFY(done[0].filled && std::fabs(done[0].depth - 0.3) < 1e-5);
    QVERIFY(std::hypot(done[0].placeLps.y() - 16.0, done[0].placeLps.z() - 14.0) < 0.6);
    QVERIFY(handlesOf(phi).empty());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      changed += phi.voxels[i] != before.voxels[i];
    QCOMPARE(changed, done[0].voxels);
    // The whole channel, with no pit on either side.
    for (int i = 13; i <= 17; ++i) QVERIFY(phi.at(i, 16, 14) < 0.0F);
    // A hole whose phi is above the limit stays.
    phi = before;
    HandleLimits limits;
    limits.depth = 0.2;
    QVERIFY(closeSmallHandles(phi, limits).empty());
    QVERIFY(phi.voxels == before.voxels);
    // So it does where the wall is known better.
    Volume<float> sure(g, 0.1F);
    QVERIFY(closeSmallHandles(phi, {}, &sure).empty());
  }

  void leavesRealLoopsAndRoundBodiesAlone() {
    const Geometry g = cube(48);
    const Eigen::Vector3d c = centreOf(g);
    const Function bodies[] = {[&](const auto& x) { return torus(x, c, 13.0, 3.1); },
                               [&](const auto& x) { return torus(x, c, 13.0, 0.9); },
                               [&](const auto& x) {
                                 return std::min(ball(x, c, 6.0), tube(x, c, {0.6, 0.0, 0.8}, 1.1));
                               },
                               // Kissing vessels, with a gap of less than a voxel between them.
                               [&](const auto& x) {
                                 return std::min(tube(x, c, kAlongZ, 3.0),
                                                 tube(x, c + 6.5 * kAlongX, kAlongZ, 3.0));
                               }};
    for (const Function& body : bodies) {
      Volume<float> phi = clamped(g, body);
      const Volume<float> before = phi;
      QVERIFY(closeSmallHandles(phi, {}).empty());
      QVERIFY(phi.voxels == before.voxels);
    }
  }

  void fillsABubble() {
    const Geometry g = cube(24);
    Volume<float> phi = clamped(g, [&](const auto& x) { return ball(x, centreOf(g), 7.0); });
    phi.at(12, 12, 10) = 0.2F;
    const std::vector<HandleChange> done = closeSmallHandles(phi, {});
    QCOMPARE(done.size(), std::size_t{1});
    QVERIFY(done[0].filled && phi.at(12, 12, 10) < 0.0F);
  }

  /// Where a short bridge is thinner than the hole beside it is deep, it goes.
  void takesTheCheaperChange() {
    const Geometry g = cube(32);
    const auto bridged = [&](float bridge, float gap) {
      Volume<float> phi = clamped(g, [&](const auto& x) {
        return std::min(tube(x, {11, 16, 16}, kAlongZ, 3.2), tube(x, {20, 16, 16}, kAlongZ, 3.2));
      });
      for (int k = 12; k <= 16; ++k)
        for (int i = 14; i <= 17; ++i) {
          float& value = phi.at(i, 16, k);
          value = k == 12 ? std::min(value, -2.0F)
                          : std::min(value, k == 14 ? bridge : std::max(gap, value - 5.0F));
        }
      return phi;
    };
    Volume<float> phi = bridged(-0.1F, 0.4F);
    QCOMPARE(handlesOf(phi).size(), std::size_t{1});
    const std::vector<HandleChange> cutOne = closeSmallHandles(phi, {});
    QCOMPARE(cutOne.size(), std::size_t{1});
    QVERIFY(!cutOne[0].filled && std::fabs(cutOne[0].depth - 0.1) < 1e-5);
    QVERIFY(handlesOf(phi).empty());
    QVERIFY(connectedComponents(insideMask(phi)).sizes.size() == 1);
    phi = bridged(-0.4F, 0.1F);
    QCOMPARE(handlesOf(phi).size(), std::size_t{1});
    const std::vector<HandleChange> filledOne = closeSmallHandles(phi, {});
    QCOMPARE(filledOne.size(), std::size_t{1});
    QVERIFY(filledOne[0].filled);
    QVERIFY(handlesOf(phi).empty());
  }

  /// On anything there are no more handles than before, and the parts are the same.
  void neitherJoinsNorPartsNorAdds() {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      Volume<float> phi = anything(seed);
      const std::size_t parts = connectedComponents(insideMask(phi)).sizes.size();
      const std::size_t handles = handlesOf(phi).size();
      const std::vector<HandleChange> done = closeSmallHandles(phi, {});
      QCOMPARE(connectedComponents(insideMask(phi)).sizes.size(), parts);
      QVERIFY(handlesOf(phi).size() <= handles);
      QVERIFY(!done.empty());
    }
  }

  void theSameForAnyNumberOfThreads() {
    const Volume<float> phi = tubeWithAHole(cube(32), 3.7, {15, 16, 14});
    const auto [one, two] = onOneAndSeveralThreads([&] { return handlesOf(phi); });
    QCOMPARE(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      QVERIFY(one[i].placeLps == two[i].placeLps);
      QCOMPARE(one[i].lengthMm, two[i].lengthMm);
    }
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      Volume<float> phi = unlikeVessels(fewAlongLast);
      // A hole through the vessel, one voxel wide.
      const Geometry& g = phi.geometry;
      const Index3 c{g.size[0] / 2, g.size[1] / 2, g.size[2] / 2};
      for (int k = -12; k <= 12; ++k)
        if (g.contains(c[0], c[1] - 1, c[2] + k))
          phi.at(c[0], c[1] - 1, c[2] + k) = std::max(phi.at(c[0], c[1] - 1, c[2] + k), 0.2F);
      const std::vector<Handle> one = handlesOf(phi), other = handlesOf(turned(phi));
      QCOMPARE(one.size(), std::size_t{1});
      QCOMPARE(other.size(), one.size());
      QVERIFY(std::fabs(one[0].lengthMm - other[0].lengthMm) < 0.3);
      Volume<float> closed = phi, closedOther = turned(phi);
      closeSmallHandles(closed, HandleLimits{});
      closeSmallHandles(closedOther, HandleLimits{});
      QVERIFY(mostApart(closed, phi) > 0.0);
      QVERIFY(mostApart(turned(closed), closedOther) < 1e-6);
    }
  }
};

QTEST_GUILESS_MAIN(TestHandles)
#include "tst_handles.moc"
