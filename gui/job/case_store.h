// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <deque>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gui/job/job_runner.h"
#include "io/case/case_cache.h"
#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "io/file/file_lock.h"

namespace angiomesh {

/// The folder of an open case, locked against other windows while the object lives. Its lock and
/// its files belong to the worker.
struct CasePlace {
  std::filesystem::path folder;
  bool recovery = false;           ///< of a case without a folder of its own
  std::unique_ptr<FileLock> lock;  ///< null until the folder is there
};
enum class LockEnd { Locked, InUse, Impossible };
LockEnd lockPlace(CasePlace& place);

/// What a program that ended without a word left of a case that was never saved.
struct Recovery {
  std::shared_ptr<CasePlace> place;
  std::filesystem::file_time_type changed;
  std::size_t steps = 0;
  std::string source;  ///< CaseSource::hash
};
/// The recoveries in `root` that no running program holds, the latest first. Those without an edit
/// are removed.
std::vector<Recovery> findRecoveries(const std::filesystem::path& root);
/// For good.
void removeRecovery(CasePlace& place);

/// Keeps the open case on the disk, off the window's thread and in the order of the calls: saves,
/// and the journal of the edits since. Until a case has a folder, its journal lies in a recovery
/// folder of its own, which a clean end removes. What happened is told by poll().
class CaseStore {
 public:
  struct Outcome {
    enum class Kind { Saved, NotSaved, NotNoted } kind = Kind::Saved;
    std::filesystem::path folder;
    SavedCase document;  ///< as saved
    std::string error;
    bool present = true;  ///< the case is still the one that was saved
  };

  /// @param recoveryRoot empty: cases without a folder have no journal
  CaseStore(const JobRunnerFactory& makeRunner, std::filesystem::path recoveryRoot);
  /// Waits for what was asked for, and leaves the disk as a crash would: see leave().
  ~CaseStore();

  /// @param start the case as it is on the disk, or as a case without a folder begins
  /// @param place where it lies; null: nowhere yet
  void begin(SavedCase start, std::shared_ptr<CasePlace> place);
  [[nodiscard]] bool begun() const { return begun_; }
  /// Of the case; empty: it was never saved.
  [[nodiscard]] std::filesystem::path folder() const;

  void note(JournalStep step);
  /// The edits on the disk are not wanted.
  void forgetEdits();
  void save(const std::filesystem::path& folder, SavedCase document);
  /// Keeps a result in the case's folder, if it has one. A failure is no loss and not told.
  void cache(CachedEvolve evolve);
  /// The clean end of the case: what was not saved is not kept.
  void leave();

  [[nodiscard]] bool saving() const;
  [[nodiscard]] bool busy() const {
    return current_ || !queue_.empty() || waitingCache_ || cacheRunner_->running();
  }
  std::vector<Outcome> poll();

 private:
  struct Task;
  void add(std::shared_ptr<Task> task);
  void startNext();
  void finish();
  void startCache();

  std::unique_ptr<JobRunner> runner_;
  /// Packing a volume takes seconds, and edits must not wait for it.
  std::unique_ptr<JobRunner> cacheRunner_;
  std::shared_ptr<Task> waitingCache_;
  std::filesystem::path recoveryRoot_;
  bool begun_ = false;
  int generation_ = 0;  ///< of the case: what an earlier one asked for changes nothing here
  int saves_ = 0;
  std::shared_ptr<const SavedCase> start_;
  std::shared_ptr<CasePlace> place_;
  std::shared_ptr<Task> current_;
  std::deque<std::shared_ptr<Task>> queue_;
  std::vector<Outcome> outcomes_;
};

}  // namespace angiomesh
