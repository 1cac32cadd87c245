// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/cuts/clip_reference.h"
#include "core/phantom/phantom.h"
#include "core/phantom/shape.h"
#include "core/quality/mesh_quality.h"
#include "core/smooth/smoothing.h"
#include "core/surface/zero_set_mesh.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/refusal.h"
#include "tests/core/surface/surface_bed.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

struct Cut {
  Volume<float> phi;
  SplineField field;
  CutAway away;

  Cut(Volume<float> volume, const std::vector<CutPlane>& cuts,
      const std::vector<std::string>& names = {})
      : phi(std::move(volume)),
        field(phi, SplineKind::InterpolatingBspline),
        away(checkedCutAway(field, phi, cuts, names)) {}

  [[nodiscard]] ZeroSetMesh mesh(SurfaceMethod method = SurfaceMethod::AdvancingFront,
                                 SurfaceBorder border = SurfaceBorder::Cap,
                                 double rho = 0.4) const {
    SizingParams sizing;
    sizing.rho = rho;
    sizing.edgeMinVoxels.reset();
    return meshZeroSet(field, sizing, method, border, {}, away);
  }
};

// Along z, of radius 6; the wall is rough, more so around than along.
Volume<float> roughTube(int length, double rough) {
  Geometry g;
  g.size = {24, 22, length};
  const Volume<float> noise = shapes::noise(g.size, 1);
  Volume<float> phi = shapes::sampled(
      g, [](const Vector3d& p) { return std::hypot(p.x() - 11.5, p.y() - 10.5) - 6.0; });
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
    const auto [x, y, z] = g.indexOf(i);
    float sum = 0.0F;
    for (int k = z - 1; k <= z + 1; ++k) sum += noise.at(x, y, std::clamp(k, 0, length - 1));
    phi.voxels[i] += static_cast<float>(rough / std::sqrt(3.0)) * sum;
  }
  return phi;
}

std::size_t unverifiedOf(const ZeroSetMesh& mesh) {
  return static_cast<std::size_t>(std::count_if(mesh.components.begin(), mesh.components.end(),
                                                [](const auto& c) { return !c.verified; }));
}

// The caps of the cuts are flat, where they should be, and hold the mesh together.
void checkPorts(const ZeroSetMesh& mesh, const CutAway& away, SurfaceBorder border,
                std::size_t unverified = 0) {
  checkMesh(mesh.mesh);
  QCOMPARE(mesh.mesh.patch.size(), mesh.mesh.triangles.size());
  const bool open = border == SurfaceBorder::Open;
  for (std::size_t n = 0; n < away.sections.size(); ++n) {
    const Port& port = mesh.ports[n];
    const Section& section = away.sections[n];
    QVERIFY2(
        std::abs(port.areaMm2 / section.areaMm2 - 1.0) < 0.06,
        qPrintable(QString("port %1: %2 of %3 mm2").arg(n).arg(port.areaMm2).arg(section.areaMm2)));
    QVERIFY((port.centreLps - section.centreLps).norm() < 0.05 * section.radiusMm);
    QVERIFY(port.normalLps.dot(section.plane.normalLps) > 1.0 - 1e-9);
    std::size_t count = 0;
    for (std::size_t t = 0; t < mesh.mesh.triangles.size(); ++t) {
      if (mesh.mesh.patch[t] != n + 1) continue;
      ++count;
      for (const std::uint32_t v : mesh.mesh.triangles[t])
        QVERIFY(std::abs(section.height(mesh.mesh.points[v])) < 1e-9);
    }
    QCOMPARE(count == 0, open);
  }
  if (!open) QVERIFY(portFaults(mesh.ports, mesh.mesh).empty());
  QCOMPARE(unverifiedOf(mesh), unverified);
  const MeshQuality q = measureQuality(mesh.mesh);
  QCOMPARE(q.nonManifoldEdges + q.nonManifoldVertices + q.selfIntersections, std::size_t{0});
  QCOMPARE(q.closed, !open);
  QVERIFY(q.oriented);
  QVERIFY2(q.minAngleMin >= 25.0, qPrintable(QString::number(q.minAngleMin)));
}

Volume<float> tubeAlong(const Geometry& g, const Vector3d& axis, double radius) {
  const Vector3d centre = analytic::centreOf(g);
  return shapes::sampled(
      g, [&](const Vector3d& p) { return analytic::tube(p, centre, axis, radius); });
}

double volumeOf(const ZeroSetMesh& mesh) { return enclosedVolumeMm3(mesh.mesh); }

}  // namespace

class TestCuts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aThinVesselBetweenVoxelsIsTakenToo() {
    Geometry g;
    g.size = {12, 12, 12};
    CutAway away;
    away.sections.resize(1);
    away.voxels = Volume<std::uint8_t>(g, CutAway::kOutside);
    away.voxels.at(5, 5, 5) = CutAway::kTaken;
    away.voxels.at(9, 5, 5) = CutAway::kLeft;
    QVERIFY(away.takenAt({5.4, 5.4, 5.4}));
    QVERIFY(away.takenAt({6.6, 5.4, 5.4}));
    QVERIFY(!away.takenAt({7.6, 5.4, 5.4}));
    QVERIFY(!away.takenAt({0.4, 0.4, 0.4}));
  }

  /// A bubble is a surface of its own that no section touches: it goes with the voxels around it.
  void bubblesGoWithTheVesselAroundThem() {
    const Geometry g = analytic::cube(40);
    const Vector3d centre = analytic::centreOf(g) + Vector3d(0.2, -0.3, 0.1);
    const Vector3d axis = Vector3d(0.1, 0.2, 1.0).normalized();
    const auto bubble = [&](const Vector3d& p, double along) {
      return -analytic::ball(p, centre + along * axis, 2.6);
    };
    const Cut cut(shapes::sampled(g,
                                  [&](const Vector3d& p) {
                                    return std::max({analytic::tube(p, centre, axis, 7.0),
                                                     bubble(p, -8.0), bubble(p, 8.0)});
                                  }),
                  {{centre + Vector3d(4.0, 0.0, 0.0), axis}});
    const SurfaceBed bed(cut.phi);
    PatchMesh reference = bed.reference;
    QCOMPARE(meshComponents(wallOf(reference)).count, std::size_t{3});
    clipReference(reference, cut.away, g.voxelMm());
    const TriMesh wall = wallOf(reference);
    QCOMPARE(meshComponents(wall).count, std::size_t{2});
    bool left = false;
    for (const auto& t : wall.triangles) {
      const Vector3d& p = wall.points[t[0]];
      QVERIFY((p - centre).dot(axis) < 4.0 * axis.x() + 0.1);
      left = left || (p - centre + 8.0 * axis).norm() < 3.0;
    }
    QVERIFY(left);
  }

  void everyMethodEndsATubeAtItsCuts_data() {
    QTest::addColumn<bool>("remeshed");
    QTest::addColumn<bool>("open");
    QTest::newRow("front") << false << false;
    QTest::newRow("front, open") << false << true;
    QTest::newRow("remesh") << true << false;
    QTest::newRow("remesh, open") << true << true;
  }
  void everyMethodEndsATubeAtItsCuts() {
    QFETCH(bool, remeshed);
    QFETCH(bool, open);
    const Geometry g = shapes::obliqueGeometry({40, 36, 30});
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d(0.3, -0.5, 0.8).normalized();
    const Vector3d tilted = (axis + 0.35 * axis.unitOrthogonal()).normalized();
    const Cut cut(tubeAlong(g, axis, 2.1),
                  {{centre + 4.0 * axis, tilted}, {centre - 3.5 * axis, -axis}},
                  {"outlet", "inlet"});
    const SurfaceBorder border = open ? SurfaceBorder::Open : SurfaceBorder::Cap;
    const ZeroSetMesh mesh =
        cut.mesh(remeshed ? SurfaceMethod::Remesh : SurfaceMethod::AdvancingFront, border);
    checkPorts(mesh, cut.away, border);
    QCOMPARE(mesh.components.size(), std::size_t{1});
    QCOMPARE(mesh.ports.size(), std::size_t{2});
    QCOMPARE(mesh.ports[0].name, std::string("outlet"));
    QCOMPARE(mesh.ports[1].name, std::string("inlet"));
    QVERIFY(cut.away.taken[0] > 100 && cut.away.taken[1] > 100);
    if (open) return;
    // A right cylinder and a wedge of it that averages out.
    const double volume = shapes::pi * 2.1 * 2.1 * 7.5;
    QVERIFY(isNear(volumeOf(mesh) / volume, 1.0, 0.05));
  }

  // Whatever smooths: caps stay flat where they are, and keep-wall gives each its section's area.
  void smoothingKeepsThePorts_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<bool>("open");
    for (const bool open : {false, true}) {
      const char* name = open ? "%s, open" : "%s";
      QTest::addRow(name, "keep-wall") << static_cast<int>(SmoothMethod::KeepWall) << open;
      QTest::addRow(name, "without phi") << -1 << open;
      QTest::addRow(name, "taubin") << static_cast<int>(SmoothMethod::Taubin) << open;
    }
  }
  void smoothingKeepsThePorts() {
    QFETCH(int, method);
    QFETCH(bool, open);
    const Geometry g = shapes::obliqueGeometry({40, 36, 30});
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d(0.3, -0.5, 0.8).normalized();
    const Vector3d tilted = (axis + 0.35 * axis.unitOrthogonal()).normalized();
    const Cut cut(tubeAlong(g, axis, 2.1),
                  {{centre + 4.0 * axis, tilted}, {centre - 3.5 * axis, -axis}});
    const ZeroSetMesh mesh =
        cut.mesh(SurfaceMethod::AdvancingFront, open ? SurfaceBorder::Open : SurfaceBorder::Cap);
    SmoothParams params;
    params.method = method < 0 ? SmoothMethod::KeepWall : static_cast<SmoothMethod>(method);
    const TriMesh smooth =
        smoothSurface(mesh.mesh, params, method < 0 ? nullptr : &cut.field, {}, mesh.ports);
    QCOMPARE(smooth.patch, mesh.mesh.patch);
    std::vector<Port> after = measurePatches(smooth, 2);
    for (std::size_t n = 0; n < 2; ++n) {
      const Section& section = cut.away.sections[n];
      std::size_t inPlane = 0;
      for (std::size_t v = 0; v < smooth.points.size(); ++v) {
        if (std::abs(section.height(mesh.mesh.points[v])) > 1e-9) continue;
        ++inPlane;
        QVERIFY(std::abs(section.height(smooth.points[v])) < 1e-6);
      }
      QVERIFY(inPlane >= 8);
      if (open) continue;
      const double area = after[n].areaMm2 / section.areaMm2;
      const double most = method == static_cast<int>(SmoothMethod::KeepWall) ? 5e-3 : 0.15;
      QVERIFY(isNear(area, 1.0, most));
      QVERIFY((after[n].centreLps - section.centreLps).norm() < 0.05);
    }
    // Taubin's filter may change the radius of a rim of few edges by more than is taken for a port.
    if (!open && params.method != SmoothMethod::Taubin)
      QVERIFY(portFaults(mesh.ports, smooth).empty());
    const MeshQuality q = measureQuality(smooth);
    QCOMPARE(q.nonManifoldEdges + q.selfIntersections, std::size_t{0});
    QCOMPARE(q.closed, !open);
  }

  // What is cut away is out of phi, and the planes end what is left.
  void phiEndsAtTheCuts() {
    const Geometry g = analytic::cube(48);
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d(0.2, 0.3, 0.93).normalized();
    const Cut cut(tubeAlong(g, axis, 4.3), {{centre + 10.0 * axis, axis}});
    const Volume<float> left = phiWithout(cut.phi, cut.away);
    for (std::size_t i = 0; i < left.voxels.size(); ++i) {
      const Index3 p = g.indexOf(i);
      const Vector3d at = voxelCentre(g, p);
      const double height = cut.away.sections[0].height(at);
      const bool inside = cut.phi.voxels[i] < 0.0F && height <= 0.0;
      QCOMPARE(left.voxels[i] < 0.0F, inside);
      // Well inside, the plane is where phi says.
      if (cut.phi.voxels[i] > -3.0F || std::abs(height) > 2.5) continue;
      QVERIFY(std::abs(static_cast<double>(left.voxels[i]) - height) < 0.05);
    }
  }

  // Just beyond a cut the nearest voxels are still those that are left. Within two voxels' height a
  // point counts as cut off all the same, where it belongs to the cut vessel and not to one beside.
  void wallsJustBeyondACutAreCutOff() {
    const Vector3d one{9.3, 15.6, 0.0}, other{23.4, 15.4, 0.0};
    const Cut cut(shapes::sampled(analytic::cube(32),
                                  [&](const Vector3d& p) {
                                    return std::min(
                                        analytic::tube(p, one, Vector3d::UnitZ(), 4.0),
                                        analytic::tube(p, other, Vector3d::UnitZ(), 4.0));
                                  }),
                  {{one + Vector3d(0.0, 0.0, 15.05), Vector3d::UnitZ()}});
    for (int turn = 0; turn < 12; ++turn) {
      const double angle = turn * shapes::pi / 6.0;
      const Vector3d wall(4.0 * std::cos(angle), 4.0 * std::sin(angle), 0.0);
      for (const auto& [z, taken] : {std::pair{14.9, false}, std::pair{15.3, true},
                                     std::pair{16.9, true}, std::pair{25.0, true}}) {
        QCOMPARE(cut.away.beyond(one + wall + Vector3d(0.0, 0.0, z)), taken);
        QVERIFY(!cut.away.beyond(other + wall + Vector3d(0.0, 0.0, z)));
      }
    }
  }

  void aTipOfACapsuleIsCutOff() {
    const Geometry g = analytic::cube(36);
    const Vector3d from{10.2, 11.1, 9.4}, to{25.3, 24.2, 26.1};
    const Vector3d axis = (to - from).normalized();
    const Cut cut(shapes::sampled(g,
                                  [&](const Vector3d& p) {
                                    const double t =
                                        std::clamp((p - from).dot(axis), 0.0, (to - from).norm());
                                    return (p - from - t * axis).norm() - 3.2;
                                  }),
                  {{to, axis}, {from + 1.0 * axis, -axis}});
    const ZeroSetMesh mesh = cut.mesh();
    checkPorts(mesh, cut.away, SurfaceBorder::Cap);
    QCOMPARE(mesh.components.size(), std::size_t{1});
    const double volume = shapes::pi * 3.2 * 3.2 * ((to - from).norm() - 1.0);
    QVERIFY(std::abs(volumeOf(mesh) / volume - 1.0) < 0.05);
  }

  // Two cuts take a piece out of a ring; one alone ends nothing.
  void aRingNeedsTwoCuts() {
    const Geometry g = analytic::cube(40);
    const Vector3d centre{19.4, 19.7, 19.2};
    const auto ring = [&] {
      return shapes::sampled(
          g, [&](const Vector3d& p) { return analytic::torus(p, centre, 11.0, 3.6); });
    };
    const CutPlane east{centre + Vector3d(11.0, 0.0, 0.0), {0.0, 1.0, 0.0}};
    const CutPlane north{centre + Vector3d(0.0, 11.0, 0.0), {1.0, 0.0, 0.0}};
    const Cut cut(ring(), {east, north}, {"a", "b"});
    const ZeroSetMesh mesh = cut.mesh();
    checkPorts(mesh, cut.away, SurfaceBorder::Cap);
    QCOMPARE(mesh.components.size(), std::size_t{1});
    QCOMPARE(mesh.components[0].euler, 2);
    const double volume = 0.75 * 2.0 * shapes::pi * shapes::pi * 11.0 * 3.6 * 3.6;
    QVERIFY(std::abs(volumeOf(mesh) / volume - 1.0) < 0.04);
    QVERIFY_THROWS_EXCEPTION(InputError, Cut(ring(), {east}));
  }

  // Neither the voxels nor the mesh of the vessel beside are touched.
  void aKissingVesselStaysWhole() {
    PhantomParams params;
    params.kind = PhantomKind::Kissing;
    params.size = {48, 48, 48};
    params.radius = 3.0;
    const Shape shape = analyticShape(params);
    const Geometry g = phantomGeometry(params);
    const auto phi = shapes::sampled(g, [&](const Vector3d& p) { return shape.signedDistance(p); });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const ZeroSetMesh whole = Cut(phi, {}).mesh();
    QCOMPARE(whole.components.size(), std::size_t{2});
    QCOMPARE(whole.ports.size(), std::size_t{4});
    // The nearest point of one vessel to the other.
    Vector3d at = Vector3d::Zero();
    double deepest = 0.0;
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      const Index3 p = g.indexOf(i);
      const Vector3d q{1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
      if ((q - Vector3d(24.0, 24.0, 24.0)).norm() > 5.0 || phi.voxels[i] >= deepest) continue;
      deepest = phi.voxels[i];
      at = g.toPhysical(q);
    }
    for (const double sign : {1.0, -1.0}) {
      const Cut cut(phi, {{at, sign * Vector3d::UnitZ()}}, {"here"});
      const ZeroSetMesh mesh = cut.mesh();
      checkPorts(mesh, cut.away, SurfaceBorder::Cap, unverifiedOf(whole));
      QCOMPARE(mesh.components.size(), std::size_t{2});
      // The cut takes one of four openings and makes one.
      QCOMPARE(mesh.ports.size(), std::size_t{4});
      double untouched = 0.0, before = 0.0;
      for (const SurfaceComponent& c : mesh.components)
        untouched = std::max(untouched, c.volumeMm3);
      for (const SurfaceComponent& c : whole.components) before = std::max(before, c.volumeMm3);
      QVERIFY(std::abs(untouched / before - 1.0) < 2e-3);
    }
  }

  // Two vessels along x (Cassini ovals across it) that a neck of 0.16 voxels joins: a section, but
  // no mesh, has it.
  void aNeckThinnerThanAVoxelIsNoVessel() {
    Geometry g;
    g.size = {24, 34, 24};
    const Vector3d neck(12.0, 16.5, 11.5);
    constexpr double c = 6.0, k = 0.24;
    const Volume<float> phi = shapes::sampled(g, [&](const Vector3d& p) {
      const double y = p.y() - neck.y(), z = p.z() - neck.z(), square = y * y + z * z;
      return (square * square - 2.0 * c * c * (y * y - z * z) - k) / (4.0 * c * c * c);
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const Section section = sectionOf(field, {neck, Vector3d::UnitX()});
    QCOMPARE(section.loops.size(), std::size_t{1});
    QVERIFY(section.radiusMm > 8.0);
    const std::string text = messageOf([&] {
      checkedCutAway(field, phi, {{neck, Vector3d::UnitX()}}, {"pinched"});
    });
    QVERIFY2(text.find("'pinched' lies where") != std::string::npos &&
                 text.find("all but touches another") != std::string::npos,
             text.c_str());
  }

  void theResultDoesNotDependOnTheNumberOfThreads() {
    const Geometry g = shapes::obliqueGeometry({40, 36, 30});
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d(0.3, -0.5, 0.8).normalized();
    const auto made = [&](int threads) {
      setThreads(threads);
      const Cut cut(tubeAlong(g, axis, 2.1), {{centre + 4.0 * axis, axis}});
      return cut.mesh().mesh;
    };
    const TriMesh one = made(1), four = made(4);
    setThreads(0);
    QVERIFY(one.points == four.points && one.triangles == four.triangles &&
            one.patch == four.patch);
  }

  void whatCannotBeCutIsNamed() {
    const Geometry g = analytic::cube(40);
    const Vector3d centre = analytic::centreOf(g), axis = Vector3d::UnitZ();
    const auto refused = [&](const std::vector<CutPlane>& cuts, const char* why) {
      try {
        const Cut cut(tubeAlong(g, axis, 5.0), cuts, {"first", "second"});
      } catch (const InputError& error) {
        const std::string text = error.what();
        if (text.find(why) != std::string::npos) return true;
        qWarning("%s", text.c_str());
      }
      return false;
    };
    QVERIFY(refused({{centre + 12.0 * Vector3d::UnitX(), axis}}, "'first'"));
    QVERIFY(refused({{centre, axis}, {centre, Vector3d(0.5, 0.0, 1.0)}}, "touch"));
    QVERIFY(refused({{centre, axis}, {centre + Vector3d(0, 0, 1), axis}}, "touch"));
    QVERIFY(refused({{centre, axis}, {centre + 8.0 * axis, axis}}, "'second' lies in what"));
    QVERIFY(refused({{centre, Vector3d::UnitX()}}, "reaches the border"));
  }

  /// A straight tube whose wall is rough, cut at every voxel and between all of them: the voxels on
  /// both sides are joined nowhere but through the section.
  void aRoughTubeIsCutAnywhere() {
    const Volume<float> phi = roughTube(64, 0.15);
    for (const SplineKind kind : {SplineKind::InterpolatingBspline, SplineKind::Bspline}) {
      const SplineField field(phi, kind);
      for (double z = 3.0; z < 60.0; z += 0.5) {
        const CutAway away =
            checkedCutAway(field, phi, {{{11.5, 10.5, z}, {0.0, 0.0, 1.0}}}, {"out"});
        // All of the tube beyond, but for specks beside it, and nothing before.
        std::size_t beyond = 0, taken = 0;
        for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
          const bool is = away.voxels.voxels[i] == CutAway::kTaken;
          const bool high = phi.geometry.indexOf(i)[2] > z;
          QVERIFY(!is || high);
          taken += is ? 1 : 0;
          beyond += high && phi.voxels[i] < 0.0F ? 1 : 0;
        }
        QVERIFY2(static_cast<double>(taken) > 0.98 * static_cast<double>(beyond),
                 qPrintable(QString::number(z)));
      }
    }
  }

  void aRoughTubeHasOneFlatCap() {
    const Volume<float> phi = roughTube(30, 0.1);
    for (double z = 8.0; z < 20.0; z += 1.5) {
      const Cut cut(phi, {{{11.5, 10.5, z}, {0.0, 0.0, 1.0}}});
      const ZeroSetMesh mesh = cut.mesh();
      checkPorts(mesh, cut.away, SurfaceBorder::Cap);
      for (const Vector3d& p : mesh.mesh.points) QVERIFY(p.z() < z + 1e-9);
    }
  }
};

QTEST_APPLESS_MAIN(TestCuts)
#include "tst_cuts.moc"
