// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/picture_jobs.h"

#include <exception>
#include <vector>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "gui/job/file_jobs.h"
#include "io/file/files.h"

namespace angiomesh {

namespace {

std::string nameOf(int number) { return formatted("%03d.png", number); }

/// Without what Qt may add to a file: size and pixels alone.
Picture pixelsOf(const QImage& image) {
  const QImage rgb = image.convertToFormat(QImage::Format_RGB888);
  Picture picture;
  picture.width = rgb.width();
  picture.height = rgb.height();
  for (int row = 0; row < rgb.height(); ++row) {
    const uchar* line = rgb.constScanLine(row);
    picture.rgb.insert(picture.rgb.end(), line,
                       line + 3 * static_cast<std::ptrdiff_t>(rgb.width()));
  }
  return picture;
}

}  // namespace

void PictureJob::execute() noexcept {
  const std::filesystem::path& place = turntable ? turntable->path : path;
  try {
    if (turntable)
      addToTurntable();
    else
      writePng(pixelsOf(picture), path);
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), place, place.filename().string());
    if (turntable) turntable->staged.reset();
  }
}

void PictureJob::addToTurntable() {
  std::optional<StagedFolder>& staged = turntable->staged;
  if (number == 0) {
    staged.reset();
    return;
  }
  if (!staged) {
    std::error_code none;
    if (std::filesystem::exists(turntable->path, none))
      throw InputError("there is such a folder already", turntable->path.string(),
                       "choose another name");
    std::vector<std::string> names;
    for (int n = 1; n <= turntable->count; ++n) names.push_back(nameOf(n));
    staged.emplace(turntable->path, std::move(names), false);
  }
  staged->add(nameOf(number),
              [this](const std::filesystem::path& file) { writePng(pixelsOf(picture), file); });
  if (number < turntable->count) return;
  staged->commit();
  staged.reset();
}

}  // namespace angiomesh
