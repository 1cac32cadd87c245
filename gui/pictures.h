// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <memory>

#include "gui/dialog/export_dialog.h"
#include "gui/dialog/picture_dialog.h"
#include "gui/job/picture_jobs.h"
#include "gui/model/case_models.h"

class QMainWindow;
class QMenu;

namespace angiomesh {

/// Pictures of what the panes show: into files, into the clipboard, and round the 3D pane. They
/// hold nothing but pixels.
class Pictures : public QObject {
  Q_OBJECT

 public:
  Pictures(QMainWindow* window, CaseModels& models, ViewGrid& views, PathChooser chooser,
           const JobRunnerFactory& makeRunner);
  ~Pictures() override;

  void addActions(QMenu* menu);

  /// Whether a turntable is being made, how many of its pictures are done, and of how many.
  [[nodiscard]] bool turning() const { return turntable_ != nullptr; }
  [[nodiscard]] int done() const { return done_; }
  [[nodiscard]] int count() const { return turntable_ ? turntable_->count : 0; }
  /// Ends the turntable; nothing of it is left.
  void cancel() { cancelled_ = turning(); }

 Q_SIGNALS:
  void turningChanged();

 private:
  void ask();
  void save(const PictureWish& wish);
  void copy(const PictureWish& wish);
  void turn(const PictureWish& wish, const QString& path);
  void takeNext();
  void finish(const PictureJob& job);
  void endTurntable();
  /// Null, and a message, where the panes cannot be drawn.
  [[nodiscard]] QImage take(const PictureWish& wish);
  [[nodiscard]] QImage takeTurned();
  /// Under the mouse; null where there is none.
  [[nodiscard]] VtkView* paneUnderMouse() const;

  QMainWindow* window_;
  CaseModels& models_;
  ViewGrid& views_;
  PathChooser chooser_;
  std::shared_ptr<TurntableFolder> turntable_;
  int done_ = 0, scale_ = 1;
  QSize size_;  ///< of all pictures of the turntable, Qt's pixels
  bool cancelled_ = false;
  JobSlot<PictureJob> slot_;
};

}  // namespace angiomesh
