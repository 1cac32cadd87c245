// SPDX-License-Identifier: BSD-3-Clause
#include <QTest>
#include <algorithm>
#include <filesystem>

#include "core/pipeline/pipeline.h"
#include "io/scan/image_io.h"

using namespace angiomesh;

/// The whole pipeline with its defaults on real scans, where ANGIOMESH_DATA names their folder.
class TestScans : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void defaultsGiveATreeThatSpansTheScan_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("span");  // least share of the volume's extent, on two axes at least
    QTest::newRow("abdominal aorta") << "aorta-mra/aorta.mha" << 0.7;
    QTest::newRow("circle of Willis") << "brain-tof-crop/mra.mha" << 0.9;
    QTest::newRow("masked brain") << "brain-tof-masked/mra.nii.gz" << 0.5;
    QTest::newRow("arteriovenous fistula") << "avf-mra/avf_float_32.nrrd" << 0.7;
  }

  void defaultsGiveATreeThatSpansTheScan() {
    const QByteArray data = qgetenv("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    QFETCH(QString, file);
    QFETCH(double, span);
    const auto path = std::filesystem::path(data.toStdString()) / file.toStdString();
    if (!std::filesystem::exists(path)) QSKIP("ANGIOMESH_DATA does not hold this scan");
    const RunResult run = Pipeline(makeSource(readImage(path).image, "scan")).run(Parameters{});

    QVERIFY(run.evolve->stopReason == StopReason::Converged ||
            run.evolve->stopReason == StopReason::Settled);
    const std::size_t largest = run.surface->components.front().voxels;
    QVERIFY(static_cast<double>(largest) > 0.8 * static_cast<double>(run.surface->insideVoxels));
    // A leak would fill the volume.
    QVERIFY(run.surface->insideVoxels < run.surface->phi->voxels.size() / 20);

    const Components parts = connectedComponents(insideMask(*run.surface->phi));
    const Geometry& g = run.surface->phi->geometry;
    Index3 low = g.size;
    Index3 high{0, 0, 0};
    for (std::size_t i = 0; i < parts.labels.voxels.size(); ++i) {
      if (parts.labels.voxels[i] != 1) continue;
      const Index3 p = g.indexOf(i);
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
    }
    int spanned = 0;
    for (std::size_t a = 0; a < 3; ++a)
      if (high[a] - low[a] + 1 >= span * g.size[a]) ++spanned;
    QVERIFY2(spanned >= 2, qPrintable(QString::number(spanned)));

    const MeshQuality& mesh = run.quality->mesh;
    QVERIFY(mesh.closed && mesh.oriented);
    QCOMPARE(mesh.nonManifoldEdges + mesh.nonManifoldVertices, std::size_t{0});
    QCOMPARE(mesh.degenerateTriangles + mesh.selfIntersections, std::size_t{0});
    QCOMPARE(mesh.boundaryEdges, std::size_t{0});
    QVERIFY(mesh.below20Percent < 1.0);
  }
};

QTEST_GUILESS_MAIN(TestScans)
#include "tst_scans.moc"
