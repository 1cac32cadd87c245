// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <functional>
#include <map>
#include <string>

#include "core/phantom/phantom.h"
#include "tests/core/bytes.h"
#include "tests/core/phantom_case.h"

using namespace angiomesh;
using analytic::Bytes;

namespace {

std::string bitsOf(const PhantomParams& params) {
  const Phantom phantom = makePhantom(params);
  Bytes bytes;
  bytes.add(phantom.image);
  bytes.add(phantom.truth);
  bytes.add(phantom.clutter);
  for (const CentreLineSegment& line : phantom.centreLines) {
    bytes.add(line.from);
    bytes.add(line.to);
    bytes.add(Eigen::Vector3d(line.radiusFromMm, line.radiusToMm, line.parent));
  }
  for (const ClutterPiece& piece : phantom.pieces) {
    bytes.add(piece.from);
    bytes.add(piece.to);
    bytes.add(Eigen::Vector3d(piece.intensity, piece.segment, piece.label));
  }
  const auto distance = phantomDistance(params);
  for (int n = 0; n < 200; ++n) {
    const Eigen::Vector3d at(0.37 * n - 9.0, std::fmod(5.3 * n, 31.0), std::fmod(7.9 * n, 37.0));
    bytes.add(Eigen::Vector3d(distance(at), 0.0, 0.0));
  }
  return bytes.hash();
}

PhantomParams paramsOf(PhantomKind kind, Index3 size, double radius) {
  PhantomParams params;
  params.kind = kind;
  params.size = size;
  params.radius = radius;
  params.axis = {0.3, -0.2, 1.0};
  return params;
}

}  // namespace

Q_DECLARE_METATYPE(PhantomParams)

/// The figures of docs/evidence.md, and what users compare, are of phantoms that anybody can make
/// again: the same parameters give the same bits, in each version and on every machine. Where they
/// have to change, CHANGELOG says so, and the figures are measured again.
class TestPhantomBits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void parametersGiveTheSameBits_data() {
    QTest::addColumn<PhantomParams>("params");
    QTest::addColumn<QString>("hash");
    const auto row = [](const char* name, const PhantomParams& params, const char* hash) {
      QTest::newRow(name) << params << QString(hash);
    };
    row("Tube", paramsOf(PhantomKind::Tube, {30, 34, 38}, 3), "99071163a86b6bf8");
    row("Torus", paramsOf(PhantomKind::Torus, {48, 44, 40}, 2.5), "77a48c7230ef399d");
    row("Bifurcation", paramsOf(PhantomKind::Bifurcation, {52, 48, 44}, 2.5), "624bb6e5f59c0f5f");
    row("Kissing", paramsOf(PhantomKind::Kissing, {44, 48, 52}, 2.5), "f46e6744cf7cb3c9");
    row("Helix", paramsOf(PhantomKind::Helix, {48, 44, 52}, 2), "220c0d4577c85ac2");
    row("Stenosis", paramsOf(PhantomKind::Stenosis, {32, 36, 40}, 3), "a83ea4b9e58fccb6");
    row("Aneurysm", paramsOf(PhantomKind::Aneurysm, {52, 48, 44}, 2.5), "ade7999e745cef2f");
    row("CapsuleTree", paramsOf(PhantomKind::CapsuleTree, {70, 66, 74}, 2.5), "e9664458aa3159f8");
    row("BentTube", paramsOf(PhantomKind::BentTube, {56, 52, 60}, 2.5), "2f33fa374a14f770");
    row("Cone", paramsOf(PhantomKind::Cone, {36, 40, 44}, 4), "6dbdaf3b1b81c15c");
    row("NeckAneurysm", paramsOf(PhantomKind::NeckAneurysm, {60, 56, 52}, 2.5), "3a27b7ee55c2c4e8");
    PhantomParams tree = paramsOf(PhantomKind::Tree, {44, 48, 52}, 3.0);
    tree.spacingMm = {0.5, 0.5, 0.8};
    tree.radiusMin = 1.0;
    tree.radiusMax = 4.0;
    tree.volumePercent = 2.0;
    tree.fadePercent = 60.0;
    tree.driftPercent = 20.0;
    tree.noiseSigma = 15.0;
    row("a tree that fades, drift and noise", tree, "7261ed8cc09cef50");
    tree.randomSeed = 5;
    tree.terminals = 9;
    tree.noiseModel = NoiseModel::Rician;
    row("another, by its terminals", tree, "d345aaded3a34d67");
    PhantomParams vessels = paramsOf(PhantomKind::VesselTree, {52, 48, 44}, 3.0);
    vessels.noiseSigma = 5.0;
    row("a tree of bent vessels", vessels, "b5680ab13bb68f54");
    PhantomParams cluttered = paramsOf(PhantomKind::CapsuleTree, {96, 92, 88}, 2.0);
    cluttered.clutter = true;
    cluttered.fadePercent = 70.0;
    cluttered.driftPercent = 10.0;
    row("clutter", cluttered, "8b9761bc1e6172a7");
    cluttered.spacingMm = {0.9, 0.7, 0.8};
    cluttered.kind = PhantomKind::Tree;
    cluttered.radiusMin = 0.9;
    cluttered.radiusMax = 3.0;
    cluttered.randomSeed = 3;
    row("a tree in clutter", cluttered, "fb2ec47a802567d4");
    PhantomParams scanned = paramsOf(PhantomKind::VesselTree, {40, 44, 36}, 2.5);
    scanned.spacingMm = {0.8, 0.5, 0.6};
    scanned.psf = {PointSpread::Kind::Mr, 0.6, 1.6};
    scanned.fadePercent = 50.0;
    row("as a scanner sees it", scanned, "d4fbbc97a543bfd1");
    scanned.psf = {PointSpread::Kind::Gaussian, 1.3, 1.0};
    scanned.kind = PhantomKind::CapsuleTree;
    scanned.size = {72, 84, 74};
    scanned.spacingMm = {0.8, 0.5, 0.7};
    scanned.clutter = true;
    scanned.randomSeed = 4;
    row("through a wide Gaussian", scanned, "54ec23f56f1e1912");
  }
  void parametersGiveTheSameBits() {
    QFETCH(PhantomParams, params);
    QFETCH(QString, hash);
    QCOMPARE(QString::fromStdString(bitsOf(params)), hash);
  }
};

QTEST_GUILESS_MAIN(TestPhantomBits)
#include "tst_phantom_bits.moc"
