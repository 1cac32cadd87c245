// SPDX-License-Identifier: BSD-3-Clause
// Masks, labels and scans as other programs leave them, through the commands that read them.
#include <QJsonArray>
#include <QRegularExpression>
#include <cmath>
#include <limits>

#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/app/cli_run.h"

using namespace angiomesh;

namespace {

/// A rod along z, of value `inside`, in a box of 16 x 16 x `slices` voxels of value `outside`.
Volume<float> rod(float outside, float inside, int slices = 20, int clear = 4) {
  Volume<float> image;
  image.geometry.size = {16, 16, slices};
  image.voxels = BigVector<float>(image.geometry.voxelCount(), outside);
  for (int k = clear; k < slices - clear; ++k)
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 16; ++i)
        if (std::hypot(i - 7.5, j - 7.5) < 4.0) image.at(i, j, k) = inside;
  return image;
}

}  // namespace

class TestCliMasks : public QObject, CliFolder {
  Q_OBJECT

  void save(const Volume<float>& image, const char* name) {
    writeVolume(image, nativePath(at(name)));
  }
  double volume(const CliResult& mesh) {
    return mesh.json()["source"].toObject()["mesh_volume_mm3"].toDouble();
  }

 private Q_SLOTS:
  void masksAreRoundedByEveryCommand() {
    save(rod(0.0F, 1.0F), "whole.nrrd");
    save(rod(0.01F, 0.988F), "near.nrrd");
    save(rod(0.2F, 0.7F), "soft.nrrd");
    save(rod(-0.04F, 1.06F), "ringing.nrrd");
    const CliResult whole = cli({"mesh", "whole.nrrd", "-o", "m.ply", "--json"});
    QCOMPARE(whole.code, 0);
    QCOMPARE(whole.errors, QByteArray());
    for (const char* name : {"near.nrrd", "soft.nrrd", "ringing.nrrd"}) {
      const CliResult mesh = cli({"mesh", name, "-o", "m.ply", "--json"});
      QVERIFY2(mesh.code == 0, mesh.errors.constData());
      QVERIFY2(mesh.errors.contains("warning: the "), mesh.errors.constData());
      QCOMPARE(volume(mesh), volume(whole));
      const CliResult told = cli({"mesh", name, "-o", "m.ply", "--json", "--threshold", "0.5"});
      QVERIFY2(told.code == 0, told.errors.constData());
      QCOMPARE(told.errors, QByteArray());
      QCOMPARE(volume(told), volume(whole));
      for (const QStringList& pair : {QStringList{name, "whole.nrrd"}, {"whole.nrrd", name}}) {
        const CliResult same = cli({"evaluate", pair[0], pair[1], "--json"});
        QCOMPARE(same.json()["truth"].toObject()["overlap"].toDouble(), 100.0);
        QVERIFY(same.errors.contains("warning: the "));
      }
      const CliResult lines = cli({"skeleton", name, "--json", "--threshold", "0.5"});
      QVERIFY2(lines.code == 0, lines.errors.constData());
    }
    QCOMPARE(cli({"mesh", "soft.nrrd", "-o", "m.ply", "--threshold", "0.8"}).code, 2);
  }

  void aLevelSetIsNoMask() {
    Volume<float> phi(rod(0, 0).geometry);
    for (int k = 0; k < 20; ++k)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i)
          phi.at(i, j, k) =
              static_cast<float>(std::min(std::hypot(i - 7.5, j - 7.5, k - 9.5) - 3.0, 1.0));
    save(phi, "phi.nrrd");
    const CliResult mesh = cli({"mesh", "phi.nrrd", "-o", "m.ply", "--json"});
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    QCOMPARE(mesh.json()["source"].toObject()["kind"].toString(), QString("level-set"));
    phi.voxels[5] = std::numeric_limits<float>::quiet_NaN();
    save(phi, "phi.nrrd");
    const CliResult refused = cli({"mesh", "phi.nrrd", "-o", "n.ply"});
    QCOMPARE(refused.code, 2);
    QVERIFY(refused.errors.contains("not finite"));
    QVERIFY(!QFile::exists(at("n.ply")));
  }

  void aMaskAtTheBorderSaysWhatIsLost() {
    save(rod(0.0F, 1.0F, 2, 0), "two.nrrd");
    const CliResult mesh = cli({"mesh", "two.nrrd", "-o", "m.ply"});
    QVERIFY2(mesh.code == 0, mesh.errors.constData());
    const QRegularExpression holds("it holds ([0-9]+) % of the label's voxels");
    const QRegularExpressionMatch found = holds.match(QString::fromUtf8(mesh.errors));
    QVERIFY2(found.hasMatch(), mesh.errors.constData());
    // The surface reaches from the centre of the one slice to that of the other.
    QVERIFY(std::abs(found.captured(1).toInt() - 50) < 3);
  }

  void partsAreChosenAsByARun() {
    Volume<float> mask = rod(0.0F, 1.0F, 30);
    for (int j = 0; j < 16; ++j)
      for (int i = 0; i < 16; ++i) mask.at(i, j, 20) = 0.0F;  // 16 slices below, 5 above
    save(mask, "two.nrrd");
    const CliResult all = cli({"mesh", "two.nrrd", "-o", "all.ply", "--json"});
    QCOMPARE(all.json()["surface"].toObject()["components"].toArray().size(), 2);
    const double voxels = all.json()["source"].toObject()["voxels"].toDouble();
    const CliResult run = cli({"run", "two.nrrd", "--set", "segmentation.method=label", "-o", "run",
                               "--until", "evolve"});
    QVERIFY2(run.code == 0, run.errors.constData());
    for (const QStringList& choice :
         {QStringList{"--set", "segmentation.keep=largest"},
          {"--set", "segmentation.minVolumeMm3=400"},
          {"--set", "segmentation.drop=7.5,7.5,23"},
          {"--set", "segmentation.keep=seeded", "--set", "seeds.points=7.5,7.5,10"}}) {
      const CliResult one =
          cli(QStringList{"mesh", "two.nrrd", "-o", "one.ply", "--json"} + choice);
      QVERIFY2(one.code == 0, one.errors.constData());
      QCOMPARE(one.json()["surface"].toObject()["components"].toArray().size(), 1);
      const QJsonObject source = one.json()["source"].toObject();
      QCOMPARE(source["voxels"].toDouble(), voxels * 16.0 / 21.0);
      QVERIFY(std::fabs(source["volume_change_percent"].toDouble()) < 3.0);
      // Of a level set function, too.
      const CliResult phi =
          cli(QStringList{"mesh", "run/phi.nrrd", "-o", "phi.ply", "--json"} + choice);
      QVERIFY2(phi.code == 0, phi.errors.constData());
      QCOMPARE(phi.json()["surface"].toObject()["components"].toArray().size(), 1);
    }
    const CliResult none =
        cli({"mesh", "two.nrrd", "-o", "none.ply", "--set", "segmentation.minVolumeMm3=1e6"});
    QCOMPARE(none.code, 2);
    QVERIFY(none.errors.contains("segmentation.minVolumeMm3"));
    QVERIFY(!QFile::exists(at("none.ply")));
  }

  void whatIsInsideOutIsSaid() {
    save(rod(-1.0F, 1.0F), "outward.nrrd");  // as networks and some programs leave it
    const CliResult outward = cli({"mesh", "outward.nrrd", "-o", "m.ply", "--json"});
    QVERIFY2(outward.errors.contains("the function is negative on 100 % of the volume's border") &&
                 outward.errors.contains("--threshold 0"),
             outward.errors.constData());
    save(rod(0.0F, 1.0F), "mask.nrrd");
    const CliResult turned =
        cli({"mesh", "outward.nrrd", "-o", "m.ply", "--json", "--threshold", "0"});
    QCOMPARE(turned.errors, QByteArray());
    QCOMPARE(volume(turned), volume(cli({"mesh", "mask.nrrd", "-o", "m.ply", "--json"})));
    save(rod(1.0F, 0.0F), "hole.nrrd");
    QVERIFY(cli({"mesh", "hole.nrrd", "-o", "m.ply"}).errors.contains("the mask lies on 100 %"));
    const CliResult run = cli({"run", "hole.nrrd", "--set", "segmentation.method=label", "-o",
                               "around", "--until", "evolve"});
    QVERIFY(run.output.contains("the label lies on 100 %"));
    save(rod(0.0F, 1.0F, 20, 0), "through.nrrd");
    QVERIFY(!cli({"mesh", "through.nrrd", "-o", "m.ply"}).errors.contains("the mask lies on"));
  }

  void labelsAreJoined() {
    Volume<float> labels = rod(0.0F, 1.0F);
    for (int k = 10; k < 20; ++k)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i)
          if (labels.at(i, j, k) > 0.0F) labels.at(i, j, k) = 3.0F;
    labels.voxels[0] = 2.0F;
    save(labels, "l.nrrd");
    save(rod(0.0F, 1.0F), "whole.nrrd");
    const CliResult joined = cli({"mesh", "l.nrrd", "-o", "m.ply", "--json", "--label", "1,3"});
    QVERIFY2(joined.code == 0, joined.errors.constData());
    const CliResult whole = cli({"mesh", "whole.nrrd", "-o", "m.ply", "--json"});
    QCOMPARE(volume(joined), volume(whole));
    QCOMPARE(joined.json()["source"].toObject()["labels"].toArray().size(), 2);
    QCOMPARE(cli({"mesh", "l.nrrd", "-o", "m.ply", "--label", "1,4"}).code, 2);
    QCOMPARE(cli({"mesh", "l.nrrd", "-o", "m.ply", "--label", "value:3"}).code, 0);
  }

  void scansWithoutSomeNumbersAreRead() {
    Volume<float> scan = rod(10.0F, 90.0F);
    scan.voxels[7] = std::numeric_limits<float>::quiet_NaN();
    save(scan, "scan.nii");
    const char* const said = "1 voxel is not a finite number";
    const CliResult info = cli({"info", "scan.nii", "--json"});
    QVERIFY2(info.code == 0, info.errors.constData());
    QVERIFY(info.json()["warnings"].toArray().at(0).toString().startsWith(said));
    const CliResult convert = cli({"convert", "scan.nii", "-o", "c.nrrd"});
    QCOMPARE(convert.code, 0);
    QVERIFY(convert.errors.contains(said));
    QCOMPARE(readImage(nativePath(at("c.nrrd"))).image.voxels[7], 10.0F);
    const CliResult vesselness = cli({"vesselness", "scan.nii", "-o", "v.nrrd"});
    QVERIFY2(vesselness.code == 0, vesselness.errors.constData());
    QVERIFY(vesselness.errors.contains(said));
  }
};

QTEST_APPLESS_MAIN(TestCliMasks)
#include "tst_cli_masks.moc"
