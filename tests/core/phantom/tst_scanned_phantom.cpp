// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/phantom.h"
#include "core/phantom/rasterise.h"
#include "core/phantom/truth_json.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using Eigen::Vector3d;

namespace {

/// Seen through the default point spread.
PhantomParams paramsOf(PhantomKind kind, int side, double radius = 4.0) {
  PhantomParams params = analytic::paramsOf(kind, side, radius);
  params.psf = {};
  return params;
}

Geometry gridOf(int side, const Vector3d& spacing = Vector3d::Ones()) {
  Geometry g;
  g.size = {side, side, side};
  g.spacing = spacing;
  return g;
}

Shape ballOf(const Vector3d& centre, double radius) {
  Shape shape;
  shape.solids.emplace_back(RoundCone(centre, centre, radius, radius));
  return shape;
}

double volumeOf(const PartialVolumes& volumes) {
  double sum = 0.0;
  for (std::size_t i = 0; i < volumes.state.size(); ++i) sum += volumes.share(i);
  return sum * volumes.grid.voxelVolumeMm3();
}

/// The mean of a half-space that ends at `wall` over a voxel, blurred: by the rectangle rule.
double blurredStep(double wall, double sigma) {
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps - 0.5;
    sum += 0.5 * std::erfc((x - wall) / (sigma * std::sqrt(2.0)));
  }
  return sum / steps;
}

PhantomParams withPsf(PhantomParams params, const std::string& psf) {
  params.psf = pointSpreadFromText(psf);
  return params;
}

}  // namespace

class TestScannedPhantom : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  /// A ball of the thinnest vessels' radius, wherever it lies, has its volume.
  void partialVolumesHoldTheShapesVolume() {
    for (const double radius : {1.3, 2.0, 5.0})
      for (const Vector3d& move : {Vector3d(0, 0, 0), Vector3d(0.5, 0.5, 0.5),
                                   Vector3d(0.21, 0.37, 0.44), Vector3d(0.5, 0.1, 0)}) {
        const Vector3d centre = Vector3d::Constant(7.0) + move;
        const double expected = 4.0 / 3.0 * M_PI * radius * radius * radius;
        const double found = volumeOf(partialVolumes(ballOf(centre, radius), gridOf(16)));
        // As a shift of the wall, voxels.
        const double shift = (found - expected) / (4.0 * M_PI * radius * radius);
        QVERIFY(isNear(shift, 0.0, 5e-4));
      }
  }

  /// No staircase: along a wall that leans against the voxels every voxel has its exact share.
  void aPlaneFillsVoxelsExactly() {
    for (const Vector3d& way : {Vector3d(0, 0, 1), Vector3d(1, 1, 0), Vector3d(0.3, -0.7, 1.1)}) {
      const Vector3d normal = way.normalized();
      const Vector3d on(7.3, 7.45, 7.6);
      const Geometry g = gridOf(15, {1.0, 1.3, 0.8});
      const Shape plane = ballOf(on - 1e7 * normal, 1e7);
      const PartialVolumes volumes = partialVolumes(plane, g);
      constexpr int fine = 24;
      for (int k = 4; k < 11; ++k)
        for (int j = 4; j < 11; ++j)
          for (int i = 4; i < 11; ++i) {
            const Vector3d centre = g.toPhysical(Vector3d(i, j, k));
            if (std::fabs((centre - on).dot(normal)) > 1.0) continue;
            double inside = 0.0;
            for (int n = 0; n < fine * fine * fine; ++n) {
              const Vector3d at((n % fine + 0.5) / fine - 0.5, (n / fine % fine + 0.5) / fine - 0.5,
                                (n / fine / fine + 0.5) / fine - 0.5);
              // Each sample's own box, along the normal.
              const double depth = (on - centre - g.spacing.cwiseProduct(at)).dot(normal);
              const double box = g.spacing.cwiseProduct(normal).cwiseAbs().sum() / fine;
              inside += std::clamp(0.5 + depth / box, 0.0, 1.0);
            }
            inside /= fine * fine * fine;
            const double share = volumes.share(g.offset(i, j, k));
            QVERIFY(isNear(share, inside, 2e-3));
          }
    }
  }

  /// Across a wide tube's wall, at any place in a voxel, the image is the wall's exact blur: the
  /// staircase of any rasterisation is below 0.2 % of the contrast.
  void aGaussianPointSpreadIsExact() {
    for (const double sigma : {0.3, 0.5, 1.2})
      for (const double offset : {0.0, 0.13, 0.4}) {
        PhantomParams params = paramsOf(PhantomKind::Tube, 64, 26.0);
        params.psf.sigma = sigma;
        params.offset = {offset, 0.0, 0.0};
        const Phantom phantom = makePhantom(params);
        for (int i = 50; i < 63; ++i) {
          const double wall = 31.5 + offset + 26.0 - i;
          // Beside the plane through the axis the wall falls back by y^2 / 2r.
          const double back = (0.25 + 1.0 / 12.0 + sigma * sigma) / (2.0 * 26.0);
          const double expected = 255.0 * blurredStep(wall - back, sigma);
          const double found = phantom.image.at(i, 31, 32);
          QVERIFY(isNear(found, expected, 0.002 * 255.0));
        }
      }
  }

  void aPointSpreadKeepsWhatIsThere() {
    const double expected = 255.0 * 2.0 * M_PI * M_PI * 16.0 * 25.0;
    for (const char* psf : {"gaussian:0", "gaussian:0.5", "gaussian:1.5", "mr", "mr:1.5"}) {
      PhantomParams params = withPsf(paramsOf(PhantomKind::Torus, 64, 5.0), psf);
      params.axis = {1.0, 2.0, 3.0};
      const Phantom phantom = makePhantom(params);
      const double sum =
          std::accumulate(phantom.image.voxels.begin(), phantom.image.voxels.end(), 0.0);
      QVERIFY2(std::fabs(sum / expected - 1.0) < 2e-3, psf);
      QVERIFY(std::fabs(phantom.image.at(0, 0, 0)) < 0.6F);
    }
  }

  /// In an MR image a wide vessel rings by about 1 %, and zero filling makes the edge wider.
  void anMrPointSpreadRingsALittle() {
    const auto profile = [](const char* psf) {
      const Phantom phantom = makePhantom(withPsf(paramsOf(PhantomKind::Tube, 64, 20.0), psf));
      std::vector<double> values;
      for (int i = 32; i < 64; ++i) values.push_back(phantom.image.at(i, 31, 31));
      return values;
    };
    const auto width = [](const std::vector<double>& values) {
      return std::count_if(values.begin(), values.end(),
                           [](double v) { return v > 26.0 && v < 229.0; });
    };
    const std::vector<double> mr = profile("mr");
    const double over = *std::max_element(mr.begin(), mr.end()) / 255.0 - 1.0;
    QVERIFY2(over > 0.001 && over < 0.02, QByteArray::number(over));
    QVERIFY(*std::min_element(mr.begin(), mr.end()) < -0.1);
    QVERIFY(std::fabs(mr.front() / 255.0 - 1.0) < 0.01);
    QVERIFY(width(profile("mr:3")) > width(mr) + 2);
  }

  void theTruthIsWhatIsInsideByHalf() {
    for (const char* psf : {"gaussian:0", "gaussian:1", "mr"}) {
      PhantomParams params = withPsf(paramsOf(PhantomKind::Helix, 64, 3.0), psf);
      params.noiseSigma = 20.0;
      const Phantom phantom = makePhantom(params);
      params.noiseSigma = 0.0;
      params.psf.kind = PointSpread::Kind::Gaussian;
      params.psf.sigma = 0.0;
      const Phantom plain = makePhantom(params);
      for (std::size_t i = 0; i < plain.image.voxels.size(); ++i) {
        if (std::fabs(plain.image.voxels[i] - 127.5F) < 1.0F) continue;
        QCOMPARE(phantom.truth.voxels[i],
                 static_cast<std::uint8_t>(plain.image.voxels[i] > 127.5F ? 1 : 0));
      }
    }
  }

  /// A tube along the slices is cut by the volume's end as if it went on.
  void vesselsGoOnBeyondTheVolume() {
    for (const char* psf : {"gaussian:2", "mr:2"}) {
      const Phantom phantom = makePhantom(withPsf(paramsOf(PhantomKind::Tube, 40, 4.0), psf));
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i)
          QVERIFY(std::fabs(phantom.image.at(i, j, 0) - phantom.image.at(i, j, 20)) < 0.05F);
    }
  }

  void sigmaIsRoundInMillimetres() {
    PhantomParams params = paramsOf(PhantomKind::Torus, 48, 5.0);
    params.psf.sigma = 1.0;
    params.size = {48, 48, 24};
    params.spacingMm = {0.5, 0.5, 1.0};
    // The centre of a blurred ball: the same along z as along x, but for the voxels' own boxes.
    params.kind = PhantomKind::Aneurysm;
    params.radius = 2.0;
    params.axis = {0.0, 0.0, 1.0};
    const Phantom phantom = makePhantom(params);
    QVERIFY(phantom.image.at(23, 23, 12) > 100.0F);
    params.psf.sigma = 0.0;
    const Phantom sharp = makePhantom(params);
    QVERIFY(sharp.image.at(23, 23, 12) > phantom.image.at(23, 23, 12));
  }

  void imagesDoNotDependOnTheThreads() {
    PhantomParams params = paramsOf(PhantomKind::VesselTree, 48, 3.0);
    params.fadePercent = 60.0;
    for (const char* psf : {"gaussian:0.5", "mr"}) {
      params = withPsf(params, psf);
      const auto [one, two] = onOneAndSeveralThreads([&] { return makePhantom(params); });
      QVERIFY(one.image.voxels == two.image.voxels);
      QVERIFY(one.truth.voxels == two.truth.voxels);
    }
  }

  void clutterIsBlurredAsWell() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 64);
    params.clutter = true;
    const auto steps = [&](const char* psf) {
      const Phantom phantom = makePhantom(withPsf(params, psf));
      // Across the shell, 2 voxels inside the border.
      double largest = 0.0;
      for (int i = 0; i < 8; ++i)
        largest = std::max(largest, std::fabs(static_cast<double>(phantom.image.at(i + 1, 40, 40)) -
                                              phantom.image.at(i, 40, 40)));
      return largest;
    };
    QVERIFY(steps("gaussian:1") < 0.6 * steps("subvoxels"));
  }

  void pointSpreadsAreReadAndWritten() {
    for (const char* text :
         {"gaussian:0.5", "gaussian:0", "gaussian:1.25", "mr", "mr:2", "subvoxels"})
      QCOMPARE(pointSpreadText(pointSpreadFromText(text)), std::string(text));
    QCOMPARE(pointSpreadText(pointSpreadFromText("gaussian")), std::string("gaussian:0.5"));
    for (const char* text : {"", "gauss", "gaussian:", "gaussian:x", "gaussian:-1", "gaussian:9",
                             "gaussian:0.5mm", "mr:0", "mr:9", "mr:nan", "subvoxels:2"})
      QVERIFY_THROWS_EXCEPTION(InputError, pointSpreadFromText(text));
  }

  /// Everything that makes a phantom is in its truth.json.
  void truthJsonMakesThePhantomAgain() {
    for (std::size_t kind = 0; kind < phantomKindNames().size(); ++kind) {
      PhantomParams params = paramsOf(static_cast<PhantomKind>(kind), 48, 2.1);
      params.spacingMm = {0.7, 0.7, 0.9};
      params.randomSeed = 12345678901234567ULL;
      params.axis = {0.1, -0.2, 1.0 / 3.0};
      params.offset = {0.1, 0.2, 0.3};
      params.gap = 1.7;
      params.stenosisPercent = 71.3;
      params.radiusMin = 0.9;
      params.volumePercent = 0.9;
      params.noiseSigma = 7.0;
      params.noiseModel = NoiseModel::Rician;
      params.driftPercent = 11.0;
      params.fadePercent = 77.0;
      params.psf = pointSpreadFromText(kind % 4 == 0 ? "mr:1.5" : "gaussian:0.7");
      const Phantom first = makePhantom(params);
      const std::string json = truthJson(params, first);
      const PhantomParams read = phantomFromTruthJson(json, "truth.json");
      const Phantom second = makePhantom(read);
      QVERIFY2(first.image.voxels == second.image.voxels, phantomKindNames()[kind].c_str());
      QCOMPARE(truthJson(read, second), json);
    }
  }

  void oldFilesAreOfSubvoxels() {
    const PhantomParams params = withPsf(paramsOf(PhantomKind::Tube, 32), "mr");
    std::string json = truthJson(params, makePhantom(params));
    const std::size_t at = json.find("\"psf\"");
    json.erase(at, json.find('\n', at) - at);
    QCOMPARE(phantomFromTruthJson(json, "t").psf.kind, PointSpread::Kind::Subvoxels);
  }

  void wrongFilesAreRefusedWithTheirName() {
    const PhantomParams params = paramsOf(PhantomKind::Stenosis, 48);
    const std::string json = truthJson(params, makePhantom(params));
    const auto refusal = [&](const std::function<void(std::string&)>& change) {
      std::string text = json;
      change(text);
      return messageOf([&] { (void)phantomFromTruthJson(text, "some/truth.json"); });
    };
    const auto replaced = [&](const std::string& from, const std::string& to) {
      return refusal([&](std::string& text) { text.replace(text.find(from), from.size(), to); });
    };
    QVERIFY(refusal([](std::string&) {}).empty());
    for (const std::string& message :
         {refusal([](std::string& text) { text = "no JSON"; }),
          refusal([](std::string& text) { text = "{}"; }),
          refusal([](std::string& text) { text.resize(text.size() / 2); }),
          replaced("\"schema\": 1", "\"schema\": 99"), replaced("\"stenosis\"", "\"stenosys\""),
          replaced("\"radius_voxels\"", "\"radius\""),
          replaced("\"radius_voxels\": 4.0", "\"radius_voxels\": \"4\""),
          replaced("\"gaussian:0.5\"", "\"gaussian:-5\"")})
      QVERIFY2(!message.empty() && message.find('\n') == std::string::npos, message.c_str());
    QVERIFY(replaced("\"radius_voxels\"", "\"radius\"").find("some/truth.json") !=
            std::string::npos);
    QVERIFY(replaced("\"radius_voxels\"", "\"radius\"").find("radius_voxels") != std::string::npos);
    const std::string other = replaced("\"radius_voxels\": 4.0", "\"radius_voxels\": 5.0");
    QVERIFY2(other.find("centre lines") != std::string::npos, other.c_str());
  }

  void newParametersThatCannotBeMetAreRefused() {
    const auto refused = [](const std::function<void(PhantomParams&)>& change) {
      return analytic::isRefused(paramsOf(PhantomKind::Stenosis, 48), change);
    };
    QVERIFY(!refused([](PhantomParams&) {}));
    QVERIFY(refused([](PhantomParams& p) { p.stenosisPercent = 0.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.stenosisPercent = 100.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.stenosisPercent = std::nan(""); }));
    QVERIFY(refused([](PhantomParams& p) { p.psf.sigma = -0.1; }));
    QVERIFY(refused([](PhantomParams& p) { p.psf.zeroFilling = 0.5; }));
    for (const PhantomKind kind : {PhantomKind::BentTube, PhantomKind::Cone,
                                   PhantomKind::NeckAneurysm, PhantomKind::VesselTree})
      QVERIFY(refused([&](PhantomParams& p) {
        p.kind = kind;
        p.radius = 20.0;
      }));
  }
};

QTEST_GUILESS_MAIN(TestScannedPhantom)
#include "tst_scanned_phantom.moc"
