// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/picture_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/pane/view_grid.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// What the list of panes has after them.
constexpr int kAll = -1, kTurntable = -2;

}  // namespace

PictureDialog::PictureDialog(const ViewGrid& views, VtkView* pane, QWidget* parent)
    : QDialog(parent), views_(views) {
  setObjectName("pictureDialog");
  setWindowTitle(tr("Save picture"));
  auto* column = new QVBoxLayout(this);
  form_ = new QFormLayout;
  column->addLayout(form_);
  addChoices(pane);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  copy_ = named(buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole), "pictureCopy");
  auto* go = named(buttons->addButton(tr("Save…"), QDialogButtonBox::AcceptRole), "pictureSave");
  go->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, [this] { finish(save); });
  connect(copy_, &QPushButton::clicked, this, [this] { finish(copy); });
  for (QComboBox* combo : {pane_, scale_})
    connect(combo, &QComboBox::currentIndexChanged, this, &PictureDialog::refresh);
  refresh();
}

void PictureDialog::addChoices(VtkView* pane) {
  pane_ = named(new QComboBox(this), "picturePane");
  const std::vector<VtkView*> shown = views_.shown();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    pane_->addItem(views_.titleOf(shown[i]), static_cast<int>(i));
    if (shown[i] == pane) pane_->setCurrentIndex(static_cast<int>(i));
  }
  if (shown.size() > 1) {
    pane_->addItem(tr("all panes"), kAll);
    if (!pane) pane_->setCurrentIndex(pane_->count() - 1);
  }
  if (views_.shown3d()) pane_->addItem(tr("turntable of the 3D pane"), kTurntable);
  form_->addRow(tr("Picture of"), pane_);
  scale_ = named(new QComboBox(this), "pictureScale");
  scale_->addItem(tr("as on the screen"), 1);
  scale_->addItem(tr("twice as large"), 2);
  form_->addRow(tr("Size"), scale_);
  size_ = named(new QLabel(this), "pictureSize");
  form_->addRow(tr("Pixels"), size_);
  turns_ = named(new QComboBox(this), "pictureTurns");
  for (const int count : {36, 60, 72, 120})
    turns_->addItem(tr("%1, every %2°").arg(count).arg(360.0 / count), count);
  form_->addRow(tr("Pictures"), turns_);
  crosshair_ = named(new QCheckBox(tr("With the crosshair"), this), "pictureCrosshair");
  form_->addRow(crosshair_);
}

PictureWish PictureDialog::wish() const {
  const int what = pane_->currentData().toInt();
  PictureWish wish;
  wish.scale = scale_->currentData().toInt();
  wish.crosshair = crosshair_->isChecked();
  if (what == kTurntable) {
    wish.pane = views_.shown3d();
    wish.turns = turns_->currentData().toInt();
  } else if (what != kAll) {
    wish.pane = views_.shown().at(static_cast<std::size_t>(what));
  }
  return wish;
}

void PictureDialog::refresh() {
  const PictureWish now = wish();
  const QSize size = views_.pictureSize(now.pane, now.scale);
  size_->setText(tr("%1 × %2").arg(size.width()).arg(size.height()));
  form_->setRowVisible(turns_, now.turns > 0);
  form_->setRowVisible(crosshair_, views_.hasCrosshair(now.pane));
  copy_->setEnabled(now.turns == 0);
}

void PictureDialog::finish(const std::function<void(const PictureWish&)>& use) {
  const PictureWish chosen = wish();
  accept();
  use(chosen);
}

}  // namespace angiomesh
