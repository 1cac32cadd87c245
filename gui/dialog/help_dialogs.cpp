// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/help_dialogs.h"

#include <QMessageBox>

#include "core/pipeline/report.h"

namespace angiomesh {

void showAbout(QWidget* window) {
  auto* box = new QMessageBox(
      QMessageBox::NoIcon, QObject::tr("About Angiomesh"),
      QObject::tr(
          "Angiomesh %1\n\nFrom an angiogram to a vessel surface that a flow solver accepts.\n"
          "Not a medical device: research use only.\n\nBSD-3-Clause.")
          .arg(QString::fromLatin1(versionText())),
      QMessageBox::Close, window);
  box->setObjectName("aboutBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

}  // namespace angiomesh
