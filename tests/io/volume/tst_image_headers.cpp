// SPDX-License-Identifier: BSD-3-Clause
#include <zlib.h>

#include <QTest>
#include <algorithm>
#include <optional>

#include "core/base/error.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// 2 x 3 x 4 voxels: 0, 1, ... 23, as bytes of T, the most significant first where asked for.
template <class T>
std::string ramp(bool bigEndian = false, int count = 24) {
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    std::string one;
    append(one, static_cast<T>(i));
    if (bigEndian) std::reverse(one.begin(), one.end());
    bytes += one;
  }
  return bytes;
}

std::string gzipped(const std::string& plain) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(plain.size() + 200, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(plain.data()));
  stream.avail_in = static_cast<unsigned>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<unsigned>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

const char* const kMeta =
    "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\n";

std::string meta(const std::string& lines, const std::string& voxels) {
  return kMeta + lines + "\nElementDataFile = LOCAL\n" + voxels;
}

std::string nrrd(const std::string& fields, const std::string& voxels = {}) {
  return "NRRD0004\ndimension: 3\nsizes: 2 3 4\nspace: left-posterior-superior\n"
         "space directions: (1,0,0) (0,2,0) (0,0,3)\n" +
         fields + "\n\n" + voxels;
}

bool isRamp(const fs::path& path) {
  const Volume<float> image = readImage(path).image;
  if (image.voxels.size() != 24) return false;
  for (std::size_t i = 0; i < 24; ++i)
    if (image.voxels[i] != static_cast<float>(i)) return false;
  return image.geometry.spacing == Eigen::Vector3d(1, 2, 3);
}

std::string messageOf(const fs::path& path) {
  TerminalCapture terminal;
  std::string message;
  try {
    readImage(path);
  } catch (const Error& error) {
    message = error.what();
  }
  return terminal.text().isEmpty() ? message : std::string();
}

}  // namespace

class TestImageHeaders : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void voxelsAreFoundWhereverTheyAre() {
    const Folder f;
    const std::string plain = ramp<std::int16_t>(), big = ramp<std::int16_t>(true);
    const std::string s = "ElementType = MET_SHORT\n";
    save(f / "swapped.mha", meta(s + "BinaryDataByteOrderMSB = True", big));
    save(f / "skipped.raw", "12345" + plain);
    save(f / "skipped.mhd", kMeta + s + "HeaderSize = 5\nElementDataFile = skipped.raw\n");
    save(f / "atend.mhd", kMeta + s + "HeaderSize = -1\nElementDataFile = skipped.raw\n");
    std::string slices;
    for (int k = 0; k < 4; ++k) {
      const std::string part = plain.substr(12 * static_cast<std::size_t>(k), 12);
      const std::string name = "slice" + std::to_string(k + 7) + ".raw";
      save(f / name, part);
      if (k < 3) save(f / ("slice0" + std::to_string(k + 7) + ".raw"), part);
      slices += name + "\n";
    }
    save(f / "list.mhd", kMeta + s + "ElementDataFile = LIST\n" + slices);
    save(f / "pattern.mhd", kMeta + s + "ElementDataFile = slice%02d.raw 7 10 1\n");
    save(f / "text.mha", meta(s + "BinaryData = False",
                              "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23\n"));
    for (const char* name :
         {"swapped.mha", "skipped.mhd", "atend.mhd", "list.mhd", "pattern.mhd", "text.mha"})
      QVERIFY2(isRamp(f / name), name);

    const std::string t = "type: int16\nendian: little\n";
    save(f / "swapped.nrrd", nrrd("type: short\nendian: big\nencoding: raw", big));
    save(f / "gzip.nrrd", nrrd(t + "encoding: gzip", gzipped(plain)));
    save(f / "members.nrrd",
         nrrd(t + "encoding: gz", gzipped(plain.substr(0, 20)) + gzipped(plain.substr(20))));
    save(f / "d.raw", "a line\nanother\n123" + plain);
    save(f / "skips.nhdr", nrrd(t + "encoding: raw\nline skip: 2\nbyte skip: 3\ndata file: d.raw"));
    save(f / "atend.nhdr", nrrd(t + "encoding: raw\nbyteskip: -1\ndatafile: d.raw"));
    save(f / "d.gz", "a line\n" + gzipped("123" + plain));
    save(f / "gzskips.nhdr",
         nrrd(t + "encoding: gzip\nline skip: 1\nbyte skip: 3\ndata file: d.gz"));
    std::string list = nrrd(t + "encoding: raw\ndata file: LIST");
    list.pop_back();
    save(f / "list.nhdr", list + slices);
    save(f / "pattern.nhdr", nrrd(t + "encoding: raw\ndata file: slice%02d.raw 7 10 1"));
    save(f / "text.nrrd", nrrd("type: short\nencoding: text",
                               "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23\n"));
    for (const char* name :
         {"swapped.nrrd", "gzip.nrrd", "members.nrrd", "skips.nhdr", "atend.nhdr", "gzskips.nhdr",
          "list.nhdr", "pattern.nhdr", "text.nrrd"})
      QVERIFY2(isRamp(f / name), (std::string(name) + ": " + messageOf(f / name)).c_str());
  }

  void unpackingStopsNotFarBeyondTheHeader() {
    const Folder f;
    const std::string zeros(std::size_t{48} << 20, '\0');
    save(f / "d.gz", gzipped(ramp<std::int16_t>() + zeros));
    save(f / "a.nhdr", nrrd("type: int16\nendian: little\nencoding: gzip\ndata file: d.gz"));
    const std::vector<std::string> warnings = readImage(f / "a.nhdr").info.warnings;
    QCOMPARE(warnings.size(), std::size_t(1));
    const std::size_t at = warnings[0].find("at least ");
    QVERIFY2(at != std::string::npos, warnings[0].c_str());
    QVERIFY(std::stoull(warnings[0].substr(at + 9)) < zeros.size() / 8);
  }

  void moreVoxelsThanTheHeaderSaysAreSaid() {
    const Folder f;
    const std::string plain = ramp<std::int16_t>(), longer = plain + std::string(6, '\1');
    const std::string s = "ElementType = MET_SHORT\n", t = "type: int16\nendian: little\n";
    const std::string numbers =
        "0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22 23 24 25 26\n";
    save(f / "d.raw", longer);
    save(f / "d.gz", gzipped(longer));
    save(f / "d.txt", numbers);
    save(f / "a.mhd", kMeta + s + "ElementDataFile = d.raw\n");
    save(f / "skip.mhd", kMeta + s + "HeaderSize = 2\nElementDataFile = d.raw\n");
    save(f / "packed.mhd", kMeta + s + "CompressedData = True\nElementDataFile = d.gz\n");
    save(f / "text.mhd", kMeta + s + "BinaryData = False\nElementDataFile = d.txt\n");
    save(f / "b.mha", meta("ElementType = MET_SHORT", longer));
    save(f / "a.nhdr", nrrd(t + "encoding: raw\ndata file: d.raw"));
    save(f / "packed.nhdr", nrrd(t + "encoding: gzip\ndata file: d.gz"));
    save(f / "text.nhdr", nrrd(t + "encoding: ascii\ndata file: d.txt"));
    save(f / "b.nrrd", nrrd(t + "encoding: raw", longer));
    Volume<std::int16_t> image;
    image.geometry.size = {2, 3, 4};
    image.voxels = BigVector<std::int16_t>(24, 1);
    image.voxels[3] = 2;
    writeVolume(AnyVolume(image), f / "c.nii");
    save(f / "c.nii", bytesOf(f / "c.nii") + "123456");
    for (const char* name : {"a.mhd", "skip.mhd", "packed.mhd", "text.mhd", "b.mha", "a.nhdr",
                             "packed.nhdr", "text.nhdr", "b.nrrd", "c.nii"}) {
      const std::vector<std::string> warnings = readImage(f / name).info.warnings;
      QVERIFY2(warnings.size() == 1 &&
                   warnings[0].find("more than the header says") != std::string::npos,
               name);
      QCOMPARE(readNative(f / name).info.warnings, warnings);
      QCOMPARE(readMask(f / name).warnings, warnings);
      // A warning may go into a report, which holds no name of a file.
      QVERIFY(warnings[0].find("d.") == std::string::npos);
    }
    // Where the header says that the voxels are the last bytes, there is nothing to say.
    save(f / "end.mhd", kMeta + s + "HeaderSize = -1\nElementDataFile = d.raw\n");
    QVERIFY(readImage(f / "end.mhd").info.warnings.empty());
  }

  void impossibleClaimsAreRefusedByName_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("file");
    QTest::addColumn<QString>("says");
    const auto row = [](const char* name, const std::string& file, const char* says) {
      QTest::addRow("%s %s", name, says)
          << QString(name) << QByteArray::fromStdString(file) << QString(says);
    };
    const std::string v = ramp<float>();
    const auto metaOf = [&](const std::string& sizes, const std::string& more = {}) {
      return "ObjectType = Image\nNDims = 3\nDimSize = " + sizes +
             "\nElementSpacing = 1 1 1\nElementType = MET_FLOAT\n" + more +
             "ElementDataFile = LOCAL\n" + v;
    };
    const auto nrrdOf = [&](const std::string& sizes, const std::string& encoding) {
      return "NRRD0004\ntype: float\ndimension: 3\nsizes: " + sizes +
             "\nendian: little\nencoding: " + encoding + "\n\n" + v;
    };
    row("v.mha", metaOf("100000 100000 100000"), "100000 100000 100000");
    row("v.mha", metaOf("9000 9000 9000"), "9000 x 9000 x 9000");
    row("v.mha", metaOf("9000 9000 9000", "CompressedData = True\n"), "9000 x 9000 x 9000");
    row("v.mha", metaOf("9000 9000 9000", "BinaryData = False\n"), "9000 x 9000 x 9000");
    row("v.nrrd", nrrdOf("100000 100000 100000", "raw"), "100000 100000 100000");
    for (const char* encoding : {"raw", "gzip", "ascii", "hex"})
      row("v.nrrd", nrrdOf("9000 9000 9000", encoding), "9000 x 9000 x 9000");
    row("v.nrrd", nrrdOf("2 3 4", "bzip2"), "bzip2");
    row("v.nrrd", nrrdOf("2 3 4", "zrl"), "zrl");
    row("v.mha", metaOf("4294967297 4294967297 1"), "DimSize");
  }
  void impossibleClaimsAreRefusedByName() {
    QFETCH(QString, name);
    QFETCH(QByteArray, file);
    QFETCH(QString, says);
    const Folder folder;
    const fs::path path = folder / name.toStdString();
    save(path, file.toStdString());
    const std::string message = messageOf(path);
    QVERIFY2(message.find(says.toStdString()) != std::string::npos, message.c_str());
    QVERIFY(message.find(path.string()) != std::string::npos);
  }

  void numbersThatAreNoneAreRefused() {
    const Folder f;
    const std::string v = ramp<std::int16_t>();
    for (const char* line :
         {"Offset = 1 2", "TransformMatrix = 1 0 0 0 1 0 0 0", "Position = a b c",
          "ElementSize = 1", "Orientation = 1 0 0 0 1 0 0 0 x"}) {
      save(f / "v.mha", meta(std::string("ElementType = MET_SHORT\n") + line, v));
      QVERIFY2(messageOf(f / "v.mha").find("header is not usable") != std::string::npos,
               (line + (": " + messageOf(f / "v.mha"))).c_str());
    }
    // ITK's own parser does not come back from this.
    save(f / "v.mha", bytesOf(fs::path(ANGIOMESH_FUZZ_CORPUS) / "fuzz_image/meta_endless"));
    messageOf(f / "v.mha");
  }

  void aMetaImageLiesWhereItsHeaderSays() {
    const Folder f;
    const std::string values = ramp<std::int16_t>(false, 48);
    const std::string type = "ElementType = MET_SHORT\n";
    save(f / "v.mha", meta(type + "Offset = 4 5.5 -6\nTransformMatrix = 0 1 0 0 0 1 1 0 0",
                           values.substr(0, 48)));
    save(f / "time.mha",
         "ObjectType = Image\nNDims = 4\nDimSize = 2 3 4 2\nElementSpacing = 1 2 3 1\n"
         "Position = 4 5.5 -6 7\nTransformMatrix = 0 1 0 0 0 0 1 0 1 0 0 0 0 0 0 1\n" +
             type + "ElementDataFile = LOCAL\n" + values);
    Eigen::Matrix3d turned;  // the matrix of the file holds an axis in each row
    turned << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    for (const char* name : {"v.mha", "time.mha"}) {
      const std::optional<int> first =
          std::string(name) == "v.mha" ? std::nullopt : std::optional<int>(0);
      const Geometry g = geometryOf(readNative(f / name, {}, first).volume);
      QCOMPARE(g.origin, Eigen::Vector3d(4, 5.5, -6));
      QCOMPARE(g.spacing, Eigen::Vector3d(1, 2, 3));
      QCOMPARE(g.direction, turned);
    }
  }

  void filePatternsAreNoFormatStrings() {
    const Folder f;
    for (const char* pattern : {"%s 1 4 1", "%n%d 1 4 1", "%9999d 1 4 1", "v%d 4 1 1", "v%d 1 4 0",
                                "%d 1", "%d -3 0 1"}) {
      save(f / "v.mhd",
           kMeta + std::string("ElementType = MET_SHORT\nElementDataFile = ") + pattern + "\n");
      QVERIFY2(messageOf(f / "v.mhd").find("pattern") != std::string::npos, pattern);
    }
  }

  void oneOfSeveralValuesCanBeTaken() {
    const Folder f;
    const auto second = [&](const char* name, int component) {
      return std::get<Volume<std::int16_t>>(readNative(f / name, {}, component).volume).voxels[5];
    };
    const std::string values = ramp<std::int16_t>(false, 72);
    save(f / "vector.mha", meta("ElementNumberOfChannels = 3\nElementType = MET_SHORT", values));
    save(f / "time.mha",
         "ObjectType = Image\nNDims = 4\nDimSize = 2 3 4 3\nElementSpacing = 1 2 3 1\n"
         "ElementType = MET_SHORT\nElementDataFile = LOCAL\n" +
             values);
    const std::string t = "NRRD0004\ntype: short\ndimension: 4\nspace: left-posterior-superior\n";
    const std::string e = "endian: little\nencoding: raw\nspace origin: (5,6,7)\n\n";
    save(f / "vector.nrrd", t +
                                "sizes: 3 2 3 4\nkinds: vector domain domain domain\nspace "
                                "directions: none (1,0,0) (0,2,0) (0,0,3)\n" +
                                e + values);
    save(f / "time.nrrd", t +
                              "sizes: 2 3 4 3\nkinds: domain domain domain list\nspace "
                              "directions: (1,0,0) (0,2,0) (0,0,3) none\n" +
                              e + values);
    for (const char* name : {"vector.mha", "time.mha", "vector.nrrd", "time.nrrd"}) {
      const bool vector = std::string(name).starts_with("vector");
      for (int component = 0; component < 3; ++component)
        QCOMPARE(static_cast<int>(second(name, component)),
                 vector ? 5 * 3 + component : 24 * component + 5);
      const Geometry g = geometryOf(readNative(f / name, {}, 1).volume);
      QCOMPARE(g.size, (Index3{2, 3, 4}));
      QCOMPARE(g.spacing, Eigen::Vector3d(1, 2, 3));
      if (std::string(name).ends_with("nrrd")) QCOMPARE(g.origin, Eigen::Vector3d(5, 6, 7));
      QVERIFY_THROWS_EXCEPTION(InputError, readNative(f / name, {}, 3));
      QVERIFY2(messageOf(f / name).find("--component N', N from 0 to 2") != std::string::npos,
               messageOf(f / name).c_str());
    }
  }

  void niftiTakesTheFormThatIsRight() {
    const Folder f;
    Volume<std::int16_t> image;
    image.geometry.size = {2, 3, 4};
    image.geometry.spacing = {1, 2, 3};
    image.geometry.origin = {-10, -20, 30};
    image.voxels = BigVector<std::int16_t>(24, 1);
    image.voxels[3] = 2;
    writeVolume(AnyVolume(image), f / "v.nii");
    std::string whole = bytesOf(f / "v.nii");
    const auto origin = [&](short qCode, short sCode, float sformX, float shear = 0.0F) {
      std::string bytes = whole;
      put(bytes, 252, qCode);
      put(bytes, 254, sCode);
      put(bytes, 292, sformX);
      put(bytes, 284, shear);
      save(f / "v.nii", bytes);
      return readImage(f / "v.nii").image.geometry.origin.x();
    };
    QCOMPARE(origin(1, 1, 10.0F), -10.0);
    QCOMPARE(origin(1, 1, 50.0F), -50.0);  // both: the sform
    QCOMPARE(origin(1, 2, 50.0F), -50.0);  // aligned to something: as nibabel and 3D Slicer
    QCOMPARE(origin(0, 2, 50.0F), -50.0);  // the only one
    QCOMPARE(origin(1, 0, 50.0F), -10.0);
    QCOMPARE(origin(0, 0, 50.0F), 0.0);
    QCOMPARE(readImage(f / "v.nii").info.warnings.size(), std::size_t{1});
    QCOMPARE(origin(1, 1, 50.0F, 0.5F), -10.0);  // a skewed sform
    QCOMPARE(readImage(f / "v.nii").info.warnings.size(), std::size_t{1});
    QVERIFY_THROWS_EXCEPTION(InputError, origin(0, 1, 50.0F, 0.5F));
    put(whole, 112, std::numeric_limits<float>::quiet_NaN());  // no scaling
    QCOMPARE(origin(1, 1, 10.0F), -10.0);
    QCOMPARE(readImage(f / "v.nii").image.voxels[3], 2.0F);
    put(whole, 112, 2.0F);
    put(whole, 116, std::numeric_limits<float>::quiet_NaN());
    QVERIFY_THROWS_EXCEPTION(InputError, origin(1, 1, 10.0F));
    put(whole, 112, 1.0F);
    put(whole, 116, 0.0F);

    std::string metres = whole;
    metres[123] = 1;
    save(f / "v.nii", metres);
    const Geometry g = readImage(f / "v.nii").image.geometry;
    QCOMPARE(g.spacing, Eigen::Vector3d(1000, 2000, 3000));
    QCOMPARE(g.origin, Eigen::Vector3d(-10000, -20000, 30000));

    std::string two = whole;
    put<std::int32_t>(two, 0, 540);
    save(f / "v.nii", two);
    QVERIFY(messageOf(f / "v.nii").find("NIfTI-2") != std::string::npos);
    std::string pair = whole;
    pair[345] = 'i';
    save(f / "v.nii", pair);
    QVERIFY(messageOf(f / "v.nii").find(".hdr/.img") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(TestImageHeaders)
#include "tst_image_headers.moc"
