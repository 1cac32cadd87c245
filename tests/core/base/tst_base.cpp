// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <atomic>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/random.h"

using namespace angiomesh;

class TestBase : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Against the library in long double, at even steps and at random.
  void portableMathAgreesWithTheLibrary() {
    const auto everywhere = [](double from, double to, auto agrees) {
      const int n = 100000;
      for (int i = 0; i < n; ++i)
        for (const double t : {(i + 0.5) / n, randomUniform(11, static_cast<std::uint64_t>(i))})
          if (!agrees(from + t * (to - from))) return false;
      return true;
    };
    const auto ulps = [](double got, long double wanted) {
      return std::fabs(got - wanted) / std::ldexp(1.0L, std::ilogb(wanted) - 52);
    };
    const long double turn = 2.0L * std::acos(-1.0L);
    const auto exponential = [&](double x) {
      return ulps(portableExp(x), std::exp(1.0L * x)) < 1.5L;
    };
    QVERIFY(everywhere(-700.0, 700.0, exponential));
    QVERIFY(everywhere(-1.0, 1.0, exponential));
    const auto logarithm = [&](double x) {
      return ulps(portableLog(x), std::log(1.0L * x)) < 3.0L;
    };
    const auto root = [&](double x) {
      return ulps(portableCubeRoot(x), std::cbrt(1.0L * x)) < 1.0L;
    };
    for (const double most : {2.0, 1e-300, 1e-3, 1e3, 1e300}) {
      QVERIFY(everywhere(0.01 * most, most, logarithm));
      QVERIFY(everywhere(0.01 * most, most, root));
    }
    QVERIFY(everywhere(0.9, 1.1, logarithm));
    for (const double reach : {0.2, 3.0, 1e6})
      QVERIFY(everywhere(-reach, reach, [&](double x) {
        const long double angle = turn * (x - std::floor(1.0L * x));
        const long double rounding = std::fabs((x - 0.25) - (x - 0.25L));
        return std::fabs(portableCosTurns(x) - std::cos(angle)) < 2.5e-16L &&
               std::fabs(portableSinTurns(x) - std::sin(angle)) < 2.5e-16L + turn * rounding;
      }));
    QCOMPARE(portableExp(0.0), 1.0);
    QCOMPARE(portableLog(1.0), 0.0);
    QCOMPARE(portableSinTurns(0.0), 0.0);
    QCOMPARE(portableCosTurns(0.25), 0.0);
    for (const double x : {0.25, 0.3, 0.5, 3.0}) QCOMPARE(portableCubeRoot(x * x * x), x);
  }

  void normalNumbersHaveTheMomentsOfTheNormalDistribution() {
    const int n = 200000;
    double sum = 0.0;
    double square = 0.0;
    double fourth = 0.0;
    for (int i = 0; i < n; ++i) {
      const double z = randomNormal(7, static_cast<std::uint64_t>(i));
      sum += z;
      square += z * z;
      fourth += z * z * z * z;
    }
    QVERIFY(std::fabs(sum / n) < 0.01);
    QVERIFY(std::fabs(square / n - 1.0) < 0.02);
    QVERIFY(std::fabs(fourth / n - 3.0) < 0.1);
    QVERIFY(randomBits(1, 0) != randomBits(1, 1));
    QVERIFY(randomBits(1, 0) != randomBits(2, 0));
  }

  void progressOnlyGrowsAndSplits() {
    const Progress whole;
    const Progress second = whole.sub(0.5, 1.0);
    second.report(0.5);
    QCOMPARE(whole.fraction(), 0.75);
    whole.report(0.1);
    QCOMPARE(whole.fraction(), 0.75);
    // Parts of parts.
    const Progress other;
    const Progress middle = other.sub(0.2, 0.6);
    middle.sub(0.25, 0.75).report(0.0);
    QVERIFY(std::fabs(other.fraction() - 0.3) < 1e-12);
    middle.sub(0.25, 0.75).report(1.0);
    QVERIFY(std::fabs(other.fraction() - 0.5) < 1e-12);
    middle.sub(0.5, 1.0).report(1.0);
    QVERIFY(std::fabs(other.fraction() - 0.6) < 1e-12);
    whole.cancel();
    QVERIFY(second.cancelled());
    QVERIFY_THROWS_EXCEPTION(Cancelled, second.report(0.9));
  }

  void parallelForVisitsEachItemOnceAndPassesExceptionsOn() {
    std::vector<std::atomic<int>> visits(1001);
    parallelFor(1, 1001, 7, [&](std::size_t first, std::size_t last) {
      QVERIFY((first - 1) % 7 == 0);
      for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    QCOMPARE(visits[0].load(), 0);
    for (std::size_t i = 1; i < 1001; ++i) QCOMPARE(visits[i].load(), 1);
    QVERIFY_THROWS_EXCEPTION(
        Cancelled, parallelFor(0, 100, 1, [](std::size_t, std::size_t) { throw Cancelled(); }));
  }

  void errorsAreOneLine() {
    const IoError error("cannot read\nthe file", "a.mha", "check the name");
    QCOMPARE(std::string(error.what()), std::string("cannot read the file, a.mha: check the name"));
  }

  void placesAreNamedBySide() {
    QCOMPARE(placeText({12.34, 4.12, 30.0}), std::string("L 12.3 P 4.1 S 30.0 mm"));
    QCOMPARE(placeText({-12.34, -4.12, -30.0}), std::string("R 12.3 A 4.1 I 30.0 mm"));
  }
};

QTEST_GUILESS_MAIN(TestBase)
#include "tst_base.moc"
