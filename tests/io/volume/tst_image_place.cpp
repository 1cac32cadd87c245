// SPDX-License-Identifier: BSD-3-Clause
// Where image files say that their voxels lie.
#include <QTest>

#include "core/base/error.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// 2 x 3 x 4 bytes: 0, 1, ... 23, and again.
std::string voxels(int count = 24) {
  std::string bytes;
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(i);
  return bytes;
}

/// 2 x 3 x 4 voxels of 1 x 2 x 3 mm, all 1.
Volume<std::uint8_t> fullMask() {
  Volume<std::uint8_t> image;
  image.geometry.size = {2, 3, 4};
  image.geometry.spacing = {1, 2, 3};
  image.voxels = BigVector<std::uint8_t>(24, 1);
  return image;
}

std::string nrrd(const std::string& fields) {
  return "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 2 3 4\nencoding: raw\n" + fields + "\n\n" +
         voxels();
}

/// Without those of unlikely sizes, which follow from the units in a test.
QString withoutSizes(const QString& warnings) {
  QStringList lines = warnings.split('\n');
  lines.removeIf([](const QString& line) { return line.contains("none of a scan of vessels"); });
  return lines.join('\n');
}

struct Read {
  Geometry geometry;
  QString warnings;
  QString error;
};

Read read(const std::string& name, const std::string& bytes, std::optional<int> component = {}) {
  const Folder f;
  save(f / name, bytes);
  Read out;
  out.error = messageOf([&] {
    const NativeImage image = readNative(f / name, {}, component);
    out.geometry = geometryOf(image.volume);
    for (const std::string& warning : image.info.warnings)
      out.warnings += QString::fromStdString(warning) + "\n";
  });
  return out;
}

bool lies(const Geometry& g, const Eigen::Vector3d& spacing, const Eigen::Vector3d& origin,
          const Eigen::Vector3d& signs) {
  const Eigen::Matrix3d direction = signs.asDiagonal();
  return (g.spacing - spacing).norm() < 1e-9 && (g.origin - origin).norm() < 1e-9 &&
         (g.direction - direction).norm() < 1e-9;
}

}  // namespace

class TestImagePlace : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everySpaceOfNrrdIsTurnedToLps_data() {
    QTest::addColumn<QString>("space");
    QTest::addColumn<int>("x");
    QTest::addColumn<int>("y");
    QTest::addColumn<QString>("warning");
    const auto row = [](const char* space, int x, int y, const char* warning = "") {
      QTest::addRow("%s", space) << QString(space) << x << y << QString(warning);
    };
    for (const char* lps : {"left-posterior-superior", "LPS", "left posterior superior",
                            "left-posterior-superior-time", "LPST"})
      row(lps, 1, 1);
    for (const char* ras : {"right-anterior-superior", "RAS", "Right-Anterior-Superior",
                            "right-anterior-superior-time", "RAST"})
      row(ras, -1, -1);
    for (const char* las : {"left-anterior-superior", "LAS", "left-anterior-superior-time", "LAST"})
      row(las, 1, -1);
    for (const char* none :
         {"scanner-xyz", "3D-right-handed", "scanner-xyz-time", "3D-right-handed-time"})
      row(none, 1, 1, "does not say how the patient lies");
    for (const char* left : {"3D-left-handed", "3D-left-handed-time"}) row(left, 1, 1, "mirrored");
  }
  void everySpaceOfNrrdIsTurnedToLps() {
    QFETCH(QString, space);
    QFETCH(int, x);
    QFETCH(int, y);
    QFETCH(QString, warning);
    const bool time = space.endsWith("-time") || (space.size() == 4 && space.endsWith('T'));
    const std::string fields =
        time ? "space directions: (0.5,0,0,0) (0,0.6,0,0) (0,0,0.8,0)\nspace origin: (10,20,30,5)"
             : "space directions: (0.5,0,0) (0,0.6,0) (0,0,0.8)\nspace origin: (10,20,30)";
    const Read got = read("v.nrrd", nrrd("space: " + space.toStdString() + "\n" + fields));
    QCOMPARE(got.error, QString());
    QVERIFY(
        lies(got.geometry, {0.5, 0.6, 0.8}, {10.0 * x, 20.0 * y, 30.0}, {1.0 * x, 1.0 * y, 1.0}));
    QCOMPARE(got.warnings.isEmpty(), warning.isEmpty());
    QVERIFY2(got.warnings.contains(warning), qPrintable(got.warnings));
  }

  void aSpaceWithoutANameIsSaid() {
    const std::string place =
        "space directions: (0.5,0,0) (0,0.6,0) (0,0,0.8)\nspace origin: (10,20,30)";
    const Read got = read("v.nrrd", nrrd("space dimension: 3\n" + place));
    QVERIFY(lies(got.geometry, {0.5, 0.6, 0.8}, {10, 20, 30}, {1, 1, 1}));
    QVERIFY2(got.warnings.contains("a space without a name"), qPrintable(got.warnings));
    QVERIFY(read("v.nrrd", nrrd("space: left-inferior-anterior\n" + place))
                .error.contains("left-inferior-anterior"));
    // Two axes of space make no volume.
    QVERIFY(read("v.nrrd", nrrd("space dimension: 2\nspace directions: none (1,0) (0,1)"))
                .error.contains("2D"));
  }

  void unitsBecomeMillimetres_data() {
    QTest::addColumn<QString>("fields");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("z");
    QTest::addColumn<QString>("warning");
    const std::string place =
        "space: LPS\nspace directions: (0.5,0,0) (0,0.6,0) (0,0,0.8)\nspace origin: (10,20,30)\n";
    const auto row = [&](const char* units, double x, double z, const char* warning = "") {
      QTest::addRow("%s", units) << QString::fromStdString(place + "space units: " + units) << x
                                 << z << QString(warning);
    };
    row(R"("mm" "mm" "mm")", 1, 1);
    row(R"("" "" "")", 1, 1);
    row(R"("um" "um" "um")", 1e-3, 1e-3);
    row("\"\xc2\xb5m\" \"\xc2\xb5m\" \"microns\"", 1e-3, 1e-3);
    row(R"("m" "m" "m")", 1000, 1000);
    row(R"("mm" "mm" "cm")", 1, 10);
    row("cm cm mm", 10, 1);
    row(R"("furlong" "furlong" "mm")", 1, 1, "'furlong'");
  }
  void unitsBecomeMillimetres() {
    QFETCH(QString, fields);
    QFETCH(double, x);
    QFETCH(double, z);
    QFETCH(QString, warning);
    const Read got = read("v.nrrd", nrrd(fields.toStdString()));
    QCOMPARE(got.error, QString());
    QVERIFY(std::fabs(got.geometry.spacing.x() - 0.5 * x) < 1e-9);
    QVERIFY(std::fabs(got.geometry.spacing.z() - 0.8 * z) < 1e-9);
    QVERIFY(std::fabs(got.geometry.origin.x() - 10.0 * x) < 1e-9);
    QVERIFY(std::fabs(got.geometry.origin.z() - 30.0 * z) < 1e-9);
    QCOMPARE(withoutSizes(got.warnings).isEmpty(), warning.isEmpty());
    QVERIFY2(got.warnings.contains(warning), qPrintable(got.warnings));
    QCOMPARE(withoutSizes(got.warnings).count('\n'), warning.isEmpty() ? 0 : 1);
  }

  void unitsBelongToTheAxesOfASlantedSpace() {
    // An index step along z of the space, which is in cm.
    const Read got = read("v.nrrd", nrrd("space: LPS\nspace units: \"mm\" \"mm\" \"cm\"\nspace "
                                         "directions: (0,0,0.5) (0,0.6,0) (0.8,0,0)\n"));
    QVERIFY((got.geometry.spacing - Eigen::Vector3d(5, 0.6, 0.8)).norm() < 1e-9);
  }

  void spacingsWithoutASpace() {
    const Read plain = read("v.nrrd", nrrd("spacings: 0.5 0.6 0.8\nunits: \"mm\" \"mm\" \"cm\""));
    QVERIFY(lies(plain.geometry, {0.5, 0.6, 8}, {0, 0, 0}, {1, 1, 1}));
    QCOMPARE(plain.warnings, QString());
    const Read turned = read("v.nrrd", nrrd("spacings: 0.5 -0.6 0.8"));
    QVERIFY(lies(turned.geometry, {0.5, 0.6, 0.8}, {0, 0, 0}, {1, -1, 1}));
    const Read ends = read("v.nrrd", nrrd("axis mins: 1 2 3\naxis maxs: 2 8 15\ncenters: cell node "
                                          "cell"));
    QVERIFY(lies(ends.geometry, {0.5, 3, 3}, {1.25, 2, 4.5}, {1, 1, 1}));
    const Read unknown = read("v.nrrd", nrrd("spacings: 0.5 0.6 NaN"));
    QVERIFY(lies(unknown.geometry, {0.5, 0.6, 1}, {0, 0, 0}, {1, 1, 1}));
    QVERIFY2(unknown.warnings.contains("spacing along axis 3: 1 mm"), qPrintable(unknown.warnings));
    for (const char* none : {"", "spacings: nan nan nan", "space: LPS",
                             "space: LPS\nspace directions: none none none"}) {
      const Read got = read("v.nrrd", nrrd(none));
      QVERIFY2(got.warnings.contains("does not state the voxel spacing: 1 mm"), none);
    }
    QVERIFY(read("v.nrrd", nrrd("space: LPS\nspace directions: (1,0,0) (0,1,0) none"))
                .error.contains("a 2D image"));
    for (const char* bad : {"spacings: 0.5 0.6 0", "spacings: 0.5 0.6", "spacings: 1 1 inf",
                            "spacings: 1 1 x", "space: LPS\nspace directions: (1,0,0) none (0,0,1)",
                            "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0,0)",
                            "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,0",
                            "space: LPS\nspace directions: (1,0) (0,1) (0,0)",
                            "space: LPS\nspace directions: (1,0,0) (0,1,0) (0,nan,1)"})
      QVERIFY2(read("v.nrrd", nrrd(bad)).error.contains("header is not usable"), bad);
  }

  void oneOfSeveralValuesIsTakenWithoutKinds() {
    const std::string head = "NRRD0005\ntype: uint8\nencoding: raw\ndimension: 4\n";
    const std::string last = head + "sizes: 2 3 4 2\n", end = "\n\n" + voxels(48);
    for (const char* fields :
         {"space: LPS\nspace directions: (0.5,0,0) (0,0.6,0) (0,0,0.8) none",
          "space: LPS\nspace directions: (0.5,0,0) (0,0.6,0) (0,0,0.8) (nan,nan,nan)",
          "space: LPST\nspace directions: (0.5,0,0,0) (0,0.6,0,0) (0,0,0.8,0) (0,0,0,2)",
          "spacings: 0.5 0.6 0.8 NaN", "spacings: 0.5 0.6 0.8 2\nkinds: space space space time"}) {
      const Read got = read("v.nrrd", last + fields + end, 1);
      QCOMPARE(got.error, QString());
      QVERIFY2(lies(got.geometry, {0.5, 0.6, 0.8}, {0, 0, 0}, {1, 1, 1}), fields);
      QCOMPARE(got.warnings, QString());
    }
    const Read first = read(
        "v.nrrd",
        head + "sizes: 2 2 3 4\nspace: LPS\nspace directions: none (0.5,0,0) (0,0.6,0) (0,0,0.8)" +
            end,
        1);
    QVERIFY(lies(first.geometry, {0.5, 0.6, 0.8}, {0, 0, 0}, {1, 1, 1}));
  }

  void fieldsInCapitalsAndUnknownOnes() {
    const Folder f;
    save(f / "v.nrrd",
         "NRRD0005\r\nType: UINT8\r\nDimension: 3\r\nSIZES: 2 3 4\r\nSpace: lps\r\nEncoding: "
         "ASCII\r\nSpace Directions: (1,0,0) (0,2,0) (0,0,3)\r\na key: with colon:=its value\r\n"
         "\r\n0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23\n");
    const LoadedImage text = readImage(f / "v.nrrd");
    QCOMPARE(text.image.voxels[23], 23.0F);
    QCOMPARE(text.image.geometry.spacing, Eigen::Vector3d(1, 2, 3));
    save(f / "raw.nrrd",
         "NRRD0005\nTYPE: Unsigned Char\ndimension: 3\nsizes: 2 3 4\nspace: LPS\n"
         "space directions: (1,0,0) (0,2,0) (0,0,3)\nencoding: RAW\n\n" +
             voxels());
    QCOMPARE(readImage(f / "raw.nrrd").image.voxels[23], 23.0F);
    const QString message = read("v.nrrd", nrrd("AnatomicalOrientation: RAI")).error;
    QVERIFY2(message.contains("'AnatomicalOrientation'"), qPrintable(message));
  }

  void theSformOfNiftiIsTakenAndTheOtherSaid_data() {
    QTest::addColumn<QVector<double>>("sform");  // its first three columns, RAS
    QTest::addColumn<int>("qCode");
    QTest::addColumn<QString>("warning");
    const auto row = [](const char* name, const QVector<double>& sform, int qCode,
                        const char* warning) {
      QTest::addRow("%s", name) << sform << qCode << QString(warning);
    };
    row("alike", {-1, 0, 0, 0, -2, 0, 0, 0, 3}, 1, "");
    row("nearly", {-1, 1e-4, 0, 0, -2, 0, 0, 0, 3.0001}, 1, "");
    row("half a turn", {1, 0, 0, 0, 2, 0, 0, 0, 3}, 1, "turned by 180 degrees");
    row("another turn", {0, -2, 0, 1, 0, 0, 0, 0, 3}, 1, "turned by 90 degrees");
    row("mirrored", {1, 0, 0, 0, -2, 0, 0, 0, 3}, 1, "mirrored");
    row("scaled", {-2, 0, 0, 0, -2, 0, 0, 0, 3}, 1, "voxels of 2 x 2 x 3 against 1 x 2 x 3 mm");
    row("scaled, alone", {-1, 0, 0, 0, -1, 0, 0, 0, 1}, 0, "1 x 1 x 1 mm and pixdim 1 x 2 x 3 mm");
    row("alone", {1, 0, 0, 0, 2, 0, 0, 0, 3}, 0, "");
  }
  void theSformOfNiftiIsTakenAndTheOtherSaid() {
    QFETCH(QVector<double>, sform);
    QFETCH(int, qCode);
    QFETCH(QString, warning);
    const Folder f;
    writeVolume(fullMask(), f / "v.nii");
    std::string bytes = bytesOf(f / "v.nii");
    put(bytes, 252, static_cast<short>(qCode));
    put(bytes, 254, short{2});
    Eigen::Matrix3d lps;
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) {
        const double value = sform[3 * row + column];
        put(bytes, static_cast<std::size_t>(280 + 16 * row + 4 * column),
            static_cast<float>(value));
        lps(row, column) = row < 2 ? -value : value;
      }
    const Read got = read("v.nii", bytes);
    QCOMPARE(got.error, QString());
    QCOMPARE(got.warnings.isEmpty(), warning.isEmpty());
    QVERIFY2(got.warnings.contains(warning), qPrintable(got.warnings));
    const Eigen::Matrix3d steps = got.geometry.direction * got.geometry.spacing.asDiagonal();
    QVERIFY((steps - lps).norm() < 1e-6);
  }

  void namesMayBeInCapitals() {
    const Folder f;
    const Volume<std::uint8_t> image = fullMask();
    for (const char* name :
         {"V.NII.GZ", "V.NII", "V.NRRD", "W.NHDR", "V.MHA", "X.MHD", "v.Nii.Gz"}) {
      writeVolume(image, f / name);
      const NativeImage back = readNative(f / name);
      QVERIFY2(std::get<Volume<std::uint8_t>>(back.volume).voxels == image.voxels, name);
      QVERIFY(geometryOf(back.volume) == image.geometry);
    }
    // What it is, is told from the file.
    fs::rename(f / "V.NII.GZ", f / "packed.nii");
    fs::rename(f / "V.NII", f / "plain.nii.gz");
    QVERIFY(readMask(f / "packed.nii").mask.voxels == image.voxels);
    QVERIFY(readMask(f / "plain.nii.gz").mask.voxels == image.voxels);
  }

  void whatIsNoNumberIsReplacedAndCounted() {
    const Folder f;
    Volume<float> image;
    image.geometry.size = {2, 3, 4};
    image.voxels = BigVector<float>(24, 1.0F);
    image.voxels[3] = -7.0F;
    image.voxels[4] = 9.0F;
    const float infinity = std::numeric_limits<float>::infinity();
    image.voxels[0] = std::numeric_limits<float>::quiet_NaN();
    image.voxels[1] = infinity;
    image.voxels[2] = -infinity;
    writeVolume(image, f / "v.nii");
    QVERIFY_THROWS_EXCEPTION(InputError, readImage(f / "v.nii"));
    ReadOptions options;
    options.replaceNotFinite = true;
    const LoadedImage read = readImage(f / "v.nii", options);
    QCOMPARE(read.image.voxels[0], -7.0F);
    QCOMPARE(read.image.voxels[1], 9.0F);
    QCOMPARE(read.image.voxels[2], -7.0F);
    QCOMPARE(read.image.voxels[5], 1.0F);
    QCOMPARE(read.info.warnings.size(), std::size_t{1});
    QVERIFY(read.info.warnings[0].find("3 voxels are not a finite number") == 0);
    const LoadedImage described =
        readImage(describeImages(f / "v.nii").front(), f / "v.nii", false);
    QCOMPARE(described.image.voxels[0], -7.0F);
    image.voxels = BigVector<float>(24, infinity);
    writeVolume(image, f / "v.nii");
    QVERIFY_THROWS_EXCEPTION(InputError, readImage(f / "v.nii", options));
  }

  void placesThatNoScanHasAreSaid_data() {
    QTest::addColumn<QString>("spacing");
    QTest::addColumn<QString>("matrix");
    QTest::addColumn<QString>("warning");
    const QString unit = "1 0 0 0 1 0 0 0 1";
    QTest::newRow("plain") << "0.5 0.5 1" << unit << "";
    QTest::newRow("three digits") << "0.5 0.5 1"
                                  << "0.866 0.5 0 -0.5 0.866 0 0 0 1"
                                  << "";
    QTest::newRow("twice") << "0.5 0.5 1"
                           << "2 0 0 0 2 0 0 0 2"
                           << "length 1 but 2 x 2 x 2";
    QTest::newRow("skewed") << "0.5 0.5 1"
                            << "1 0 0 0.0871557 0.9961947 0 0 0 1"
                            << "by 5 degrees";
    QTest::newRow("micrometres") << "0.004 0.004 0.004" << unit << "0.004 x 0.004 x 0.004 mm";
    QTest::newRow("large voxels") << "500 500 500" << unit << "500 x 500 x 500 mm";
    QTest::newRow("metres") << "0.0005 0.0005 0.001" << unit << "in millimetres?";
    QTest::newRow("small box") << "0.02 0.02 0.02" << unit << "a volume of";
  }
  void placesThatNoScanHasAreSaid() {
    QFETCH(QString, spacing);
    QFETCH(QString, matrix);
    QFETCH(QString, warning);
    const Read got =
        read("v.mha", "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = " +
                          spacing.toStdString() + "\nTransformMatrix = " + matrix.toStdString() +
                          "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxels());
    QCOMPARE(got.error, QString());
    QCOMPARE(got.warnings.isEmpty(), warning.isEmpty());
    QVERIFY2(got.warnings.contains(warning), qPrintable(got.warnings));
    if (QTest::currentDataTag() == QString("twice"))
      QVERIFY(lies(got.geometry, {1, 1, 2}, {0, 0, 0}, {1, 1, 1}));
  }

  void aHeaderThatSaysTwoThingsIsRefused() {
    const auto meta = [](const std::string& lines) {
      return "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\n" + lines +
             "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxels();
    };
    for (const auto& [lines, fields] :
         {std::pair<std::string, const char*>{"DimSize = 4 3 2\n", "'2 3 4' and '4 3 2'"},
          {"ElementSpacing = 1 1 1\n", "ElementSpacing"},
          {"Offset = 1 2 3\nPosition = 1 2 4\n", "Offset is '1 2 3', Position '1 2 4'"},
          {"Offset = 1 2 3\nOrigin = 1 2\n", "Origin"},
          {"TransformMatrix = 1 0 0 0 1 0 0 0 1\nOrientation = 0 1 0 1 0 0 0 0 1\n",
           "Orientation"}})
      QVERIFY2(read("v.mha", meta(lines)).error.contains(fields), lines.c_str());
    for (const std::string lines : {"Comment = one\nComment = two\n", "DimSize = 2 3 4\n",
                                    "Offset = 1 2 3\nPosition = 1.0 2.0 3.0\n"}) {
      const Read got = read("v.mha", meta(lines));
      QVERIFY2(got.error.isEmpty() && got.warnings.isEmpty(), lines.c_str());
    }
    QVERIFY(read("v.nrrd", nrrd("spacings: 1 2 3\nspacings: 1 2 4")).error.contains("spacings"));
    QVERIFY(read("v.nrrd", nrrd("spacings: 1 2 3\nspacings: 1 2 3.0\na:=1\na:=2")).error.isEmpty());
  }

  /// NRRD allows one of them; who writes both means the same by them.
  void spacingsThatDisagreeAreSaid_data() {
    QTest::addColumn<QString>("fields");
    QTest::addColumn<QString>("warning");
    const QString directions = "space: LPS\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n";
    QTest::newRow("directions") << directions + "spacings: 1 2 4"
                                << "3 mm long along axis 3 by its space directions and 4 mm";
    QTest::newRow("directions, alike") << directions + "spacings: 1 2 -3"
                                       << "";
    QTest::newRow("directions, unknown") << directions + "spacings: nan nan nan"
                                         << "";
    QTest::newRow("directions, units")
        << "space: LPS\nspace units: \"cm\" \"cm\" \"cm\"\nspace directions: (0.1,0,0) "
           "(0,0.2,0) (0,0,0.3)\nspacings: 0.1 0.2 0.3"
        << "";
    QTest::newRow("ends") << "spacings: 1 2 3\naxis mins: 0 0 0\naxis maxs: 4 6 12"
                          << "1 mm long along axis 1 by its spacings and 2 mm";
    QTest::newRow("ends, alike") << "spacings: 1 2 3\naxis mins: 0 0 0\naxis maxs: 2 6 12"
                                 << "";
    QTest::newRow("directions, no space") << "space directions: (1,0,0) (0,2,0) (0,0,3)"
                                          << "a space without a name";
  }
  void spacingsThatDisagreeAreSaid() {
    QFETCH(QString, fields);
    QFETCH(QString, warning);
    const Read got = read("v.nrrd", nrrd(fields.toStdString()));
    QCOMPARE(got.error, QString());
    QVERIFY((got.geometry.spacing - Eigen::Vector3d(1, 2, 3)).norm() < 1e-9);
    QCOMPARE(got.warnings.isEmpty(), warning.isEmpty());
    QVERIFY2(got.warnings.contains(warning), qPrintable(got.warnings));
  }

  void aQformThatIsNoneIsSaid() {
    const Folder f;
    writeVolume(fullMask(), f / "v.nii");
    std::string bytes = bytesOf(f / "v.nii");
    put(bytes, 254, short{0});
    QCOMPARE(read("v.nii", bytes).warnings, QString());
    std::string turned = bytes;
    for (const std::size_t at : {256, 260, 264}) put(turned, at, 1.0F);
    QVERIFY(read("v.nii", turned).warnings.contains("a length of 1.732 instead of 1"));
    put(bytes, 80, -1.0F);
    const Read negative = read("v.nii", bytes);
    QVERIFY2(negative.warnings.contains("pixdim) is negative"), qPrintable(negative.warnings));
    QVERIFY((negative.geometry.spacing - Eigen::Vector3d(1, 2, 3)).norm() < 1e-9);
  }

  void metaImagesHaveUnitsToo() {
    const auto meta = [](const std::string& line) {
      return "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\nOffset = 4 5 "
             "6\nElementType = MET_UCHAR\n" +
             line + "ElementDataFile = LOCAL\n" + voxels();
    };
    for (const auto& [line, scale] : {std::pair<std::string, double>{"", 1.0},
                                      {"DistanceUnits = mm\n", 1.0},
                                      {"DistanceUnits = ?\n", 1.0},
                                      {"DistanceUnits = um\n", 1e-3},
                                      {"DistanceUnits = cm\n", 10.0}}) {
      const Read got = read("v.mha", meta(line));
      QVERIFY2(lies(got.geometry, scale * Eigen::Vector3d(1, 2, 3),
                    scale * Eigen::Vector3d(4, 5, 6), {1, 1, 1}),
               line.c_str());
      QCOMPARE(withoutSizes(got.warnings), QString());
    }
    const Read got = read("v.mha", meta("DistanceUnits = ell\n"));
    QVERIFY(got.warnings.contains("'ell'"));
  }
};

QTEST_APPLESS_MAIN(TestImagePlace)
#include "tst_image_place.moc"
