// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/phantom/phantom.h"
#include "io/mesh/mesh_io.h"
#include "io/volume/image_write.h"
#include "tests/core/mesh_shapes.h"
#include "tests/io/dicom_writer.h"
#include "tests/io/identity_search.h"

namespace angiomesh::test {

/// Where the planted inputs lie: in a folder as hospitals name them, and in one below it.
inline fs::path plantedFolder(const fs::path& root) {
  const fs::path folder =
      root / (std::string(kPerson) + "_Wilma_" + kBirthDate) / ("Study " + std::string(kPerson));
  fs::create_directories(folder);
  return folder;
}

/// Two parallel tubes well apart, quick to segment.
inline Phantom plantedTubes() {
  PhantomParams params;
  params.kind = PhantomKind::Kissing;
  params.size = {32, 32, 32};
  params.spacingMm = {0.5, 0.5, 0.5};
  params.radius = 3.0;
  params.gap = 6.0;
  params.noiseSigma = 3.0;
  return makePhantom(params);
}

inline std::string planted(const std::string& what) { return std::string(kPerson) + " " + what; }

/// Everything that tells who it is, where a DICOM header has room for it.
inline void plantHeader(DcmDataset& data, const std::string& instance) {
  const std::string uid = kUidRoot;
  putText(data, DCM_PatientName, std::string(kPerson) + "^Wilma");
  putText(data, DCM_PatientBirthDate, kBirthDate);
  for (const DcmTagKey& tag : {DCM_StudyDate, DCM_SeriesDate, DCM_AcquisitionDate, DCM_ContentDate})
    putText(data, tag, kStudyDate);
  putText(data, DCM_StudyInstanceUID, uid + ".1");
  putText(data, DCM_SeriesInstanceUID, uid + ".2");
  putText(data, DCM_FrameOfReferenceUID, uid + ".3");
  putText(data, DCM_SOPInstanceUID, uid + ".4." + instance);
  int n = 0;
  for (const DcmTagKey& tag : {DCM_PatientID,
                               DCM_RETIRED_OtherPatientIDs,
                               DCM_OtherPatientNames,
                               DCM_PatientBirthName,
                               DCM_PatientMotherBirthName,
                               DCM_PatientAddress,
                               DCM_PatientTelephoneNumbers,
                               DCM_PatientComments,
                               DCM_AdditionalPatientHistory,
                               DCM_Occupation,
                               DCM_EthnicGroup,
                               DCM_AccessionNumber,
                               DCM_StudyID,
                               DCM_StudyDescription,
                               DCM_SeriesDescription,
                               DCM_ProtocolName,
                               DCM_InstitutionName,
                               DCM_InstitutionAddress,
                               DCM_InstitutionalDepartmentName,
                               DCM_ReferringPhysicianName,
                               DCM_PerformingPhysicianName,
                               DCM_OperatorsName,
                               DCM_RequestingPhysician,
                               DCM_StationName,
                               DCM_DeviceSerialNumber,
                               DCM_ImageComments,
                               DCM_PerformedProcedureStepDescription,
                               DCM_SequenceName})
    putText(data, tag, planted(std::to_string(++n)));
  putText(data, DCM_WindowCenter, "127");
  putText(data, DCM_WindowWidth, "255");
  putText(data, DCM_WindowCenterWidthExplanation, planted("window"));
  DcmItem* request = nullptr;
  data.findOrCreateSequenceItem(DCM_RequestAttributesSequence, request, -2);
  putText(*request, DCM_RequestedProcedureDescription, planted("request"));
  data.putAndInsertString(DcmTag(0x0029, 0x0010, EVR_LO), planted("creator").c_str());
  data.putAndInsertString(DcmTag(0x0029, 0x1001, EVR_LT), planted("private").c_str());
}

/// One file of a series that shows `image`.
inline void savePlantedSlice(const Volume<float>& image, int k, const fs::path& path) {
  const Geometry& g = image.geometry;
  DcmFileFormat format;
  DcmDataset& data = *format.getDataset();
  Slice slice;
  slice.columns = g.size[0];
  slice.rows = g.size[1];
  putCommon(data, slice, UID_MRImageStorage);
  plantHeader(data, std::to_string(k + 1));
  putText(data, DCM_ImagePositionPatient, numbers(g.toPhysical({0.0, 0.0, double(k)})));
  putText(data, DCM_ImageOrientationPatient,
          numbers(g.direction.col(0)) + "\\" + numbers(g.direction.col(1)));
  putText(data, DCM_PixelSpacing,
          std::to_string(g.spacing.y()) + "\\" + std::to_string(g.spacing.x()));
  std::vector<Uint16> pixels;
  for (int j = 0; j < slice.rows; ++j)
    for (int i = 0; i < slice.columns; ++i)
      pixels.push_back(static_cast<Uint16>(std::clamp(image.at(i, j, k), 0.0F, 400.0F)));
  data.putAndInsertUint16Array(DCM_PixelData, pixels.data(), pixels.size());
  QVERIFY(format.saveFile(path.c_str(), EXS_LittleEndianExplicit).good());
}

/// A series with a repeated slice and a letter beside it, and without the slices `missing`.
inline void savePlantedSeries(const Volume<float>& image, const fs::path& folder,
                              const std::vector<int>& missing = {}) {
  const fs::path below = folder / (std::string(kPerson) + "_series");
  fs::create_directories(below);
  const auto file = [&](const std::string& name) { return below / (kPerson + ("_" + name)); };
  for (int k = 0; k < image.geometry.size[2]; ++k)
    if (std::find(missing.begin(), missing.end(), k) == missing.end())
      savePlantedSlice(image, k, file(std::to_string(k) + ".dcm"));
  fs::copy_file(file("3.dcm"), file("again.dcm"));
  save(file("letter.txt"), planted("letter"));
}

inline std::string gzipped(const std::string& bytes) {
  z_stream stream{};
  deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

inline std::string withBehind(std::string text, const std::string& place,
                              const std::string& added) {
  const std::size_t at = text.find(place);
  return at == std::string::npos ? text : text.insert(at + place.size(), added);
}

/// A NIfTI header's texts, and a comment as an extension between header and voxels.
inline std::string plantedNifti(std::string bytes) {
  const auto text = [&](std::size_t at, const std::string& what) {
    bytes.replace(at, what.size(), what);
  };
  text(4, kPerson);   // data_type
  text(14, kPerson);  // db_name
  text(148, planted("descrip"));
  text(228, planted("aux"));
  text(328, kPerson);  // intent_name
  constexpr std::int32_t kBytes = 64, kComment = 6;
  put<float>(bytes, 108, 352.0F + kBytes);
  bytes[348] = 1;
  std::string extension;
  append(extension, kBytes);
  append(extension, kComment);
  extension += planted("extension");
  extension.resize(kBytes, '\0');
  return bytes.insert(352, extension);
}

/// Volumes of all formats that say who it is; returns their paths.
template <class T>
std::vector<fs::path> savePlantedVolumes(const Volume<T>& image, const fs::path& folder) {
  const auto file = [&](const std::string& name) { return folder / (kPerson + name); };
  writeVolume(image, file(".mha"));
  save(file(".mha"),
       withBehind(bytesOf(file(".mha")), "NDims = 3\n",
                  "PatientName = " + planted("name") + "\nComment = " + planted("comment") +
                      "\nAcquisitionDate = " + kStudyDate + "\n"));
  writeVolume(image, file(".nrrd"));
  save(file(".nrrd"), withBehind(bytesOf(file(".nrrd")), "NRRD0004\n",
                                 "# " + planted("comment") + "\ncontent: " + planted("content") +
                                     "\nPatientName:=" + planted("name") +
                                     "\nDICOM_0008_0020:=" + kStudyDate + "\n"));
  writeVolume(image, file(".nhdr"));
  save(file(".nhdr"),
       withBehind(bytesOf(file(".nhdr")), "NRRD0004\n", "PatientName:=" + planted("name") + "\n"));
  writeVolume(image, file(".mhd"));
  save(file(".mhd"),
       withBehind(bytesOf(file(".mhd")), "NDims = 3\n", "PatientID = " + planted("number") + "\n"));
  writeVolume(image, file(".nii"));
  const std::string nifti = plantedNifti(bytesOf(file(".nii")));
  save(file(".nii"), nifti);
  save(file(".nii.gz"), gzipped(nifti));
  return {file(".mha"), file(".nrrd"), file(".nhdr"), file(".mhd"), file(".nii"), file(".nii.gz")};
}

/// Character codes, as VTK writes texts in XML.
inline std::string codes(const std::string& text) {
  std::string list;
  for (const char c : text) list += std::to_string(static_cast<int>(c)) + " ";
  return list + "0";
}

/// Meshes of all formats that say who it is, also where the program writes its key; returns their
/// paths.
inline std::vector<fs::path> savePlantedMeshes(const fs::path& folder) {
  const TriMesh ball = shapes::icosphere(1);
  const std::string key = "KEY=" + std::string(kPerson);
  const auto file = [&](const std::string& name) { return folder / (kPerson + name); };
  MeshWriteOptions ascii;
  ascii.encoding = MeshEncoding::Ascii;
  ascii.key = kPerson;
  MeshWriteOptions binary;
  binary.key = kPerson;
  writeMesh(ball, file(".ply"), ascii);
  save(file(".ply"),
       withBehind(bytesOf(file(".ply")), "format ascii 1.0\n",
                  "comment " + planted("comment") + "\nobj_info " + planted("info") + "\n"));
  writeMesh(ball, file(".obj"), binary);
  save(file(".obj"), "# " + planted("comment") + "\nmtllib " + kPerson + ".mtl\no " + kPerson +
                         "\ng " + kPerson + "\n" + bytesOf(file(".obj")));
  writeMesh(ball, file("_binary.stl"));
  std::string stl = bytesOf(file("_binary.stl"));
  const std::string head = "Model of " + planted(key);
  save(file("_binary.stl"), stl.replace(0, head.size(), head));
  ascii.patchNames = {kPerson};
  writeMesh(ball, file("_one.stl"), ascii);
  TriMesh patched = ball;
  patched.patch.assign(80, 0);
  std::fill(patched.patch.begin() + 40, patched.patch.end(), std::uint16_t{1});
  ascii.patchNames = {std::string(kPerson) + "_wall", std::string(kPerson) + "_inlet"};
  writeMesh(patched, file(".stl"), ascii);
  binary.patchNames = ascii.patchNames;
  writeMesh(patched, file("_patches.ply"), ascii);
  writeMesh(patched, file("_patches.obj"), binary);
  writeMesh(patched, file("_patches.vtp"), binary);
  save(file("_patches.vtp"), withBehind(bytesOf(file("_patches.vtp")), "<FieldData>",
                                        "<!-- " + planted("comment") + " -->"));
  writeMesh(ball, file(".vtp"), binary);
  save(file(".vtp"),
       withBehind(bytesOf(file(".vtp")), "<FieldData>",
                  "<Array type=\"String\" Name=\"" + std::string(kPerson) +
                      "\" NumberOfTuples=\"1\" format=\"ascii\">" + codes(planted("name")) +
                      "</Array><!-- " + planted(key) + " -->"));
  std::string vtk = "# vtk DataFile Version 3.0\n" + planted("title " + key) +
                    "\nASCII\nDATASET POLYDATA\nPOINTS " + std::to_string(ball.points.size()) +
                    " double\n";
  for (const auto& p : ball.points) vtk += numbers(p) + "\n";
  std::replace(vtk.begin(), vtk.end(), '\\', ' ');
  vtk += "POLYGONS 80 320\n";
  for (const auto& t : ball.triangles)
    vtk += "3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " + std::to_string(t[2]) +
           "\n";
  save(file(".vtk"), vtk);
  return {file(".ply"),         file(".obj"),        file("_binary.stl"), file(".stl"),
          file("_one.stl"),     file(".vtp"),        file(".vtk"),        file("_patches.ply"),
          file("_patches.obj"), file("_patches.vtp")};
}

}  // namespace angiomesh::test
