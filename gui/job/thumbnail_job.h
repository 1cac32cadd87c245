// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <mutex>
#include <utility>
#include <vector>

#include "core/image/projection.h"
#include "io/volume/loaded_image.h"

namespace angiomesh {

/// Makes the thumbnails of a list of volumes off the window's thread, one after the other.
class ThumbnailJob {
 public:
  ThumbnailJob(std::vector<ImageSummary> entries, int size)
      : entries_(std::move(entries)), size_(size) {}

  void execute() noexcept;
  void cancel() { cancelled_ = true; }

  /// Row and picture of what has arrived since the last call.
  std::vector<std::pair<int, Picture>> take();

 private:
  std::vector<ImageSummary> entries_;
  int size_;
  std::atomic<bool> cancelled_{false};
  std::mutex mutex_;
  std::vector<std::pair<int, Picture>> made_;  ///< guarded by mutex_
};

}  // namespace angiomesh
