// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/image_io.h"

#include <Eigen/Dense>

// After Eigen: ITK's own copy of it stays out then.
#include <itkImage.h>
#include <itkImageFileReader.h>
#include <itkMetaImageIO.h>
#include <itkNiftiImageIO.h>
#include <itkNrrdImageIO.h>

#include <QTest>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "io/volume/image_write.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

Geometry rotated(bool leftHanded = false) {
  Geometry g;
  g.size = {7, 5, 4};
  g.spacing = {0.3, 0.7, 1.25};
  g.origin = {-21.375, 104.5, -33.0625};
  g.direction = (Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()) *
                 Eigen::AngleAxisd(2.0, Eigen::Vector3d::UnitX()))
                    .toRotationMatrix();
  if (leftHanded) g.direction.col(2) *= -1.0;
  return g;
}

template <class T>
Volume<T> numbered(const Geometry& g) {
  Volume<T> volume(g);
  for (std::size_t i = 0; i < volume.voxels.size(); ++i)
    volume.voxels[i] = static_cast<T>((i * 37) % 251);
  return volume;
}

/// Where three corners of the grid lie, the only thing that matters of a geometry.
bool sameCorners(const Geometry& a, const Geometry& b, double toleranceMm) {
  if (a.size != b.size) return false;
  for (const Eigen::Vector3d& index :
       {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(a.size[0], 0, 0),
        Eigen::Vector3d(0, a.size[1], 0), Eigen::Vector3d(0, 0, a.size[2])})
    if ((a.toPhysical(index) - b.toPhysical(index)).norm() > toleranceMm) return false;
  return true;
}

/// 2 x 3 x 4 voxels with the values 0, 1, 2, ... 23.
template <class T>
std::string rawVoxels() {
  std::string bytes;
  for (int i = 0; i < 24; ++i) append(bytes, static_cast<T>(i));
  return bytes;
}

const char* const kMetaHeader =
    "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\n";

std::string metaImage(const std::string& type, const std::string& voxels) {
  return kMetaHeader + ("ElementType = " + type) + "\nElementDataFile = LOCAL\n" + voxels;
}

std::string nrrd(const std::string& type, const std::string& voxels,
                 const std::string& space = "left-posterior-superior") {
  return "NRRD0004\ntype: " + type + "\ndimension: 3\nspace: " + space +
         "\nsizes: 2 3 4\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n"
         "kinds: domain domain domain\nendian: little\nencoding: raw\n"
         "space origin: (10,20,30)\n\n" +
         voxels;
}

/// `sform` axes 1, 2, 3 mm along right, anterior, superior; origin (10, 20, 30) in RAS.
std::string nifti(short datatype, short bits, const std::string& voxels,
                  std::vector<short> dims = {3, 2, 3, 4, 1, 1, 1, 1}) {
  std::string h(352, '\0');
  put<std::int32_t>(h, 0, 348);
  for (std::size_t i = 0; i < 8; ++i) put<std::int16_t>(h, 40 + 2 * i, dims[i]);
  put<std::int16_t>(h, 70, datatype);
  put<std::int16_t>(h, 72, bits);
  for (std::size_t i = 0; i < 4; ++i) put<float>(h, 76 + 4 * i, i == 0 ? 1.0F : float(i));
  put<float>(h, 108, 352.0F);
  h[123] = 2;  // mm
  put<std::int16_t>(h, 254, 1);
  const float rows[3][4] = {{1, 0, 0, 10}, {0, 2, 0, 20}, {0, 0, 3, 30}};
  std::memcpy(h.data() + 280, rows, sizeof(rows));
  std::memcpy(h.data() + 344, "n+1", 4);
  return h + voxels;
}

enum class Kind { None, Input, Io };

Kind kindOf(const std::function<void()>& call, std::string& message) {
  try {
    call();
  } catch (const InputError& error) {
    message = error.what();
    return Kind::Input;
  } catch (const IoError& error) {
    message = error.what();
    return Kind::Io;
  }
  return Kind::None;
}

}  // namespace

class TestImageIo : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void volumesSurviveARoundTrip_data() {
    QTest::addColumn<QString>("extension");
    QTest::addColumn<bool>("leftHanded");
    for (const char* extension : {".mha", ".nrrd", ".nii", ".nii.gz"})
      for (const bool left : {false, true})
        QTest::addRow("%s %s", extension, left ? "left-handed" : "right-handed")
            << QString(extension) << left;
  }
  void volumesSurviveARoundTrip() {
    QFETCH(QString, extension);
    QFETCH(bool, leftHanded);
    const Folder folder;
    const fs::path path = folder / ("v" + extension.toStdString());
    auto image = numbered<float>(rotated(leftHanded));
    image.voxels[5] = -1234.0625F;
    writeVolume(image, path);
    const LoadedImage loaded = readImage(path);
    QCOMPARE(loaded.image.voxels, image.voxels);
    QCOMPARE(loaded.info.pixelType, std::string("float32"));
    // NIfTI keeps its geometry in float32.
    const double tolerance = extension.startsWith(".nii") ? 1e-4 : 1e-9;
    QVERIFY(sameCorners(loaded.image.geometry, image.geometry, tolerance));
    QVERIFY(loaded.info.warnings.empty());
    QCOMPARE(entriesOf(folder.path()), 1);

    auto mask = numbered<std::uint8_t>(rotated(leftHanded));
    for (auto& voxel : mask.voxels) voxel = voxel % 3 == 0 ? 1 : 0;
    writeVolume(mask, path);
    const auto back = readMask(path).mask;
    QCOMPARE(back.voxels, mask.voxels);
    QVERIFY(sameCorners(back.geometry, mask.geometry, tolerance));
    QCOMPARE(describeImages(path).at(0).info.pixelType, std::string("uint8"));
    QVERIFY(sameCorners(describeImages(path).at(0).geometry, mask.geometry, tolerance));
  }

  void otherProgramsSeeImagesInPlace_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {".mha", ".mhd", ".nrrd", ".nhdr", ".nii", ".nii.gz"})
      QTest::newRow(extension) << QString(extension);
  }
  void otherProgramsSeeImagesInPlace() {
    QFETCH(QString, extension);
    const Folder folder;
    for (const bool left : {false, true}) {
      const auto before = numbered<std::int16_t>(rotated(left));
      const fs::path path = folder / ("v" + extension.toStdString());
      writeVolume(AnyVolume(before), path);
      using Image = itk::Image<short, 3>;
      const auto reader = itk::ImageFileReader<Image>::New();
      if (extension.startsWith(".mh")) reader->SetImageIO(itk::MetaImageIO::New());
      if (extension.startsWith(".n") && !extension.startsWith(".ni"))
        reader->SetImageIO(itk::NrrdImageIO::New());
      if (extension.startsWith(".ni")) reader->SetImageIO(itk::NiftiImageIO::New());
      reader->SetFileName(path.string());
      reader->Update();
      const Image& image = *reader->GetOutput();
      const double tolerance = extension.startsWith(".ni") ? 1e-4 : 1e-9;
      for (int k = 0; k < before.geometry.size[2]; ++k)
        for (int j = 0; j < before.geometry.size[1]; ++j)
          for (int i = 0; i < before.geometry.size[0]; ++i) {
            const Image::IndexType index{{i, j, k}};
            Image::PointType point;
            image.TransformIndexToPhysicalPoint(index, point);
            const Eigen::Vector3d ours = before.geometry.toPhysical(Eigen::Vector3d(i, j, k));
            QVERIFY((ours - Eigen::Vector3d(point[0], point[1], point[2])).norm() < tolerance);
            QCOMPARE(image.GetPixel(index), before.at(i, j, k));
          }
    }
  }

  void segmentationsAreCompressedAndInLps() {
    const Folder folder;
    writeVolume(numbered<std::uint8_t>(rotated()), folder / "mask.nrrd");
    const std::string head = bytesOf(folder / "mask.nrrd").substr(0, 1000);
    QVERIFY(head.find("space: left-posterior-superior") != std::string::npos);
    QVERIFY(head.find("encoding: gzip") != std::string::npos);
  }

  void everyPixelTypeIsRead_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("type");
    const auto row = [](const char* name, const std::string& file, const char* type) {
      QTest::addRow("%s %s", name, type)
          << QString(name) << QByteArray::fromStdString(file) << QString(type);
    };
    const auto all = [&]<class T>(T, const char* meta, const char* nrrdName, short datatype,
                                  const char* type) {
      const std::string voxels = rawVoxels<T>();
      if (meta != nullptr) row("v.mha", metaImage(meta, voxels), type);
      row("v.nrrd", nrrd(nrrdName, voxels), type);
      row("v.nii", nifti(datatype, 8 * sizeof(T), voxels), type);
    };
    all(std::int8_t{}, "MET_CHAR", "signed char", 256, "int8");
    all(std::uint8_t{}, "MET_UCHAR", "unsigned char", 2, "uint8");
    all(std::int16_t{}, "MET_SHORT", "short", 4, "int16");
    all(std::uint16_t{}, "MET_USHORT", "unsigned short", 512, "uint16");
    all(std::int32_t{}, "MET_INT", "int", 8, "int32");
    all(std::uint32_t{}, "MET_UINT", "unsigned int", 768, "uint32");
    all(std::int64_t{}, "MET_LONG_LONG", "long long int", 1024, "int64");
    all(std::uint64_t{}, "MET_ULONG_LONG", "unsigned long long int", 1280, "uint64");
    all(float{}, "MET_FLOAT", "float", 16, "float32");
    all(double{}, "MET_DOUBLE", "double", 64, "float64");
  }
  void everyPixelTypeIsRead() {
    QFETCH(QString, name);
    QFETCH(QByteArray, file);
    QFETCH(QString, type);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    save(path, file.toStdString());
    const LoadedImage loaded = readImage(path);
    QCOMPARE(QString::fromStdString(loaded.info.pixelType), type);
    QCOMPARE(loaded.image.geometry.size, (Index3{2, 3, 4}));
    QCOMPARE(loaded.image.geometry.spacing, Eigen::Vector3d(1, 2, 3));
    for (std::size_t i = 0; i < 24; ++i) QCOMPARE(loaded.image.voxels[i], static_cast<float>(i));
  }

  void framesOfOtherProgramsBecomeLps() {
    const Folder folder;
    const std::string voxels = rawVoxels<float>();
    save(folder / "ras.nrrd", nrrd("float", voxels, "right-anterior-superior"));
    save(folder / "ras.nii", nifti(16, 32, voxels));
    for (const char* name : {"ras.nrrd", "ras.nii"}) {
      const Geometry g = readImage(folder / name).image.geometry;
      QVERIFY((g.toPhysical({0, 0, 0}) - Eigen::Vector3d(-10, -20, 30)).norm() < 1e-5);
      QVERIFY((g.toPhysical({1, 1, 1}) - Eigen::Vector3d(-11, -22, 33)).norm() < 1e-5);
    }
  }

  void headerInAFileOfItsOwn() {
    const Folder folder;
    const std::string voxels = rawVoxels<float>();
    save(folder / "v.raw", voxels);
    save(folder / "v.mhd", std::string(kMetaHeader) +
                               "Modality = MET_MOD_MR\nElementType = MET_FLOAT\n"
                               "ElementDataFile = v.raw\n");
    std::string header = nrrd("float", "");
    header.insert(header.size() - 1, "data file: v.raw\n");
    save(folder / "v.nhdr", header);
    QCOMPARE(readImage(folder / "v.mhd").image.voxels[23], 23.0F);
    QCOMPARE(readImage(folder / "v.mhd").info.modality, std::string("MR"));
    QCOMPARE(readImage(folder / "v.nhdr").image.voxels[23], 23.0F);
    for (const std::size_t length : {std::size_t{90}, std::size_t{0}}) {
      save(folder / "v.raw", voxels.substr(0, length));
      QVERIFY_THROWS_EXCEPTION(IoError, readImage(folder / "v.mhd"));
      QVERIFY_THROWS_EXCEPTION(IoError, readImage(folder / "v.nhdr"));
    }
    fs::remove(folder / "v.raw");
    QVERIFY_THROWS_EXCEPTION(IoError, readImage(folder / "v.mhd"));
    QVERIFY_THROWS_EXCEPTION(IoError, readImage(folder / "v.nhdr"));
  }

  void missingSpacingIsSaid() {
    const Folder folder;
    save(folder / "v.mha",
         "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_FLOAT\n"
         "ElementDataFile = LOCAL\n" +
             rawVoxels<float>());
    QCOMPARE(readImage(folder / "v.mha").info.warnings.size(), std::size_t{1});
    QVERIFY_THROWS_EXCEPTION(InputError, readImage(folder / "v.mha", {"1.2.3", false}));
  }

  void badInputIsRefusedInOneLine_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<bool>("isInput");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* title, const char* name, const std::string& file, bool input,
                        const char* says) {
      QTest::newRow(title) << QString(name) << QByteArray::fromStdString(file) << input
                           << QString(says);
    };
    const std::string voxels = rawVoxels<float>();
    row("empty mha", "v.mha", "", false, "empty");
    row("empty nii.gz", "v.nii.gz", "", false, "empty");
    row("text", "v.nrrd", "hello world", true, "not an image");
    row("noise", "v.nii", std::string(5000, '\x7b'), true, "not an image");
    row("header only mha", "v.mha", kMetaHeader, true, "header");
    row("header only nrrd", "v.nrrd", "NRRD0004\ntype: float\n", true, "header");
    row("header only nii", "v.nii", nifti(16, 32, "").substr(0, 200), false, "truncated");
    for (const std::size_t cut : {std::size_t{1}, std::size_t{50}, std::size_t{96}}) {
      const std::string part = voxels.substr(0, voxels.size() - cut);
      const std::string title = "truncated by " + std::to_string(cut) + " ";
      row((title + "mha").c_str(), "v.mha", metaImage("MET_FLOAT", part), false, "truncated");
      row((title + "nrrd").c_str(), "v.nrrd", nrrd("float", part), false, "truncated");
      row((title + "nii").c_str(), "v.nii", nifti(16, 32, part), false, "truncated");
    }
    row("2D mha", "v.mha",
        "ObjectType = Image\nNDims = 2\nDimSize = 4 6\nElementSpacing = 1 1\n"
        "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
            voxels,
        true, "2D");
    row("one slice", "v.nii", nifti(16, 32, voxels, {3, 4, 6, 1, 1, 1, 1, 1}), true, "3D");
    row("2D nii", "v.nii", nifti(16, 32, voxels, {2, 4, 6, 1, 1, 1, 1, 1}), true, "D");
    row("4D nii", "v.nii", nifti(16, 32, voxels, {4, 2, 3, 2, 2, 1, 1, 1}), true, "4D");
    row("4D mha", "v.mha",
        "ObjectType = Image\nNDims = 4\nDimSize = 2 3 2 2\nElementSpacing = 1 1 1 1\n"
        "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
            voxels,
        true, "4D");
    row("colour mha", "v.mha",
        std::string(kMetaHeader) +
            "ElementNumberOfChannels = 3\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
            std::string(72, 'x'),
        true, "colour");
    row("colour nii", "v.nii", nifti(128, 24, std::string(72, 'x')), true, "colour");
    row("vector nrrd", "v.nrrd",
        "NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 2 3 4\nkinds: vector domain domain domain\n"
        "encoding: raw\n\n" +
            std::string(72, 'x'),
        true, "vector");
    row("constant", "v.mha", metaImage("MET_FLOAT", std::string(96, '\0')), true, "same value");
    std::string nan = voxels;
    put(nan, 40, std::numeric_limits<float>::quiet_NaN());
    row("NaN mha", "v.mha", metaImage("MET_FLOAT", nan), true, "finite");
    row("NaN nrrd", "v.nrrd", nrrd("float", nan), true, "finite");
    row("NaN nii", "v.nii", nifti(16, 32, nan), true, "finite");
    std::string infinite = voxels;
    put(infinite, 40, std::numeric_limits<float>::infinity());
    row("infinity", "v.nii", nifti(16, 32, infinite), true, "finite");
    row("absurd size mha", "v.mha",
        "ObjectType = Image\nNDims = 3\nDimSize = 99999 99999 99999\nElementSpacing = 1 1 1\n"
        "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
            voxels,
        true, "DimSize");
    row("large size nrrd", "v.nrrd",
        "NRRD0004\ntype: float\ndimension: 3\nsizes: 9000 9000 9000\nencoding: gzip\n\n" + voxels,
        false, "");
    row("negative size", "v.mha",
        "ObjectType = Image\nNDims = 3\nDimSize = 2 -3 4\nElementType = MET_FLOAT\n"
        "ElementDataFile = LOCAL\n" +
            voxels,
        true, "DimSize");
    row("zero spacing", "v.mha",
        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 0 1\n"
        "ElementType = MET_FLOAT\nElementDataFile = LOCAL\n" +
            voxels,
        true, "");
    row("singular directions", "v.nrrd",
        "NRRD0004\ntype: float\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 4\n"
        "space directions: (1,0,0) (1,0,0) (0,0,3)\nendian: little\nencoding: raw\n\n" +
            voxels,
        true, "");
  }
  void badInputIsRefusedInOneLine() {
    QFETCH(QString, name);
    QFETCH(QByteArray, file);
    QFETCH(bool, isInput);
    QFETCH(QString, says);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    save(path, file.toStdString());
    std::string message;
    TerminalCapture terminal;
    const Kind kind = kindOf([&] { readImage(path); }, message);
    QCOMPARE(terminal.text(), QString());
    QVERIFY2(kind == (isInput ? Kind::Input : Kind::Io), message.c_str());
    QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
    QVERIFY(message.find('\n') == std::string::npos);
  }

  void truncationIsFoundAtEveryLength_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {".mha", ".nrrd", ".nii", ".nii.gz"})
      QTest::newRow(extension) << QString(extension);
  }
  void truncationIsFoundAtEveryLength() {
    QFETCH(QString, extension);
    const Folder folder;
    const fs::path path = folder / ("v" + extension.toStdString());
    writeVolume(numbered<float>(rotated()), path);
    const std::string whole = bytesOf(path);
    QString missed;
    TerminalCapture terminal;
    for (std::size_t length = 0; length < whole.size();
         length += length + 20 < whole.size() ? 13 : 1) {
      save(path, whole.substr(0, length));
      std::string message;
      const Kind kind = kindOf([&] { readImage(path); }, message);
      if (kind == Kind::None) missed += QString(" %1").arg(length);
    }
    QCOMPARE(terminal.text(), QString());
    QVERIFY2(missed.isEmpty(), qPrintable("of " + QString::number(whole.size()) + missed));
  }

  void damagedBytesNeverCrash() {
    const Folder folder;
    for (const char* extension : {".mha", ".nrrd", ".nii", ".nii.gz"}) {
      const fs::path path = folder / (std::string("v") + extension);
      writeVolume(numbered<float>(rotated()), path);
      const std::string whole = bytesOf(path);
      int refused = 0;
      TerminalCapture terminal;
      for (std::size_t at = 0; at < whole.size(); at += 7) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        save(path, damaged);
        std::string message;
        if (kindOf([&] { readImage(path); }, message) != Kind::None) ++refused;
      }
      QVERIFY(refused > 0);
      QCOMPARE(terminal.text(), QString());
    }
  }

  void masksMayBeConstantButNotNan() {
    const Folder folder;
    save(folder / "zero.mha", metaImage("MET_FLOAT", std::string(96, '\0')));
    QVERIFY(readMask(folder / "zero.mha").mask.voxels == BigVector<std::uint8_t>(24, 0));
    std::string nan = rawVoxels<float>();
    put(nan, 40, std::numeric_limits<float>::quiet_NaN());
    save(folder / "nan.mha", metaImage("MET_FLOAT", nan));
    QCOMPARE(readMask(folder / "nan.mha").warnings.size(), std::size_t{1});
    save(folder / "label.mha", metaImage("MET_FLOAT", rawVoxels<float>()));
    BigVector<std::uint8_t> expected(24, 1);
    expected[0] = 0;
    QCOMPARE(readMask(folder / "label.mha").mask.voxels, expected);
  }

  void badPlacesAreRefused() {
    const Folder folder;
    const auto image = numbered<float>(rotated());
    save(folder / "file", "x");
    fs::create_directory(folder / "folder.nrrd");
    for (const char* name : {"none/v.nrrd", "file/v.nrrd", "folder.nrrd"})
      QVERIFY_THROWS_EXCEPTION(IoError, writeVolume(image, folder / name));
    QVERIFY_THROWS_EXCEPTION(IoError, writeVolume(image, "/dev/null.nrrd/v.nrrd"));
    QVERIFY_THROWS_EXCEPTION(InputError, writeVolume(image, folder / "v.png"));
    QVERIFY_THROWS_EXCEPTION(IoError, readImage(folder / "none.mha"));
    QVERIFY_THROWS_EXCEPTION(IoError, describeImages(folder / "none.mha"));
    QCOMPARE(entriesOf(folder.path()), 2);
  }

  void fullDiskLeavesNothingBehind_data() { truncationIsFoundAtEveryLength_data(); }
  void fullDiskLeavesNothingBehind() {
    QFETCH(QString, extension);
    const Folder folder;
    const fs::path path = folder / ("v" + extension.toStdString());
    Geometry g = rotated();
    g.size = {40, 40, 40};
    Volume<float> image(g);
    std::uint32_t noise = 1;
    for (float& voxel : image.voxels) {
      noise = noise * 1664525U + 1013904223U;
      voxel = static_cast<float>(noise >> 8U);
    }
    save(path, "old");
    for (const rlim_t limit : {rlim_t{0}, rlim_t{100}, rlim_t{100000}}) {
      std::string message;
      TerminalCapture terminal;
      Kind kind = Kind::None;
      {
        const FullDisk full(limit);
        kind = kindOf([&] { writeVolume(image, path); }, message);
      }
      QCOMPARE(terminal.text(), QString());
      QVERIFY(kind == Kind::Io);
      QVERIFY2(message.find(path.string()) != std::string::npos, message.c_str());
      QCOMPARE(bytesOf(path), std::string("old"));
      QCOMPARE(entriesOf(folder.path()), 1);
    }
  }

  void realScansAreRead() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    const fs::path root = data.toStdString();
    const LoadedImage a = readImage(root / "avf-mra/avf_float_32.nrrd");
    const LoadedImage b = readImage(root / "avf-mra/avf_float_32.nii.gz");
    QVERIFY(sameCorners(a.image.geometry, b.image.geometry, 1e-4));
    QCOMPARE(a.image.voxels, b.image.voxels);
    const Geometry brain = readImage(root / "brain-tof-crop/mra.mha").image.geometry;
    QCOMPARE(brain.size, (Index3{140, 123, 34}));
    QVERIFY(std::fabs(brain.direction.determinant() - 1.0) < 1e-6);
    QVERIFY(std::fabs(brain.direction(0, 1)) > 0.05);
  }
};

QTEST_APPLESS_MAIN(TestImageIo)
#include "tst_image_io.moc"
