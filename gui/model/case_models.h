// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "gui/model/case_corrections.h"
#include "gui/model/case_files.h"
#include "gui/model/exports.h"
#include "gui/model/live_preview.h"
#include "gui/model/preset_shelf.h"

namespace angiomesh {

/// The models of the open case. All work runs on workers and is looked at 30 times a second by one
/// timer; nothing here blocks, and nothing goes through a volume.
struct CaseModels {
  explicit CaseModels(const JobRunnerFactory& makeRunner = makeThreadedJobRunner,
                      const std::filesystem::path& recovery = {});

  MessageLog log;
  JobTimer timer;
  CaseDocument document;
  PresetShelf presets;
  ResultModel results;
  RunModel runs;
  LivePreview live;
  CaseFiles files;
  Exports exports;
  CaseCorrections corrections;

  /// Whether any work is on.
  [[nodiscard]] bool busy() const;
  /// Ends the load and the run that are on.
  void cancel();
};

}  // namespace angiomesh
