// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "render/slice/pane_grid.h"
#include "render/slice/slice_cast.h"
#include "render/slice/slice_raster.h"

using namespace angiomesh;

namespace {

using Eigen::Vector3d;

const Vector3d kSlope(2.0, -3.0, 5.0);  // per mm

/// Voxels three times as thick as wide, in an oblique frame.
Geometry obliqueGrid() {
  Geometry g;
  g.size = {50, 44, 20};
  g.spacing = {0.7, 0.8, 2.1};
  g.direction = Eigen::AngleAxisd(0.3, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  g.origin = {-12.0, 20.0, 75.0};
  return g;
}

template <class Value>
Volume<float> imageOf(const Geometry& grid, Value value) {
  Volume<float> image(grid);
  for (std::size_t p = 0; p < image.voxels.size(); ++p) {
    const Index3 v = grid.indexOf(p);
    image.voxels[p] = static_cast<float>(value(grid.toPhysical(Vector3d(v[0], v[1], v[2]))));
  }
  return image;
}

Vector3d middleOf(const Geometry& g) {
  return g.toPhysical(
      Vector3d(0.5 * g.size[0] - 0.5, 0.5 * g.size[1] - 0.5, 0.5 * g.size[2] - 0.5));
}

/// Turned in one pane, and then in another.
PlaneTurn turned(const Geometry& g, bool patientAxes) {
  PlaneTurn turn;
  turn.patientAxes = patientAxes;
  const Vector3d pivot = middleOf(g) + Vector3d(0.3, -0.7, 1.1);
  turn = turn.turnedBy(2, 0.6, planeNormals(g, turn)[2], pivot);
  return turn.turnedBy(0, -0.4, planeNormals(g, turn)[0], pivot);
}

struct Shown {
  PaneGrid pane;
  SlicePlane plane;
  std::vector<float> values;

  Shown(const Volume<float>& image, int number, const PlaneTurn& turn, const Vector3d& through,
        SlabMode mode = SlabMode::None, int more = 0)
      : pane(paneGrid(image.geometry, number, turn)) {
    const auto slice = static_cast<int>(std::lround(pane.grid.toIndex(through)[pane.axes.across]));
    plane = SlicePlane(pane.grid, pane.axes, slice);
    castSlab(image, pane.grid, pane.axes, mode, slice - more, slice + more, values);
  }
  template <class Each>
  void each(Each call) const {
    for (int row = 0; row < plane.height(); ++row)
      for (int column = 0; column < plane.width(); ++column)
        call(plane.toLps({column * plane.pixelWidthMm(), row * plane.pixelHeightMm()}),
             values[static_cast<std::size_t>(row) * static_cast<std::size_t>(plane.width()) +
                    static_cast<std::size_t>(column)]);
  }
};

}  // namespace

class TestTurnedSlices : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPixelHasTheValueOfItsPlace() {
    const Geometry g = obliqueGrid();
    const Volume<float> ramp = imageOf(g, [](const Vector3d& p) { return kSlope.dot(p); });
    for (const bool patientAxes : {false, true})
      for (const bool turns : {false, true}) {
        PlaneTurn turn = turns ? turned(g, patientAxes) : PlaneTurn();
        turn.patientAxes = patientAxes;
        for (int plane = 0; plane < 3; ++plane) {
          const Shown shown(ramp, plane, turn, middleOf(g));
          int inside = 0;
          double worst = 0.0;
          shown.each([&](const Vector3d& lps, float value) {
            if (!g.holds(lps)) return;
            ++inside;
            worst = std::max(worst, std::abs(value - kSlope.dot(lps)));
          });
          QVERIFY2(inside > 300, qPrintable(QString::number(inside)));
          QVERIFY2(worst < 1e-3, qPrintable(QString::number(worst)));
        }
      }
  }

  void whatIsOutsideIsSaidToBe() {
    const Geometry g = obliqueGrid();
    const Volume<float> ramp = imageOf(g, [](const Vector3d& p) { return kSlope.dot(p); });
    const Shown shown(ramp, 1, turned(g, false), middleOf(g));
    int outside = 0;
    shown.each([&](const Vector3d& lps, float value) {
      const Vector3d index = g.toIndex(lps);
      bool in = true;
      for (int a = 0; a < 3; ++a)
        in = in && index[a] > -0.499 && index[a] < g.size[static_cast<std::size_t>(a)] - 0.501;
      if (in) QVERIFY(value != kOutside);
      if (!g.holds(lps, 0.51)) {
        QCOMPARE(value, kOutside);
        ++outside;
      }
      if (in) QVERIFY(std::abs(value - valueAt(ramp, lps)) < 1e-3);
    });
    QVERIFY(outside > 50);
  }

  void slabsOfATurnedPlaneCombineAlongItsNormal() {
    const Geometry g = obliqueGrid();
    const Volume<float> ramp = imageOf(g, [](const Vector3d& p) { return kSlope.dot(p); });
    const PlaneTurn turn = turned(g, false);
    constexpr int more = 3;
    const Shown mip(ramp, 0, turn, middleOf(g), SlabMode::Mip, more);
    const Shown least(ramp, 0, turn, middleOf(g), SlabMode::MinIp, more);
    const Shown mean(ramp, 0, turn, middleOf(g), SlabMode::Mean, more);
    const Vector3d normal = planeNormals(g, turn)[0];
    const double reach = more * g.voxelMm() * std::abs(kSlope.dot(normal));
    QVERIFY(reach > 1.0);
    const auto whole = [&](const Vector3d& lps) {
      const double mm = more * g.voxelMm();
      return g.holds(lps + mm * normal) && g.holds(lps - mm * normal);
    };
    mip.each([&](const Vector3d& lps, float value) {
      if (whole(lps)) QVERIFY(std::abs(value - kSlope.dot(lps) - reach) < 2e-3);
    });
    least.each([&](const Vector3d& lps, float value) {
      if (whole(lps)) QVERIFY(std::abs(value - kSlope.dot(lps) + reach) < 2e-3);
    });
    mean.each([&](const Vector3d& lps, float value) {
      if (whole(lps)) QVERIFY(std::abs(value - kSlope.dot(lps)) < 2e-3);
    });
  }

  void aBallIsACircleOfItsRadius() {
    const Geometry g = obliqueGrid();
    const Vector3d centre = middleOf(g);
    constexpr double radius = 9.0;
    const auto distance = [&](const Vector3d& p) { return (p - centre).norm() - radius; };
    const Volume<float> ball = imageOf(g, distance);
    const PlaneTurn turn = turned(g, false);
    for (int plane = 0; plane < 3; ++plane) {
      // Trilinear values of a curved function are a little off between voxels of 2.1 mm.
      constexpr double tolerance = 0.12;
      const Shown shown(ball, plane, turn, centre);
      const auto segments = zeroContour(ball, shown.plane);
      QVERIFY(segments.size() > 50);
      const Vector3d middle = shown.plane.fromLps(centre);
      const double off = std::abs(middle[2]) * shown.pane.grid.spacing[0];
      const double expected = std::sqrt(radius * radius - off * off);
      for (const auto& segment : segments)
        for (const Eigen::Vector2d& end : segment) {
          const double r = (end - middle.head<2>()).norm();
          QVERIFY2(std::abs(r - expected) < tolerance, qPrintable(QString::number(r - expected)));
        }
      double area = 0.0;
      shown.each([&](const Vector3d&, float value) {
        if (value != kOutside && value < 0.0F)
          area += shown.plane.pixelWidthMm() * shown.plane.pixelHeightMm();
      });
      const double disc = std::numbers::pi * expected * expected;
      QVERIFY2(std::abs(area - disc) < 0.03 * disc, qPrintable(QString::number(area / disc)));
    }
  }

  void thePlanesStayAtRightAngles() {
    const Geometry g = obliqueGrid();
    const PlaneTurn turn = turned(g, false);
    const auto normals = planeNormals(g, turn);
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(k), b = static_cast<std::size_t>((k + 1) % 3);
      QVERIFY(std::abs(normals[a].dot(normals[b])) < 1e-12);
      QVERIFY(std::abs(normals[a].norm() - 1.0) < 1e-12);
      const PaneGrid pane = paneGrid(g, k, turn);
      const Vector3d across = pane.axes.rightLps.cross(pane.axes.upLps);
      QVERIFY(std::abs(std::abs(across.dot(normals[a])) - 1.0) < 1e-12);
      // The pivot lies in a slice.
      const double depth = pane.grid.toIndex(turn.pivotLps)[pane.axes.across];
      QVERIFY(std::abs(depth - std::round(depth)) < 1e-6);
    }
  }

  void lettersAreTrueInTurnedPlanes() {
    Geometry g;
    g.size = {20, 20, 20};
    constexpr double degree = std::numbers::pi / 180.0;
    const auto rightOf = [&](int plane, int about, double angle) {
      const PlaneTurn turn = PlaneTurn().turnedBy(
          about, angle * degree, planeNormals(g, {})[static_cast<std::size_t>(about)], {0, 0, 0});
      return orientationLetters(paneGrid(g, plane, turn).axes.rightLps);
    };
    QCOMPARE(rightOf(1, 2, 0.0), std::string("L"));
    QCOMPARE(rightOf(1, 2, 8.0), std::string("L"));
    QCOMPARE(rightOf(1, 2, 12.0), std::string("LP"));
    QCOMPARE(rightOf(1, 2, -12.0), std::string("LA"));
    QCOMPARE(rightOf(1, 2, 60.0), std::string("PL"));
    QCOMPARE(rightOf(2, 2, 60.0), std::string("L"));  // the pane that one turns in stays
    QVERIFY(std::abs(paneGrid(g, 1, PlaneTurn().turnedBy(2, 0.5, {0, 0, 1}, {0, 0, 0})).turnedDeg -
                     0.5 / degree) < 1e-9);
  }

  void patientAxesAreExact() {
    const Geometry g = obliqueGrid();
    PlaneTurn turn;
    turn.patientAxes = true;
    const PaneGrid axial = paneGrid(g, 2, turn);
    QVERIFY((axial.axes.rightLps - Vector3d(1, 0, 0)).norm() < 1e-12);
    QVERIFY((axial.axes.upLps - Vector3d(0, -1, 0)).norm() < 1e-12);
    QCOMPARE(axial.turnedDeg, 0.0);
    const SlicePlane plane(axial.grid, axial.axes, 3);
    QCOMPARE(plane.toLps({0.0, 0.0})[2], plane.toLps({9.0, 7.0})[2]);
    QVERIFY(std::abs(plane.toLps({9.0, 0.0})[0] - plane.toLps({0.0, 0.0})[0] - 9.0) < 1e-9);
  }

  void sagittalSlabsAreThoseOfTheirVoxels() {
    const Geometry g = obliqueGrid();
    Volume<float> image(g);
    for (std::size_t p = 0; p < image.voxels.size(); ++p)
      image.voxels[p] = static_cast<float>((p * 7919) % 1009);
    const PaneAxes axes = paneAxes(g, 0);
    const SlicePlane plane(g, axes, 20);
    std::vector<float> values;
    castSlab(image, g, axes, SlabMode::Mip, 15, 25, values);
    for (int row = 0; row < plane.height(); ++row)
      for (int column = 0; column < plane.width(); ++column) {
        const Vector3d index =
            g.toIndex(plane.toLps({column * plane.pixelWidthMm(), row * plane.pixelHeightMm()}));
        float most = 0.0F;
        for (int along = 15; along <= 25; ++along) {
          std::array<int, 3> voxel{};
          for (std::size_t a = 0; a < 3; ++a)
            voxel[a] = static_cast<int>(std::lround(index[static_cast<Eigen::Index>(a)]));
          voxel[static_cast<std::size_t>(axes.across)] = along;
          most = std::max(most, image.at(voxel[0], voxel[1], voxel[2]));
        }
        QCOMPARE(values[static_cast<std::size_t>(row * plane.width() + column)], most);
      }
  }
};

QTEST_APPLESS_MAIN(TestTurnedSlices)
#include "tst_turned_slices.moc"
