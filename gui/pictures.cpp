// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pictures.h"

#include <QClipboard>
#include <QCursor>
#include <QGuiApplication>
#include <QMainWindow>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "gui/menu/window_actions.h"
#include "gui/pane/view_grid.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

constexpr const char* kPng = ".png";

QString withoutPng(const QString& path) {
  return path.endsWith(QLatin1String(kPng), Qt::CaseInsensitive) ? path.chopped(4) : path;
}

}  // namespace

Pictures::Pictures(QMainWindow* window, CaseModels& models, ViewGrid& views, PathChooser chooser,
                   const JobRunnerFactory& makeRunner)
    : QObject(window),
      window_(window),
      models_(models),
      views_(views),
      chooser_(std::move(chooser)),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<PictureJob>& job) { finish(*job); }) {}

Pictures::~Pictures() = default;

void Pictures::addActions(QMenu* menu) {
  addMenuAction(window_, menu, "savePicture", tr("Save picture…"), QKeySequence(tr("Ctrl+Shift+P")),
                [this] { ask(); });
  addMenuAction(window_, menu, "copyPicture", tr("Copy picture"), QKeySequence(tr("Ctrl+Shift+C")),
                [this] { copy({paneUnderMouse()}); });
}

VtkView* Pictures::paneUnderMouse() const {
  const std::vector<VtkView*> shown = views_.shown();
  if (shown.size() == 1) return shown.front();
  for (VtkView* view : shown)
    if (view->rect().contains(view->mapFromGlobal(QCursor::pos()))) return view;
  return nullptr;
}

void Pictures::ask() {
  auto* dialog = new PictureDialog(views_, paneUnderMouse(), window_);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->save = [this](const PictureWish& wish) { save(wish); };
  dialog->copy = [this](const PictureWish& wish) { copy(wish); };
  dialog->open();
}

QImage Pictures::take(const PictureWish& wish) {
  try {
    return views_.picture(wish.pane, wish.scale, wish.crosshair);
  } catch (const Error& failure) {
    models_.log.say(Severity::Error, std::string(failure.what()));
    return {};
  }
}

QImage Pictures::takeTurned() {
  try {
    const double degrees = 360.0 * done_ / turntable_->count;
    return views_.surface()->pictureTurned(degrees, scale_, size_);
  } catch (const Error& failure) {
    models_.log.say(Severity::Error, std::string(failure.what()));
    return {};
  }
}

void Pictures::copy(const PictureWish& wish) {
  const QImage picture = take(wish);
  if (picture.isNull()) return;
  QGuiApplication::clipboard()->setImage(picture);
  models_.log.say(
      Severity::Info,
      tr("Copied a picture of %1 × %2 pixels.").arg(picture.width()).arg(picture.height()));
}

void Pictures::save(const PictureWish& wish) {
  if (slot_) {
    models_.log.say(Severity::Warning,
                    tr("Pictures are being written: try again when they are done."));
    return;
  }
  // Taken before a file dialog lies over the panes, or what they show changes.
  const QImage picture = wish.turns > 0 ? QImage() : take(wish);
  if (wish.turns == 0 && picture.isNull()) return;
  const QString name = wish.turns > 0 ? QStringLiteral("vessels")
                       : wish.pane    ? wish.pane->objectName()
                                      : QStringLiteral("panes");
  const QString path = wish.turns > 0
                           ? chooser_.save(window_, name, tr("Folders NAME-turntable (*)"))
                           : chooser_.save(window_, name + QLatin1String(kPng), tr("PNG (*.png)"));
  if (path.isEmpty() || slot_) return;
  if (wish.turns > 0) {
    turn(wish, path);
    return;
  }
  auto job = std::make_shared<PictureJob>();
  job->picture = picture;
  job->path = (withoutPng(path) + QLatin1String(kPng)).toStdString();
  slot_.startAndPoll(std::move(job));
}

void Pictures::turn(const PictureWish& wish, const QString& path) {
  turntable_ = std::make_shared<TurntableFolder>();
  turntable_->path = (withoutPng(path) + QStringLiteral("-turntable")).toStdString();
  turntable_->count = wish.turns;
  done_ = 0;
  scale_ = wish.scale;
  size_ = views_.surface()->size();
  cancelled_ = false;
  // A camera that somebody turns meanwhile would make it jump.
  views_.surface()->setEnabled(false);
  Q_EMIT turningChanged();
  takeNext();
}

void Pictures::takeNext() {
  auto job = std::make_shared<PictureJob>();
  job->turntable = turntable_;
  if (!cancelled_) {
    job->picture = takeTurned();
    if (!job->picture.isNull()) job->number = done_ + 1;
  }
  cancelled_ = job->number == 0;
  slot_.start(std::move(job));
}

void Pictures::endTurntable() {
  turntable_.reset();
  views_.surface()->setEnabled(true);
  Q_EMIT turningChanged();
}

void Pictures::finish(const PictureJob& job) {
  const std::filesystem::path& path = job.turntable ? job.turntable->path : job.path;
  const QString name = QString::fromStdString(path.filename().string());
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot save the picture: %1").arg(QString::fromStdString(job.error)));
    if (job.turntable) endTurntable();
  } else if (!job.turntable) {
    models_.log.say(Severity::Info, tr("Saved %1, %2 × %3 pixels.")
                                        .arg(name)
                                        .arg(job.picture.width())
                                        .arg(job.picture.height()));
  } else if (job.number == 0) {
    models_.log.say(Severity::Info, tr("Gave up the turntable: nothing of it was kept."));
    endTurntable();
  } else if (done_ = job.number; done_ == count()) {
    models_.log.say(Severity::Info, tr("Saved the %1 pictures of %2, %3 × %4 pixels.")
                                        .arg(done_)
                                        .arg(name)
                                        .arg(job.picture.width())
                                        .arg(job.picture.height()));
    endTurntable();
  } else {
    // Once the window has had its turn.
    QMetaObject::invokeMethod(
        this, [this] { takeNext(); }, Qt::QueuedConnection);
  }
}

}  // namespace angiomesh
