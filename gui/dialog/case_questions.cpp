// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/case_questions.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include "gui/dialog/shared_history.h"

namespace angiomesh {

namespace {

bool sure(QWidget* parent, const QString& title, const QString& question) {
  return QMessageBox::warning(parent, title, question, QMessageBox::Yes | QMessageBox::Cancel,
                              QMessageBox::Cancel) == QMessageBox::Yes;
}

bool replaceCase(QWidget* parent, const QString& name) {
  return sure(parent, QObject::tr("Save case"),
              QObject::tr("There is a case %1 already. Replace it?").arg(name));
}

SaveAnswer saveChanges(QWidget* parent, const QString& name) {
  const auto answer = QMessageBox::question(
      parent, QObject::tr("Unsaved changes"),
      QObject::tr("The case %1 has changes that are not saved.").arg(name),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  return answer == QMessageBox::Save      ? SaveAnswer::Save
         : answer == QMessageBox::Discard ? SaveAnswer::Discard
                                          : SaveAnswer::Cancel;
}

RestoreAnswer restore(QWidget* parent, const QString& what, bool later) {
  QMessageBox box(QMessageBox::Question, QObject::tr("Restore edits"),
                  QObject::tr("Angiomesh ended before these changes were saved:\n%1").arg(what),
                  QMessageBox::NoButton, parent);
  QPushButton* yes = box.addButton(QObject::tr("Restore"), QMessageBox::AcceptRole);
  QPushButton* no = box.addButton(QObject::tr("Discard"), QMessageBox::DestructiveRole);
  box.setDefaultButton(yes);
  if (later) {
    box.setEscapeButton(box.addButton(QObject::tr("Ask again later"), QMessageBox::RejectRole));
  } else {
    // Restored edits can be undone, discarded ones are gone.
    box.setEscapeButton(yes);
  }
  box.exec();
  return box.clickedButton() == yes  ? RestoreAnswer::Restore
         : box.clickedButton() == no ? RestoreAnswer::Discard
                                     : RestoreAnswer::Later;
}

SourceAnswer findSource(QWidget* parent, const QString& what, const QString& reason) {
  const QString text =
      reason.isEmpty()
          ? QObject::tr("The volume of this case is not where it was, nor beside the case:\n%1")
                .arg(what)
          : QObject::tr("The case cannot be opened with this volume: %1.").arg(reason);
  QMessageBox box(QMessageBox::Question, QObject::tr("Where is the volume?"), text,
                  QMessageBox::Cancel, parent);
  QPushButton* file = box.addButton(QObject::tr("Choose a file…"), QMessageBox::AcceptRole);
  QPushButton* folder =
      box.addButton(QObject::tr("Choose a DICOM folder…"), QMessageBox::AcceptRole);
  QPushButton* parameters = nullptr;
  if (!reason.isEmpty()) {
    parameters = box.addButton(QObject::tr("Open it with the case's parameters only"),
                               QMessageBox::AcceptRole);
    box.setInformativeText(
        QObject::tr("Seeds, the region of interest and the parts left out are "
                    "places in the other volume and are not taken over."));
  }
  box.exec();
  const QAbstractButton* clicked = box.clickedButton();
  return clicked == file                       ? SourceAnswer::File
         : clicked == folder                   ? SourceAnswer::Folder
         : parameters && clicked == parameters ? SourceAnswer::ParametersOnly
                                               : SourceAnswer::Cancel;
}

}  // namespace

CaseQuestions dialogCaseQuestions() {
  CaseQuestions questions;
  questions.saveCaseAs = [](QWidget* parent, const QString& suggested) {
    const SharedHistory history;
    return QFileDialog::getSaveFileName(
        parent, QObject::tr("Save case as"), suggested, QObject::tr("Cases (*.angiomesh)"), nullptr,
        QFileDialog::DontUseNativeDialog | QFileDialog::DontConfirmOverwrite);
  };
  questions.replaceCase = replaceCase;
  questions.saveChanges = saveChanges;
  questions.restore = restore;
  questions.findSource = findSource;
  questions.replacePreset = [](QWidget* parent, const QString& name) {
    return sure(parent, QObject::tr("Import a preset"),
                QObject::tr("There is a preset %1 already. Replace it?").arg(name));
  };
  questions.removePreset = [](QWidget* parent, const QString& name) {
    return sure(
        parent, QObject::tr("Remove a preset"),
        QObject::tr("Remove the preset %1 for good? The parameters in use stay.").arg(name));
  };
  return questions;
}

}  // namespace angiomesh
