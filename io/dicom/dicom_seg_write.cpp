// SPDX-License-Identifier: BSD-3-Clause
#include "io/dicom/dicom_seg_write.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <new>
#include <set>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/pipeline/report.h"
#include "io/dicom/dicom_file_header.h"
#include "io/dicom/dicom_uid.h"
#include "io/dicom/slice_orientation.h"
#include "io/file/files.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr double kOnSlice = 0.01;  // of the distance of slices
constexpr double kSameDirection = 1e-3;
constexpr double kSamePlace = 0.1;  // of the pixel spacing

struct Code {
  const char* value;
  const char* scheme;
  const char* meaning;
};
// PS3.16 CID 7150, what kind of thing a segment is; and SNOMED CT's word for it.
constexpr Code kAnatomicalStructure{"91723000", "SCT", "Anatomical Structure"};
constexpr Code kBloodVessel{"59820001", "SCT", "Blood vessel"};
// PS3.16 CID 7203 and CID 7202.
constexpr Code kSegmentation{"113076", "DCM", "Segmentation"};
constexpr Code kSourceImage{"121322", "DCM", "Source image for image processing operation"};

/// The red of vessels: CIELab as PS3.3 C.10.7.1.1 encodes it.
constexpr std::array<Uint16, 3> kVesselColour{33930, 47658, 43041};

void put(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
  item.putAndInsertString(tag, text.c_str());
}

void put(DcmItem& item, const DcmTagKey& tag, int number) {
  item.putAndInsertUint16(tag, static_cast<Uint16>(number));
}

/// A decimal string (DS): as exact as its 16 characters allow.
std::string decimal(double value) {
  for (int digits = 17; digits > 1; --digits)
    if (std::string text = formatted("%.*g", digits, value + 0.0); text.size() <= 16) return text;
  return "0";
}

std::string decimals(const Eigen::Vector3d& v) {
  return decimal(v.x()) + '\\' + decimal(v.y()) + '\\' + decimal(v.z());
}

DcmItem& newItem(DcmItem& in, const DcmTagKey& sequence) {
  DcmItem* item = nullptr;
  constexpr long kAppend = -2;
  if (in.findOrCreateSequenceItem(sequence, item, kAppend).bad()) throw std::bad_alloc();
  return *item;
}

void putCode(DcmItem& in, const DcmTagKey& sequence, const Code& code) {
  DcmItem& item = newItem(in, sequence);
  put(item, DCM_CodeValue, code.value);
  put(item, DCM_CodingSchemeDesignator, code.scheme);
  put(item, DCM_CodeMeaning, code.meaning);
}

/// Empty where it is not there.
void copy(DcmItem& to, const DicomHeader& source, const DcmTagKey& tag) {
  put(to, tag, source.text(tag));
}
void copyIfThere(DcmItem& to, const DicomHeader& source, const DcmTagKey& tag) {
  if (const std::string value = source.text(tag); !value.empty()) put(to, tag, value);
}

void putPatientAndStudy(DcmItem& data, const DicomHeader& source, DicomIdentity identity) {
  if (identity == DicomIdentity::OfSource) {
    copyIfThere(data, source, DCM_SpecificCharacterSet);
    for (const DcmTagKey& tag :
         {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
          DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber,
          DCM_StudyInstanceUID})
      copy(data, source, tag);
    for (const DcmTagKey& tag :
         {DCM_IssuerOfPatientID, DCM_PatientAge, DCM_PatientSize, DCM_PatientWeight,
          DCM_StudyDescription, DCM_PatientIdentityRemoved, DCM_DeidentificationMethod})
      copyIfThere(data, source, tag);
  } else {
    for (const DcmTagKey& tag :
         {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_PatientSex, DCM_StudyDate,
          DCM_StudyTime, DCM_ReferringPhysicianName, DCM_StudyID, DCM_AccessionNumber})
      put(data, tag, std::string());
    put(data, DCM_PatientIdentityRemoved, "YES");
    put(data, DCM_DeidentificationMethod, "Patient and study were not copied");
  }
  OFString study;
  if (data.findAndGetOFString(DCM_StudyInstanceUID, study).bad() || study.empty())
    put(data, DCM_StudyInstanceUID, newDicomUid());
}

void putSeries(DcmItem& data, const DicomHeader& source) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::array<char, 16> date{}, time{};
  std::strftime(date.data(), date.size(), "%Y%m%d", &local);
  std::strftime(time.data(), time.size(), "%H%M%S", &local);
  put(data, DCM_SOPClassUID, UID_SegmentationStorage);
  put(data, DCM_SOPInstanceUID, newDicomUid());
  put(data, DCM_Modality, "SEG");
  put(data, DCM_SeriesInstanceUID, newDicomUid());
  put(data, DCM_SeriesNumber, "900");
  put(data, DCM_SeriesDescription, "Blood vessels");
  put(data, DCM_SeriesDate, date.data());
  put(data, DCM_SeriesTime, time.data());
  put(data, DCM_InstanceNumber, "1");
  put(data, DCM_ContentDate, date.data());
  put(data, DCM_ContentTime, time.data());
  put(data, DCM_ContentLabel, "BLOOD_VESSELS");
  put(data, DCM_ContentDescription, "Blood vessels");
  put(data, DCM_ContentCreatorName, std::string());
  put(data, DCM_Manufacturer, "Angiomesh");
  put(data, DCM_ManufacturerModelName, "Angiomesh");
  put(data, DCM_DeviceSerialNumber, versionText());
  put(data, DCM_SoftwareVersions, versionText());
  const std::string frame = source.text(DCM_FrameOfReferenceUID);
  put(data, DCM_FrameOfReferenceUID, frame.empty() ? newDicomUid() : frame);
  copy(data, source, DCM_PositionReferenceIndicator);
  const bool lossy = source.text(DCM_LossyImageCompression) == "01";
  put(data, DCM_LossyImageCompression, lossy ? "01" : "00");
  if (lossy) {
    copyIfThere(data, source, DCM_LossyImageCompressionRatio);
    copyIfThere(data, source, DCM_LossyImageCompressionMethod);
  }
}

void putPixelDescription(DcmItem& data, const Geometry& g) {
  put(data, DCM_ImageType, "DERIVED\\PRIMARY");
  put(data, DCM_SamplesPerPixel, 1);
  put(data, DCM_PhotometricInterpretation, "MONOCHROME2");
  put(data, DCM_Rows, g.size[1]);
  put(data, DCM_Columns, g.size[0]);
  put(data, DCM_BitsAllocated, 1);
  put(data, DCM_BitsStored, 1);
  put(data, DCM_HighBit, 0);
  put(data, DCM_PixelRepresentation, 0);
  put(data, DCM_NumberOfFrames, std::to_string(g.size[2]));
  put(data, DCM_SegmentationType, "BINARY");
}

void putSegment(DcmItem& data) {
  DcmItem& segment = newItem(data, DCM_SegmentSequence);
  put(segment, DCM_SegmentNumber, 1);
  put(segment, DCM_SegmentLabel, kBloodVessel.meaning);
  put(segment, DCM_SegmentAlgorithmType, "SEMIAUTOMATIC");
  put(segment, DCM_SegmentAlgorithmName, "Angiomesh");
  putCode(segment, DCM_SegmentedPropertyCategoryCodeSequence, kAnatomicalStructure);
  putCode(segment, DCM_SegmentedPropertyTypeCodeSequence, kBloodVessel);
  segment.putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, kVesselColour.data(),
                                  kVesselColour.size());
}

/// By segment, then by place.
void putDimensions(DcmItem& data) {
  const std::string organization = newDicomUid();
  put(newItem(data, DCM_DimensionOrganizationSequence), DCM_DimensionOrganizationUID, organization);
  const auto dimension = [&](const DcmTagKey& index, const DcmTagKey& group, const char* label) {
    DcmItem& item = newItem(data, DCM_DimensionIndexSequence);
    put(item, DCM_DimensionOrganizationUID, organization);
    item.putAndInsertTagKey(DCM_DimensionIndexPointer, index);
    item.putAndInsertTagKey(DCM_FunctionalGroupPointer, group);
    put(item, DCM_DimensionDescriptionLabel, label);
  };
  dimension(DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence, "Segment");
  dimension(DCM_ImagePositionPatient, DCM_PlanePositionSequence, "Position");
}

void putShared(DcmItem& data, const Geometry& g) {
  DcmItem& shared = newItem(data, DCM_SharedFunctionalGroupsSequence);
  DcmItem& measures = newItem(shared, DCM_PixelMeasuresSequence);
  // Between rows, along y, comes first.
  put(measures, DCM_PixelSpacing, decimal(g.spacing.y()) + '\\' + decimal(g.spacing.x()));
  put(measures, DCM_SliceThickness, decimal(g.spacing.z()));
  put(measures, DCM_SpacingBetweenSlices, decimal(g.spacing.z()));
  put(newItem(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
      decimals(g.direction.col(0)) + '\\' + decimals(g.direction.col(1)));
  put(newItem(shared, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber, 1);
}

void putReference(DcmItem& item, const DicomFile& file) {
  put(item, DCM_ReferencedSOPClassUID, file.classUid);
  put(item, DCM_ReferencedSOPInstanceUID, file.instanceUid);
}

/// The frames of the series that a slice at this height is of: the one there, or its neighbours.
std::vector<const DicomFrame*> framesAt(const DicomStack& series, double height, double step) {
  const DicomFrame& first = series.frames.front();
  const DicomFrame *below = nullptr, *above = nullptr;
  double lower = 0.0, upper = 0.0;
  for (const DicomFrame& frame : series.frames) {
    const double off = (frame.position - first.position).dot(sliceNormal(first)) - height;
    if (std::fabs(off) <= kOnSlice * step) return {&frame};
    if (off < 0.0 && (below == nullptr || off > lower)) {
      below = &frame;
      lower = off;
    }
    if (off > 0.0 && (above == nullptr || off < upper)) {
      above = &frame;
      upper = off;
    }
  }
  if (below == nullptr || above == nullptr) return {};
  return {below, above};
}

[[noreturn]] void refuseGrid(const fs::path& path) {
  throw InputError("the mask does not lie on the grid of the DICOM series", path.string(),
                   "give the series that the mask is of");
}

void checkGrid(const Geometry& g, const DicomStack& series, const fs::path& path) {
  if (series.frames.empty() || !series.frames.front().placed) refuseGrid(path);
  const DicomFrame& first = series.frames.front();
  const DicomFile& file = series.fileOf(first);
  const double pixel = std::min(first.spacingX, first.spacingY);
  const Eigen::Vector3d off = g.origin - first.position;
  const Eigen::Vector3d aside = off - off.dot(sliceNormal(first)) * sliceNormal(first);
  const bool same =
      g.size[0] == file.columns && g.size[1] == file.rows &&
      std::fabs(g.spacing.x() - first.spacingX) < 1e-3 * first.spacingX &&
      std::fabs(g.spacing.y() - first.spacingY) < 1e-3 * first.spacingY &&
      (g.direction.col(0) - first.alongRow.stableNormalized()).norm() < kSameDirection &&
      (g.direction.col(1) - first.alongColumn.stableNormalized()).norm() < kSameDirection &&
      (g.direction.col(2) - sliceNormal(first)).norm() < kSameDirection &&
      aside.norm() < kSamePlace * pixel;
  if (!same) refuseGrid(path);
}

void putFrames(DcmItem& data, const Geometry& g, const DicomStack& series, const fs::path& path) {
  const DicomFrame& first = series.frames.front();
  for (int k = 0; k < g.size[2]; ++k) {
    const Eigen::Vector3d place = g.toPhysical({0.0, 0.0, 1.0 * k});
    DcmItem& own = newItem(data, DCM_PerFrameFunctionalGroupsSequence);
    const std::array<Uint32, 2> index{1, static_cast<Uint32>(k + 1)};
    newItem(own, DCM_FrameContentSequence)
        .putAndInsertUint32Array(DCM_DimensionIndexValues, index.data(), index.size());
    put(newItem(own, DCM_PlanePositionSequence), DCM_ImagePositionPatient, decimals(place));
    DcmItem& derivation = newItem(own, DCM_DerivationImageSequence);
    putCode(derivation, DCM_DerivationCodeSequence, kSegmentation);
    const std::vector<const DicomFrame*> frames =
        framesAt(series, (place - first.position).dot(sliceNormal(first)), g.spacing.z());
    if (frames.empty()) refuseGrid(path);
    for (const DicomFrame* frame : frames) {
      const DicomFile& file = series.fileOf(*frame);
      DcmItem& source = newItem(derivation, DCM_SourceImageSequence);
      putReference(source, file);
      if (file.frames > 1 && !file.mosaic)
        put(source, DCM_ReferencedFrameNumber, std::to_string(frame->index + 1));
      putCode(source, DCM_PurposeOfReferenceCodeSequence, kSourceImage);
      put(source, DCM_SpatialLocationsPreserved, "YES");
    }
  }
}

void putInstances(DcmItem& data, const DicomStack& series) {
  DcmItem& of = newItem(data, DCM_ReferencedSeriesSequence);
  put(of, DCM_SeriesInstanceUID, series.uid);
  std::set<std::size_t> files;
  for (const DicomFrame& frame : series.frames) files.insert(frame.file);
  for (const std::size_t file : files)
    putReference(newItem(of, DCM_ReferencedInstanceSequence), series.files[file]);
}

/// One bit for each voxel, the lowest of a byte first; frames follow each other without a gap.
void putBits(DcmItem& data, const Volume<std::uint8_t>& mask) {
  const std::size_t count = mask.voxels.size();
  std::vector<Uint8> bits((count + 15) / 16 * 2);
  for (std::size_t i = 0; i < count; ++i)
    if (mask.voxels[i] != 0) bits[i / 8] = static_cast<Uint8>(bits[i / 8] | (1U << (i % 8)));
  if (bits.size() > 0xfffffffeU ||
      data.putAndInsertUint8Array(DCM_PixelData, bits.data(), bits.size()).bad())
    throw std::bad_alloc();
}

}  // namespace

void writeSegmentation(const Volume<std::uint8_t>& mask, const DicomStack& series,
                       DicomIdentity identity, const fs::path& path) {
  const Geometry& g = mask.geometry;
  checkGrid(g, series, path);
  const DicomHeader source(series.fileOf(series.frames.front()).path);
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  putPatientAndStudy(data, source, identity);
  putSeries(data, source);
  putPixelDescription(data, g);
  putSegment(data);
  putDimensions(data);
  putShared(data, g);
  putFrames(data, g, series, path);
  putInstances(data, series);
  putBits(data, mask);
  writeAtomically(path, [&](const fs::path& temporary) {
    const OFCondition status = format.saveFile(temporary.c_str(), EXS_LittleEndianExplicit);
    if (status.bad())
      throw IoError(std::string("cannot write the file (") + status.text() + ")", path.string(),
                    "choose another place");
  });
}

}  // namespace angiomesh
