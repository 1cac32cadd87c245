// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <memory>
#include <optional>

#include "app/cli/commands.h"
#include "app/session/mesh_files.h"
#include "app/session/options.h"
#include "core/base/error.h"
#include "core/openings/port.h"
#include "io/mesh/mesh_format.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/scan/mask_file.h"
#include "io/vessel/openfoam_case.h"
#include "io/vessel/patch_files.h"
#include "io/volume/image_format.h"
#include "io/volume/image_write.h"
#include "io/volume/not_finite.h"

namespace angiomesh::cli {
namespace {

namespace fs = std::filesystem;

struct ConvertOptions {
  ReadOptions reading;
  MeshReading meshReading;
  std::optional<int> component;
  std::string input, output, unit = "mm", frame = "lps", fromFrame, fromUnit;
  bool ascii = false, normals = false, quality = false, solidNames = false, patchFiles = false,
       openFoam = false, force = false;
  std::string like;  ///< the DICOM series that a mask is of
  bool identity = false;
  std::string meshOption;  ///< one that was given and means nothing for a volume
};

/// Through links and other names of the same file.
void checkOther(const ConvertOptions& options) {
  std::error_code error;
  if (!options.force && fs::equivalent(options.input, options.output, error) &&
      !fs::is_directory(options.input, error))
    throw InputError("the output is the input", options.output,
                     "give another name with -o, or replace the input with --force");
}

bool isMeshName(const fs::path& path) {
  const MeshFormat* format = meshFormatOf(path);
  return format != nullptr && format->written();
}

/// Says which of the two names is wrong before a file is read as what it is not.
void checkKinds(const ConvertOptions& options) {
  const bool fromMesh = meshFormatOf(options.input) != nullptr;
  if (isMeshName(options.output)) {
    if (imageEndingOf(options.input) != nullptr || fs::is_directory(options.input))
      throw InputError("a volume does not become a mesh by conversion", options.input,
                       "make its surface with 'run' or, of a mask, with 'mesh'");
    return;
  }
  if (!fromMesh) return;
  if (imageEndingOf(options.output) != nullptr)
    throw InputError("a mesh does not become a volume", options.output,
                     "end the output's name in " + meshEndings(true));
  throw InputError("no format that can be written has the ending of the output's name",
                   options.output,
                   "end it in " + meshEndings(true) + ", or write a folder with --openfoam");
}

LoadedMesh loadSpoken(const ConvertOptions& options) {
  LoadedMesh loaded =
      loadMesh(options.input, options.meshReading.options(options.fromFrame, options.fromUnit));
  for (const std::string& warning : loaded.warnings) printWarning(warning);
  if (!loaded.frameStated && options.fromFrame.empty())
    printWarning("the mesh does not say its frame, LPS is taken, " + options.input +
                 ": give --from-frame ras if it is in RAS");
  return loaded;
}

void sayNumbered(const ConvertOptions& options) {
  printWarning("patches are numbered whose names may tell who the patient is, " + options.input +
               ": give --solid-names to keep them");
}

int convertMesh(const ConvertOptions& options, const Progress& progress) {
  const MeshFormat* format = meshFormatOf(options.output);
  const bool hasNames =
      format == nullptr ||
      format->holdsNames(options.ascii ? MeshEncoding::Ascii : MeshEncoding::Binary);
  if (options.solidNames && !hasNames && !options.patchFiles)
    throw InputError("a binary STL file has no names of patches", "--solid-names",
                     "leave it out, or write .stl with --ascii, .ply, .vtp or .obj");
  const LoadedMesh loaded = loadSpoken(options);
  if (options.patchFiles && loaded.mesh.patch.empty())
    throw InputError("the mesh has no patches", options.input,
                     "leave --patch-files out, or give a mesh with named solids, groups or faces");
  MeshWriteOptions write;
  write.unit = unitFromOption(options.unit);
  write.frame = frameFromOption(options.frame);
  write.encoding = options.ascii ? MeshEncoding::Ascii : MeshEncoding::Binary;
  write.normals = options.normals;
  write.quality = options.quality;
  write.key = loaded.key;
  bool numbered = false;
  write.patchNames = options.solidNames ? loaded.patchNames : plainPatchNames(loaded, numbered);
  if (numbered && loaded.patchNames.size() > 1 && (hasNames || options.patchFiles))
    sayNumbered(options);
  progress.check();
  if (!options.patchFiles) {
    writeChecked(loaded.mesh, options.output, options.output, write);
    return Done;
  }
  std::vector<std::string> warnings;
  writePatchFiles(loaded.mesh, options.output, write, &warnings);
  for (const std::string& warning :
       renamedWords(write.patchNames, fileWords(write.patchNames), "among the files"))
    warnings.push_back(warning);
  for (const std::string& warning : warnings) printWarning(warning + ", " + options.output);
  return Done;
}

int convertToOpenFoam(const ConvertOptions& options, const Progress& progress) {
  const LoadedMesh loaded = loadSpoken(options);
  bool numbered = false;
  const std::vector<std::string> names =
      options.solidNames ? loaded.patchNames : plainPatchNames(loaded, numbered);
  if (numbered && names.size() > 1) sayNumbered(options);
  std::vector<Port> ports;
  if (!loaded.mesh.patch.empty()) ports = measurePatches(loaded.mesh, names.size() - 1);
  for (std::size_t n = 0; n < ports.size(); ++n) ports[n].name = names[n + 1];
  progress.check();
  const OpenFoamCase written = writeOpenFoamCase(loaded.mesh, ports, options.output, options.force);
  for (const std::string& warning : written.warnings) printWarning(warning + ", " + options.output);
  return Done;
}

bool isDicomName(const fs::path& path) { return path.extension() == ".dcm"; }

/// A mask to a DICOM segmentation.
int convertMask(const ConvertOptions& options, const Progress& progress) {
  if (!isDicomName(options.output))
    throw InputError("--like is for DICOM segmentations", options.output,
                     "end the output's name in .dcm, or leave --like out");
  const MaskImage read = readMask(options.input);
  for (const std::string& warning : read.warnings) printWarning(warning);
  progress.check();
  DicomOrigin origin{options.like, options.reading.series, DicomIdentity::None};
  if (options.identity) origin.identity = DicomIdentity::OfSource;
  writeMask(read.mask, origin, options.output);
  progress.report(1.0);
  return Done;
}

int convertVolume(const ConvertOptions& options, const Progress& progress) {
  if (!options.meshOption.empty())
    throw InputError("a volume has no such property", options.meshOption,
                     "leave it out, or end the output's name in " + meshEndings(true));
  if (!options.like.empty()) return convertMask(options, progress);
  if (isDicomName(options.output))
    throw InputError("of DICOM, only segmentations are written", options.output,
                     "name the DICOM series that the mask is of with --like");
  NativeImage native =
      readNative(options.input, options.reading, options.component, progress.sub(0.0, 0.6));
  const std::string replaced = replaceNotFinite(native.volume);
  checkUsable(native.volume, options.input);
  printWarnings(native.info);
  progress.check();
  if (!replaced.empty()) printWarning(replaced);
  writeVolume(native.volume, options.output);
  progress.report(1.0);
  return Done;
}

}  // namespace

void addConvert(CLI::App& program, Session& session) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command =
      program.add_subcommand("convert",
                             "Between volume formats (the pixel type stays), between mesh formats, "
                             "or from a mesh to a case for OpenFOAM");
  command->add_option("INPUT", options->input, "Volume or mesh")->required();
  command
      ->add_option("-o,--output", options->output,
                   "File to write, whose name tells the format, or folder")
      ->required();
  addReading(*command, options->reading);
  command
      ->add_option("--component", options->component,
                   "Of a colour, vector or 4D image: which value of a voxel, or which point in "
                   "time, from 0 on")
      ->check(CLI::NonNegativeNumber);
  CLI::Option* like = command->add_option(
      "--like", options->like,
      "Write a mask as a DICOM segmentation of this DICOM file or folder (of the series --series)");
  command
      ->add_flag("--identity", options->identity,
                 "With --like: copy patient and study, which are left empty otherwise")
      ->needs(like);
  std::vector<CLI::Option*> ofMeshes{
      command->add_option("--unit", options->unit, "Of the mesh to write: mm or m")
          ->check(CLI::IsMember({"mm", "m"})),
      command->add_option("--frame", options->frame, "Of the mesh to write: lps or ras")
          ->check(CLI::IsMember({"lps", "ras"})),
      command
          ->add_option("--from-frame", options->fromFrame,
                       "Of the mesh to read, whatever its header says: lps or ras")
          ->check(CLI::IsMember({"lps", "ras"})),
      command
          ->add_option("--from-unit", options->fromUnit,
                       "Of the mesh to read, whatever its header says: mm or m")
          ->check(CLI::IsMember({"mm", "m"})),
      command->add_flag("--ascii", options->ascii, "Write PLY or STL as text"),
      command->add_flag("--normals", options->normals, "Write the vertices' normals (PLY, VTP)"),
      command->add_flag("--quality", options->quality,
                        "Write each face's radius ratio, 1 if equilateral (PLY, VTP)"),
      command->add_flag("--solid-names", options->solidNames,
                        "Keep the names of solids, groups and faces (patches: inlets, outlets), "
                        "whatever they tell"),
      command->add_flag("--patch-files", options->patchFiles,
                        "Write each patch to a file of its own, too: NAME_PATCH beside NAME")};
  for (CLI::Option* option : addMeshReading(*command, options->meshReading))
    ofMeshes.push_back(option);
  CLI::Option* openFoam = command->add_flag(
      "--openfoam", options->openFoam,
      "Write a folder for OpenFOAM instead: the closed mesh in metres, its patches as wall, inlets "
      "and outlets, and what snappyHexMesh needs");
  for (const char* name :
       {"--unit", "--frame", "--ascii", "--normals", "--quality", "--patch-files"})
    openFoam->excludes(name);
  command->add_flag("--force", options->force,
                    "Replace the input, if the output is the same file; with --openfoam: replace "
                    "the case in the folder");
  command->callback([options, ofMeshes, &session] {
    for (const CLI::Option* option : ofMeshes)
      if (option->count() > 0) options->meshOption = option->get_name();
    session.action = [options, &session] {
      checkOther(*options);
      if (options->openFoam) return convertToOpenFoam(*options, session.progress);
      checkKinds(*options);
      return isMeshName(options->output) ? convertMesh(*options, session.progress)
                                         : convertVolume(*options, session.progress);
    };
  });
}

}  // namespace angiomesh::cli
