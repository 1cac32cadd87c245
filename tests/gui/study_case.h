// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QAction>
#include <QDir>
#include <QTemporaryDir>
#include <filesystem>

#include "io/volume/image_write.h"
#include "window_case.h"

namespace angiomesh::test {

/// In the paths of the sources; nothing of it may get into a case.
inline const char* const kPatient = "Doe_Jane";

/// A folder with a volume in a place that tells a name.
struct Study {
  Study() {
    QDir(folder.path()).mkpath(QString("%1/scans").arg(kPatient));
    QDir(folder.path()).mkpath("cases");
    volume = folder.filePath(QString("%1/scans/%1_tubes.mha").arg(kPatient));
    writeVolume(*twoTubes().image, volume.toStdString());
    saved = folder.filePath("cases/vessels.angiomesh");
    recovery = folder.filePath("recovery").toStdString();
  }
  /// Another volume on the same grid.
  QString otherVolume() const {
    QString path = folder.filePath("other.mha");
    Volume<float> image = *twoTubes().image;
    image.voxels[5] += 1.0F;
    writeVolume(image, path.toStdString());
    return path;
  }
  [[nodiscard]] int recoveries() const {
    return static_cast<int>(QDir(QString::fromStdString(recovery.string()))
                                .entryList(QDir::Dirs | QDir::NoDotAndDotDot)
                                .size());
  }

  QTemporaryDir folder;
  QString volume, saved;
  std::filesystem::path recovery;
};

inline QAction* action(WindowCase& c, const char* name) {
  return c.window->findChild<QAction*>(QLatin1String(name));
}

/// Opens the study's volume, edits and saves.
inline void makeCase(WindowCase& c, const Study& study) {
  c.window->open(study.volume);
  c.models().document.setField("levelset.xi", 31.0);
  c.models().document.addSeed({1.0, 2.0, 3.0});
  c.answers.savePath = study.saved;
  action(c, "saveCase")->trigger();
}

}  // namespace angiomesh::test
