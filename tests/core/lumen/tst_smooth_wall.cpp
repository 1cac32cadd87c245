// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/distance/mask_distance.h"
#include "core/distance/redistance.h"
#include "core/field/spline_field.h"
#include "core/lumen/local_quadric.h"
#include "core/lumen/smooth_wall.h"
#include "tests/core/analytic.h"
#include "tests/core/bars.h"
#include "tests/core/threads.h"
#include "tests/core/turned_axes.h"

using namespace angiomesh;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr double kLumen = 200.0, kAround = 40.0;
constexpr int kSize = 30;
const Vector3d kAxis = Vector3d(0.25, 0.45, 1.0).normalized();
const Vector3d kCentre{14.6, 14.2, 14.7};

double tubeDistance(const Vector3d& p, double radius) {
  return analytic::tube(p, kCentre, kAxis, radius);
}

/// A point set on the unit ball, evenly by golden angles.
Vector3f onBall(int i, int count) {
  const double z = 1.0 - 2.0 * (i + 0.5) / count, turn = 2.399963229728653 * i;
  const double r = std::sqrt(1.0 - z * z);
  return Vector3d(r * std::cos(turn), r * std::sin(turn), z).cast<float>();
}

/// What a shape looks like through a Gaussian point spread: the mean over 7^3 points that have its
/// moments, of a boundary that is blurred a little already.
template <class Distance>
Volume<float> seen(const Distance& distance, double spread, double noise) {
  constexpr double fine = 0.25;
  const double coarse = std::sqrt(spread * spread - fine * fine);
  // Gauss and Hermite's rule of seven points.
  constexpr std::array<double, 4> node{0.0, 1.154405394739968, 2.366759410734541,
                                       3.750439717725742};
  constexpr std::array<double, 4> weight{0.457142857142857, 0.240123178605013, 0.030757123967586,
                                         0.000548268855972};
  Volume<float> image(analytic::cube(kSize));
  parallelFor(0, image.voxels.size(), 256, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Index3 at = image.geometry.indexOf(i);
      const Vector3d x(at[0], at[1], at[2]);
      double share = distance(x) < 0.0 ? 1.0 : 0.0;
      if (std::fabs(distance(x)) < 4.5 * spread + 0.5) {
        share = 0.0;
        for (int n = 0; n < 343; ++n) {
          Vector3d y = x;
          double w = 1.0;
          for (int a = 0, m = n; a < 3; ++a, m /= 7) {
            const int k = m % 7 - 3;
            const auto which = static_cast<std::size_t>(std::abs(k));
            y[a] += coarse * (k < 0 ? -node[which] : node[which]);
            w *= weight[which];
          }
          share += w * WallProfile::share(distance(y) / fine);
        }
      }
      image.voxels[i] =
          static_cast<float>(kAround + (kLumen - kAround) * share + noise * randomNormal(11, i));
    }
  });
  return image;
}

/// The evidence of an image whose levels are known.
WallEvidence evidenceOf(const Volume<float>& image, const Volume<float>& phi, double noise) {
  WallEvidence evidence;
  Volume<std::uint8_t> found = insideMask(phi);
  evidence.band = bandAround(found, 3);
  for (const std::uint32_t voxel : evidence.band.voxel)
    evidence.value.push_back(image.voxels[voxel]);
  evidence.lumen.assign(evidence.band.size(), static_cast<float>(kLumen));
  evidence.around.assign(evidence.band.size(), static_cast<float>(kAround));
  evidence.noise = noise;
  evidence.meanSteps = 50;
  return evidence;
}

/// A wall half-way between lumen and surroundings, as it is found voxel by voxel.
Volume<float> halfWay(const Volume<float>& image) {
  Volume<float> phi(image.geometry);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    phi.voxels[i] = static_cast<float>(0.5 * (kLumen + kAround)) - image.voxels[i];
  for (float& v : phi.voxels) v /= static_cast<float>(kLumen - kAround);
  return phi;
}

struct WallError {
  double mean = 0.0, spread = 0.0, angle = 0.0;  ///< voxels, degrees
};

/// Of the zero set's crossings with the grid's edges, moved onto it, away from the border.
template <class Distance>
WallError errorOf(const Volume<float>& phi, const Distance& distance) {
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  std::vector<double> off;
  double angles = 0.0;
  const auto add = [&](Vector3d x) {
    if (!field.projectToZero(x)) return;
    off.push_back(distance(x));
    Vector3d slope;
    for (int a = 0; a < 3; ++a) {
      Vector3d h = Vector3d::Zero();
      h[a] = 1e-4;
      slope[a] = distance(x + h) - distance(x - h);
    }
    const double cosine = slope.normalized().dot(field.at(x).gradient.normalized());
    angles += std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / M_PI;
  };
  for (int k = 4; k < kSize - 4; ++k)
    for (int j = 4; j < kSize - 4; ++j)
      for (int i = 4; i < kSize - 4; ++i)
        for (int a = 0; a < 3; ++a)
          if ((phi.at(i, j, k) < 0.0F) != (phi.at(i + (a == 0), j + (a == 1), k + (a == 2)) < 0.0F))
            add({i + 0.5 * (a == 0), j + 0.5 * (a == 1), k + 0.5 * (a == 2)});
  WallError error;
  const auto count = static_cast<double>(off.size());
  for (const double d : off) error.mean += d / count;
  for (const double d : off) error.spread += (d - error.mean) * (d - error.mean) / count;
  error.spread = std::sqrt(error.spread);
  error.angle = angles / count;
  return error;
}

struct Made {
  SmoothWall wall;
  WallError before, after;
};

template <class Distance>
Made make(const Distance& distance, double spread, double noise) {
  const Volume<float> image = seen(distance, spread, noise);
  const Volume<float> phi = redistance(halfWay(image));
  WallEvidence evidence = evidenceOf(image, phi, noise);
  Made made;
  made.wall = smoothWall(phi, &evidence, {});
  made.before = errorOf(phi, distance);
  made.after = errorOf(redistance(made.wall.phi), distance);
  return made;
}

}  // namespace

class TestSmoothWall : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aQuadricMeetsBallsTubesAndPlanes() {
    for (const double radius : {1.3, 4.0}) {
      LocalQuadric ball(2.0), tube(2.0);
      for (int i = 0; i < 300; ++i) {
        const Vector3f n = onBall(i, 300);
        // The place lies 0.2 outside the wall along x.
        const auto r = static_cast<float>(radius);
        const Vector3f place(r + 0.2F, 0.0F, 0.0F);
        ball.add({(r * n - place) / 2.0F, n, 1.0F, 0.0F});
        const Vector3f across = Vector3f(n[0], n[1], 0.0F).normalized();
        tube.add({(r * across + Vector3f(0, 0, 2.0F * n[2]) - place) / 2.0F, across, 1.0F, 0.0F});
      }
      const LocalQuadric::Fit b = ball.solve(0.3), t = tube.solve(0.3);
      QVERIFY(b.found && t.found);
      QVERIFY(std::fabs(b.offset + 0.2) < 1e-3 && std::fabs(t.offset + 0.2) < 1e-3);
      QVERIFY(std::fabs(b.mean * radius - 2.0) < 0.2 && std::fabs(t.mean * radius - 1.0) < 0.1);
      QVERIFY(std::fabs(t.gauss) < 1e-3);
      QCOMPARE(b.weight, 300.0);
    }
    LocalQuadric plane(3.0);
    for (int i = 0; i < 50; ++i) {
      const Vector3f n = onBall(i, 50);
      plane.add({{n[0], n[1], 0.1F}, {0, 0, 1}, 1.0F, 0.0F});
    }
    const LocalQuadric::Fit flat = plane.solve(0.3);
    QVERIFY(std::fabs(flat.offset - 0.3) < 1e-3 && std::fabs(flat.mean) < 1e-4);
    QVERIFY(!LocalQuadric(1.0).solve(0.3).found);
  }

  void targetsMoveAQuadric() {
    LocalQuadric plane(3.0);
    for (int i = 0; i < 50; ++i) {
      const Vector3f n = onBall(i, 50);
      plane.add({{n[0], n[1], 0.0F}, {0, 0, 1}, 1.0F, -0.25F});
    }
    QVERIFY(std::fabs(plane.solve(0.3).offset - 0.25) < 1e-3);
  }

  void findsThePointSpread() {
    for (const double spread : {0.45, 0.8}) {
      const Made made = make([](const Vector3d& p) { return tubeDistance(p, 4.3); }, spread, 4.0);
      QVERIFY(isNear(made.wall.spreadVoxels / spread, 1.0, 0.04));
    }
  }

  /// Every second place tells of another point spread, which does not count without evidence or
  /// contrast, or on a vessel that is too thin while there are enough others.
  void thePointSpreadIsThatOfPlacesThatTell() {
    constexpr double spread = 0.6, otherSpread = 1.2;
    const Volume<float> phi = analytic::clamped(
        analytic::cube(kSize), [](const Vector3d& p) { return tubeDistance(p, 4.3); });
    WallCells cells(phi, 4.5);
    cells.place(analytic::fieldOf(phi), {});
    const std::vector<WallBend> bends(cells.size(), {static_cast<float>(1.0 / 4.3), 0.0F});
    WallEvidence evidence;
    evidence.lumen.assign(cells.size(), static_cast<float>(kLumen));
    evidence.around.assign(cells.size(), static_cast<float>(kAround));
    std::vector<std::uint32_t> number(cells.size());
    std::iota(number.begin(), number.end(), 0U);
    const auto isOther = [](std::size_t n) { return n % 2 == 1; };
    const auto tell = [&](const auto& other) {
      evidence.value.clear();
      for (std::size_t n = 0; n < cells.size(); ++n) {
        const WallProfile profile{other(n) ? otherSpread : spread};
        const double x = profile.argument(static_cast<double>(cells[n].distance), bends[n]);
        evidence.value.push_back(
            static_cast<float>(kAround + (kLumen - kAround) * WallProfile::share(x)));
      }
    };
    const auto withRadii = [&](float one, float other) {
      std::vector<float> radii(cells.size(), one);
      for (std::size_t n = 0; n < radii.size(); ++n)
        if (isOther(n)) radii[n] = other;
      return measureSpread(cells, evidence, number, radii, bends);
    };
    tell([](std::size_t) { return false; });
    QVERIFY(isNear(withRadii(4.3F, 4.3F), spread, 2e-3));
    tell(isOther);
    const double mixed = withRadii(4.3F, 4.3F);
    QVERIFY(mixed > 1.1 * spread && mixed < otherSpread);
    QVERIFY(isNear(withRadii(2.0F, 1.99F), spread, 2e-3));
    QVERIFY(isNear(withRadii(1.2F, 1.19F), spread, 2e-3));
    QVERIFY(isNear(withRadii(1.99F, 1.2F), mixed, 2e-3));
    QCOMPARE(withRadii(1.19F, 0.0F), 0.0);
    const std::vector<std::uint32_t> all = number;
    for (std::size_t n = 0; n < number.size(); ++n)
      if (isOther(n)) number[n] = kNoEvidence;
    QVERIFY(isNear(withRadii(4.3F, 4.3F), spread, 2e-3));
    // Where thick vessels are too few, their places count as much as those of thin ones.
    std::size_t one = 0, other = 0;
    for (std::size_t n = 0; n < number.size(); ++n) {
      std::size_t& count = isOther(n) ? other : one;
      const bool kept = std::fabs(cells[n].distance) < 1.9F && count++ < 150;
      number[n] = kept ? all[n] : kNoEvidence;
    }
    QCOMPARE(withRadii(1.5F, 4.3F), withRadii(1.5F, 1.5F));
    number = all;
    for (const float dark : {0.0F, 1.0F}) {
      for (std::size_t n = 0; n < number.size(); ++n)
        if (isOther(n)) evidence.lumen[n] = (evidence.value[n] = evidence.around[n]) - dark;
      QVERIFY(isNear(withRadii(4.3F, 4.3F), spread, 2e-3));
    }
    // Too few.
    std::fill(number.begin() + 40, number.end(), kNoEvidence);
    QCOMPARE(withRadii(4.3F, 4.3F), 0.0);
  }

  void aTubeIsAsSmoothAsATube_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("noise");
    QTest::addColumn<double>("mean");
    QTest::addColumn<double>("spread");
    QTest::addColumn<double>("angle");
    QTest::newRow("thin") << 1.4 << 0.0 << 0.02 << 0.025 << 3.2;
    QTest::newRow("thick") << 5.2 << 0.0 << 0.01 << 0.006 << 0.4;
    QTest::newRow("thin, noisy") << 1.4 << 12.0 << 0.04 << 0.06 << 4.0;
    QTest::newRow("thick, noisy") << 5.2 << 12.0 << 0.02 << 0.035 << 2.0;
  }
  void aTubeIsAsSmoothAsATube() {
    QFETCH(double, radius);
    QFETCH(double, noise);
    QFETCH(double, mean);
    QFETCH(double, spread);
    QFETCH(double, angle);
    const Made made =
        make([radius](const Vector3d& p) { return tubeDistance(p, radius); }, 0.5, noise);
    const QString found = QString("mean %1 spread %2 angle %3")
                              .arg(made.after.mean)
                              .arg(made.after.spread)
                              .arg(made.after.angle);
    QVERIFY2(std::fabs(made.after.mean) < mean, qPrintable(found));
    QVERIFY2(made.after.spread < spread, qPrintable(found));
    QVERIFY2(made.after.angle < angle, qPrintable(found));
    if (noise == 0.0) return;
    QVERIFY2(made.after.spread < 0.7 * made.before.spread, qPrintable(found));
    QVERIFY2(made.after.angle < 0.6 * made.before.angle, qPrintable(found));
  }

  // A ball on a tube: the crease between them is not filled.
  void aNeckStays() {
    const auto shape = [](const Vector3d& p) {
      const Vector3d ball = kCentre + 7.0 * kAxis.cross(Vector3d::UnitX()).normalized();
      return std::min(tubeDistance(p, 3.5), (p - ball).norm() - 5.0);
    };
    const Made made = make(shape, 0.5, 10.0);
    QVERIFY(made.after.spread < 1.15 * made.before.spread);
    QCOMPARE(connectedComponents(insideMask(made.wall.phi)).sizes.size(), std::size_t{1});
  }

  void vesselsThatNearlyTouchStayApart() {
    const auto shape = [](const Vector3d& p) {
      const Vector3d aside = 2.6 * kAxis.cross(Vector3d::UnitX()).normalized();
      return std::min(tubeDistance(p + aside, 1.9), tubeDistance(p - aside, 1.9));
    };
    const Made made = make(shape, 0.5, 6.0);
    QCOMPARE(connectedComponents(insideMask(made.wall.phi)).sizes.size(), std::size_t{2});
    QVERIFY(std::fabs(made.after.mean) < 0.03);
    QVERIFY(made.after.spread < 0.06);
  }

  void aMaskIsSmoothedWithoutAnImage() {
    const auto tube = [](const Vector3d& p) { return tubeDistance(p, 3.3); };
    Volume<float> phi(analytic::cube(kSize));
    for (std::size_t i = 0; i < phi.voxels.size(); ++i) {
      const Index3 p = phi.geometry.indexOf(i);
      const double rough = tube(Vector3d(p[0], p[1], p[2])) + 0.25 * randomNormal(3, i);
      phi.voxels[i] = static_cast<float>(rough);
    }
    phi = redistance(phi);
    const SmoothWall wall = smoothWall(phi, nullptr, {});
    QCOMPARE(wall.spreadVoxels, 0.0);
    const WallError before = errorOf(phi, tube), after = errorOf(redistance(wall.phi), tube);
    QVERIFY(after.spread < 0.6 * before.spread);
    QVERIFY(after.angle < 0.4 * before.angle);
  }

  void aMaskKeepsTheVesselsThickness() {
    for (const double radius : {1.3, 2.0, 3.3}) {
      const auto tube = [&](const Vector3d& p) { return tubeDistance(p, radius); };
      Volume<std::uint8_t> mask(analytic::cube(kSize));
      for (std::size_t i = 0; i < mask.voxels.size(); ++i) {
        const Index3 p = mask.geometry.indexOf(i);
        mask.voxels[i] = tube(Vector3d(p[0], p[1], p[2])) < 0.0 ? 1 : 0;
      }
      const Volume<float> phi = distanceOfMask(mask).phi;
      const WallError before = errorOf(phi, tube);
      const WallError after = errorOf(redistance(smoothWall(phi, nullptr, {}).phi), tube);
      QVERIFY(isNear(after.mean, 0.0, 0.03));
      QVERIFY(isBelow(after.spread, 0.7 * before.spread));
      QVERIFY(isBelow(after.angle, 0.4 * before.angle));
    }
  }

  void isTheSameForAnyNumberOfThreads() {
    const auto tube = [](const Vector3d& p) { return tubeDistance(p, 2.2); };
    const int before = threads();
    const auto [one, two] = onOneAndSeveralThreads([&] { return make(tube, 0.5, 10.0); });
    setThreads(before);
    QVERIFY(one.wall.phi.voxels == two.wall.phi.voxels);
    QCOMPARE(one.wall.spreadVoxels, two.wall.spreadVoxels);
  }

  void canBeCancelled() {
    const Volume<float> phi = analytic::sampled(
        analytic::cube(kSize), [](const Vector3d& p) { return tubeDistance(p, 3.0); });
    Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, (void)smoothWall(phi, nullptr, {}, progress));
  }

  void axesAreAlike() {
    for (const bool fewAlongLast : {true, false}) {
      const Volume<std::uint8_t> mask = insideMask(analytic::unlikeVessels(fewAlongLast));
      const Volume<float> phi = distanceOfMask(mask).phi;
      const SmoothWall one = smoothWall(phi, nullptr, {});
      const SmoothWall other = smoothWall(analytic::turned(phi), nullptr, {});
      const double most = analytic::mostApart(analytic::turned(one.phi), other.phi);
      QVERIFY2(most < 0.02, qPrintable(QString::number(most)));
      QCOMPARE(one.heldVoxels, other.heldVoxels);
    }
  }
};

QTEST_GUILESS_MAIN(TestSmoothWall)
#include "tst_smooth_wall.moc"
