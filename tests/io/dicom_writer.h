// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>

#include <Eigen/Geometry>
#include <QTest>
#include <cmath>
#include <cstdio>
#include <functional>

#include "core/base/error.h"
#include "io/scan/image_io.h"
#include "tests/io/io_test.h"

namespace angiomesh::test {

constexpr int kColumns = 9;
constexpr int kRows = 7;
constexpr int kSlices = 6;
constexpr double kSpacingX = 0.4;
constexpr double kSpacingY = 0.6;
constexpr double kSpacingZ = 1.3;

/// The stored value of a voxel: 12 bit, no two slices alike.
inline int storedValue(int i, int j, int k) {
  return (i * 5 + j * 71 + k * 503 + i * j * k) % 4096;
}

/// Direction of an oblique acquisition: columns are along the row, along the column, the normal.
inline Eigen::Matrix3d oblique() {
  return (Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()) *
          Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitX()))
      .toRotationMatrix();
}
inline const Eigen::Vector3d kOrigin(-31.5, 12.25, 87.125);

struct Slice {
  int k = 0;  ///< of the voxels
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d direction = oblique();
  int columns = kColumns, rows = kRows;
  double slope = 1.0, intercept = 0.0;
  bool rescaled = false;
  bool isSigned = false;
  std::string series = "1.2.3.4.1000001";
  std::string description = "tof";
  std::string instance;
  std::function<void(DcmDataset&)> edit;  ///< of the header, before the pixels come
  std::function<Uint16(int)> encode;      ///< a value to the word that is stored
};

inline Slice sliceAt(int k) {
  Slice slice;
  slice.k = k;
  slice.position = kOrigin + oblique().col(2) * (kSpacingZ * k);
  slice.instance = "1.2.3.4.5." + std::to_string(k + 1);
  return slice;
}

inline std::string numbers(const Eigen::Vector3d& v) {
  char text[100];
  std::snprintf(text, sizeof(text), "%.9g\\%.9g\\%.9g", v.x(), v.y(), v.z());
  return text;
}

inline void putText(DcmItem& item, const DcmTagKey& tag, const std::string& text) {
  item.putAndInsertString(tag, text.c_str());
}

inline void putCommon(DcmDataset& data, const Slice& slice, const char* sopClass) {
  putText(data, DCM_SOPClassUID, sopClass);
  putText(data, DCM_SOPInstanceUID, slice.instance);
  putText(data, DCM_PatientName, "Doe^Jane");
  putText(data, DCM_PatientID, "4711");
  putText(data, DCM_PatientBirthDate, "19700101");
  putText(data, DCM_Modality, "MR");
  putText(data, DCM_SeriesInstanceUID, slice.series);
  putText(data, DCM_SeriesDescription, slice.description);
  data.putAndInsertUint16(DCM_Rows, static_cast<Uint16>(slice.rows));
  data.putAndInsertUint16(DCM_Columns, static_cast<Uint16>(slice.columns));
  data.putAndInsertUint16(DCM_SamplesPerPixel, 1);
  putText(data, DCM_PhotometricInterpretation, "MONOCHROME2");
  data.putAndInsertUint16(DCM_BitsAllocated, 16);
  data.putAndInsertUint16(DCM_BitsStored, slice.isSigned ? 16 : 12);
  data.putAndInsertUint16(DCM_HighBit, slice.isSigned ? 15 : 11);
  data.putAndInsertUint16(DCM_PixelRepresentation, slice.isSigned ? 1 : 0);
}

inline void appendPixels(const Slice& slice, std::vector<Uint16>& pixels) {
  for (int j = 0; j < slice.rows; ++j)
    for (int i = 0; i < slice.columns; ++i) {
      const int value = storedValue(i, j, slice.k) - (slice.isSigned ? 2000 : 0);
      pixels.push_back(slice.encode ? slice.encode(value) : static_cast<Uint16>(value));
    }
}

inline void saveSlice(const Slice& slice, const fs::path& path,
                      E_TransferSyntax syntax = EXS_LittleEndianExplicit) {
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  putCommon(data, slice, UID_MRImageStorage);
  putText(data, DCM_ImagePositionPatient, numbers(slice.position));
  putText(data, DCM_ImageOrientationPatient,
          numbers(slice.direction.col(0)) + "\\" + numbers(slice.direction.col(1)));
  putText(data, DCM_PixelSpacing, std::to_string(kSpacingY) + "\\" + std::to_string(kSpacingX));
  putText(data, DCM_WindowCenter, "300\\40");
  putText(data, DCM_WindowWidth, "600\\400");
  if (slice.rescaled) {
    putText(data, DCM_RescaleSlope, std::to_string(slice.slope));
    putText(data, DCM_RescaleIntercept, std::to_string(slice.intercept));
  }
  std::vector<Uint16> pixels;
  appendPixels(slice, pixels);
  if (slice.edit) slice.edit(data);
  Uint16 allocated = 16;
  data.findAndGetUint16(DCM_BitsAllocated, allocated);
  if (allocated == 8) {
    std::vector<Uint8> bytes(pixels.begin(), pixels.end());
    data.putAndInsertUint8Array(DCM_PixelData, bytes.data(), bytes.size());
  } else {
    data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  }
  if (DcmXfer(syntax).isEncapsulated()) QVERIFY(data.chooseRepresentation(syntax, nullptr).good());
  const OFCondition status = format.saveFile(path.c_str(), syntax);
  QVERIFY2(status.good(), status.text());
}

/// A series whose file names have nothing to do with the order of its slices.
inline void saveSeries(const fs::path& folder, const std::function<bool(Slice&)>& change = {},
                       E_TransferSyntax syntax = EXS_LittleEndianExplicit,
                       const std::string& prefix = "") {
  for (int k = 0; k < kSlices; ++k) {
    Slice slice = sliceAt(k);
    if (change && !change(slice)) continue;
    saveSlice(slice, folder / (prefix + std::to_string(k * 5 % 7) + ".dcm"), syntax);
  }
}

/// Another series ("phase", values 5000 higher) beside the one that saveSeries() writes, in files
/// whose names begin with "b".
inline void saveSecondSeries(const fs::path& folder,
                             const std::function<bool(Slice&)>& change = {}) {
  saveSeries(
      folder,
      [&](Slice& slice) {
        slice.series = "1.2.3.4.2000002";
        slice.description = "phase";
        slice.rescaled = true;
        slice.intercept = 5000.0;
        slice.instance += ".9";
        return !change || change(slice);
      },
      EXS_LittleEndianExplicit, "b");
}

/// Orientation and pixel spacing of all frames; the item of the latter.
inline DcmItem* putSharedGroups(DcmItem& data) {
  DcmItem* shared = nullptr;
  DcmItem* item = nullptr;
  data.findOrCreateSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, -2);
  shared->findOrCreateSequenceItem(DCM_PlaneOrientationSequence, item, -2);
  putText(*item, DCM_ImageOrientationPatient,
          numbers(oblique().col(0)) + "\\" + numbers(oblique().col(1)));
  shared->findOrCreateSequenceItem(DCM_PixelMeasuresSequence, item, -2);
  putText(*item, DCM_PixelSpacing, std::to_string(kSpacingY) + "\\" + std::to_string(kSpacingX));
  return item;
}

/// An enhanced multi-frame object with `order[f]` the slice that frame f shows.
inline void saveEnhanced(const fs::path& path, const std::vector<int>& order,
                         bool withGroups = true,
                         E_TransferSyntax syntax = EXS_LittleEndianExplicit) {
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  Slice common = sliceAt(0);
  putCommon(data, common, UID_EnhancedMRImageStorage);
  putText(data, DCM_NumberOfFrames, std::to_string(order.size()));
  if (withGroups) {
    DcmItem* item = putSharedGroups(data);
    for (const int k : order) {
      DcmItem* frame = nullptr;
      data.findOrCreateSequenceItem(DCM_PerFrameFunctionalGroupsSequence, frame, -2);
      frame->findOrCreateSequenceItem(DCM_PlanePositionSequence, item, -2);
      putText(*item, DCM_ImagePositionPatient, numbers(sliceAt(k).position));
      frame->findOrCreateSequenceItem(DCM_PixelValueTransformationSequence, item, -2);
      putText(*item, DCM_RescaleSlope, "0.5");
      putText(*item, DCM_RescaleIntercept, "-7");
    }
  }
  std::vector<Uint16> pixels;
  for (const int k : order) appendPixels(sliceAt(k), pixels);
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  if (DcmXfer(syntax).isEncapsulated()) QVERIFY(data.chooseRepresentation(syntax, nullptr).good());
  QVERIFY(format.saveFile(path.c_str(), syntax).good());
}

inline void verifyGeometry(const Geometry& g) {
  QCOMPARE(g.size, (Index3{kColumns, kRows, kSlices}));
  QVERIFY((g.spacing - Eigen::Vector3d(kSpacingX, kSpacingY, kSpacingZ)).norm() < 1e-6);
  QVERIFY((g.origin - kOrigin).norm() < 1e-6);
  QVERIFY((g.direction - oblique()).norm() < 1e-6);
}

inline void verifyVoxels(const Volume<float>& image,
                         const std::function<float(int stored, int k)>& value) {
  for (int k = 0; k < kSlices; ++k)
    for (int j = 0; j < kRows; ++j)
      for (int i = 0; i < kColumns; ++i)
        QCOMPARE(image.at(i, j, k), value(storedValue(i, j, k), k));
}

inline QString refusal(const fs::path& path, const std::string& uid = {}) {
  try {
    readImage(path, {uid, false});
  } catch (const InputError& error) {
    return QString("Input: ") + error.what();
  } catch (const IoError& error) {
    return QString("Io: ") + error.what();
  }
  return "accepted";
}

inline const auto plain = [](int stored, int) { return static_cast<float>(stored); };

/// The finding of this kind, or null.
inline const Finding* findingOf(const std::vector<Finding>& findings, FindingKind kind) {
  for (const Finding& finding : findings)
    if (finding.kind == kind) return &finding;
  return nullptr;
}

/// Registers the encoders while it lives.
struct Encoders {
  Encoders() {
    DcmRLEEncoderRegistration::registerCodecs();
    DJLSEncoderRegistration::registerCodecs();
    DJEncoderRegistration::registerCodecs();
  }
  ~Encoders() {
    DcmRLEEncoderRegistration::cleanup();
    DJLSEncoderRegistration::cleanup();
    DJEncoderRegistration::cleanup();
  }
};

}  // namespace angiomesh::test
