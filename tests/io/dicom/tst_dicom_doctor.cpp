// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/dicom_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

void verifyVoxelsOf(const Volume<float>& image, int slices) {
  for (int k = 0; k < slices; ++k)
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i)
        QCOMPARE(image.at(i, j, k), static_cast<float>(storedValue(i, j, k)));
}

}  // namespace

class TestDicomDoctor : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aFileThatIsThereTwiceIsUsedOnce() {
    const Folder folder;
    saveSeries(folder.path());
    fs::copy_file(folder / "0.dcm", folder / "copy.dcm");
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(screenWarnings(loaded.info).size(), std::size_t{1});
  }

  void stacksThatAreNoGridAreRefused_data() {
    QTest::addColumn<QString>("flaw");
    QTest::addColumn<QStringList>("says");
    QTest::newRow("missing slice") << "gap" << QStringList{"2.6 mm", "1.3 mm", ".dcm and "};
    QTest::newRow("uneven") << "uneven" << QStringList{"mm between", ".dcm and "};
    QTest::newRow("two in one place") << "double" << QStringList{"one place", ".dcm and "};
    QTest::newRow("tilted") << "tilt" << QStringList{"gantry tilt", "11.3 degrees", ".dcm and "};
    QTest::newRow("another size") << "size" << QStringList{"size", "9 x 7", "8 x 7", ".dcm and "};
    QTest::newRow("another orientation") << "turn" << QStringList{"orientation", ".dcm and "};
    QTest::newRow("one slice") << "single" << QStringList{"single slice", "9 x 7"};
  }
  void stacksThatAreNoGridAreRefused() {
    QFETCH(QString, flaw);
    QFETCH(QStringList, says);
    const Folder folder;
    saveSeries(folder.path(), [&](Slice& slice) {
      const int k = slice.k;
      if (flaw == "gap") return k != 3;
      if (flaw == "single") return k == 3;
      if (flaw == "uneven" && k >= 4) slice.position += 0.5 * oblique().col(2);
      if (flaw == "double" && k == 4) slice.position = sliceAt(3).position;
      if (flaw == "tilt") slice.position += 0.2 * kSpacingZ * k * oblique().col(1);
      if (flaw == "size" && k == 2) slice.columns = 8;
      if (flaw == "turn" && k == 2)
        slice.direction = Eigen::AngleAxisd(0.05, Eigen::Vector3d::UnitY()) * oblique();
      return true;
    });
    const QString message = refusal(folder.path());
    QVERIFY2(message.startsWith("Input: "), qPrintable(message));
    for (const QString& part : says) QVERIFY2(message.contains(part), qPrintable(message));
    // `info` still lists it, and says why it is not usable.
    const auto summaries = describeImages(folder.path());
    QCOMPARE(summaries.size(), flaw == "size" || flaw == "turn" ? std::size_t{2} : std::size_t{1});
    QVERIFY(summaries[0].refusal() != nullptr);
  }

  void smallUnevennessIsSaidOnly() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      if (slice.k == 3) slice.position += 0.05 * kSpacingZ * oblique().col(2);
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(screenWarnings(loaded.info).size(), std::size_t{1});
  }

  void threePlanesOfALocalizerBecomeThreeVolumes() {
    const Folder folder;
    const auto plane = [](const Eigen::Vector3d& row, const Eigen::Vector3d& column) {
      Eigen::Matrix3d m;
      m << row, column, row.cross(column);
      return m;
    };
    const std::vector<Eigen::Matrix3d> planes{
        plane(Eigen::Vector3d::UnitX(), Eigen::Vector3d::UnitY()),
        plane(Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitZ()),
        plane(Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ())};
    for (std::size_t p = 0; p < planes.size(); ++p)
      for (int k = 0; k < 4; ++k) {
        Slice slice = sliceAt(k);
        slice.instance += "." + std::to_string(p);
        slice.direction = planes[p];
        slice.position = planes[p].col(2) * (2.0 * k);
        saveSlice(slice, folder / std::to_string(10 * k + int(p)));
      }
    const auto entries = describeImages(folder.path());
    QCOMPARE(entries.size(), std::size_t{3});
    QStringList seen;
    for (const ImageSummary& entry : entries) {
      QVERIFY(entry.refusal() == nullptr);
      QVERIFY(findingOf(entry.info.findings, FindingKind::MixedOrientation) != nullptr);
      QCOMPARE(entry.geometry.size, (Index3{kColumns, kRows, 4}));
      QCOMPARE(entry.geometry.spacing[2], 2.0);
      seen << QString::fromStdString(entry.info.orientation);
    }
    seen.sort();
    QCOMPARE(seen, (QStringList{"axial", "coronal", "sagittal"}));
    const QString message = refusal(folder.path());
    QVERIFY2(message.contains("3 volumes in 1 series"), qPrintable(message));
    verifyVoxelsOf(readImage(folder.path(), {"1000001/2", false}).image, 4);
  }

  void severalTimesInOnePlaceAreSplit_data() {
    QTest::addColumn<QString>("by");
    for (const char* by : {"TemporalPosition", "EchoTime", "ImageType", "AcquisitionNumber",
                           "EchoTime and ImageType", "instance numbers", "nothing"})
      QTest::newRow(by) << by;
  }
  void severalTimesInOnePlaceAreSplit() {
    QFETCH(QString, by);
    const Folder folder;
    const int times = by == "EchoTime and ImageType" ? 4 : 3;
    for (int t = 0; t < times; ++t)
      for (int k = 0; k < kSlices; ++k) {
        Slice slice = sliceAt(k);
        slice.instance += "." + std::to_string(t);
        slice.rescaled = true;
        slice.intercept = 5000.0 * t;
        slice.edit = [&](DcmDataset& data) {
          const std::string number = std::to_string(t + 1);
          // Each slice has a time of its own, which marks no volume.
          putText(data, DCM_AcquisitionTime, "1200" + std::to_string(10 + k) + "." + number);
          if (by == "TemporalPosition") putText(data, DCM_TemporalPositionIdentifier, number);
          if (by == "EchoTime") putText(data, DCM_EchoTime, number + ".5");
          if (by == "ImageType") putText(data, DCM_ImageType, "ORIGINAL\\PRIMARY\\" + number);
          if (by == "AcquisitionNumber") putText(data, DCM_AcquisitionNumber, number);
          if (by == "EchoTime and ImageType") {
            putText(data, DCM_EchoTime, t % 2 == 0 ? "5" : "20");
            putText(data, DCM_ImageType,
                    t / 2 == 0 ? "ORIGINAL\\PRIMARY\\M" : "ORIGINAL\\PRIMARY\\P");
          }
          const int block = by == "nothing" ? k * times + t : t * kSlices + k;
          if (by == "instance numbers" || by == "nothing")
            putText(data, DCM_InstanceNumber, std::to_string(block + 1));
        };
        saveSlice(slice,
                  folder / (std::to_string((7 * k + 3 * t) % 100) + "-" + std::to_string(t)));
      }
    const auto entries = describeImages(folder.path());
    if (by == "nothing") {
      QCOMPARE(entries.size(), std::size_t{1});
      QVERIFY(entries[0].refusal() != nullptr);
      QVERIFY(entries[0].refusal()->kind == FindingKind::DuplicatePosition);
      QVERIFY(refusal(folder.path()).contains("one place"));
      return;
    }
    QCOMPARE(entries.size(), static_cast<std::size_t>(times));
    double sum = 0.0;
    for (int t = 0; t < times; ++t) {
      const ImageSummary& entry = entries[static_cast<std::size_t>(t)];
      const Finding* finding = findingOf(entry.info.findings, FindingKind::SeveralVolumes);
      QVERIFY(finding != nullptr);
      QVERIFY2(finding->text.find("differ in " + by.toStdString()) != std::string::npos,
               finding->text.c_str());
      const LoadedImage loaded = readImage(entry, folder.path(), false);
      verifyGeometry(loaded.image.geometry);
      const float base = loaded.image.at(0, 0, 0);
      verifyVoxels(loaded.image,
                   [&](int stored, int) { return static_cast<float>(stored) + base; });
      sum += static_cast<double>(base);
    }
    QCOMPARE(sum, 5000.0 * times * (times - 1) / 2);
  }

  void missingSlicesAreResampledWhenTheUserSaysSo() {
    const Folder folder;
    // Linear along the normal, so that interpolation is exact.
    const auto value = [](int i, int j, int k) { return static_cast<float>(40 * k + 3 * i + j); };
    for (int k = 0; k < 9; ++k) {
      if (k == 3 || k == 4 || k == 7) continue;
      Slice slice = sliceAt(k);
      slice.encode = [k, n = 0](int) mutable {
        const int i = n % kColumns;
        const int j = n++ / kColumns;
        return static_cast<Uint16>(40 * k + 3 * i + j);
      };
      saveSlice(slice, folder / std::to_string(90 - k));
    }
    const auto entry = describeImages(folder.path()).at(0);
    QVERIFY(entry.refusal() != nullptr);
    QVERIFY(entry.refusal()->kind == FindingKind::MissingSlices);
    QCOMPARE(entry.refusal()->slices, (std::vector<int>{3, 5}));
    const QString message = refusal(folder.path());
    QVERIFY2(message.contains("3 slices are missing: 3.9 mm between slices 3 and 4"),
             qPrintable(message));
    QVERIFY2(message.contains("88 and 85"), qPrintable(message));
    QVERIFY_THROWS_EXCEPTION(UnevenSlicesError, readImage(folder.path()));

    const LoadedImage loaded = readImage(folder.path(), {{}, true});
    QCOMPARE(loaded.image.geometry.size, (Index3{kColumns, kRows, 9}));
    QVERIFY(
        (loaded.image.geometry.spacing - Eigen::Vector3d(kSpacingX, kSpacingY, kSpacingZ)).norm() <
        1e-6);
    for (int k = 0; k < 9; ++k)
      QVERIFY(std::fabs(loaded.image.at(5, 2, k) - value(5, 2, k)) < 1e-3F);
    const Finding* said = findingOf(loaded.info.findings, FindingKind::MissingSlices);
    QVERIFY(said != nullptr && !said->refuses);
    QVERIFY2(said->text.find("3 of them interpolated") != std::string::npos, said->text.c_str());
    for (const std::string& text : reportWarnings(loaded.info))
      QVERIFY2(text.find("88") == std::string::npos, text.c_str());
  }

  void unevenSlicesAreResampledToTheSmallestDistance() {
    const Folder folder;
    const std::vector<double> heights{0.0, 1.0, 2.0, 3.5, 5.0, 7.1, 8.1};
    for (std::size_t k = 0; k < heights.size(); ++k) {
      Slice slice = sliceAt(int(k));
      slice.position = kOrigin + oblique().col(2) * heights[k];
      slice.encode = [&](int) { return static_cast<Uint16>(std::lround(100.0 * heights[k])); };
      saveSlice(slice, folder / std::to_string(k));
    }
    QVERIFY(describeImages(folder.path()).at(0).refusal()->kind == FindingKind::UnevenSpacing);
    const LoadedImage loaded = readImage(folder.path(), {{}, true});
    const Geometry& g = loaded.image.geometry;
    QVERIFY(g.spacing[2] <= 1.0 + 1e-9);
    QVERIFY(std::fabs(g.spacing[2] * (g.size[2] - 1) - 8.1) < 1e-6);
    for (int k = 0; k < g.size[2]; ++k)
      QVERIFY(std::fabs(loaded.image.at(1, 1, k) - 100.0 * k * g.spacing[2]) < 1.1);
  }

  void whatIsNoSliceIsRefusedByName_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("colour") << int(FindingKind::ColourImage);
    QTest::newRow("mosaic") << int(FindingKind::MosaicImage);
    QTest::newRow("no position") << int(FindingKind::NoPosition);
    QTest::newRow("skew rows") << int(FindingKind::NoPosition);
  }
  void whatIsNoSliceIsRefusedByName() {
    QFETCH(int, kind);
    const Folder folder;
    const QString row = QTest::currentDataTag();
    saveSeries(folder.path(), [&](Slice& slice) {
      if (row == "skew rows") slice.direction.col(1) += 0.1 * slice.direction.col(0);
      slice.edit = [&](DcmDataset& data) {
        // Three bytes for each pixel, of which the 16 bit words hold two.
        if (row == "colour") {
          data.putAndInsertUint16(DCM_SamplesPerPixel, 3);
          data.putAndInsertUint16(DCM_Rows, 1);
        }
        if (row == "mosaic") putText(data, DCM_ImageType, "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC");
        if (row == "no position") data.findAndDeleteElement(DCM_ImagePositionPatient);
      };
      return true;
    });
    const auto entries = describeImages(folder.path());
    QVERIFY(entries.at(0).refusal() != nullptr);
    QCOMPARE(int(entries.at(0).refusal()->kind), kind);
    QVERIFY(refusal(folder.path()).startsWith("Input: "));
  }
};

QTEST_APPLESS_MAIN(TestDicomDoctor)
#include "tst_dicom_doctor.moc"
