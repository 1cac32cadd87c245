// SPDX-License-Identifier: BSD-3-Clause
#include <QPushButton>
#include <QTableWidget>
#include <cmath>
#include <fstream>

#include "gui/dialog/label_dialog.h"
#include "gui/model/case_models.h"
#include "io/volume/image_write.h"
#include "window_case.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr int kSize = 24;

/// Two spheres that do not touch: 1 and 5, the second one larger.
int labelAt(int i, int j, int k) {
  if (std::hypot(i - 5.0, j - 6.0, k - 6.0) < 3.5) return 1;
  return std::hypot(i - 15.0, j - 14.0, k - 14.0) < 6.0 ? 5 : 0;
}

Volume<std::uint8_t> labels(bool second) {
  Geometry g;
  g.size = {kSize, kSize, kSize};
  g.spacing = {0.5, 0.5, 0.8};
  Volume<std::uint8_t> volume(g);
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        const int label = labelAt(i, j, k);
        volume.at(i, j, k) = static_cast<std::uint8_t>(label == 5 && !second ? 0 : label);
      }
  return volume;
}

std::size_t count(int label) {
  const Volume<std::uint8_t> all = labels(true);
  return static_cast<std::size_t>(std::count(all.voxels.begin(), all.voxels.end(), label));
}

/// As 3D Slicer writes segments that overlap: each has a layer and the value 1.
void writeLayers(const std::string& path) {
  std::ofstream out(path, std::ios::binary);
  out << "NRRD0004\ntype: unsigned char\ndimension: 4\nspace: left-posterior-superior\n"
         "sizes: 2 24 24 24\nkinds: list domain domain domain\n"
         "space directions: none (0.5,0,0) (0,0.5,0) (0,0,0.8)\nencoding: raw\n"
         "space origin: (1,2,3)\n"
         "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=artery\n"
         "Segment1_LabelValue:=1\nSegment1_Layer:=1\nSegment1_Name:=aneurysm\n\n";
  for (int k = 0; k < kSize; ++k)
    for (int j = 0; j < kSize; ++j)
      for (int i = 0; i < kSize; ++i) {
        const int label = labelAt(i, j, k);
        out.put(label == 1 ? '\1' : '\0').put(label == 5 ? '\1' : '\0');
      }
}

}  // namespace

class TestLabels : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aMaskIsMeshedWithoutAQuestion() {
    WindowCase c;
    const QString path = c.folder.filePath("mask.nii.gz");
    writeVolume(labels(false), path.toStdString());
    c.window->open(path, true);
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.quality(MeshKind::Exported), kPatienceMs);
    QVERIFY(c.labelsShown.empty());
    const double voxels = double(count(1)) * 0.5 * 0.5 * 0.8;
    QVERIFY(std::fabs(c.models().results.quality(MeshKind::Exported)->volumeMm3 / voxels - 1.0) <
            0.01);
    QCOMPARE(c.models().runs.state(Step::Vesselness), StepState::NotNeeded);
    QCOMPARE(c.models().runs.state(Step::Evolve), StepState::Fresh);

    // A preset is for everything but what the image is.
    c.models().presets.apply("thesis");
    QCOMPARE(c.models().document.parameters().segmentation.method, SegmentationMethod::Label);
    QCOMPARE(c.models().presets.current(), QString("thesis"));
    // And the next scan is a scan.
    c.models().files.take(twoTubes());
    QTRY_COMPARE(c.models().document.parameters().segmentation.method,
                 SegmentationMethod::LevelSet);
  }

  void oneOfSeveralLabelsIsChosen() {
    WindowCase c;
    const QString path = c.folder.filePath("labels.mha");
    writeVolume(labels(true), path.toStdString());
    c.window->open(path);
    QTRY_COMPARE(c.labelsShown.size(), std::size_t{2});
    QVERIFY(!c.models().document.hasCase());
    c.labelChosen = LabelAnswer(1);
    c.window->open(path, true);
    QTRY_VERIFY_WITH_TIMEOUT(
        c.models().results.phi() && c.models().results.mesh(MeshKind::Exported), kPatienceMs);
    QCOMPARE(c.models().results.evolveResult()->label->voxels, count(5));
    // The label is a parameter as any other, undo included.
    c.models().document.setField("segmentation.label", std::int64_t{1});
    c.models().runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.meshFresh(), kPatienceMs);
    QCOMPARE(c.models().results.evolveResult()->label->voxels, count(1));
    c.models().document.undoStack()->undo();
    QCOMPARE(c.models().document.parameters().segmentation.label, 5);
    c.models().document.undoStack()->setClean();

    c.labelChosen = LabelAnswer();
    c.window->open(path);
    QTRY_COMPARE(c.models().document.parameters().segmentation.method,
                 SegmentationMethod::LevelSet);
  }

  void aCaseOfALayerFindsItsLayerAgain() {
    WindowCase c;
    const QString path = c.folder.filePath("both.seg.nrrd");
    writeLayers(path.toStdString());
    c.labelChosen = LabelAnswer(1);
    c.window->open(path, true);
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.mesh(MeshKind::Exported), kPatienceMs);
    QCOMPARE(c.labelsShown.at(1).name, std::string("aneurysm"));
    QCOMPARE(c.models().results.evolveResult()->label->voxels, count(5));
    const std::string hash = c.models().document.sourceHash();
    c.models().files.saveCase(c.folder.filePath("one.angiomesh"), {});
    QTRY_VERIFY(!c.models().files.saving());
    c.models().files.take(twoTubes());
    QTRY_VERIFY(c.models().document.sourceHash() != hash);

    c.window->open(c.folder.filePath("one.angiomesh"));
    QTRY_COMPARE(c.models().document.sourceHash(), hash);
    QCOMPARE(c.models().document.parameters().segmentation.method, SegmentationMethod::Label);
    c.models().runs.run();
    QTRY_VERIFY_WITH_TIMEOUT(c.models().results.meshFresh(), kPatienceMs);
    QCOMPARE(c.models().results.evolveResult()->label->voxels, count(5));
  }

  void theTableListsTheLabels() {
    LabelDialog dialog({{1, "artery", 0, 1200}, {5, "vein", 0, 700}}, 2.0);
    auto* table = dialog.findChild<QTableWidget*>("labelTable");
    QCOMPARE(table->rowCount(), 2);
    QCOMPARE(table->item(1, 0)->text(), QString("5"));
    QCOMPARE(table->item(1, 1)->text(), QString("vein"));
    QCOMPARE(table->item(0, 3)->text().toDouble(), 2.4);
    QCOMPARE(dialog.answer(), LabelAnswer(0));
    table->selectRow(1);
    QCOMPARE(dialog.answer(), LabelAnswer(1));
    dialog.findChild<QPushButton*>("labelScan")->click();
    QCOMPARE(dialog.answer(), LabelAnswer());
    QCOMPARE(dialog.result(), int(QDialog::Accepted));
  }
};

int main(int argc, char** argv) { return test::runWindowTests<TestLabels>(argc, argv); }
#include "tst_labels.moc"
