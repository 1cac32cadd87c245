// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/recipe_actions.h"

#include <QAction>
#include <QClipboard>
#include <QGuiApplication>
#include <QMenu>
#include <utility>

#include "gui/model/case_models.h"
#include "gui/model/case_recipe.h"
#include "io/recipe/command_line.h"

namespace angiomesh {

RecipeActions::RecipeActions(CaseModels& models, PathChooser chooser,
                             const JobRunnerFactory& makeRunner, QWidget* window)
    : QObject(window),
      models_(models),
      chooser_(std::move(chooser)),
      window_(window),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<RecipeFileJob>& job) { finish(*job); }) {}

void RecipeActions::add(QMenu* menu, const char* name, const QString& text,
                        const std::function<void()>& slot, const std::function<bool()>& possible) {
  QAction* action = menu->addAction(text, this, slot);
  action->setObjectName(QLatin1String(name));
  action->setParent(window_);
  const auto refresh = [action, possible] { action->setEnabled(possible()); };
  connect(&models_.files, &CaseFiles::caseChanged, this, refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, refresh);
  refresh();
}

void RecipeActions::addExport(QMenu* menu) {
  add(
      menu, "exportRecipe", tr("Recipe…"), [this] { exportRecipe(); },
      [this] { return models_.document.hasCase(); });
}

void RecipeActions::addCopies(QMenu* menu) {
  add(
      menu, "copyCommandLine", tr("Copy as command line"), [this] { copyCommandLine(); },
      [this] { return models_.document.hasCase(); });
  add(
      menu, "copyMethods", tr("Copy methods paragraph"), [this] { copyMethods(); },
      [this] { return models_.results.meshRun() != nullptr; });
}

void RecipeActions::exportRecipe() {
  QString path = chooser_.save(window_, "case.recipe.json", tr("Recipes (*.recipe.json *.json)"));
  if (path.isEmpty() || slot_) return;
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
    path += QLatin1String(".recipe.json");
  auto job = std::make_shared<RecipeFileJob>();
  job->recipe = caseRecipe(models_);
  job->path = path.toStdString();
  slot_.startAndPoll(std::move(job));
}

void RecipeActions::finish(const RecipeFileJob& job) {
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot write the recipe: %1").arg(QString::fromStdString(job.error)));
    return;
  }
  const QString name = QString::fromStdString(job.path.filename().string());
  models_.log.say(
      Severity::Info,
      tr("Wrote the recipe %1: angiomesh-cli run SCAN --recipe %1 makes the same mesh.").arg(name));
}

void RecipeActions::copyCommandLine() {
  QGuiApplication::clipboard()->setText(
      QString::fromStdString(commandLine(caseRecipe(models_).params)));
  models_.log.say(Severity::Info, tr("Copied the command line that repeats this case: put the "
                                     "volume in place of SCAN and a folder in place of OUT."));
}

void RecipeActions::copyMethods() {
  QGuiApplication::clipboard()->setText(QString::fromStdString(caseMethods(models_)));
  if (models_.results.meshFresh())
    models_.log.say(Severity::Info, tr("Copied a methods paragraph on this mesh."));
  else
    models_.log.say(Severity::Warning, tr("Copied a methods paragraph on a mesh of earlier "
                                          "parameters: run again for the present ones."));
}

}  // namespace angiomesh
