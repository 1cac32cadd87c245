// SPDX-License-Identifier: BSD-3-Clause
// DICOM that archives, research programs and other objects than scanners' images bring along.
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>

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
