// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <functional>

#include "gui/dialog/case_questions.h"
#include "gui/dialog/export_dialog.h"
#include "gui/model/case_models.h"
#include "gui/model/view_state.h"
#include "gui/pane/view_grid.h"

namespace angiomesh {

/// Opening, saving, leaving and restoring cases, as far as the user is asked about it.
class CaseDialogs : public QObject {
  Q_OBJECT

 public:
  CaseDialogs(QWidget* window, CaseModels& models, ViewState& state, ViewGrid& views,
              PathChooser chooser, CaseQuestions questions, std::filesystem::path recovery);

  void open(const QString& path);
  void save();
  void saveAs();
  /// Whether the open case may go; asks about unsaved changes. With the answer "save" it may not
  /// yet: `onceSaved` is called when it may.
  bool mayLeave(const std::function<void()>& onceSaved);
  /// Asks whether to restore what a crash left unsaved; true when something is being restored.
  bool offerRestore();
  /// Shows whether there are edits, and keeps the case among the unfinished ones if so.
  void refreshModified();

 Q_SIGNALS:
  void saved(const QString& folder);

 private:
  void saveTo(const QString& folder);
  void askForSource(const QString& what, const QString& reason);
  void askToRestore(int count);
  bool offerUnfinished();

  QWidget* window_;
  CaseModels& models_;
  ViewState& state_;
  ViewGrid& views_;
  PathChooser chooser_;
  CaseQuestions questions_;
  std::filesystem::path recovery_;
  std::function<void()> afterSave_;
  QString unfinished_;  ///< the case that the settings name as such for this window
};

}  // namespace angiomesh
