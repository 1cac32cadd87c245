// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/image/volume.h"
#include "core/parameters/parameters.h"
#include "io/case/case_notes.h"

namespace angiomesh {

/// The newest schema of case.json that this program reads, and the one that it writes.
constexpr int kCaseSchema = 1;

/// What a case says of its source: enough to know it again wherever it lies. Never a name, a path
/// or anything else that may tell the patient.
struct CaseSource {
  std::string hash;    ///< Source::hash
  std::string format;  ///< InputInfo::format; "phantom" for the built-in sample
  int files = 1;       ///< more than one for a DICOM series
  Geometry grid;
};

/// A pane's slab.
struct CaseSlab {
  std::string mode;
  double thicknessMm = 10.0;

  bool operator==(const CaseSlab&) const = default;
};

/// How the slice planes lie.
struct CasePlanes {
  bool patientAxes = false;
  /// By pane: the rows of the rotation from where its plane began.
  std::map<std::string, std::array<double, 9>> turns;
  std::array<double, 3> pivotMm{0.0, 0.0, 0.0};  ///< LPS

  bool operator==(const CasePlanes&) const = default;
};

/// What the window showed and how, in words of its own; absent in cases from elsewhere.
struct CaseView {
  std::string layer;
  std::map<std::string, std::array<double, 2>> windowLevels;  ///< by layer
  std::map<std::string, CaseSlab> slabs;  ///< by pane: "sagittal", "coronal", "axial"
  std::string overlay;                    ///< a layer in colour over the one shown; empty: none
  double overlayOpacity = 0.5;
  std::optional<CasePlanes> planes;  ///< empty where they lie along the image
  std::optional<Eigen::Vector3d> crosshairLps;
  std::map<std::string, bool> shown;  ///< "contours", "surface", ...
  std::string mesh, colour;
};

/// case.json. Seeds, region of interest and dropped parts are among the parameters.
struct SavedCase {
  CaseSource source;
  Parameters params;
  CaseNotes notes;
  CaseView view;
  int saves =
      0;  ///< how many times it was saved; the journal's steps say after which one they came
};

struct CaseReading {
  SavedCase document;
  std::vector<std::string> warnings;
};

/// Whether a case lies at `folder`: by its case.json, or by the name NAME.angiomesh of a folder.
bool isCase(const std::filesystem::path& folder);

/// The case's folder for the folder itself and for its case.json; any other path as it is.
std::filesystem::path caseFolder(const std::filesystem::path& path);

/// Writes case.json into `folder`, which is made when there is none; the one before stays as
/// case.previous.json. Whenever the program ends, the folder holds a case that opens, or no case.
/// @throws IoError (no such place, disk full, a folder with other files): what was there stays
void writeCase(const std::filesystem::path& folder, const SavedCase& document);

/// Reads case.json, or case.previous.json where that one is missing or damaged, or else the last
/// edit in the journal, with a warning. Parameters that the file does not name have their defaults;
/// those that this program does not know or cannot use are left out, with a warning, and so are
/// notes that it cannot read. What a program that was killed had begun to write in the folder is
/// removed.
/// @throws IoError (no case, damaged, a link among its files), InputError (a newer schema)
CaseReading readCase(const std::filesystem::path& folder);

/// The source as the case's files say it, in JSON; empty where they do not.
std::string caseSourceText(const std::filesystem::path& folder);

}  // namespace angiomesh
