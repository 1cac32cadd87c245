// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/review_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/base/formatted.h"
#include "gui/findings/case_review.h"
#include "gui/pane/view_grid.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

enum RemarkColumn { Score, Where, Text, RemarkColumns };
enum PlaceColumn { Seen, What, PlaceColumns };

QString doubtTitle(DoubtKind kind) {
  switch (kind) {
    case DoubtKind::Hole:
      return ReviewPanel::tr("Hole");
    case DoubtKind::Neck:
      return ReviewPanel::tr("Neck");
    case DoubtKind::Missed:
      return ReviewPanel::tr("Missed?");
    case DoubtKind::Island:
      return ReviewPanel::tr("Island");
  }
  return {};
}

/// "–", 1 to 5.
void fillScores(QComboBox* box) {
  box->addItem(QStringLiteral("–"));
  for (int score = 1; score <= kBestScore; ++score) box->addItem(QString::number(score));
}

/// In the item that is there: with another one an editor that is open would start anew.
QTableWidgetItem* setCell(QTableWidget* table, int row, int column, const QString& text) {
  QTableWidgetItem* item = table->item(row, column);
  if (item == nullptr) {
    item = new QTableWidgetItem;
    table->setItem(row, column, item);
  }
  item->setText(text);
  return item;
}

void setFixedCell(QTableWidget* table, int row, int column, const QString& text) {
  QTableWidgetItem* item = setCell(table, row, column, text);
  if ((item->flags() & Qt::ItemIsEditable) != 0)
    item->setFlags(item->flags() & ~Qt::ItemIsEditable);
}

QTableWidget* makeTable(const QStringList& titles, const char* name, QWidget* parent) {
  auto* table = named(new QTableWidget(0, static_cast<int>(titles.size()), parent), name);
  table->setHorizontalHeaderLabels(titles);
  table->verticalHeader()->hide();
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setStretchLastSection(true);
  table->setSelectionBehavior(QAbstractItemView::SelectRows);
  table->setSelectionMode(QAbstractItemView::SingleSelection);
  table->setWordWrap(true);
  table->setTabKeyNavigation(false);
  return table;
}

}  // namespace

ReviewPanel::ReviewPanel(CaseReviewModel& review, const ViewGrid& views, QWidget* parent)
    : QWidget(parent), review_(review), views_(views) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(4, 4, 4, 4);
  column->setSpacing(3);
  buildVerdict(column);
  buildPlaces(column);
  buildRemarks(column);
  connect(&review_, &CaseReviewModel::changed, this, &ReviewPanel::refresh);
  refresh();
}

void ReviewPanel::buildVerdict(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  const std::array<Verdict, 2> verdicts{Verdict::Accepted, Verdict::Rejected};
  verdicts_ = {named(new QPushButton(tr("Accept"), this), "reviewAccept"),
               named(new QPushButton(tr("Reject"), this), "reviewReject")};
  for (std::size_t i = 0; i < verdicts_.size(); ++i) {
    verdicts_[i]->setCheckable(true);
    row->addWidget(verdicts_[i]);
    connect(verdicts_[i], &QPushButton::clicked, this, [this, verdict = verdicts[i]](bool on) {
      review_.setVerdict(on ? verdict : Verdict::None);
    });
  }
  row->addSpacing(8);
  row->addWidget(new QLabel(tr("Score"), this));
  score_ = named(new QComboBox(this), "reviewScore");
  score_->setToolTip(tr("Of the whole segmentation, from 1, worst, to 5, best"));
  fillScores(score_);
  connect(score_, &QComboBox::activated, this, [this](int score) { review_.setScore(score); });
  row->addWidget(score_);
  row->addStretch(1);
  column->addLayout(row);
  stale_ = named(new QLabel(tr("Given to an earlier result"), this), "reviewStale");
  keepRoom(stale_);
  column->addWidget(stale_);
}

void ReviewPanel::buildPlaces(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  count_ = named(new QLabel(this), "reviewCount");
  row->addWidget(count_, 1);
  placeButtons_ = {named(new QPushButton(tr("Find"), this), "reviewFind"),
                   named(new QPushButton(tr("Previous"), this), "reviewPrevious"),
                   named(new QPushButton(tr("Next"), this), "reviewNext")};
  placeButtons_[0]->setToolTip(
      tr("Looks for small holes, necks, high vesselness outside, and small parts that hang on "
         "nothing"));
  connect(placeButtons_[0], &QPushButton::clicked, &review_, &CaseReviewModel::find);
  connect(placeButtons_[1], &QPushButton::clicked, this, [this] { review_.step(-1); });
  connect(placeButtons_[2], &QPushButton::clicked, this, [this] { review_.step(1); });
  for (QPushButton* button : placeButtons_) row->addWidget(button);
  column->addLayout(row);
  places_ = makeTable({tr("Doubt"), tr("Why")}, "doubtfulPlaces", this);
  places_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  connect(places_, &QTableWidget::cellClicked, this, [this](int at, int) { review_.visit(at); });
  column->addWidget(places_, 3);
}

void ReviewPanel::buildRemarks(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->addWidget(new QLabel(tr("Remarks"), this), 1);
  remarkButtons_ = {named(new QPushButton(tr("Add at the crosshair"), this), "remarkAdd"),
                    named(new QPushButton(tr("Remove"), this), "remarkRemove")};
  connect(remarkButtons_[0], &QPushButton::clicked, this, [this] {
    review_.addRemark(views_.crosshair());
    const int last = remarks_->rowCount() - 1;
    if (last < 0) return;
    remarks_->setCurrentCell(last, Text);
    remarks_->editItem(remarks_->item(last, Text));
  });
  connect(remarkButtons_[1], &QPushButton::clicked, this,
          [this] { review_.removeRemark(remarks_->currentRow()); });
  for (QPushButton* button : remarkButtons_) row->addWidget(button);
  column->addLayout(row);
  remarks_ = makeTable({tr("Score"), tr("Place"), tr("Remark")}, "remarks", this);
  remarks_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
  connect(remarks_, &QTableWidget::itemChanged, this,
          [this](QTableWidgetItem* item) { remarkEdited(item->row()); });
  connect(remarks_, &QTableWidget::cellClicked, this, [this](int at, int) {
    const Eigen::Vector3d& p = review_.review().remarks[static_cast<std::size_t>(at)].pointLps;
    Q_EMIT review_.goTo(p[0], p[1], p[2], 0.0);
  });
  column->addWidget(remarks_, 2);
}

void ReviewPanel::remarkEdited(int row) {
  const auto* score = qobject_cast<QComboBox*>(remarks_->cellWidget(row, Score));
  review_.setRemark(row, score->currentIndex(), remarks_->item(row, Text)->text());
}

void ReviewPanel::refresh() {
  refreshVerdict();
  refreshPlaces();
  refreshRemarks();
}

void ReviewPanel::refreshVerdict() {
  const CaseReview& review = review_.review();
  verdicts_[0]->setChecked(review.verdict == Verdict::Accepted);
  verdicts_[1]->setChecked(review.verdict == Verdict::Rejected);
  score_->setCurrentIndex(review.score);
  for (QPushButton* button : verdicts_) button->setEnabled(review_.canReview());
  score_->setEnabled(review_.canReview());
  stale_->setVisible(review_.verdictStale());
}

void ReviewPanel::refreshPlaces() {
  const auto& places = review_.places();
  QString count = tr("Doubtful places");
  if (review_.finding())
    count = tr("Looking for doubtful places…");
  else if (review_.found())
    count = tr("%1 of %2 doubtful places seen").arg(review_.seenCount()).arg(places.size());
  count_->setText(count);
  placeButtons_[0]->setEnabled(review_.canReview() && !review_.found() && !review_.finding());
  for (const std::size_t i : {1, 2}) placeButtons_[i]->setEnabled(review_.canReview());
  places_->setRowCount(static_cast<int>(places.size()));
  for (int i = 0; i < places_->rowCount(); ++i) {
    const DoubtfulPlace& place = places[static_cast<std::size_t>(i)];
    const QString sign = review_.seen(i) ? QStringLiteral("✓ ") : QStringLiteral("○ ");
    setCell(places_, i, Seen, sign + doubtTitle(place.kind));
    setCell(places_, i, What, QString::fromStdString(place.text))
        ->setToolTip(QString::fromStdString(placeText(place.pointLps)));
  }
  if (review_.current() >= 0) places_->setCurrentCell(review_.current(), What);
}

void ReviewPanel::refreshRemarks() {
  const QSignalBlocker quiet(remarks_);
  const auto& remarks = review_.review().remarks;
  remarks_->setRowCount(static_cast<int>(remarks.size()));
  for (int row = 0; row < remarks_->rowCount(); ++row) {
    const ReviewRemark& remark = remarks[static_cast<std::size_t>(row)];
    auto* score = qobject_cast<QComboBox*>(remarks_->cellWidget(row, Score));
    if (score == nullptr) {
      score = new QComboBox(remarks_);
      score->setToolTip(tr("Of the vessel there, from 1, worst, to 5, best"));
      fillScores(score);
      remarks_->setCellWidget(row, Score, score);
      // The row may have moved up meanwhile.
      connect(score, &QComboBox::activated, this, [this, score] {
        for (int at = 0; at < remarks_->rowCount(); ++at)
          if (remarks_->cellWidget(at, Score) == score) remarkEdited(at);
      });
    }
    score->setCurrentIndex(remark.score);
    setFixedCell(remarks_, row, Where, QString::fromStdString(placeText(remark.pointLps)));
    setCell(remarks_, row, Text, QString::fromStdString(remark.text));
  }
  remarkButtons_[0]->setEnabled(review_.canReview());
  remarkButtons_[1]->setEnabled(!remarks.empty());
}

}  // namespace angiomesh
