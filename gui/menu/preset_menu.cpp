// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/preset_menu.h"

#include <QAction>
#include <QMainWindow>
#include <QMenu>
#include <utility>

#include "gui/dialog/preset_dialog.h"
#include "gui/menu/window_actions.h"

namespace angiomesh {

PresetMenu::PresetMenu(QMainWindow* window, CaseModels& models, PathChooser chooser,
                       CaseQuestions questions, const JobRunnerFactory& makeRunner)
    : QObject(window),
      window_(window),
      models_(models),
      chooser_(std::move(chooser)),
      questions_(std::move(questions)),
      menu_(new QMenu(tr("Presets"), window)),
      reading_(models.timer, makeRunner,
               [this](const std::shared_ptr<RecipeReadJob>& job) { finishImport(*job); }),
      writing_(models.timer, makeRunner,
               [this](const std::shared_ptr<RecipeFileJob>& job) { finishExport(*job); }) {
  menu_->setObjectName("presetMenu");
  addMenuAction(window_, menu_, "savePreset", tr("Save as a preset…"), {}, [this] { save(); });
  addMenuAction(window_, menu_, "removePreset", tr("Remove this preset…"), {},
                [this] { remove(); });
  menu_->addSeparator();
  addMenuAction(window_, menu_, "importPreset", tr("Import a preset…"), {},
                [this] { importFile(); });
  addMenuAction(window_, menu_, "exportPreset", tr("Export this preset…"), {},
                [this] { exportFile(); });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &PresetMenu::refresh);
  connect(&models_.presets, &PresetShelf::changed, this, &PresetMenu::refresh);
  refresh();
}

void PresetMenu::addTo(QMenu* menu) { menu->addMenu(menu_); }

void PresetMenu::refresh() {
  const QString current = models_.presets.current();
  actionOf(window_, "savePreset")->setEnabled(current.isEmpty());
  actionOf(window_, "exportPreset")->setEnabled(!current.isEmpty());
  actionOf(window_, "removePreset")
      ->setEnabled(models_.presets.isOwn(QString::fromStdString(models_.presets.base().name)));
}

void PresetMenu::save() { (new PresetDialog(models_, window_))->open(); }

void PresetMenu::importFile() {
  const QString path = chooser_.openPreset(window_);
  if (path.isEmpty() || reading_) return;
  auto job = std::make_shared<RecipeReadJob>();
  job->path = path.toStdString();
  reading_.startAndPoll(std::move(job));
}

void PresetMenu::finishImport(const RecipeReadJob& job) {
  QString why = QString::fromStdString(job.error);
  Preset preset = presetOf(job.recipe, job.path);
  QString name = QString::fromStdString(preset.name).simplified();
  if (why.isEmpty()) {
    const Preset* known = models_.presets.find(name);
    if (known && known->params == preset.params) {
      models_.log.say(Severity::Info, tr("There is a preset %1 with these parameters.").arg(name));
      models_.presets.apply(name);
      return;
    }
    if (known && !models_.presets.isOwn(name)) name = tr("%1 (imported)").arg(name);
    preset.name = name.toStdString();
    if (models_.presets.isOwn(name) && !questions_.replacePreset(window_, name)) return;
    why = models_.presets.keep(preset);
  }
  if (!why.isEmpty()) {
    models_.log.say(Severity::Error, tr("Cannot import the preset: %1").arg(why));
    return;
  }
  models_.log.say(Severity::Info, tr("Imported the preset %1.").arg(name));
  models_.presets.apply(name);
}

void PresetMenu::exportFile() {
  const Preset* preset = models_.presets.find(models_.presets.current());
  if (!preset || writing_) return;
  auto job = std::make_shared<RecipeFileJob>();
  job->recipe = recipeOf(*preset);
  const QString name = QString::fromStdString(preset->name);
  QString path = chooser_.save(
      window_,
      QString(name).replace(QLatin1Char('/'), QLatin1Char('-')) + QLatin1String(".preset.json"),
      tr("Presets (*.preset.json *.json)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(QLatin1String(".json"), Qt::CaseInsensitive))
    path += QLatin1String(".preset.json");
  job->path = path.toStdString();
  writing_.startAndPoll(std::move(job));
}

void PresetMenu::finishExport(const RecipeFileJob& job) {
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot write the preset: %1").arg(QString::fromStdString(job.error)));
    return;
  }
  models_.log.say(Severity::Info,
                  tr("Wrote the preset %1: angiomesh-cli run SCAN --params %1 begins with it.")
                      .arg(QString::fromStdString(job.path.filename().string())));
}

void PresetMenu::remove() {
  const QString name = QString::fromStdString(models_.presets.base().name);
  if (!models_.presets.isOwn(name) || !questions_.removePreset(window_, name)) return;
  models_.presets.forget(name);
  models_.log.say(Severity::Info, tr("Removed the preset %1.").arg(name));
}

}  // namespace angiomesh
