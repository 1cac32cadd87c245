// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <set>
#include <system_error>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/dicom/dicom_series.h"
#include "io/file/open_file.h"
#include "io/file/text_scanner.h"
#include "io/volume/image_format.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

const char* const kDamagedAdvice = "copy the file again, or take it out of the folder";

void prepareDcmtk() {
  // DCMTK logs to the terminal; what matters comes back as a status.
  static const bool ready = [] {
    OFLog::configure(OFLogger::OFF_LOG_LEVEL);
    // Archives that turn implicit into explicit files may mark known elements as unknown ones.
    dcmEnableUnknownVRConversion.set(OFTrue);
    return true;
  }();
  static_cast<void>(ready);
}

/// What file systems and desktops keep for themselves, and often from others.
bool isOfTheSystem(const fs::path& folder) {
  static const std::set<std::string> names = {"lost+found", "System Volume Information",
                                              "$RECYCLE.BIN"};
  return names.count(folder.filename().string()) != 0;
}

/// The files of a folder, and below it, sorted; links that lead nowhere among them. Links to
/// folders are not followed: they may go round in circles.
std::vector<fs::path> filesIn(const fs::path& folder, ScanDepth depth, const Progress& progress) {
  std::error_code error;
  std::vector<fs::path> files;
  fs::path at = folder;  // the folder that is opened next
  fs::recursive_directory_iterator entry(folder, error);
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    progress.check();
    std::error_code unknown;
    const fs::file_type type = entry->status(unknown).type();
    const bool isFolder = entry->is_directory(unknown) && !entry->is_symlink(unknown);
    if (isFolder) at = entry->path();
    if (depth == ScanDepth::Here || (isFolder && isOfTheSystem(at)))
      entry.disable_recursion_pending();
    const bool exists = type != fs::file_type::not_found;
    if (exists && unknown) throwNotOpened(entry->path().filename().string(), unknown.value());
    if (type == fs::file_type::regular || !exists) files.push_back(entry->path());
  }
  if (error) throwNotOpened(at.string(), error.value());
  std::sort(files.begin(), files.end());
  return files;
}

struct ScannedFile {
  DicomSeries series;  ///< of this file alone
  HeaderResult result;
  bool misnamed = false;
};

std::vector<ScannedFile> readHeaders(const std::vector<fs::path>& files, const Progress& progress) {
  std::vector<ScannedFile> scanned(files.size());
  std::atomic<std::size_t> done{0};
  parallelFor(0, files.size(), 8, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const std::string extension = inSmall(files[i].extension().string());
      std::error_code error;
      if (!fs::exists(files[i], error))
        scanned[i].result.damage = "a link leads to no file";
      else if (looksLikeDicom(files[i]))
        scanned[i].result = readDicomHeader(files[i], scanned[i].series);
      else
        scanned[i].misnamed = extension == ".dcm";
    }
    done += last - first;
    progress.report(static_cast<double>(done) / static_cast<double>(files.size()));
  });
  return scanned;
}

void append(DicomSeries& to, DicomSeries&& from) {
  if (to.files.empty() && to.findings.empty()) {
    std::vector<Finding> findings = std::move(from.findings);
    to = std::move(from);
    to.findings = std::move(findings);
    return;
  }
  for (DicomFrame& frame : from.frames) {
    frame.file += to.files.size();
    to.frames.push_back(std::move(frame));
  }
  for (DicomFile& file : from.files) to.files.push_back(std::move(file));
}

Finding damageOf(const fs::path& file, const std::string& damage) {
  return {FindingKind::DamagedFile, true, damage, {}, file.filename().string()};
}

/// Where the header of a damaged file does not say any more what it belonged to, it may have been a
/// slice of any series beside it.
void addDamage(const fs::path& file, const ScannedFile& scanned,
               std::map<std::string, DicomSeries>& all) {
  const Finding finding = damageOf(file, scanned.result.damage);
  if (scanned.result.knowsSeries) {
    DicomSeries& own = all[scanned.series.uid];
    if (own.files.empty() && own.findings.empty()) own = scanned.series;
    own.findings.push_back(finding);
    return;
  }
  for (auto& [uid, series] : all)
    if (std::any_of(series.files.begin(), series.files.end(), [&](const DicomFile& other) {
          return other.path.parent_path() == file.parent_path();
        }))
      series.findings.push_back(finding);
}

std::vector<DicomSeries> scanFolder(const fs::path& folder, const Progress& progress,
                                    ScanDepth depth, std::vector<std::string>& warnings) {
  const std::vector<fs::path> files = filesIn(folder, depth, progress);
  std::vector<ScannedFile> scanned = readHeaders(files, progress);
  std::map<std::string, DicomSeries> all;
  std::size_t misnamed = 0;
  for (ScannedFile& one : scanned) {
    misnamed += one.misnamed ? 1 : 0;
    if (one.result.image) append(all[one.series.uid], std::move(one.series));
  }
  for (std::size_t i = 0; i < files.size(); ++i)
    if (!scanned[i].result.damage.empty()) {
      if (all.empty() && !scanned[i].result.knowsSeries)
        throw IoError(scanned[i].result.damage, files[i].filename().string(), kDamagedAdvice);
      addDamage(files[i], scanned[i], all);
    }
  if (misnamed > 0)
    warnings.push_back(std::to_string(misnamed) +
                       " files named .dcm are not DICOM or empty and were left out");
  std::vector<DicomSeries> result;
  result.reserve(all.size());
  for (auto& [uid, series] : all) result.push_back(std::move(series));
  return result;
}

}  // namespace

std::string kindWithoutImage(const fs::path& path) {
  prepareDcmtk();
  DicomSeries none;
  return readDicomHeader(path, none).kind;
}

std::vector<DicomSeries> scanDicom(const fs::path& path, const Progress& progress, ScanDepth depth,
                                   std::vector<std::string>& warnings) {
  prepareDcmtk();
  std::error_code error;
  if (fs::is_directory(path, error)) return scanFolder(path, progress, depth, warnings);
  DicomSeries series;
  const HeaderResult result = readDicomHeader(path, series);
  if (!result.damage.empty())
    throw IoError(result.damage, path.filename().string(), "copy the file again");
  if (!result.image) return {};
  return {std::move(series)};
}

}  // namespace angiomesh
