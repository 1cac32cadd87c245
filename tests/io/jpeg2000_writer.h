// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gdcmImageChangeTransferSyntax.h>
#include <gdcmImageReader.h>
#include <gdcmImageWriter.h>
#include <gdcmTrace.h>

#include "tests/io/dicom_writer.h"

namespace angiomesh::test {

/// Compresses the pixels of a DICOM file with JPEG 2000, which DCMTK does not write.
inline void toJpeg2000(const fs::path& path) {
  DcmFileFormat file, packed;
  QVERIFY(file.loadFile(path.c_str()).good() && file.loadAllDataIntoMemory().good());
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  QVERIFY(reader.Read());
  gdcm::ImageChangeTransferSyntax change;
  change.SetTransferSyntax(gdcm::TransferSyntax::JPEG2000Lossless);
  change.SetInput(reader.GetImage());
  QVERIFY(change.Change());
  gdcm::ImageWriter writer;
  writer.SetFile(reader.GetFile());
  writer.SetImage(change.GetOutput());
  writer.SetFileName(path.c_str());
  QVERIFY(writer.Write());
  gdcm::Trace::WarningOn();
  gdcm::Trace::ErrorOn();
  // GDCM changes more than the pixels.
  QVERIFY(packed.loadFile(path.c_str()).good() && packed.loadAllDataIntoMemory().good());
  QVERIFY(packed.getDataset()->findAndInsertCopyOfElement(DCM_PixelData, file.getDataset()).good());
  QVERIFY(file.saveFile(path.c_str(), packed.getDataset()->getOriginalXfer()).good());
}

}  // namespace angiomesh::test
