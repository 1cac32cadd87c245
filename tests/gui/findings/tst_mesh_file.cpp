// SPDX-License-Identifier: BSD-3-Clause
#include <QFile>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QToolButton>

#include "core/quality/quality_table.h"
#include "gui/inspector/histogram_widget.h"
#include "gui/inspector/quality_grid.h"
#include "io/mesh/mesh_io.h"
#include "tests/gui/port_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr int kFile = static_cast<int>(MeshKind::File);

/// A window after a run of two tubes.
struct Compared : WindowCase {
  Compared() {
    models().files.take(twoTubes());
    click(find<QPushButton>("run"));
    state().setVolumeView(VolumeView::None);
  }
  [[nodiscard]] TriMesh ours() { return *models().results.mesh(MeshKind::Exported); }
  /// Opens it from the inspector.
  void compare(const TriMesh& mesh, const QString& name = "other.ply") {
    const QString path = folder.filePath(name);
    (void)writeMesh(mesh, path.toStdString());
    open(path);
  }
  void open(const QString& path) {
    openPath = path;
    click(find<QToolButton>("openMeshButton"));
  }
  const MeshQuality* quality() { return models().results.quality(MeshKind::File); }
  QString log() { return find<QPlainTextEdit>("log")->toPlainText(); }
  QString hints() { return find<QLabel>("hints")->text(); }
  QImage picture3d() { return window->views().surface()->grabFramebuffer(); }
};

TriMesh moved(TriMesh mesh, double alongX) {
  for (Eigen::Vector3d& point : mesh.points) point.x() += alongX;
  return mesh;
}

/// As a mesh of another program has them: without patches.
TriMesh plain(TriMesh mesh) {
  mesh.patch.clear();
  return mesh;
}

}  // namespace

class TestMeshFile : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void itIsMeasuredAsOursAre() {
    Compared c;
    auto* grid = c.find<QualityGrid>("quality");
    QVERIFY(grid->isColumnHidden(kFile));
    c.compare(c.ours());
    QVERIFY(!grid->isColumnHidden(kFile));
    QCOMPARE(c.find<QComboBox>("meshShown")->currentIndex(), kFile);
    QVERIFY2(c.log().contains("other.ply: 23"), qPrintable(c.log()));
    const MeshQuality& ours = *c.models().results.quality(MeshKind::Exported);
    for (const QualityMeasure& measure : qualityMeasures()) {
      if (std::string(measure.key) == "from_front_percent") continue;  // a file does not tell
      QVERIFY2(measureText(measure, *c.quality()) == measureText(measure, ours), measure.key);
    }
    QVERIFY(c.quality()->vertexDeviation.has_value());
  }

  void formats_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"a.ply", "a.stl", "a.obj", "a.off", "a.vtp"})
      QTest::newRow(name) << QString(name);
  }
  void formats() {
    QFETCH(const QString, name);
    Compared c;
    c.compare(c.ours(), name);
    QVERIFY2(c.quality() != nullptr, qPrintable(c.log()));
    QCOMPARE(c.quality()->triangles, c.ours().triangles.size());
    QVERIFY(c.quality()->vertexDeviation->maxMm < 0.01);
  }

  void whatCannotBeReadIsSaid() {
    Compared c;
    c.compare(c.ours());
    const QString bad = c.folder.filePath("bad.ply");
    QFile file(bad);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("ply\nformat ascii 1.0\nnonsense") > 0);
    file.close();
    for (const QString& path : {bad, c.folder.filePath("none.stl"), c.folder.filePath("a.xyz")}) {
      c.open(path);
      const QString name = path.section('/', -1);
      QVERIFY2(c.log().contains("Cannot compare with this mesh: ") && c.log().contains(name),
               qPrintable(c.log()));
    }
    QVERIFY2(!c.log().contains(c.folder.path()), qPrintable(c.log()));
    // The one before is still there.
    QVERIFY(c.quality() != nullptr);
    QVERIFY(c.hints().contains("other.ply"));
  }

  void whereItLiesOffTheVolumeNoDistanceIsGiven() {
    Compared c;
    const auto deviates = [&c] { return c.quality()->centroidDeviation.has_value(); };
    c.compare(moved(c.ours(), 500.0));
    QVERIFY(!deviates());
    QVERIFY2(c.hints().contains("off the volume"), qPrintable(c.hints()));
    // Beside the tubes, where phi does not tell how far they are.
    c.compare(moved(plain(c.ours()), 3.0));
    QVERIFY(!deviates());
    QVERIFY2(c.hints().contains("too far from the wall"), qPrintable(c.hints()));
    c.compare(moved(plain(c.ours()), 0.5));
    QVERIFY2(deviates(), qPrintable(c.hints()));
    QVERIFY(c.quality()->vertexDeviation->maxMm > 0.4 && c.quality()->vertexDeviation->maxMm < 0.6);
  }

  void anotherWallIsAnotherMeasure() {
    Compared c;
    c.compare(c.ours());
    const double before = c.quality()->centroidDeviation->meanMm;
    c.models().document.setField("wall.smooth", false);
    c.click(c.find<QPushButton>("run"));
    QVERIFY(c.quality()->centroidDeviation->meanMm != before);
    // The mesh of the run is another one, that of the file is as it was.
    QCOMPARE(c.state().meshKind(), MeshKind::File);
    QVERIFY(c.find<QLabel>("fixThen")->isHidden());
  }

  void itSharesColoursAndHistogram() {
    Compared c;
    c.compare(c.ours());
    const QImage file = c.picture3d();
    c.choose(c.find<QComboBox>("meshColour"), 1);
    const QImage coloured = c.picture3d();
    QVERIFY(coloured != file);
    auto* histogram = c.find<HistogramWidget>("histogram");
    QCOMPARE(histogram->shares(MeshKind::File), histogram->shares(MeshKind::Exported));
    // Nothing of ours helps it.
    c.compare(*c.models().results.mesh(MeshKind::MarchingCubes), "cubes.ply");
    for (const char* fix : {"fixRho", "fixMesher", "fixParts", "fixCaps"})
      QVERIFY2(c.find<QPushButton>(fix)->isHidden(), fix);
    QVERIFY(c.find<QLabel>("gate:solver")->text().contains("fails"));
  }

  void itGoesWithTheCase() {
    Compared c;
    c.compare(c.ours());
    QCOMPARE(c.state().caseView().mesh, std::string("exported"));
    c.models().files.take(slowTree());
    QVERIFY(c.models().results.mesh(MeshKind::File) == nullptr && c.quality() == nullptr);
    QCOMPARE(c.state().meshKind(), MeshKind::Exported);
    QVERIFY(c.find<QualityGrid>("quality")->isColumnHidden(kFile));
  }

  void itIsReadByAWorker() {
    WindowCase c(makeThreadedJobRunner);
    c.models().files.take(twoTubes());
    QTRY_VERIFY_WITH_TIMEOUT(c.models().document.hasCase(), kPatienceMs);
    c.models().runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.quality(MeshKind::Exported) != nullptr,
                             kPatienceMs);
    c.openPath = c.folder.filePath("other.ply");
    (void)writeMesh(*c.models().results.mesh(MeshKind::Exported), c.openPath.toStdString());
    trigger(c, "openMesh");
    QVERIFY(c.models().results.mesh(MeshKind::File) == nullptr);
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.quality(MeshKind::File) != nullptr, kPatienceMs);
    // The last one that was asked for stays.
    trigger(c, "openMesh");
    c.openPath = c.folder.filePath("cubes.ply");
    const auto cubes = c.models().results.mesh(MeshKind::MarchingCubes);
    (void)writeMesh(*cubes, c.openPath.toStdString());
    trigger(c, "openMesh");
    QTRY_COMPARE_WITH_TIMEOUT(c.models().results.mesh(MeshKind::File)->triangles.size(),
                              cubes->triangles.size(), kPatienceMs);
    // And a window that goes does not wait for it.
    trigger(c, "openMesh");
  }
};

int main(int argc, char** argv) { return runWindowTests<TestMeshFile>(argc, argv); }
#include "tst_mesh_file.moc"
