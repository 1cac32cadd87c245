// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/projection.h"
#include "tests/core/analytic.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

struct Ball {
  Vector3d centre;  // LPS mm
  double radius;
};

/// A bright ball on dark ground, and its distance.
Volume<float> fieldOf(const Geometry& g, const Ball& b) {
  return analytic::sampled(
      g, [&](const Vector3d& x) { return analytic::ball(x, b.centre, b.radius); });
}

Volume<float> imageOf(const Geometry& g, const Ball& b) {
  Volume<float> image = fieldOf(g, b);
  for (float& v : image.voxels) v = v < 0.0F ? 200.0F : 0.0F;
  return image;
}

/// A cube of 48 mm around the patient's origin whose grid axes are columns of `direction`.
Geometry cubeGrid(const Eigen::Matrix3d& direction, const Vector3d& spacing) {
  Geometry g;
  g.direction = direction;
  g.spacing = spacing;
  for (int a = 0; a < 3; ++a) g.size[a] = static_cast<int>(std::lround(48.0 / spacing[a]));
  g.origin =
      -direction *
      (0.5 * (Vector3d(g.size[0], g.size[1], g.size[2]) - Vector3d::Ones())).cwiseProduct(spacing);
  return g;
}

struct Region {
  int left, top, width, height;
};

/// Centre of the light pixels of a tile, each as a fraction of its sides; letters do not count
/// (their blue is much lower than their red).
Vector3d centreOfLight(const Picture& p, const Region& r) {
  double sum = 0.0;
  Vector3d centre = Vector3d::Zero();
  for (int y = 0; y < r.height; ++y)
    for (int x = 0; x < r.width; ++x) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(r.top + y) * static_cast<std::size_t>(p.width) +
               static_cast<std::size_t>(r.left + x));
      const int red = p.rgb[at];
      const int blue = p.rgb[at + 2];
      if (red < 40 || blue < red / 2) continue;
      sum += 1.0;
      centre += Vector3d((x + 0.5) / r.width, (y + 0.5) / r.height, 0.0);
    }
  return sum > 0.0 ? Vector3d(centre / sum + Vector3d(0, 0, sum)) : Vector3d::Zero();
}

/// The six tiles of a cube's preview: coronal, sagittal, axial above, their vessels below.
std::array<Region, 6> tilesOf(const Picture& p) {
  const int gap = (p.width - 3 * 480) / 4;
  std::array<Region, 6> tiles{};
  for (int i = 0; i < 6; ++i)
    tiles[static_cast<std::size_t>(i)] = {gap + i % 3 * (480 + gap), gap + i / 3 * (480 + gap), 480,
                                          480};
  return tiles;
}

}  // namespace

class TestProjection : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  void projectionsHoldTheLargestValueOnEachLine() {
    Geometry g;
    g.size = {4, 5, 6};
    Volume<float> image(g, -1.0F);
    image.at(1, 2, 3) = 10.0F;
    image.at(3, 0, 5) = 7.0F;
    const int width[3] = {5, 4, 4};
    const int height[3] = {6, 6, 5};
    const int peak[3] = {2 + 5 * 3, 1 + 4 * 3, 1 + 4 * 2};
    const int second[3] = {0 + 5 * 5, 3 + 4 * 5, 3 + 4 * 0};
    for (int axis = 0; axis < 3; ++axis) {
      const Projection p = maximumProjection(image, axis);
      QCOMPARE(p.width, width[axis]);
      QCOMPARE(p.height, height[axis]);
      QCOMPARE(p.values.size(), static_cast<std::size_t>(p.width * p.height));
      for (int i = 0; i < p.width * p.height; ++i) {
        const float expected = i == peak[axis] ? 10.0F : i == second[axis] ? 7.0F : -1.0F;
        QCOMPARE(p.values[static_cast<std::size_t>(i)], expected);
      }
    }
    QVERIFY_THROWS_EXCEPTION(InputError, maximumProjection(image, 3));
    QVERIFY_THROWS_EXCEPTION(InputError, maximumProjection(Volume<float>(), 0));
  }

  void tilesAreInPatientOrientation_data() {
    QTest::addColumn<int>("turn");
    QTest::addColumn<double>("thickness");
    for (int turn = 0; turn < 5; ++turn)
      QTest::addRow("turn %d", turn) << turn << (turn % 2 == 0 ? 1.0 : 2.0);
  }
  void tilesAreInPatientOrientation() {
    QFETCH(int, turn);
    QFETCH(double, thickness);
    Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
    if (turn == 1) direction << -1, 0, 0, 0, -1, 0, 0, 0, 1;  // RAS
    if (turn == 2) direction << 0, 0, 1, 1, 0, 0, 0, -1, 0;   // sagittal slices, S to I
    if (turn == 3) direction << 1, 0, 0, 0, 0, 1, 0, -1, 0;   // coronal slices
    if (turn == 4)                                            // oblique by 10 degrees
      direction = Eigen::AngleAxisd(0.175, Vector3d(1, 1, 1).normalized()).toRotationMatrix();
    const Geometry g = cubeGrid(direction, {1.0, 1.0, thickness});
    // To the patient's left, in front, and high.
    const Ball ball{Vector3d(12.0, -9.0, 14.0), 5.0};
    // Another grid than the image's for the field.
    const Geometry other = cubeGrid(Eigen::Matrix3d::Identity(), {0.8, 1.2, 0.8});
    const Picture p = previewPicture(imageOf(g, ball), fieldOf(other, ball));
    QCOMPARE(p.rgb.size(), static_cast<std::size_t>(3 * p.width * p.height));
    const std::array<Region, 6> tiles = tilesOf(p);
    const double u[3] = {0.5 + 12.0 / 48.0, 0.5 - 9.0 / 48.0, 0.5 + 12.0 / 48.0};
    const double v[3] = {0.5 - 14.0 / 48.0, 0.5 - 14.0 / 48.0, 0.5 - 9.0 / 48.0};
    const double tolerance = turn == 4 ? 0.09 : 0.02;
    const double area = M_PI * 25.0 / (48.0 * 48.0) * 480.0 * 480.0;
    for (std::size_t i = 0; i < 6; ++i) {
      const Vector3d centre = centreOfLight(p, tiles[i]);
      QVERIFY(std::fabs(centre[0] - u[i % 3]) < tolerance);
      QVERIFY(std::fabs(centre[1] - v[i % 3]) < tolerance);
      if (i >= 3) QVERIFY(std::fabs(centre[2] / area - 1.0) < 0.06);
    }
  }

  /// Nearer to the front, to the patient's left and to the feet, whichever way the grid runs.
  void nearVesselsAreLighter() {
    Eigen::Matrix3d direction = Eigen::Matrix3d::Identity();
    direction(0, 0) = direction(1, 1) = -1.0;
    const Geometry g = cubeGrid(direction, {1.0, 1.0, 1.0});
    const Ball one{Vector3d(15.0, -14.0, -16.0), 4.0}, other{Vector3d(-15.0, 14.0, 16.0), 4.0};
    Volume<float> phi = fieldOf(g, one);
    const Volume<float> second = fieldOf(g, other);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      phi.voxels[i] = std::min(phi.voxels[i], second.voxels[i]);
    const Picture p = previewPicture(imageOf(g, one), phi);
    for (std::size_t view = 0; view < 3; ++view) {
      const Region tile = tilesOf(p)[3 + view];
      const auto red = [&](const Vector3d& place) {
        const double right = view == 1 ? place.y() : place.x();
        const double down = view == 2 ? place.y() : -place.z();
        const auto x = static_cast<std::size_t>(tile.left + (0.5 + right / 48.0) * tile.width);
        const auto y = static_cast<std::size_t>(tile.top + (0.5 + down / 48.0) * tile.height);
        return static_cast<int>(p.rgb[3 * (y * static_cast<std::size_t>(p.width) + x)]);
      };
      QVERIFY(red(one.centre) > 200);
      QVERIFY(red(other.centre) > 60 && red(other.centre) < red(one.centre) - 60);
      QCOMPARE(red(Vector3d::Zero()), 0);
    }
  }

  /// The sides' letters, told from one another by their symmetries.
  void lettersNameTheSides() {
    Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {2.0, 2.0, 2.0});
    const Picture p = previewPicture(Volume<float>(g, 0.0F), Volume<float>(g, 1.0F));
    using Pixels = std::set<std::pair<int, int>>;
    // The lit pixels near the middle of a side of a tile, from the corner of their box.
    const auto letterAt = [&](const Region& tile, double u, double v) {
      Pixels found;
      int left = p.width, top = p.height;
      for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
          const int px = tile.left + static_cast<int>(u * (tile.width - 24)) + x;
          const int py = tile.top + static_cast<int>(v * (tile.height - 24)) + y;
          if (p.rgb[static_cast<std::size_t>(3 * (py * p.width + px))] < 100) continue;
          found.emplace(px, py);
          left = std::min(left, px);
          top = std::min(top, py);
        }
      Pixels moved;
      for (const auto& [x, y] : found) moved.emplace(x - left, y - top);
      return moved;
    };
    const auto mirrored = [](const Pixels& pixels, bool across, bool down) {
      int right = 0, bottom = 0;
      for (const auto& [x, y] : pixels) {
        right = std::max(right, x);
        bottom = std::max(bottom, y);
      }
      Pixels other;
      for (const auto& [x, y] : pixels)
        other.emplace(across ? right - x : x, down ? bottom - y : y);
      return other;
    };
    const auto tiles = tilesOf(p);
    for (const std::size_t row : {0, 3}) {
      const auto side = [&](std::size_t view, double u, double v) {
        return letterAt(tiles[row + view], u, v);
      };
      const Pixels right = side(0, 0.0, 0.5), left = side(0, 1.0, 0.5);
      const Pixels head = side(0, 0.5, 0.0), feet = side(0, 0.5, 1.0);
      const Pixels front = side(1, 0.0, 0.5), back = side(1, 1.0, 0.5);
      QCOMPARE(side(1, 0.5, 0.0), head);
      QCOMPARE(side(1, 0.5, 1.0), feet);
      QCOMPARE(side(2, 0.0, 0.5), right);
      QCOMPARE(side(2, 1.0, 0.5), left);
      QCOMPARE(side(2, 0.5, 0.0), front);
      QCOMPARE(side(2, 0.5, 1.0), back);
      // I, A, S.
      QVERIFY(!feet.empty() && mirrored(feet, true, false) == feet);
      QVERIFY(mirrored(feet, false, true) == feet);
      QVERIFY(mirrored(front, true, false) == front && mirrored(front, false, true) != front);
      QVERIFY(mirrored(head, true, true) == head && mirrored(head, true, false) != head);
      // R is a P with a leg; L has nothing but a stem on the left and a foot.
      QVERIFY(back.size() < right.size() &&
              std::includes(right.begin(), right.end(), back.begin(), back.end()));
      QVERIFY(mirrored(back, true, false) != back && mirrored(back, false, true) != back);
      for (const auto& [x, y] : left) QVERIFY(x < 2 || y > 11);
      QCOMPARE(left.size(), std::size_t{14 * 2 + 10 * 2 - 2 * 2});
    }
  }

  /// One each, and never by rounding where two choices are as near.
  void axesOfTheGridAreNamedByThePatients() {
    std::array<int, 3> axes{0, 1, 2};
    do
      for (int signs = 0; signs < 8; ++signs) {
        Geometry g;
        g.direction.setZero();
        for (int a = 0; a < 3; ++a)
          g.direction(axes[static_cast<std::size_t>(a)], a) = (signs >> a & 1) != 0 ? -1.0 : 1.0;
        QCOMPARE(nearestPatientAxes(g), axes);
        g.direction = Eigen::AngleAxisd(0.5, Vector3d(1, -2, 3).normalized()).toRotationMatrix() *
                      g.direction;
        QCOMPARE(nearestPatientAxes(g), axes);
      }
    while (std::next_permutation(axes.begin(), axes.end()));
    std::set<std::array<int, 3>> found;
    for (const double off : {-1e-13, 0.0, 1e-13}) {
      Geometry g;
      g.direction = Eigen::AngleAxisd(0.25 * M_PI + off, Vector3d::UnitZ()).toRotationMatrix();
      found.insert(nearestPatientAxes(g));
    }
    QCOMPARE(found.size(), std::size_t{1});
    QCOMPARE((*found.begin())[2], 2);
  }

  /// Round ones darken towards their outline; where the volume's border cuts one, it is even.
  void roundVesselsAreShadedAndCutsAreFlat() {
    const Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {1.0, 1.0, 1.0});
    const auto shadeOf = [&](const Volume<float>& phi) {
      const Picture p = previewPicture(imageOf(g, {Vector3d::Zero(), 8.0}), phi);
      const Region coronal = tilesOf(p)[3];
      return [p, coronal](double fromMiddleMm) {
        const auto x = static_cast<std::size_t>(coronal.left + 240 + 10.0 * fromMiddleMm);
        const auto y = static_cast<std::size_t>(coronal.top + 240);
        return static_cast<int>(p.rgb[3 * (y * static_cast<std::size_t>(p.width) + x)]);
      };
    };
    const auto ball = shadeOf(fieldOf(g, {Vector3d::Zero(), 8.0}));
    QVERIFY(ball(5.0) < ball(0.0) - 15 && ball(7.0) < ball(5.0) - 15 && ball(7.0) > 0);
    const auto cut = shadeOf(analytic::sampled(g, [](const Vector3d& x) {
      return analytic::tube(x, Vector3d::Zero(), Vector3d::UnitY(), 8.0);
    }));
    QVERIFY(cut(0.0) > 100 && cut(9.0) == 0);
    for (const double aside : {-7.0, -5.0, 5.0, 7.0}) QCOMPARE(cut(aside), cut(0.0));
  }

  /// Also where no brick of voxels is without vessel.
  void aVolumeFullOfVesselIsLight() {
    const Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {2.0, 2.0, 2.0});
    const Picture p = previewPicture(imageOf(g, {Vector3d::Zero(), 8.0}), Volume<float>(g, -1.0F));
    for (std::size_t i = 3; i < 6; ++i)
      QVERIFY(centreOfLight(p, tilesOf(p)[i])[2] > 0.95 * 480.0 * 480.0);
  }

  void whatLiesInTheMiddleIsShownThere() {
    const Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {1.0, 1.0, 1.0});
    const Ball ball{Vector3d::Zero(), 7.3};
    const Picture p = previewPicture(imageOf(g, ball), fieldOf(g, ball));
    for (const Region& tile : tilesOf(p))
      for (int a = 0; a < 2; ++a)
        QVERIFY(std::fabs(centreOfLight(p, tile)[a] - 0.5) * tile.width < 0.1);
  }

  void pixelsAreSquareAndTilesLimited() {
    Geometry g;
    g.size = {40, 30, 10};
    g.spacing = {0.5, 1.0, 3.0};  // 20 x 30 x 30 mm
    const Ball ball{g.toPhysical({20.0, 15.0, 5.0}), 4.0};
    const Picture p = previewPicture(imageOf(g, ball), fieldOf(g, ball));
    QCOMPARE(p.width - (320 + 480 + 320), 4 * 8);
    QCOMPARE(p.height - 2 * 480, 3 * 8);
    // Of any size.
    g.spacing *= 0.01;
    const Ball small{g.toPhysical({20.0, 15.0, 5.0}), 0.04};
    const Picture same = previewPicture(imageOf(g, small), fieldOf(g, small));
    QCOMPARE(same.width, p.width);
    QCOMPARE(same.height, p.height);
  }

  void aFieldElsewhereOrEmptyGivesDarkTiles() {
    const Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {1.0, 1.0, 1.0});
    const Ball ball{Vector3d::Zero(), 6.0};
    Geometry elsewhere = g;
    elsewhere.origin += Vector3d(500.0, 0.0, 0.0);
    const Ball there{Vector3d(500.0, 0.0, 0.0), 6.0};
    for (const Volume<float>& phi : {Volume<float>(g, 5.0F), fieldOf(elsewhere, there)}) {
      const Picture p = previewPicture(imageOf(g, ball), phi);
      for (std::size_t i = 3; i < 6; ++i) QCOMPARE(centreOfLight(p, tilesOf(p)[i]).norm(), 0.0);
    }
    QVERIFY_THROWS_EXCEPTION(InputError, previewPicture(Volume<float>(), Volume<float>()));
  }

  void theMipFromTheFrontIsThePreviews() {
    // So narrow that no letter is drawn on it.
    Geometry narrow;
    narrow.size = {6, 30, 52};
    const Volume<float> image = fieldOf(narrow, {Vector3d(2.0, 12.0, 20.0), 9.0});
    const Picture mip = mipFromTheFront(image, 480);
    const Picture preview = previewPicture(image, image);
    QVERIFY(mip.width < 60 && mip.height == 480);
    constexpr int gap = 8;
    for (int y = 0; y < mip.height; ++y)
      for (int x = 0; x < 3 * mip.width; ++x)
        QCOMPARE(mip.rgb[static_cast<std::size_t>(3 * y * mip.width + x)],
                 preview.rgb[static_cast<std::size_t>(3 * ((y + gap) * preview.width + gap) + x)]);
    const Picture small = mipFromTheFront(image, 52);
    QCOMPARE(small.width, 6);
    QCOMPARE(small.height, 52);
  }

  void picturesDoNotDependOnTheThreads() {
    const Geometry g = cubeGrid(Eigen::Matrix3d::Identity(), {1.5, 1.5, 1.5});
    const Ball ball{Vector3d(3.0, 2.0, 1.0), 8.0};
    setThreads(1);
    const Picture one = previewPicture(imageOf(g, ball), fieldOf(g, ball));
    setThreads(2);
    QVERIFY(one.rgb == previewPicture(imageOf(g, ball), fieldOf(g, ball)).rgb);
  }

  void axesAreAlike() {
    const Volume<float> image = analytic::unlikeVessels(true), other = analytic::turned(image);
    for (int axis = 0; axis < 3; ++axis) {
      const Projection one = maximumProjection(image, axis);
      const Projection two = maximumProjection(other, (axis + 1) % 3);
      // The two axes that are left, in order: along the second one they change places.
      const bool swapped = axis != 2;
      QCOMPARE(two.width, swapped ? one.height : one.width);
      for (int v = 0; v < one.height; ++v)
        for (int u = 0; u < one.width; ++u) {
          const auto at = static_cast<std::size_t>(swapped ? u * two.width + v : v * two.width + u);
          QCOMPARE(two.values[at], one.values[static_cast<std::size_t>(v * one.width + u)]);
        }
    }
  }
};

QTEST_GUILESS_MAIN(TestProjection)
#include "tst_projection.moc"
