// SPDX-License-Identifier: BSD-3-Clause
#include "tests/io/dicom_writer.h"
#include "tests/io/jpeg2000_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// The big-endian bytes of a number.
std::string big(std::uint32_t number, std::size_t bytes) {
  std::string text;
  for (std::size_t i = bytes; i-- > 0;) text += static_cast<char>((number >> (8 * i)) & 0xffU);
  return text;
}

}  // namespace

class TestDicom : public QObject {
  Q_OBJECT

  Encoders encoders_;

 private Q_SLOTS:
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
    QCOMPARE(loaded.info.windows.at(0).width, 600.0);
    QCOMPARE(loaded.info.windows.at(0).level, 300.0);
    QVERIFY(screenWarnings(loaded.info).empty());
  }

  void jpeg2000IsRead() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.rescaled = true;
      slice.slope = 0.5;
      slice.intercept = -3.0;
      return true;
    });
    for (const auto& entry : fs::directory_iterator(folder.path())) toJpeg2000(entry.path());
    TerminalCapture terminal;
    const LoadedImage loaded = readImage(folder.path());
    QCOMPARE(terminal.text(), QString());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image,
                 [](int stored, int) { return static_cast<float>(0.5 * stored - 3.0); });
  }

  void jpeg2000IsReadFrameByFrame() {
    const Folder folder;
    saveEnhanced(folder / "e", {4, 1, 0, 5, 3, 2});
    toJpeg2000(folder / "e");
    TerminalCapture terminal;
    const LoadedImage loaded = readImage(folder.path());
    QCOMPARE(terminal.text(), QString());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image,
                 [](int stored, int) { return static_cast<float>(0.5 * stored - 7.0); });
  }

  void signedJpeg2000IsRead() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) { return slice.isSigned = true; });
    for (const auto& entry : fs::directory_iterator(folder.path())) toJpeg2000(entry.path());
    verifyVoxels(readImage(folder.path()).image,
                 [](int stored, int) { return static_cast<float>(stored - 2000); });
  }

  void damagedHeadsOfCompressedPicturesAreRefused_data() {
    QTest::addColumn<int>("syntax");
    QTest::addColumn<QByteArray>("mark");
    QTest::addColumn<int>("offset");
    QTest::addColumn<QByteArray>("claim");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, int syntax, const char* mark, int offset,
                        const std::string& claim, const char* says) {
      QTest::newRow(name) << syntax << QByteArray(mark) << offset
                          << QByteArray::fromStdString(claim) << says;
    };
    const std::string side = big(60000, 2);
    row("JPEG", EXS_JPEGProcess14SV1, "\xff\xc3", 5, side + side, "60000 x 60000");
    row("JPEG marker", EXS_JPEGProcess14SV1, "\xff\xd8\xff", 2, big(0xff01, 2), "marker TEM");
    row("JPEG marker behind fill", EXS_JPEGProcess14SV1, "\xff\xd8\xff", 2, big(0xffffff01, 4),
        "marker TEM");
    row("JPEG-LS", EXS_JPEGLSLossless, "\xff\xf7", 5, side + side, "60000 x 60000");
    row("JPEG 2000", EXS_JPEG2000, "\xff\x4f\xff\x51", 8, big(60000, 4) + big(60000, 4),
        "60000 x 60000");
    row("JPEG 2000 tiles", EXS_JPEG2000, "\xff\x4f\xff\x51", 24, big(1, 4) + big(1, 4),
        "9000 tiles");
    row("JPEG 2000 head", EXS_JPEG2000, "\xff\x93", 0, big(0x01ff, 2), "head of a JPEG 2000");
    row("JPEG 2000 rows", EXS_JPEG2000, "\xff\x4f\xff\x51", 12, big(89, 4), "100 x 89");
    row("JPEG 2000 colour", EXS_JPEG2000, "\xff\x4f\xff\x51", 40, big(3, 2), "another kind");
    row("JPEG 2000 bits", EXS_JPEG2000, "\xff\x4f\xff\x51", 42, big(0x83, 1), "of 4 bits");
    row("JPEG 2000 steps", EXS_JPEG2000, "\xff\x4f\xff\x51", 43, big(0x0102, 2), "another kind");
  }
  void damagedHeadsOfCompressedPicturesAreRefused() {
    QFETCH(int, syntax);
    QFETCH(QByteArray, mark);
    QFETCH(int, offset);
    QFETCH(QByteArray, claim);
    QFETCH(QString, says);
    const Folder folder;
    const bool jpeg2000 = syntax == EXS_JPEG2000;
    saveSeries(
        folder.path(),
        [](Slice& slice) {
          slice.columns = 100;
          slice.rows = 90;
          return true;
        },
        jpeg2000 ? EXS_LittleEndianExplicit : static_cast<E_TransferSyntax>(syntax));
    for (const auto& entry : fs::directory_iterator(folder.path())) {
      if (jpeg2000) toJpeg2000(entry.path());
      std::string bytes = bytesOf(entry.path());
      bytes.replace(bytes.rfind(mark.toStdString()) + static_cast<std::size_t>(offset),
                    static_cast<std::size_t>(claim.size()), claim.toStdString());
      save(entry.path(), bytes);
    }
    const double before = peakMb();
    const QString message = refusal(folder.path());
    QVERIFY2(message.startsWith("Io: ") && message.contains(says), qPrintable(message));
    QVERIFY2(peakMb() < before + 100.0, qPrintable(QString::number(peakMb() - before)));
  }

  void damagedRunLengthsAreRefusedOrRead() {
    const Folder folder;
    saveSeries(folder.path(), {}, EXS_RLELossless);
    const std::string whole = bytesOf(folder / "0.dcm");
    const std::size_t start = whole.rfind(std::string("\xfe\xff\x00\xe0", 4)) + 8;
    int refused = 0;
    for (std::size_t at = start; at < whole.size() - 8; ++at)
      for (const char other : {'\x00', '\x7f', '\x80', '\xff'}) {
        std::string bytes = whole;
        bytes[at] = other;
        save(folder / "0.dcm", bytes);
        const QString message = refusal(folder.path());
        QVERIFY2(message == "accepted" || message.startsWith("Io: "), qPrintable(message));
        refused += message == "accepted" ? 0 : 1;
      }
    QVERIFY2(refused > 50, qPrintable(QString::number(refused)));
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
    QCOMPARE(screenWarnings(loaded.info).size(), std::size_t{1});
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
    QVERIFY(refusal(folder / "e.dcm").contains("position of each frame"));
  }

  void bitsAreTakenFromWhereTheyLie_data() {
    QTest::addColumn<int>("allocated");
    QTest::addColumn<int>("stored");
    QTest::addColumn<int>("high");
    QTest::addColumn<bool>("isSigned");
    QTest::addColumn<int>("syntax");
    for (const auto& [name, syntax] : {std::pair{"little", EXS_LittleEndianExplicit},
                                       {"implicit", EXS_LittleEndianImplicit},
                                       {"big", EXS_BigEndianExplicit}})
      for (const auto& [allocated, stored, high] :
           {std::tuple{16, 12, 11}, {16, 12, 15}, {16, 10, 12}, {16, 16, 15}, {8, 8, 7}, {8, 6, 6}})
        for (const bool isSigned : {false, true})
          QTest::addRow("%s %d %d %d %d", name, allocated, stored, high, int(isSigned))
              << allocated << stored << high << isSigned << int(syntax);
  }
  void bitsAreTakenFromWhereTheyLie() {
    QFETCH(int, allocated);
    QFETCH(int, stored);
    QFETCH(int, high);
    QFETCH(bool, isSigned);
    QFETCH(int, syntax);
    const int half = 1 << (stored - 1);
    const auto wanted = [&](int value) {
      const int folded = value & (2 * half - 1);
      return isSigned ? folded - half : folded;
    };
    const Folder folder;
    saveSeries(
        folder.path(),
        [&](Slice& slice) {
          slice.edit = [&](DcmDataset& data) {
            data.putAndInsertUint16(DCM_BitsAllocated, static_cast<Uint16>(allocated));
            data.putAndInsertUint16(DCM_BitsStored, static_cast<Uint16>(stored));
            data.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(high));
            data.putAndInsertUint16(DCM_PixelRepresentation, isSigned ? 1 : 0);
          };
          slice.encode = [&](int value) {
            const auto bits = static_cast<unsigned>(wanted(value)) & (2U * unsigned(half) - 1U);
            // The bits beside the stored ones hold something else, as old overlays do.
            const unsigned all = (1U << unsigned(allocated)) - 1U;
            const unsigned mask = (2U * unsigned(half) - 1U) << unsigned(high + 1 - stored);
            return static_cast<Uint16>(((bits << unsigned(high + 1 - stored)) & mask) |
                                       (0x5555U & all & ~mask));
          };
          return true;
        },
        static_cast<E_TransferSyntax>(syntax));
    const LoadedImage loaded = readImage(folder.path());
    verifyVoxels(loaded.image, [&](int value, int) { return static_cast<float>(wanted(value)); });
    QCOMPARE(loaded.info.pixelType, (isSigned ? "int" : "uint") + std::to_string(allocated));
  }

  void jpegBaselineIsReadAsNearAsItIs() {
    const auto ramp = [](int n, int k) {
      const int i = n % kColumns;
      const int j = n / kColumns;
      return static_cast<Uint16>(k % 2 == 0 ? 255 * i / (kColumns - 1) : 255 * j / (kRows - 1));
    };
    const Folder folder;
    saveSeries(
        folder.path(),
        [&](Slice& slice) {
          slice.edit = [](DcmDataset& data) {
            data.putAndInsertUint16(DCM_BitsAllocated, 8);
            data.putAndInsertUint16(DCM_BitsStored, 8);
            data.putAndInsertUint16(DCM_HighBit, 7);
          };
          // From 0 to 255 in each slice: the encoder stretches what it is given.
          slice.encode = [&ramp, k = slice.k, n = 0](int) mutable { return ramp(n++, k); };
          return true;
        },
        EXS_JPEGProcess1);
    const LoadedImage loaded = readImage(folder.path());
    for (int k = 0; k < kSlices; ++k)
      for (int n = 0; n < kColumns * kRows; ++n)
        QVERIFY(std::fabs(loaded.image.at(n % kColumns, n / kColumns, k) -
                          static_cast<float>(ramp(n, k))) <= 8.0F);
  }

  void compressedMultiFrameIsReadFrameByFrame_data() {
    QTest::addColumn<int>("syntax");
    QTest::newRow("RLE") << int(EXS_RLELossless);
    QTest::newRow("JPEG lossless") << int(EXS_JPEGProcess14SV1);
    QTest::newRow("JPEG-LS") << int(EXS_JPEGLSLossless);
    QTest::newRow("deflated") << int(EXS_DeflatedLittleEndianExplicit);
    QTest::newRow("big endian") << int(EXS_BigEndianExplicit);
  }
  void compressedMultiFrameIsReadFrameByFrame() {
    QFETCH(int, syntax);
    const Folder folder;
    saveEnhanced(folder / "e", {4, 1, 0, 5, 3, 2}, true, static_cast<E_TransferSyntax>(syntax));
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image,
                 [](int stored, int) { return static_cast<float>(0.5 * stored - 7.0); });
  }

  void pixelsNeedNotBeTheLastElement() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.edit = [](DcmDataset& data) {
        data.putAndInsertUint8Array(DCM_DataSetTrailingPadding, std::vector<Uint8>(40, 0).data(),
                                    40);
      };
      return true;
    });
    verifyVoxels(readImage(folder.path()).image, plain);
  }

  void paddingBecomesTheSmallestValue() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.isSigned = slice.rescaled = true;
      slice.slope = 2.0;
      slice.intercept = -10.0;
      slice.edit = [](DcmDataset& data) {
        data.putAndInsertSint16(DcmTag(DCM_PixelPaddingValue, EVR_SS), -30000);
        data.putAndInsertSint16(DcmTag(DCM_PixelPaddingRangeLimit, EVR_SS), -29000);
      };
      slice.encode = [](int value) {
        return static_cast<Uint16>(value % 7 == 0 ? -29500 : std::max(value, -1500));
      };
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyVoxels(loaded.image, [](int stored, int) {
      const int value = stored - 2000;
      return static_cast<float>(2 * (value % 7 == 0 ? -1500 : std::max(value, -1500)) - 10);
    });
    QVERIFY(findingOf(loaded.info.findings, FindingKind::PaddedValues) != nullptr);
  }

  void brightForSmallIsSaidAndTheValuesKept() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.edit = [](DcmDataset& data) {
        putText(data, DCM_PhotometricInterpretation, "MONOCHROME1");
      };
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyVoxels(loaded.image, plain);
    QVERIFY(findingOf(loaded.info.findings, FindingKind::InvertedValues) != nullptr);
  }

  void windowsAreListedWithTheirFunction() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.edit = [](DcmDataset& data) {
        putText(data, DCM_WindowCenterWidthExplanation, "BRAIN\\VESSEL");
        putText(data, DCM_VOILUTFunction, "LINEAR_EXACT");
      };
      return true;
    });
    const auto windows = readImage(folder.path()).info.windows;
    QCOMPARE(windows.size(), std::size_t{2});
    QCOMPARE(windows[1].name, std::string("VESSEL"));
    QCOMPARE(windows[1].range(), (std::array<double, 2>{-160.0, 240.0}));
    const DisplayWindow linear{400.0, 40.0, "LINEAR", {}};
    QCOMPARE(linear.range(), (std::array<double, 2>{-160.0, 239.0}));
  }

  void nothingSaysWhoThePatientIs() {
    const Folder folder;
    saveSeries(folder.path());
    const InputInfo info = readImage(folder.path()).info;
    std::string all =
        info.format + info.modality + info.pixelType + info.seriesUid + info.seriesDescription;
    for (const std::string& warning : reportWarnings(info)) all += warning;
    for (const char* identity : {"Doe", "Jane", "4711", "1970"})
      QVERIFY(all.find(identity) == std::string::npos);
  }

  void aRealSeriesIsRead() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const fs::path path = fs::path(data.toStdString()) / "head-mr-dicom";
    const LoadedImage loaded = readImage(path);
    QCOMPARE(loaded.image.geometry.size, (Index3{512, 512, 120}));
    QCOMPARE(loaded.info.files, 120);
    QVERIFY(std::fabs(loaded.image.geometry.spacing[2] - 1.5) < 1e-3);
    QVERIFY(screenWarnings(loaded.info).empty());
    QVERIFY(!loaded.info.windows.empty());
  }
};

QTEST_APPLESS_MAIN(TestDicom)
#include "tst_dicom.moc"
