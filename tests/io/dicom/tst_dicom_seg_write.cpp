// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "io/scan/label_image.h"
#include "io/scan/mask_file.h"
#include "tests/io/dicom_writer.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

constexpr const char* kFrameOfReference = "1.2.3.4.77";
constexpr const char* kStudy = "1.2.3.4.88";

/// A series that says of which patient, study and frame of reference it is.
void saveKnownSeries(const fs::path& folder) {
  saveSeries(
      folder,
      [](Slice& slice) {
        slice.edit = [](DcmDataset& data) {
          putText(data, DCM_FrameOfReferenceUID, kFrameOfReference);
          putText(data, DCM_StudyInstanceUID, kStudy);
          putText(data, DCM_StudyDate, "20200131");
          putText(data, DCM_StudyDescription, "head of Jane");
        };
        return true;
      },
      EXS_LittleEndianExplicit, "a");
}

/// Some voxels of the grid, no two slices alike, some with none.
Volume<std::uint8_t> maskOn(const Geometry& grid) {
  Volume<std::uint8_t> mask(grid);
  for (int k = 1; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) mask.at(i, j, k) = (i * k + j) % 3 == 0 ? 1 : 0;
  return mask;
}

/// A segmentation as it was written.
struct Written {
  explicit Written(const fs::path& path) {
    const bool good = format.loadFile(path.c_str()).good();
    QVERIFY(good);
  }
  std::string text(const DcmTagKey& tag) {
    OFString value;
    if (format.getDataset()->findAndGetOFStringArray(tag, value).bad()) return "absent";
    return value.c_str();
  }
  /// All values of an element, wherever it stands.
  std::multiset<std::string> everywhere(const DcmTagKey& tag) {
    std::multiset<std::string> all;
    DcmStack stack;
    bool more = format.getDataset()->search(tag, stack, ESM_fromHere, OFTrue).good();
    while (more) {
      OFString value;
      static_cast<DcmElement*>(stack.top())->getOFStringArray(value);
      all.insert(value.c_str());
      more = format.getDataset()->search(tag, stack, ESM_afterStackTop, OFTrue).good();
    }
    return all;
  }

  DcmFileFormat format;
};

}  // namespace

class TestDicomSegWrite : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsWrittenReadsBack() {
    const Folder folder;
    fs::create_directory(folder / "scan");
    saveKnownSeries(folder / "scan");
    const Volume<std::uint8_t> mask = maskOn(readImage(folder / "scan").image.geometry);
    writeMask(mask, {folder / "scan", {}, DicomIdentity::None}, folder / "seg.dcm");
    const MaskImage back = readMask(folder / "seg.dcm");
    verifyGeometry(back.mask.geometry);
    QVERIFY(back.mask.voxels == mask.voxels);
    QVERIFY(back.warnings.empty());
    const std::vector<Label> labels = readLabels(folder / "seg.dcm");
    QCOMPARE(labels.size(), std::size_t{1});
    QCOMPARE(labels[0].name, std::string("Blood vessel"));
    // Beside the scan it stands in nobody's way.
    fs::copy(folder / "seg.dcm", folder / "scan/seg.dcm");
    verifyVoxels(readImage(folder / "scan").image, plain);
  }

  void itRefersToTheImagesItIsOf() {
    const Folder folder;
    fs::create_directory(folder / "scan");
    saveKnownSeries(folder / "scan");
    writeMask(maskOn(readImage(folder / "scan").image.geometry),
              {folder / "scan", "1000001", DicomIdentity::None}, folder / "seg.dcm");
    Written seg(folder / "seg.dcm");
    QCOMPARE(seg.text(DCM_SOPClassUID), std::string(UID_SegmentationStorage));
    QCOMPARE(seg.text(DCM_FrameOfReferenceUID), std::string(kFrameOfReference));
    QCOMPARE(seg.text(DCM_SegmentationType), std::string("BINARY"));
    QCOMPARE(seg.text(DCM_NumberOfFrames), std::to_string(kSlices));
    const auto codes = seg.everywhere(DCM_CodeValue);
    for (const char* code : {"91723000", "59820001"}) QCOMPARE(codes.count(code), std::size_t{1});
    // Each image once among those referred to, and once with the frame that is of it.
    const auto images = seg.everywhere(DCM_ReferencedSOPInstanceUID);
    QCOMPARE(images.size(), std::size_t{2 * kSlices});
    for (int k = 0; k < kSlices; ++k) QCOMPARE(images.count(sliceAt(k).instance), std::size_t{2});
    QCOMPARE(seg.everywhere(DCM_ReferencedSOPClassUID).count(UID_MRImageStorage),
             std::size_t{2 * kSlices});
    QCOMPARE(seg.everywhere(DCM_SeriesInstanceUID).count("1.2.3.4.1000001"), std::size_t{1});
    DcmItem *frame = nullptr, *place = nullptr, *derived = nullptr, *source = nullptr;
    constexpr int kFrame = 4;
    QVERIFY(seg.format.getDataset()
                ->findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, kFrame)
                .good());
    QVERIFY(frame->findAndGetSequenceItem(DCM_PlanePositionSequence, place).good());
    QVERIFY(frame->findAndGetSequenceItem(DCM_DerivationImageSequence, derived).good());
    QVERIFY(derived->findAndGetSequenceItem(DCM_SourceImageSequence, source).good());
    Eigen::Vector3d at;
    for (unsigned long a = 0; a < 3; ++a)
      place->findAndGetFloat64(DCM_ImagePositionPatient, at[static_cast<int>(a)], a);
    QVERIFY((at - sliceAt(kFrame).position).norm() < 1e-6);
    OFString of;
    source->findAndGetOFString(DCM_ReferencedSOPInstanceUID, of);
    QCOMPARE(std::string(of.c_str()), sliceAt(kFrame).instance);
  }

  void identityIsCopiedWhereItIsAskedForAlone() {
    const Folder folder;
    fs::create_directory(folder / "scan");
    saveKnownSeries(folder / "scan");
    const Volume<std::uint8_t> mask = maskOn(readImage(folder / "scan").image.geometry);
    writeMask(mask, {folder / "scan", {}, DicomIdentity::None}, folder / "none.dcm");
    writeMask(mask, {folder / "scan", {}, DicomIdentity::OfSource}, folder / "of.dcm");
    Written none(folder / "none.dcm"), of(folder / "of.dcm");
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate,
                                 DCM_PatientSex, DCM_StudyDate, DCM_AccessionNumber})
      QCOMPARE(none.text(tag), std::string());
    const std::string bytes = bytesOf(folder / "none.dcm");
    for (const char* told : {"Doe^Jane", "4711", "19700101", "20200131", kStudy, "head of Jane"})
      QVERIFY2(bytes.find(told) == std::string::npos, told);
    QCOMPARE(of.text(DCM_PatientName), std::string("Doe^Jane"));
    QCOMPARE(of.text(DCM_PatientID), std::string("4711"));
    QCOMPARE(of.text(DCM_PatientBirthDate), std::string("19700101"));
    QCOMPARE(of.text(DCM_StudyInstanceUID), std::string(kStudy));
    QCOMPARE(of.text(DCM_StudyDescription), std::string("head of Jane"));
    QVERIFY(none.text(DCM_StudyInstanceUID).starts_with("2.25."));
    for (const DcmTagKey& tag : {DCM_SOPInstanceUID, DCM_SeriesInstanceUID})
      QVERIFY(none.text(tag) != of.text(tag) && of.text(tag).starts_with("2.25.") &&
              of.text(tag).size() <= 64);
  }

  void ofMultiFrameObjectsItNamesTheFrames() {
    const Folder folder;
    saveEnhanced(folder / "scan.dcm", {3, 0, 5, 1, 4, 2});
    const Volume<std::uint8_t> mask = maskOn(readImage(folder / "scan.dcm").image.geometry);
    writeMask(mask, {folder / "scan.dcm", {}, DicomIdentity::None}, folder / "seg.dcm");
    QVERIFY(readMask(folder / "seg.dcm").mask.voxels == mask.voxels);
    Written seg(folder / "seg.dcm");
    DcmItem* frame = nullptr;
    QVERIFY(seg.format.getDataset()
                ->findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, 1)
                .good());
    OFString number;
    QVERIFY(frame->findAndGetOFString(DCM_ReferencedFrameNumber, number, 0, OFTrue).good());
    QCOMPARE(std::string(number.c_str()), std::string("4"));
  }

  void masksOfAnotherGridAreRefused() {
    const Folder folder;
    fs::create_directory(folder / "scan");
    saveKnownSeries(folder / "scan");
    const Geometry right = readImage(folder / "scan").image.geometry;
    const auto says = [&](const Geometry& grid) {
      return messageOf([&] {
        writeMask(maskOn(grid), {folder / "scan", {}, DicomIdentity::None}, folder / "seg.dcm");
      });
    };
    Geometry wrong = right;
    wrong.size[0] += 1;
    QVERIFY(says(wrong).contains("does not lie on the grid"));
    wrong = right;
    wrong.origin += 0.5 * right.direction.col(0);
    QVERIFY(says(wrong).contains("does not lie on the grid"));
    wrong = right;
    wrong.size[2] += 1;
    QVERIFY(says(wrong).contains("does not lie on the grid"));
    wrong = right;
    wrong.direction.col(0) = right.direction.col(1);
    wrong.direction.col(1) = right.direction.col(0);
    QVERIFY(says(wrong).contains("does not lie on the grid"));
    QVERIFY(!fs::exists(folder / "seg.dcm"));
  }
};

QTEST_GUILESS_MAIN(TestDicomSegWrite)
#include "tst_dicom_seg_write.moc"
