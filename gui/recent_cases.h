// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>

#include "gui/job/case_thumbnail_job.h"
#include "gui/job/job_slot.h"
#include "gui/model/case_models.h"

namespace angiomesh {

/// What was opened last, with a small picture of each, in the user's settings.
class RecentCases : public QObject {
  Q_OBJECT

 public:
  RecentCases(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent = nullptr);

  /// Files, folders and cases, the latest first.
  [[nodiscard]] QStringList paths() const;
  /// The file of a path's picture, which may not be there.
  [[nodiscard]] static QString pictureOf(const QString& path);

  /// A case's name, and the folder of the file that it was read from: files of many patients have
  /// one name.
  [[nodiscard]] QString titleOf(const QString& caseName) const;

  /// The volume that is open came from there.
  void remember(const QString& path);
  void forgetAll();

 Q_SIGNALS:
  void changed();  ///< the list or a picture

 private:
  void setPaths(const QStringList& paths);
  void makeNext();

  CaseModels& models_;
  QString open_;  ///< what was remembered last
  std::shared_ptr<CaseThumbnailJob> next_;
  JobSlot<CaseThumbnailJob> slot_;
};

/// "mra (patient 7)" of a volume in such a folder; the name alone of cases and folders.
QString fullTitle(const QString& name, const QString& path);

}  // namespace angiomesh
