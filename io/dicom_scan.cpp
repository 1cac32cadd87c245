// SPDX-License-Identifier: BSD-3-Clause
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <system_error>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "io/dicom_series.h"
#include "io/image_format.h"

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

/// The regular files of a folder, and below it, sorted. Links to folders are not followed: they may
/// go round in circles.
std::vector<fs::path> filesIn(const fs::path& folder, ScanDepth depth, const Progress& progress) {
  std::error_code error;
  std::vector<fs::path> files;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                         error);
  for (const fs::recursive_directory_iterator end; !error && entry != end; entry.increment(error)) {
    progress.check();
    std::error_code ignored;
    if (depth == ScanDepth::Here) entry.disable_recursion_pending();
    if (entry->is_regular_file(ignored)) files.push_back(entry->path());
  }
  if (error)
    throw IoError("cannot read the folder (" + error.message() + ")", folder.string(),
                  "check the permissions");
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
      const std::string extension = files[i].extension().string();
      if (looksLikeDicom(files[i]))
        scanned[i].result = readDicomHeader(files[i], scanned[i].series);
      else
        scanned[i].misnamed = extension == ".dcm" || extension == ".DCM";
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
