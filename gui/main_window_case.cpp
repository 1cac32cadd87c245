// SPDX-License-Identifier: BSD-3-Clause
#include <QDateTime>
#include <QFileInfo>
#include <QSettings>
#include <chrono>

#include "gui/main_window.h"
#include "gui/model/view_state.h"
#include "gui/panel/view_grid.h"

namespace angiomesh {

namespace {

const char* const kExtension = ".angiomesh";

/// Cases with edits that are not saved, each for as long as a window has it open.
const char* const kUnfinished = "unfinished";

std::filesystem::path pathOf(const QString& text) {
  return QFileInfo(text).absoluteFilePath().toStdString();
}

QString changesText(std::size_t count) {
  return count == 1 ? MainWindow::tr("1 change") : MainWindow::tr("%1 changes").arg(count);
}

/// The case's folder where somebody chose a name inside of it, as file dialogs make one do.
QString outOfCase(const QString& path) {
  const QString parent = QFileInfo(path).absolutePath();
  return parent.endsWith(kExtension) && isCase(parent.toStdString()) ? parent : path;
}

}  // namespace

void MainWindow::connectCases() {
  connect(models_->document.undoStack(), &QUndoStack::cleanChanged, this,
          &MainWindow::refreshModified);
  connect(&models_->files, &CaseFiles::caseFound, this, [this](const CaseView& view) {
    state_->take(view);
    if (view.crosshairLps) {
      views_->setCrosshair(*view.crosshairLps);
    }
  });
  connect(&models_->files, &CaseFiles::sourceSeen, this, [this](const QString& path) {
    rememberSource(models_->document.sourceHash(), path.toStdString());
  });
  // Asked from the event loop: the models is in the midst of its work.
  connect(&models_->files, &CaseFiles::sourceMissing, this, [this](const QString& what) {
    QMetaObject::invokeMethod(
        this, [this, what] { askForSource(what, {}); }, Qt::QueuedConnection);
  });
  connect(&models_->files, &CaseFiles::sourceDiffers, this, [this](const QString& reason) {
    QMetaObject::invokeMethod(
        this, [this, reason] { askForSource({}, reason); }, Qt::QueuedConnection);
  });
  connect(&models_->files, &CaseFiles::editsFound, this, [this](int count) {
    QMetaObject::invokeMethod(
        this, [this, count] { askToRestore(count); }, Qt::QueuedConnection);
  });
  connect(&models_->files, &CaseFiles::caseSaved, this, [this](const QString& folder) {
    refreshTitle();
    remember(folder);
    if (afterSave_ && !models_->document.modified()) {
      QMetaObject::invokeMethod(this, std::exchange(afterSave_, nullptr), Qt::QueuedConnection);
    }
  });
  connect(&models_->files, &CaseFiles::caseNotSaved, this, [this] { afterSave_ = nullptr; });
}

void MainWindow::refreshModified() {
  const bool modified = models_->document.modified();
  setWindowModified(modified);
  const QString wanted = modified ? models_->files.caseFolder() : QString();
  if (wanted == unfinished_) {
    return;
  }
  QSettings settings;
  QStringList folders = settings.value(kUnfinished).toStringList();
  folders.removeAll(std::exchange(unfinished_, wanted));
  if (!wanted.isEmpty()) {
    folders << wanted;
  }
  settings.setValue(kUnfinished, folders);
  settings.sync();
}

void MainWindow::openCase(const QString& path) {
  CaseRequest request;
  request.folder = caseFolder(pathOf(path));
  request.known = knownSources();
  models_->files.openCase(std::move(request));
}

void MainWindow::saveCase() {
  if (models_->files.caseFolder().isEmpty()) {
    saveCaseAs();
  } else {
    saveCaseTo(models_->files.caseFolder());
  }
}

void MainWindow::saveCaseAs() {
  const QString present = models_->files.caseFolder();
  QString path = options_.questions.saveCaseAs(
      this, present.isEmpty() ? QStringLiteral("vessels") + kExtension : present);
  if (path.isEmpty()) {
    afterSave_ = nullptr;
    return;
  }
  path = outOfCase(path);
  if (!path.endsWith(kExtension)) {
    path += kExtension;
  }
  if (path != present && isCase(pathOf(path)) &&
      !options_.questions.replaceCase(this, QFileInfo(path).completeBaseName())) {
    afterSave_ = nullptr;
    return;
  }
  saveCaseTo(path);
}

void MainWindow::saveCaseTo(const QString& folder) {
  CaseView view = state_->caseView();
  view.crosshairLps = views_->crosshair();
  models_->files.saveCase(folder, view);
}

bool MainWindow::mayLeave(const std::function<void()>& onceSaved) {
  if (!models_->document.modified()) {
    return true;
  }
  switch (options_.questions.saveChanges(this, models_->document.caseName())) {
    case SaveAnswer::Discard:
      return true;
    case SaveAnswer::Save:
      afterSave_ = onceSaved;
      saveCase();
      return false;
    case SaveAnswer::Cancel:
      break;
  }
  return false;
}

void MainWindow::askForSource(const QString& what, const QString& reason) {
  QString path;
  switch (options_.questions.findSource(this, what, reason)) {
    case SourceAnswer::File:
      path = options_.chooser.openFile(this);
      break;
    case SourceAnswer::Folder:
      path = options_.chooser.openFolder(this);
      break;
    case SourceAnswer::ParametersOnly:
      models_->files.takeParametersOnly();
      return;
    case SourceAnswer::Cancel:
      break;
  }
  if (path.isEmpty()) {
    models_->files.giveUpCase();
  } else {
    models_->files.giveSource(path);
  }
}

void MainWindow::askToRestore(int count) {
  const QString what =
      tr("%1 of the case %2")
          .arg(changesText(static_cast<std::size_t>(count)), models_->document.caseName());
  if (options_.questions.restore(this, what, false) == RestoreAnswer::Discard) {
    models_->files.forgetEdits();
  } else {
    models_->files.restoreEdits();
  }
}

bool MainWindow::offerRestore() {
  for (const Recovery& recovery : findRecoveries(options_.recovery)) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
        std::filesystem::file_time_type::clock::now() - recovery.changed);
    const QString when = QLocale().toString(QDateTime::currentDateTime().addSecs(-seconds.count()),
                                            QLocale::ShortFormat);
    const QString what = tr("%1 of a case that was never saved, the last one on %2")
                             .arg(changesText(recovery.steps), when);
    const RestoreAnswer answer = options_.questions.restore(this, what, true);
    if (answer == RestoreAnswer::Restore) {
      CaseRequest request;
      request.folder = recovery.place->folder;
      request.place = recovery.place;
      request.known = knownSources();
      request.restore = true;
      models_->files.openCase(std::move(request));
      return true;
    }
    if (answer == RestoreAnswer::Discard) {
      removeRecovery(*recovery.place);
    }
  }
  return offerUnfinished();
}

bool MainWindow::offerUnfinished() {
  QStringList folders = QSettings().value(kUnfinished).toStringList();
  for (const QString& folder : QStringList(folders)) {
    CaseRequest request;
    request.folder = pathOf(folder);
    request.place = std::make_shared<CasePlace>();
    request.place->folder = request.folder;
    std::size_t steps = 0;
    try {
      const int saves = readCase(request.folder).document.saves;
      if (lockPlace(*request.place) == LockEnd::InUse) {
        continue;
      }
      steps = readJournal(request.folder, saves).size();
    } catch (const std::exception&) {
      // It was moved, or is not for this program: whoever opens it is asked then.
    }
    RestoreAnswer answer = RestoreAnswer::Discard;
    if (steps > 0) {
      const QString name = QFileInfo(folder).completeBaseName();
      answer = options_.questions.restore(
          this, tr("%1 of the case %2").arg(changesText(steps), name), true);
    }
    if (answer == RestoreAnswer::Later) {
      continue;
    }
    folders.removeAll(folder);
    QSettings().setValue(kUnfinished, folders);
    if (answer == RestoreAnswer::Restore) {
      request.known = knownSources();
      request.restore = true;
      models_->files.openCase(std::move(request));
      return true;
    }
    if (steps > 0) {
      removeJournal(request.folder);
    }
  }
  return false;
}

}  // namespace angiomesh
