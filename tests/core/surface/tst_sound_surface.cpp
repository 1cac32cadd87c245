// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/mesh/mesh_faults.h"
#include "core/pipeline/surface_step.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/smooth_soundly.h"
#include "core/smooth/smoothing.h"
#include "core/surface/facing_check.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/surface/surface_bed.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

// Fields that a front, or a remesher, ties up.
Volume<float> fieldNamed(const QString& name) {
  if (name == "noise") return shapes::noise({6, 6, 6}, 7);
  if (name == "anisotropic noise") {
    Volume<float> phi = shapes::noise({5, 5, 4}, 11);
    phi.geometry.spacing = {0.4, 0.4, 2.0};
    return phi;
  }
  if (name == "thin sheets")
    // Two that lean towards each other, each thinner than a tenth of a voxel.
    return analytic::sampled(analytic::cube(20), [](const Vector3d& p) {
      const double a = std::abs(p.z() - 7.3 - 0.11 * p.x()) - 0.04;
      const double b = std::abs(p.z() - 9.6) - 0.04;
      const double rim = std::hypot(p.x() - 9.5, p.y() - 9.5) - 7.4;
      return std::max(std::min(a, b), rim);
    });
  if (name == "saddles on the grid")
    return analytic::sampled(analytic::cube(13), [](const Vector3d& p) {
      return std::cos(0.5 * M_PI * p.x()) * std::cos(0.5 * M_PI * p.y()) +
             0.3 * std::cos(0.5 * M_PI * p.z());
    });
  // Values that are clamped but for voxels barely inside, as of a segmentation of noise.
  return [] {
    Volume<float> phi(analytic::cube(7), 2.0F);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i)
      if (randomUniform(3, i) < 0.35) phi.voxels[i] = randomUniform(4, i) < 0.7 ? -0.002F : -0.6F;
    return phi;
  }();
}

const char* const kFields[] = {"noise", "anisotropic noise", "thin sheets", "saddles on the grid",
                               "plateau"};

TriMesh twoCrossingCubes() {
  TriMesh mesh = shapes::cube();
  const TriMesh other = shapes::cube();
  for (const Vector3d& p : other.points) mesh.points.push_back(p + Vector3d(0.4, 0.3, 0.2));
  for (const auto& t : other.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  return mesh;
}

}  // namespace

class TestSoundSurface : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nothingThatCutsItselfIsHandedOut_data() {
    QTest::addColumn<QString>("field");
    QTest::addColumn<int>("method");
    for (const char* name : kFields)
      for (const SurfaceMethod method : {SurfaceMethod::AdvancingFront, SurfaceMethod::Remesh})
        QTest::addRow("%s, %d", name, static_cast<int>(method))
            << QString(name) << static_cast<int>(method);
  }
  void nothingThatCutsItselfIsHandedOut() {
    QFETCH(QString, field);
    QFETCH(int, method);
    const Volume<float> phi = fieldNamed(field);
    SurfaceParams params;
    params.method = static_cast<SurfaceMethod>(method);
    params.minComponentMm3 = 0.0;
    params.sizing.edgeMinMm = 0.3;
    const SplineField spline(phi, params.spline);
    const MadeSurface made = makeSurface(phi, spline, params);
    QVERIFY(!made.mesh.triangles.empty());
    const MeshFaults faults = findFaults(made.mesh, true);
    QVERIFY2(faults.none(), faults.text().c_str());
    std::size_t replaced = 0;
    for (const SurfaceComponent& part : made.origin.components) {
      QVERIFY(part.faults.empty());
      QVERIFY(part.method == params.method || !part.instead.empty());
      if (!part.instead.empty()) ++replaced;
    }
    QVERIFY(made.origin.warnings().size() >= std::min<std::size_t>(replaced, 20));
    // Smoothing ties nothing up again.
    for (const SmoothMethod how : {SmoothMethod::KeepWall, SmoothMethod::Taubin}) {
      SmoothParams smooth;
      smooth.method = how;
      smooth.iterations = 10;
      const MeshFaults after = findFaults(smoothSurface(made.mesh, smooth, &spline), true);
      QVERIFY2(after.none(), after.text().c_str());
    }
  }

  void whatIsMadeOtherwiseIsSaid() {
    SurfaceOrigin origin;
    SurfaceComponent part;
    part.verified = true;
    part.triangles = 12;
    part.method = SurfaceMethod::MarchingCubes;
    part.instead = "the front's cuts itself in 2 places, such as near L 1.0 P 2.0 S 3.0 mm";
    origin.components = {part};
    QCOMPARE(origin.warnings().size(), std::size_t{1});
    QVERIFY(QString::fromStdString(origin.warnings()[0]).contains("made by marching cubes"));
    QVERIFY(QString::fromStdString(origin.warnings()[0]).contains("L 1.0 P 2.0 S 3.0"));
  }

  void isTheSameForAnyNumberOfThreads() {
    const Volume<float> phi = fieldNamed("plateau");
    SurfaceParams params;
    params.sizing.edgeMinMm = 0.3;
    const SplineField spline(phi, params.spline);
    const auto [one, three] =
        onOneAndSeveralThreads([&] { return makeSurface(phi, spline, params); }, 3);
    setThreads(0);
    QVERIFY(one.mesh.points == three.mesh.points);
    QVERIFY(one.mesh.triangles == three.mesh.triangles);
  }

  void faultsAreFoundAndCounted() {
    QVERIFY(findFaults(shapes::cube(), true).none());
    const MeshFaults crossing = findFaults(twoCrossingCubes(), true);
    QVERIFY(!crossing.meeting.empty() && crossing.broken.empty());
    QCOMPARE(crossing.places, std::size_t{1});
    QVERIFY(crossing.placeLps.minCoeff() > 0.0 && crossing.placeLps.maxCoeff() < 1.4);
    QVERIFY(QString::fromStdString(crossing.text()).startsWith("cuts itself in 1 place, near L "));
    TriMesh open = shapes::cube();
    open.triangles.pop_back();
    QVERIFY(findFaults(open, false).none());
    QVERIFY(!findFaults(open, true).none());
    TriMesh twice = shapes::cube();
    twice.triangles.push_back({0, 1, 7});
    QVERIFY(!findFaults(twice, false).broken.empty());
    QVERIFY(surfaceFault(shapes::cube(), true).empty());
    const MeshQuality known = measureQuality(twoCrossingCubes());
    QVERIFY(!surfaceFault(twoCrossingCubes(), true, &known).empty());
  }

  void whatNoFreezingHelpsComesBack() {
    TriMesh apart = twoCrossingCubes();
    for (std::size_t v = 8; v < 16; ++v) apart.points[v].x() += 3.0;
    std::size_t left = 0;
    // A filter that heeds nothing: the second cube always ends in the first.
    const TriMesh smoothed = smoothSoundly(apart,
                                           [&](const std::vector<char>&) {
                                             TriMesh moved = apart;
                                             for (std::size_t v = 8; v < 16; ++v)
                                               moved.points[v].x() -= 3.0;
                                             return moved;
                                           },
                                           left, {});
    QVERIFY(smoothed.points == apart.points);
    QCOMPARE(left, std::size_t{2});
  }

  // Coarse triangles on a ball: a bound of the second derivatives times their size is too loose,
  // boxes that are halved show that nothing turns away. A triangle turned over is found.
  void turnedFacesAreToldFromLooseBounds() {
    const Vector3d c{15.4, 15.2, 15.7};
    const Volume<float> phi = analytic::sampled(
        analytic::cube(32), [&](const Vector3d& p) { return analytic::ball(p, c, 9.3); });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    PatchMesh mesh;
    mesh.mesh = shapes::icosahedron();
    for (Vector3d& p : mesh.mesh.points) p = c + 9.3 * p.normalized();
    if (enclosedVolumeMm3(mesh.mesh) < 0.0)
      for (auto& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
    mesh.patch.assign(mesh.mesh.triangles.size(), 0);
    mesh.place.assign(mesh.mesh.points.size(), Place::onWall());
    mesh.origin.assign(mesh.patch.size(), FaceOrigin::Front);
    QVERIFY(turnedFaces(mesh, field, {}).empty());
    std::swap(mesh.mesh.triangles[3][1], mesh.mesh.triangles[3][2]);
    const auto turned = turnedFaces(mesh, field, {});
    QCOMPARE(turned.size(), std::size_t{1});
    QCOMPARE(turned[0].triangle, 3U);
    QVERIFY(turned[0].measured && turned[0].degrees > 120.0);
  }

  // A field and a mesh turned about a point have the same faces turned away as before.
  void turnedFacesHaveNoPreferredSide() {
    Volume<float> phi = shapes::noise({9, 9, 9}, 17);
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      const Index3 p = phi.geometry.indexOf(i);
      phi.voxels[i] *= 0.3F;
      phi.voxels[i] += static_cast<float>(
          analytic::ball(Vector3d(p[0], p[1], p[2]), analytic::centreOf(phi.geometry), 2.4));
    }
    Volume<float> turned = phi;
    std::reverse(turned.voxels.begin(), turned.voxels.end());
    const Vector3d centre = analytic::centreOf(phi.geometry);
    TriMesh mesh = shapes::icosphere(3);
    for (Vector3d& p : mesh.points) p = centre + 2.7 * p;
    TriMesh other = mesh;
    for (Vector3d& p : other.points) p = 2.0 * centre - p;
    for (auto& t : other.triangles) std::swap(t[1], t[2]);
    const auto one = turnedFaces(patchOf(mesh), {phi, SplineKind::InterpolatingBspline}, {});
    const auto two = turnedFaces(patchOf(other), {turned, SplineKind::InterpolatingBspline}, {});
    QVERIFY(one.size() > 50);
    QCOMPARE(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) QCOMPARE(one[i].triangle, two[i].triangle);
  }

  // In noise the reference's own triangles are left in the end. They meet nothing, as each stays in
  // its cell, with corners on the grid's edges that keep away from the grid's vertices.
  void theReferenceIsLeftInTheEnd() {
    const SurfaceBed bed(fieldNamed("noise"), SurfaceBorder::Cap, 1.2);
    const SoundSurface sound = bed.sound(bed.grown());
    QVERIFY(findFaults(sound.mesh.mesh, true).none());
    std::size_t contours = 0;
    double least = 0.5;
    for (std::size_t t = 0; t < sound.mesh.group.size(); ++t) {
      const SurfaceGroup& group = sound.groups[sound.mesh.group[t]];
      QVERIFY(group.faults.empty());
      if (group.method != SurfaceMethod::MarchingCubes || sound.mesh.patch[t] != 0) continue;
      QVERIFY(!group.instead.empty());
      QVERIFY(sound.mesh.origin[t] == FaceOrigin::Contour);
      ++contours;
      for (const std::uint32_t v : sound.mesh.mesh.triangles[t]) {
        const Vector3d index = bed.field.geometry().toIndex(sound.mesh.mesh.points[v]);
        int between = 0;
        for (int a = 0; a < 3; ++a) {
          const double off = std::fabs(index[a] - std::round(index[a]));
          if (off < 1e-9) continue;
          ++between;
          least = std::min(least, off);
        }
        QCOMPARE(between, 1);
      }
    }
    QVERIFY(contours > 100);
    QVERIFY2(least > 0.1 && least < 0.15, qPrintable(QString::number(least)));
  }

  // A part too thin for the edges that are asked for is made of shorter ones.
  void thinPartsGetShorterEdges() {
    const Volume<float> phi = analytic::sampled(analytic::cube(28), [](const Vector3d& p) {
      return std::min(analytic::ball(p, {8.0, 13.5, 13.5}, 5.0),
                      analytic::tube(p, {21.3, 13.4, 13.6}, Vector3d::UnitY(), 0.9));
    });
    SurfaceParams params;
    params.minComponentMm3 = 0.0;
    params.sizing.edgeMinMm = params.sizing.edgeMaxMm = 2.5;
    const SplineField spline(phi, params.spline);
    const MadeSurface made = makeSurface(phi, spline, params);
    QVERIFY(findFaults(made.mesh, true).none());
    QCOMPARE(measureQuality(made.mesh).components, 2);
  }

  void cornersOfTheOutlineAreMeasuredApart() {
    TriMesh cube = shapes::cube();
    QVERIFY(!measureQuality(cube).corners);
    for (std::uint16_t t = 0; t < 12; ++t) cube.patch.push_back(static_cast<std::uint16_t>(t / 2));
    const MeshQuality q = measureQuality(cube);
    QVERIFY(q.corners.has_value());
    QCOMPARE(q.corners->triangles, std::size_t{12});
    QVERIFY(std::abs(q.corners->minAngle - 45.0) < 1e-3);
  }
};

QTEST_GUILESS_MAIN(TestSoundSurface)
#include "tst_sound_surface.moc"
