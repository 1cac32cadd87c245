// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/find_source.h"

#include <algorithm>
#include <system_error>

#include "core/base/error.h"
#include "io/scan/label_image.h"
#include "io/volume/geometry_check.h"

namespace angiomesh {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 300;  ///< looked at in one folder

void addEntries(const fs::path& folder, const fs::path& but, std::vector<fs::path>& places) {
  std::vector<fs::path> files, folders;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path == but || path.filename().string().starts_with(".") || isCase(path)) continue;
    std::error_code unreadable;
    if (entry->is_directory(unreadable)) {
      folders.push_back(path);
    } else if (entry->is_regular_file(unreadable)) {
      files.push_back(path);
    }
  }
  for (std::vector<fs::path>* list : {&files, &folders}) {
    std::sort(list->begin(), list->end());
    list->resize(std::min(list->size(), kMostEntries));
    places.insert(places.end(), list->begin(), list->end());
  }
  places.push_back(folder);
}

}  // namespace

std::optional<FoundSource> sourceAt(const fs::path& path, const CaseSource& source,
                                    const Progress& progress, ScanDepth depth) {
  for (const ImageSummary& summary : describeImages(path, progress.sub(0.0, 0.1), depth)) {
    progress.check();
    // The grid of slices that were resampled is known only once they are.
    const Finding* refusal = summary.refusal();
    const bool uneven = refusal != nullptr && canBeEvenedOut(refusal->kind);
    if (!uneven && !sameGrid(summary.geometry, source.grid)) continue;
    const int layers = summary.stack ? 1 : segmentationLayers(path);
    for (int layer = 0; layer < layers; ++layer) {
      FoundSource found;
      found.path = path;
      found.loaded = layers > 1 ? readLayer(path, layer, progress.sub(0.1, 0.9))
                                : readImage(summary, path, uneven, progress.sub(0.1, 0.9));
      found.hash = contentHash(found.loaded.image);
      if (found.hash == source.hash) return found;
    }
  }
  return std::nullopt;
}

std::optional<FoundSource> findSource(const std::vector<fs::path>& places, const CaseSource& source,
                                      const Progress& progress) {
  for (const fs::path& place : places) {
    progress.check();
    try {
      if (std::optional<FoundSource> found = sourceAt(place, source, progress, ScanDepth::Here))
        return found;
    } catch (const Error&) {
      // Most of what lies about is no image.
    } catch (const fs::filesystem_error&) {
      // A folder that may not be looked into.
    }
  }
  return std::nullopt;
}

std::vector<fs::path> placesNear(const fs::path& folder) {
  std::error_code error;
  const fs::path here = fs::absolute(folder, error).lexically_normal();
  const fs::path beside = here.parent_path();
  std::vector<fs::path> places;
  addEntries(beside, here, places);
  if (beside.has_parent_path() && beside.parent_path() != beside)
    addEntries(beside.parent_path(), beside, places);
  return places;
}

}  // namespace angiomesh
