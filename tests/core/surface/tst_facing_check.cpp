// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/surface/facing_check.h"
#include "tests/core/surface/surface_bed.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// A function of the distance along a direction from the middle of a grid, with another spacing
// along each axis. Splines hold polynomials of the second degree.
struct Layers {
  Vector3d middle, along;
  SplineField field;

  template <class F>
  Layers(const Vector3d& direction, F f)
      : middle(analytic::centreOf(analytic::oblique(24, 22, 18))),
        along(direction.normalized()),
        field(analytic::fieldOf(
            analytic::sampled(analytic::oblique(24, 22, 18),
                              [&](const Vector3d& p) { return f((p - middle).dot(along)); }))) {}

  // A small triangle around a place, with a normal at an angle to the direction of the layers.
  void add(PatchMesh& mesh, double at, double degrees = 0.0, double size = 0.05) const {
    const double turn = degrees * M_PI / 180.0;
    const Vector3d aside = along.unitOrthogonal(), level = along.cross(aside);
    const Vector3d normal = std::cos(turn) * along + std::sin(turn) * aside;
    const Vector3d u = level, v = normal.cross(level);
    const auto first = static_cast<std::uint32_t>(mesh.mesh.points.size());
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * M_PI * k / 3.0;
      mesh.mesh.points.push_back(middle + at * along +
                                 size * (std::cos(angle) * u + std::sin(angle) * v));
      mesh.place.push_back(Place::onWall());
    }
    addTriangle(mesh, {first, first + 1, first + 2});
  }
  [[nodiscard]] std::vector<TurnedFace> turned(double at, double degrees = 0.0,
                                               double size = 0.05) const {
    PatchMesh mesh;
    add(mesh, at, degrees, size);
    return turnedFaces(mesh, field, {});
  }
};

const Vector3d kDirections[] = {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {1, 2, -1}, {-3, 1, 2}};

}  // namespace

class TestFacingCheck : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Where the gradient is the same everywhere a face is turned away from a right angle on, by the
  // angle that it has.
  void anglesToTheGradientAreMeasured() {
    for (const Vector3d& direction : kDirections) {
      const Layers layers(direction, [](double x) { return 2.5 * x; });
      for (const double degrees : {0.0, 40.0, 85.0, -60.0, -88.0})
        QVERIFY(layers.turned(0.0, degrees).empty());
      for (const double degrees : {92.0, 120.0, 175.0, -95.0}) {
        const auto turned = layers.turned(0.0, degrees);
        QCOMPARE(turned.size(), std::size_t{1});
        QVERIFY(turned[0].measured);
        QVERIFY(std::fabs(turned[0].degrees - std::fabs(degrees)) < 0.01);
      }
    }
  }

  void wallTrianglesAreLookedAtInTheirOrder() {
    const Layers layers({1, 2, -1}, [](double x) { return x; });
    PatchMesh mesh;
    for (const double degrees : {0.0, 150.0, 100.0, 20.0, 170.0}) layers.add(mesh, 0.0, degrees);
    // One without an area faces nothing.
    addTriangle(mesh, {0, 1, 1});
    mesh.patch[2] = 1;
    const auto turned = turnedFaces(mesh, layers.field, {});
    QCOMPARE(turned.size(), std::size_t{3});
    QCOMPARE(turned[0].triangle, 1U);
    QCOMPARE(turned[1].triangle, 4U);
    QCOMPARE(turned[2].triangle, 5U);
    QVERIFY(turned[2].measured);
  }

  // phi = x - x^2 / (2 turn) mm grows as far as x = turn. What lies between a triangle and its foot
  // is looked at to twice the distance, to first order, but no farther than a voxel.
  void theWayToTheZeroSetIsLookedAt() {
    for (const Vector3d& direction : kDirections) {
      const auto parabola = [&](double turn) {
        return Layers(direction, [=](double x) { return x - 0.5 * x * x / turn; });
      };
      // 2 phi / phi' is 0.98 of the way to the turn, or 1.05 of it.
      const double turn = 0.4;
      const Layers near = parabola(turn);
      const auto reach = [&](double x) {
        return 2.0 * (x - 0.5 * x * x / turn) / (1.0 - x / turn) / (turn - x);
      };
      QVERIFY(reach(0.105) < 0.99 && reach(0.125) > 1.1);
      QVERIFY(near.turned(0.105, 0.0, 1e-4).empty());
      QCOMPARE(near.turned(0.125, 0.0, 1e-4).size(), std::size_t{1});
      // Farther off than a voxel.
      const double voxel = near.field.geometry().voxelMm();
      const Layers far = parabola(2.0);
      QVERIFY(far.turned(2.0 - 1.1 * voxel, 0.0, 1e-4).empty());
      QCOMPARE(far.turned(2.0 - 0.9 * voxel, 0.0, 1e-4).size(), std::size_t{1});
      // The triangle itself reaches over it.
      const auto over = far.turned(0.0, 80.0, 3.0);
      QCOMPARE(over.size(), std::size_t{1});
      QVERIFY(over[0].measured && std::fabs(over[0].degrees - 100.0) < 1.0);
    }
  }

  // Wherever on a large triangle the gradient turns away in a small place, at its corners, at the
  // middles of its edges or at its centroid: its angle there is the one that is told.
  void cornersEdgesAndTheCentroidAreMeasured() {
    const Geometry g = analytic::cube(40);
    const Vector3d centre = analytic::centreOf(g) + Vector3d(0.2, 0.1, 0.3);
    std::vector<Vector3d> corners, places{centre};
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * M_PI * k / 3.0;
      corners.push_back(centre + 11.0 * Vector3d(std::cos(angle), std::sin(angle), 0.0));
    }
    for (std::size_t k = 0; k < 3; ++k) {
      places.push_back(corners[k]);
      places.push_back(0.5 * (corners[k] + corners[(k + 1) % 3]));
    }
    PatchMesh mesh;
    mesh.mesh.points = corners;
    mesh.place.assign(3, Place::onWall());
    addTriangle(mesh, {0, 1, 2});
    for (const Vector3d& place : places) {
      const SplineField field = analytic::fieldOf(analytic::sampled(g, [&](const Vector3d& p) {
        const Vector3d d = p - place;
        return 0.5 * d.x() + d.z() * (1.0 - 1.5 * std::exp(-0.25 * d.squaredNorm()));
      }));
      const double degrees = analytic::degreesBetween(field.at(place).gradient, Vector3d::UnitZ());
      QVERIFY(degrees > 125.0);
      const auto turned = turnedFaces(mesh, field, {});
      QCOMPARE(turned.size(), std::size_t{1});
      QVERIFY(turned[0].measured && std::fabs(turned[0].degrees - degrees) < 1e-6);
    }
  }

  // Nor does a small place between all those in which the gradient turns away go unnoticed, though
  // only halved boxes lead there; they also tell where it comes near to that but does not.
  void placesInsideATriangleAreLookedAt() {
    const Geometry g = analytic::cube(24);
    const Vector3d centre = analytic::centreOf(g) + Vector3d(0.2, 0.1, 0.3);
    PatchMesh mesh;
    for (int k = 0; k < 3; ++k) {
      const double angle = 2.0 * M_PI * k / 3.0;
      mesh.mesh.points.push_back(centre + 5.0 * Vector3d(std::cos(angle), std::sin(angle), 0.0));
    }
    mesh.place.assign(3, Place::onWall());
    addTriangle(mesh, {0, 1, 2});
    // Along the normal the gradient is 1 - depth in that place.
    for (const auto& [depth, turns] : {std::pair{0.95, false}, std::pair{1.5, true}}) {
      for (const Vector3d& corner : mesh.mesh.points) {
        const Vector3d place = 0.55 * centre + 0.45 * corner;
        const SplineField field =
            analytic::fieldOf(analytic::sampled(g, [&, most = depth](const Vector3d& p) {
              const Vector3d d = p - place;
              return 0.5 * d.x() + d.z() * (1.0 - most * std::exp(-0.25 * d.squaredNorm()));
            }));
        QCOMPARE(!turnedFaces(mesh, field, {}).empty(), turns);
      }
    }
  }

  // Where no bound over the whole triangle is enough boxes are halved; a wave that nowhere turns is
  // found to face, one that turns a little is found to turn.
  void halvedBoxesDecide() {
    for (const auto& [height, turns] : {std::pair{0.8, false}, std::pair{1.3, true}}) {
      const Layers waves({0, 0, 1}, [h = height](double x) { return x + h * std::sin(x); });
      for (const double size : {0.6, 1.5, 4.0}) {
        // Across many waves.
        const auto turned = waves.turned(0.0, 60.0, size);
        QCOMPARE(!turned.empty(), turns && size > 2.0);
      }
    }
  }
};

QTEST_GUILESS_MAIN(TestFacingCheck)
#include "tst_facing_check.moc"
