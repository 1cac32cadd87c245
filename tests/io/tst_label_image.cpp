// SPDX-License-Identifier: BSD-3-Clause
#include "io/label_image.h"

#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "io/image_io.h"
#include "tests/io/io_test.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

Geometry grid() {
  Geometry g;
  g.size = {5, 4, 3};
  return g;
}

/// 10 voxels of label `a`, 5 of label `b`, the rest 0.
template <class T>
Volume<T> labels(T a, T b) {
  Volume<T> volume(grid());
  for (std::size_t i = 0; i < 10; ++i) volume.voxels[i] = a;
  for (std::size_t i = 30; i < 35; ++i) volume.voxels[i] = b;
  return volume;
}

std::size_t count(const Volume<std::uint8_t>& mask) {
  std::size_t n = 0;
  for (const std::uint8_t voxel : mask.voxels) n += voxel;
  return n;
}

/// As 3D Slicer writes it: segments by name, those that overlap in layers of their own.
std::string segNrrd(int layers) {
  std::string text = "NRRD0004\ntype: unsigned char\ndimension: ";
  text +=
      layers > 1
          ? "4\nspace: left-posterior-superior\nsizes: 2 5 4 3\nkinds: list domain domain domain\n"
            "space directions: none (1,0,0) (0,1,0) (0,0,1)\n"
          : "3\nspace: left-posterior-superior\nsizes: 5 4 3\nkinds: domain domain domain\n"
            "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
  text +=
      "encoding: raw\nspace origin: (1,2,3)\n"
      "Segment0_ID:=Segment_1\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
      "Segment0_Name:=artery\nSegment1_LabelValue:=";
  text += layers > 1 ? "1\nSegment1_Layer:=1\n" : "2\nSegment1_Layer:=0\n";
  text += "Segment1_Name:=left vein: upper\n\n";
  for (int i = 0; i < 60; ++i) {
    const bool artery = i < 10, vein = i >= 30 && i < 35;
    if (layers > 1)
      text += {artery ? '\1' : '\0', vein ? '\1' : '\0'};
    else
      text += artery ? '\1' : vein ? '\2' : '\0';
  }
  return text;
}

std::string messageOf(const fs::path& path, const std::string& choice = {}) {
  try {
    readLabel(path, choice);
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

}  // namespace

class TestLabelImage : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void labelsAreCountedInAnyType() {
    const Folder f;
    for (const AnyVolume& volume :
         {AnyVolume(labels<std::uint8_t>(7, 255)), AnyVolume(labels<std::uint16_t>(7, 255)),
          AnyVolume(labels<std::int32_t>(7, 255)), AnyVolume(labels<std::int64_t>(7, 255)),
          AnyVolume(labels<float>(7, 255)), AnyVolume(labels<double>(7, 255))}) {
      writeVolume(volume, f / "l.nii.gz");
      const std::vector<Label> found = readLabels(f / "l.nii.gz");
      QCOMPARE(found.size(), std::size_t{2});
      QCOMPARE(found[0].value, std::int64_t{7});
      QCOMPARE(found[0].voxels, std::size_t{10});
      QCOMPARE(found[1].value, std::int64_t{255});
      QCOMPARE(found[1].voxels, std::size_t{5});
    }
  }

  void aSegmentationIsToldFromAScan() {
    const Folder f;
    const fs::path path = f / "x.mha";  // for the names of segments alone
    writeVolume(AnyVolume(labels<std::uint8_t>(1, 2)), path);
    Geometry g;
    g.size = {16, 16, 16};
    Volume<float> scan(g), masked(g), mask(g), many(g);
    std::uint32_t noise = 1;
    for (int k = 0; k < 16; ++k)
      for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 16; ++i) {
          noise = noise * 1664525U + 1013904223U;
          const float grey = static_cast<float>(20 + (noise >> 27U));
          const bool inside = std::hypot(i - 8.0, j - 8.0, k - 8.0) < 6.0;
          scan.at(i, j, k) = grey;
          masked.at(i, j, k) = inside ? grey : 0.0F;
          mask.at(i, j, k) = inside ? 2.0F : 0.0F;
          many.at(i, j, k) = static_cast<float>(1 + i / 4 + 4 * (j / 4));
        }
    QVERIFY(labelsOfSegmentation(path, scan).empty());
    QVERIFY(labelsOfSegmentation(path, masked).empty());
    QCOMPARE(labelsOfSegmentation(path, mask).size(), std::size_t{1});
    // Blocks of four: of 15 neighbours along a row 12 are alike.
    QVERIFY(labelsOfSegmentation(path, many).empty());
    for (float& value : many.voxels) value = value > 8.0F ? 2.0F : value > 4.0F ? 1.0F : 0.0F;
    QCOMPARE(labelsOfSegmentation(path, many).size(), std::size_t{2});
    mask.voxels[5] = -1.0F;
    QVERIFY(labelsOfSegmentation(path, mask).empty());
    mask.voxels[5] = 0.5F;
    QVERIFY(labelsOfSegmentation(path, mask).empty());
    // A line across the rows has no neighbours along them.
    Volume<float> line(g);
    for (int k = 0; k < 16; ++k) line.at(4, 5, k) = 3.0F;
    QCOMPARE(labelsOfSegmentation(path, line).at(0).voxels, std::size_t{16});
  }

  void realScansAreNotTakenForSegmentations() {
    const QString data = qEnvironmentVariable("ANGIOMESH_DATA");
    if (data.isEmpty()) QSKIP("ANGIOMESH_DATA is not set");
    for (const char* file : {"aorta-mra/aorta.mha", "avf-mra/avf_float_32.nrrd",
                             "brain-tof-crop/mra.mha", "brain-tof-masked/mra.nii.gz"}) {
      const fs::path path = fs::path(data.toStdString()) / file;
      QVERIFY2(labelsOfSegmentation(path, readImage(path).image).empty(), file);
    }
  }

  void oneLabelNeedsNoChoice() {
    const Folder f;
    writeVolume(AnyVolume(labels<std::uint16_t>(3, 0)), f / "l.mha");
    const LabelMask mask = readLabel(f / "l.mha", {});
    QVERIFY(mask.onlyOne);
    QCOMPARE(mask.label.value, std::int64_t{3});
    QCOMPARE(count(mask.mask), std::size_t{10});
  }

  void severalLabelsAreListed() {
    const Folder f;
    writeVolume(AnyVolume(labels<std::uint16_t>(3, 800)), f / "l.mha");
    const std::string message = messageOf(f / "l.mha");
    QVERIFY2(message.find("3 (10 voxels), 800 (5 voxels)") != std::string::npos, message.c_str());
    QVERIFY(message.find("--label") != std::string::npos);
    QCOMPARE(count(readLabel(f / "l.mha", "800").mask), std::size_t{5});
    QVERIFY(!readLabel(f / "l.mha", "3").onlyOne);
    QVERIFY(messageOf(f / "l.mha", "4").find("800 (5 voxels)") != std::string::npos);
  }

  void segmentsOfSlicerHaveNames_data() {
    QTest::addColumn<int>("layers");
    QTest::newRow("one layer") << 1;
    QTest::newRow("two layers") << 2;
  }
  void segmentsOfSlicerHaveNames() {
    QFETCH(int, layers);
    const Folder f;
    const fs::path path = f / "s.seg.nrrd";
    save(path, segNrrd(layers));
    const std::vector<Label> found = readLabels(path);
    QCOMPARE(found.size(), std::size_t{2});
    QCOMPARE(found[0].name, std::string("artery"));
    QCOMPARE(found[1].name, std::string("left vein: upper"));
    const LabelMask vein = readLabel(path, "left vein: upper");
    QCOMPARE(count(vein.mask), std::size_t{5});
    QCOMPARE(vein.mask.voxels[30], std::uint8_t{1});
    QCOMPARE(vein.mask.geometry.origin, Eigen::Vector3d(1, 2, 3));
    QCOMPARE(count(readLabel(path, "artery").mask), std::size_t{10});
    if (layers == 1) QCOMPARE(count(readLabel(path, "2").mask), std::size_t{5});
    if (layers > 1) QVERIFY(messageOf(path, "1").find("layers") != std::string::npos);
    QCOMPARE(describeImages(path).at(0).geometry.size, grid().size);
  }

  void whatIsNoLabelImageIsRefused() {
    const Folder f;
    writeVolume(AnyVolume(labels<std::int16_t>(-3, 2)), f / "v.mha");
    QVERIFY(messageOf(f / "v.mha").find("negative") != std::string::npos);
    writeVolume(AnyVolume(labels<float>(0.5F, 2.0F)), f / "v.mha");
    QVERIFY(!messageOf(f / "v.mha").empty());
    writeVolume(AnyVolume(labels<std::uint8_t>(0, 0)), f / "v.mha");
    QVERIFY(!messageOf(f / "v.mha").empty());
    Volume<std::uint16_t> scan;
    scan.geometry.size = {30, 30, 30};
    for (std::size_t i = 0; i < 27000; ++i) scan.voxels.push_back(static_cast<std::uint16_t>(i));
    writeVolume(AnyVolume(scan), f / "v.mha");
    QVERIFY(!messageOf(f / "v.mha").empty());
  }
};

QTEST_APPLESS_MAIN(TestLabelImage)
#include "tst_label_image.moc"
