// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/base/error.h"
#include "io/image_io.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr int kColumns = 9;
constexpr int kRows = 7;
constexpr int kSlices = 6;
const double kSpacingX = 0.4;
const double kSpacingY = 0.6;
const double kSpacingZ = 1.3;

/// The stored value of a voxel: 12 bit, no two slices alike.
int storedValue(int i, int j, int k) { return (i * 5 + j * 71 + k * 503 + i * j * k) % 4096; }

/// Direction of an oblique acquisition: columns are along the row, along the column, the normal.
Eigen::Matrix3d oblique() {
  return (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}
const Eigen::Vector3d kOrigin(-31.5, 12.25, 87.125);

struct Slice {
  int k = 0;  ///< of the voxels
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d direction = oblique();
  int columns = kColumns, rows = kRows;
  double slope = 1.0, intercept = 0.0;
  bool rescaled = false;
  bool isSigned = false;
  std::string series = "1.2.3.4.1000001";
  std::string description = "tof";
  std::string instance;
};

Slice sliceAt(int k) {
  Slice slice;
  slice.k = k;
  slice.position = kOrigin + oblique().col(2) * (kSpacingZ * k);
  slice.instance = "1.2.3.4.5." + std::to_string(k + 1);
  return slice;
}

std::string numbers(const Eigen::Vector3d& v) {
  char text[100];
  std::snprintf(text, sizeof(text), "%.9g\\%.9g\\%.9g", v.x(), v.y(), v.z());
  return text;
}

void putText(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
  item.putAndInsertString(tag, text.c_str());
}

void putCommon(DcmDataset& data, const Slice& slice, const char* sopClass) {
  putText(data, DCM_SOPClassUID, sopClass);
  putText(data, DCM_SOPInstanceUID, slice.instance);
  putText(data, DCM_PatientName, "Doe^Jane");
  putText(data, DCM_PatientID, "4711");
  putText(data, DCM_PatientBirthDate, "19700101");
  putText(data, DCM_Modality, "MR");
  putText(data, DCM_SeriesInstanceUID, slice.series);
  putText(data, DCM_SeriesDescription, slice.description);
  data.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(slice.rows));
  data.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(slice.columns));
  data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  putText(data, DCM_PhotometricInterpretation, "MONOCHROME2");
  data.putAndInsertUint16(DCM_BitsAllocated, 16);
  data.putAndInsertUint16(DCM_BitsStored, slice.isSigned ? 16 : 12);
  data.putAndInsertUint16(DCM_HighBit, slice.isSigned ? 15 : 11);
  data.putAndInsertUint16(DCM_PixelRepresentation, slice.isSigned ? 1 : 0);
}

void appendPixels(const Slice& slice, std::vector<Uint16>& pixels) {
  for (int j = 0; j < slice.rows; ++j)
    for (int i = 0; i < slice.columns; ++i) {
      const int value = storedValue(i, j, slice.k) - (slice.isSigned ? 2000 : 0);
      pixels.push_back(static_cast<Uint16>(value));
    }
}

void saveSlice(const Slice& slice, const fs::path& path,
               E_TransferSyntax syntax = EXS_LittleEndianExplicit) {
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  putCommon(data, slice, UID_MRImageStorage);
  putText(data, DCM_ImagePositionPatient, numbers(slice.position));
  putText(data, DCM_ImageOrientationPatient,
          numbers(slice.direction.col(0)) + "\\" + numbers(slice.direction.col(1)));
  putText(data, DCM_PixelSpacing, std::to_string(kSpacingY) + "\\" + std::to_string(kSpacingX));
  putText(data, DCM_WindowCenter, "300\\40");
  putText(data, DCM_WindowWidth, "600\\400");
  if (slice.rescaled) {
    putText(data, DCM_RescaleSlope, std::to_string(slice.slope));
    putText(data, DCM_RescaleIntercept, std::to_string(slice.intercept));
  }
  std::vector<Uint16> pixels;
  appendPixels(slice, pixels);
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  if (DcmXfer(syntax).isEncapsulated()) QVERIFY(data.chooseRepresentation(syntax, nullptr).good());
  const OFCondition status = format.saveFile(path.c_str(), syntax);
  QVERIFY2(status.good(), status.text());
}

/// A series whose file names have nothing to do with the order of its slices.
void saveSeries(const fs::path& folder, const std::function<bool(Slice&)>& change = {},
                E_TransferSyntax syntax = EXS_LittleEndianExplicit,
                const std::string& prefix = "") {
  for (int k = 0; k < kSlices; ++k) {
    Slice slice = sliceAt(k);
    if (change && !change(slice)) continue;
    saveSlice(slice, folder / (prefix + std::to_string(k * 5 % 7) + ".dcm"), syntax);
  }
}

/// An enhanced multi-frame object with `order[f]` the slice that frame f shows.
void saveEnhanced(const fs::path& path, const std::vector<int>& order, bool withGroups = true) {
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  Slice common = sliceAt(0);
  putCommon(data, common, UID_EnhancedMRImageStorage);
  putText(data, DCM_NumberOfFrames, std::to_string(order.size()));
  if (withGroups) {
    DcmItem* shared = nullptr;
    DcmItem* item = nullptr;
    data.findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, -2);
    shared->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, item, -2);
    putText(*item, DCM_ImageOrientationPatient,
            numbers(oblique().col(0)) + "\\" + numbers(oblique().col(1)));
    shared->findOrCreateSequenceItem(DCM_PixelMeasuresSequence, item, -2);
    putText(*item, DCM_PixelSpacing, std::to_string(kSpacingY) + "\\" + std::to_string(kSpacingX));
    for (const int k : order) {
      DcmItem* frame = nullptr;
      data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, -2);
      frame->findOrCreateSequenceItem(DCM_PlanePositionSequence, item, -2);
      putText(*item, DCM_ImagePositionPatient, numbers(sliceAt(k).position));
      frame->findOrCreateSequenceItem(DCM_PixelValueTransformationSequence, item, -2);
      putText(*item, DCM_RescaleSlope, "0.5");
      putText(*item, DCM_RescaleIntercept, "-7");
    }
  }
  std::vector<Uint16> pixels;
  for (const int k : order) appendPixels(sliceAt(k), pixels);
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  QVERIFY(format.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
}

void verifyGeometry(const Geometry& g) {
  QCOMPARE(g.size, (Index3{kColumns, kRows, kSlices}));
  QVERIFY((g.spacing - Eigen::Vector3d(kSpacingX, kSpacingY, kSpacingZ)).norm() < 1e-6);
  QVERIFY((g.origin - kOrigin).norm() < 1e-6);
  QVERIFY((g.direction - oblique()).norm() < 1e-6);
}

void verifyVoxels(const Volume<float>& image,
                  const std::function<float(int stored, int k)>& value) {
  for (int k = 0; k < kSlices; ++k)
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i)
        QCOMPARE(image.at(i, j, k), value(storedValue(i, j, k), k));
}

QString refusal(const fs::path& path, const std::string& uid = {}) {
  try {
    readImage(path, uid);
  } catch (const InputError& error) {
    return QString("Input: ") + error.what();
  } catch (const IoError& error) {
    return QString("Io: ") + error.what();
  }
  return "accepted";
}

const auto plain = [](int stored, int) { return static_cast<float>(stored); };

}  // namespace

class TestDicom : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    DcmRLEEncoderRegistration::registerCodecs();
    DJLSEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs();
  }
  void cleanupTestCase() {
    DcmRLEEncoderRegistration::cleanup();
    DJLSEncoderRegistration::cleanup();
    DJEncoderRegistration::cleanup();
  }

  void anObliqueSeriesIsReadVoxelByVoxel_data() {
    QTest::addColumn<int>("syntax");
    QTest::newRow("little endian") << int(EXS_LittleEndianExplicit);
    QTest::newRow("implicit") << int(EXS_LittleEndianImplicit);
    QTest::newRow("big endian") << int(EXS_BigEndianExplicit);
    QTest::newRow("deflated") << int(EXS_DeflatedLittleEndianExplicit);
    QTest::newRow("RLE") << int(EXS_RLELossless);
    QTest::newRow("JPEG lossless") << int(EXS_JPEGProcess14SV1);
    QTest::newRow("JPEG-LS") << int(EXS_JPEGLSLossless);
  }
  void anObliqueSeriesIsReadVoxelByVoxel() {
    QFETCH(int, syntax);
    const Folder folder;
    saveSeries(folder.path(), {}, static_cast<E_TransferSyntax>(syntax));
    save(folder / "readme.txt", "not DICOM");
    fs::create_directory(folder / "subfolder");
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image, plain);
    QCOMPARE(loaded.info.format, std::string("DICOM"));
    QCOMPARE(loaded.info.modality, std::string("MR"));
    QCOMPARE(loaded.info.pixelType, std::string("uint16"));
    QCOMPARE(loaded.info.files, kSlices);
    QCOMPARE(loaded.info.window.value_or(0.0), 600.0);
    QCOMPARE(loaded.info.level.value_or(0.0), 300.0);
    QVERIFY(loaded.info.warnings.empty());
  }

  void jpeg2000IsRead() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.rescaled = true;
      slice.slope = 0.5;
      slice.intercept = -3.0;
      return true;
    });
    gdcm::Trace::WarningOff();
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      gdcm::ImageReader reader;
      reader.SetFileName(entry.path().c_str());
      QVERIFY(reader.Read());
      gdcm::ImageChangeTransferSyntax change;
      change.SetTransferSyntax(gdcm::TransferSyntax::JPEG2000Lossless);
      change.SetInput(reader.GetImage());
      QVERIFY(change.Change());
      gdcm::ImageWriter writer;
      writer.SetFile(reader.GetFile());
      writer.SetImage(change.GetOutput());
      writer.SetFileName(entry.path().c_str());
      QVERIFY(writer.Write());
    }
    gdcm::Trace::WarningOn();
    TerminalCapture terminal;
    const LoadedImage loaded = readImage(folder.path());
    QCOMPARE(terminal.text(), QString());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image,
                 [](int stored, int) { return static_cast<float>(0.5 * stored - 3.0); });
  }

  void valuesAreRescaledSliceBySlice() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.rescaled = slice.isSigned = true;
      slice.slope = 0.25 * (slice.k + 1);
      slice.intercept = -1024.5;
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyVoxels(loaded.image, [](int stored, int k) {
      return static_cast<float>(0.25 * (k + 1) * (stored - 2000) - 1024.5);
    });
    QCOMPARE(loaded.info.pixelType, std::string("int16"));
    QCOMPARE(loaded.info.warnings.size(), std::size_t{1});
  }

  void anEnhancedFileIsReadInAnyOrderOfFrames() {
    const Folder folder;
    saveEnhanced(folder / "e.dcm", {4, 1, 0, 5, 3, 2});
    for (const fs::path& path : {folder / "e.dcm", folder.path()}) {
      const LoadedImage loaded = readImage(path);
      verifyGeometry(loaded.image.geometry);
      verifyVoxels(loaded.image,
                   [](int stored, int) { return static_cast<float>(0.5 * stored - 7.0); });
    }
    QCOMPARE(describeImages(folder / "e.dcm").at(0).geometry.size[2], kSlices);
    saveEnhanced(folder / "e.dcm", {0, 1, 2}, false);
    QVERIFY(refusal(folder / "e.dcm").startsWith("Input: the position"));
  }

  void emptyFilesThatShouldBeSlicesAreSaid() {
    const Folder folder;
    saveSeries(folder.path());
    save(folder / "empty.dcm", "");
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(loaded.info.warnings.size(), std::size_t{1});
    QCOMPARE(describeImages(folder.path()).at(0).info.warnings, loaded.info.warnings);
  }

  void aFileThatIsThereTwiceIsUsedOnce() {
    const Folder folder;
    saveSeries(folder.path());
    fs::copy_file(folder / "0.dcm", folder / "copy.dcm");
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(loaded.info.warnings.size(), std::size_t{1});
  }

  void seriesAreChosenByTheirUid() {
    const Folder folder;
    saveSeries(folder.path());
    saveSeries(
        folder.path(),
        [](Slice& slice) {
          slice.series = "1.2.3.4.2000002";
          slice.description = "phase";
          slice.rescaled = true;
          slice.intercept = 5000.0;
          slice.instance += ".9";
          return true;
        },
        EXS_LittleEndianExplicit, "b");
    const QString message = refusal(folder.path());
    QVERIFY2(message.startsWith("Input: the folder holds 2 series"), qPrintable(message));
    for (const char* part :
         {".1000001", ".2000002", "\"tof\"", "\"phase\"", "9 x 7 x 6", "--series"})
      QVERIFY2(message.contains(part), qPrintable(message));
    verifyVoxels(readImage(folder.path(), "1.2.3.4.1000001").image, plain);
    verifyVoxels(readImage(folder.path(), "2000002").image,
                 [](int stored, int) { return static_cast<float>(stored + 5000); });
    QVERIFY(refusal(folder.path(), "9.9").startsWith("Input: there is no series 9.9"));
    QVERIFY(refusal(folder.path(), "").contains("2 series"));

    const auto summaries = describeImages(folder.path());
    QCOMPARE(summaries.size(), std::size_t{2});
    for (const ImageSummary& summary : summaries) {
      verifyGeometry(summary.geometry);
      QCOMPARE(summary.info.files, kSlices);
    }
    QCOMPARE(summaries[1].info.seriesDescription, std::string("phase"));
  }

  void nothingSaysWhoThePatientIs() {
    const Folder folder;
    saveSeries(folder.path());
    const InputInfo info = readImage(folder.path()).info;
    std::string all =
        info.format + info.modality + info.pixelType + info.seriesUid + info.seriesDescription;
    for (const std::string& warning : info.warnings) all += warning;
    for (const char* identity : {"Doe", "Jane", "4711", "1970"})
      QVERIFY(all.find(identity) == std::string::npos);
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
    QCOMPARE(summaries.size(), std::size_t{1});
    QVERIFY(!summaries[0].info.warnings.empty());
  }

  void smallUnevennessIsSaidOnly() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      if (slice.k == 3) slice.position += 0.05 * kSpacingZ * oblique().col(2);
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(loaded.info.warnings.size(), std::size_t{1});
  }

  void damagedFilesAreRefused() {
    const Folder folder;
    saveSeries(folder.path());
    const std::string whole = bytesOf(folder / "0.dcm");
    TerminalCapture terminal;
    QString missed;
    // Shorter than 133 bytes nothing says that this is DICOM: it is left out, as other files are.
    for (std::size_t length = 133; length < whole.size(); length += 3) {
      save(folder / "0.dcm", whole.substr(0, length));
      const QString message = refusal(folder.path());
      if (!message.startsWith("Io: ") || !message.contains("0.dcm"))
        missed += QString(" %1 of %2: %3").arg(length).arg(whole.size()).arg(message);
    }
    QCOMPARE(terminal.text(), QString());
    QVERIFY2(missed.isEmpty(), qPrintable(missed));
  }

  void foldersWithoutImagesAreRefused() {
    const Folder folder;
    QVERIFY(refusal(folder.path()).startsWith("Input: the folder holds no DICOM image"));
    fs::create_directory(folder / "sub");
    QVERIFY(refusal(folder.path()).contains("subfolder"));
    QVERIFY(refusal(folder / "none").startsWith("Io: "));
  }

  void readingCanBeCancelled() {
    const Folder folder;
    saveSeries(folder.path());
    const Progress progress;
    progress.cancel();
    QVERIFY_EXCEPTION_THROWN(readImage(folder.path(), {}, progress), Cancelled);
  }

  void aRealSeriesIsRead() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const fs::path path = fs::path(data.toStdString()) / "head-mr-dicom";
    const LoadedImage loaded = readImage(path);
    QCOMPARE(loaded.image.geometry.size, (Index3{512, 512, 120}));
    QCOMPARE(loaded.info.files, 120);
    QVERIFY(std::fabs(loaded.image.geometry.spacing[2] - 1.5) < 1e-3);
    QVERIFY(loaded.info.warnings.empty());
    QVERIFY(loaded.info.window.has_value());
  }
};

QTEST_APPLESS_MAIN(TestDicom)
#include "tst_dicom.moc"
