// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/parameters/parameters.h"
#include "io/case/case_notes.h"

namespace angiomesh {

/// One edit of a case as its journal keeps it: one line of edits/journal.jsonl.
struct JournalStep {
  int saves = 0;      ///< SavedCase::saves at the time of the edit
  int position = 0;   ///< in the undo stack, after the edit
  std::string text;   ///< "change levelset.xi"
  Parameters params;  ///< after the edit
  CaseNotes notes;    ///< likewise
};

/// Adds steps to the end of the case's journal and forces them to the medium. A long journal is
/// cut to its last steps. @throws IoError: the journal is as before
void appendJournal(const std::filesystem::path& folder, const std::vector<JournalStep>& steps);

/// The steps that came after the save number `saves`, oldest first; of several in a row that
/// changed one edit, as a slider does, the last one. A line that was not written whole is left out.
std::vector<JournalStep> readJournal(const std::filesystem::path& folder, int saves);

/// The case's source as the journal's first line has it, in JSON, so that a case whose other files
/// are damaged is known by its journal; empty where it does not say.
std::string journalSource(const std::filesystem::path& folder);

/// Nothing happens where there is none.
void removeJournal(const std::filesystem::path& folder);

}  // namespace angiomesh
