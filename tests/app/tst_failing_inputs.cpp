// SPDX-License-Identifier: BSD-3-Clause
// The inputs of ANGIOMESH_DATA/failing/README.md: the right value, or one clear line, for each.
#include <QJsonArray>
#include <QRegularExpression>
#include <QTest>
#include <cmath>

#include "core/openings/port.h"
#include "core/quality/mesh_quality.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "tests/app/cli_process.h"

using namespace angiomesh;

namespace {

using Numbers = QVector<double>;

/// Of a regular polygon.
double polygonArea(int corners, double radius) {
  return 0.5 * corners * radius * radius * std::sin(2.0 * M_PI / corners);
}

/// The closed tube of many of the inputs: 16 corners around, radius 2, 10 long.
const double kTubeMm3 = 10.0 * polygonArea(16, 2.0);

bool near(const QJsonArray& numbers, const Numbers& wanted) {
  bool all = numbers.size() == wanted.size();
  for (qsizetype n = 0; all && n < wanted.size(); ++n)
    all = std::fabs(numbers[n].toDouble() - wanted[n]) < 1e-6 * (1.0 + std::fabs(wanted[n]));
  return all;
}

QString warningsOf(const QJsonObject& info) {
  QStringList lines;
  for (const QJsonValue& line : info["warnings"].toArray()) lines += line.toString();
  return lines.join('\n');
}

}  // namespace

class TestFailingInputs : public QObject, CliFolder {
  Q_OBJECT

  QString folder_;

  [[nodiscard]] QString input(const QString& name) const { return folder_ + '/' + name; }
  [[nodiscard]] std::string native(const QString& name) const { return at(name).toStdString(); }

  /// A call that has to succeed.
  [[nodiscard]] CliResult done(const QStringList& arguments) const {
    CliResult result = cli(arguments);
    if (result.code != 0) qWarning("%s", result.errors.constData());
    return result;
  }
  [[nodiscard]] QJsonObject info(const QString& file) const {
    return done({"info", file, "--json"}).json();
  }
  static void verifyPlace(const QJsonObject& image, const Numbers& spacing, const Numbers& origin,
                          const Numbers& signs) {
    QVERIFY(near(image["spacing_mm"].toArray(), spacing));
    QVERIFY(near(image["origin_mm"].toArray(), origin));
    const QJsonArray rows = image["direction"].toArray();
    for (qsizetype a = 0; a < 3; ++a) {
      Numbers row(3, 0.0);
      row[a] = signs[a];
      QVERIFY(near(rows[a].toArray(), row));
    }
  }
  /// One line that holds `words`, and exit code 2.
  void verifyRefused(const CliResult& result, const QByteArray& words) const {
    QVERIFY2(result.errorLines().size() == 1, result.errors.constData());
    QVERIFY2(result.errors.contains(words), result.errors.constData());
    QCOMPARE(result.code, 2);
  }
  void write(const QString& name, const QByteArray& bytes) const {
    QFile file(at(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
  }
  /// What convert makes of a mesh of `folder_`, in the file m.ply.
  [[nodiscard]] CliResult convert(const QString& name, const QStringList& options = {}) const {
    QFile::remove(at("m.ply"));
    return done(QStringList{"convert", input(name), "-o", "m.ply"} + options);
  }
  [[nodiscard]] LoadedMesh loaded(const QString& name = "m.ply") const {
    return loadMesh(native(name));
  }
  [[nodiscard]] MeshQuality quality(const QString& name = "m.ply") const {
    return measureQuality(loaded(name).mesh);
  }
  void verifyTube() const {
    const MeshQuality mesh = quality();
    QVERIFY(mesh.closed && mesh.oriented);
    QCOMPARE(mesh.selfIntersections, std::size_t{0});
    QVERIFY2(std::fabs(mesh.volumeMm3 / kTubeMm3 - 1.0) < 1e-5,
             qPrintable(QString::number(mesh.volumeMm3)));
  }
  [[nodiscard]] QStringList patchFiles(const QString& mesh) const {
    for (const QString& old : filesIn(dir.path()))
      if (old.startsWith("parts")) QFile::remove(at(old));
    (void)done({"convert", mesh, "-o", "parts.stl", "--patch-files"});
    return filesIn(dir.path()).filter("parts_");
  }
  [[nodiscard]] static double volumeOf(const CliResult& mesh) {
    return mesh.json()["source"].toObject()["mesh_volume_mm3"].toDouble();
  }

 private Q_SLOTS:
  void initTestCase() {
    if (!qEnvironmentVariableIsSet("ANGIOMESH_DATA")) QSKIP("ANGIOMESH_DATA is not set");
    folder_ = qEnvironmentVariable("ANGIOMESH_DATA") + "/failing";
    if (!QFile::exists(folder_)) QSKIP("ANGIOMESH_DATA does not hold these inputs");
    QVERIFY(dir.isValid());
  }

  void theTubeIsTheOneOfTheInputs() {
    QVERIFY(convert("stl-solid-names-with-space.stl").code == 0);
    verifyTube();
  }

  void volumesLieWhereTheirHeadersSay_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<Numbers>("spacing");
    QTest::addColumn<Numbers>("origin");
    QTest::addColumn<Numbers>("signs");  // of the axes, which are those of the patient
    QTest::addColumn<Numbers>("range");
    QTest::addColumn<QString>("warning");
    const Numbers usual{0.5, 0.6, 0.8}, lps{1, 1, 1}, ras{-1, -1, 1}, range{-485, 1496};
    const auto row = [&](const char* file, const Numbers& signs, const char* warning = "",
                         const Numbers& spacing = Numbers{0.5, 0.6, 0.8},
                         const Numbers& place = Numbers{-10, 20, 30}) {
      QTest::addRow("%s", file) << QString(file) << spacing << place << signs << range
                                << QString(warning);
    };
    row("nrrd-space-LAS.nrrd", {1, -1, 1}, "", usual, {-10, -20, 30});
    row("nifti-sform-qform-disagree.nii", ras, "turned by 180 degrees): the sform is taken");
    row("nifti-sform-scale-against-pixdim.nii", ras,
        "voxels of 1 x 1 x 1 against 0.5 x 0.6 x 0.8 mm): the sform is taken", {1, 1, 1});
    row("nrrd-space-units-um.nrrd", lps);
    row("nrrd-third-spacing-nan.nrrd", lps, "voxel spacing along axis 3: 1 mm is assumed",
        {0.5, 0.6, 1}, {0, 0, 0});
    row("nrrd-encoding-upper-case.nrrd", lps);
    row("nifti-scl-slope-nan.nii", ras);
    row("UP.NII.GZ", ras);
    row("nifti-one-nan.nii", ras, "1 voxel is not a finite number: it becomes the least value");
    row("base.nii", ras);
  }
  void volumesLieWhereTheirHeadersSay() {
    QFETCH(QString, file);
    QFETCH(Numbers, spacing);
    QFETCH(Numbers, origin);
    QFETCH(Numbers, signs);
    QFETCH(Numbers, range);
    QFETCH(QString, warning);
    const QJsonObject all = info(input(file)), image = all["input"].toObject();
    verifyPlace(image, spacing, origin, signs);
    QVERIFY(near(image["range"].toArray(), range));
    const QString said = warningsOf(all);
    QVERIFY2(said.contains(warning), qPrintable(said));
    QCOMPARE(said.isEmpty(), warning.isEmpty());
    const CliResult copy = done({"convert", input(file), "-o", "copy.nrrd"});
    verifyPlace(info("copy.nrrd")["input"].toObject(), spacing, origin, signs);
    QVERIFY(copy.errors.contains(warning.toUtf8()));
  }

  void slicesOfOneSeriesAreOneVolume_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("finding");
    QTest::addColumn<Numbers>("range");
    QTest::newRow("frames of reference") << "dicom-frame-of-reference-per-slice"
                                         << "5 frames of reference" << Numbers{9, 3986};
    QTest::newRow("instance UIDs")
        << "dicom-same-sop-uid"
        << "4 images have the instance UID of another" << Numbers{9, 3986};
    QTest::newRow("float pixels") << "dicom-float-pixel-data"
                                  << "" << Numbers{3.33, 1474.82};
  }
  void slicesOfOneSeriesAreOneVolume() {
    QFETCH(QString, folder);
    QFETCH(QString, finding);
    QFETCH(Numbers, range);
    const QJsonObject image = info(input(folder))["input"].toObject();
    QVERIFY(near(image["size"].toArray(), {6, 8, 5}));
    QCOMPARE(image["files"].toInt(), 5);
    verifyPlace(image, {0.5, 0.6, 0.8}, {-10, 20, 30}, {1, 1, 1});
    QVERIFY(near(image["range"].toArray(), range));
    const QJsonArray findings = image["findings"].toArray();
    QCOMPARE(findings.size(), finding.isEmpty() ? 0 : 1);
    QVERIFY(findings.first().toObject()["text"].toString().contains(finding));
  }

  void aSegmentationOfDicomIsReadAsLabels() {
    const QJsonObject image = info(input("dicom-seg-one-segment.dcm"))["input"].toObject();
    verifyPlace(image, {0.5, 0.5, 0.8}, {-10, 20, 30}, {1, 1, 1});
    const QJsonArray labels = image["labels"].toArray();
    QCOMPARE(labels.size(), 1);
    QCOMPARE(labels[0].toObject()["voxels"].toInt(), 96);
    QCOMPARE(labels[0].toObject()["name"].toString(), "artery1");
  }

  void oneOfSeveralVolumesIsTakenOut() {
    const QString file = input("nrrd-4d-without-kinds.nrrd");
    verifyRefused(cli({"info", file}), "convert --component N', N from 0 to 1");
    for (const char* n : {"0", "1"}) {
      QCOMPARE(done({"convert", file, "--component", n, "-o", "c.nrrd"}).code, 0);
      const QJsonObject image = info("c.nrrd")["input"].toObject();
      QVERIFY(near(image["size"].toArray(), {7, 6, 5}));
      verifyPlace(image, {0.5, 0.6, 0.8}, {-10, 20, 30}, {1, 1, 1});
      QVERIFY(near(image["range"].toArray(), {-485, 1496}));
    }
  }

  /// The folder lacks dh.raw, which the header names.
  void aVoxelFileOfAnotherSizeIsSaid() {
    verifyRefused(cli({"info", input("data-file-too-long.mhd")}), "'dh.raw'");
    const QByteArray header = readBytes(input("data-file-too-long.mhd"));
    const QByteArray voxels = readBytes(input("d.raw"));
    QCOMPARE(voxels.size(), 7 * 6 * 5 * 2);
    QVERIFY(QDir(dir.path()).mkpath("long"));
    write("long/h.mhd", header);
    write("long/dh.raw", voxels);
    QCOMPARE(warningsOf(info("long/h.mhd")), QString());
    write("long/dh.raw", QByteArray(100, '\1') + voxels);
    const QString said = warningsOf(info("long/h.mhd"));
    QVERIFY2(said.contains("100 bytes more than the header says"), qPrintable(said));
  }

  void aFieldThatNrrdDoesNotHaveIsNamed() {
    verifyRefused(cli({"info", input("nhdr-unknown-field.nhdr")}), "'AnatomicalOrientation'");
  }

  void whatIsWrittenUnderAnyNameIsRead() {
    for (const char* name : {"x 77 %.mhd", "x 77 %.nhdr"}) {
      QCOMPARE(done({"convert", input("base.nii"), "-o", name}).code, 0);
      QVERIFY(readImage(native(name)).image.voxels ==
              readImage(input("base.nii").toStdString()).image.voxels);
    }
  }

  void aMaskWithASlopeIsRounded() {
    const CliResult mesh =
        done({"mesh", input("mask-nibabel-uint8.nii.gz"), "-o", "a.ply", "--json"});
    QCOMPARE(mesh.code, 0);
    QVERIFY2(mesh.errors.contains("were rounded"), mesh.errors.constData());
    QCOMPARE(mesh.json()["source"].toObject()["voxels"].toInt(), 10816);
    QVERIFY(std::fabs(volumeOf(mesh) / 10816.0 - 1.0) < 0.02);
    QVERIFY(quality("a.ply").closed);
  }

  void aMaskOfTwoSlicesSaysWhatIsLost() {
    const CliResult mesh = done({"mesh", input("mask-two-slices.nrrd"), "-o", "a.ply"});
    QCOMPARE(mesh.code, 0);
    QVERIFY2(mesh.errors.contains("it holds 50 % of the label's voxels"), mesh.errors.constData());
  }

  void segmentsOfOneNameAreToldApart() {
    const QString file = input("segments-of-one-name.seg.nrrd");
    const auto mesh = [&](const char* label) {
      return cli({"mesh", file, "--label", label, "-o", "a.ply", "--json"});
    };
    verifyRefused(mesh("artery"), "several labels fit 'artery'");
    const CliResult first = mesh("id:S1"), second = mesh("7");
    QCOMPARE(first.json()["source"].toObject()["voxels"].toInt(), 10816);
    QCOMPARE(second.json()["source"].toObject()["voxels"].toInt(), 1508);
  }

  void severalLabelsAreJoined() {
    const CliResult mesh =
        done({"mesh", input("nnunet.mha"), "--label", "1,3", "-o", "a.ply", "--json"});
    const QJsonObject source = mesh.json()["source"].toObject();
    const QJsonArray labels = source["labels"].toArray();
    QCOMPARE(labels.size(), 2);
    QCOMPARE(labels[0].toObject()["value"].toInt(), 1);
    QCOMPARE(labels[1].toObject()["value"].toInt(), 3);
    QCOMPARE(source["voxels"].toInt(), 3312 + 1250);
    QVERIFY(std::fabs(source["volume_change_percent"].toDouble()) < 2.0);
  }

  void voxelsThatShareAnEdgeAreOnePartOrTwo() {
    for (const char* shared : {"edges", "faces"}) {
      const CliResult mesh = done({"mesh", input("edge.mha"), "-o", "a.ply", "--json", "--set",
                                   QString("segmentation.connectivity=") + shared});
      const QJsonObject surface = mesh.json()["surface"].toObject();
      QCOMPARE(surface["components"].toArray().size(), shared == QString("edges") ? 1 : 2);
      QCOMPARE(surface["unverified"].toInt(), 0);
      QVERIFY(quality("a.ply").closed);
      QVERIFY(mesh.errors.contains("share only an edge"));
    }
  }

  void aCheckerboardIsMeshed() {
    const CliResult mesh = done({"mesh", input("mask-checkerboard-8.nrrd"), "-o", "a.ply"});
    QCOMPARE(mesh.code, 0);
    const MeshQuality surface = quality("a.ply");
    QVERIFY(surface.closed && surface.oriented);
    QCOMPARE(surface.selfIntersections, std::size_t{0});
  }

  void whatTakesLongIsSaidBefore() {
    const CliResult noise = done({"mesh", input("mask-3-percent-noise.nrrd"), "--estimate"});
    QCOMPARE(noise.code, 0);
    QVERIFY2(noise.errors.contains("triangles are expected"), noise.errors.constData());
    QVERIFY(noise.errors.contains("longer edges"));
  }

  /// Nothing tells the marrow in a bone from a vessel once the bone is taken out, and half of the
  /// vessel is too faint beside tissue: both is said, and what is advised helps.
  void marrowAndAHoledVesselAreSaid() {
    const QStringList call{"run",      input("wide-vessel-beside-bone.mha"),
                           "--truth",  input("wide-vessel-beside-bone-truth.mha"),
                           "--preset", "ct",
                           "--until",  "evolve",
                           "-o",       "wide",
                           "--force"};
    const auto reportOf = [&](const QStringList& choice) {
      const CliResult run = done(call + choice);
      QFile file(at("wide/report.json"));
      return run.code == 0 && file.open(QIODevice::ReadOnly)
                 ? QJsonDocument::fromJson(file.readAll()).object()
                 : QJsonObject();
    };
    const QJsonObject alone = reportOf({});
    const QString words = warningsOf(alone);
    const QRegularExpression advice(
        "a part that is 4\\d % of the segmentation is no vessel: 9\\d % of "
        "what lies around it is brighter.* segmentation.drop = (\\S+)");
    const QRegularExpressionMatch match = advice.match(words);
    QVERIFY2(match.hasMatch(), qPrintable(words));
    QVERIFY2(words.contains("the vessels are full of holes") &&
                 words.contains("lower vesselness.c, which is 33.3 here"),
             qPrintable(words));
    const QJsonObject advised =
        reportOf({"--set", "segmentation.drop=" + match.captured(1), "--set", "vesselness.c=20",
                  "--set", "vesselness.sigmaMaxMm=8.5"});
    const double before = alone["truth"].toObject()["overlap"].toDouble();
    const double after = advised["truth"].toObject()["overlap"].toDouble();
    QVERIFY2(before < 65.0 && after > 95.0, qPrintable(QString("%1 -> %2").arg(before).arg(after)));
  }

  void aRoughLevelSetMakesASoundSurface() {
    const CliResult mesh =
        cli({"mesh", input("phi-cta-crop.nrrd"), "-o", "a.ply", "--set", "surface.edgeMinMm=0.8"});
    if (mesh.code == 3) {
      QVERIFY2(mesh.errors.contains("cuts itself") && mesh.errors.contains("near"),
               mesh.errors.constData());
      QVERIFY(!QFile::exists(at("a.ply")));
      return;
    }
    QCOMPARE(mesh.code, 0);
    const MeshQuality surface = quality("a.ply");
    QCOMPARE(surface.selfIntersections + surface.nonManifoldEdges + surface.nonManifoldVertices,
             std::size_t{0});
    QVERIFY(surface.closed && surface.oriented);
  }

  void aStraightTubeIsCut() {
    const CliResult mesh =
        done({"mesh", input("r6_phi.nrrd"), "--cut", "31.5,31.5,43.5,0,0,1,out", "-o", "a.ply"});
    QCOMPARE(mesh.errors, QByteArray());
    const LoadedMesh cut = loaded("a.ply");
    QCOMPARE(cut.patchNames.size(), std::size_t{3});
    QCOMPARE(cut.patchNames[1], std::string("out"));
    const Port out = measurePatches(cut.mesh, 2)[0];
    QVERIFY((out.centreLps - Eigen::Vector3d(31.5, 31.5, 43.5)).norm() < 0.05);
    QVERIFY(std::fabs(out.areaMm2 / (M_PI * 6.0 * 6.0) - 1.0) < 0.01);
    for (const Eigen::Vector3d& p : cut.mesh.points) QVERIFY(p.z() < 43.5 + 1e-6);
  }

  void namesWithBlanksStayApart() {
    const QString file = input("stl-solid-names-with-space.stl");
    const QStringList three{"parts_outlet_1.stl", "parts_outlet_2.stl", "parts_wall.stl"};
    QCOMPARE(patchFiles(file), three);
    QCOMPARE(done({"convert", file, "-o", "names.obj"}).code, 0);
    write("names.obj", readBytes(at("names.obj")).replace("g outlet_", "g outlet "));
    QCOMPARE(patchFiles("names.obj"), three);
    QCOMPARE(done({"convert", file, "--openfoam", "-o", "foam"}).code, 0);
    const QByteArray surface = readBytes(at("foam/constant/triSurface/vessel.stl"));
    for (const char* solid : {"\nsolid outlet_1\n", "\nsolid outlet_2\n"})
      QCOMPARE(surface.count(solid), 1);
  }

  void pointsThatAreNotSharedAreJoined() {
    QVERIFY(convert("ply-points-not-shared.ply").errors.contains("878 points"));
    verifyTube();
  }

  void trianglesThatAreTurnedAreTurnedBack() {
    QVERIFY(convert("stl-a-third-turned.stl").errors.contains("118 triangles were not oriented"));
    verifyTube();
  }

  void stlInCapitalsIsRead() {
    QCOMPARE(convert("stl-upper-case.stl").code, 0);
    verifyTube();
  }

  void theFaceIdsOfVmtkArePatches() {
    QVERIFY(convert("vtp-vmtk-CellEntityIds.vtp").errors.contains("1 is taken for the wall"));
    verifyTube();
    const LoadedMesh tube = loaded();
    QCOMPARE(tube.patchNames, (std::vector<std::string>{"wall", "face_2", "face_3"}));
    for (const Port& end : measurePatches(tube.mesh, 2))
      QVERIFY(std::fabs(end.areaMm2 / polygonArea(16, 2.0) - 1.0) < 1e-6);
  }

  void aRingWithABridgeHasItsArea() {
    QCOMPARE(convert("ring-ngon-with-bridge.obj").code, 0);
    const double area = polygonArea(16, 2.0) - polygonArea(16, 1.0);
    QVERIFY(std::fabs(quality().areaMm2 / area - 1.0) < 1e-6);
  }

  void cracksAreSaidAndClosed() {
    const CliResult open = convert("stl-cracks-1e-6.stl");
    QVERIFY2(open.errors.contains("878 points at open edges") &&
                 open.errors.contains("--merge-distance 0.0001 joins them"),
             open.errors.constData());
    QCOMPARE(convert("stl-cracks-1e-6.stl", {"--merge-distance", "0.0001"}).code, 0);
    verifyTube();
  }
};

QTEST_GUILESS_MAIN(TestFailingInputs)
#include "tst_failing_inputs.moc"
