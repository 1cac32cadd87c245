// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>

#include "core/centreline/component_measure.h"
#include "core/pipeline/pipeline.h"
#include "core/quality/best_threshold.h"
#include "core/quality/overlap.h"
#include "core/quality/roughness.h"
#include "core/quality/sizing_check.h"
#include "core/quality/vessel_measures.h"
#include "core/quality/wall_accuracy.h"
#include "core/quality/wall_gaps.h"
#include "core/quality/zero_set_measure.h"
#include "tests/core/bytes.h"

using namespace angiomesh;
using analytic::Bytes;

namespace {

PhantomParams paramsOf(PhantomKind kind, Index3 size, double radius, double noise) {
  PhantomParams params;
  params.kind = kind;
  params.size = size;
  params.spacingMm = {0.9, 0.8, 1.0};
  params.radius = radius;
  params.radiusMin = 1.0;
  params.radiusMax = radius;
  params.volumePercent = 2.0;
  params.noiseSigma = noise;
  params.axis = {0.2, -0.3, 1.0};
  return params;
}

void addAgreement(Bytes& bytes, const WallAgreement& a) {
  bytes.add(a.vertices);
  bytes.add(a.triangles);
  // Where nothing counts they are no number, of one sign or the other.
  if (a.vertices == 0) return;
  for (const double value : {a.meanMm, a.spreadMm, a.distance95Mm, a.normalMeanDeg, a.normal95Deg,
                             a.curvatureErrorMedian})
    bytes.add(std::isnan(value) ? -1.0 : value);
}

std::string wallFigures(const PhantomParams& params, const TriMesh& mesh) {
  Bytes bytes;
  const WallAccuracy accuracy = wallAccuracy(mesh, WallTruth(params));
  addAgreement(bytes, accuracy.all);
  for (const WallAgreement& part : accuracy.byRadius) addAgreement(bytes, part);
  bytes.add(accuracy.leftOut);
  if (accuracy.stenosis) bytes.add(accuracy.stenosis->foundMm);
  return bytes.hash();
}

std::string meshFigures(const TriMesh& mesh, const Volume<float>& phi) {
  Bytes bytes;
  bytes.add(vertexSpreads(mesh));
  if (const auto roughness = measureRoughness(mesh)) {
    bytes.add(Eigen::Vector3d(roughness->spreadMm, roughness->spread95Mm, roughness->angleDeg));
    bytes.add(roughness->places);
  }
  const GapFigures gaps = gapFigures(measureGaps(mesh));
  for (const double figure : {gaps.leastGapEdges.value_or(-1), gaps.narrowPercent,
                              gaps.leastThicknessMm.value_or(-1), gaps.thickness1Mm.value_or(-1)})
    bytes.add(figure);
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  const SizingCheck sizing = checkSizing(mesh, GuidanceField(field, SizingParams{}), phi.geometry);
  bytes.add(
      Eigen::Vector3d(sizing.edgesInRangePercent, sizing.edgeRatioMean, sizing.wantedTriangles));
  bytes.add(sizing.triangles);
  return bytes.hash();
}

std::string voxelFigures(const Phantom& phantom, const Volume<float>& phi) {
  Bytes bytes;
  const Volume<std::uint8_t> found = maskOnGrid(phi, phantom.truth.geometry);
  const OverlapMeasures overlap = compareMasks(found, phantom.truth);
  for (const double figure :
       {overlap.overlap, overlap.sensitivity, overlap.precision, overlap.assdMm, overlap.hd95Mm})
    bytes.add(figure);
  const BestThreshold best = bestThreshold(phantom.image, phantom.truth);
  bytes.add(Eigen::Vector3d(best.overlap, best.sigmaVoxels, best.threshold));
  const ComponentMeasures parts = measureComponents(found, phantom.truth, phantom.centreLines);
  for (const std::size_t figure :
       {parts.components, parts.falseOnes, parts.largestFalse, parts.mergedVessels})
    bytes.add(figure);
  const Components components = connectedComponents(insideMask(phi));
  for (const ComponentMeasure& part :
       measureComponents(phi, components.labels, components.sizes.size())) {
    bytes.add(Eigen::Vector3d(part.lengthMm, part.meanRadiusMm, part.tips));
    for (const VesselPiece& piece : part.pieces)
      bytes.add(Eigen::Vector3d(piece.lengthMm, piece.radiusMm, 0.0));
  }
  return bytes.hash();
}

std::string fieldFigures(const PhantomParams& params, const Phantom& phantom,
                         const Volume<float>& phi) {
  Bytes bytes;
  const SplineField field(phi, SplineKind::InterpolatingBspline);
  const ZeroSetMeasure measure = measureZeroSet(field);
  const std::vector<WallSample> samples =
      wallSamples(field, phantomDistance(params), phantom.centreLines);
  const WallDistance distance = wallDistance(samples);
  for (const double figure :
       {measure.volumeMm3, measure.areaMm2, distance.meanMm, distance.percentile95Mm,
        wallBias(samples, 1.0, 4.0, 2.0), centreLineRecall(phi, phantom.centreLines, 1.0)})
    bytes.add(figure);
  return bytes.hash();
}

}  // namespace

Q_DECLARE_METATYPE(PhantomParams)

/// docs/evidence.md compares figures that were measured in different versions: a measure that
/// changes says so here, and the figures are measured again.
class TestFigureBits : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void figuresStayTheSame_data() {
    QTest::addColumn<PhantomParams>("params");
    QTest::addColumn<QStringList>("hashes");
    const auto row = [](const char* name, const PhantomParams& params, const QStringList& hashes) {
      QTest::newRow(name) << params << hashes;
    };
    row("tree", paramsOf(PhantomKind::Tree, {52, 56, 60}, 3.0, 20.0),
        {"5a2e8be2d379cb25", "46294ac5419a048f", "ff8ccf51bb93e298", "2fc1b05bef2bdfa8"});
    row("stenosis", paramsOf(PhantomKind::Stenosis, {36, 32, 40}, 4.0, 10.0),
        {"36d914455636330a", "81471a20ea02e429", "86f7e4ce96ce91f3", "3919f3453a511466"});
    row("bent vessels", paramsOf(PhantomKind::VesselTree, {60, 56, 52}, 3.0, 10.0),
        {"3d7bbc010258a2b9", "bc9119adcb957bb5", "645800fdbfcb3477", "6b71c81c04124f81"});
  }
  void figuresStayTheSame() {
    QFETCH(PhantomParams, params);
    QFETCH(QStringList, hashes);
    const Phantom phantom = makePhantom(params);
    const RunResult run = Pipeline(makeSource(phantom.image, "phantom")).run(preset("angiomesh"));
    const std::vector<std::string> now{
        wallFigures(params, *run.smoothed), meshFigures(*run.smoothed, *run.surface->phi),
        voxelFigures(phantom, *run.evolve->phi), fieldFigures(params, phantom, *run.evolve->phi)};
    QStringList found;
    for (const std::string& hash : now) found << QString::fromStdString(hash);
    QVERIFY2(found == hashes, qPrintable("the figures of wall, mesh, voxels and field are now {\"" +
                                         found.join("\", \"") + "\"}"));
  }
};

QTEST_GUILESS_MAIN(TestFigureBits)
#include "tst_figure_bits.moc"
