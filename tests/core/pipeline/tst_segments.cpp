// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "core/pipeline/segments.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"

using namespace angiomesh;
using namespace angiomesh::analytic;
using Eigen::Vector3d;

namespace {

constexpr double kRadius = 8.0;
const Geometry kGrid = cube(48);
const Vector3d kCentre(17.3, 21.7, 22.4);

/// Two balls, a smaller one beside that at kCentre, its wall so many voxels off.
Volume<float> twoBalls(double gap) {
  const double radius = 0.75 * kRadius;
  const Vector3d small = kCentre + (kRadius + gap + radius) * Vector3d(1.0, 0.3, 0.15).normalized();
  return clamped(kGrid, [&](const Vector3d& x) {
    return std::min(ball(x, kCentre, kRadius), ball(x, small, radius));
  });
}

}  // namespace

class TestSegments : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsKeptStaysWhereItWas_data() {
    QTest::addColumn<double>("gap");
    for (const double gap : {1.6, 3.0, 8.0}) QTest::addRow("%g voxels apart", gap) << gap;
  }
  void whatIsKeptStaysWhereItWas() {
    QFETCH(const double, gap);
    SegmentationParams params;
    params.keep = KeepComponents::Largest;
    const auto phi = std::make_shared<const Volume<float>>(twoBalls(gap));
    const Segments segments = selectSegments(*phi, params, {}, {});
    QCOMPARE(segments.components.size(), std::size_t{2});
    const auto kept = withoutDropped(phi, segments, {});
    double worst = 0.0;
    for (std::size_t n = 0; n < kept->voxels.size(); ++n) {
      const Index3 p = kGrid.indexOf(n);
      const double truth = ball(Vector3d(p[0], p[1], p[2]), kCentre, kRadius);
      QCOMPARE(kept->voxels[n] < 0.0F, truth < 0.0);
      if (std::fabs(truth) < 1.0)
        worst = std::max(worst, std::fabs(static_cast<double>(kept->voxels[n]) - truth));
    }
    QVERIFY(isBelow(worst, 0.12));
  }

  void shortPartsAreLeftOutHoweverThick() {
    // A rod of 30 voxels, and a ball that holds more.
    const Volume<float> phi = clamped(kGrid, [](const Vector3d& x) {
      const Vector3d along(0.0, 0.0, std::clamp(x.z(), 8.0, 38.0));
      const double rod = (x - Vector3d(38.0, 38.0, 0.0) - along).norm() - 2.5;
      return std::min(rod, ball(x, {16.0, 16.0, 24.0}, 11.0));
    });
    SegmentationParams params;
    QVERIFY(keepsAll(params));
    params.minLengthMm = 20.0;
    QVERIFY(!keepsAll(params));
    const Segments segments = selectSegments(phi, params, {}, {});
    QCOMPARE(segments.components.size(), std::size_t{2});
    QVERIFY(segments.components[0].volumeMm3 > 2.0 * segments.components[1].volumeMm3);
    QVERIFY(!segments.components[0].kept && segments.components[1].kept);
    params.minLengthMm = 40.0;
    QVERIFY_THROWS_EXCEPTION(NumericError, selectSegments(phi, params, {}, {}));
  }

  void allIsKeptUnlessAskedFor() {
    const auto phi = std::make_shared<const Volume<float>>(twoBalls(4.0));
    const Segments segments = selectSegments(*phi, {}, {}, {});
    QVERIFY(keepsAll({}));
    QCOMPARE(withoutDropped(phi, segments, {}).get(), phi.get());
    SegmentationParams params;
    params.minVolumeMm3 = 1e6;
    QVERIFY(!keepsAll(params));
    QVERIFY_THROWS_EXCEPTION(NumericError, selectSegments(*phi, params, {}, {}));
  }
};

QTEST_GUILESS_MAIN(TestSegments)
#include "tst_segments.moc"
