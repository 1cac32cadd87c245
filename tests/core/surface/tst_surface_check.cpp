// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/mesh/mesh_faults.h"
#include "core/mesh/self_intersection.h"
#include "core/quality/mesh_quality.h"
#include "tests/core/surface/surface_bed.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

const Vector3d kCentre{15.4, 15.2, 15.7};
constexpr double kRadius = 9.3;

const SurfaceBed& oneBall() {
  static const SurfaceBed bed(ballsField({{kCentre, kRadius}}, analytic::cube(32)));
  return bed;
}

// A large ball and a small one.
const Vector3d kLarge{12.3, 15.2, 14.7}, kSmall{32.1, 14.8, 15.3};
constexpr double kLargeRadius = 8.4, kSmallRadius = 4.7;

const SurfaceBed& twoBalls() {
  static const SurfaceBed bed([] {
    Geometry g;
    g.size = {44, 30, 30};
    return ballsField({{kLarge, kLargeRadius}, {kSmall, kSmallRadius}}, g);
  }());
  return bed;
}

PatchMesh goodMesh() { return ballPatch(kCentre, kRadius, 3); }

// The vertex at the tip of a triangle leaves its fan: along the ball, into the fans beside it.
PatchMesh withAFold(const PatchMesh& good, std::uint32_t vertex, double edges) {
  PatchMesh mesh = good;
  Vector3d& p = mesh.mesh.points[vertex];
  double edge = 0.0;
  std::uint32_t towards = vertex;
  for (const auto& t : mesh.mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      if (t[k] == vertex) {
        towards = t[(k + 1) % 3];
        edge = (mesh.mesh.points[towards] - p).norm();
      }
  const Vector3d way = (mesh.mesh.points[towards] - p).normalized();
  p += edges * edge * way;
  p = kCentre + kRadius * (p - kCentre).normalized();
  return mesh;
}

// The only component's reason, and that it has one exactly when it is not verified.
QString doubtOf(const SurfaceCheck& check) {
  if (check.components.size() != 1) return "not one component";
  const SurfaceComponent& c = check.components[0];
  if (c.verified != c.why.empty()) return "verified with a doubt, or doubted without a reason";
  return QString::fromStdString(c.why);
}

// With the points in the order in which the triangles use them, as selectTriangles() leaves them.
TriMesh renumbered(const PatchMesh& mesh) {
  return selectTriangles(mesh, [](std::uint32_t) { return true; }).mesh;
}

std::size_t sameTriangles(const TriMesh& a, const TriMesh& b) {
  const auto keys = [](const TriMesh& mesh) {
    std::vector<std::array<double, 3>> middles;
    for (const auto& t : mesh.triangles) {
      const Vector3d m = mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]];
      middles.push_back({m.x(), m.y(), m.z()});
    }
    std::sort(middles.begin(), middles.end());
    return middles;
  };
  const auto first = keys(a), second = keys(b);
  std::vector<std::array<double, 3>> both;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                        std::back_inserter(both));
  return both.size();
}

}  // namespace

class TestSurfaceCheck : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aGoodMeshIsVerified() {
    for (const PatchMesh& mesh : {goodMesh(), oneBall().grown()}) {
      const SurfaceCheck check = oneBall().checked(mesh);
      QCOMPARE(doubtOf(check), QString());
      const SurfaceComponent& c = check.components[0];
      QVERIFY(c.verified);
      QCOMPARE(c.euler, 2);
      QCOMPARE(c.genus(), 0);
      QCOMPARE(c.boundaryLoops, 0);
      QCOMPARE(c.triangles, mesh.mesh.triangles.size());
      QCOMPARE(c.fromFrontPercent, 100.0);
      QVERIFY(std::fabs(c.volumeMm3 / enclosedVolumeMm3(mesh.mesh) - 1.0) < 1e-9);
      QVERIFY(std::fabs(c.areaMm2 / (4.0 * M_PI * kRadius * kRadius) - 1.0) < 0.05);
      QCOMPARE(check.reached.size(), std::size_t{1});
      QCOMPARE(check.reached[0].part, 0U);
      QCOMPARE(check.reached[0].missed, std::size_t{0});
    }
  }

  void aTurnedFaceIsDoubted() {
    PatchMesh mesh = goodMesh();
    std::swap(mesh.mesh.triangles[40][0], mesh.mesh.triangles[40][1]);
    QVERIFY(!doubtOf(oneBall().checked(mesh)).isEmpty());
  }

  // All faces turned over: a manifold, which faces inward.
  void aMeshInsideOutIsDoubted() {
    PatchMesh mesh = goodMesh();
    for (auto& t : mesh.mesh.triangles) std::swap(t[1], t[2]);
    const QString doubt = doubtOf(oneBall().checked(mesh));
    QVERIFY2(doubt.contains("gradient turns away"), qPrintable(doubt));
    QVERIFY(doubt.contains(QString("%1 triangles").arg(mesh.mesh.triangles.size())));
  }

  void aFoldIsDoubted() {
    for (const double edges : {1.5, 2.2}) {
      const PatchMesh mesh = withAFold(goodMesh(), 100, edges);
      const QString doubt = doubtOf(oneBall().checked(mesh));
      QVERIFY2(doubt.contains("gradient turns away from their normal"), qPrintable(doubt));
    }
  }

  void aHoleIsDoubted() {
    const PatchMesh mesh = selectTriangles(goodMesh(), [](std::uint32_t t) { return t != 40; });
    const SurfaceCheck check = oneBall().checked(mesh);
    QCOMPARE(doubtOf(check), QString("it is not closed"));
    QCOMPARE(check.components[0].boundaryLoops, 1);
    QCOMPARE(check.components[0].euler, 1);
    // Nor is it a rim of an open surface: it lies in no plane.
    QVERIFY(!checkManifold(mesh, SurfaceBorder::Open).components[0].why.empty());
  }

  void aDoubledFaceIsDoubted() {
    PatchMesh mesh = goodMesh();
    addTriangle(mesh, mesh.mesh.triangles[40]);
    QVERIFY(!doubtOf(oneBall().checked(mesh)).isEmpty());
    PatchMesh fin = goodMesh();
    const auto t = fin.mesh.triangles[40];
    addTriangle(fin, {t[0], t[1], fin.mesh.triangles[900][0]});
    QVERIFY(!doubtOf(oneBall().checked(fin)).isEmpty());
  }

  void fansThatMeetAreDoubted() {
    PatchMesh mesh = goodMesh();
    const std::uint32_t kept = mesh.mesh.triangles[40][0], other = mesh.mesh.triangles[900][0];
    for (auto& t : mesh.mesh.triangles)
      for (auto& v : t)
        if (v == other) v = kept;
    QVERIFY(doubtOf(oneBall().checked(mesh)).contains("more than one fan"));
  }

  // Two parts that touch in a point have a rim each, whatever the order of their edges is.
  void rimsThatTouchAreCountedInEachPart() {
    for (const bool inTurn : {false, true}) {
      TriMesh mesh;
      mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
      mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
      if (inTurn) mesh.triangles = {{0, 1, 3}, {0, 2, 4}};
      const SurfaceCheck check = checkManifold(patchOf(mesh), SurfaceBorder::Cap);
      QCOMPARE(check.components.size(), std::size_t{2});
      for (const SurfaceComponent& c : check.components) {
        QCOMPARE(c.boundaryLoops, 1);
        QCOMPARE(c.triangles, std::size_t{1});
      }
    }
  }

  void aMissingPartIsSaid() {
    const SurfaceBed& bed = twoBalls();
    const PatchMesh one = ballPatch(kLarge, kLargeRadius, 3);
    const SurfaceCheck check = bed.checked(one);
    QCOMPARE(doubtOf(check), QString());
    QCOMPARE(check.reached.size(), std::size_t{2});
    std::size_t reached = 0;
    for (const SurfaceCheck::Reached& r : check.reached) {
      if (r.part == SurfaceCheck::none) {
        QCOMPARE(r.missed, r.landmarks);
        QVERIFY((bed.landmarks.points[r.component].point - kSmall).norm() < 1.1 * kSmallRadius);
      } else {
        ++reached;
        QCOMPARE(r.missed, std::size_t{0});
        QCOMPARE(r.parts.size(), std::size_t{1});
      }
    }
    QCOMPARE(reached, std::size_t{1});
  }

  // Places of the same component that no vertex is near.
  void missedPlacesAreDoubted() {
    const PatchMesh mesh = goodMesh();
    SurfaceBed bed(ballsField({{kCentre, kRadius}}, analytic::cube(32)));
    for (int i = 0; i < 5; ++i) {
      FrontPoint far = bed.landmarks.points[0];
      far.point += Vector3d(100.0, 0.0, i);
      bed.landmarks.points.push_back(far);
      bed.landmarks.valid.push_back(1);
      bed.landmarks.component.push_back(bed.landmarks.component[0]);
    }
    const QString doubt = doubtOf(bed.checked(mesh));
    QVERIFY2(doubt.startsWith("5 places of the zero set"), qPrintable(doubt));
  }

  // Rims in the planes of the volume's border are what an open surface ends in.
  void rimsInPlanesAreOfOpenSurfacesAlone() {
    const Volume<float> phi = analytic::sampled(analytic::cube(20), [](const Vector3d& p) {
      return analytic::tube(p, {9.5, 9.6, 9.5}, Vector3d::UnitZ(), 5.3);
    });
    const SurfaceBed open(phi, SurfaceBorder::Open);
    const PatchMesh tube = open.grown();
    const SurfaceCheck check = open.checked(tube);
    QCOMPARE(doubtOf(check), QString());
    QCOMPARE(check.components[0].boundaryLoops, 2);
    QCOMPARE(check.components[0].genus(), 0);
    QVERIFY(QString::fromStdString(checkManifold(tube, SurfaceBorder::Cap).components[0].why)
                .contains("not closed"));
  }

  void brokenPartsAreDropped() {
    PatchMesh mesh = ballPatch(kLarge, kLargeRadius, 2);
    const PatchMesh small = ballPatch(kSmall, kSmallRadius, 2);
    appendPatch(mesh, small);
    const PatchMesh whole = mesh;
    dropBroken(mesh, SurfaceBorder::Cap);
    QVERIFY(mesh.mesh.triangles == whole.mesh.triangles);
    // A hole in the first.
    mesh = selectTriangles(whole, [](std::uint32_t t) { return t != 7; });
    dropBroken(mesh, SurfaceBorder::Cap);
    QVERIFY(mesh.mesh.triangles == renumbered(small).triangles);
    QVERIFY(mesh.mesh.points == renumbered(small).points);
    QCOMPARE(mesh.patch.size(), small.patch.size());
    // A turned face in the other.
    mesh = whole;
    std::swap(mesh.mesh.triangles.back()[0], mesh.mesh.triangles.back()[1]);
    dropBroken(mesh, SurfaceBorder::Cap);
    QVERIFY(mesh.mesh.triangles == renumbered(ballPatch(kLarge, kLargeRadius, 2)).triangles);
  }

  void aSoundMeshStays() {
    const PatchMesh mesh = oneBall().grown();
    const SoundSurface sound = oneBall().sound(mesh);
    QVERIFY(!sound.changed);
    QVERIFY(sound.mesh.mesh.triangles == mesh.mesh.triangles);
    QCOMPARE(sound.groups.size(), std::size_t{1});
    QVERIFY(sound.groups[0].instead.empty() && sound.groups[0].faults.empty());
    QVERIFY(sound.groups[0].method == SurfaceMethod::AdvancingFront);
    QVERIFY(sound.dropped.empty());
  }

  // A front that meets itself in one place is filled anew there, and stays the front's elsewhere.
  void whatMeetsItselfIsFilledAnew() {
    const SurfaceBed bed(ballsField({{kCentre, kRadius}}, analytic::cube(32)), SurfaceBorder::Cap,
                         0.15);
    const PatchMesh good = bed.grown();
    const PatchMesh folded = withAFold(good, 200, 2.0);
    QVERIFY(!selfIntersections(folded.mesh).empty());
    const SoundSurface sound = bed.sound(folded);
    QVERIFY(sound.changed);
    QCOMPARE(sound.groups.size(), std::size_t{1});
    QVERIFY2(sound.groups[0].instead.empty(), sound.groups[0].instead.c_str());
    QVERIFY(sound.groups[0].method == SurfaceMethod::AdvancingFront);
    QVERIFY(findFaults(sound.mesh.mesh, true).none());
    const MeshQuality q = measureQuality(sound.mesh.mesh);
    QVERIFY(q.closed);
    QCOMPARE(q.euler, 2);
    QVERIFY(q.minAngleMin > 25.0);
    QCOMPARE(sound.mesh.group.size(), sound.mesh.mesh.triangles.size());
    const SurfaceCheck check = bed.checked(sound.mesh);
    QCOMPARE(doubtOf(check), QString());
    QVERIFY(check.components[0].fromFrontPercent > 80.0);
    QVERIFY(check.components[0].fromFrontPercent < 100.0);
  }

  // Of two parts the front made one: the other is remeshed, the first stays as it is.
  void whatTheFrontDidNotReachIsAdded() {
    const SurfaceBed& bed = twoBalls();
    const PatchMesh one = ballPatch(kLarge, kLargeRadius, 3);
    const SoundSurface sound = bed.sound(one);
    QVERIFY(sound.changed);
    QCOMPARE(sound.groups.size(), std::size_t{2});
    std::size_t added = 0;
    for (const SurfaceGroup& g : sound.groups) {
      QVERIFY(g.faults.empty());
      if (g.method == SurfaceMethod::AdvancingFront) {
        QVERIFY(g.instead.empty());
        continue;
      }
      ++added;
      QVERIFY(g.method == SurfaceMethod::Remesh);
      QVERIFY(QString::fromStdString(g.instead).contains("did not reach"));
    }
    QCOMPARE(added, std::size_t{1});
    QVERIFY(sound.dropped.empty());
    const TriMesh& mesh = sound.mesh.mesh;
    QCOMPARE(sameTriangles(mesh, one.mesh), one.mesh.triangles.size());
    QVERIFY(findFaults(mesh, true).none());
    const MeshQuality q = measureQuality(mesh);
    QCOMPARE(q.components, 2);
    QCOMPARE(q.euler, 4);
    const double truth =
        4.0 / 3.0 * M_PI * (std::pow(kLargeRadius, 3.0) + std::pow(kSmallRadius, 3.0));
    QVERIFY(std::fabs(q.volumeMm3 / truth - 1.0) < 0.05);
    const SurfaceCheck check = bed.checked(sound.mesh);
    for (const SurfaceComponent& c : check.components) QVERIFY2(c.verified, c.why.c_str());
  }

  // Two parts that cross: neither is handed out as it was.
  void partsThatCrossAreMadeAnew() {
    const SurfaceBed& bed = twoBalls();
    PatchMesh mesh = ballPatch(kLarge, kLargeRadius, 3);
    // The small one where it should not be.
    PatchMesh astray = ballPatch(kSmall, kSmallRadius, 2);
    for (Vector3d& p : astray.mesh.points) p -= Vector3d(10.0, 0.0, 0.0);
    appendPatch(mesh, astray);
    QVERIFY(!findFaults(mesh.mesh, true).none());
    const SoundSurface sound = bed.sound(mesh);
    QVERIFY(sound.changed);
    QVERIFY(findFaults(sound.mesh.mesh, true).none());
    const MeshQuality q = measureQuality(sound.mesh.mesh);
    QVERIFY(q.closed);
    QCOMPARE(q.components, 2);
    const SurfaceCheck check = bed.checked(sound.mesh);
    for (const SurfaceComponent& c : check.components) QVERIFY2(c.verified, c.why.c_str());
  }

  // What the front misses of a part is a detail, or too much of it: then all of it is remeshed.
  void aPartThatIsMissedByMuchIsMadeAnew() {
    const auto made = [](double radius, double share, std::size_t least) {
      SurfaceBed bed(ballsField({{kCentre, radius}}, analytic::cube(32)));
      // Places of the same component that the mesh is not near, so many for each of it.
      const std::size_t all = bed.landmarks.points.size();
      const auto missed =
          std::max(static_cast<std::size_t>(share * static_cast<double>(all)), least);
      for (std::size_t i = 0; i < missed; ++i) {
        FrontPoint far = bed.landmarks.points[0];
        far.point += Vector3d(100.0, 0.0, 0.01 * static_cast<double>(i));
        bed.landmarks.points.push_back(far);
        bed.landmarks.valid.push_back(1);
        bed.landmarks.component.push_back(bed.landmarks.component[0]);
      }
      return bed.sound(ballPatch(kCentre, radius, 3));
    };
    const auto remeshed = [&](double radius, double share, std::size_t least) {
      const SoundSurface sound = made(radius, share, least);
      const SurfaceGroup& group = sound.groups.front();
      return sound.groups.size() == 1 && sound.changed && group.faults.empty() &&
             group.method == SurfaceMethod::Remesh && !group.instead.empty() &&
             findFaults(sound.mesh.mesh, true).none();
    };
    // A quarter of all is a third of the others.
    QVERIFY(!made(kRadius, 0.3, 0).changed);
    QVERIFY(remeshed(kRadius, 0.37, 0));
    // Of a small part that may be a few dozen.
    QVERIFY(!made(0.9, 0.0, 35).changed);
    QVERIFY(remeshed(0.9, 0.0, 50));
  }

  // A part that no component of the zero set belongs to goes, and that is said.
  void whatBelongsToNothingIsDropped() {
    const SurfaceBed& bed = oneBall();
    PatchMesh mesh = goodMesh();
    // It crosses the ball, far from any landmark with its normals, as it faces inward.
    PatchMesh speck = ballPatch(kCentre + Vector3d(kRadius, 0.0, 0.0), 1.0, 1);
    for (auto& t : speck.mesh.triangles) std::swap(t[1], t[2]);
    appendPatch(mesh, speck);
    const SoundSurface sound = bed.sound(mesh);
    QVERIFY(findFaults(sound.mesh.mesh, true).none());
    QCOMPARE(measureQuality(sound.mesh.mesh).components, 1);
  }
};

QTEST_GUILESS_MAIN(TestSurfaceCheck)
#include "tst_surface_check.moc"
