// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <array>
#include <cmath>
#include <functional>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/phantom/phantom.h"
#include "core/quality/zero_set_measure.h"
#include "core/sizing/guidance_field.h"
#include "core/sizing/guidance_samples.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;

namespace {

constexpr double pi = 3.14159265358979323846;

SplineField fieldOf(const Geometry& g, const std::function<double(const Eigen::Vector3d&)>& f) {
  return {sampled(g, f), SplineKind::InterpolatingBspline};
}

/// The thesis's own setting: curvature alone.
SizingParams curvatureOnly() { return SizingParams::printed(); }

Eigen::Vector3d jitter(std::uint64_t i) {
  return {randomUniform(7, 3 * i) - 0.5, randomUniform(7, 3 * i + 1) - 0.5,
          randomUniform(7, 3 * i + 2) - 0.5};
}

/// Whether g is `expected` within `tolerance` (relative) at points of the zero set `margin` voxels
/// away from the border.
bool isEverywhere(const GuidanceField& guidance, const SplineField& field, double expected,
                  double tolerance, double margin = 5.0) {
  const Geometry& g = field.geometry();
  int seen = 0;
  for (std::size_t i = 0; i < guidance.samples().size(); ++i) {
    Eigen::Vector3d x = guidance.samples()[i].point + 0.7 * jitter(i);
    if (!field.projectToZero(x)) continue;
    const Eigen::Vector3d index = g.toIndex(x);
    bool inner = true;
    for (int a = 0; a < 3; ++a)
      inner = inner && index[a] >= margin && index[a] <= g.size[a] - 1 - margin;
    if (!inner) continue;
    ++seen;
    if (std::fabs(guidance.at(x) / expected - 1.0) > tolerance) {
      qWarning("%g instead of %g", guidance.at(x), expected);
      return false;
    }
  }
  return seen > 100;
}

}  // namespace

class TestGuidanceField : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreads(0); }

  void tubeAndTorusHaveTheLengthOfTheirCurvature() {
    const Geometry g = cube(44);
    const Eigen::Vector3d c = centreOf(g) + Eigen::Vector3d(0.3, 0.1, -0.2);
    const double r = 6.0;
    const double chord = 2.0 * std::sin(0.2) * r;
    const SplineField bodies[] = {
        fieldOf(g,
                [&](const auto& x) {
                  return tube(x, c, Eigen::Vector3d(0.3, 0.2, 0.93).normalized(), r);
                }),
        fieldOf(g, [&](const auto& x) { return torus(x, c, 13.5, r); })};
    for (const SplineField& field : bodies) {
      SizingParams p = curvatureOnly();
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 0.8 * chord, 0.04, 3.0));
      p.curvatureRelax = 3.0;
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 2.4 * chord, 0.04, 3.0));
      p.curvatureRelax = 1.0;
      p.etaCompensated = true;
      QVERIFY(isEverywhere(GuidanceField(field, p), field, chord, 0.04, 3.0));
      p.edgeMaxMm = 0.5;
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 0.5, 0.03, 3.0));
      p.edgeMaxMm.reset();
      p.edgeMinMm = 5.0;
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 5.0, 1e-9, 3.0));
    }
  }

  // Eq. 4.1: an edge subtends the angle rho on a circle of radius 1 / kappa.
  void theIdealLengthIsTheChordOfRho() {
    const Geometry g = cube(30);
    const SplineField field = fieldOf(g, [&](const auto& x) { return ball(x, centreOf(g), 8.0); });
    for (const double rho : {0.1, 0.4, 1.2}) {
      SizingParams p = SizingParams::printed(rho);
      for (const double kappa : {0.1, 0.25, 2.0}) {
        const double chord = 2.0 * std::sin(0.5 * rho) / kappa;
        p.etaCompensated = false;
        QVERIFY(std::fabs(GuidanceField(field, p).idealLength(kappa) / (0.8 * chord) - 1.0) < 1e-9);
        p.etaCompensated = true;
        QVERIFY(std::fabs(GuidanceField(field, p).idealLength(kappa) / chord - 1.0) < 1e-9);
      }
    }
  }

  void soManyEdgesGoAround() {
    const Geometry g = cube(36);
    const Eigen::Vector3d c = centreOf(g) + Eigen::Vector3d(0.3, 0.1, -0.2);
    const Eigen::Vector3d axis = Eigen::Vector3d(0.3, 0.2, 0.93).normalized();
    const double r = 5.0;
    const SplineField field = fieldOf(g, [&](const auto& x) { return tube(x, c, axis, r); });
    SizingParams p;
    p.curvatureRelax = 40.0;
    for (const int n : {6, 12, 20}) {
      p.edgesAround = n;
      const GuidanceField guidance(field, p);
      QVERIFY(isEverywhere(guidance, field, 2.0 * r * std::sin(pi / n), 0.03));
    }
  }

  void curvatureAsksForNoEdgeThatVoxelsDoNotTell() {
    const Geometry g = oblique(40, 34, 24);
    const Eigen::Vector3d c = centreOf(g);
    const double voxel = std::cbrt(g.spacing.prod());
    for (const double r : {4.0, 6.0}) {
      const SplineField field = fieldOf(g, [&](const auto& x) { return ball(x, c, r); });
      SizingParams p = SizingParams::printed(0.02);
      p.etaCompensated = true;
      p.edgeMinVoxels = 0.7;
      // Between samples it rises by the slope.
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 0.7 * voxel, 0.12));
      // However long that is, no edge spans more than 0.8 radian.
      p.edgeMinVoxels = 20.0;
      QVERIFY(isEverywhere(GuidanceField(field, p), field, 2.0 * std::sin(0.4) * r, 0.04));
    }
  }

  /// A plate has no curvature: its thickness alone limits, and without that the size of the volume.
  void aFlatPlateHasAFiniteLength() {
    const Geometry g = cube(30);
    const SplineField field = fieldOf(g, [&](const auto& x) {
      return std::fabs(x.dot(Eigen::Vector3d(0, 0.6, 0.8)) - 20.3) - 2.0;
    });
    SizingParams p = curvatureOnly();
    GuidanceField wide(field, p);
    p.edgesAround = 12;
    QVERIFY(isEverywhere(GuidanceField(field, p), field, 4.0 * std::sin(pi / 12), 0.02, 8.0));
    for (const auto& s : wide.samples()) QVERIFY(wide.at(s.point) < 31.0 * std::sqrt(3.0));
  }

  void lengthsFollowTheGrid() {
    const Geometry g = oblique(40, 34, 24);
    const Eigen::Vector3d c = centreOf(g);
    const SplineField field = fieldOf(g, [&](const auto& x) { return ball(x, c, 5.0); });
    const GuidanceField guidance(field, curvatureOnly());
    QVERIFY(isEverywhere(guidance, field, 1.6 * std::sin(0.2) * 5.0, 0.04));
    QVERIFY(std::fabs(guidance.estimatedAreaMm2() / (4 * pi * 25.0) - 1.0) < 0.02);
  }

  /// Between thick slices the wall bends as much as between thin ones.
  void thickSlicesAreLookedIntoFinely() {
    Geometry g = cube(44);
    g.size = {44, 44, 12};
    g.spacing = {1.0, 1.0, 4.0};
    const Eigen::Vector3d c = centreOf(g) + Eigen::Vector3d(0.3, 0.1, -0.2);
    const double r = 6.0;
    const SplineField tilted = fieldOf(g, [&](const auto& x) {
      return tube(x, c, Eigen::Vector3d(0.6, 0.1, 0.79).normalized(), r);
    });
    const SplineField small = fieldOf(g, [&](const auto& x) { return ball(x, c, 3.0); });
    for (const SplineField* field : {&tilted, &small}) {
      const GuidanceField guidance(*field, curvatureOnly());
      const double area = measureZeroSet(*field).areaMm2;
      QVERIFY(isNear(guidance.estimatedAreaMm2() / area, 1.0, 0.03));
      for (const auto& s : guidance.samples()) QVERIFY(s.reachMm < 1.0);
    }
  }

  void neitherSteepNorAboveTheIdealLength() {
    PhantomParams tree;
    tree.kind = PhantomKind::CapsuleTree;
    tree.size = {64, 64, 64};
    tree.radius = 3.0;
    const SplineField field(phantomField(tree), SplineKind::InterpolatingBspline);
    const GuidanceField guidance(field, curvatureOnly());
    std::vector<Eigen::Vector3d> points;
    for (std::size_t i = 0; i < guidance.samples().size(); ++i) {
      const auto& sample = guidance.samples()[i];
      QVERIFY(guidance.at(sample.point) <= sample.lengthMm * (1 + 1e-12));
      Eigen::Vector3d x = sample.point + jitter(i);
      if (field.projectToZero(x)) points.push_back(x);
    }
    std::size_t above = 0;
    std::size_t steep = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double g = guidance.at(points[i]);
      if (g > 1.02 * guidance.idealLength(field.secondAt(points[i]))) ++above;
      const std::uint64_t j = randomBits(5, i) % points.size();
      const Eigen::Vector3d near = points[i] + 1.5 * jitter(i + 77);
      for (const Eigen::Vector3d& other : {points[j], near})
        if (std::fabs(guidance.at(other) - g) >
            guidance.slope() * (other - points[i]).norm() + 0.02 * g)
          ++steep;
    }
    // Where the curvature rises within one cell faster than the field may, a little is missed.
    QVERIFY(above * 30 <= points.size());
    QVERIFY(steep * 1000 <= points.size());
    // What eq. 4.3 says with the same samples.
    for (std::size_t i = 0; i < points.size(); i += 50) {
      double lowest = 1e9;
      for (const auto& s : guidance.samples())
        lowest = std::min(
            lowest, s.lengthMm +
                        guidance.slope() * std::max(0.0, (points[i] - s.point).norm() - s.reachMm));
      QVERIFY(guidance.at(points[i]) >= lowest - 1e-12);
      QVERIFY(guidance.at(points[i]) <= 1.2 * lowest);
    }
  }

  void theSameForAnyNumberOfThreads() {
    PhantomParams tree;
    tree.kind = PhantomKind::CapsuleTree;
    tree.size = {48, 48, 48};
    tree.radius = 2.5;
    const SplineField field(phantomField(tree), SplineKind::InterpolatingBspline);
    setThreads(1);
    const GuidanceField one(field, {});
    setThreads(2);
    const GuidanceField two(field, {});
    QCOMPARE(one.samples().size(), two.samples().size());
    QCOMPARE(one.estimatedTriangles(), two.estimatedTriangles());
    for (std::size_t i = 0; i < one.samples().size(); ++i) {
      QVERIFY(one.samples()[i].point == two.samples()[i].point);
      const Eigen::Vector3d x = one.samples()[i].point + jitter(i);
      QVERIFY(one.at(x) == two.at(x));
    }
  }

  void estimatesAreaAndTriangles() {
    const Geometry g = cube(44);
    const Eigen::Vector3d c = centreOf(g);
    const double r = 5.0;
    const double ring = 14.0;
    const SplineField field = fieldOf(g, [&](const auto& x) { return torus(x, c, ring, r); });
    const GuidanceField guidance(field, curvatureOnly());
    const double area = 4 * pi * pi * ring * r;
    const double edge = 1.6 * std::sin(0.2) * r;
    QVERIFY(std::fabs(guidance.estimatedAreaMm2() / area - 1.0) < 0.02);
    const double triangles = area / (std::sqrt(3.0) / 4.0 * edge * edge);
    QVERIFY(std::fabs(guidance.estimatedTriangles() / triangles - 1.0) < 0.05);
  }

  // Where edges are longer than cells, the samples stand for what of the zero set lies in all
  // cells, none left out and none counted twice, however they are found.
  void samplesHaveTheAreaOfAllCells() {
    SizingParams params = curvatureOnly();
    params.edgeMinMm = 2.0;
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      Volume<float> phi(cube(16));
      for (std::size_t i = 0; i < phi.voxels.size(); ++i)
        phi.voxels[i] = static_cast<float>(randomNormal(seed, i));
      const SplineField field(phi, SplineKind::InterpolatingBspline);
      double area = 0.0;
      for (const GuidanceField::Sample& sample : GuidanceField(field, params).samples())
        area += sample.areaMm2;
      double expected = 0.0;
      for (int cell = 0; cell < 15 * 15 * 15; ++cell) {
        std::array<double, 8> corner{};
        for (int c = 0; c < 8; ++c)
          corner[static_cast<std::size_t>(c)] = field.atVoxel(
              cell % 15 + (c & 1), cell / 15 % 15 + (c >> 1 & 1), cell / 225 + (c >> 2 & 1));
        expected += zeroSetArea(corner, Eigen::Matrix3d::Identity());
      }
      QVERIFY(isNear(area / expected, 1.0, 1e-9));
    }
  }

  void endsOnInputOfAnyKind() {
    const Geometry g = cube(20);
    const Eigen::Vector3d c = centreOf(g);
    const std::vector<std::function<double(const Eigen::Vector3d&)>> inputs = {
        [](const auto&) { return 0.0; },
        [](const auto&) { return 1.0; },
        [&](const auto& x) { return ball(x, c, 5.0) < 0 ? -0.5 : 0.5; },
        [&](const auto& x) { return std::round(ball(x, c, 5.0)); },
        [&](const auto& x) { return std::max(0.0, ball(x, c, 5.0)); },
        [&](const auto& x) { return std::min(0.0, ball(x, c, 5.0)); },
        [&](const auto& x) { return (x - c).norm() < 0.9 ? -1.0 : 1.0; },
        [&](const auto& x) {
          return randomNormal(9, static_cast<std::uint64_t>(x[0] + 50 * x[1] + 2500 * x[2]));
        },
        [&](const auto& x) { return 1e30 * ball(x, c, 5.0); },
        [&](const auto& x) { return 1e-20 * ball(x, c, 5.0); }};
    for (const auto& f : inputs)
      for (const SplineKind kind :
           {SplineKind::InterpolatingBspline, SplineKind::Bspline, SplineKind::CatmullRom}) {
        const SplineField field(sampled(g, f), kind);
        const GuidanceField guidance(field, {});
        for (const auto& s : guidance.samples()) QVERIFY(s.lengthMm >= 0.02 && s.lengthMm < 40.0);
        for (const Eigen::Vector3d& x : {c, Eigen::Vector3d(-50.0, 3.0, 900.0)})
          QVERIFY(guidance.at(x) >= 0.02 && std::isfinite(guidance.at(x)));
        QVERIFY(std::isfinite(guidance.estimatedTriangles()));
      }
    Geometry thin = g;
    thin.size = {2, 20, 1};
    const SplineField field(sampled(thin, inputs[3]), SplineKind::InterpolatingBspline);
    QVERIFY(GuidanceField(field, {}).at(c) > 0.0);
  }

  void areaOfACutThroughACell() {
    // The plane x + y + z = 1 cuts a triangle with sides sqrt(2) off the unit cell; x = 0.3 a
    // square.
    std::array<double, 8> oblique{};
    std::array<double, 8> upright{};
    for (std::size_t i = 0; i < 8; ++i) {
      oblique[i] = static_cast<double>((i & 1) + (i >> 1 & 1) + (i >> 2)) - 1.0 + 1e-9;
      upright[i] = static_cast<double>(i & 1) - 0.3;
    }
    QVERIFY(std::fabs(zeroSetArea(oblique, Eigen::Matrix3d::Identity()) - std::sqrt(3.0) / 2) <
            1e-6);
    QVERIFY(std::fabs(zeroSetArea(upright, Eigen::Matrix3d::Identity()) - 1.0) < 1e-12);
  }
};

QTEST_GUILESS_MAIN(TestGuidanceField)
#include "tst_guidance_field.moc"
