// SPDX-License-Identifier: BSD-3-Clause
// DICOM that archives, research programs and other objects than scanners' images bring along.
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

#include "io/scan/label_image.h"
#include "tests/io/jpeg2000_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// Writes the pixels of a file again as Float or Double Float Pixel Data, each value halved.
template <class Number>
void makeReal(const fs::path& path, double nothing) {
  DcmFileFormat format;
  QVERIFY(format.loadFile(path.c_str()).good());
  DcmDataset& data = *format.getDataset();
  const Uint16* words = nullptr;
  unsigned long count = 0;
  QVERIFY(data.findAndGetUint16Array(DCM_PixelData, words, &count).good());
  std::vector<Number> numbers(words, words + count);
  for (Number& number : numbers) number /= 2;
  numbers[3] = static_cast<Number>(nothing);
  constexpr bool single = sizeof(Number) == 4;
  data.findAndDeleteElement(DCM_PixelData);
  data.putAndInsertUint16(DCM_BitsAllocated, single ? 32 : 64);
  if constexpr (single) {
    data.putAndInsertFloat32(DCM_FloatPixelPaddingValue, static_cast<Float32>(nothing));
    data.insert(new DcmOtherFloat(DCM_FloatPixelData), true);
    DcmElement* element = nullptr;
    data.findAndGetElement(DCM_FloatPixelData, element);
    element->putFloat32Array(numbers.data(), count);
  } else {
    data.putAndInsertFloat64(DCM_DoubleFloatPixelPaddingValue, nothing);
    data.insert(new DcmOtherDouble(DCM_DoubleFloatPixelData), true);
    DcmElement* element = nullptr;
    data.findAndGetElement(DCM_DoubleFloatPixelData, element);
    element->putFloat64Array(numbers.data(), count);
  }
  QVERIFY(format.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
}

/// Cuts each compressed frame of a file into three fragments, the first of 70 bytes.
void cutFragments(const fs::path& path, bool withTable) {
  DcmFileFormat format;
  QVERIFY(format.loadFile(path.c_str()).good() && format.loadAllDataIntoMemory().good());
  DcmDataset& data = *format.getDataset();
  const E_TransferSyntax syntax = data.getOriginalXfer();
  DcmElement* element = nullptr;
  data.findAndGetElement(DCM_PixelData, element);
  DcmPixelSequence* whole = nullptr;
  QVERIFY(dynamic_cast<DcmPixelData*>(element)
              ->getEncapsulatedRepresentation(syntax, nullptr, whole)
              .good());
  auto* cut = new DcmPixelSequence(DCM_PixelSequenceTag);
  auto* table = new DcmPixelItem(DCM_PixelItemTag);
  cut->insert(table);
  std::vector<Uint32> offsets;
  Uint32 at = 0;
  for (unsigned long i = 1; i < whole->card(); ++i) {
    DcmPixelItem* item = nullptr;
    whole->getItem(item, i);
    Uint8* bytes = nullptr;
    item->getUint8Array(bytes);
    const std::vector<Uint8> all(bytes, bytes + item->getLength());
    offsets.push_back(at);
    const std::size_t half = 70 + (all.size() - 70) / 4 * 2;
    for (const auto& [from, to] :
         {std::pair<std::size_t, std::size_t>{0, 70}, {70, half}, {half, all.size()}}) {
      auto* part = new DcmPixelItem(DCM_PixelItemTag);
      part->putUint8Array(all.data() + from, static_cast<unsigned long>(to - from));
      cut->insert(part);
      at += static_cast<Uint32>(8 + to - from);
    }
  }
  if (withTable)
    table->putUint8Array(reinterpret_cast<const Uint8*>(offsets.data()),
                         static_cast<unsigned long>(4 * offsets.size()));
  auto* pixels = new DcmPixelData(DCM_PixelData);
  pixels->putOriginalRepresentation(syntax, nullptr, cut);
  data.insert(pixels, true);
  QVERIFY(format.saveFile(path.c_str(), syntax).good());
}

/// Of one frame: which segment and which of ten slices.
struct SegFrame {
  int segment = 1, slice = 0;
};

/// Whether a voxel of 9 x 7 x 10 belongs to a segment: blocks that do not touch; of `overlap`, the
/// second one lies over the first.
bool isInside(int segment, int i, int j, int k, bool overlap) {
  if (segment == 1) return i < 4 && j < 5 && k >= 2 && k < 6;
  return i >= (overlap ? 2 : 5) && j > 1 && (k == 5 || k == 7);
}

/// A DICOM segmentation of two segments without the frames in which they have no voxels.
void saveSegmentation(const fs::path& path, bool fractional, bool overlap = false,
                      double missing = 0.0) {
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  putCommon(data, sliceAt(0), UID_SegmentationStorage);
  putText(data, DCM_Modality, "SEG");
  putText(data, DCM_SegmentationType, fractional ? "FRACTIONAL" : "BINARY");
  const Uint16 bits = fractional ? 8 : 1;
  data.putAndInsertUint16(DCM_BitsAllocated, bits);
  data.putAndInsertUint16(DCM_BitsStored, bits);
  data.putAndInsertUint16(DCM_HighBit, static_cast<Uint16>(bits - 1));
  if (fractional) data.putAndInsertUint16(DCM_MaximumFractionalValue, 200);
  DcmItem* item = nullptr;
  for (const char* name : {"artery", "vein"}) {
    data.findOrCreateSequenceItem(DCM_SegmentSequence, item, -2);
    item->putAndInsertUint16(DCM_SegmentNumber, name == std::string("artery") ? 1 : 2);
    putText(*item, DCM_SegmentLabel, name);
  }
  putText(*putSharedGroups(data), DCM_SpacingBetweenSlices, std::to_string(kSpacingZ));
  const std::vector<SegFrame> frames{{2, 7}, {1, 2}, {1, 4}, {1, 3}, {2, 5}, {1, 5}};
  std::vector<Uint8> bytes(fractional ? frames.size() * 63 : (frames.size() * 63 + 15) / 16 * 2, 0);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    DcmItem* frame = nullptr;
    data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, -2);
    frame->findOrCreateSequenceItem(DCM_PlanePositionSequence, item, -2);
    const double slice = frames[f].slice == 4 ? 4 + missing : frames[f].slice;
    putText(*item, DCM_ImagePositionPatient,
            numbers(kOrigin + oblique().col(2) * (kSpacingZ * slice)));
    frame->findOrCreateSequenceItem(DCM_SegmentIdentificationSequence, item, -2);
    item->putAndInsertUint16(DCM_ReferencedSegmentNumber, static_cast<Uint16>(frames[f].segment));
    for (std::size_t p = 0; p < 63; ++p) {
      const int i = static_cast<int>(p % 9), j = static_cast<int>(p / 9);
      const bool inside = isInside(frames[f].segment, i, j, frames[f].slice, overlap);
      const std::size_t n = f * 63 + p;
      if (fractional)
        bytes[n] = inside ? 160 : 60;
      else if (inside)
        bytes[n / 8] = static_cast<Uint8>(bytes[n / 8] | 1U << (n % 8));
    }
  }
  putText(data, DCM_NumberOfFrames, std::to_string(frames.size()));
  if (fractional && bytes.size() % 2 != 0) bytes.push_back(0);
  data.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
  QVERIFY(format.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
}

/// Voxels of a mask on the grid of slices 2 to 7 that are not as they should be.
int wrongVoxels(const LabelMask& read, int segment, bool overlap) {
  const Geometry& g = read.mask.geometry;
  if (g.size != Index3{9, 7, 6}) return -1;
  if ((g.origin - (kOrigin + oblique().col(2) * (2 * kSpacingZ))).norm() > 1e-6) return -2;
  if ((g.spacing - Eigen::Vector3d(kSpacingX, kSpacingY, kSpacingZ)).norm() > 1e-6) return -3;
  int wrong = 0;
  for (int k = 0; k < 6; ++k)
    for (int j = 0; j < 7; ++j)
      for (int i = 0; i < 9; ++i)
        wrong += (read.mask.at(i, j, k) != 0) == isInside(segment, i, j, k + 2, overlap) ? 0 : 1;
  return wrong;
}

}  // namespace

class TestDicomOdd : public QObject {
  Q_OBJECT

  Encoders encoders_;

 private Q_SLOTS:
  void framesOfReferenceOfSingleSlicesSayNothing_data() {
    QTest::addColumn<QStringList>("references");
    QTest::addColumn<bool>("said");
    QTest::newRow("one") << QStringList{"a", "a", "a", "a", "a", "a"} << false;
    QTest::newRow("none") << QStringList{"", "", "", "", "", ""} << false;
    QTest::newRow("each its own") << QStringList{"a", "b", "c", "d", "e", "f"} << true;
    QTest::newRow("missing once") << QStringList{"a", "a", "", "a", "a", "a"} << true;
    QTest::newRow("missing often") << QStringList{"a", "", "", "a", "", "a"} << true;
    QTest::newRow("another once") << QStringList{"a", "a", "a", "a", "b", "a"} << true;
  }
  void framesOfReferenceOfSingleSlicesSayNothing() {
    QFETCH(QStringList, references);
    QFETCH(bool, said);
    const Folder folder;
    saveSeries(folder.path(), [&](Slice& slice) {
      const QString reference = references[slice.k];
      slice.edit = [reference](DcmDataset& data) {
        if (!reference.isEmpty())
          putText(data, DCM_FrameOfReferenceUID, "1.2." + std::to_string(reference[0].unicode()));
      };
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image, plain);
    QCOMPARE(findingOf(loaded.info.findings, FindingKind::MixedReference) != nullptr, said);
  }

  void twoFramesOfReferenceAreTwoVolumes() {
    const Folder folder;
    saveSeries(folder.path(), [&](Slice& slice) {
      const char* reference = slice.k < 3 ? "1.2.7" : "1.2.8";
      slice.edit = [=](DcmDataset& data) { putText(data, DCM_FrameOfReferenceUID, reference); };
      return true;
    });
    QCOMPARE(describeImages(folder.path()).size(), std::size_t{2});
  }

  void oneInstanceUidForAllIsReadByPosition() {
    const Folder folder;
    saveSeries(folder.path(), [&](Slice& slice) {
      slice.instance = "1.2.3";
      return true;
    });
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    verifyVoxels(loaded.image, plain);
    const Finding* finding = findingOf(loaded.info.findings, FindingKind::RepeatedUid);
    QVERIFY(finding != nullptr);
    QVERIFY(finding->text.starts_with("5 images"));
    // One that really is there twice is used once all the same.
    fs::copy_file(folder / "5.dcm", folder / "copy.dcm");
    const LoadedImage again = readImage(folder.path());
    verifyVoxels(again.image, plain);
    QVERIFY(findingOf(again.info.findings, FindingKind::RepeatedFile) != nullptr);
  }

  void floatPixelDataIsRead_data() {
    QTest::addColumn<bool>("single");
    QTest::newRow("32 bits") << true;
    QTest::newRow("64 bits") << false;
  }
  void floatPixelDataIsRead() {
    QFETCH(bool, single);
    const Folder folder;
    saveSeries(folder.path());
    for (const auto& entry : fs::directory_iterator(folder.path()))
      single ? makeReal<Float32>(entry.path(), -9999.5) : makeReal<Float64>(entry.path(), -9999.5);
    const LoadedImage loaded = readImage(folder.path());
    verifyGeometry(loaded.image.geometry);
    QCOMPARE(loaded.info.pixelType, std::string(single ? "float32" : "float64"));
    QCOMPARE(loaded.image.at(5, 4, 3), 0.5F * static_cast<float>(storedValue(5, 4, 3)));
    QVERIFY(loaded.image.at(3, 0, 3) >= 0.0F);  // padding
    QVERIFY(findingOf(loaded.info.findings, FindingKind::PaddedValues) != nullptr);
    const std::string whole = bytesOf(folder / "5.dcm");
    save(folder / "5.dcm", whole.substr(0, whole.size() - 40));
    QVERIFY(refusal(folder.path()).startsWith("Io: "));
  }

  void framesMayBeCutIntoFragments_data() {
    QTest::addColumn<bool>("rle");
    QTest::addColumn<bool>("table");
    QTest::newRow("RLE") << true << false;
    QTest::newRow("RLE with a table") << true << true;
    QTest::newRow("JPEG 2000") << false << false;
    QTest::newRow("JPEG 2000 with a table") << false << true;
  }
  void framesMayBeCutIntoFragments() {
    QFETCH(bool, rle);
    QFETCH(bool, table);
    const E_TransferSyntax syntax = rle ? EXS_RLELossless : EXS_LittleEndianExplicit;
    const Folder single, several;
    saveSeries(single.path(), {}, syntax);
    saveEnhanced(several / "e", {4, 1, 0, 5, 3, 2}, true, syntax);
    for (const Folder* folder : {&single, &several})
      for (const auto& entry : fs::directory_iterator(folder->path())) {
        if (!rle) toJpeg2000(entry.path());
        cutFragments(entry.path(), table);
      }
    verifyVoxels(readImage(single.path()).image, plain);
    verifyVoxels(readImage(several.path()).image,
                 [](int stored, int) { return static_cast<float>(0.5 * stored - 7.0); });
  }

  void segmentationsAreLabels_data() {
    QTest::addColumn<bool>("fractional");
    QTest::addColumn<bool>("overlap");
    QTest::newRow("binary") << false << false;
    QTest::newRow("binary, overlapping") << false << true;
    QTest::newRow("fractional") << true << false;
  }
  void segmentationsAreLabels() {
    QFETCH(bool, fractional);
    QFETCH(bool, overlap);
    const Folder folder;
    const fs::path path = folder / "seg.dcm";
    saveSegmentation(path, fractional, overlap);
    const std::vector<Label> labels = readLabels(path);
    QCOMPARE(labels.size(), std::size_t{2});
    QCOMPARE(labels[1].name, std::string("vein"));
    QCOMPARE(labels[1].value, std::int64_t{2});
    QCOMPARE(labels[0].voxels, std::size_t{80});
    QCOMPARE(wrongVoxels(readLabel(path, {"artery", {}}), 1, overlap), 0);
    QCOMPARE(wrongVoxels(readLabel(path, {"2", {}}), 2, overlap), 0);
    QCOMPARE(wrongVoxels(readLabel(path, {"name:vein", 0.5}), 2, overlap), 0);
    if (fractional)  // 0.3 outside
      QVERIFY(readLabel(path, {"artery", 0.25}).labels[0].voxels > 80);
    QCOMPARE(describeImages(path).at(0).geometry.size, (Index3{9, 7, 6}));
    const QString all = messageOf([&] {
      const NativeImage image = readNative(path);
      QCOMPARE(std::get<Volume<std::uint16_t>>(image.volume).at(8, 6, 5), std::uint16_t{2});
    });
    QVERIFY2(all.contains(fractional ? "fractional" : overlap ? "overlap" : ""), qPrintable(all));
    QCOMPARE(all.isEmpty(), !fractional && !overlap);
    QCOMPARE(geometryOf(readNative(path, {}, 1).volume).size, (Index3{9, 7, 6}));
    QVERIFY_THROWS_EXCEPTION(InputError, readNative(path, {}, 2));
  }

  void segmentationsThatFormNoGridAreRefused() {
    const Folder folder;
    saveSegmentation(folder / "seg.dcm", false, false, 0.3);
    QVERIFY(messageOf([&] { readLabels(folder / "seg.dcm"); }).contains("uneven distances"));
    const std::string whole = bytesOf(folder / "seg.dcm");
    save(folder / "seg.dcm", whole.substr(0, whole.size() - 20));
    QVERIFY(!messageOf([&] { readLabels(folder / "seg.dcm"); }).isEmpty());
  }

  void aSegmentationStandsInNobodysWay() {
    const Folder folder;
    saveSeries(folder.path());
    fs::create_directory(folder / "seg");
    saveSegmentation(folder / "seg/s.dcm", false);
    // The writer gives it the same series, as no scanner does.
    DcmFileFormat format;
    QVERIFY(format.loadFile((folder / "seg/s.dcm").c_str()).good());
    QVERIFY(format.loadAllDataIntoMemory().good());
    putText(*format.getDataset(), DCM_SeriesInstanceUID, "1.2.3.4.9");
    QVERIFY(format.saveFile((folder / "seg/s.dcm").c_str(), EXS_LittleEndianExplicit).good());
    verifyVoxels(readImage(folder.path()).image, plain);
    QVERIFY(refusal(folder / "seg").contains("a DICOM segmentation (SEG) of 2 segments"));
  }

  void objectsWithoutImagesSayWhatTheyAre() {
    const Folder folder;
    const auto saying = [&](const char* kind) {
      DcmFileFormat format;
      putText(*format.getDataset(), DCM_SOPClassUID, kind);
      putText(*format.getDataset(), DCM_SOPInstanceUID, "1.2.3");
      if (!format.saveFile((folder / "x").c_str(), EXS_LittleEndianExplicit).good())
        return QString();
      return refusal(folder / "x");
    };
    QVERIFY2(saying(UID_MediaStorageDirectoryStorage).contains("give the folder that it lies in"),
             qPrintable(saying(UID_MediaStorageDirectoryStorage)));
    QVERIFY(saying(UID_EncapsulatedPDFStorage).contains("EncapsulatedPDFStorage"));
    QVERIFY(saying(UID_BasicTextSRStorage).contains("SR"));
  }
};

QTEST_APPLESS_MAIN(TestDicomOdd)
#include "tst_dicom_odd.moc"
