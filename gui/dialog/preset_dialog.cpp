// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/preset_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/model/case_models.h"
#include "gui/view/named.h"

namespace angiomesh {

PresetDialog::PresetDialog(CaseModels& models, QWidget* parent) : QDialog(parent), models_(models) {
  setObjectName("presetDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Save as a preset"));
  resize(480, 0);
  auto* column = new QVBoxLayout(this);
  auto* what = new QLabel(
      tr("All parameters are kept, but not seeds, region of interest, cuts and corrections: these "
         "belong to one scan. Do not write a patient's name."),
      this);
  what->setWordWrap(true);
  column->addWidget(what);
  auto* form = new QFormLayout;
  name_ = named(new QLineEdit(this), "presetName");
  name_->setMaxLength(PresetShelf::kLongestName);
  name_->setPlaceholderText(tr("such as the scanner or the region"));
  about_ = named(new QLineEdit(this), "presetAbout");
  about_->setMaxLength(PresetShelf::kLongestAbout);
  form->addRow(tr("Name"), name_);
  form->addRow(tr("What it is for"), about_);
  column->addLayout(form);
  note_ = named(new QLabel(this), "presetNote");
  note_->setWordWrap(true);
  column->addWidget(note_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = named(buttons->addButton(tr("Save"), QDialogButtonBox::AcceptRole), "presetSave");
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &PresetDialog::keep);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(name_, &QLineEdit::textChanged, this, &PresetDialog::refresh);
  // To save one again that was changed is what is wanted most.
  const Preset& base = models_.presets.base();
  const QString baseName = QString::fromStdString(base.name);
  if (models_.presets.isOwn(baseName)) {
    name_->setText(baseName);
    about_->setText(QString::fromStdString(base.about));
  }
  refresh();
}

void PresetDialog::refresh() {
  const QString name = name_->text().simplified();
  const bool own = models_.presets.isOwn(name);
  save_->setEnabled(!name.isEmpty() && (own || !models_.presets.find(name)));
  note_->setText(own              ? tr("It replaces the preset of this name.")
                 : name.isEmpty() ? QString()
                 : save_->isEnabled()
                     ? QString()
                     : tr("%1 comes with the program: choose another name.").arg(name));
}

void PresetDialog::keep() {
  const QString name = name_->text().simplified();
  const QString why = models_.presets.keep(
      {name.toStdString(), about_->text().toStdString(), models_.document.parameters()});
  if (!why.isEmpty()) {
    note_->setText(why);
    return;
  }
  models_.log.say(Severity::Info, tr("Saved the preset %1.").arg(name));
  accept();
}

}  // namespace angiomesh
