// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>
#include <random>

#include "io/dicom/dicom.h"
#include "tests/io/dicom_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

class TestDicomScan : public QObject {
  Q_OBJECT

  Encoders encoders_;

 private Q_SLOTS:
  void foldersOfAnyMessAreSearched() {
    const Folder folder;
    const fs::path deep = folder / "DICOM/ST000001/SE 3";
    fs::create_directories(deep);
    fs::create_directories(folder / "b");
    fs::create_directory_symlink(folder.path(), folder / "b/loop");
    int n = 0;
    saveSeries(deep, [&](Slice&) { return n++ % 2 == 0; });
    n = 0;
    saveSeries(folder / "b", [&](Slice&) { return n++ % 2 == 1; });
    for (const auto& entry : fs::directory_iterator(folder / "b"))
      if (entry.path().extension() == ".dcm")
        fs::rename(entry.path(), entry.path().parent_path() / entry.path().stem());
    save(folder / "AUTORUN.INF", "[autorun]");
    save(folder / "b/thumbs.db", std::string(5000, 'x'));
    // A directory and a report are DICOM and hold no image.
    for (const char* kind : {UID_MediaStorageDirectoryStorage, UID_BasicTextSRStorage}) {
      DcmFileFormat format;
      putText(*format.getDataset(), DCM_SOPClassUID, kind);
      putText(*format.getDataset(), DCM_SOPInstanceUID, "1.2.3");
      putText(*format.getDataset(), DCM_SeriesInstanceUID, "1.2.9");
      QVERIFY(
          format.saveFile((folder / std::string(kind)).c_str(), EXS_LittleEndianExplicit).good());
    }
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image, plain);
    QVERIFY(screenWarnings(loaded.info).empty());
  }

  void whatCannotBeOpenedIsNoReasonForFewerSlices() {
    const Folder folder;
    // So many that several threads open them.
    for (int n = 0; n < 6; ++n)
      saveSeries(
          folder.path(),
          [&](Slice& slice) {
            slice.series += std::to_string(n);
            slice.instance += "." + std::to_string(n);
            return true;
          },
          EXS_LittleEndianExplicit, std::to_string(n));
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    int refused = 0;
    for (rlim_t descriptors = 3; descriptors <= 20; ++descriptors) {
      rlimit limit = before;
      limit.rlim_cur = descriptors;
      ::setrlimit(RLIMIT_NOFILE, &limit);
      LoadedImage loaded;
      const QString failure = messageOf([&] {
        loaded = readImage(folder.path(), {"10000010", false});
      });
      ::setrlimit(RLIMIT_NOFILE, &before);
      if (failure.isEmpty()) {
        verifyVoxels(loaded.image, plain);
      } else {
        QVERIFY2(failure.contains("Too many open files"), qPrintable(failure));
        ++refused;
      }
    }
    QVERIFY(refused > 0);
  }

  void whatMayNotBeReadIsNamed() {
    const Folder folder;
    saveSeries(folder.path());
    // Root may read everything: as nobody, who may come this far.
    const bool root = ::geteuid() == 0;
    fs::permissions(folder.path(), fs::perms::group_read | fs::perms::group_exec,
                    fs::perm_options::add);
    fs::create_directory(folder / "more");
    for (const char* name : {"5.dcm", "more"}) {
      const fs::perms perms = fs::status(folder / name).permissions();
      fs::permissions(folder / name, fs::perms::none);
      if (root) QCOMPARE(::seteuid(65534), 0);
      const QString failure = messageOf([&] { readImage(folder.path()); });
      if (root) QCOMPARE(::seteuid(0), 0);
      fs::permissions(folder / name, perms);
      QVERIFY2(failure.contains("Permission denied") && failure.contains(name),
               qPrintable(failure));
    }
    verifyVoxels(readImage(folder.path()).image, plain);
  }

  void aLinkThatLeadsNowhereMayBeASlice() {
    const Folder folder;
    saveSeries(folder.path());
    fs::create_symlink(folder / "gone", folder / "extra");
    const QString message = refusal(folder.path());
    QVERIFY2(message.contains("a link leads to no file") && message.contains("extra"),
             qPrintable(message));
    fs::remove(folder / "extra");
    // In a folder without slices it was none.
    fs::create_directory(folder / "notes");
    fs::create_symlink(folder / "gone", folder / "notes/extra");
    verifyVoxels(readImage(folder.path()).image, plain);
  }

  void aDamagedFileConcernsItsOwnSeriesOnly() {
    const Folder folder;
    saveSeries(folder.path());
    saveSecondSeries(folder.path());
    const std::string whole = bytesOf(folder / "b0.dcm");
    save(folder / "b0.dcm", whole.substr(0, whole.size() - 20));
    verifyVoxels(readImage(folder.path(), {"1000001", false}).image, plain);
    const QString message = refusal(folder.path(), "2000002");
    QVERIFY2(message.startsWith("Io: ") && message.contains("b0.dcm"), qPrintable(message));
    // Cut before the series is named, it may have belonged to either.
    save(folder / "b0.dcm", whole.substr(0, 150));
    for (const char* uid : {"1000001", "2000002"})
      QVERIFY(refusal(folder.path(), uid).contains("b0.dcm"));
  }

  void aLoneVolumeAmongPicturesIsTaken() {
    const Folder folder;
    saveSeries(folder.path());
    Slice scout = sliceAt(0);
    scout.series = "1.2.3.4.3000003";
    scout.instance = "1.2.77";
    scout.columns = 20;
    saveSlice(scout, folder / "scout");
    const LoadedImage loaded = readImage(folder.path());
    verifyVoxels(loaded.image, plain);
    QCOMPARE(loaded.info.warnings.size(), std::size_t{1});
  }

  void aHeaderThatClaimsMoreThanTheFileHoldsIsRefused_data() {
    QTest::addColumn<int>("columns");
    QTest::addColumn<QString>("frames");
    QTest::addColumn<int>("syntax");
    for (const auto& [name, syntax] : {std::pair{"raw", EXS_LittleEndianExplicit},
                                       {"RLE", EXS_RLELossless},
                                       {"deflated", EXS_DeflatedLittleEndianExplicit}}) {
      QTest::addRow("%s, large", name) << 65535 << "" << int(syntax);
      QTest::addRow("%s, many frames", name) << 9 << "2000000000" << int(syntax);
    }
  }
  void aHeaderThatClaimsMoreThanTheFileHoldsIsRefused() {
    QFETCH(int, columns);
    QFETCH(QString, frames);
    QFETCH(int, syntax);
    const Folder folder;
    const auto kind = static_cast<E_TransferSyntax>(syntax);
    saveSlice(sliceAt(0), folder / "a", kind);
    DcmFileFormat format;
    QVERIFY(format.loadFile((folder / "a").c_str()).good());
    format.loadAllDataIntoMemory();
    format.getDataset()->putAndInsertUint16(DCM_Columns, static_cast<Uint16>(columns));
    format.getDataset()->putAndInsertUint16(DCM_Rows, static_cast<Uint16>(columns));
    if (!frames.isEmpty()) putText(*format.getDataset(), DCM_NumberOfFrames, frames.toStdString());
    QVERIFY(format.saveFile((folder / "a").c_str(), kind).good());
    const QString message = refusal(folder / "a");
    QVERIFY2(message.startsWith("Io: ") && message.contains("cannot hold"), qPrintable(message));
  }

  void lengthsBeyondTheFileTakeNoMemory_data() {
    QTest::addColumn<QByteArray>("mark");
    QTest::addColumn<QByteArray>("instead");  // of the mark and the length behind it
    QTest::addColumn<int>("syntax");
    const auto row = [](const char* name, const std::string& mark, const std::string& instead,
                        E_TransferSyntax syntax) {
      QTest::newRow(name) << QByteArray::fromStdString(mark) << QByteArray::fromStdString(instead)
                          << int(syntax);
    };
    using namespace std::string_literals;
    const auto plain = EXS_LittleEndianExplicit;
    row("description", "\x08\0\x3e\x10LO\4\0"s, "\x08\0\x3e\x10UN\0\0"s, plain);
    row("rows", "\x28\0\x10\0US\2\0"s, "\x28\0\x10\0OB\0\0"s, plain);
    row("pixels", "\xe0\x7f\x10\0OW\0\0\x7e\0\0\0"s, "\xe0\x7f\x10\0OW\0\0"s, plain);
    const std::string table = "\xfe\xff\0\xe0\4\0\0\0\0\0\0\0\xfe\xff\0\xe0"s;
    row("fragment", table + "\x9a\0\0\0"s, table, EXS_RLELossless);
  }
  void lengthsBeyondTheFileTakeNoMemory() {
    QFETCH(QByteArray, mark);
    QFETCH(QByteArray, instead);
    QFETCH(int, syntax);
    const Folder folder;
    const fs::path path = folder / "a.dcm";
    saveSlice(sliceAt(1), path, static_cast<E_TransferSyntax>(syntax));
    std::string bytes = bytesOf(path);
    const std::size_t at = bytes.find(mark.toStdString());
    QVERIFY(at != std::string::npos);
    bytes.replace(at, static_cast<std::size_t>(mark.size()),
                  instead.toStdString() + "\xf0\xff\xff\x6f");
    save(path, bytes);
    const double before = peakMb();
    try {
      for (const ImageSummary& entry : describeImages(path)) thumbnail(entry, 16);
    } catch (const Error&) {
      // Refused: that is as good.
    }
    QVERIFY2(peakMb() < before + 100.0, qPrintable(QString::number(peakMb() - before)));
  }

  void anySeriesComesBack_data() {
    QTest::addColumn<int>("seed");
    for (int seed = 0; seed < 25; ++seed) QTest::addRow("%d", seed) << seed;
  }
  /// Random direction, spacing, order of files, sign, rescaling, syntax and depth of folders.
  void anySeriesComesBack() {
    QFETCH(int, seed);
    std::mt19937 random(static_cast<unsigned>(seed));
    const auto uniform = [&](double a, double b) {
      return a + (b - a) * static_cast<double>(random()) / 4294967295.0;
    };
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1))
            .normalized();
    const Eigen::Matrix3d direction = turn.toRotationMatrix();
    const Eigen::Vector3d origin(uniform(-200, 200), uniform(-200, 200), uniform(-200, 200));
    const double spacing = std::round(uniform(0.2, 4.0) * 1e4) / 1e4;
    const bool isSigned = random() % 2 == 0;
    const double slope = std::round(uniform(0.1, 3.0) * 1000.0) / 1000.0;
    const std::vector<E_TransferSyntax> syntaxes{
        EXS_LittleEndianExplicit,         EXS_LittleEndianImplicit, EXS_BigEndianExplicit,
        EXS_DeflatedLittleEndianExplicit, EXS_RLELossless,          EXS_JPEGLSLossless};
    std::vector<int> order(12);
    for (int k = 0; k < 12; ++k) order[static_cast<std::size_t>(k)] = k;
    std::shuffle(order.begin(), order.end(), random);
    const Folder folder;
    fs::create_directories(folder / "0/1");
    for (int k = 0; k < 12; ++k) {
      Slice slice = sliceAt(k);
      slice.direction = direction;
      slice.position = origin + direction.col(2) * (spacing * k);
      slice.isSigned = isSigned;
      slice.rescaled = true;
      slice.slope = slope;
      slice.intercept = -17.25;
      const int name = order[static_cast<std::size_t>(k)];
      saveSlice(slice, folder / ((name % 3 == 0 ? "0/1/s" : "0/s") + std::to_string(name)),
                syntaxes[random() % syntaxes.size()]);
    }
    const LoadedImage loaded = readImage(folder.path());
    const Geometry& g = loaded.image.geometry;
    QCOMPARE(g.size, (Index3{kColumns, kRows, 12}));
    QVERIFY((g.direction - direction).norm() < 1e-6);
    QVERIFY((g.origin - origin).norm() < 1e-5);
    QVERIFY(std::fabs(g.spacing[2] - spacing) < 1e-6);
    for (int k = 0; k < 12; ++k)
      for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i)
          QCOMPARE(
              loaded.image.at(i, j, k),
              static_cast<float>(slope * (storedValue(i, j, k) - (isSigned ? 2000 : 0)) - 17.25));
  }

  void thumbnailsShowTheMiddleSlice() {
    const Folder folder;
    saveSeries(folder.path(), [](Slice& slice) {
      slice.edit = [](DcmDataset& data) { data.findAndDeleteElement(DCM_WindowWidth); };
      return true;
    });
    const auto entries = describeImages(folder.path());
    const Picture picture = thumbnail(entries.at(0), 16);
    // 9 x 0.4 mm by 7 x 0.6 mm: higher than wide.
    QCOMPARE(picture.height, 16);
    QCOMPARE(picture.width, 14);
    QCOMPARE(picture.rgb.size(), std::size_t{3} * 16 * 14);
    QVERIFY(*std::max_element(picture.rgb.begin(), picture.rgb.end()) > 200);
    QVERIFY(*std::min_element(picture.rgb.begin(), picture.rgb.end()) < 50);
  }

  void emptyFilesThatShouldBeSlicesAreSaid() {
    const Folder folder;
    saveSeries(folder.path());
    save(folder / "empty.dcm", "");
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(screenWarnings(loaded.info).size(), std::size_t{1});
    QCOMPARE(describeImages(folder.path()).at(0).info.warnings, loaded.info.warnings);
  }

  void seriesAreChosenByTheirUid() {
    const Folder folder;
    saveSeries(folder.path());
    saveSecondSeries(folder.path());
    const QString message = refusal(folder.path());
    QVERIFY2(message.startsWith("Input: there are 2 series"), qPrintable(message));
    for (const char* part :
         {".1000001", ".2000002", "\"tof\"", "\"phase\"", "9 x 7 x 6", "--series"})
      QVERIFY2(message.contains(part), qPrintable(message));
    verifyVoxels(readImage(folder.path(), {"1.2.3.4.1000001", false}).image, plain);
    verifyVoxels(readImage(folder.path(), {"2000002", false}).image,
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

  void endlesslyNestedSequencesAreRefused_data() {
    QTest::addColumn<int>("syntax");
    QTest::addColumn<bool>("behindPixels");
    QTest::newRow("explicit") << int(EXS_LittleEndianExplicit) << false;
    QTest::newRow("behind the pixels") << int(EXS_LittleEndianExplicit) << true;
    QTest::newRow("implicit") << int(EXS_LittleEndianImplicit) << false;
    QTest::newRow("deflated") << int(EXS_DeflatedLittleEndianExplicit) << false;
  }
  void endlesslyNestedSequencesAreRefused() {
    QFETCH(int, syntax);
    QFETCH(bool, behindPixels);
    const auto written = static_cast<E_TransferSyntax>(syntax);
    const DcmTagKey place = behindPixels ? DcmTagKey(0x7fe1, 0x1010) : DcmTagKey(0x0029, 0x1010);
    const auto nest = [&](int depth, const fs::path& folder) {
      // Built from the inside, so that nothing here calls itself.
      auto sequence = std::make_unique<DcmSequenceOfItems>(DcmTag(place, EVR_SQ));
      for (int n = 1; n < depth; ++n) {
        auto outer = std::make_unique<DcmSequenceOfItems>(DcmTag(place, EVR_SQ));
        auto item = std::make_unique<DcmItem>();
        item->insert(sequence.release());
        outer->append(item.release());
        sequence = std::move(outer);
      }
      saveSeries(
          folder,
          [&](Slice& slice) {
            if (slice.k == 0)
              slice.edit = [&](DcmDataset& data) { data.insert(sequence.release()); };
            return true;
          },
          written);
    };
    // What DCMTK can write is not deep enough to do harm, but more than any scanner nests.
    const Folder deep;
    nest(300, deep.path());
    QVERIFY2(refusal(deep.path()).contains("nests sequences"), qPrintable(refusal(deep.path())));
    const Folder flat;
    nest(20, flat.path());
    verifyVoxels(readImage(flat.path()).image, plain);
  }

  void aFileOfSequencesAloneDoesNotFillTheStack() {
    const Folder folder;
    saveSeries(folder.path());
    std::string bytes = bytesOf(folder / "0.dcm");
    const std::size_t pixels = bytes.find(std::string("\xe0\x7f\x10\0OW", 6));
    QVERIFY(pixels != std::string::npos);
    std::string nested;
    for (int n = 0; n < 100000; ++n)
      nested +=
          std::string("\x29\0\x10\x10SQ\0\0\xff\xff\xff\xff\xfe\xff\0\xe0\xff\xff\xff\xff", 20);
    save(folder / "0.dcm", bytes.substr(0, pixels) + nested + bytes.substr(pixels));
    QVERIFY(refusal(folder.path()).contains("nests sequences"));
    save(folder / "0.dcm", bytes + nested);
    QVERIFY(refusal(folder.path()).contains("nests sequences"));
    // In group 2, before everything else.
    save(folder / "0.dcm", bytes.substr(0, 132) + "\x02" + nested.substr(1) + bytes.substr(132));
    QVERIFY(refusal(folder.path()).contains("nests sequences"));
  }

  void foldersWithoutImagesAreRefused() {
    const Folder folder;
    QVERIFY(refusal(folder.path()).startsWith("Input: there is no DICOM image"));
    QVERIFY(refusal(folder / "none").startsWith("Io: "));
  }

  void readingCanBeCancelled() {
    const Folder folder;
    saveSeries(folder.path());
    const Progress progress;
    progress.cancel();
    QVERIFY_THROWS_EXCEPTION(Cancelled, readImage(folder.path(), {}, progress));
  }
};

QTEST_APPLESS_MAIN(TestDicomScan)
#include "tst_dicom_scan.moc"
