// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <functional>

#include "gui/dialog/export_dialog.h"
#include "gui/job/job_slot.h"
#include "gui/job/recipe_job.h"

class QAction;
class QMenu;

namespace angiomesh {

/// The rows of the menus that take the open case elsewhere: as a recipe, as a line for the command
/// line, and as a paragraph for a paper.
class RecipeActions : public QObject {
  Q_OBJECT

 public:
  RecipeActions(CaseModels& models, PathChooser chooser, const JobRunnerFactory& makeRunner,
                QWidget* window);

  void addExport(QMenu* menu);  ///< "exportRecipe"
  void addCopies(QMenu* menu);  ///< "copyCommandLine" and "copyMethods"

 private:
  void add(QMenu* menu, const char* name, const QString& text, const std::function<void()>& slot,
           const std::function<bool()>& possible);
  void exportRecipe();
  void finish(const RecipeFileJob& job);
  void copyCommandLine();
  void copyMethods();

  CaseModels& models_;
  PathChooser chooser_;
  QWidget* window_;
  JobSlot<RecipeFileJob> slot_;
};

}  // namespace angiomesh
