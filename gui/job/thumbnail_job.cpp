// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/thumbnail_job.h"
#include "io/dicom/dicom.h"

#include <exception>

namespace angiomesh {

void ThumbnailJob::execute() noexcept {
  for (std::size_t i = 0; i < entries_.size() && !cancelled_; ++i) {
    try {
      Picture picture = thumbnail(entries_[i], size_);
      if (picture.width == 0) continue;
      const std::lock_guard lock(mutex_);
      made_.emplace_back(static_cast<int>(i), std::move(picture));
    } catch (const std::exception&) {
      // A row without a picture is still a row.
    }
  }
}

std::vector<std::pair<int, Picture>> ThumbnailJob::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(made_, {});
}

}  // namespace angiomesh
