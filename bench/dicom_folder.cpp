// SPDX-License-Identifier: BSD-3-Clause
#include "bench/dicom_folder.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cstdint>
#include <stdexcept>
#include <string>

namespace angiomesh::bench {
namespace {

namespace fs = std::filesystem;

const char* const kSeries = "1.2.826.0.1.3680043.2.1125.1";

/// What describes the slice: some fifty elements and a private block of 12 kB, as scanners add.
void describe(DcmDataset& data, int slice) {
  const auto text = [&](const DcmTagKey& tag, const std::string& value) {
    data.putAndInsertString(tag, value.c_str());
  };
  text(DCM_SOPClassUID, UID_MRImageStorage);
  text(DCM_SOPInstanceUID, std::string(kSeries) + ".2." + std::to_string(slice + 1));
  text(DCM_StudyInstanceUID, std::string(kSeries) + ".0");
  text(DCM_SeriesInstanceUID, kSeries);
  text(DCM_FrameOfReferenceUID, std::string(kSeries) + ".3");
  text(DCM_ImageType, "ORIGINAL\\PRIMARY\\M\\ND");
  text(DCM_Modality, "MR");
  text(DCM_SeriesDescription, "tof 3d");
  text(DCM_SeriesNumber, "5");
  text(DCM_InstanceNumber, std::to_string(slice + 1));
  text(DCM_AcquisitionNumber, "1");
  text(DCM_ImagePositionPatient, "-100\\-120\\" + std::to_string(0.8 * slice));
  text(DCM_ImageOrientationPatient, "1\\0\\0\\0\\1\\0");
  text(DCM_PixelSpacing, "0.5\\0.5");
  text(DCM_SliceThickness, "0.8");
  text(DCM_WindowCenter, "300");
  text(DCM_WindowWidth, "600");
  const DcmTagKey others[] = {DCM_Manufacturer,     DCM_ManufacturerModelName,
                              DCM_StationName,      DCM_ProtocolName,
                              DCM_ScanningSequence, DCM_SequenceVariant,
                              DCM_ScanOptions,      DCM_MRAcquisitionType,
                              DCM_SequenceName,     DCM_RepetitionTime,
                              DCM_EchoTime,         DCM_NumberOfAverages,
                              DCM_ImagingFrequency, DCM_ImagedNucleus,
                              DCM_EchoNumbers,      DCM_MagneticFieldStrength,
                              DCM_FlipAngle,        DCM_SAR};
  for (const DcmTagKey& tag : others) text(tag, "1");
  text(DcmTag(0x0029, 0x0010, EVR_LO), "MAKER HEADER");
  const std::vector<Uint8> block(12000, 7);
  data.putAndInsertUint8Array(DcmTag(0x0029, 0x1010, EVR_OB), block.data(), block.size());
}

}  // namespace

std::vector<fs::path> writeDicomFolder(const fs::path& folder, int columns, int rows, int slices) {
  fs::create_directories(folder);
  std::vector<fs::path> files;
  std::vector<Uint16> pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  std::uint32_t noise = 1;
  for (int slice = 0; slice < slices; ++slice) {
    DcmFileFormat format;
    DcmDataset& data = *format.getDataset();
    describe(data, slice);
    data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
    data.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2");
    data.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(columns));
    data.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(rows));
    data.putAndInsertUint16(DCM_BitsAllocated, 16);
    data.putAndInsertUint16(DCM_BitsStored, 12);
    data.putAndInsertUint16(DCM_HighBit, 11);
    data.putAndInsertUint16(DCM_PixelRepresentation, 0);
    for (Uint16& pixel : pixels) {
      noise = noise * 1664525U + 1013904223U;
      pixel = static_cast<Uint16>(noise >> 22U);
    }
    data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
    // Multiplied by a number without a common factor, so that neighbours lie far apart.
    const fs::path file = folder / ("IM" + std::to_string(10000 + slice * 7919L % 10007));
    if (format.saveFile(file.c_str(), EXS_LittleEndianExplicit).bad())
      throw std::runtime_error("cannot write " + file.string());
    files.push_back(file);
  }
  return files;
}

}  // namespace angiomesh::bench
