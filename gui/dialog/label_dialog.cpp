// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/label_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/view/named.h"

namespace angiomesh {

namespace {

enum Column { Value, Name, Voxels, VolumeMl, ColumnCount };

}  // namespace

LabelDialog::LabelDialog(const std::vector<Label>& labels, double voxelMm3, QWidget* parent)
    : QDialog(parent) {
  setObjectName("labelDialog");
  setWindowTitle(tr("Choose a label"));
  resize(520, 420);
  auto* layout = new QVBoxLayout(this);
  auto* note = new QLabel(
      tr("This is a segmentation with %1 labels. Which one is the vessel?").arg(labels.size()),
      this);
  note->setWordWrap(true);
  layout->addWidget(note);
  table_ =
      named(new QTableWidget(static_cast<int>(labels.size()), ColumnCount, this), "labelTable");
  table_->setHorizontalHeaderLabels({tr("Label"), tr("Name"), tr("Voxels"), tr("Volume, ml")});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  const QLocale locale;
  for (int row = 0; row < table_->rowCount(); ++row) {
    const Label& label = labels[static_cast<std::size_t>(row)];
    const auto put = [&](Column column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setTextAlignment(column == Name ? Qt::AlignLeft | Qt::AlignVCenter
                                            : Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    };
    put(Value, QString::number(label.value));
    put(Name, QString::fromStdString(label.name));
    put(Voxels, locale.toString(static_cast<qulonglong>(label.voxels)));
    put(VolumeMl, locale.toString(1e-3 * voxelMm3 * static_cast<double>(label.voxels), 'g', 3));
  }
  table_->resizeColumnsToContents();
  table_->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
  const bool haveNames = std::any_of(labels.begin(), labels.end(),
                                     [](const Label& label) { return !label.name.empty(); });
  const bool layered =
      std::any_of(labels.begin(), labels.end(), [](const Label& label) { return label.layer > 0; });
  table_->setColumnHidden(Name, !haveNames);
  table_->horizontalHeader()->setStretchLastSection(!haveNames);
  layout->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* open =
      named(buttons->addButton(tr("Open the label"), QDialogButtonBox::AcceptRole), "labelOpen");
  open->setDefault(true);
  if (!layered) {
    auto* scan =
        named(buttons->addButton(tr("It is a scan"), QDialogButtonBox::ActionRole), "labelScan");
    connect(scan, &QPushButton::clicked, this, [this] {
      asScan_ = true;
      accept();
    });
  }
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(table_, &QTableWidget::cellDoubleClicked, this, &QDialog::accept);
  table_->selectRow(0);
}

LabelAnswer LabelDialog::answer() const {
  if (asScan_) return std::nullopt;
  return static_cast<std::size_t>(std::max(table_->currentRow(), 0));
}

}  // namespace angiomesh
