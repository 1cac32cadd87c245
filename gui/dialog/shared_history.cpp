// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/shared_history.h"

#include <QSettings>

namespace angiomesh {

namespace {

/// As in QFileDialogPrivate::saveSettings().
const char* const kFile = "QtProject";
constexpr std::array<const char*, 2> kKeys{"FileDialog/history", "FileDialog/lastVisited"};

}  // namespace

SharedHistory::SharedHistory() {
  const QSettings settings(QSettings::UserScope, kFile);
  for (std::size_t i = 0; i < kKeys.size(); ++i) before_[i] = settings.value(kKeys[i]);
}

SharedHistory::~SharedHistory() {
  QSettings settings(QSettings::UserScope, kFile);
  for (std::size_t i = 0; i < kKeys.size(); ++i)
    if (before_[i].isValid())
      settings.setValue(kKeys[i], before_[i]);
    else
      settings.remove(kKeys[i]);
}

}  // namespace angiomesh
