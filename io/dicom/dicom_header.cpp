// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <system_error>

#include "io/dicom/dicom_nesting.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/dicom_source.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

// The most that a file of some bytes can hold: a compressed pixel takes a part of a bit only.
constexpr double kLargestExpansion = 4096.0;

// What is longer is no text that is read here. DCMTK leaves it in the file, and makes room for
// whatever length it states once it is asked for.
constexpr std::uint32_t kLongestText = 1024;

bool isReadable(DcmItem& item, const DcmTagKey& tag) {
  DcmElement* element = nullptr;
  return item.findAndGetElement(tag, element).good() && element != nullptr &&
         element->getLengthField() <= kLongestText;
}

/// DCMTK sets the output of its find functions to 0 when the element is missing.
std::optional<double> number(DcmItem& item, const DcmTagKey& tag, unsigned long index = 0) {
  Float64 value = 0.0;
  if (!isReadable(item, tag)) return std::nullopt;
  if (item.findAndGetFloat64(tag, value, index).good()) return value;
  Float32 single = 0.0F;
  if (item.findAndGetFloat32(tag, single, index).bad()) return std::nullopt;
  return static_cast<double>(single);
}

/// Printable ASCII only: descriptions come in many character sets.
std::string text(DcmItem& item, const DcmTagKey& tag) {
  OFString value;
  if (!isReadable(item, tag) || item.findAndGetOFStringArray(tag, value).bad()) return {};
  std::string clean;
  for (const char c : value) clean += c >= ' ' && c < 127 ? c : '?';
  while (!clean.empty() && clean.back() == ' ') clean.pop_back();
  clean.erase(0, clean.find_first_not_of(' '));
  return clean;
}

int integer(DcmItem& item, const DcmTagKey& tag, int otherwise) {
  // IS elements are text, US elements are not: both have a text form.
  const std::string value = text(item, tag);
  return value.empty() ? otherwise : std::atoi(value.c_str());
}

/// A number that takes two bytes in a file that is not damaged.
int word(DcmItem& item, const DcmTagKey& tag, int otherwise) {
  return std::clamp(integer(item, tag, otherwise), 0, 65535);
}

/// The first item of a sequence, or null.
DcmItem* itemOf(DcmItem* item, const DcmTagKey& sequence) {
  DcmItem* found = nullptr;
  if (item == nullptr || item->findAndGetSequenceItem(sequence, found, 0).bad()) return nullptr;
  return found;
}

bool vectorOf(DcmItem& item, const DcmTagKey& tag, unsigned long first, Eigen::Vector3d& result) {
  for (unsigned long a = 0; a < 3; ++a) {
    const auto value = number(item, tag, first + a);
    if (!value) return false;
    result[static_cast<Eigen::Index>(a)] = *value;
  }
  return result.allFinite();
}

std::vector<DisplayWindow> windowsOf(DcmItem& item) {
  std::vector<DisplayWindow> windows;
  const std::string function = text(item, DCM_VOILUTFunction);
  for (unsigned long i = 0; i < 32; ++i) {
    const auto width = number(item, DCM_WindowWidth, i);
    const auto level = number(item, DCM_WindowCenter, i);
    if (!width || !level) break;
    if (!(*width > 0.0)) continue;
    DisplayWindow window{*width, *level, function.empty() ? "LINEAR" : function, {}};
    OFString name;
    if (isReadable(item, DCM_WindowCenterWidthExplanation) &&
        item.findAndGetOFString(DCM_WindowCenterWidthExplanation, name, i).good())
      for (const char c : name) window.name += c >= ' ' && c < 127 ? c : '?';
    windows.push_back(std::move(window));
  }
  return windows;
}

/// The items in which an attribute of a frame may stand: the frame's own ones before the shared
/// ones before the file itself, which holds all of them in a classic object.
struct Places {
  DcmItem* file;
  DcmItem* shared = nullptr;
  DcmItem* own = nullptr;

  [[nodiscard]] bool classic() const { return shared == nullptr && own == nullptr; }
  [[nodiscard]] DcmItem* macro(const DcmTagKey& sequence) const {
    if (classic()) return file;
    DcmItem* item = itemOf(own, sequence);
    return item != nullptr ? item : itemOf(shared, sequence);
  }
  [[nodiscard]] std::string textOf(const DcmTagKey& sequence, const DcmTagKey& tag) const {
    DcmItem* item = macro(sequence);
    return item != nullptr ? text(*item, tag) : std::string();
  }
};

void readSplit(const Places& from, DicomFrame& frame) {
  auto& split = frame.split;
  DcmItem& file = *from.file;
  if (from.classic()) {
    const DcmTagKey tags[] = {DCM_TemporalPositionIdentifier,
                              DCM_EchoTime,
                              DCM_EchoNumbers,
                              DCM_DiffusionBValue,
                              DCM_ImageType,
                              DCM_StackID,
                              DCM_NominalPercentageOfCardiacPhase,
                              DCM_TriggerTime,
                              DCM_DiffusionGradientOrientation,
                              DCM_AcquisitionNumber,
                              DCM_AcquisitionTime,
                              DCM_ContentTime};
    for (std::size_t i = 0; i < split.size(); ++i) split[i] = text(file, tags[i]);
    return;
  }
  const DcmTagKey content = DCM_FrameContentSequence;
  split[0] = from.textOf(content, DCM_TemporalPositionIndex);
  split[1] = from.textOf(DCM_MREchoSequence, DCM_EffectiveEchoTime);
  split[3] = from.textOf(DCM_MRDiffusionSequence, DCM_DiffusionBValue);
  split[4] = from.textOf(DCM_MRImageFrameTypeSequence, DCM_FrameType);
  if (split[4].empty()) split[4] = from.textOf(DCM_CTImageFrameTypeSequence, DCM_FrameType);
  split[5] = from.textOf(content, DCM_StackID);
  split[6] = from.textOf(DCM_CardiacSynchronizationSequence, DCM_NominalPercentageOfCardiacPhase);
  split[7] = from.textOf(DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime);
  if (DcmItem* diffusion = from.macro(DCM_MRDiffusionSequence); diffusion != nullptr)
    if (DcmItem* gradient = itemOf(diffusion, DCM_DiffusionGradientDirectionSequence);
        gradient != nullptr)
      split[8] = text(*gradient, DCM_DiffusionGradientOrientation);
  split[9] = from.textOf(content, DCM_FrameAcquisitionNumber);
  split[10] = from.textOf(content, DCM_FrameAcquisitionDateTime);
  split[11] = from.textOf(content, DCM_FrameReferenceDateTime);
}

DicomFrame readFrameOf(const Places& from) {
  DicomFrame frame;
  DcmItem* position = from.macro(DCM_PlanePositionSequence);
  DcmItem* orientation = from.macro(DCM_PlaneOrientationSequence);
  DcmItem* measures = from.macro(DCM_PixelMeasuresSequence);
  frame.placed = position != nullptr && orientation != nullptr && measures != nullptr &&
                 vectorOf(*position, DCM_ImagePositionPatient, 0, frame.position) &&
                 vectorOf(*orientation, DCM_ImageOrientationPatient, 0, frame.alongRow) &&
                 vectorOf(*orientation, DCM_ImageOrientationPatient, 3, frame.alongColumn);
  if (frame.placed) {
    // Row spacing (between rows, along y) comes first.
    const auto y = number(*measures, DCM_PixelSpacing, 0);
    const auto x = number(*measures, DCM_PixelSpacing, 1);
    frame.placed = x && y && *x > 0.0 && *y > 0.0 && *x < 1e6 && *y < 1e6;
    frame.spacingX = x.value_or(1.0);
    frame.spacingY = y.value_or(1.0);
  }
  if (measures != nullptr)
    frame.stepMm = number(*measures, DCM_SpacingBetweenSlices)
                       .value_or(number(*measures, DCM_SliceThickness).value_or(0.0));
  if (DcmItem* segment = from.macro(DCM_SegmentIdentificationSequence))
    frame.segment = integer(*segment, DCM_ReferencedSegmentNumber, 0);
  if (DcmItem* transform = from.macro(DCM_PixelValueTransformationSequence)) {
    frame.slope = number(*transform, DCM_RescaleSlope).value_or(1.0);
    frame.intercept = number(*transform, DCM_RescaleIntercept).value_or(0.0);
  }
  if (DcmItem* window = from.macro(DCM_FrameVOILUTSequence)) frame.windows = windowsOf(*window);
  frame.instanceNumber = integer(*from.file, DCM_InstanceNumber, 0);
  frame.frameOfReference = text(*from.file, DCM_FrameOfReferenceUID);
  readSplit(from, frame);
  return frame;
}

PixelLayout layoutOf(DcmDataset& data) {
  PixelLayout layout;
  layout.allocated = word(data, DCM_BitsAllocated, 16);
  layout.stored = word(data, DCM_BitsStored, layout.allocated);
  if (layout.stored < 1 || layout.stored > layout.allocated) layout.stored = layout.allocated;
  layout.high = word(data, DCM_HighBit, layout.stored - 1);
  if (layout.high + 1 < layout.stored || layout.high >= layout.allocated)
    layout.high = layout.stored - 1;
  layout.isSigned = word(data, DCM_PixelRepresentation, 0) == 1;
  const E_TransferSyntax syntax = data.getOriginalXfer();
  layout.bigEndian = syntax == EXS_BigEndianExplicit;
  layout.encapsulated = DcmXfer(syntax).isEncapsulated();
  layout.rle = syntax == EXS_RLELossless;
  layout.jpeg2000 = syntax == EXS_JPEG2000 || syntax == EXS_JPEG2000LosslessOnly ||
                    syntax == EXS_JPEG2000Multicomponent ||
                    syntax == EXS_JPEG2000MulticomponentLosslessOnly;
  layout.real = !data.tagExists(DCM_PixelData) &&
                (data.tagExists(DCM_FloatPixelData) || data.tagExists(DCM_DoubleFloatPixelData));
  if (layout.real) {
    layout.allocated = data.tagExists(DCM_FloatPixelData) ? 32 : 64;
    const bool single = layout.allocated == 32;
    const auto from =
        number(data, single ? DCM_FloatPixelPaddingValue : DCM_DoubleFloatPixelPaddingValue);
    const auto to = number(
        data, single ? DCM_FloatPixelPaddingRangeLimit : DCM_DoubleFloatPixelPaddingRangeLimit);
    if (from)
      layout.padding = {std::min(*from, to.value_or(*from)), std::max(*from, to.value_or(*from))};
    return layout;
  }
  const std::string padding = text(data, DCM_PixelPaddingValue);
  if (!padding.empty()) {
    // Writers do not agree on whether it is signed: taken as the pixels are.
    const auto asPixels = [&](const std::string& value) {
      const int number = std::atoi(value.c_str());
      return layout.isSigned ? static_cast<int>(static_cast<std::int16_t>(number))
                             : static_cast<int>(static_cast<std::uint16_t>(number));
    };
    const int from = asPixels(padding);
    const std::string limit = text(data, DCM_PixelPaddingRangeLimit);
    const int to = limit.empty() ? from : asPixels(limit);
    layout.padding = {static_cast<double>(std::min(from, to)),
                      static_cast<double>(std::max(from, to))};
  }
  return layout;
}

DicomFile fileOf(DcmDataset& data, const fs::path& path) {
  DicomFile file;
  file.path = path;
  file.columns = word(data, DCM_Columns, 0);
  file.rows = word(data, DCM_Rows, 0);
  file.samples = word(data, DCM_SamplesPerPixel, 1);
  file.classUid = text(data, DCM_SOPClassUID);
  file.instanceUid = text(data, DCM_SOPInstanceUID);
  file.frames = std::max(integer(data, DCM_NumberOfFrames, 1), 1);
  file.mosaic = text(data, DCM_ImageType).find("MOSAIC") != std::string::npos;
  file.inverted = text(data, DCM_PhotometricInterpretation) == "MONOCHROME1";
  file.table = itemOf(&data, DCM_ModalityLUTSequence) != nullptr;
  file.layout = layoutOf(data);
  return file;
}

/// What is wrong when the file cannot hold what its header states; empty when it can. Asked before
/// anything is allocated for the pixels.
std::string sizeDamage(const DicomFile& file) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file.path, error);
  const auto has = static_cast<double>(error ? 0 : bytes);
  const double each = std::max(file.layout.allocated, 1) / 8.0 * std::max(file.samples, 1);
  const double wanted = static_cast<double>(file.pixels()) * each * file.frames;
  const bool packed = file.layout.encapsulated || file.layout.deflated;
  if (wanted <= (packed ? has * kLargestExpansion : has) && file.frames <= has) return {};
  return "the DICOM file is truncated: its header states " + std::to_string(file.columns) + " x " +
         std::to_string(file.rows) + " pixels" +
         (file.frames > 1 ? " in " + std::to_string(file.frames) + " frames" : std::string()) +
         ", which " + std::to_string(bytes) + " bytes cannot hold";
}

void addFrames(DcmDataset& data, const DicomFile& file, DicomSeries& series) {
  const std::size_t number = series.files.size();
  DcmItem* shared = itemOf(&data, DCM_SharedFunctionalGroupsSequence);
  DcmSequenceOfItems* perFrame = nullptr;
  data.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, perFrame);
  if (perFrame == nullptr && (shared == nullptr || file.frames == 1)) {
    DicomFrame frame = readFrameOf({&data, nullptr, nullptr});
    // A multi-frame object without functional groups does not say where its frames lie.
    frame.placed = frame.placed && file.frames == 1;
    frame.file = number;
    series.frames.push_back(std::move(frame));
    return;
  }
  for (int f = 0; f < file.frames; ++f) {
    const auto f1 = static_cast<unsigned long>(f);
    DcmItem* own = perFrame != nullptr && f1 < perFrame->card() ? perFrame->getItem(f1) : nullptr;
    if (own == nullptr && f > 0) {
      // One frame that lies nowhere tells as much as all of them.
      DicomFrame frame;
      frame.file = number;
      frame.index = f;
      series.frames.push_back(std::move(frame));
      return;
    }
    DcmItem empty;
    DicomFrame frame = readFrameOf({&data, shared, own != nullptr ? own : &empty});
    frame.file = number;
    frame.index = f;
    series.frames.push_back(std::move(frame));
  }
}

/// Of a segmentation (PS3.3 C.8.20); nothing of another object.
void readSegmentsOf(DcmDataset& data, DicomSeries& series) {
  if (text(data, DCM_SOPClassUID) != UID_SegmentationStorage) return;
  constexpr unsigned long kMostSegments = 4096;
  for (unsigned long n = 0; n < kMostSegments; ++n) {
    DcmItem* item = nullptr;
    if (data.findAndGetSequenceItem(DCM_SegmentSequence, item, static_cast<long>(n)).bad()) break;
    series.segments.push_back({word(*item, DCM_SegmentNumber, static_cast<int>(n) + 1),
                               text(*item, DCM_SegmentLabel).substr(0, 64)});
  }
  if (series.segments.empty()) series.segments.push_back({1, {}});
  if (text(data, DCM_SegmentationType) == "FRACTIONAL")
    series.mostFraction = std::max(word(data, DCM_MaximumFractionalValue, 255), 1);
}

std::string dateOf(DcmItem& data) {
  for (const DcmTagKey& tag : {DCM_AcquisitionDate, DCM_SeriesDate, DCM_StudyDate}) {
    std::string date = text(data, tag);
    const bool digits = date.size() == 8 && std::all_of(date.begin(), date.end(), [](char c) {
                          return c >= '0' && c <= '9';
                        });
    if (digits) return date.substr(0, 4) + '-' + date.substr(4, 2) + '-' + date.substr(6);
  }
  return {};
}

}  // namespace

HeaderResult readDicomHeader(const fs::path& path, DicomSeries& series) {
  const char* const kTooDeep = "the DICOM header nests sequences more than a hundred deep";
  if (nestsTooDeeply(path)) return {false, kTooDeep, false, {}};
  const DicomSource source(path);
  if (source.inflated() && nestsTooDeeply(source.path())) return {false, kTooDeep, false, {}};
  DcmFileFormat format;
  const OFCondition status =
      format.loadFileUntilTag(source.path().c_str(), EXS_Unknown, EGL_noChange, kLongestText,
                              ERM_autoDetect, DCM_PixelData);
  checkOpened(path, status);
  DcmDataset& data = *format.getDataset();
  series.uid = text(data, DCM_SeriesInstanceUID);
  series.description = text(data, DCM_SeriesDescription);
  series.modality = text(data, DCM_Modality);
  series.number = text(data, DCM_SeriesNumber);
  series.date = dateOf(data);
  DcmElement* last = data.card() > 0 ? data.getElement(data.card() - 1) : nullptr;
  const bool known = last != nullptr && DcmTagKey(DCM_SeriesInstanceUID) < last->getTag();
  if (status.bad())
    return {false, std::string("the DICOM header is damaged (") + status.text() + ")", known, {}};
  DicomFile file = fileOf(data, path);
  file.layout.deflated = source.inflated();
  if (file.columns < 1 || file.rows < 1) {
    // An image whose header ends before it states its size was cut off between two elements.
    const std::string kind = text(*format.getMetaInfo(), DCM_MediaStorageSOPClassUID);
    if (dcmIsImageStorageSOPClassUID(kind.c_str()))
      return {false, "the DICOM file is truncated", known, {}};
    const char* const name = dcmFindNameOfUID(kind.c_str());
    return {false, {}, known, name != nullptr ? name : ""};
  }
  if (std::string damage = sizeDamage(file); !damage.empty())
    return {false, std::move(damage), known, {}};
  readSegmentsOf(data, series);
  addFrames(data, file, series);
  series.files.push_back(std::move(file));
  return {true, {}, known, {}};
}

}  // namespace angiomesh
