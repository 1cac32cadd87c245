// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/centreline/skeleton.h"
#include "core/cuts/border_cuts.h"
#include "core/cuts/border_slant.h"
#include "core/field/wall_field.h"
#include "core/parameters/field.h"
#include "core/pipeline/surface_step.h"
#include "tests/core/bars.h"
#include "tests/core/mesh_shapes.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 4.0;

Geometry grid() {
  Geometry g;
  g.size = {48, 48, 48};
  g.origin = {-20.0, 7.0, 110.0};
  return g;
}

/// A vessel through the middle of the volume, in index coordinates, `degrees` off the z axis; it
/// leaves the volume at z = 0 and ends inside.
Volume<float> leaning(double degrees) {
  const double angle = degrees * M_PI / 180.0;
  const Vector3d axis(std::sin(angle), 0.0, std::cos(angle));
  const Vector3d foot(18.0, 23.4, 0.0);
  const Geometry g = grid();
  return analytic::clamped(g, [=](const Vector3d& x) {
    const Vector3d d = g.toIndex(x) - foot;
    const double along = std::min(d.dot(axis), 24.0);
    return (d - along * axis).norm() - kRadius;
  });
}

/// A quarter of a ring whose beginning runs along the border z = 0, the axis one voxel below it,
/// and which ends inside.
Volume<float> grazing() {
  const Geometry g = grid();
  return analytic::clamped(g, [=](const Vector3d& x) {
    const Vector3d p = g.toIndex(x) - Vector3d(8.0, 23.5, 27.0);
    const double around = std::clamp(std::atan2(p.x(), -p.z()), 0.0, 1.4);
    const Vector3d axis = 28.0 * Vector3d(std::sin(around), 0.0, -std::cos(around));
    return (p - axis).norm() - kRadius;
  });
}

/// A vessel that turns about an axis across the border z = 0, as a siphon does, and is sliced by it
/// over most of the turn; it ends inside.
Volume<float> wideOpening() {
  const Geometry g = grid();
  return analytic::clamped(g, [=](const Vector3d& x) {
    const Vector3d p = g.toIndex(x) - Vector3d(22.0, 20.0, -0.8);
    const double around = std::clamp(std::atan2(p.y(), p.x()), -0.9, 2.2);
    const Vector3d turn(9.0 * std::cos(around), 9.0 * std::sin(around), 0.0);
    const Vector3d end(9.0 * std::cos(2.2), 9.0 * std::sin(2.2), 0.0);
    const Vector3d up = Vector3d(-0.3, -0.2, 0.93).normalized();
    const double along = std::clamp((p - end).dot(up), 0.0, 32.0);
    const double bend = (p - turn).norm(), rise = (p - end - along * up).norm();
    return std::min(bend, rise) - kRadius;
  });
}

std::vector<Port> openPorts(const Volume<float>& phi) {
  std::vector<Port> ports = borderOpenings(phi);
  for (std::size_t n = 0; n < ports.size(); ++n) ports[n].name = "border_" + std::to_string(n + 1);
  return ports;
}

}  // namespace

class TestBorderPorts : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anglesAndRatiosAreThoseOfATiltedTube_data() {
    QTest::addColumn<double>("degrees");
    for (const double degrees : {0.0, 15.0, 28.0, 40.0, 55.0})
      QTest::addRow("%g", degrees) << degrees;
  }
  void anglesAndRatiosAreThoseOfATiltedTube() {
    QFETCH(double, degrees);
    const Volume<float> phi = leaning(degrees);
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    std::vector<Port> ports = openPorts(phi);
    QCOMPARE(ports.size(), std::size_t{1});
    QVERIFY((ports[0].normalLps + Vector3d::UnitZ()).norm() < 1e-12);
    const double ratio = 1.0 / std::cos(degrees * M_PI / 180.0);
    QVERIFY(std::fabs(ports[0].areaMm2 / (M_PI * kRadius * kRadius * ratio) - 1.0) < 0.03);
    measureSlants(field, phi, ports);
    QVERIFY(ports[0].slant.has_value());
    const BorderSlant& slant = *ports[0].slant;
    QVERIFY(isNear(slant.angleDeg, degrees, 2.0));
    QVERIFY(isNear(slant.areaRatio / ratio, 1.0, 0.05));
    QCOMPARE(slant.flagged(), degrees > 30.0);
    QCOMPARE(slantWarnings(ports).size(), std::size_t{degrees > 30.0 ? 1U : 0U});
    if (degrees < 30.0) return;
    const QString warning = QString::fromStdString(slantWarnings(ports)[0]);
    QVERIFY(warning.contains("'border_1'") && warning.contains("--cut "));
    // What is proposed is a cut.
    const CutAway away = cutAway(field, phi, {{slant.centreLps, slant.axisLps}}, {"x"});
    QVERIFY(std::fabs(away.sections[0].areaMm2 / (M_PI * kRadius * kRadius) - 1.0) < 0.03);
  }

  void aVesselAlongTheBorderIsCutAcross() {
    const Volume<float> phi = grazing();
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    std::vector<Port> ports = openPorts(phi);
    measureSlants(field, phi, ports);
    QVERIFY(std::any_of(ports.begin(), ports.end(),
                        [](const Port& p) { return p.slant && p.slant->flagged(); }));
    CutAway away;
    const std::vector<std::string> remarks = addBorderCuts(field, phi, away);
    QVERIFY2(remarks.empty(), remarks.empty() ? "" : remarks[0].c_str());
    QCOMPARE(away.names, std::vector<std::string>{"across_1"});
    QVERIFY(std::fabs(away.sections[0].areaMm2 / (M_PI * kRadius * kRadius) - 1.0) < 0.05);
    // All openings of the border are gone with what was cut away.
    MadeSurface made = makeSurface(phi, field, {}, {}, away);
    QCOMPARE(made.ports.size(), std::size_t{1});
    QCOMPARE(made.ports[0].name, std::string("across_1"));
    measureSlants(field, phi, made.ports);
    QVERIFY(!made.ports[0].slant);
  }

  /// Its line ends where the opening begins, in one end, and wherever the line goes the vessel can
  /// be cut across, there or a little farther inside.
  void aLineAlongTheBorderEndsThere_data() {
    QTest::addColumn<bool>("wide");
    QTest::newRow("a grazing vessel") << false;
    QTest::newRow("a wide opening") << true;
  }
  void aLineAlongTheBorderEndsThere() {
    QFETCH(bool, wide);
    const Volume<float> phi = wide ? wideOpening() : grazing();
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    const Skeleton skeleton = skeletonOf(phi);
    QCOMPARE(skeleton.branches.size(), std::size_t{1});
    QCOMPARE(skeleton.nodes.size(), std::size_t{2});
    QVERIFY((skeleton.nodes[0].kind == NodeKind::Border) !=
            (skeleton.nodes[1].kind == NodeKind::Border));
    QVERIFY(skeleton.nodes[0].kind == NodeKind::Tip || skeleton.nodes[1].kind == NodeKind::Tip);
    std::size_t moved = 0;
    for (const SkeletonPoint& point : skeleton.branches[0].points) {
      QVERIFY(phi.geometry.holds(point.pointLps) && field.valueAt(point.pointLps) < 0.0);
      PortParams params;
      params.cuts = {cutText({point.pointLps, std::nullopt, "here"})};
      std::vector<std::string> remarks;
      const CutAway away = makeCuts(field, phi, params, remarks);
      QCOMPARE(away.sections.size(), std::size_t{1});
      QVERIFY(std::fabs(away.sections[0].areaMm2 / (M_PI * kRadius * kRadius) - 1.0) < 0.15);
      moved += std::count_if(remarks.begin(), remarks.end(), [](const std::string& remark) {
        return remark.find("the cut 'here' was moved by") == 0;
      });
    }
    QVERIFY(moved > 0 && moved < skeleton.branches[0].points.size() / 2);
  }

  /// Near such an opening the wall tells nothing of the vessel's axis.
  void aWideOpeningIsFlagged() {
    const Volume<float> phi = wideOpening();
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    std::vector<Port> ports = openPorts(phi);
    measureSlants(field, phi, ports);
    QCOMPARE(ports.size(), std::size_t{1});
    QVERIFY(ports[0].slant.has_value());
    QVERIFY(ports[0].slant->flagged() && ports[0].slant->areaRatio > 2.0);
    QVERIFY(std::fabs(ports[0].slant->sectionAreaMm2 / (M_PI * kRadius * kRadius) - 1.0) < 0.15);
  }

  void whatIsNotKnownIsSaid() {
    std::vector<Port> ports(4);
    for (Port& port : ports) port.atBorder = true;
    ports[0].areaMm2 = 12.0;
    ports[0].slant.emplace().angleDeg = 10.0;
    ports[1].name = "border_2";
    ports[1].areaMm2 = 6.0;
    ports[2].areaMm2 = 0.1;
    ports[3].areaMm2 = 9.0;
    ports[3].atBorder = false;
    const std::vector<std::string> sentences = slantWarnings(ports);
    QCOMPARE(sentences.size(), std::size_t{1});
    QVERIFY(sentences[0].find("the port 'border_2' of 6 mm2 may slice its vessel") == 0);
  }

  /// The first place that comes into question lies on points of the surface's rim at the border.
  void aCutKeepsOffThePointsOfTheRim() {
    const Geometry g = grid();
    const Vector3d axis = Vector3d(1.0, 0.0, 1.0).normalized();
    const Volume<float> phi = analytic::clamped(g, [&](const Vector3d& x) {
      const Vector3d d = g.toIndex(x) - Vector3d(4.0, 23.4, 0.0);
      return (d - std::min(d.dot(axis), 24.0) * axis).norm() - 3.0;
    });
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    CutAway away;
    QVERIFY(addBorderCuts(field, phi, away).empty());
    QCOMPARE(away.names, std::vector<std::string>{"across_1"});
    QCOMPARE(makeSurface(phi, field, {}, {}, away).ports.size(), std::size_t{1});
  }

  /// Through an edge of the volume: an opening in each of two planes, as the surface has them, and
  /// one cut for both.
  void anOpeningMayLieInTwoPlanes() {
    const Geometry g = grid();
    const Vector3d axis = Vector3d(1.0, 0.0, 1.0).normalized();
    const Volume<float> phi = analytic::clamped(g, [&](const Vector3d& x) {
      const Vector3d d = g.toIndex(x) - Vector3d(-1.0, 23.4, 0.0);
      return (d - std::min(d.dot(axis), 30.0) * axis).norm() - kRadius;
    });
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    std::vector<Port> ports = openPorts(phi);
    std::sort(ports.begin(), ports.end(),
              [](const Port& a, const Port& b) { return a.areaMm2 > b.areaMm2; });
    const MadeSurface made = makeSurface(phi, field, {}, {});
    QCOMPARE(ports.size(), made.ports.size());
    for (std::size_t n = 0; n < ports.size(); ++n) {
      QVERIFY(std::fabs(ports[n].areaMm2 / made.ports[n].areaMm2 - 1.0) < 0.05);
      QVERIFY((ports[n].centreLps - made.ports[n].centreLps).norm() < 0.3);
      QVERIFY(ports[n].normalLps.dot(made.ports[n].normalLps) > 0.999);
    }
    CutAway away;
    QVERIFY(addBorderCuts(field, phi, away).empty());
    QCOMPARE(away.sections.size(), std::size_t{1});
  }

  /// A horseshoe lies in one border of the volume, a ring that is one voxel wide in places, and it
  /// is one opening, of the same area and centre from whichever side it is looked for.
  void openingsAreWholeInEveryDirection() {
    Geometry g;
    g.size = {26, 22, 20};
    g.spacing = {0.8, 1.0, 0.7};
    const auto shape = [&](const Vector3d& p) {
      const Vector3d d = p - Vector3d(9.6, 10.3, 0.0);
      const double ring = std::fabs(std::hypot(d.x(), d.y()) - 5.1) - 0.75;
      const double gap = 1.9 - std::hypot(d.x() - 3.4, d.y() + 3.4);
      return std::max({ring, gap, d.z() - 3.0});
    };
    Volume<float> phi = analytic::sampled(g, shape);
    const std::vector<Port> expected = borderOpenings(phi);
    QCOMPARE(expected.size(), std::size_t{1});
    for (int turn = 0; turn < 3; ++turn) {
      for (std::size_t mirror = 0; mirror < 8; ++mirror) {
        Volume<float> other = phi;
        for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
          Index3 p = phi.geometry.indexOf(i);
          for (std::size_t a = 0; a < 3; ++a)
            if ((mirror >> a & 1U) != 0) p[a] = phi.geometry.size[a] - 1 - p[a];
          other.at(p[0], p[1], p[2]) = phi.voxels[i];
        }
        const std::vector<Port> openings = borderOpenings(other);
        QCOMPARE(openings.size(), std::size_t{1});
        QVERIFY(isNear(openings[0].areaMm2 / expected[0].areaMm2, 1.0, 1e-6));
        Vector3d index = phi.geometry.toIndex(openings[0].centreLps);
        for (std::size_t a = 0; a < 3; ++a)
          if ((mirror >> a & 1U) != 0)
            index[static_cast<int>(a)] = phi.geometry.size[a] - 1 - index[static_cast<int>(a)];
        QVERIFY((phi.geometry.toPhysical(index) - expected[0].centreLps).norm() < 1e-6);
      }
      phi = analytic::turned(phi);
    }
  }

  /// One voxel of surroundings parts two openings, also of which one lies around the other.
  void openingsThatAllButTouchAreTwo() {
    const Volume<float> phi = analytic::sampled(analytic::cube(20), [&](const Vector3d& p) {
      const double off = std::max(std::fabs(p.x() - 9.0), std::fabs(p.y() - 8.0));
      return std::max(std::min(off - 2.5, std::fabs(off - 5.0) - 1.5), p.z() - 3.2);
    });
    const std::vector<Port> openings = borderOpenings(phi);
    QCOMPARE(openings.size(), std::size_t{2});
    for (const Port& opening : openings)
      QVERIFY((opening.centreLps - Vector3d(9.0, 8.0, 0.0)).norm() < 0.1);
    QVERIFY(openings[0].areaMm2 > 2.0 * openings[1].areaMm2);
  }

  /// Of two openings side by side one can be cut across. The other is told, and stands in no way of
  /// a third.
  void anOpeningThatCannotBeCutLeavesTheOthers() {
    const Vector3d axis = Vector3d(0.77, 0.0, 0.64).normalized();
    const Geometry g = grid();
    const Volume<float> phi = analytic::clamped(g, [&](const Vector3d& x) {
      double least = 1e9;
      for (const double y : {8.2, 15.9, 36.3}) {
        const Vector3d d = g.toIndex(x) - Vector3d(16.0, y, 0.0);
        least = std::min(least, (d - std::min(d.dot(axis), 24.0) * axis).norm() - 3.4);
      }
      return least;
    });
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    CutAway away;
    const std::vector<std::string> remarks = addBorderCuts(field, phi, away);
    QCOMPARE(remarks.size(), std::size_t{1});
    QVERIFY(remarks[0].find("was not cut: ") != std::string::npos &&
            remarks[0].find("touch") != std::string::npos);
    QCOMPARE(away.names, (std::vector<std::string>{"across_1", "across_2"}));
    QCOMPARE(away.sections.size(), std::size_t{2});
    QVERIFY(std::fabs(g.toIndex(away.sections[0].centreLps).y() - 8.2) < 0.3);
    QVERIFY(std::fabs(g.toIndex(away.sections[1].centreLps).y() - 36.3) < 0.3);
  }

  void whatIsStraightIsNotCut() {
    const Volume<float> phi = leaning(10.0);
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    PortParams params;
    params.cutBorders = true;
    std::vector<std::string> remarks;
    QVERIFY(makeCuts(field, phi, params, remarks).empty());
    QVERIFY(remarks.empty());
    const Volume<float> steep = leaning(50.0);
    const SplineField other = wallField(steep, SplineKind::InterpolatingBspline);
    QCOMPARE(makeCuts(other, steep, params, remarks).sections.size(), std::size_t{1});
    // A cut of the user's own stands in for it.
    params.cuts = {cutText({grid().toPhysical({30.0, 23.4, 10.0}), Vector3d(-1, 0, -1), "mine"})};
    QCOMPARE(makeCuts(other, steep, params, remarks).names, std::vector<std::string>{"mine"});
  }

  void namesGoByPlace() {
    const auto port = [](const char* name, const Vector3d& place) {
      return Port{name, place, Vector3d::UnitZ(), M_PI * kRadius * kRadius, true};
    };
    PortParams params;
    params.cuts = {"0,0,9,out"};
    params.names = {"1,2,3=inlet", "0,0,9.5=second", "40,0,0=far", "1,2.5,3=again"};
    // In another order, and some way off, as on a surface of other parameters.
    std::vector<Port> ports{port("out", {0, 0, 9}), port("border_1", {0, 0, 12}),
                            port("border_2", {1, 2, 1.5})};
    const std::vector<std::string> warnings = namePorts(params, ports);
    QCOMPARE(ports[0].name, std::string("out"));
    QCOMPARE(ports[1].name, std::string("second"));
    QCOMPARE(ports[2].name, std::string("inlet"));
    QCOMPARE(warnings.size(), std::size_t{2});
    QVERIFY(warnings[0].find("there is no port at 40,0,0 mm LPS") == 0);
    QVERIFY(warnings[1].find("'inlet' keeps its name") != std::string::npos);
    const PortNaming naming = parsePortNaming("1,-2.5,3e1=a");
    QCOMPARE(portNamingText(naming), std::string("1,-2.5,30=a"));
    QCOMPARE(portNamingText(parsePortNaming("border_7=a")), std::string("border_7=a"));
  }

  /// What addPorts() makes of a surface's ports gives the same ports on the next one.
  void portsComeBack() {
    const Volume<float> phi = leaning(50.0);
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    PortParams params;
    params.cuts = {cutText({grid().toPhysical({30.0, 23.4, 10.0}), std::nullopt, "end"})};
    params.names = {"border_1=inlet"};
    const auto portsOf = [&](const PortParams& given) {
      std::vector<std::string> remarks;
      const CutAway away = makeCuts(field, phi, given, remarks);
      std::vector<Port> ports = makeSurface(phi, field, {}, {}, away).ports;
      return namePorts(given, ports).empty() ? ports : std::vector<Port>();
    };
    const std::vector<Port> first = portsOf(params);
    QCOMPARE(first.size(), std::size_t{2});
    QVERIFY(!first[0].atBorder && first[1].atBorder);
    PortParams read;
    addPorts(first, read);
    QCOMPARE(read.cuts.size(), std::size_t{1});
    QCOMPARE(read.names.size(), std::size_t{1});
    const std::vector<Port> second = portsOf(read);
    QCOMPARE(second.size(), first.size());
    for (std::size_t n = 0; n < first.size(); ++n) {
      QCOMPARE(second[n].name, first[n].name);
      QVERIFY((second[n].centreLps - first[n].centreLps).norm() < 1e-3);
      QVERIFY(std::fabs(second[n].areaMm2 / first[n].areaMm2 - 1.0) < 1e-3);
    }
    // One that has no name of its own gets one from the program again.
    params.names.clear();
    PortParams unnamed;
    addPorts(portsOf(params), unnamed);
    QVERIFY(unnamed.names.empty());
  }

  /// A cut across an opening that has been named by its place takes the name over.
  void aCutAcrossHasTheNameOfTheOpening() {
    const Volume<float> phi = leaning(50.0);
    const SplineField field = wallField(phi, SplineKind::InterpolatingBspline);
    PortParams params;
    params.cutBorders = true;
    addPorts({{"inlet", borderOpenings(phi)[0].centreLps, -Vector3d::UnitZ(), 1.0, true}}, params);
    std::vector<std::string> remarks;
    const CutAway away = makeCuts(field, phi, params, remarks);
    QCOMPARE(away.names, std::vector<std::string>{"inlet"});
    std::vector<Port> ports = makeSurface(phi, field, {}, {}, away).ports;
    QVERIFY(namePorts(params, ports).empty());
    QCOMPARE(ports.size(), std::size_t{1});
    QCOMPARE(ports[0].name, std::string("inlet"));
  }

  void portsGetTheirNames() {
    std::vector<Port> ports(3);
    ports[0].name = "border_1";
    ports[1].name = "border_2";
    ports[2].name = "out";
    PortParams params;
    params.names = {"border_1=inlet", "border_2=out", "border_7=far"};
    const std::vector<std::string> warnings = namePorts(params, ports);
    QCOMPARE(ports[0].name, std::string("inlet"));
    QCOMPARE(ports[1].name, std::string("border_2"));
    QCOMPARE(warnings.size(), std::size_t{2});
    QVERIFY(warnings[0].find("another one is called 'out'") != std::string::npos);
    QVERIFY(warnings[1].find("no port is called 'border_7'") == 0);
    Parameters all;
    setFieldFromText(all, "ports.names", "border_1=a;border_2=b;1,-2.5,3=c");
    validate(all);
    for (const char* text :
         {"border_1", "=a", "border_1=", "border_1=wall", "border_1=border_2", "border_1=a b",
          "border 1=a", "border_1;b=a", "\xff=a", "1,2=a", "1,2,x=a", "1,2,3,4=a"})
      QVERIFY_THROWS_EXCEPTION(InputError,
                               setField(all, "ports.names", std::vector<std::string>{text}));
    for (const char* text : {"border_1=a;border_2=a", "border_1=a;border_1=b"}) {
      setFieldFromText(all, "ports.names", text);
      QVERIFY_THROWS_EXCEPTION(InputError, validate(all));
    }
    setFieldFromText(all, "ports.names", "border_1=a");
    setFieldFromText(all, "ports.cuts", "1,2,3,a");
    QVERIFY_THROWS_EXCEPTION(InputError, validate(all));
  }
};

QTEST_APPLESS_MAIN(TestBorderPorts)
#include "tst_border_ports.moc"
