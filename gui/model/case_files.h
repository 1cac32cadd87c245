// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "gui/job/case_store.h"
#include "gui/job/file_jobs.h"
#include "gui/job/open_case_job.h"
#include "gui/model/preset_shelf.h"
#include "gui/model/run_model.h"

namespace angiomesh {

/// Opens volumes and cases, keeps the open case on the disk, and gives back after a crash what was
/// not saved.
class CaseFiles : public QObject, private Polled {
  Q_OBJECT

 public:
  /// @param recovery the folder for the edits of cases that were never saved; empty: they are not
  /// kept
  CaseFiles(CaseDocument& document, PresetShelf& presets, ResultModel& results, RunModel& runs,
            MessageLog& log, JobTimer& timer, const JobRunnerFactory& makeRunner,
            const std::filesystem::path& recovery, QObject* parent = nullptr);
  /// Edits stay on the disk as after a crash: see leaveCase().
  ~CaseFiles() override;

  // Volumes.
  void open(const QString& path);
  /// Loads a volume that seriesFound() listed; `evenOut`: missing or uneven slices are resampled.
  void openSeries(const QString& path, const ImageSummary& entry, bool evenOut);
  /// Loads a label that labelsFound() listed; nothing: the file is a scan after all.
  void openLabel(const QString& path, const std::optional<Label>& label);
  void openSample();
  /// Takes a source that is at hand already.
  void take(Source source);
  [[nodiscard]] bool loading() const { return static_cast<bool>(slot_); }
  [[nodiscard]] double loadFraction() const {
    return slot_ ? slot_.job()->progress().fraction() : 0.0;
  }
  void cancelLoad();
  /// Where the volume of the open case lies, if it is a DICOM series; without its identity.
  [[nodiscard]] std::optional<DicomOrigin> dicomOrigin() const;

  // Cases on the disk.
  /// One of caseFound(), sourceMissing() and sourceDiffers() follows, or a message.
  void openCase(CaseRequest request);
  /// After sourceMissing() or sourceDiffers(): look at `path`; open its volume with the parameters
  /// of the case only, without places; or let the case be.
  void giveSource(const QString& path);
  void takeParametersOnly();
  void giveUpCase() { pending_.reset(); }
  /// caseSaved() or caseNotSaved() follows. @param view what the window shows
  void saveCase(const QString& folder, const CaseView& view);
  /// Empty: the case was never saved.
  [[nodiscard]] QString caseFolder() const;
  [[nodiscard]] bool saving() const { return store_.saving(); }
  /// Whether something is being written.
  [[nodiscard]] bool storing() const { return store_.busy(); }
  /// After editsFound(): makes those edits again, each one undoable, or does away with them.
  void restoreEdits();
  void forgetEdits();
  /// A clean end: nothing is kept for a restore.
  void leaveCase();

 Q_SIGNALS:
  void caseChanged();
  void loadingChanged();
  /// The folder holds several volumes: openSeries() takes one.
  void seriesFound(const QString& path, const std::vector<ImageSummary>& entries);
  /// Slices are missing or uneven: openSeries() with `evenOut`, or leave it.
  void unevenFound(const QString& path, const ImageSummary& entry, const QString& reason);
  /// A segmentation with several labels: openLabel() takes one.
  void labelsFound(const QString& path, const std::vector<Label>& labels, double voxelMm3);
  void opened(const QString& path);                 ///< a file or folder was loaded
  void sourceSeen(const QString& path);             ///< where the volume of the open case lies
  void caseFound(const angiomesh::CaseView& view);  ///< a case was opened, and looked like this
  void sourceMissing(const QString& what);          ///< the case's volume, in words
  void sourceDiffers(const QString& reason);
  void editsFound(int count);  ///< since the last save of the case opened, after a crash
  void caseSaved(const QString& folder);
  void caseNotSaved();

 private:
  void startLoad(std::shared_ptr<LoadJob> job);
  void finishLoad(const std::shared_ptr<LoadJob>& job);
  void takeVolume(const LoadJob& job);
  /// Nothing of another patient's: a preset, or what was chosen before there was any volume.
  [[nodiscard]] Parameters parametersToBegin(const LoadJob& job);
  void takeCase(const std::shared_ptr<const OpenCaseJob>& job);
  void begin(const LoadJob& job, const QString& name, const Parameters& params,
             const CaseNotes& notes = {});
  void announce();
  void sayOpened(const InputInfo& info);
  void sayLabel(const Label& label);
  void noteEdit();
  void cacheEvolve();
  bool poll() override;
  void takeOutcome(const CaseStore::Outcome& outcome);
  [[nodiscard]] CaseSource describeSource() const;

  CaseDocument& document_;
  PresetShelf& presets_;
  ResultModel& results_;
  RunModel& runs_;
  MessageLog& log_;
  JobTimer& timer_;
  CaseStore store_;
  InputInfo info_;  ///< of the source
  std::filesystem::path sourcePath_;
  std::vector<JournalStep> foundSteps_;
  bool restoring_ = false;                      ///< edits come from the journal
  bool noteFailed_ = false;                     ///< and the user knows
  std::shared_ptr<const OpenCaseJob> pending_;  ///< without a source so far
  std::shared_ptr<LoadJob> next_;
  JobSlot<LoadJob> slot_;
};

}  // namespace angiomesh
