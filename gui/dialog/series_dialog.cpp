// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/series_dialog.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr int kPicture = 96;
constexpr int kPollMilliseconds = 33;

enum Column { Thumbnail, Description, Modality, Size, Spacing, Orientation, Number, Date, State };

QString text(const std::string& value) { return QString::fromStdString(value); }

/// A volume can be made of it, if need be by resampling.
bool isUsable(const ImageSummary& entry) {
  const Finding* refusal = entry.refusal();
  return refusal == nullptr || canBeEvenedOut(refusal->kind);
}

QString stateOf(const ImageSummary& entry) {
  const Finding* refusal = entry.refusal();
  if (refusal == nullptr) return SeriesDialog::tr("ready");
  return isUsable(entry) ? SeriesDialog::tr("uneven slices") : SeriesDialog::tr("no volume");
}

}  // namespace

SeriesDialog::SeriesDialog(const std::vector<ImageSummary>& entries,
                           const JobRunnerFactory& makeRunner, QWidget* parent)
    : QDialog(parent),
      entries_(entries),
      thumbnails_(std::make_shared<ThumbnailJob>(entries, kPicture)),
      runner_(makeRunner()) {
  setObjectName("seriesDialog");
  setWindowTitle(tr("Choose a series"));
  resize(1040, 560);
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(new QLabel(tr("%1 volumes were found.").arg(entries_.size()), this));
  table_ =
      named(new QTableWidget(static_cast<int>(entries_.size()), State + 1, this), "seriesTable");
  table_->setHorizontalHeaderLabels({QString(), tr("Description"), tr("Modality"), tr("Size"),
                                     tr("Spacing, mm"), tr("Orientation"), tr("No."), tr("Date"),
                                     tr("State")});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(kPicture + 4);
  table_->setIconSize(QSize(kPicture, kPicture));
  for (int row = 0; row < table_->rowCount(); ++row) fillRow(row);
  table_->resizeColumnsToContents();
  table_->setColumnWidth(Thumbnail, kPicture + 12);
  table_->horizontalHeader()->setSectionResizeMode(Description, QHeaderView::Stretch);
  layout->addWidget(table_, 1);
  note_ = named(new QLabel(this), "seriesNote");
  note_->setWordWrap(true);
  note_->setMinimumHeight(3 * note_->fontMetrics().height());
  layout->addWidget(note_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  open_ = named(buttons->addButton(tr("Open"), QDialogButtonBox::AcceptRole), "seriesOpen");
  open_->setDefault(true);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &SeriesDialog::refresh);
  connect(table_, &QTableWidget::cellDoubleClicked, this, [this] {
    if (open_->isEnabled()) accept();
  });
  connect(&timer_, &QTimer::timeout, this, &SeriesDialog::takeThumbnails);
  runner_->start([job = thumbnails_] { job->execute(); });
  timer_.start(kPollMilliseconds);
  takeThumbnails();
  table_->selectRow(0);
}

SeriesDialog::~SeriesDialog() {
  thumbnails_->cancel();
  runner_->wait();
}

std::optional<std::size_t> SeriesDialog::chosen() const {
  const int row = table_->currentRow();
  if (row < 0 || !isUsable(entries_[static_cast<std::size_t>(row)])) return std::nullopt;
  return static_cast<std::size_t>(row);
}

void SeriesDialog::fillRow(int row) {
  const ImageSummary& entry = entries_[static_cast<std::size_t>(row)];
  const Geometry& g = entry.geometry;
  const auto put = [&](Column column, const QString& value) {
    auto* item = new QTableWidgetItem(value);
    item->setToolTip(value);
    table_->setItem(row, column, item);
  };
  put(Thumbnail, {});
  put(Description, text(entry.info.seriesDescription));
  put(Modality, text(entry.info.modality));
  put(Size, QStringLiteral("%1 × %2 × %3").arg(g.size[0]).arg(g.size[1]).arg(g.size[2]));
  put(Spacing, QStringLiteral("%1 × %2 × %3")
                   .arg(g.spacing[0], 0, 'g', 3)
                   .arg(g.spacing[1], 0, 'g', 3)
                   .arg(g.spacing[2], 0, 'g', 3));
  put(Orientation, text(entry.info.orientation));
  put(Number, text(entry.info.seriesNumber));
  put(Date, text(entry.info.date));
  put(State, stateOf(entry));
}

void SeriesDialog::refresh() {
  const int row = table_->currentRow();
  QStringList notes;
  if (row >= 0)
    for (const Finding& finding : entries_[static_cast<std::size_t>(row)].info.findings)
      notes << text(screenText(finding));
  note_->setText(notes.join('\n'));
  open_->setEnabled(chosen().has_value());
}

void SeriesDialog::takeThumbnails() {
  const bool ended = !runner_->running();
  for (const auto& [row, picture] : thumbnails_->take()) {
    const QImage image(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                       QImage::Format_RGB888);
    table_->item(row, Thumbnail)->setIcon(QIcon(QPixmap::fromImage(image)));
  }
  if (ended) timer_.stop();
}

}  // namespace angiomesh
