// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "gui/job/job_runner.h"
#include "io/scan/image_io.h"
#include "io/scan/label_image.h"

class QWidget;

namespace angiomesh {

/// Nothing: the image is a scan.
using LabelAnswer = std::optional<std::size_t>;

/// What is asked about a folder or a file that is being opened. The window uses dialogs; tests
/// answer at once.
struct OpenQuestions {
  /// Which volume of a DICOM folder; nothing: none of them.
  std::function<std::optional<std::size_t>(QWidget*, const std::vector<ImageSummary>&,
                                           const JobRunnerFactory&)>
      choose;
  /// True: resample the slices.
  std::function<bool(QWidget*, const QString& reason)> resample;
  /// Which label of a segmentation, or that it is a scan; nothing: do not open it.
  std::function<std::optional<LabelAnswer>(QWidget*, const std::vector<Label>&, double voxelMm3)>
      label;
};
OpenQuestions dialogOpenQuestions();

}  // namespace angiomesh
