// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gui/job/case_store.h"
#include "gui/job/file_jobs.h"
#include "gui/job/known_sources.h"

namespace angiomesh {

/// A case to be opened, and what helps to find its source.
struct CaseRequest {
  std::filesystem::path folder;
  std::shared_ptr<CasePlace> place;  ///< of `folder`, locked already; null: to be made
  KnownSources known;
  std::filesystem::path source;  ///< where the user says that the source is; empty: look for it
  bool restore = false;          ///< the edits in its journal are wanted
};

/// Opens a case off the window's thread: its document, its journal, and its source wherever that
/// is now. A source that is not found is no error: pipeline() is null then.
class OpenCaseJob final : public LoadJob {
 public:
  explicit OpenCaseJob(CaseRequest request);

  [[nodiscard]] const CaseRequest& request() const { return request_; }

  // After execute():
  [[nodiscard]] const SavedCase& document() const { return document_; }
  [[nodiscard]] const std::vector<JournalStep>& steps() const { return steps_; }
  /// Of reading and of the place.
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// Null where the case cannot be kept: it is open elsewhere, or the folder cannot be written to.
  [[nodiscard]] std::shared_ptr<CasePlace> place() const { return place_; }
  /// Where the source was found; empty for the built-in sample.
  [[nodiscard]] const std::filesystem::path& sourcePath() const { return sourcePath_; }
  /// Why CaseRequest::source is not the case's; empty when it was not asked for or is.
  [[nodiscard]] const std::string& difference() const { return difference_; }

 protected:
  Source obtain() override;
  void prepare(Pipeline& pipeline) override;

 private:
  void readFolder();
  Source obtainSample();

  CaseRequest request_;
  SavedCase document_;
  std::vector<JournalStep> steps_;
  std::vector<std::string> warnings_;
  std::shared_ptr<CasePlace> place_;
  std::filesystem::path sourcePath_;
  std::string difference_;
};

}  // namespace angiomesh
