// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/quality/vessel_measures.h"
#include "tests/core/bars.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

PhantomParams paramsOf(PhantomKind kind, int side, double radius) {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = kind;
  params.size = {side, side, side};
  params.radius = radius;
  return params;
}

SplineField splineOf(const Volume<float>& phi) {
  return SplineField(phi, SplineKind::InterpolatingBspline);
}

Volume<float> shifted(Volume<float> phi, float by) {
  for (float& v : phi.voxels) v += by;
  return phi;
}

}  // namespace

class TestVesselMeasures : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anExactWallHasNoDistanceAndAGrownOneThatByWhichItGrew() {
    for (const double grown : {0.0, 0.4, -0.3}) {
      PhantomParams params = paramsOf(PhantomKind::Torus, 48, 5.0);
      params.axis = {0.3, 0.5, 1.0};
      const Phantom phantom = makePhantom(params);
      const Volume<float> phi = shifted(phantomField(params), static_cast<float>(-grown));
      const auto samples = wallSamples(splineOf(phi), phantomDistance(params), phantom.centreLines);
      QVERIFY(samples.size() > 1000);
      const WallDistance distance = wallDistance(samples);
      QVERIFY(isNear(distance.meanMm, std::fabs(grown), 0.01));
      QVERIFY(std::fabs(distance.percentile95Mm - std::fabs(grown)) < 0.02);
      QVERIFY(std::fabs(wallBias(samples, 4.0, 6.0, 2.0) - grown) < 0.01);
      QVERIFY(std::isnan(wallBias(samples, 6.0, 9.0, 2.0)));
      QVERIFY(std::isnan(wallBias(samples, 4.0, 6.0, -1.0)));
    }
    QVERIFY(std::isnan(wallDistance({}).meanMm));
  }

  void wallSamplesAreTheSameForAnyNumberOfThreads() {
    const PhantomParams params = paramsOf(PhantomKind::Bifurcation, 32, 4.0);
    const SplineField phi = splineOf(phantomField(params));
    const auto [one, two] =
        onOneAndSeveralThreads([&] { return wallSamples(phi, phantomDistance(params)); });
    QCOMPARE(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) QVERIFY(one[i].point == two[i].point);
  }

  void radiusOfATube_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("grown");
    QTest::addColumn<double>("tilt");
    for (const double radius : {1.5, 3.0, 6.0})
      for (const double grown : {0.0, 0.25})
        for (const double tilt : {0.0, 0.7})
          QTest::addRow("%g %g %g", radius, grown, tilt) << radius << grown << tilt;
  }
  void radiusOfATube() {
    QFETCH(double, radius);
    QFETCH(double, grown);
    QFETCH(double, tilt);
    PhantomParams params = paramsOf(PhantomKind::Tube, 48, radius);
    params.axis = {tilt, 0.5 * tilt, 1.0};
    params.offset = {0.3, 0.1, 0.2};
    params.spacingMm = {0.5, 0.5, 0.5};
    const Phantom phantom = makePhantom(params);
    const Volume<float> phi = shifted(phantomField(params), static_cast<float>(-0.5 * grown));
    const CentreLineSegment& line = phantom.centreLines.front();
    const double found = tubeRadius(splineOf(phi), line.from, line.to, 0.5 * (radius + 4.0)) / 0.5;
    QVERIFY2(std::fabs(found - radius - grown) < 0.02, QByteArray::number(found));
    Volume<float> shares = phantom.image;
    double sum = 0.0;
    for (float& v : shares.voxels) {
      v = v >= 255.0F ? 1.0F : v / 256.0F;
      sum += v;
    }
    // All of the line: the whole volume.
    const double length = (line.to - line.from).norm() / 0.5;
    const double imaged =
        tubeRadiusOfShares(shares, line.from, line.to, 0.5 * (radius + 4.0)) / 0.5;
    QVERIFY(isNear(imaged, std::sqrt(sum / (M_PI * length)), (tilt > 0.0 ? 0.1 : 0.01)));
  }

  void recallIsTheShareOfTheLengthInside() {
    const PhantomParams params = paramsOf(PhantomKind::Tube, 40, 3.0);
    const Phantom phantom = makePhantom(params);
    Volume<float> phi = phantomField(params);
    QCOMPARE(centreLineRecall(phi, phantom.centreLines, 1.0), 1.0);
    QVERIFY(std::isnan(centreLineRecall(phi, phantom.centreLines, 3.5)));
    for (int k = 0; k < 10; ++k)
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i) phi.at(i, j, k) = 3.0F;
    // Between k = 9 and 10 the sign changes half way.
    QVERIFY(std::fabs(centreLineRecall(phi, phantom.centreLines, 1.0) - 30.0 / 40.0) < 0.01);
  }

  void falseComponentsAndMergedVesselsAreCounted() {
    PhantomParams params = paramsOf(PhantomKind::Kissing, 64, 3.0);
    params.gap = 3.0;
    const Phantom phantom = makePhantom(params);
    Volume<std::uint8_t> result = phantom.truth;
    ComponentMeasures m = measureComponents(result, phantom.truth, phantom.centreLines);
    QCOMPARE(m.components, std::size_t{2});
    QCOMPARE(m.falseOnes, std::size_t{0});
    QCOMPARE(m.mergedVessels, std::size_t{0});
    for (int i = 28; i < 36; ++i) result.at(i, 32, 32) = 1;  // a bridge between the two
    for (int i = 0; i < 7; ++i) result.at(i, 2, 60) = 1;
    result.at(2, 60, 2) = 1;
    m = measureComponents(result, phantom.truth, phantom.centreLines);
    QCOMPARE(m.components, std::size_t{3});
    QCOMPARE(m.falseOnes, std::size_t{2});
    QCOMPARE(m.largestFalse, std::size_t{7});
    QCOMPARE(m.mergedVessels, std::size_t{1});
    const Volume<std::uint8_t> nothing(phantom.truth.geometry);
    QCOMPARE(measureComponents(nothing, phantom.truth, phantom.centreLines).components,
             std::size_t{0});
  }

  void axesAreAlike() {
    const Volume<float> phi = analytic::unlikeVessels(true);
    const Geometry& g = phi.geometry;
    CentreLineSegment line;
    line.from = g.toPhysical({0.3 * (g.size[0] - 1), 0.3 * (g.size[1] - 1), 0.3 * (g.size[2] - 1)});
    line.to = analytic::centreOf(g);
    line.radiusFromMm = line.radiusToMm = 1.7;
    CentreLineSegment second = line;
    second.from = line.to;
    second.to =
        g.toPhysical({0.7 * (g.size[0] - 1), 0.61 * (g.size[1] - 1), 0.74 * (g.size[2] - 1)});
    const std::vector<CentreLineSegment> lines{line, second};
    const auto inside = insideMask(phi);
    const auto one = measureComponents(inside, inside, lines);
    const auto other = measureComponents(analytic::turned(inside), analytic::turned(inside), lines);
    QCOMPARE(one.mergedVessels, std::size_t{1});
    QCOMPARE(other.mergedVessels, one.mergedVessels);
    QCOMPARE(centreLineRecall(phi, lines, 0.0), 1.0);
    QCOMPARE(centreLineRecall(analytic::turned(phi), lines, 0.0), 1.0);
    const SplineField field = analytic::fieldOf(phi),
                      turnedField = analytic::fieldOf(analytic::turned(phi));
    const auto distance = [](const Eigen::Vector3d& p) { return p[0] - 0.3 * p[1] + 0.1 * p[2]; };
    QVERIFY(std::fabs(wallDistance(wallSamples(field, distance)).meanMm -
                      wallDistance(wallSamples(turnedField, distance)).meanMm) < 1e-6);
    QVERIFY(std::fabs(tubeRadius(field, line.from, line.to, 2.5) -
                      tubeRadius(turnedField, line.from, line.to, 2.5)) < 1e-6);
  }
};

QTEST_GUILESS_MAIN(TestVesselMeasures)
#include "tst_vessel_measures.moc"
