// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <cmath>

#include "render/slice/pane_axes.h"
#include "render/slice/slice_cast.h"
#include "render/slice/slice_overlay.h"
#include "render/slice/slice_raster.h"

using namespace angiomesh;

namespace {

Geometry grid(const Eigen::Matrix3d& direction) {
  Geometry g;
  g.size = {24, 31, 17};
  g.spacing = {0.8, 1.1, 1.7};
  g.origin = {-31.0, 12.5, 204.0};
  g.direction = direction;
  return g;
}

Eigen::Matrix3d turned(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * M_PI / 180.0, axis.normalized()).toRotationMatrix();
}

/// Volumes as scanners store them: axial, coronal and sagittal acquisitions, flipped, turned.
std::vector<Eigen::Matrix3d> directions() {
  Eigen::Matrix3d coronal;
  coronal << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  Eigen::Matrix3d sagittal;
  sagittal << 0, 0, 1, 1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  const Eigen::Matrix3d leftHanded = Eigen::Vector3d(1, -1, 1).asDiagonal();
  return {Eigen::Matrix3d::Identity(),
          coronal,
          sagittal,
          mirrored,
          leftHanded,
          turned(17, {1, 2, 3}),
          turned(25, {0, 1, 0.3}) * sagittal,
          turned(-30, {1, 0.1, 0}) * leftHanded};
}

}  // namespace

class TestRaster : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void panesFollowTheRadiologicalConvention() {
    const std::array<Eigen::Vector3d, 3> right{{{0, 1, 0}, {1, 0, 0}, {1, 0, 0}}};  // P; L; L
    const std::array<Eigen::Vector3d, 3> up{{{0, 0, 1}, {0, 0, 1}, {0, -1, 0}}};    // S; S; A
    for (const Eigen::Matrix3d& direction : directions())
      for (int plane = 0; plane < 3; ++plane) {
        const PaneAxes axes = paneAxes(grid(direction), plane);
        QVERIFY(axes.rightLps.dot(right[static_cast<std::size_t>(plane)]) > 0.7);
        QVERIFY(axes.upLps.dot(up[static_cast<std::size_t>(plane)]) > 0.7);
        QCOMPARE(axes.right + axes.up + axes.across, 3);
        QVERIFY(axes.right != axes.up && axes.right != axes.across);
      }
  }

  void everyPlaneHasItsOwnGridAxis() {
    // Nearly diagonal directions, where each axis on its own would choose the same plane.
    for (int degrees = 0; degrees < 180; degrees += 9) {
      const Geometry g = grid(turned(degrees, {1, 1, 1}));
      std::array<bool, 3> used{};
      for (int plane = 0; plane < 3; ++plane)
        used[static_cast<std::size_t>(paneAxes(g, plane).across)] = true;
      QVERIFY(used[0] && used[1] && used[2]);
    }
  }

  void lettersTellObliqueDirections() {
    QCOMPARE(orientationLetters({1, 0, 0}), std::string("L"));
    QCOMPARE(orientationLetters({-1, 0, 0}), std::string("R"));
    QCOMPARE(orientationLetters({0, 1, 0}), std::string("P"));
    QCOMPARE(orientationLetters({0, -2, 0}), std::string("A"));
    QCOMPARE(orientationLetters({0, 0, 1}), std::string("S"));
    QCOMPARE(orientationLetters({0, 0, -1}), std::string("I"));
    const auto leaning = [](double degrees) {
      return Eigen::Vector3d(std::cos(degrees * M_PI / 180), 0, -std::sin(degrees * M_PI / 180));
    };
    QCOMPARE(orientationLetters(leaning(9.9)), std::string("L"));
    QCOMPARE(orientationLetters(leaning(10.1)), std::string("LI"));
    QCOMPARE(orientationLetters(leaning(60)), std::string("IL"));
  }

  void planeAndPatientSpaceAreInverse() {
    for (const Eigen::Matrix3d& direction : directions())
      for (int plane = 0; plane < 3; ++plane) {
        const Geometry g = grid(direction);
        const SlicePlane slice(g, paneAxes(g, plane), 5);
        const Eigen::Vector3d lps = slice.toLps({3.2, 7.7});
        const Eigen::Vector3d back = slice.fromLps(lps);
        QVERIFY((back - Eigen::Vector3d(3.2, 7.7, 0.0)).norm() < 1e-9);
      }
  }

  void rasterShowsVoxelsWhereThePlaneSaysTheyAre() {
    for (const Eigen::Matrix3d& direction : directions())
      for (int plane = 0; plane < 3; ++plane) {
        Volume<float> image(grid(direction));
        for (std::size_t p = 0; p < image.voxels.size(); ++p)
          image.voxels[p] = static_cast<float>(p);
        const PaneAxes axes = paneAxes(image.geometry, plane);
        const SlicePlane slice(image.geometry, axes, 6);
        std::vector<float> values;
        castSlab(image, image.geometry, axes, SlabMode::None, 6, 6, values);
        QCOMPARE(values.size(), static_cast<std::size_t>(slice.width() * slice.height()));
        for (int row = 0; row < slice.height(); row += 3)
          for (int column = 0; column < slice.width(); column += 3) {
            const Eigen::Vector3d lps =
                slice.toLps({column * slice.pixelWidthMm(), row * slice.pixelHeightMm()});
            const Eigen::Vector3d index = image.geometry.toIndex(lps);
            const float expected = image.at(static_cast<int>(std::lround(index[0])),
                                            static_cast<int>(std::lround(index[1])),
                                            static_cast<int>(std::lround(index[2])));
            QCOMPARE(values[static_cast<std::size_t>(row * slice.width() + column)], expected);
          }
      }
  }

  void slabsCombineTheirSlices() {
    Volume<float> image(grid(Eigen::Matrix3d::Identity()), 10.0F);
    image.at(4, 5, 7) = 90.0F;
    image.at(4, 5, 9) = -30.0F;
    const PaneAxes axes = paneAxes(image.geometry, 2);
    const SlicePlane slice(image.geometry, axes, 8);
    const Eigen::Vector3d xy = slice.fromLps(image.geometry.toPhysical({4, 5, 8}));
    const auto pixel =
        static_cast<std::size_t>(std::lround(xy[1] / slice.pixelHeightMm()) * slice.width() +
                                 std::lround(xy[0] / slice.pixelWidthMm()));
    const auto shown = [&](SlabMode mode, int first, int last) {
      std::vector<float> values;
      castSlab(image, image.geometry, axes, mode, first, last, values);
      return values[pixel];
    };
    QCOMPARE(shown(SlabMode::None, 8, 8), 10.0F);
    QCOMPARE(shown(SlabMode::Mip, 7, 9), 90.0F);
    QCOMPARE(shown(SlabMode::Mip, 8, 9), 10.0F);
    QCOMPARE(shown(SlabMode::MinIp, 7, 9), -30.0F);
    QCOMPARE(shown(SlabMode::Mean, 7, 10), 20.0F);
  }

  void slabThicknessIsRoundedToSlicesAndCutAtTheEnds() {
    const Geometry g = grid(Eigen::Matrix3d::Identity());  // 17 slices of 1.7 mm
    const PaneAxes axes = paneAxes(g, 2);
    using Range = std::array<int, 2>;
    QCOMPARE(slabSlices(g, axes, 8, 0.0), (Range{8, 8}));
    QCOMPARE(slabSlices(g, axes, 8, 5.1), (Range{7, 9}));
    QCOMPARE(slabSlices(g, axes, 8, 5.1 + 1.7), (Range{7, 10}));
    QCOMPARE(slabSlices(g, axes, 0, 5.1), (Range{0, 1}));
    QCOMPARE(slabSlices(g, axes, 8, 1e9), (Range{0, 16}));
  }

  void contourLiesOnTheBall() {
    // A ball on its own, finer and turned grid, cut by the slices of other grids.
    const Eigen::Vector3d centre(3.0, -2.0, 5.0);
    const double radius = 7.0;
    Volume<float> phi;
    phi.geometry.size = {48, 50, 46};
    phi.geometry.spacing = {0.5, 0.45, 0.55};
    phi.geometry.direction = turned(33, {2, 1, 1});
    phi.geometry.origin = centre - phi.geometry.direction * Eigen::Vector3d(11.75, 11.025, 12.375);
    phi.voxels.resize(phi.geometry.voxelCount());
    for (std::size_t p = 0; p < phi.voxels.size(); ++p) {
      const Index3 v = phi.geometry.indexOf(p);
      phi.voxels[p] = static_cast<float>(
          (phi.geometry.toPhysical(Eigen::Vector3d(v[0], v[1], v[2])) - centre).norm() - radius);
    }
    for (const Eigen::Matrix3d& direction : directions())
      for (int plane = 0; plane < 3; ++plane) {
        Geometry g = grid(direction);
        g.size = {40, 40, 40};
        g.origin = centre - direction * g.spacing.cwiseProduct(Eigen::Vector3d(19.3, 20.1, 20.4));
        const PaneAxes axes = paneAxes(g, plane);
        const SlicePlane slice(g, axes, 21);
        const double height = std::abs(slice.fromLps(centre)[2]) * g.spacing[axes.across];
        const double circle = std::sqrt(radius * radius - height * height);
        const auto segments = zeroContour(phi, slice);
        QVERIFY(segments.size() > 20);
        double length = 0.0;
        for (const auto& segment : segments) {
          length += (segment[1] - segment[0]).norm();
          for (const Eigen::Vector2d& end : segment)
            QVERIFY(std::abs((slice.toLps(end) - centre).norm() - radius) < 0.06);
        }
        QVERIFY(std::abs(length / (2.0 * M_PI * circle) - 1.0) < 0.02);
      }
  }

  void contourEndsWhereItsGridEnds() {
    Volume<float> phi(grid(Eigen::Matrix3d::Identity()), -1.0F);
    const Geometry g = phi.geometry;
    const SlicePlane slice(g, paneAxes(g, 2), 4);
    QVERIFY(zeroContour(phi, slice).empty());
    QVERIFY(zeroContour(Volume<float>(), slice).empty());
  }

  void boxIsCutByTurnedSlices() {
    const Geometry g = grid(turned(25, {0.2, 0.3, 1}));
    const RoiBox whole = volumeBox(g);
    const Eigen::Vector3d middle = g.toPhysical({11, 15, 8});
    for (int plane = 0; plane < 3; ++plane) {
      const PaneAxes axes = paneAxes(g, plane);
      const SlicePlane slice(g, axes,
                             std::array<int, 3>{11, 15, 8}[static_cast<std::size_t>(axes.across)]);
      RoiBox box{};
      for (int a = 0; a < 3; ++a) {
        box[static_cast<std::size_t>(a)] = middle[a] - 3.0 - a;
        box[static_cast<std::size_t>(a) + 3] = middle[a] + 3.0 + a;
      }
      const auto polygon = boxSection(box, slice);
      QVERIFY(polygon.size() >= 3);
      for (const Eigen::Vector2d& corner : polygon) {
        const Eigen::Vector3d lps = slice.toLps(corner);
        double outside = -1e300;  // of the farthest side; 0 on the box's surface
        for (int a = 0; a < 3; ++a)
          outside = std::max(outside, std::abs(lps[a] - middle[a]) - 3.0 - a);
        QVERIFY(std::abs(outside) < 1e-9);
      }
      RoiBox away = box;
      away[0] += 1000.0;
      away[3] += 1000.0;
      if (plane == 0) QVERIFY(boxSection(away, slice).empty());
    }
    for (const Index3& corner : {Index3{0, 0, 0}, Index3{23, 30, 16}}) {
      const Eigen::Vector3d lps = g.toPhysical(Eigen::Vector3d(corner[0], corner[1], corner[2]));
      for (int a = 0; a < 3; ++a) {
        QVERIFY(lps[a] >= whole[static_cast<std::size_t>(a)]);
        QVERIFY(lps[a] <= whole[static_cast<std::size_t>(a) + 3]);
      }
    }
  }

  void scaleBarsAreRound() {
    QCOMPARE(scaleBarLengthMm(73.0), 50.0);
    QCOMPARE(scaleBarLengthMm(49.0), 20.0);
    QCOMPARE(scaleBarLengthMm(19.0), 10.0);
    QCOMPARE(scaleBarLengthMm(0.6), 0.5);
    QCOMPARE(scaleBarLengthMm(0.0), 0.0);
  }

  void displayRangeIgnoresFewOutliers() {
    Volume<float> image(grid(Eigen::Matrix3d::Identity()));
    for (std::size_t p = 0; p < image.voxels.size(); ++p)
      image.voxels[p] = static_cast<float>(p % 101);
    image.voxels[17] = 1e9F;
    const std::array<double, 2> range = displayRange(image, 0.1, 0.9);
    QVERIFY(std::abs(range[0] - 10.0) <= 1.5);
    QVERIFY(std::abs(range[1] - 90.0) <= 1.5);
    const std::array<double, 2> flat = displayRange(Volume<float>(image.geometry, 5.0F), 0.1, 0.9);
    QVERIFY(flat[1] > flat[0]);
  }
};

QTEST_APPLESS_MAIN(TestRaster)
#include "tst_raster.moc"
