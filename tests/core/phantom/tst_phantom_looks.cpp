// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/appearance.h"
#include "core/phantom/phantom.h"
#include "core/phantom/shape.h"
#include "core/phantom/truth_json.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using analytic::paramsOf;
using Eigen::Vector3d;

namespace {

double meanOf(const Volume<float>& image) {
  double sum = 0.0;
  for (const float v : image.voxels) sum += v;
  return sum / static_cast<double>(image.voxels.size());
}

Phantom cluttered(PhantomParams params) {
  params.clutter = true;
  return makePhantom(params);
}

}  // namespace

class TestPhantomLooks : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void driftIsAFactorThatReachesBothExtremes() {
    for (const std::uint64_t seed : {1, 2, 3, 4}) {
      PhantomParams params = paramsOf(PhantomKind::Tube, 64);
      params.randomSeed = seed;
      params.clutter = true;  // its slabs make a background that is not 0
      const Phantom flat = makePhantom(params);
      params.driftPercent = 40.0;
      const Phantom drifted = makePhantom(params);
      QVERIFY(drifted.truth.voxels == flat.truth.voxels);
      const Geometry& g = flat.image.geometry;
      double least = 2.0;
      double most = 0.0;
      for (int k = 16; k + 1 < g.size[2]; ++k)
        for (int j = 0; j + 1 < g.size[1]; ++j)
          for (int i = 0; i + 1 < g.size[0]; ++i) {
            const auto ratio = [&](int di) {
              return static_cast<double>(drifted.image.at(i + di, j, k)) /
                     static_cast<double>(flat.image.at(i + di, j, k));
            };
            least = std::min(least, ratio(0));
            most = std::max(most, ratio(0));
            // The steepest slope is 0.4 * 3/2 pi over the side.
            QVERIFY(std::fabs(ratio(1) - ratio(0)) < 0.4 * 1.5 * M_PI / 64.0 + 1e-5);
          }
      QVERIFY2(least > 0.5999 && least < 0.603, QByteArray::number(least));
      QVERIFY2(most < 1.4001 && most > 1.397, QByteArray::number(most));
    }
  }

  void fadeFallsLinearlyAlongTheAxis() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 48);
    const Phantom flat = makePhantom(params);
    params.fadePercent = 60.0;
    const Phantom faded = makePhantom(params);
    QVERIFY(faded.truth.voxels == flat.truth.voxels);
    for (int k = 3; k < 45;
         ++k) {  // the point spread sees beyond the ends, where it stays as it is
      const double expected = 255.0 * (1.0 - 0.4 * (k + 0.5) / 48.0);
      QVERIFY(std::fabs(static_cast<double>(faded.image.at(24, 24, k)) - expected) < 1e-3);
    }
    params.kind = PhantomKind::Torus;  // along a diameter
    const Phantom torus = makePhantom(params);
    float least = 255.0F;
    float most = 0.0F;
    for (std::size_t i = 0; i < torus.truth.voxels.size(); ++i) {
      if (torus.truth.voxels[i] == 0) continue;
      most = std::max(most, torus.image.voxels[i]);
      if (torus.image.voxels[i] > 128.0F * 0.6F) least = std::min(least, torus.image.voxels[i]);
    }
    QVERIFY(most > 250.0F && most <= 255.0F);
    QVERIFY(least < 128.0F);
  }

  void everyTipOfATreeFadesAlikeAndNoBifurcationIsAStep() {
    PhantomParams params = paramsOf(PhantomKind::Tree, 96);
    params.radiusMin = 2.0;  // whole voxels of vessel on every centre line
    params.volumePercent = 3.0;
    const Phantom flat = makePhantom(params);
    params.fadePercent = 50.0;
    const Phantom faded = makePhantom(params);
    QVERIFY(faded.truth.voxels == flat.truth.voxels);
    const auto brightness = [&](const Vector3d& p) {
      Index3 at;
      for (int a = 0; a < 3; ++a)
        at[a] = std::clamp(static_cast<int>(std::lround(p[a])), 0, params.size[a] - 1);
      return static_cast<double>(faded.image.at(at[0], at[1], at[2])) /
             static_cast<double>(flat.image.at(at[0], at[1], at[2]));
    };
    const auto& lines = faded.centreLines;
    std::vector<int> children(lines.size(), 0);
    for (const CentreLineSegment& s : lines)
      if (s.parent >= 0) ++children[static_cast<std::size_t>(s.parent)];
    int tips = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const CentreLineSegment& s = lines[i];
      const double atEnd = brightness(s.to);
      QVERIFY(atEnd > 0.499 && atEnd < 1.0);
      if (children[i] == 0) {
        ++tips;
        QVERIFY(isBelow(atEnd, 0.53));
      }
      const Vector3d step = (s.to - s.from).normalized();
      const double length = (s.to - s.from).norm();
      const double slope = std::fabs(atEnd - brightness(s.from)) / length;
      for (double t = 1.0; t + 1.0 < length; t += 1.0) {
        const double change =
            std::fabs(brightness(s.from + t * step) - brightness(s.from + (t + 1.0) * step));
        QVERIFY(isBelow(change, 3.0 * slope + 0.03));  // at whole voxels
      }
    }
    QVERIFY(tips > 3);
  }

  // From the root to the tip that is farthest along the vessels; sooner in shorter branches.
  void fadeIsLinearAlongTheLongestWay() {
    for (const PhantomKind kind : {PhantomKind::Tree, PhantomKind::VesselTree}) {
      PhantomParams params = paramsOf(kind, 96);
      params.fadePercent = 50.0;
      const Shape shape = makeShape(params);
      const auto& lines = shape.centreLines;
      std::vector<double> end(lines.size(), 0.0);  // along the vessels, from the root
      std::size_t last = 0;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        end[i] = (lines[i].to - lines[i].from).norm();
        if (lines[i].parent >= 0) end[i] += end[static_cast<std::size_t>(lines[i].parent)];
        if (end[i] > end[last]) last = i;
      }
      const VesselFade fade(params, shape);
      int passed = 0;
      for (int i = static_cast<int>(last); i >= 0; ++passed) {
        const auto at = static_cast<std::size_t>(i);
        QVERIFY(isNear(fade.at(lines[at].to), 1.0 - 0.5 * end[at] / end[last], 0.01));
        i = lines[at].parent;
      }
      QVERIFY(passed > 3);
    }
  }

  void ricianNoiseHasItsMeanInTheBackgroundAndInTheLumen() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 64, 12.0);
    const Phantom clean = makePhantom(params);
    params.noiseSigma = 20.0;
    params.noiseModel = NoiseModel::Rician;
    setThreads(1);
    const Phantom noisy = makePhantom(params);
    setThreads(2);
    QVERIFY(makePhantom(params).image.voxels == noisy.image.voxels);
    std::map<float, std::vector<double>> values;
    for (std::size_t i = 0; i < clean.image.voxels.size(); ++i) {
      QVERIFY(noisy.image.voxels[i] >= 0.0F);
      values[clean.image.voxels[i]].push_back(static_cast<double>(noisy.image.voxels[i]));
    }
    const auto mean = [](const std::vector<double>& list) {
      double sum = 0.0;
      for (const double v : list) sum += v;
      return sum / static_cast<double>(list.size());
    };
    QVERIFY(std::fabs(mean(values[0.0F]) - 20.0 * std::sqrt(M_PI / 2.0)) < 0.2);
    // Far above the noise: sqrt(A^2 + sigma^2) to second order.
    QVERIFY(std::fabs(mean(values[255.0F]) - std::sqrt(255.0 * 255.0 + 400.0)) < 0.6);
  }

  void clutterKeepsClearOfTheVesselsExceptForTheBone() {
    for (const PhantomKind kind : {PhantomKind::Tree, PhantomKind::Helix}) {
      const PhantomParams params = paramsOf(kind, 96);
      const Phantom plain = makePhantom(params);
      const Phantom phantom = cluttered(params);
      QVERIFY(phantom.truth.voxels == plain.truth.voxels);
      const Volume<float> field = phantomField(params);
      std::map<int, std::size_t> voxels;
      std::map<int, double> nearest;
      for (std::size_t i = 0; i < field.voxels.size(); ++i) {
        const int label = phantom.clutter.voxels[i];
        if (label == 0) continue;
        QCOMPARE(phantom.truth.voxels[i], std::uint8_t{0});
        ++voxels[label];
        const auto [place, isNew] = nearest.try_emplace(label, 1e9);
        place->second = std::min(place->second, static_cast<double>(field.voxels[i]));
      }
      QCOMPARE(voxels.size(), std::size_t{5});
      for (const int label : {1, 2, 3}) QVERIFY(nearest[label] > 2.5);
      QVERIFY(nearest[5] > 1.0 && nearest[5] < 3.0);   // runs beside an artery
      QVERIFY(nearest[4] > -0.3 && nearest[4] < 1.0);  // touches
      QCOMPARE(phantom.pieces.size(), std::size_t{11});
      for (const ClutterPiece& piece : phantom.pieces)
        QCOMPARE(piece.segment >= 0, piece.kind == "bone" || piece.kind == "vein");
    }
  }

  void clutterHasItsSizesAndSteps() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 96);
    params.axis = {1.0, 1.0, 0.3};
    const Phantom phantom = cluttered(params);
    const Geometry& g = phantom.image.geometry;
    double blobs = 0.0;
    for (const ClutterPiece& piece : phantom.pieces) {
      if (piece.kind == "blob") {
        blobs += M_PI / 6.0 * std::pow(piece.to[0] - piece.from[0], 3);
        // To be taken for a vessel, which has 255.
        QVERIFY(piece.intensity >= 180.0 && piece.intensity <= 255.0);
      }
      if (piece.kind != "slab") continue;
      const int k = static_cast<int>(std::lround(0.5 * (piece.from[2] + piece.to[2])));
      QCOMPARE(phantom.image.at(0, g.size[1] - 1, k), static_cast<float>(piece.intensity));
    }
    QVERIFY(std::fabs(blobs / (M_PI / 6.0 * (15.0 * 15.0 * 15.0 + 2.0 * 125.0)) - 1.0) < 1e-6);
    const auto count = [&](std::uint8_t label) {
      return static_cast<double>(
          std::count(phantom.clutter.voxels.begin(), phantom.clutter.voxels.end(), label));
    };
    QVERIFY(std::fabs(count(3) / blobs - 1.0) < 0.12);
    QVERIFY(std::fabs(count(2) / (24.0 * 24.0 * 2.0) - 1.0) < 0.25);
    // The shell is 3 mm thick, half of it and more on the way out from the middle of a face.
    int thick = 0;
    for (int i = 0; i < g.size[0] / 2; ++i) thick += phantom.clutter.at(i, 48, 80) == 1 ? 1 : 0;
    QVERIFY(thick >= 3 && thick <= 4);
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j) QCOMPARE(phantom.clutter.at(0, j, k), std::uint8_t{0});
    // The bone is brighter than any vessel.
    QVERIFY(*std::max_element(phantom.image.voxels.begin(), phantom.image.voxels.end()) > 390.0F);
  }

  /// It runs beside a vessel where nothing else is in its way.
  void aVeinIsDrawnAlongAllOfItsLength() {
    for (const PhantomKind kind :
         {PhantomKind::Tree, PhantomKind::Bifurcation, PhantomKind::CapsuleTree}) {
      const PhantomParams params = paramsOf(kind, 96);
      const Phantom phantom = cluttered(params);
      const auto vein = std::find_if(phantom.pieces.begin(), phantom.pieces.end(),
                                     [](const ClutterPiece& p) { return p.kind == "vein"; });
      QVERIFY(vein != phantom.pieces.end());
      const CentreLineSegment& beside =
          phantom.centreLines[static_cast<std::size_t>(vein->segment)];
      const double radius = 0.5 * (beside.radiusFromMm + beside.radiusToMm);
      const double length = (vein->to - vein->from).norm();
      const double volume = M_PI * radius * radius * (length + 4.0 / 3.0 * radius);
      const auto drawn = static_cast<double>(
          std::count(phantom.clutter.voxels.begin(), phantom.clutter.voxels.end(), vein->label));
      QVERIFY(isNear(drawn / volume, 1.0, 0.15));
    }
  }

  void clutterDependsOnTheSeedAndNotOnTheThreads() {
    PhantomParams params = paramsOf(PhantomKind::Tree, 64);
    params.noiseSigma = 20.0;
    params.driftPercent = 30.0;
    params.fadePercent = 70.0;
    const auto [one, two] = onOneAndSeveralThreads([&] { return cluttered(params); });
    QVERIFY(one.image.voxels == two.image.voxels);
    QVERIFY(one.clutter.voxels == two.clutter.voxels);
    params.kind = PhantomKind::Torus;
    const Phantom first = cluttered(params);
    params.randomSeed = 2;
    QVERIFY(cluttered(params).clutter.voxels != first.clutter.voxels);
    const std::string json = truthJson(params, first);
    for (const char* key : {"\"clutter\"", "\"kind\": \"vein\"", "\"kind\": \"bone\"",
                            "\"kind\": \"slab\"", "\"centre_line\"", "\"drift_percent\": 30.0"})
      QVERIFY2(json.find(key) != std::string::npos, key);
  }

  void everyKindTakesEveryLook() {
    for (std::size_t kind = 0; kind < phantomKindNames().size(); ++kind)
      for (const Vector3d& spacing : {Vector3d(1.0, 1.0, 1.0), Vector3d(0.8, 0.8, 1.2)}) {
        PhantomParams params = paramsOf(static_cast<PhantomKind>(kind), 64);
        params.spacingMm = spacing;
        const Phantom plain = makePhantom(params);
        params.driftPercent = 40.0;
        params.fadePercent = 60.0;
        params.noiseSigma = 10.0;
        params.noiseModel = NoiseModel::Rician;
        const Phantom looks = cluttered(params);
        QVERIFY(looks.truth.voxels == plain.truth.voxels);
        QVERIFY(std::isfinite(meanOf(looks.image)));
        QVERIFY(meanOf(looks.image) > meanOf(plain.image));
      }
  }

  void looksThatCannotBeMetAreRefused() {
    const auto refused = [](const std::function<void(PhantomParams&)>& change) {
      return analytic::isRefused(paramsOf(PhantomKind::Tube, 48), change);
    };
    QVERIFY(!refused([](PhantomParams&) {}));
    QVERIFY(refused([](PhantomParams& p) { p.driftPercent = -1.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.driftPercent = 100.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.fadePercent = 0.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.fadePercent = 120.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.noiseSigma = std::nan(""); }));
    QVERIFY(refused([](PhantomParams& p) {
      p.clutter = true;
      p.spacingMm = {0.5, 0.5, 0.5};
    }));
  }
};

QTEST_GUILESS_MAIN(TestPhantomLooks)
#include "tst_phantom_looks.moc"
