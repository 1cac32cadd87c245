// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/phantom/phantom.h"
#include "core/phantom/truth_json.h"
#include "core/phantom/vessel_growth.h"
#include "tests/core/bars.h"
#include "tests/core/phantom_case.h"
#include "tests/core/threads.h"

using namespace angiomesh;
using analytic::paramsOf;
using Eigen::Vector3d;

namespace {

double truthVolume(const Volume<std::uint8_t>& truth) {
  return std::accumulate(truth.voxels.begin(), truth.voxels.end(), 0.0) *
         truth.geometry.voxelVolumeMm3();
}

/// Volume by the subvoxels: less sensitive to the grid than the truth mask.
double imageVolume(const Volume<float>& image) {
  double sum = 0.0;
  for (const float v : image.voxels) sum += v >= 255.0F ? 1.0 : v / 256.0;
  return sum * image.geometry.voxelVolumeMm3();
}

/// A half-filled voxel (128 > 127) belongs to the vessel, so the truth's wall lies up to about 1/8
/// voxel outside the shape's.
void verifyTruthVolume(const Volume<std::uint8_t>& truth,
                       const std::function<double(double)>& volumeOfShiftedWall) {
  const double volume = truthVolume(truth);
  QVERIFY(volume > volumeOfShiftedWall(-0.02));
  QVERIFY(volume < volumeOfShiftedWall(0.2));
}

Vector3d centreOf(const Geometry& g) {
  return 0.5 * Vector3d(g.size[0] - 1, g.size[1] - 1, g.size[2] - 1).cwiseProduct(g.spacing);
}

/// Euler characteristic of the closed voxels (cubical complex): cells - faces + edges - ... in the
/// order corners - edges + faces - cells.
int eulerCharacteristic(const Volume<std::uint8_t>& mask) {
  const Index3 n = mask.geometry.size;
  const auto inside = [&](int i, int j, int k) {
    return mask.geometry.contains(i, j, k) && mask.at(i, j, k) != 0;
  };
  int euler = 0;
  // A cell of the complex at (2i + a, 2j + b, 2k + c) belongs to the voxels around it.
  for (int k = 0; k <= 2 * n[2]; ++k)
    for (int j = 0; j <= 2 * n[1]; ++j)
      for (int i = 0; i <= 2 * n[0]; ++i) {
        bool any = false;
        for (int c = (k + 1) / 2 - 1; c <= k / 2; ++c)
          for (int b = (j + 1) / 2 - 1; b <= j / 2; ++b)
            for (int a = (i + 1) / 2 - 1; a <= i / 2; ++a) any = any || inside(a, b, c);
        if (any) euler += ((i + j + k) % 2 == 0) ? 1 : -1;
      }
  return euler;
}

double segmentDistance(const CentreLineSegment& s, const CentreLineSegment& t) {
  double least = 1e9;
  const int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const Vector3d p = s.from + (s.to - s.from) * i / steps;
    const Vector3d d = t.to - t.from;
    const double at = std::clamp((p - t.from).dot(d) / d.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - t.from - at * d).norm());
  }
  return least;
}

PhantomParams treeParams(const Index3& size, std::uint64_t seed) {
  PhantomParams params = paramsOf(PhantomKind::Tree, 128);
  params.size = size;
  params.randomSeed = seed;
  return params;
}

}  // namespace

class TestPhantom : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { setThreads(0); }

  void tubeFieldIsTheDistanceToItsWall() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 40, 5.0);
    params.size = {40, 30, 20};
    params.spacingMm = {0.5, 0.7, 1.1};
    params.axis = {1.0, -2.0, 0.5};
    params.offset = {0.3, -0.2, 0.4};
    const Volume<float> field = phantomField(params);
    const Geometry& g = field.geometry;
    const Vector3d centre = centreOf(g) + 0.5 * params.offset;
    const Vector3d axis = params.axis.normalized();
    for (std::size_t i = 0; i < field.voxels.size(); ++i) {
      const Index3 at = g.indexOf(i);
      const Vector3d p = g.toPhysical(Vector3d(at[0], at[1], at[2])) - centre;
      const double expected = (p - p.dot(axis) * axis).norm() - 5.0 * 0.5;
      QVERIFY(std::fabs(field.voxels[i] - expected) < 1e-5);
    }
  }

  void voxelsHoldThirtyTwoPerSubvoxel() {
    PhantomParams params = paramsOf(PhantomKind::Tube, 24, 3.3);
    params.axis = {0.3, 1.0, -0.4};
    params.offset = {0.25, 0.1, -0.3};
    params.spacingMm = {1.0, 1.5, 1.2};
    const Phantom phantom = makePhantom(params);
    const Geometry& g = phantom.image.geometry;
    QVERIFY(g.origin.isZero() && g.direction.isIdentity());
    const Vector3d centre = centreOf(g) + params.offset;
    const Vector3d axis = params.axis.normalized();
    std::vector<int> seen(9, 0);
    for (std::size_t i = 0; i < phantom.image.voxels.size(); ++i) {
      const Index3 at = g.indexOf(i);
      int count = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const Vector3d index(at[0] + ((corner & 1) != 0 ? 0.25 : -0.25),
                             at[1] + ((corner & 2) != 0 ? 0.25 : -0.25),
                             at[2] + ((corner & 4) != 0 ? 0.25 : -0.25));
        const Vector3d p = g.toPhysical(index) - centre;
        if ((p - p.dot(axis) * axis).norm() < 3.3) ++count;
      }
      ++seen[static_cast<std::size_t>(count)];
      QCOMPARE(phantom.image.voxels[i], static_cast<float>(std::min(255, 32 * count)));
      QCOMPARE(phantom.truth.voxels[i], static_cast<std::uint8_t>(count >= 4 ? 1 : 0));
    }
    for (const int n : seen) QVERIFY(n > 0);
  }

  void tubeHasTheVolumeOfACylinder() {
    const Phantom phantom = makePhantom(paramsOf(PhantomKind::Tube, 48, 6.0));
    const double expected = M_PI * 36.0 * 48.0;
    QVERIFY(std::fabs(imageVolume(phantom.image) / expected - 1.0) < 0.01);
    verifyTruthVolume(phantom.truth,
                      [](double shift) { return M_PI * (6.0 + shift) * (6.0 + shift) * 48.0; });
    QCOMPARE(phantom.centreLines.size(), std::size_t{1});
    const CentreLineSegment& line = phantom.centreLines.front();
    QVERIFY(std::fabs((line.to - line.from).norm() - 48.0) < 1e-9);
    QCOMPARE(line.radiusFromMm, 6.0);
    QCOMPARE(line.parent, -1);
  }

  void torusHasItsVolumeAndHole() {
    for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 2, 3)}) {
      PhantomParams params = paramsOf(PhantomKind::Torus, 64, 5.0);
      params.axis = axis;
      params.offset = {0.3, 0.2, 0.1};
      params.spacingMm = {0.4, 0.4, 0.4};
      const Phantom phantom = makePhantom(params);
      const double expected = 2.0 * M_PI * M_PI * 16.0 * 25.0 * std::pow(0.4, 3);
      verifyTruthVolume(phantom.truth, [](double shift) {
        return 2.0 * M_PI * M_PI * 16.0 * (5.0 + shift) * (5.0 + shift) * std::pow(0.4, 3);
      });
      QVERIFY(std::fabs(imageVolume(phantom.image) / expected - 1.0) < 0.01);
      QCOMPARE(eulerCharacteristic(phantom.truth), 0);
    }
  }

  void helixHasTheVolumeOfItsLength() {
    PhantomParams params = paramsOf(PhantomKind::Helix, 72, 3.0);
    params.axis = {1.0, 1.0, 0.5};
    const Phantom phantom = makePhantom(params);
    double length = 0.0;
    for (const CentreLineSegment& s : phantom.centreLines) length += (s.to - s.from).norm();
    const double expected = M_PI * 9.0 * (length + 4.0);  // two half balls of radius 3 are 4 long
    QVERIFY(std::fabs(imageVolume(phantom.image) / expected - 1.0) < 0.02);
    QCOMPARE(connectedComponents(phantom.truth).sizes.size(), std::size_t{1});
    QCOMPARE(eulerCharacteristic(phantom.truth), 1);
  }

  void fieldsHaveUnitGradientAtTheWall_data() {
    QTest::addColumn<int>("kind");
    for (const PhantomKind kind :
         {PhantomKind::Tube, PhantomKind::Torus, PhantomKind::Helix, PhantomKind::Stenosis,
          PhantomKind::CapsuleTree, PhantomKind::Aneurysm, PhantomKind::Bifurcation,
          PhantomKind::Kissing, PhantomKind::BentTube, PhantomKind::Cone, PhantomKind::NeckAneurysm,
          PhantomKind::VesselTree})
      QTest::newRow(phantomKindNames()[static_cast<std::size_t>(kind)].c_str())
          << static_cast<int>(kind);
  }
  void fieldsHaveUnitGradientAtTheWall() {
    QFETCH(int, kind);
    PhantomParams params = paramsOf(static_cast<PhantomKind>(kind), 64);
    params.axis = {0.2, 0.3, 1.0};
    const Volume<float> field = phantomField(params);
    const int side = params.size[0];
    std::size_t wall = 0;
    std::size_t good = 0;
    for (int k = 1; k + 1 < side; ++k)
      for (int j = 1; j + 1 < side; ++j)
        for (int i = 1; i + 1 < side; ++i) {
          if (std::fabs(field.at(i, j, k)) > 0.5F) continue;
          const Vector3d gradient(0.5 * (field.at(i + 1, j, k) - field.at(i - 1, j, k)),
                                  0.5 * (field.at(i, j + 1, k) - field.at(i, j - 1, k)),
                                  0.5 * (field.at(i, j, k + 1) - field.at(i, j, k - 1)));
          ++wall;
          if (std::fabs(gradient.norm() - 1.0) < 0.1) ++good;
          QVERIFY(gradient.norm() < 1.03);
        }
    QVERIFY(wall > 1000);
    QVERIFY(static_cast<double>(good) > 0.9 * static_cast<double>(wall));
  }

  void kissingTubesKeepTheirGap() {
    for (const double gap : {1.0, 3.0}) {
      PhantomParams params = paramsOf(PhantomKind::Kissing, 64);
      params.gap = gap;
      params.offset = {0.5, 0.5, 0.5};  // puts a voxel centre on the middle
      const Volume<float> field = phantomField(params);
      QVERIFY(std::fabs(field.at(32, 32, 32) - 0.5 * gap) < 1e-5);
      QVERIFY(std::fabs(field.at(32, 32, 36) - 0.5 * gap) < 1e-5);
      const float least = std::min(field.at(32, 32, 16), field.at(32, 32, 48));
      QVERIFY(least > 0.5 * gap + 0.5);  // they bend away
    }
    PhantomParams params = paramsOf(PhantomKind::Kissing, 64);
    params.gap = 3.0;
    QCOMPARE(connectedComponents(makePhantom(params).truth).sizes.size(), std::size_t{2});
  }

  void stenosisNarrowsToHalf() {
    const Phantom phantom = makePhantom(paramsOf(PhantomKind::Stenosis, 64, 6.0));
    const auto area = [&](int k) {
      double sum = 0.0;
      for (int j = 0; j < 64; ++j)
        for (int i = 0; i < 64; ++i) sum += phantom.image.at(i, j, k) / 256.0;
      return sum;
    };
    QVERIFY(std::fabs(area(31) / (M_PI * 9.0) - 1.0) < 0.08);
    QVERIFY(std::fabs(area(2) / (M_PI * 36.0) - 1.0) < 0.04);
  }

  void bifurcationObeysMurray() {
    const Phantom phantom = makePhantom(paramsOf(PhantomKind::Bifurcation, 48));
    QCOMPARE(phantom.centreLines.size(), std::size_t{3});
    const auto cube = [&](std::size_t n) { return std::pow(phantom.centreLines[n].radiusToMm, 3); };
    QVERIFY(std::fabs(cube(0) - cube(1) - cube(2)) < 1e-9);
    QCOMPARE(phantom.centreLines[1].parent, 0);
    QCOMPARE(phantom.centreLines[2].parent, 0);
    QCOMPARE(connectedComponents(phantom.truth).sizes.size(), std::size_t{1});
  }

  // Its radii are given for a radius of 4.
  void capsulesAreAsThickAsAsked() {
    for (const double radius : {3.0, 4.0, 5.0}) {
      PhantomParams params = paramsOf(PhantomKind::CapsuleTree, 96);
      params.radius = radius;
      const Phantom phantom = makePhantom(params);
      const double voxel = phantom.truth.geometry.voxelMm();
      const CentreLineSegment& trunk = phantom.centreLines[0];
      QVERIFY(std::abs(trunk.radiusFromMm - 6.0 * radius / 4.0 * voxel) < 1e-9);
      QVERIFY(std::abs(trunk.radiusToMm - 5.0 * radius / 4.0 * voxel) < 1e-9);
      QVERIFY(std::abs(phantom.centreLines[8].radiusToMm - 1.5 * radius / 4.0 * voxel) < 1e-9);
    }
  }

  void capsuleTreeHasOneHandle() {
    for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(-1, 2, 0.7)}) {
      PhantomParams params = paramsOf(PhantomKind::CapsuleTree, 72);
      params.axis = axis;
      const Phantom phantom = makePhantom(params);
      QCOMPARE(phantom.centreLines.size(), std::size_t{10});
      QCOMPARE(connectedComponents(phantom.truth).sizes.size(), std::size_t{1});
      QCOMPARE(eulerCharacteristic(phantom.truth), 0);
      const Geometry& g = phantom.truth.geometry;
      for (std::size_t i = 0; i < phantom.truth.voxels.size(); ++i) {
        if (phantom.truth.voxels[i] == 0) continue;
        const Index3 at = g.indexOf(i);
        for (int a = 0; a < 3; ++a) QVERIFY(at[a] > 0 && at[a] < 71);  // closed inside the volume
      }
    }
  }

  void noiseIsUnclippedAndIndependentOfThreads() {
    PhantomParams params = paramsOf(PhantomKind::Aneurysm, 48);
    params.noiseSigma = 20.0;
    const auto [one, two] = onOneAndSeveralThreads([&] { return makePhantom(params); });
    QVERIFY(one.image.voxels == two.image.voxels);
    QVERIFY(one.truth.voxels == two.truth.voxels);
    params.noiseSigma = 0.0;
    const Phantom clean = makePhantom(params);
    QVERIFY(clean.truth.voxels == one.truth.voxels);
    double sum = 0.0;
    double square = 0.0;
    const auto n = static_cast<double>(clean.image.voxels.size());
    for (std::size_t i = 0; i < clean.image.voxels.size(); ++i) {
      const double noise = static_cast<double>(one.image.voxels[i]) - clean.image.voxels[i];
      sum += noise;
      square += noise * noise;
    }
    QVERIFY(std::fabs(sum / n) < 0.3);
    QVERIFY(std::fabs(std::sqrt(square / n) - 20.0) < 0.3);
    QVERIFY(*std::min_element(one.image.voxels.begin(), one.image.voxels.end()) < -40.0F);
    QVERIFY(*std::max_element(one.image.voxels.begin(), one.image.voxels.end()) > 290.0F);
  }

  void treeMeetsItsShareAndRadii_data() {
    QTest::addColumn<QVector<int>>("size");
    QTest::addColumn<double>("zSpacing");
    QTest::newRow("32") << QVector<int>{32, 32, 32} << 1.0;
    QTest::newRow("64") << QVector<int>{64, 64, 64} << 1.0;
    QTest::newRow("128") << QVector<int>{128, 128, 128} << 1.0;
    QTest::newRow("flat") << QVector<int>{150, 100, 50} << 1.0;
    QTest::newRow("slices") << QVector<int>{96, 96, 60} << 1.5;
  }
  void treeMeetsItsShareAndRadii() {
    QFETCH(QVector<int>, size);
    QFETCH(double, zSpacing);
    for (const std::uint64_t seed : {1, 2, 3}) {
      PhantomParams params = treeParams({size[0], size[1], size[2]}, seed);
      params.spacingMm = {0.6, 0.6, 0.6 * zSpacing};
      const Phantom phantom = makePhantom(params);
      const double share =
          truthVolume(phantom.truth) / (static_cast<double>(phantom.truth.voxels.size()) *
                                        phantom.truth.geometry.voxelVolumeMm3());
      QVERIFY(isNear(share / 0.0077, 1.0, 0.02));
      const auto& lines = phantom.centreLines;
      QVERIFY(!lines.empty());
      std::vector<double> cubes(lines.size(), 0.0);
      std::vector<int> children(lines.size(), 0);
      for (std::size_t i = 0; i < lines.size(); ++i) {
        const CentreLineSegment& s = lines[i];
        QCOMPARE(s.radiusFromMm, s.radiusToMm);
        QVERIFY(s.radiusFromMm > 0.6 * (0.8 - 1e-9) && s.radiusFromMm < 0.6 * (8.0 + 1e-9));
        QVERIFY(s.parent < static_cast<int>(i));
        if (s.parent < 0) continue;
        const auto parent = static_cast<std::size_t>(s.parent);
        QVERIFY((lines[parent].to - s.from).norm() < 1e-9);
        cubes[parent] += std::pow(s.radiusFromMm, 3);
        ++children[parent];
      }
      for (std::size_t i = 0; i < lines.size(); ++i) {
        QVERIFY(children[i] == 0 || children[i] == 2);
        if (children[i] == 2)
          QVERIFY(std::fabs(cubes[i] / std::pow(lines[i].radiusToMm, 3) - 1.0) < 1e-12);
      }
      if (zSpacing == 1.0)
        QCOMPARE(connectedComponents(phantom.truth).sizes.size(), std::size_t{1});
    }
  }

  void vesselsOfATreeKeepClearOfOneAnotherAndSpanTheVolume() {
    const Phantom phantom = makePhantom(treeParams({128, 128, 128}, 4));
    const auto& lines = phantom.centreLines;
    int pairs = 0;
    int touching = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (std::size_t j = i + 1; j < lines.size(); ++j) {
        const bool joined = (lines[i].from - lines[j].to).norm() < 1e-9 ||
                            (lines[i].from - lines[j].from).norm() < 1e-9 ||
                            (lines[i].to - lines[j].from).norm() < 1e-9;
        if (joined) continue;
        ++pairs;
        if (segmentDistance(lines[i], lines[j]) < lines[i].radiusToMm + lines[j].radiusToMm)
          ++touching;
      }
    QVERIFY(pairs > 1000);
    QVERIFY2(touching <= 2, QByteArray::number(touching));
    Vector3d low = lines[0].from;
    Vector3d high = lines[0].from;
    for (const CentreLineSegment& s : lines) {
      low = low.cwiseMin(s.to);
      high = high.cwiseMax(s.to);
    }
    for (int a = 0; a < 3; ++a) QVERIFY(low[a] < 20.0 && high[a] > 107.0);
  }

  void rootsLieOnTheFacesInTurn() {
    GrowthParams params;
    params.extent = {60.0, 50.0, 40.0};
    params.roots = 9;
    params.terminals = 9;
    std::vector<int> faces;
    for (const VesselNode& node : growVessels(params, {})) {
      if (node.parent >= 0) continue;
      for (int a = 0; a < 3; ++a) {
        if (node.position[a] == 0.0) faces.push_back(2 * a);
        if (node.position[a] == params.extent[a]) faces.push_back(2 * a + 1);
      }
    }
    QCOMPARE(faces.size(), std::size_t{9});
    QCOMPARE(faces.front(), 4);
    for (std::size_t n = 6; n < faces.size(); ++n) QCOMPARE(faces[n], faces[n - 6]);
    faces.resize(6);
    std::sort(faces.begin(), faces.end());
    QCOMPARE(faces, (std::vector{0, 1, 2, 3, 4, 5}));
  }

  void treesDependOnTheSeedAndNotOnTheThreads() {
    PhantomParams params = treeParams({64, 64, 48}, 5);
    params.noiseSigma = 20.0;
    const auto [one, two] = onOneAndSeveralThreads([&] { return makePhantom(params); });
    QVERIFY(one.image.voxels == two.image.voxels);
    QVERIFY(truthJson(params, one) == truthJson(params, two));
    params.randomSeed = 6;
    QVERIFY(makePhantom(params).truth.voxels != one.truth.voxels);
  }

  void treeFieldAgreesWithTheTruth() {
    const PhantomParams params = treeParams({96, 64, 64}, 7);
    const Volume<float> field = phantomField(params);
    const Phantom phantom = makePhantom(params);
    for (std::size_t i = 0; i < field.voxels.size(); ++i) {
      if (field.voxels[i] < -0.45F) QCOMPARE(phantom.truth.voxels[i], std::uint8_t{1});
      if (field.voxels[i] > 0.45F) QCOMPARE(phantom.truth.voxels[i], std::uint8_t{0});
    }
    const CentreLineSegment& last = phantom.centreLines.back();
    const Vector3d middle = phantom.image.geometry.toIndex(0.5 * (last.from + last.to));
    QVERIFY(interpolateLinear(field, middle) < 0.0);
  }

  void theNumberOfTerminalsCanBeGiven() {
    PhantomParams params = treeParams({64, 64, 64}, 1);
    params.terminals = 9;
    const Phantom phantom = makePhantom(params);
    QCOMPARE(phantom.centreLines.size(), std::size_t{17});
  }

  void parametersThatCannotBeMetAreRefused() {
    const auto refused = [](const std::function<void(PhantomParams&)>& change) {
      return analytic::isRefused(paramsOf(PhantomKind::Tube, 32), change);
    };
    QVERIFY(refused([](PhantomParams& p) { p.size = {0, 32, 32}; }));
    QVERIFY(refused([](PhantomParams& p) { p.size = {32, -1, 32}; }));
    QVERIFY(refused([](PhantomParams& p) { p.size = {4096, 4096, 4096}; }));
    QVERIFY(refused([](PhantomParams& p) { p.size = {1024, 1024, 1025}; }));
    QVERIFY(refused([](PhantomParams& p) { p.spacingMm[1] = 0.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.spacingMm[1] = std::nan(""); }));
    QVERIFY(refused([](PhantomParams& p) { p.radius = 16.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.radius = 0.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.radius = std::nan(""); }));
    QVERIFY(refused([](PhantomParams& p) { p.axis.setZero(); }));
    QVERIFY(refused([](PhantomParams& p) { p.noiseSigma = -1.0; }));
    QVERIFY(refused([](PhantomParams& p) { p.offset[0] = 1e9; }));
    const auto treeRefused = [&](const std::function<void(PhantomParams&)>& change) {
      return refused([&](PhantomParams& p) {
        p = treeParams({48, 48, 48}, 1);
        change(p);
      });
    };
    QVERIFY(!treeRefused([](PhantomParams&) {}));
    QVERIFY(treeRefused([](PhantomParams& p) { p.size = {16, 64, 64}; }));
    QVERIFY(treeRefused([](PhantomParams& p) { p.radiusMin = 3.0, p.radiusMax = 2.0; }));
    QVERIFY(treeRefused([](PhantomParams& p) { p.radiusMin = 6.0; }));
    QVERIFY(treeRefused([](PhantomParams& p) { p.volumePercent = 60.0; }));
    QVERIFY(treeRefused([](PhantomParams& p) { p.terminals = -1; }));
    QVERIFY(treeRefused([](PhantomParams& p) { p.terminals = 15000; }));
    for (const PhantomKind kind : {PhantomKind::Torus, PhantomKind::Helix, PhantomKind::Aneurysm,
                                   PhantomKind::CapsuleTree, PhantomKind::Kissing})
      QVERIFY(refused([&](PhantomParams& p) {
        p.kind = kind;
        p.radius = 10.0;
      }));
    QVERIFY(refused([](PhantomParams& p) {
      p.kind = PhantomKind::Kissing;
      p.gap = -1.0;
    }));
  }

  void namesGoBothWaysAndTheNearestIsNamed() {
    for (std::size_t i = 0; i < phantomKindNames().size(); ++i)
      QCOMPARE(static_cast<std::size_t>(phantomKindFromName(phantomKindNames()[i])), i);
    QCOMPARE(phantomKindFromName("capsule-tree"), PhantomKind::CapsuleTree);
    QVERIFY(messageOf([] { phantomKindFromName("tors"); }).find("\"torus\"") != std::string::npos);
  }

  void truthJsonListsTheCentreLines() {
    const PhantomParams params = paramsOf(PhantomKind::Bifurcation, 32);
    const std::string json = truthJson(params, makePhantom(params));
    for (const char* key : {"\"kind\": \"bifurcation\"", "\"centre_lines\"", "\"radius_from_mm\"",
                            "\"parent\": 0", "\"spacing_mm\""})
      QVERIFY2(json.find(key) != std::string::npos, key);
  }
};

QTEST_GUILESS_MAIN(TestPhantom)
#include "tst_phantom.moc"
