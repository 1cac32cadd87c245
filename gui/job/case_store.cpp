// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/case_store.h"

#include <QUuid>
#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "core/base/error.h"

namespace angiomesh {

namespace {

namespace fs = std::filesystem;

/// As at a clean end: a recovery goes, a case keeps its last save alone.
void leavePlace(CasePlace& place) {
  if (place.recovery) {
    removeRecovery(place);
  } else {
    removeJournal(place.folder);
    place.lock.reset();
  }
}

/// Extension of a recovery that is being removed.
constexpr const char* kRemoved = ".removed";

/// A recovery without an edit, of a program that was killed before its first one; but for one that
/// another program may be making just now.
void removeUnused(CasePlace& place) {
  std::error_code error;
  const auto made = fs::last_write_time(place.folder / "case.json", error);
  if (!error && fs::file_time_type::clock::now() - made > std::chrono::minutes(1))
    removeRecovery(place);
}

/// The recovery folders are for the user alone.
void makeRoot(const fs::path& root) {
  std::error_code error;
  fs::create_directories(root, error);
  fs::permissions(root, fs::perms::owner_all, error);
}

}  // namespace

LockEnd lockPlace(CasePlace& place) {
  if (place.lock) return LockEnd::Locked;
  auto lock = std::make_unique<FileLock>(place.folder / "case.lock");
  if (lock->state() != FileLock::State::Held)
    return lock->state() == FileLock::State::Taken ? LockEnd::InUse : LockEnd::Impossible;
  place.lock = std::move(lock);
  return LockEnd::Locked;
}

std::vector<Recovery> findRecoveries(const fs::path& root) {
  std::vector<Recovery> found;
  std::error_code error;
  for (fs::directory_iterator entry(root, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == kRemoved) {
      std::error_code ignored;
      fs::remove_all(entry->path(), ignored);
    }
    if (entry->path().extension() != ".angiomesh") continue;
    Recovery recovery;
    recovery.place = std::make_shared<CasePlace>();
    recovery.place->folder = entry->path();
    recovery.place->recovery = true;
    if (lockPlace(*recovery.place) != LockEnd::Locked) continue;
    try {
      const CaseReading reading = readCase(entry->path());
      recovery.steps = readJournal(entry->path(), reading.document.saves).size();
      if (recovery.steps == 0) {
        removeUnused(*recovery.place);
        continue;
      }
      recovery.source = reading.document.source.hash;
      recovery.changed = fs::last_write_time(entry->path() / "edits" / "journal.jsonl");
    } catch (const std::exception&) {
      // Left alone: a newer program may know what to do with it.
      continue;
    }
    found.push_back(std::move(recovery));
  }
  std::sort(found.begin(), found.end(),
            [](const Recovery& a, const Recovery& b) { return a.changed > b.changed; });
  return found;
}

void removeRecovery(CasePlace& place) {
  // A program that is killed here leaves no half of a case.
  fs::path gone = place.folder;
  gone += kRemoved;
  std::error_code error;
  fs::rename(place.folder, gone, error);
  place.lock.reset();
  fs::remove_all(error ? place.folder : gone, error);
}

/// One thing to do on the worker, with all that it needs.
struct CaseStore::Task {
  enum class Kind { Note, Forget, Save, Cache, Leave } kind = Kind::Note;
  int generation = 0;
  std::vector<JournalStep> steps;
  std::shared_ptr<const SavedCase> start;
  SavedCase document;                ///< of a save
  CachedEvolve evolve;               ///< of a cache
  std::shared_ptr<CasePlace> place;  ///< where to do it
  std::shared_ptr<CasePlace> left;   ///< by a save elsewhere
  std::string error;

  void execute() noexcept {
    try {
      switch (kind) {
        case Kind::Note:
          note();
          break;
        case Kind::Forget:
          removeJournal(place->folder);
          break;
        case Kind::Save:
          save();
          break;
        case Kind::Cache:
          writeCache(place->folder, evolve);
          break;
        case Kind::Leave:
          leavePlace(*place);
          break;
      }
    } catch (const std::exception& failure) {
      error = failure.what();
    }
  }

  void note() const {
    if (place->recovery && !place->lock) {
      makeRoot(place->folder.parent_path());
      writeCase(place->folder, *start);
      lockPlace(*place);
    }
    appendJournal(place->folder, steps);
  }

  void save() const {
    std::error_code ignored;
    if (fs::is_directory(place->folder, ignored) && lockPlace(*place) == LockEnd::InUse) {
      throw IoError("the case is open in another window", place->folder.string(),
                    "close it there or save under another name");
    }
    try {
      writeCase(place->folder, document);
    } catch (...) {
      if (left != place) place->lock.reset();
      throw;
    }
    lockPlace(*place);
    removeJournal(place->folder);
    if (left && left != place) leavePlace(*left);
  }
};

CaseStore::CaseStore(const JobRunnerFactory& makeRunner, fs::path recoveryRoot)
    : runner_(makeRunner()), cacheRunner_(makeRunner()), recoveryRoot_(std::move(recoveryRoot)) {}

CaseStore::~CaseStore() {
  while (current_) {
    runner_->wait();
    finish();
    startNext();
  }
  cacheRunner_->wait();
}

fs::path CaseStore::folder() const {
  return place_ && !place_->recovery ? place_->folder : fs::path();
}

void CaseStore::begin(SavedCase start, std::shared_ptr<CasePlace> place) {
  begun_ = true;
  ++generation_;
  saves_ = start.saves;
  start_ = std::make_shared<const SavedCase>(std::move(start));
  place_ = std::move(place);
}

void CaseStore::note(JournalStep step) {
  if (!begun_ || (!place_ && recoveryRoot_.empty())) return;
  step.saves = saves_;
  if (!queue_.empty() && queue_.back()->kind == Task::Kind::Note &&
      queue_.back()->generation == generation_) {
    std::vector<JournalStep>& waiting = queue_.back()->steps;
    const JournalStep& last = waiting.back();
    if (last.position == step.position && last.text == step.text && last.saves == step.saves)
      waiting.pop_back();
    waiting.push_back(std::move(step));
    return;
  }
  const auto task = std::make_shared<Task>();
  task->kind = Task::Kind::Note;
  task->steps = {std::move(step)};
  add(task);
}

void CaseStore::forgetEdits() {
  if (!place_) return;
  const auto task = std::make_shared<Task>();
  task->kind = Task::Kind::Forget;
  task->place = place_;
  add(task);
}

void CaseStore::save(const fs::path& folder, SavedCase document) {
  const auto task = std::make_shared<Task>();
  task->kind = Task::Kind::Save;
  task->document = std::move(document);
  task->document.saves = ++saves_;
  task->place = std::make_shared<CasePlace>();
  task->place->folder = folder;
  add(task);
}

void CaseStore::cache(CachedEvolve evolve) {
  if (!begun_) return;
  const auto task = std::make_shared<Task>();
  task->kind = Task::Kind::Cache;
  task->evolve = std::move(evolve);
  add(task);
}

void CaseStore::leave() {
  if (!begun_) return;
  begun_ = false;
  queue_.erase(std::remove_if(queue_.begin(), queue_.end(),
                              [](const auto& task) { return task->kind == Task::Kind::Note; }),
               queue_.end());
  if (place_) {
    const auto task = std::make_shared<Task>();
    task->kind = Task::Kind::Leave;
    task->place = place_;
    add(task);
  }
  ++generation_;
  place_.reset();
  start_.reset();
}

bool CaseStore::saving() const {
  const auto saves = [](const std::shared_ptr<Task>& task) {
    return task->kind == Task::Kind::Save;
  };
  return (current_ && saves(current_)) || std::any_of(queue_.begin(), queue_.end(), saves);
}

void CaseStore::add(std::shared_ptr<Task> task) {
  task->generation = generation_;
  task->start = start_;
  queue_.push_back(std::move(task));
  startNext();
}

void CaseStore::startNext() {
  while (!current_ && !queue_.empty()) {
    current_ = std::move(queue_.front());
    queue_.pop_front();
    Task& task = *current_;
    // Only now it is known where a save before this task has put the case.
    if (task.kind == Task::Kind::Note) {
      if (!place_) {
        place_ = std::make_shared<CasePlace>();
        place_->recovery = true;
        place_->folder =
            recoveryRoot_ /
            (QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString() + ".angiomesh");
      }
      task.place = place_;
    } else if (task.kind == Task::Kind::Cache) {
      const std::shared_ptr<Task> cache = std::exchange(current_, nullptr);
      if (cache->generation == generation_ && place_ && !place_->recovery) {
        cache->place = place_;
        waitingCache_ = cache;
        startCache();
      }
      continue;
    } else if (task.kind == Task::Kind::Save && task.generation == generation_) {
      task.left = place_;
      if (place_ && !place_->recovery && place_->folder == task.place->folder) task.place = place_;
    }
    runner_->start([job = current_] { job->execute(); });
    if (!runner_->running()) finish();
  }
}

void CaseStore::startCache() {
  if (waitingCache_ && !cacheRunner_->running())
    cacheRunner_->start([job = std::exchange(waitingCache_, nullptr)] { job->execute(); });
}

void CaseStore::finish() {
  const std::shared_ptr<Task> task = std::exchange(current_, nullptr);
  const bool present = task->generation == generation_;
  if (task->kind == Task::Kind::Save) {
    if (task->error.empty() && present) {
      place_ = task->place;
      start_ = std::make_shared<const SavedCase>(task->document);
    }
    outcomes_.push_back({task->error.empty() ? Outcome::Kind::Saved : Outcome::Kind::NotSaved,
                         task->place->folder, task->document, task->error, present});
  } else if (task->kind == Task::Kind::Note && !task->error.empty() && present) {
    outcomes_.push_back({Outcome::Kind::NotNoted, task->place->folder, {}, task->error, true});
  }
}

std::vector<CaseStore::Outcome> CaseStore::poll() {
  if (current_ && !runner_->running()) {
    finish();
    startNext();
  }
  startCache();
  return std::exchange(outcomes_, {});
}

}  // namespace angiomesh
