// SPDX-License-Identifier: BSD-3-Clause
#include "gui/case_dialogs.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>
#include <QWidget>
#include <chrono>
#include <utility>

#include "gui/job/known_sources.h"
#include "gui/recent_cases.h"

namespace angiomesh {

namespace {

const char* const kExtension = ".angiomesh";

/// Cases with edits that are not saved, each for as long as a window has it open.
const char* const kUnfinished = "unfinished";

std::filesystem::path pathOf(const QString& text) {
  return QFileInfo(text).absoluteFilePath().toStdString();
}

QString changesText(std::size_t count) {
  return count == 1 ? CaseDialogs::tr("1 change") : CaseDialogs::tr("%1 changes").arg(count);
}

/// The case's folder where somebody chose a name inside of it, as file dialogs make one do.
QString outOfCase(const QString& path) {
  const QString parent = QFileInfo(path).absolutePath();
  return parent.endsWith(kExtension) && isCase(parent.toStdString()) ? parent : path;
}

}  // namespace

CaseDialogs::CaseDialogs(QWidget* window, CaseModels& models, ViewState& state, ViewGrid& views,
                         PathChooser chooser, CaseQuestions questions,
                         std::filesystem::path recovery)
    : QObject(window),
      window_(window),
      models_(models),
      state_(state),
      views_(views),
      chooser_(std::move(chooser)),
      questions_(std::move(questions)),
      recovery_(std::move(recovery)) {
  connect(models_.document.undoStack(), &QUndoStack::cleanChanged, this,
          &CaseDialogs::refreshModified);
  connect(&models_.files, &CaseFiles::caseFound, this, [this](const CaseView& view) {
    state_.take(view);
    if (view.crosshairLps) {
      views_.setCrosshair(*view.crosshairLps);
    }
  });
  connect(&models_.files, &CaseFiles::sourceSeen, this, [this](const QString& path) {
    rememberSource(models_.document.sourceHash(), path.toStdString());
  });
  // Asked from the event loop: the models are in the midst of their work.
  connect(&models_.files, &CaseFiles::sourceMissing, this, [this](const QString& what) {
    QMetaObject::invokeMethod(
        this, [this, what] { askForSource(what, {}); }, Qt::QueuedConnection);
  });
  connect(&models_.files, &CaseFiles::sourceDiffers, this, [this](const QString& reason) {
    QMetaObject::invokeMethod(
        this, [this, reason] { askForSource({}, reason); }, Qt::QueuedConnection);
  });
  connect(&models_.files, &CaseFiles::editsFound, this, [this](int count) {
    QMetaObject::invokeMethod(
        this, [this, count] { askToRestore(count); }, Qt::QueuedConnection);
  });
  connect(&models_.files, &CaseFiles::caseSaved, this, [this](const QString& folder) {
    Q_EMIT saved(folder);
    if (afterSave_ && !models_.document.modified()) {
      QMetaObject::invokeMethod(this, std::exchange(afterSave_, nullptr), Qt::QueuedConnection);
    }
  });
  connect(&models_.files, &CaseFiles::caseNotSaved, this, [this] { afterSave_ = nullptr; });
}

void CaseDialogs::refreshModified() {
  const bool modified = models_.document.modified();
  window_->setWindowModified(modified);
  const QString wanted = modified ? models_.files.caseFolder() : QString();
  if (wanted == unfinished_) return;
  QSettings settings;
  QStringList folders = settings.value(kUnfinished).toStringList();
  folders.removeAll(std::exchange(unfinished_, wanted));
  if (!wanted.isEmpty()) folders << wanted;
  settings.setValue(kUnfinished, folders);
  settings.sync();
}

void CaseDialogs::open(const QString& path) {
  CaseRequest request;
  request.folder = caseFolder(pathOf(path));
  request.known = knownSources();
  models_.files.openCase(std::move(request));
}

void CaseDialogs::save() {
  if (models_.files.caseFolder().isEmpty())
    saveAs();
  else
    saveTo(models_.files.caseFolder());
}

void CaseDialogs::saveAs() {
  const QString present = models_.files.caseFolder();
  QString path = questions_.saveCaseAs(
      window_, present.isEmpty() ? QStringLiteral("vessels") + kExtension : present);
  if (path.isEmpty()) {
    afterSave_ = nullptr;
    return;
  }
  path = outOfCase(path);
  if (!path.endsWith(kExtension)) path += kExtension;
  if (path != present && isCase(pathOf(path)) &&
      !questions_.replaceCase(window_, QFileInfo(path).completeBaseName())) {
    afterSave_ = nullptr;
    return;
  }
  saveTo(path);
}

void CaseDialogs::saveTo(const QString& folder) {
  CaseView view = state_.caseView();
  view.crosshairLps = views_.crosshair();
  models_.files.saveCase(folder, view);
}

bool CaseDialogs::mayLeave(const std::function<void()>& onceSaved) {
  if (!models_.document.modified()) return true;
  switch (questions_.saveChanges(window_, models_.document.caseName())) {
    case SaveAnswer::Discard:
      return true;
    case SaveAnswer::Save:
      afterSave_ = onceSaved;
      save();
      return false;
    case SaveAnswer::Cancel:
      break;
  }
  return false;
}

void CaseDialogs::askForSource(const QString& what, const QString& reason) {
  QString path;
  switch (questions_.findSource(window_, what, reason)) {
    case SourceAnswer::File:
      path = chooser_.openFile(window_);
      break;
    case SourceAnswer::Folder:
      path = chooser_.openFolder(window_);
      break;
    case SourceAnswer::ParametersOnly:
      models_.files.takeParametersOnly();
      return;
    case SourceAnswer::Cancel:
      break;
  }
  if (path.isEmpty())
    models_.files.giveUpCase();
  else
    models_.files.giveSource(path);
}

void CaseDialogs::askToRestore(int count) {
  const QString what =
      tr("%1 of the case %2")
          .arg(changesText(static_cast<std::size_t>(count)), models_.document.caseName());
  if (questions_.restore(window_, what, false) == RestoreAnswer::Discard)
    models_.files.forgetEdits();
  else
    models_.files.restoreEdits();
}

namespace {

/// By the file that its volume was read from; empty where that is not known any more.
QString nameOf(const Recovery& recovery) {
  const std::vector<std::filesystem::path> places = placesOf(recovery.source, knownSources());
  if (places.empty()) return {};
  const QString path = QString::fromStdString(places.front().string());
  return fullTitle(QFileInfo(path).fileName().section('.', 0, 0), path);
}

}  // namespace

bool CaseDialogs::offerRestore() {
  for (const Recovery& recovery : findRecoveries(recovery_)) {
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(
        std::filesystem::file_time_type::clock::now() - recovery.changed);
    const QString when = QLocale().toString(QDateTime::currentDateTime().addSecs(-seconds.count()),
                                            QLocale::ShortFormat);
    const QString name = nameOf(recovery);
    const QString what = name.isEmpty()
                             ? tr("%1 of a case that was never saved, the last one on %2")
                                   .arg(changesText(recovery.steps), when)
                             : tr("%1 of %2, which was never saved, the last one on %3")
                                   .arg(changesText(recovery.steps), name, when);
    const RestoreAnswer answer = questions_.restore(window_, what, true);
    if (answer == RestoreAnswer::Restore) {
      CaseRequest request;
      request.folder = recovery.place->folder;
      request.place = recovery.place;
      request.known = knownSources();
      request.restore = true;
      models_.files.openCase(std::move(request));
      return true;
    }
    if (answer == RestoreAnswer::Discard) removeRecovery(*recovery.place);
  }
  return offerUnfinished();
}

bool CaseDialogs::offerUnfinished() {
  QStringList folders = QSettings().value(kUnfinished).toStringList();
  for (const QString& folder : QStringList(folders)) {
    CaseRequest request;
    request.folder = pathOf(folder);
    request.place = std::make_shared<CasePlace>();
    request.place->folder = request.folder;
    std::size_t steps = 0;
    try {
      const int saves = readCase(request.folder).document.saves;
      if (lockPlace(*request.place) == LockEnd::InUse) continue;
      steps = readJournal(request.folder, saves).size();
    } catch (const std::exception&) {
      // It was moved, or is not for this program: whoever opens it is asked then.
    }
    RestoreAnswer answer = RestoreAnswer::Discard;
    if (steps > 0) {
      const QString name = QFileInfo(folder).completeBaseName();
      answer =
          questions_.restore(window_, tr("%1 of the case %2").arg(changesText(steps), name), true);
    }
    if (answer == RestoreAnswer::Later) continue;
    folders.removeAll(folder);
    QSettings().setValue(kUnfinished, folders);
    if (answer == RestoreAnswer::Restore) {
      request.known = knownSources();
      request.restore = true;
      models_.files.openCase(std::move(request));
      return true;
    }
    if (steps > 0) removeJournal(request.folder);
  }
  return false;
}

}  // namespace angiomesh
