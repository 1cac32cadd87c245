// SPDX-License-Identifier: BSD-3-Clause
#include "io/scan/label_image.h"

#include <QTest>
#include <cmath>

#include "core/base/error.h"
#include "io/scan/image_io.h"
#include "io/volume/image_write.h"
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
    readLabel(path, {choice, {}});
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
    QCOMPARE(mask.labels.at(0).value, std::int64_t{3});
    QCOMPARE(count(mask.mask), std::size_t{10});
  }

  void severalLabelsAreListed() {
    const Folder f;
    writeVolume(AnyVolume(labels<std::uint16_t>(3, 800)), f / "l.mha");
    const std::string message = messageOf(f / "l.mha");
    QVERIFY2(message.find("3 (10 voxels), 800 (5 voxels)") != std::string::npos, message.c_str());
    QVERIFY(message.find("--label") != std::string::npos);
    QCOMPARE(count(readLabel(f / "l.mha", {"800", {}}).mask), std::size_t{5});
    QVERIFY(!readLabel(f / "l.mha", {"3", {}}).onlyOne);
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
    const LabelMask vein = readLabel(path, {"left vein: upper", {}});
    QCOMPARE(count(vein.mask), std::size_t{5});
    QCOMPARE(vein.mask.voxels[30], std::uint8_t{1});
    QCOMPARE(vein.mask.geometry.origin, Eigen::Vector3d(1, 2, 3));
    QCOMPARE(count(readLabel(path, {"artery", {}}).mask), std::size_t{10});
    if (layers == 1) QCOMPARE(count(readLabel(path, {"2", {}}).mask), std::size_t{5});
    if (layers > 1)
      QVERIFY(messageOf(path, "1").find("several labels fit '1'") != std::string::npos);
    QCOMPARE(describeImages(path).at(0).geometry.size, grid().size);
  }

  void labelsAreJoined() {
    const Folder f;
    writeVolume(AnyVolume(labels<std::uint16_t>(3, 800)), f / "l.mha");
    const LabelMask both = readLabel(f / "l.mha", {"3, 800", {}});
    QCOMPARE(count(both.mask), std::size_t{15});
    QCOMPARE(both.labels.size(), std::size_t{2});
    QCOMPARE(count(readLabel(f / "l.mha", {"value:800,3,3", {}}).mask), std::size_t{15});
    QVERIFY(messageOf(f / "l.mha", "3,4").find("no label '4'") != std::string::npos);
    for (const int layers : {1, 2}) {
      save(f / "s.seg.nrrd", segNrrd(layers));
      const LabelMask joined = readLabel(f / "s.seg.nrrd", {"artery,name:left vein: upper", {}});
      QCOMPARE(count(joined.mask), std::size_t{15});
      QCOMPARE(joined.mask.voxels[30], std::uint8_t{1});
    }
  }

  void whatFitsSeveralSegmentsIsSaid() {
    const Folder f;
    const fs::path path = f / "s.seg.nrrd";
    const auto named = [&](const std::string& second) {
      std::string text = segNrrd(1);
      const std::string old = "Segment1_Name:=left vein: upper";
      text.replace(text.find(old), old.size(), "Segment1_ID:=Segment_2\nSegment1_Name:=" + second);
      save(path, text);
    };
    named("artery");
    const std::string message = messageOf(path, "artery");
    QVERIFY2(message.find("several labels fit 'artery'") != std::string::npos, message.c_str());
    QVERIFY2(message.find("id:Segment_2") != std::string::npos, message.c_str());
    QVERIFY(messageOf(path, "name:artery").find("several labels") != std::string::npos);
    QCOMPARE(count(readLabel(path, {"value:2", {}}).mask), std::size_t{5});
    QCOMPARE(count(readLabel(path, {"id:Segment_2", {}}).mask), std::size_t{5});
    QCOMPARE(count(readLabel(path, {"1,2", {}}).mask), std::size_t{15});
    named("1");
    QVERIFY(messageOf(path, "1").find("name:1 or value:1") != std::string::npos);
    QCOMPARE(count(readLabel(path, {"value:1", {}}).mask), std::size_t{10});
    QCOMPARE(count(readLabel(path, {"name:1", {}}).mask), std::size_t{5});
    named("a,b");
    QCOMPARE(count(readLabel(path, {"a,b", {}}).mask), std::size_t{5});
  }

  void nothingNamesNoLabel() {
    const Folder f;
    const fs::path path = f / "s.seg.nrrd";
    std::string text = segNrrd(1);
    const std::string old = "Segment1_Name:=left vein: upper";
    text.replace(text.find(old), old.size(), "Other:=x");
    save(path, text);
    QCOMPARE(count(readLabel(path, {"artery,2", {}}).mask), std::size_t{15});
    for (const char* choice : {"artery,,1", ",", " ", "name:", "id:", "artery,name:"})
      QVERIFY2(messageOf(path, choice).find("there is no label '") != std::string::npos, choice);
  }

  void masksOfOtherProgramsAreRounded_data() {
    QTest::addColumn<double>("outside");
    QTest::addColumn<double>("inside");
    QTest::addColumn<double>("other");
    QTest::addColumn<int>("voxels");
    QTest::addColumn<QString>("warning");
    const double nan = std::nan("");
    QTest::newRow("whole") << 0.0 << 1.0 << 1.0 << 15 << "";
    QTest::newRow("nibabel") << 0.0 << 1.00000006 << 1.00000006 << 15 << "were rounded";
    QTest::newRow("resampled") << 0.012 << 0.988 << 1.02 << 15 << "up to 0.02";
    QTest::newRow("softmax") << 0.1 << 0.6 << 0.4 << 10 << "voxels of 0.5 and more";
    QTest::newRow("overshoot") << -0.08 << 1.1 << 0.5 << 15 << "between -0.08 and 1.1";
    QTest::newRow("NaN") << 0.0 << 1.0 << nan << 10 << "5 voxels are not a number";
  }
  void masksOfOtherProgramsAreRounded() {
    QFETCH(double, outside);
    QFETCH(double, inside);
    QFETCH(double, other);
    QFETCH(int, voxels);
    QFETCH(QString, warning);
    const Folder f;
    Volume<double> mask(grid());
    for (std::size_t i = 0; i < 60; ++i)
      mask.voxels[i] = i < 10 ? inside : i >= 30 && i < 35 ? other : outside;
    writeVolume(AnyVolume(mask), f / "m.mha");
    const LabelMask label = readLabel(f / "m.mha", {});
    QCOMPARE(static_cast<int>(count(label.mask)), voxels);
    QVERIFY(label.onlyOne);
    const MaskImage truth = readMask(f / "m.mha");
    QVERIFY(truth.mask.voxels == label.mask.voxels);
    QCOMPARE(truth.warnings, label.warnings);
    QCOMPARE(label.warnings.empty(), warning.isEmpty());
    if (!warning.isEmpty())
      QVERIFY2(QString::fromStdString(label.warnings[0]).contains(warning),
               label.warnings[0].c_str());
    // Above what any has, at what one has.
    QVERIFY(QString(messageOf([&] { readLabel(f / "m.mha", {"", 2.0}); })).contains("threshold"));
    QCOMPARE(static_cast<int>(count(readMask(f / "m.mha", inside).mask)),
             other >= inside ? 15 : 10);
    QCOMPARE(static_cast<int>(count(readLabel(f / "m.mha", {"", 0.55}).mask)),
             other >= 0.55 ? 15 : 10);
  }

  void severalLabelsAreRounded() {
    const Folder f;
    writeVolume(AnyVolume(labels<float>(7.0000005F, 3.98F)), f / "l.mha");
    QCOMPARE(count(readLabel(f / "l.mha", {"7", {}}).mask), std::size_t{10});
    QCOMPARE(count(readLabel(f / "l.mha", {"4", {}}).mask), std::size_t{5});
    const Folder g;
    writeVolume(AnyVolume(labels<std::uint8_t>(7, 255)), g / "l.nii");
    std::string bytes = bytesOf(g / "l.nii");
    put(bytes, 112, 1.0F / 255.0F);  // as nibabel scales 0..1 to uint8
    save(g / "l.nii", bytes);
    QCOMPARE(count(readLabel(g / "l.nii", {}).mask), std::size_t{5});
    QCOMPARE(count(readLabel(g / "l.nii", {"", 0.01}).mask), std::size_t{15});
    QVERIFY_THROWS_EXCEPTION(InputError, readLabel(g / "l.nii", {"1", 0.5}));
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
