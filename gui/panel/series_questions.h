// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>
#include <optional>
#include <vector>

#include "gui/model/job_runner.h"
#include "io/image_io.h"

class QWidget;

namespace angiomesh {

/// What is asked of a DICOM folder. The window uses dialogs; tests answer at once.
struct SeriesQuestions {
  /// Which one; nothing: none of them.
  std::function<std::optional<std::size_t>(QWidget*, const std::vector<ImageSummary>&,
                                           const JobRunnerFactory&)>
      choose;
  /// True: resample the slices.
  std::function<bool(QWidget*, const QString& reason)> resample;
};
SeriesQuestions dialogSeriesQuestions();

}  // namespace angiomesh
