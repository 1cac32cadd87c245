// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>

#include "gui/dialog/case_questions.h"
#include "gui/dialog/export_dialog.h"
#include "gui/job/job_slot.h"
#include "gui/job/recipe_job.h"
#include "gui/model/case_models.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

/// The menu that saves, imports, exports and removes presets.
class PresetMenu : public QObject {
  Q_OBJECT

 public:
  PresetMenu(QMainWindow* window, CaseModels& models, PathChooser chooser, CaseQuestions questions,
             const JobRunnerFactory& makeRunner);

  /// Adds it to another menu.
  void addTo(QMenu* menu);
  [[nodiscard]] QMenu* menu() const { return menu_; }

 private:
  void refresh();
  void save();
  void importFile();
  void exportFile();
  void remove();
  void finishImport(const RecipeReadJob& job);
  void finishExport(const RecipeFileJob& job);

  QMainWindow* window_;
  CaseModels& models_;
  PathChooser chooser_;
  CaseQuestions questions_;
  QMenu* menu_;
  JobSlot<RecipeReadJob> reading_;
  JobSlot<RecipeFileJob> writing_;
};

}  // namespace angiomesh
