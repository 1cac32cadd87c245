// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/open_questions.h"

#include <QMessageBox>
#include <QPushButton>

#include "gui/dialog/label_dialog.h"
#include "gui/dialog/series_dialog.h"

namespace angiomesh {

OpenQuestions dialogOpenQuestions() {
  OpenQuestions questions;
  questions.choose = [](QWidget* parent, const std::vector<ImageSummary>& entries,
                        const JobRunnerFactory& makeRunner) -> std::optional<std::size_t> {
    SeriesDialog dialog(entries, makeRunner, parent);
    if (dialog.exec() != QDialog::Accepted) return std::nullopt;
    return dialog.chosen();
  };
  questions.resample = [](QWidget* parent, const QString& reason) {
    QMessageBox box(QMessageBox::Warning, QObject::tr("Uneven slices"),
                    QObject::tr("The slices of the series are not at even distances."),
                    QMessageBox::Cancel, parent);
    box.setInformativeText(reason);
    const QPushButton* resample =
        box.addButton(QObject::tr("Resample them"), QMessageBox::AcceptRole);
    box.exec();
    return box.clickedButton() == resample;
  };
  questions.label = [](QWidget* parent, const std::vector<Label>& labels,
                       double voxelMm3) -> std::optional<LabelAnswer> {
    LabelDialog dialog(labels, voxelMm3, parent);
    if (dialog.exec() != QDialog::Accepted) {
      return std::nullopt;
    }
    return dialog.answer();
  };
  return questions;
}

}  // namespace angiomesh
