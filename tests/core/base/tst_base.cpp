// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <atomic>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/base/random.h"

using namespace angiomesh;

class TestBase : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void portableMathAgreesWithTheLibrary() {
    for (double x = -700.0; x < 700.0; x += 0.37)
      QVERIFY(std::fabs(portableExp(x) / std::exp(x) - 1.0) < 1e-13);
    QCOMPARE(portableExp(0.0), 1.0);
    for (double x = 1e-12; x < 1e12; x *= 1.37)
      QVERIFY(std::fabs(portableLog(x) - std::log(x)) <
              1e-14 * std::max(1.0, std::fabs(std::log(x))));
    for (double x = -3.0; x < 3.0; x += 0.0137) {
      QVERIFY(std::fabs(portableCosTurns(x) - std::cos(2.0 * M_PI * x)) < 1e-14);
      QVERIFY(std::fabs(portableSinTurns(x) - std::sin(2.0 * M_PI * x)) < 1e-14);
    }
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
    whole.cancel();
    QVERIFY(second.cancelled());
    QVERIFY_EXCEPTION_THROWN(second.report(0.9), Cancelled);
  }

  void parallelForVisitsEachItemOnceAndPassesExceptionsOn() {
    std::vector<std::atomic<int>> visits(1001);
    parallelFor(1, 1001, 7, [&](std::size_t first, std::size_t last) {
      QVERIFY((first - 1) % 7 == 0);
      for (std::size_t i = first; i < last; ++i) ++visits[i];
    });
    QCOMPARE(visits[0].load(), 0);
    for (std::size_t i = 1; i < 1001; ++i) QCOMPARE(visits[i].load(), 1);
    QVERIFY_EXCEPTION_THROWN(
        parallelFor(0, 100, 1, [](std::size_t, std::size_t) { throw Cancelled(); }), Cancelled);
  }

  void errorsAreOneLine() {
    const IoError error("cannot read\nthe file", "a.mha", "check the name");
    QCOMPARE(std::string(error.what()), std::string("cannot read the file, a.mha: check the name"));
  }
};

QTEST_GUILESS_MAIN(TestBase)
#include "tst_base.moc"
