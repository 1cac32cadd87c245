// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <functional>

class QWidget;

namespace angiomesh {

enum class SaveAnswer { Save, Discard, Cancel };
enum class RestoreAnswer { Restore, Discard, Later };
enum class SourceAnswer { File, Folder, ParametersOnly, Cancel };

/// What the window asks about cases. It uses message boxes; tests answer at once.
struct CaseQuestions {
  /// Where to save; empty: nowhere.
  std::function<QString(QWidget*, const QString& suggested)> saveCaseAs;
  std::function<bool(QWidget*, const QString& name)> replaceCase;
  std::function<SaveAnswer(QWidget*, const QString& name)> saveChanges;
  /// About edits that a crash left; `later`: the question may be put off.
  std::function<RestoreAnswer(QWidget*, const QString& what, bool later)> restore;
  /// Where the volume of a case is. `reason` says why the last answer would not do; empty at first.
  std::function<SourceAnswer(QWidget*, const QString& what, const QString& reason)> findSource;
  std::function<bool(QWidget*, const QString&name)> replacePreset, removePreset;
};
CaseQuestions dialogCaseQuestions();

}  // namespace angiomesh
