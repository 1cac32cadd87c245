// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <limits>

#include "core/parameters/field.h"
#include "fuzz/fuzz_parameters.h"
#include "io/case/case_file.h"
#include "io/case/case_journal.h"
#include "io/file/files.h"

namespace angiomesh::fuzz {

inline bool same(const JournalStep& a, const JournalStep& b) {
  return a.saves == b.saves && a.position == b.position && a.text == b.text &&
         parametersToJson(a.params) == parametersToJson(b.params) && a.notes == b.notes;
}

/// The document comes back without a warning from what is written of it into `folder`.
inline void checkSave(const std::filesystem::path& folder, const SavedCase& document,
                      const std::filesystem::path& other) {
  writeCase(folder, document);
  const CaseReading back = readCase(folder);
  expect(back.warnings.empty(), "a case that was just saved opens with a warning");
  writeCase(other, back.document);
  expect(readText(folder / "case.json") == readText(other / "case.json"),
         "another case after saving and opening");
  std::filesystem::remove_all(other);
}

/// The edits come back from what is noted of them in `folder`: the last ones, where they are many.
inline void checkNotes(const std::filesystem::path& folder, const std::vector<JournalStep>& steps,
                       int saves) {
  appendJournal(folder, steps);
  const std::vector<JournalStep> back = readJournal(folder, saves);
  expect(!back.empty() && back.size() <= steps.size(), "edits were lost");
  for (std::size_t n = 1; n <= back.size(); ++n)
    expect(same(back[back.size() - n], steps[steps.size() - n]), "another edit in the journal");
}

/// What the desktop does with a case: it takes the edits of its journal, notes another one and
/// saves all of it again, in its place and elsewhere.
inline void workOn(const InputFolder& folder, SavedCase document) {
  const std::filesystem::path given = folder / "given.angiomesh", other = folder / "o.angiomesh";
  checkParameters(document.params);
  std::vector<JournalStep> steps = readJournal(given, document.saves);
  for (const JournalStep& step : steps) {
    expect(step.saves >= document.saves, "an edit from before the save");
    checkParameters(step.params);
  }
  const std::filesystem::path copy = folder / "copy.angiomesh";
  checkSave(copy, document, other);
  if (!steps.empty()) {
    checkNotes(copy, steps, document.saves);
    document.params = steps.back().params;
    document.notes = steps.back().notes;
  }
  const JournalStep edit{document.saves, 1, "an edit", document.params, document.notes};
  appendJournal(given, {edit});
  steps = readJournal(given, document.saves);
  expect(!steps.empty() && same(steps.back(), edit), "the edit was not noted");
  expect(document.saves < std::numeric_limits<int>::max(), "the saves cannot be counted on");
  ++document.saves;
  checkSave(given, document, other);
  removeJournal(given);
  expect(readJournal(given, 0).empty(), "edits of a journal that was removed");
}

/// A case folder. Between form feeds: case.json, case.previous.json, edits/journal.jsonl; of an
/// empty part there is no file.
inline void readCaseInput(const std::uint8_t* data, std::size_t size) {
  const std::vector<std::string_view> parts = partsOf(textOf(data, size), '\f');
  const InputFolder folder;
  std::size_t n = 0;
  for (const char* name : {"case.json", "case.previous.json", "edits/journal.jsonl"}) {
    const std::string_view text = part(parts, n++);
    if (!text.empty()) folder.add(std::string("given.angiomesh/") + name, text);
  }
  attempt([&] {
    const CaseReading reading = readCase(folder / "given.angiomesh");
    must([&] { workOn(folder, reading.document); });
  });
}

}  // namespace angiomesh::fuzz
