// SPDX-License-Identifier: BSD-3-Clause
// fuzz_seeds FOLDER: writes the inputs that the fuzzers start from to FOLDER/fuzz_dicom, fuzz_image
// and so on. Each is tiny and of one of the kinds that the readers take.
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include "core/parameters/field.h"
#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "io/mesh/mesh_io.h"
#include "io/recipe/recipe_file.h"
#include "io/vessel/ports_file.h"
#include "io/volume/image_write.h"
#include "tests/core/random_parameters.h"
#include "tests/io/dicom_writer.h"
#include "tests/io/jpeg2000_writer.h"
#include "tests/io/mesh_samples.h"

using namespace angiomesh;
using namespace angiomesh::test;

namespace {

/// Encoders name their pictures after the machine.
void takeName(const fs::path& path) {
  DcmFileFormat format;
  if (format.loadFile(path.c_str()).bad() || format.loadAllDataIntoMemory().bad()) return;
  putText(*format.getDataset(), DCM_SOPInstanceUID, "1.2.3.4.5.6");
  format.saveFile(path.c_str(), format.getDataset()->getOriginalXfer());
}

void makeDicom(const fs::path& folder) {
  const Encoders encoders;
  const std::pair<const char*, E_TransferSyntax> syntaxes[] = {
      {"explicit", EXS_LittleEndianExplicit},
      {"implicit", EXS_LittleEndianImplicit},
      {"big", EXS_BigEndianExplicit},
      {"deflated", EXS_DeflatedLittleEndianExplicit},
      {"rle", EXS_RLELossless},
      {"jpeg_lossless", EXS_JPEGProcess14SV1},
      {"jpegls", EXS_JPEGLSLossless}};
  for (const auto& [name, syntax] : syntaxes) {
    saveSlice(sliceAt(1), folder / name, syntax);
    saveEnhanced(folder / (std::string("frames_") + name), {2, 0, 1}, true, syntax);
  }
  saveSlice(sliceAt(1), folder / "jpeg2000");
  toJpeg2000(folder / "jpeg2000");
  saveEnhanced(folder / "frames_jpeg2000", {2, 0, 1});
  toJpeg2000(folder / "frames_jpeg2000");
  saveEnhanced(folder / "frames_nowhere", {0, 1, 2}, false);

  Slice slice = sliceAt(0);
  slice.edit = [](DcmDataset& data) {
    data.putAndInsertUint16(DCM_BitsAllocated, 8);
    data.putAndInsertUint16(DCM_BitsStored, 8);
    data.putAndInsertUint16(DCM_HighBit, 7);
  };
  slice.encode = [](int value) { return static_cast<Uint16>(value % 256); };
  saveSlice(slice, folder / "bytes");
  saveSlice(slice, folder / "jpeg_baseline", EXS_JPEGProcess1);

  Slice padded = sliceAt(2);
  padded.isSigned = padded.rescaled = true;
  padded.slope = 0.5;
  padded.intercept = -1024.0;
  padded.edit = [](DcmDataset& data) {
    putText(data, DCM_PhotometricInterpretation, "MONOCHROME1");
    data.putAndInsertSint16(DcmTag(DCM_PixelPaddingValue, EVR_SS), -2000);
    data.putAndInsertSint16(DcmTag(DCM_PixelPaddingRangeLimit, EVR_SS), -1900);
  };
  saveSlice(padded, folder / "padding");

  Slice colour = sliceAt(3);
  colour.edit = [](DcmDataset& data) {
    data.putAndInsertUint16(DCM_SamplesPerPixel, 3);
    putText(data, DCM_PhotometricInterpretation, "RGB");
  };
  saveSlice(colour, folder / "colour");

  for (const auto& entry : fs::directory_iterator(folder)) takeName(entry.path());

  // Old files: no preamble, no meta header, the data set from the first byte on.
  DcmFileFormat format;
  format.loadFile((folder / "implicit").c_str());
  format.getDataset()->saveFile((folder / "no_preamble").c_str(), EXS_LittleEndianImplicit);
}

template <class T>
AnyVolume volumeOf() {
  Volume<T> volume;
  volume.geometry.size = {3, 4, 3};
  volume.geometry.spacing = {0.5, 0.6, 1.2};
  volume.geometry.origin = {-10, 20, 30.5};
  volume.geometry.direction = oblique();
  volume.voxels = BigVector<T>(36);
  for (std::size_t i = 0; i < 36; ++i) volume.voxels[i] = static_cast<T>(i * 3 % 7);
  return volume;
}

template <class T>
void makeVolumes(const fs::path& folder, const std::string& type) {
  for (const char* ending : {".mha", ".nrrd", ".nii", ".nii.gz"})
    writeVolume(volumeOf<T>(), folder / (type + ending));
}

/// What our writers do not write.
void makeForeignImages(const fs::path& folder) {
  const std::string meta =
      "ObjectType = Image\nNDims = 3\nDimSize = 2 3 2\nElementSpacing = 1 2 3\n";
  const std::string local = "ElementDataFile = LOCAL\n";
  const std::string text = "0 1 2 3 4 5 6 7 8 9 10 11\n";
  std::string shorts;
  for (std::int16_t i = 0; i < 36; ++i) append(shorts, i);
  save(folder / "text.mha", meta + "ElementType = MET_SHORT\nBinaryData = False\n" + local + text);
  save(folder / "raw.mha", meta +
                               "ElementType = MET_SHORT\nBinaryData = True\nBinaryDataByteOrderMSB "
                               "= True\nTransformMatrix = 0 1 0 1 0 0 0 0 1\nOffset = 4 5 "
                               "6\nModality = MET_MOD_MR\n" +
                               local + shorts.substr(0, 24));
  save(folder / "vector.mha",
       meta + "ElementNumberOfChannels = 3\nElementType = MET_SHORT\n" + local + shorts);
  save(folder / "pattern.mhd",
       meta + "ElementType = MET_SHORT\nHeaderSize = -1\nElementDataFile = s%02d.raw 1 2 1\n");
  save(folder / "list.mhd", meta + "ElementType = MET_SHORT\nElementDataFile = LIST\na\nb\n");
  save(folder / "time.mha",
       "ObjectType = Image\nNDims = 4\nDimSize = 2 3 2 3\nElementSpacing = 1 2 3 1\n"
       "ElementType = MET_SHORT\n" +
           local + shorts);
  save(folder / "large.mha",
       "ObjectType = Image\nNDims = 3\nDimSize = 100000 100000 100000\n"
       "ElementType = MET_SHORT\n" +
           local + shorts);

  const std::string nrrd = "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 3 2\n";
  const std::string place =
      "space: left-posterior-superior\nspace directions: (1,0,0) (0,2,0) (0,0,3)\n"
      "space origin: (5,6,7)\nkinds: domain domain domain\n";
  save(folder / "text.nrrd", nrrd + place + "encoding: ascii\n\n" + text);
  save(folder / "hex.nrrd", nrrd + place + "endian: little\nencoding: hex\n\n" +
                                "000001000200030004000500060007000800090010001100\n");
  save(folder / "raw.nrrd", nrrd + "spacings: 1 2 3\nendian: big\nbyte skip: 2\nencoding: raw\n\n" +
                                shorts.substr(0, 26));
  save(folder / "list.nhdr",
       nrrd + place + "endian: little\nencoding: raw\ndata file: LIST\na\nb\n");
  save(
      folder / "pattern.nhdr",
      nrrd + place + "endian: little\nencoding: raw\nline skip: 1\ndata file: s%02d.raw 1 2 1\n\n");
  const std::string four = "NRRD0005\ntype: short\ndimension: 4\nspace: right-anterior-superior\n";
  save(folder / "vector.nrrd",
       four +
           "sizes: 3 2 3 2\nkinds: vector domain domain domain\nspace directions: none (1,0,0) "
           "(0,2,0) (0,0,3)\nendian: little\nencoding: raw\n\n" +
           shorts);
  save(folder / "time.nrrd",
       four +
           "sizes: 2 3 2 3\nkinds: domain domain domain list\nspace directions: (1,0,0) "
           "(0,2,0) (0,0,3) none\nendian: little\nencoding: raw\n\n" +
           shorts);
  save(folder / "segments.seg.nrrd",
       four +
           "sizes: 2 2 3 3\nkinds: list domain domain domain\nspace directions: none (1,0,0) "
           "(0,2,0) (0,0,3)\nendian: little\nencoding: raw\nSegment0_Name:=artery\n"
           "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment1_Name:=vein\n"
           "Segment1_LabelValue:=1\nSegment1_Layer:=1\n\n" +
           shorts);
  std::string scaled = bytesOf(folder / "int16.nii");
  put(scaled, 112, 0.5F);
  put(scaled, 116, -3.0F);
  save(folder / "scaled.nii", scaled);
  std::string time = bytesOf(folder / "uint8.nii");
  put<std::int16_t>(time, 40, 4);
  put<std::int16_t>(time, 48, 2);
  save(folder / "time.nii", time + std::string(36, '\1'));
}

void makeImages(const fs::path& folder) {
  makeVolumes<std::int8_t>(folder, "int8");
  makeVolumes<std::uint8_t>(folder, "uint8");
  makeVolumes<std::int16_t>(folder, "int16");
  makeVolumes<std::uint16_t>(folder, "uint16");
  makeVolumes<std::int32_t>(folder, "int32");
  makeVolumes<std::uint64_t>(folder, "uint64");
  makeVolumes<float>(folder, "float32");
  makeVolumes<double>(folder, "float64");
  makeForeignImages(folder);
}

vtkNew<vtkPolyData> polyDataOf(const TriMesh& mesh) {
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  for (const auto& p : mesh.points) points->InsertNextPoint(p.data());
  vtkNew<vtkCellArray> polygons, strips;
  for (std::size_t i = 1; i < mesh.triangles.size(); ++i) {
    polygons->InsertNextCell(3);
    for (const std::uint32_t corner : mesh.triangles[i]) polygons->InsertCellPoint(corner);
  }
  strips->InsertNextCell(3);
  for (const std::uint32_t corner : mesh.triangles[0]) strips->InsertCellPoint(corner);
  data->SetPoints(points);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  return data;
}

/// With the byte before it that says the format.
void keepMesh(const fs::path& folder, const std::string& name, const std::string& bytes) {
  const fs::path ending = fs::path(name).extension();
  const char kind = ending == ".ply"   ? '0'
                    : ending == ".stl" ? '1'
                    : ending == ".obj" ? '2'
                    : ending == ".vtp" ? '3'
                    : ending == ".off" ? '5'
                                       : '4';
  save(folder / name, kind + bytes);
}

void makeVtkMeshes(const fs::path& folder, const fs::path& scratch) {
  const vtkNew<vtkPolyData> data = polyDataOf(octahedron());
  for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended})
    for (const int packer :
         {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA}) {
      if (mode == vtkXMLWriter::Ascii && packer != vtkXMLWriter::NONE) continue;
      vtkNew<vtkXMLPolyDataWriter> writer;
      writer->SetInputData(data);
      writer->SetFileName(scratch.c_str());
      writer->SetDataMode(mode);
      writer->SetCompressorType(packer);
      writer->SetHeaderType(packer == vtkXMLWriter::LZ4 ? vtkXMLWriter::UInt64
                                                        : vtkXMLWriter::UInt32);
      writer->SetEncodeAppendedData(packer == vtkXMLWriter::ZLIB);
      writer->Write();
      keepMesh(folder, "vtk" + std::to_string(mode) + std::to_string(packer) + ".vtp",
               bytesOf(scratch));
    }
  for (const int version : {42, 51})
    for (const bool ascii : {false, true}) {
      vtkNew<vtkPolyDataWriter> writer;
      writer->SetInputData(data);
      writer->SetFileName(scratch.c_str());
      writer->SetFileVersion(version);
      writer->SetFileType(ascii ? VTK_ASCII : VTK_BINARY);
      writer->Write();
      keepMesh(folder, (ascii ? "ascii" : "binary") + std::to_string(version) + ".vtk",
               bytesOf(scratch));
    }
}

void makeMeshes(const fs::path& folder) {
  const Folder scratch;
  for (const char* ending : {".ply", ".stl", ".obj", ".off", ".vtp"})
    for (const bool ascii : {false, true}) {
      const std::string extension = ending;
      if (ascii && (extension == ".obj" || extension == ".off" || extension == ".vtp")) continue;
      MeshWriteOptions options;
      options.encoding = ascii ? MeshEncoding::Ascii : MeshEncoding::Binary;
      options.key = "0123abc";
      options.normals = options.quality = extension == ".ply" || extension == ".vtp";
      const fs::path path = scratch / ("m" + extension);
      writeMesh(octahedron(), path, options);
      keepMesh(folder, (ascii ? "ascii" : "ours") + extension, bytesOf(path));
      TriMesh patched = octahedron();
      patched.patch = {0, 0, 1, 0, 2, 2, 0, 0};
      options.patchNames = {"wall", "one", "two"};
      writeMesh(patched, path, options);
      keepMesh(folder, (ascii ? "patches-ascii" : "patches") + extension, bytesOf(path));
    }
  makeVtkMeshes(folder, scratch / "m");

  std::string big = plyHeader("binary_big_endian", 3, 1);
  for (int i = 0; i < 3; ++i) big += std::string("\x3f\x80\0\0\0\0\0\0\0\0\0\0", 12) + "r";
  keepMesh(folder, "big.ply", big + std::string("\3\0\0\0\0\0\0\0\1\0\0\0\2", 13));
  keepMesh(folder, "polygon.ply",
           plyHeader("ascii", 4, 1) + "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n4 0 1 2 3\n");
  keepMesh(folder, "polygon.obj",
           "# SPACE=RAS\nmtllib a.mtl\no a\nv 0 0 0\nv 1 0 0 1\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 "
           "0\ng b\nf 1/1/1 2//1 3/1 -1\n");
  keepMesh(
      folder, "fields.vtk",
      "# vtk DataFile Version 3.0\nSPACE=RAS UNIT=m\nASCII\nDATASET POLYDATA\nFIELD f 1\na 1 2 "
      "int\n3 4\nPOINTS 4 float\n0 0 0 1 0 0 1 1 0 0 1 0\nLINES 1 3\n2 0 1\nPOLYGONS 1 5\n4 0 "
      "1 2 3\nTRIANGLE_STRIPS 1 4\n3 0 1 2\nPOINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE "
      "default\n1 2 3 4\nNORMALS n float\n0 0 1 0 0 1 0 0 1 0 0 1\n");
}

/// A segmentation of 4 x 3 x 2 voxels in text; with `layers` above 1 the layers lie beside one
/// another.
std::string segmentation(const std::string& segments, int layers = 1,
                         const std::string& type = "short") {
  const bool several = layers > 1;
  std::string text =
      "NRRD0004\ntype: " + type + "\ndimension: " + (several ? "4" : "3") +
      "\nspace: left-posterior-superior\nsizes: " + (several ? std::to_string(layers) + " " : "") +
      "4 3 2\nspace directions: " + (several ? "none " : "") +
      "(1,0,0) (0,1,0) (0,0,2)\nspace origin: (0,0,0)\n" + "kinds: " + (several ? "list " : "") +
      "domain domain domain\n" + "encoding: ascii\n" + segments + "\n";
  for (int n = 0; n < 24 * layers; ++n) text += std::to_string(n * 7 % 9 % 4) + " ";
  return text + "\n";
}

std::string segment(int number, const std::string& name, int value, int layer = 0) {
  const std::string key = "Segment" + std::to_string(number) + "_";
  return key + "ID:=Segment_" + std::to_string(number + 1) + "\n" + key + "Name:=" + name + "\n" +
         key + "LabelValue:=" + std::to_string(value) + "\n" + key +
         "Layer:=" + std::to_string(layer) + "\n";
}

/// With the line before it that is the choice.
void makeLabels(const fs::path& folder) {
  const std::string three = segmentation(segment(0, "artery", 1) +
                                         segment(1, "left vein, upper", 2) + segment(2, "3", 3));
  const std::string twice = segmentation(segment(0, "artery", 1) + segment(1, "artery", 2));
  const std::string layers = segmentation(
      segment(0, "artery", 1) + segment(1, "vein", 1, 1) + segment(2, "value:1", 2, 1), 2);
  const std::pair<const char*, const char*> choices[] = {
      {"all", "1,2,3"},       {"value", "value:2"},   {"name", "name:artery"},
      {"plain", "artery"},    {"id", "id:Segment_3"}, {"comma", "left vein, upper"},
      {"mixed", "artery, 2"}, {"none", ""},           {"empty", "1,,2"},
      {"unknown", "value:9"}, {"least", "=2"}};
  for (const auto& [name, choice] : choices) {
    save(folder / (std::string("three-") + name), choice + ("\n" + three));
    save(folder / (std::string("layers-") + name), choice + ("\n" + layers));
  }
  save(folder / "twice", "artery\n" + twice);
  save(folder / "plain", "1,3\n" + segmentation(""));
  save(folder / "unnamed", "1,,3\n" + segmentation(segment(0, "artery", 1)));
  save(folder / "float", "3\n" + segmentation("", 1, "float"));
  std::string shares = segmentation("", 1, "float");
  shares.resize(shares.find("\n\n") + 2);
  for (int n = 0; n < 24; ++n) shares += "0." + std::to_string(n * 7 % 10) + " ";
  save(folder / "shares", "=0.25\n" + shares);
  save(folder / "share", "\n" + shares);
  const Folder scratch;
  for (const char* ending : {".mha", ".nii", ".nii.gz", ".nrrd"}) {
    writeVolume(volumeOf<std::uint8_t>(), scratch / (std::string("m") + ending));
    save(folder / (std::string("volume") + ending),
         "2,value:5\n" + bytesOf(scratch / (std::string("m") + ending)));
  }
}

SavedCase smallDocument() {
  SavedCase document;
  document.source.hash = "0123456789abcdef";
  document.source.format = "NRRD";
  document.source.grid.size = {64, 48, 40};
  document.source.grid.spacing = {0.35, 0.35, 0.6};
  document.view.layer = "vesselness";
  document.view.windowLevels = {{"source", {300.0, 120.0}}};
  document.view.crosshairLps = Eigen::Vector3d(1.5, -2.25, 0.1);
  document.view.shown = {{"contours", true}};
  document.saves = 3;
  return document;
}

/// case.json with `parameters` and `view` in place of all of them.
std::string shortCase(const std::string& parameters, const std::string& view = "{}") {
  return "{\"schema\": 1, \"saves\": 3, \"source\": {\"hash\": \"0123\", \"format\": \"NRRD\", "
         "\"files\": 1, \"size\": [6, 4, 2], \"spacingMm\": [1, 1, 2.5], \"originMm\": [0, -1.5, "
         "3], \"direction\": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}, \"parameters\": " +
         parameters + ", \"view\": " + view + "}";
}

std::string shortEdit(int saves, int position, const std::string& text,
                      const std::string& parameters) {
  return "{\"saves\": " + std::to_string(saves) + ", \"position\": " + std::to_string(position) +
         ", \"text\": \"" + text + "\", \"parameters\": " + parameters + "}\n";
}

/// case.json, case.previous.json and the journal between form feeds.
void makeCases(const fs::path& folder) {
  const Folder scratch;
  const fs::path place = scratch / "a.angiomesh";
  writeCase(place, smallDocument());
  appendJournal(place, {{3, 1, "change levelset.xi", randomParameters(1), {}}});
  const std::string whole = bytesOf(place / "case.json");
  const std::string journal = bytesOf(place / "edits" / "journal.jsonl");
  save(folder / "whole", whole + "\f\f" + journal);
  save(folder / "half", whole.substr(0, whole.size() / 2) + "\f" + shortCase("{}"));
  save(folder / "damaged", "{\f{\f" + journal);

  const std::string xi = "{\"levelset\": {\"xi\": 41}}";
  const std::string view =
      "{\"layer\": \"source\", \"windowLevels\": {\"source\": [300, 120]}, \"slab\": \"mip\", "
      "\"slabThicknessMm\": 7.5, \"shown\": {\"surface\": true}, \"mesh\": \"smoothed\", "
      "\"colour\": \"minAngle\", \"crosshairMm\": [1, 2, 3]}";
  const std::string edits = shortEdit(3, 1, "change levelset.xi", xi) +
                            shortEdit(3, 1, "change levelset.xi", "{\"levelset.xi\": 42}") +
                            shortEdit(3, 2, "add a seed", "{\"seeds.points\": [1, 2, 3]}");
  const std::string head = "{\"source\": {\"hash\": \"0123\"}}\n";
  save(folder / "short", shortCase(xi));
  save(folder / "view", shortCase("{}", view));
  save(folder / "edits", shortCase(xi) + "\f\f" + head + edits);
  save(folder / "unfinished", shortCase(xi) + "\f\f" + edits + "{\"saves\": 3, \"posi");
  save(folder / "previous", "[]\f" + shortCase(xi) + "\f" + edits);
  save(folder / "journal", "{}\f\f" + head + edits);
  save(folder / "old", shortCase(xi) + "\f\f" + shortEdit(2, 1, "of before", xi));
  save(folder / "newer", "{\"schema\": 2}\f" + shortCase(xi));
  save(folder / "unknown",
       shortCase("{\"levelset\": {\"xj\": 4, \"xi\": -1}, \"a\": {\"b\": {}}}"));
  save(folder / "ports", shortCase("{\"ports\": {\"cuts\": [\"1,2,3,in\", \"4,5,6,0,0,1,out\"], "
                                   "\"names\": [\"border_1=left\"], \"cutEndsRadii\": 2}}"));
  save(folder / "lists", shortCase("{\"seeds\": {\"automatic\": false, \"points\": [1, 2, 3]}, "
                                   "\"preprocess\": {\"roi\": [0, 0, 0, 9, 9, 9]}, "
                                   "\"segmentation\": {\"drop\": \"none\"}}"));
}

/// JSON, settings, cuts, names of ports and a ports.json between form feeds.
void makeParameters(const fs::path& folder) {
  for (const std::string& name : presetNames()) save(folder / name, parametersToJson(preset(name)));
  for (std::uint64_t n = 0; n < 3; ++n)
    save(folder / ("random-" + std::to_string(n)), parametersToJson(randomParameters(n)));
  Recipe recipe;
  recipe.program = "0.3.0";
  recipe.source = RecipeSource{"0123456789abcdef", {6, 4, 2}, {1.0, 1.0, 2.5}};
  save(folder / "recipe", recipeText(recipe));
  int number = 0;
  for (const char* json :
       {R"({"schema": 1, "program": "0.3.0", "parameters": {"levelset.xi": 31}})",
        "{\"levelset\": {\"xi\": 31, \"d\": 0.25}}", "{\"levelset.xi\": 31}",
        "{\"surface.edgesAround\": 0}",
        "{\"vesselness\": {\"scales\": \"auto\", \"measure\": \"frangi\"}}",
        "{\"seeds.points\": [1, 2, 3.5e1, -4, 5, 6], \"preprocess.roi\": \"none\"}",
        "{\"ports\": {\"cuts\": [\"1,2,3,in\"], \"names\": [\"border_1=left\"]}}"})
    save(folder / ("json-" + std::to_string(number++)), json);
  number = 0;
  for (const char* settings :
       {"levelset.xi=31\nlevelset.refine=off\nsurface.edgesAround=none",
        "preprocess.roi=0,0,0,1,2,3",
        "seeds.points=1,2,3,4,5,6\nvesselness.scales=7\nvesselness.measure=frangi",
        "ports.cuts=1,2,3,in;4,5,6,0,0,1,out\nports.names=border_1=left", "smooth.iterations=+5",
        "levelset.b=1e-3\nlevelset.b=auto\nwall.smooth=1"})
    save(folder / ("set-" + std::to_string(number++)), std::string("{}\f") + settings);
  number = 0;
  for (const char* cuts : {"1,2,3,in\f", "1,2,3,in\n4,5,6,0,0,-1,out-2\fborder_1=left\nin=a.b",
                           " 1.5, -2e1 ,3,0.1,0.2,0.3 ,in", "\fborder_2=left_renal"})
    save(folder / ("cut-" + std::to_string(number++)), std::string("{}\f\f") + cuts);
  const Folder scratch;
  std::vector<Port> ports{{"inlet", {12.1, -30.7, 0.5}, {0, 0.6, -0.8}, 12.56},
                          {"border_1", {0, 1, -4e3}, {0, 0, -1}, 0.7}};
  ports[1].slant = BorderSlant{41.3, 0.5, 13.0, {1, 2, 3.3}, {0, 0.6, -0.8}};
  writePorts(ports, scratch / "two.json");
  writePorts({}, scratch / "none.json");
  for (const char* name : {"two.json", "none.json"})
    save(folder / name, "{}\f\f\f\f" + bytesOf(scratch / name));
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "fuzz_seeds FOLDER\n");
    return 2;
  }
  const fs::path folder = words[1];
  const std::pair<const char*, void (*)(const fs::path&)> makers[] = {
      {"fuzz_case", makeCases},    {"fuzz_dicom", makeDicom}, {"fuzz_image", makeImages},
      {"fuzz_labels", makeLabels}, {"fuzz_mesh", makeMeshes}, {"fuzz_parameters", makeParameters}};
  for (const auto& [name, make] : makers) {
    fs::create_directories(folder / name);
    make(folder / name);
  }
  return 0;
}
