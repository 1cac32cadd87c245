// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/corrections/apply_correction.h"
#include "core/corrections/replay.h"
#include "core/distance/redistance.h"
#include "core/field/wall_field.h"
#include "core/image/voxel_box.h"
#include "core/topology/handles.h"
#include "tests/core/analytic.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

std::size_t insideVoxels(const Volume<float>& phi) {
  return static_cast<std::size_t>(
      std::count_if(phi.voxels.begin(), phi.voxels.end(), [](float v) { return v < 0.0F; }));
}

std::size_t parts(const Volume<float>& phi) {
  return connectedComponents(insideMask(phi)).sizes.size();
}

/// Largest difference to a distance where that is below `band`, voxels of 1 mm.
template <class F>
double worstNear(const Volume<float>& phi, F distance, double band) {
  double worst = 0.0;
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const double d = distance(voxelCentre(phi.geometry, i));
    if (std::fabs(d) < band) worst = std::max(worst, std::fabs(d - phi.voxels[i]));
  }
  return worst;
}

/// Voxels with other bits at least `reach` voxels of 1 mm off a place.
std::size_t changedBeyond(const Volume<float>& a, const Volume<float>& b, const Vector3d& place,
                          double reach) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.voxels.size(); ++i)
    count += a.voxels[i] != b.voxels[i] && (voxelCentre(a.geometry, i) - place).norm() > reach;
  return count;
}

Correction brush(CorrectionKind kind, double radius, std::vector<Vector3d> line) {
  return {kind, radius, std::move(line), {0.0, 0.0, 0.0}};
}

Correction at(CorrectionKind kind, std::vector<Vector3d> places,
              const Vector3d& normal = {0.0, 0.0, 0.0}) {
  return {kind, 0.0, std::move(places), normal};
}

/// 200 in what is negative, 100 elsewhere, over a voxel at the edge.
Volume<float> imageOf(const Volume<float>& phi) {
  Volume<float> image = phi;
  for (float& v : image.voxels)
    v = 150.0F - 100.0F * std::clamp(v / static_cast<float>(phi.geometry.voxelMm()), -0.5F, 0.5F);
  return image;
}

/// Of vessels of about 3 voxels of 1 mm.
CorrectionGround groundOf(const Volume<float>* image) {
  CorrectionGround ground;
  ground.image = image;
  ground.vesselness.sigmaMinMm = 1.0;
  ground.vesselness.sigmaMaxMm = 3.0;
  return ground;
}

}  // namespace

class TestCorrections : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aBrushAddsItsBall() {
    const Geometry g = cube(32);
    const Vector3d far{7.0, 7.0, 7.0}, centre{20.3, 20.1, 19.8};
    const auto phi = redistance(clamped(g, [&](const Vector3d& x) { return ball(x, far, 3.5); }));
    const Corrected made =
        applyCorrection(phi, brush(CorrectionKind::Add, 4.0, {centre}), groundOf(nullptr));
    QVERIFY(worstNear(
                made.phi, [&](const Vector3d& x) { return ball(x, centre, 4.0); }, 3.0) < 0.02);
    QCOMPARE(changedBeyond(phi, made.phi, centre, 4.0 + 1.5 + 1.8 * 6.0), std::size_t{0});
    QCOMPARE(made.added, insideVoxels(made.phi) - insideVoxels(phi));
    QCOMPARE(made.removed, std::size_t{0});
    QCOMPARE(parts(made.phi), std::size_t{2});
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      if (phi.voxels[i] != made.phi.voxels[i]) QVERIFY(made.box.holds(g.indexOf(i)));
  }

  void aStrokeAddsATube() {
    const Geometry g = cube(36);
    const auto phi = redistance(clamped(g, [&](const Vector3d& x) {
      return ball(x, {6.0, 6.0, 6.0}, 3.0);
    }));
    const Vector3d a{12.0, 20.0, 18.0}, b{27.0, 22.0, 19.0};
    // Many places on one line are the same tube.
    std::vector<Vector3d> line;
    for (int n = 0; n <= 20; ++n) line.emplace_back(a + n / 20.0 * (b - a));
    for (const std::vector<Vector3d>& way : {std::vector<Vector3d>{a, b}, line}) {
      const Corrected made =
          applyCorrection(phi, brush(CorrectionKind::Add, 3.0, way), groundOf(nullptr));
      QVERIFY(worstNear(
                  made.phi, [&](const Vector3d& x) { return capsule(x, a, b, 3.0); }, 2.0) < 0.03);
    }
  }

  void aBrushThatRunsAlongTheWallLeavesIt() {
    const Geometry g = cube(32);
    const Vector3d middle{15.5, 15.5, 15.5}, z{0.0, 0.0, 1.0};
    const auto phi =
        redistance(clamped(g, [&](const Vector3d& x) { return tube(x, middle, z, 4.0); }));
    const Corrected made =
        applyCorrection(phi, brush(CorrectionKind::Add, 4.0, {middle - 8.0 * z, middle + 8.0 * z}),
                        groundOf(nullptr));
    QVERIFY(worstNear(
                made.phi, [&](const Vector3d& x) { return tube(x, middle, z, 4.0); }, 1.5) < 0.05);
  }

  void wherePartsMeetTheEdgeIsRounded() {
    const Geometry g = cube(40);
    const Vector3d middle{19.5, 19.5, 19.5}, x{1.0, 0.0, 0.0}, z{0.0, 0.0, 1.0};
    const auto phi =
        redistance(clamped(g, [&](const Vector3d& p) { return tube(p, middle, z, 5.0); }));
    const Corrected made = applyCorrection(
        phi, brush(CorrectionKind::Add, 4.0, {middle, middle + 12.0 * x}), groundOf(nullptr));
    QCOMPARE(parts(made.phi), std::size_t{1});
    const auto sharp = [&](const Vector3d& p) {
      return std::min(tube(p, middle, z, 5.0), capsule(p, middle, middle + 12.0 * x, 4.0));
    };
    const SplineField field = wallField(made.phi, SplineKind::InterpolatingBspline);
    // At the corner in the plane y = middle: of both walls, outside the sharp union.
    const Vector3d corner = middle + 5.0 * x + 4.0 * z;
    QVERIFY(sharp(corner) > -1e-6);
    QVERIFY(field.valueAt(corner) < -0.1 && field.valueAt(corner) > -0.4);
    // A voxel and a half on, nothing of it is left.
    QVERIFY(std::fabs(field.valueAt(corner + 1.6 * z)) < 0.05);
    QVERIFY(std::fabs(field.valueAt(corner + 1.6 * x)) < 0.05);
  }

  void erasingIsAddingToWhatIsOutside() {
    const Geometry g = cube(30);
    const Vector3d middle{14.5, 14.5, 14.5}, y{0.0, 1.0, 0.0};
    const auto phi =
        redistance(clamped(g, [&](const Vector3d& x) { return tube(x, middle, y, 4.2); }));
    Volume<float> turnedOut = phi;
    for (float& v : turnedOut.voxels) v = -v;
    const std::vector<Vector3d> line{middle + Vector3d(6.0, 0.0, 0.0),
                                     middle + Vector3d(3.0, 1.0, 2.0)};
    const Corrected erased =
        applyCorrection(phi, brush(CorrectionKind::Erase, 2.5, line), groundOf(nullptr));
    const Corrected added =
        applyCorrection(turnedOut, brush(CorrectionKind::Add, 2.5, line), groundOf(nullptr));
    double worst = 0.0;
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      worst = std::max(worst, std::fabs(0.0 + erased.phi.voxels[i] + added.phi.voxels[i]));
    QVERIFY(worst < 1e-3);
    QVERIFY(erased.removed > 20 && erased.added == 0);
    QCOMPARE(erased.removed, added.added);
  }

  void allCanBeErasedAndAllFilled() {
    const Geometry g = cube(16);
    const Vector3d middle{7.5, 7.5, 7.5};
    const auto phi =
        redistance(clamped(g, [&](const Vector3d& x) { return ball(x, middle, 3.0); }));
    const Corrected none =
        applyCorrection(phi, brush(CorrectionKind::Erase, 6.0, {middle}), groundOf(nullptr));
    QCOMPARE(insideVoxels(none.phi), std::size_t{0});
    for (const float v : none.phi.voxels) QCOMPARE(v, 5.0F);
    const Corrected all =
        applyCorrection(phi, brush(CorrectionKind::Add, 30.0, {middle}), groundOf(nullptr));
    QCOMPARE(insideVoxels(all.phi), g.voxelCount());
  }

  void theBrushStopsAtTheEdgeOfTheImage() {
    const Geometry g = cube(40);
    const Vector3d middle{19.5, 19.5, 19.5}, x{1.0, 0.0, 0.0};
    const auto vessel = [&](const Vector3d& p) { return tube(p, middle, x, 3.0); };
    // The segmentation has lost the half of the vessel.
    const auto phi = redistance(clamped(g, [&](const Vector3d& p) {
      return capsule(p, Vector3d(0.0, 19.5, 19.5), Vector3d(15.0, 19.5, 19.5), 3.0);
    }));
    const auto image = imageOf(sampled(g, vessel));
    for (const bool dark : {false, true}) {
      Volume<float> shown = image;
      CorrectionGround ground = groundOf(&shown);
      if (dark) {
        for (float& v : shown.voxels) v = -v;
        ground.vesselness.polarity = Polarity::Dark;
      }
      const Corrected made = applyCorrection(
          phi, brush(CorrectionKind::AddToEdge, 6.0, {middle - 3.0 * x, middle + 10.0 * x}),
          ground);
      QCOMPARE(parts(made.phi), std::size_t{1});
      double worst = 0.0;
      for (std::size_t i = 0; i < g.voxelCount(); ++i) {
        const Vector3d p = voxelCentre(g, i);
        if (p[0] < 4.0 || p[0] > 26.0 || std::fabs(vessel(p)) > 1.0) continue;
        worst = std::max(worst, std::fabs(vessel(p) - made.phi.voxels[i]));
      }
      QVERIFY2(worst < 0.3, qPrintable(QString::number(worst)));
    }
    // What is as bright, and not connected to the middle of the line, is no part of it.
    const Vector3d other = middle + Vector3d(4.0, 6.5, 0.0);
    const auto both = imageOf(
        sampled(g, [&](const Vector3d& p) { return std::min(vessel(p), ball(p, other, 1.6)); }));
    const Corrected alone = applyCorrection(
        phi, brush(CorrectionKind::AddToEdge, 9.0, {middle - 3.0 * x, middle + 10.0 * x}),
        groundOf(&both));
    QVERIFY(alone.added > 200);
    for (std::size_t i = 0; i < g.voxelCount(); ++i)
      if ((voxelCentre(g, i) - other).norm() < 2.0) QVERIFY(alone.phi.voxels[i] > 0.0F);
    // Where there is nothing bright under the brush.
    QVERIFY_THROWS_EXCEPTION(
        InputError, applyCorrection(phi, brush(CorrectionKind::AddToEdge, 3.0, {{20.0, 5.0, 5.0}}),
                                    groundOf(&image)));
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        applyCorrection(phi, brush(CorrectionKind::AddToEdge, 3.0, {middle}), groundOf(nullptr)));
  }

  void erasingToTheEdgeLeavesTheVessel() {
    const Geometry g = cube(40);
    const Vector3d middle{19.5, 19.5, 19.5}, x{1.0, 0.0, 0.0};
    const auto vessel = [&](const Vector3d& p) { return tube(p, middle, x, 3.0); };
    const Vector3d leak = middle + Vector3d(0.0, 4.0, 0.0);
    const auto phi = redistance(
        clamped(g, [&](const Vector3d& p) { return std::min(vessel(p), ball(p, leak, 3.5)); }));
    const auto image = imageOf(sampled(g, vessel));
    const Corrected made =
        applyCorrection(phi, brush(CorrectionKind::EraseToEdge, 7.0, {leak}), groundOf(&image));
    QVERIFY(worstNear(made.phi, vessel, 1.0) < 0.35);
    QVERIFY(made.added == 0 && made.removed > 50);
  }

  void aBridgeFollowsTheVessel() {
    // A quarter of a ring, dim over a stretch where the segmentation lost it.
    const Geometry g = cube(48);
    const Vector3d centre{4.0, 4.0, 23.5};
    const auto vessel = [&](const Vector3d& p) { return torus(p, centre, 30.0, 2.5); };
    const auto angleOf = [&](const Vector3d& p) { return std::atan2(p[1] - 4.0, p[0] - 4.0); };
    const auto phi = redistance(clamped(g, [&](const Vector3d& p) {
      const double off = std::fabs(angleOf(p) - M_PI / 4.0);
      return std::max(vessel(p), 30.0 * (0.25 - off));
    }));
    QCOMPARE(parts(phi), std::size_t{2});
    Volume<float> image = imageOf(sampled(g, vessel));
    for (std::size_t i = 0; i < image.voxels.size(); ++i) {
      const Vector3d p = voxelCentre(g, i);
      if (std::fabs(angleOf(p) - M_PI / 4.0) < 0.25)
        image.voxels[i] = 100.0F + 0.35F * (image.voxels[i] - 100.0F);
    }
    const auto onRing = [&](double angle) {
      return Vector3d(centre + 30.0 * Vector3d(std::cos(angle), std::sin(angle), 0.0));
    };
    const std::vector<Vector3d> ends{onRing(M_PI / 4.0 - 0.33), onRing(M_PI / 4.0 + 0.33)};
    const Corrected made = applyCorrection(phi, at(CorrectionKind::Bridge, ends), groundOf(&image));
    QCOMPARE(parts(made.phi), std::size_t{1});
    QCOMPARE(made.removed, std::size_t{0});
    QVERIFY(handlesOf(made.phi).empty());
    // It bends with the vessel: the straight way lies 1.6 mm inside the ring.
    const SplineField field = wallField(made.phi, SplineKind::InterpolatingBspline);
    for (const double angle : {-0.2, -0.1, 0.0, 0.1, 0.2}) {
      const Vector3d out = (onRing(M_PI / 4.0 + angle) - centre).normalized();
      const double outer = field.valueAt(centre + 32.5 * out);
      const double inner = field.valueAt(centre + 27.5 * out);
      QVERIFY2(std::fabs(outer) < 0.8 && std::fabs(inner) < 0.8,
               qPrintable(QString("%1: %2 %3").arg(angle).arg(outer).arg(inner)));
    }
    // From the other end it is the same way.
    const Corrected back =
        applyCorrection(phi, at(CorrectionKind::Bridge, {ends[1], ends[0]}), groundOf(&image));
    QVERIFY(std::fabs(static_cast<double>(back.added) - static_cast<double>(made.added)) <
            0.1 * static_cast<double>(made.added));
    // Without an image it is straight.
    QCOMPARE(parts(applyCorrection(phi, at(CorrectionKind::Bridge, ends), groundOf(nullptr)).phi),
             std::size_t{1});
    QVERIFY_THROWS_EXCEPTION(
        InputError, applyCorrection(phi, at(CorrectionKind::Bridge, {ends[0], {4.0, 4.0, 4.0}}),
                                    groundOf(&image)));
  }

  void vesselsThatTouchAreParted() {
    const Geometry g = cube(40);
    const Vector3d one{15.0, 19.5, 19.5}, other{22.5, 19.5, 19.5};
    const Vector3d along = Vector3d(0.0, 0.25, 1.0).normalized();
    const Vector3d across = Vector3d(0.0, -0.25, 1.0).normalized();
    const auto vessels = [&](const Vector3d& p) {
      return std::min(tube(p, one, along, 4.0), tube(p, other, across, 4.0));
    };
    const auto phi = redistance(clamped(g, vessels));
    QCOMPARE(parts(phi), std::size_t{1});
    const Volume<float> image = imageOf(sampled(g, vessels));
    for (const Volume<float>* shown : {static_cast<const Volume<float>*>(nullptr), &image}) {
      const Corrected made =
          applyCorrection(phi, at(CorrectionKind::Separate, {one, other}), groundOf(shown));
      const Components after = connectedComponents(insideMask(made.phi));
      QCOMPARE(after.sizes.size(), std::size_t{2});
      // Each keeps what is its own.
      QVERIFY(made.added == 0 && made.removed < 160);
      QVERIFY(after.labels.at(15, 20, 20) != after.labels.at(22, 20, 20));
      QVERIFY(static_cast<double>(after.sizes[1]) > 0.9 * static_cast<double>(after.sizes[0]));
      for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
        const Vector3d p = voxelCentre(g, i);
        const bool was = phi.voxels[i] < 0.0F, is = made.phi.voxels[i] < 0.0F;
        if (was && !is) QVERIFY(std::fabs(p[0] - 18.75) < 2.5);
      }
      // They do not touch any more.
      QVERIFY_THROWS_EXCEPTION(
          InputError,
          applyCorrection(made.phi, at(CorrectionKind::Separate, {one, other}), groundOf(shown)));
    }
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        applyCorrection(phi, at(CorrectionKind::Separate, {one, one}), groundOf(&image)));
  }

  void aPlaneEndsAVessel() {
    const Geometry g = cube(40);
    const Vector3d middle{19.5, 19.5, 19.5};
    const Vector3d axis = Vector3d(1.0, 0.2, 0.1).normalized();
    // With a branch beyond the plane, and a vessel beside it that stays.
    const auto vessel = [&](const Vector3d& p) { return tube(p, middle, axis, 3.2); };
    const auto beside = [&](const Vector3d& p) {
      return tube(p, {19.5, 19.5, 5.0}, Vector3d(1.0, 0.0, 0.0), 2.6);
    };
    const Vector3d fork = middle + 6.0 * axis;
    const auto phi = redistance(clamped(g, [&](const Vector3d& p) {
      return std::min({vessel(p), beside(p), capsule(p, fork, {20.0, 36.0, 20.0}, 2.6)});
    }));
    const Corrected made =
        applyCorrection(phi, at(CorrectionKind::CutOff, {middle}, axis), groundOf(nullptr));
    QCOMPARE(parts(made.phi), std::size_t{2});
    const auto left = [&](const Vector3d& p) {
      return std::min(std::max(vessel(p), (p - middle).dot(axis)), beside(p));
    };
    for (std::size_t i = 0; i < g.voxelCount(); ++i) {
      const double d = left(voxelCentre(g, i));
      if (std::fabs(d) > 0.1) QCOMPARE(made.phi.voxels[i] < 0.0F, d < 0.0);
    }
    // The flat end lies in the plane.
    const SplineField field = wallField(made.phi, SplineKind::InterpolatingBspline);
    QVERIFY(std::fabs(field.valueAt(middle)) < 0.05);
    // The other side.
    const Corrected back =
        applyCorrection(phi, at(CorrectionKind::CutOff, {middle}, -axis), groundOf(nullptr));
    QVERIFY(std::fabs(0.0 + made.removed + back.removed + insideVoxels(sampled(g, beside)) -
                      insideVoxels(phi)) < 40);
    // Without a side it is the one that has less.
    const Vector3d nearer = middle - 6.0 * axis;
    const Corrected least =
        applyCorrection(phi, at(CorrectionKind::CutOff, {nearer}), groundOf(nullptr));
    QVERIFY(least.removed > 50 && least.removed < 0.8 * static_cast<double>(back.removed));
    QVERIFY(least.phi.at(19, 19, 19) < 0.0F && least.phi.at(5, 17, 18) > 0.0F);
    QVERIFY_THROWS_EXCEPTION(
        InputError, applyCorrection(phi, at(CorrectionKind::CutOff, {{20.0, 8.0, 36.0}}, axis),
                                    groundOf(nullptr)));
  }

  void aRingIsNotCutOff() {
    const Geometry g = cube(32);
    const Vector3d middle{15.5, 15.5, 15.5};
    const auto phi =
        redistance(clamped(g, [&](const Vector3d& p) { return torus(p, middle, 9.0, 2.6); }));
    QVERIFY_THROWS_EXCEPTION(
        InputError, applyCorrection(phi,
                                    at(CorrectionKind::CutOff, {middle + Vector3d(9.0, 0.0, 0.0)},
                                       Vector3d(0.0, 1.0, 0.0)),
                                    groundOf(nullptr)));
  }

  void cavitiesAndHolesAreFilled() {
    const Geometry g = cube(32);
    const Vector3d middle{15.5, 15.5, 15.5};
    const auto hollow = redistance(clamped(g, [&](const Vector3d& p) {
      return std::max(ball(p, middle, 9.0), -ball(p, middle, 3.0));
    }));
    const Corrected solid =
        applyCorrection(hollow, at(CorrectionKind::FillHole, {middle}), groundOf(nullptr));
    QVERIFY(worstNear(
                solid.phi, [&](const Vector3d& p) { return ball(p, middle, 9.0); }, 3.0) < 0.03);
    QCOMPARE(solid.removed, std::size_t{0});

    // However deep it is.
    const auto wide = redistance(clamped(g, [&](const Vector3d& p) {
      return std::max(ball(p, middle, 13.0), -ball(p, middle, 8.0));
    }));
    const Corrected full =
        applyCorrection(wide, at(CorrectionKind::FillHole, {middle}), groundOf(nullptr));
    QVERIFY(worstNear(
                full.phi, [&](const Vector3d& p) { return ball(p, middle, 13.0); }, 1.5) < 0.03);

    const auto ring =
        redistance(clamped(g, [&](const Vector3d& p) { return torus(p, middle, 6.0, 3.5); }));
    QCOMPARE(handlesOf(ring).size(), std::size_t{1});
    const Corrected closed =
        applyCorrection(ring, at(CorrectionKind::FillHole, {middle}), groundOf(nullptr));
    QVERIFY(handlesOf(closed.phi).empty());
    QVERIFY(closed.added > 0 && closed.removed == 0);
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        applyCorrection(closed.phi, at(CorrectionKind::FillHole, {middle}), groundOf(nullptr)));
  }

  void aLoopIsOpenedWhereItIsThin() {
    const Geometry g = cube(40);
    const Vector3d middle{19.5, 19.5, 19.5};
    // Thinnest at the greatest x.
    const auto phi = redistance(clamped(g, [&](const Vector3d& p) {
      return torus(p, middle, 10.0, 3.2 - 0.07 * (p[0] - middle[0]));
    }));
    QCOMPARE(handlesOf(phi).size(), std::size_t{1});
    const Vector3d thin = middle + Vector3d(10.0, 0.0, 0.0);
    const Corrected made =
        applyCorrection(phi, at(CorrectionKind::OpenLoop, {thin}), groundOf(nullptr));
    QVERIFY(handlesOf(made.phi).empty());
    QCOMPARE(parts(made.phi), std::size_t{1});
    QVERIFY(made.added == 0);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      if (phi.voxels[i] < 0.0F && !(made.phi.voxels[i] < 0.0F))
        QVERIFY((voxelCentre(g, i) - thin).norm() < 7.0);
    QVERIFY_THROWS_EXCEPTION(
        InputError,
        applyCorrection(made.phi, at(CorrectionKind::OpenLoop, {thin}), groundOf(nullptr)));
  }
};

QTEST_GUILESS_MAIN(TestCorrections)
#include "tst_corrections.moc"
