// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/cuts/cuts.h"
#include "core/parameters/field.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/surface_step.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/refusal.h"

using namespace angiomesh;
using analytic::capsule;
using Eigen::Vector3d;

namespace {

const Vector3d kFrom{10.2, 20.3, 19.4}, kTo{52.1, 21.2, 20.8};

Geometry grid() {
  Geometry g;
  g.size = {64, 42, 40};
  return g;
}

// A straight vessel with two ends inside the volume.
Volume<float> oneVessel() {
  return shapes::sampled(grid(), [](const Vector3d& p) { return capsule(p, kFrom, kTo, 3.4); });
}

// A trunk along x that divides at x = 30 into two branches.
Volume<float> forked() {
  return shapes::sampled(grid(), [](const Vector3d& p) {
    const Vector3d joint{30.0, 20.0, 20.0};
    return std::min({capsule(p, {-9.0, 20.0, 20.0}, joint, 4.0),
                     capsule(p, joint, {54.0, 33.0, 20.0}, 3.0),
                     capsule(p, joint, {54.0, 7.0, 20.0}, 3.0)});
  });
}

CutAway made(const Volume<float>& phi, const PortParams& params,
             std::vector<std::string>& remarks) {
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  return makeCuts(field, phi, params, remarks);
}

CutAway made(const Volume<float>& phi, const std::vector<std::string>& cuts) {
  std::vector<std::string> remarks;
  return made(phi, {cuts, 0.0}, remarks);
}

bool anyHas(const std::vector<std::string>& texts, const char* what) {
  return std::any_of(texts.begin(), texts.end(),
                     [&](const std::string& text) { return text.find(what) != std::string::npos; });
}

}  // namespace

class TestPortCuts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void textsAreReadAndWritten() {
    const GivenCut plain = parseCut(" 1.5, -2,3e1 ,inlet");
    QCOMPARE(plain.name, std::string("inlet"));
    QVERIFY(plain.pointLps == Vector3d(1.5, -2.0, 30.0) && !plain.normalLps);
    QCOMPARE(cutText(plain), std::string("1.5,-2,30,inlet"));
    const GivenCut full = parseCut("0.1,0.2,0.3,0,0,-2,left-renal.1");
    QVERIFY(full.normalLps && *full.normalLps == Vector3d(0.0, 0.0, -2.0));
    QCOMPARE(cutText(full), std::string("0.1,0.2,0.3,0,0,-2,left-renal.1"));
    QVERIFY(parseCut(cutText(full)).pointLps == full.pointLps);
  }

  void whatIsNoCutIsRefusedInWords_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("why");
    QTest::newRow("empty") << ""
                           << "is no cut";
    QTest::newRow("three") << "1,2,3"
                           << "is no cut";
    QTest::newRow("five") << "1,2,3,4,name"
                          << "is no cut";
    QTest::newRow("word") << "1,two,3,name"
                          << "'two' is no number";
    QTest::newRow("infinite") << "1,inf,3,name"
                              << "is no number";
    QTest::newRow("no direction") << "1,2,3,0,0,0,name"
                                  << "has no length";
    QTest::newRow("too long a direction") << "1,2,3,0,1e300,0,name"
                                          << "is too long";
    QTest::newRow("no name") << "1,2,3,"
                             << "'' is no name";
    QTest::newRow("blank in name") << "1,2,3,left renal"
                                   << "is no name";
    QTest::newRow("separator in name") << "1,2,3,a;b"
                                       << "is no name";
    QTest::newRow("wall") << "1,2,3,wall"
                          << "gives itself";
    QTest::newRow("border") << "1,2,3,border_1"
                            << "gives itself";
  }
  void whatIsNoCutIsRefusedInWords() {
    QFETCH(QString, text);
    QFETCH(QString, why);
    const QString message =
        QString::fromStdString(messageOf([&] { parseCut(text.toStdString()); }));
    QVERIFY2(message.contains(why), qPrintable(message));
    Parameters params;
    QVERIFY_THROWS_EXCEPTION(InputError,
                             setField(params, "ports.cuts", std::vector{text.toStdString()}));
  }

  void namesAreDifferent() {
    Parameters params;
    setFieldFromText(params, "ports.cuts", "1,2,3,a;4,5,6,a");
    QVERIFY(messageOf([&] { validate(params); }).find("two cuts are called 'a'") !=
            std::string::npos);
    setFieldFromText(params, "ports.cuts", "1,2,3,a;4,5,6,b");
    validate(params);
    QCOMPARE(params.ports.cuts.size(), std::size_t{2});
    setFieldFromText(params, "ports.cuts", "none");
    QVERIFY(params.ports.cuts.empty());
  }

  // Across the vessel, and the smaller part goes.
  void aCutWithoutNormalGoesAcross() {
    const Volume<float> phi = oneVessel();
    const Vector3d axis = (kTo - kFrom).normalized();
    for (const double share : {0.25, 0.8}) {
      // Beside the axis, and on the wall.
      for (const double off : {1.5, 3.4, 4.6}) {
        const Vector3d at = kFrom + share * (kTo - kFrom) + off * axis.unitOrthogonal();
        GivenCut cut;
        cut.pointLps = at;
        cut.name = "x";
        const CutAway away = made(phi, {cutText(cut)});
        const Section& section = away.sections[0];
        const double towards = section.plane.normalLps.dot(axis) * (share > 0.5 ? 1.0 : -1.0);
        QVERIFY(isAbove(towards, std::cos(0.03)));
        QVERIFY(std::abs(section.areaMm2 / (shapes::pi * 3.4 * 3.4) - 1.0) < 0.01);
        QVERIFY(std::abs((section.centreLps - at).dot(axis)) < 0.6);
      }
    }
  }

  // A plane through a point beside the vessel meets it where its axis does.
  void aPlaneThroughAPointOnTheWallIsTheGivenOne() {
    const Vector3d axis = (kTo - kFrom).normalized();
    const Vector3d normal = (axis + 0.4 * axis.unitOrthogonal()).normalized();
    GivenCut cut;
    cut.pointLps = 0.5 * (kFrom + kTo) + 4.4 * axis.unitOrthogonal();
    cut.normalLps = 3.0 * normal;
    cut.name = "x";
    const CutAway away = made(oneVessel(), {cutText(cut)});
    QVERIFY((away.sections[0].plane.normalLps - normal).norm() < 1e-12);
    QVERIFY(std::abs((away.sections[0].centreLps - cut.pointLps).dot(normal)) < 1e-9);
  }

  // Where the plane all but runs along the vessel, its axis would meet it far away.
  void aPlaneAlongTheVesselKeepsItsPlace() {
    const Vector3d axis = (kTo - kFrom).normalized(), aside = axis.unitOrthogonal();
    const Vector3d middle = 0.5 * (kFrom + kTo);
    const Volume<float> phi = oneVessel();
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    for (const auto& [slope, moved] : {std::pair{0.15, false}, std::pair{0.3, true}}) {
      GivenCut cut;
      cut.pointLps = middle + 4.4 * aside;
      cut.normalLps = slope * axis + std::sqrt(1.0 - slope * slope) * aside;
      const CutPlane plane = placeCut(field, phi, cut);
      const Vector3d way = plane.pointLps - middle;
      QVERIFY((way - way.dot(axis) * axis).norm() < 0.3);
      if (moved)
        QVERIFY(std::abs((plane.pointLps - cut.pointLps).dot(*cut.normalLps)) < 1e-9);
      else
        QVERIFY(std::abs(way.dot(axis)) < 0.5);
    }
  }

  void endsAreCutByThemselves() {
    std::vector<std::string> remarks;
    const CutAway away = made(oneVessel(), {{}, 2.0}, remarks);
    QCOMPARE(away.names, (std::vector<std::string>{"end_1", "end_2"}));
    QVERIFY(remarks.empty());
    const Vector3d axis = (kTo - kFrom).normalized();
    for (const Section& section : away.sections) {
      const double along = (section.centreLps - kFrom).dot(axis);
      const double fromTip = std::min(along, (kTo - kFrom).norm() - along);
      QVERIFY(isNear(fromTip, 2.0 * 3.4, 1.5));
      QVERIFY(section.plane.normalLps.dot(axis) * (along > 20.0 ? 1.0 : -1.0) > 0.99);
    }
    // A given cut stands in for its end; names do not clash.
    const CutAway one = made(oneVessel(), {{"45,21,20.6,end_1"}, 2.0}, remarks);
    QCOMPARE(one.names, (std::vector<std::string>{"end_1", "end_2"}));
    QVERIFY((one.sections[1].centreLps - kFrom).norm() < 10.0);
  }

  /// Of two vessels side by side one end only can be cut at a place. What cannot be cut is told,
  /// and stands in no way of the others or of their names.
  void anEndThatCannotBeCutLeavesTheOthers() {
    const Volume<float> phi = shapes::sampled(grid(), [](const Vector3d& p) {
      return std::min({capsule(p, {11.0, 12.3, 20.2}, {52.0, 12.3, 20.2}, 3.2),
                       capsule(p, {11.0, 20.0, 20.2}, {52.0, 20.0, 20.2}, 3.2),
                       capsule(p, {12.0, 33.1, 19.8}, {51.0, 33.1, 19.8}, 3.0)});
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const EndPlan plan = planEndCuts(field, phi, skeletonOf(phi), {}, 2.0);
    QCOMPARE(plan.names, (std::vector<std::string>{"end_1", "end_2", "end_3", "end_4"}));
    QCOMPARE(plan.remarks.size(), std::size_t{2});
    QVERIFY(anyHas(plan.remarks, "touch"));
    QCOMPARE(plan.away.names, plan.names);
    QCOMPARE(plan.away.sections.size(), plan.planes.size());
    int third = 0;
    for (std::size_t n = 0; n < plan.planes.size(); ++n) {
      QVERIFY((plan.away.sections[n].plane.pointLps - plan.planes[n].pointLps).norm() < 1e-12);
      third += plan.planes[n].pointLps.y() > 28.0 ? 1 : 0;
    }
    QCOMPARE(third, 2);
  }

  void remarksSayWhatASolverWouldNot() {
    std::vector<std::string> remarks;
    made(forked(), {{"12,20,20,-1,0,0,far", "40,25.4,20,near"}, 0.0}, remarks);
    QCOMPARE(remarks.size(), std::size_t{2});
    QVERIFY(anyHas(remarks, "'near' lies"));
    QVERIFY(anyHas(remarks, "of its diameters from the next branching"));
    remarks.clear();
    made(forked(), {{"33,20,20,1,0,0,both"}, 0.0}, remarks);
    QVERIFY(anyHas(remarks, "passes 2 vessels at once"));
    remarks.clear();
    made(oneVessel(), {{"30,20.8,20,1,0,0,single"}, 0.0}, remarks);
    QVERIFY(remarks.empty());
  }

  // Alone each cut of a ring ends nothing, and without a direction each is tried alone.
  void aRingAsksForDirections() {
    const Volume<float> phi = shapes::sampled(grid(), [](const Vector3d& p) {
      return std::hypot(std::hypot(p.x() - 32.0, p.y() - 21.0) - 13.0, p.z() - 20.0) - 3.4;
    });
    const std::string message = messageOf([&] { made(phi, {"45,21,20,round"}); });
    QVERIFY2(message.find("the cut 'round' ends no vessel") == 0, message.c_str());
    QVERIFY2(message.find("ports.cuts: give the direction") != std::string::npos, message.c_str());
  }

  void aPlaceWithoutAVesselIsNamed() {
    const std::string message = messageOf([] { made(oneVessel(), {"5,5,5,nowhere"}); });
    QVERIFY(message.find("'nowhere' at L 5.0 P 5.0 S 5.0") != std::string::npos);
  }

  // Through the pipeline: names, mask and reports; other values of rho do not move a port.
  void aRunEndsAtItsCuts() {
    PhantomParams phantom;
    phantom.psf.kind = PointSpread::Kind::Subvoxels;
    phantom.kind = PhantomKind::Bifurcation;
    phantom.size = {56, 56, 56};
    phantom.radius = 3.5;
    Pipeline pipeline(makeSource(makePhantom(phantom).image, "fork"));
    Parameters params;
    params.ports.cuts = {"27.5,27.5,8,0,0,-1,inlet", "38,27.5,42.5,left"};
    std::vector<double> areas;
    for (const double rho : {0.3, 0.4, 0.5}) {
      params.surface.sizing.rho = rho;
      const RunResult run = pipeline.run(params);
      QCOMPARE(run.ports.size(), std::size_t{3});
      QCOMPARE(run.ports[0].name, std::string("inlet"));
      QCOMPARE(run.ports[1].name, std::string("left"));
      QCOMPARE(run.ports[2].name, std::string("border_1"));
      QVERIFY(portFaults(run.ports, *run.smoothed).empty());
      for (const std::size_t n : {0, 1})
        QVERIFY(std::abs(run.ports[n].areaMm2 / run.surface->sectionAreasMm2[n] - 1.0) < 5e-3);
      areas.push_back(run.ports[1].areaMm2);
      // The mask ends at the cuts; what is left of it is inside as before.
      const Geometry& g = run.surface->phi->geometry;
      for (std::size_t i = 0; i < run.surface->phi->voxels.size(); ++i) {
        const Index3 p = g.indexOf(i);
        const bool inside = run.surface->phi->voxels[i] < 0.0F;
        QVERIFY(!inside || run.surface->uncutPhi->voxels[i] < 0.0F);
        if (p[2] < 8) QVERIFY(!inside);
      }
    }
    QVERIFY(std::abs(areas[0] / areas[2] - 1.0) < 5e-3);
    // Nothing before the surface is computed again for another cut, and undo finds the old one.
    params.ports.cuts.pop_back();
    for (const StageReport& stage : pipeline.run(params).stages)
      QCOMPARE(stage.reused, stage.step < Step::Surface);
  }

  // Two vessels, of which the surface keeps the thicker: what ends the other one is no opening.
  void aCutGoesWithThePartThatItEnds() {
    const Volume<float> phi = shapes::sampled(grid(), [](const Vector3d& p) {
      return std::min(capsule(p, {-9.0, 12.0, 20.0}, {52.0, 12.0, 20.0}, 3.0),
                      capsule(p, {-9.0, 28.0, 20.0}, {52.0, 28.0, 20.0}, 4.2));
    });
    const SplineField field(phi, SplineKind::InterpolatingBspline);
    const CutAway away = made(phi, {"30,12,20,1,0,0,thin", "30,28,20,1,0,0,thick"});
    for (const SurfaceMethod method :
         {SurfaceMethod::AdvancingFront, SurfaceMethod::MarchingCubes}) {
      SurfaceParams params;
      params.method = method;
      const MadeSurface both = makeSurface(phi, field, params, {}, away);
      QCOMPARE(both.ports.size(), std::size_t{4});
      QVERIFY(both.lostCuts.empty());
      const MadeSurface one = makeSurface(phi, field, params, {}, away, true);
      QCOMPARE(one.lostCuts, std::vector<std::size_t>{0});
      QCOMPARE(one.ports.size(), std::size_t{2});
      QCOMPARE(one.ports[0].name, std::string("thick"));
      QCOMPARE(one.ports[1].name, std::string("border_1"));
      QVERIFY(anyHas(one.origin.warnings(), "the cut 'thin' with the part that it ends"));
      QVERIFY(anyHas({one.origin.dropped.front()}, "the cut 'thin'"));
      QVERIFY(portFaults(one.ports, one.mesh).empty());
      const std::uint16_t last = *std::max_element(one.mesh.patch.begin(), one.mesh.patch.end());
      QCOMPARE(last, std::uint16_t{2});
    }
  }
};

QTEST_APPLESS_MAIN(TestPortCuts)
#include "tst_port_cuts.moc"
