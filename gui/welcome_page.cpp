// SPDX-License-Identifier: BSD-3-Clause
#include "gui/welcome_page.h"

#include <QAction>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/recent_cases.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr double kTitleTimes = 2.0;
/// Of the page's contents, in widths of an average letter.
constexpr int kLettersWide = 84;
constexpr int kLinesOfRecent = 12;
constexpr int kPicture = 48;  // pixels of a side

/// In the middle of a square, so that the names of all rows begin at one place.
QIcon pictureOf(const QString& path) {
  QPixmap square(kPicture, kPicture);
  square.fill(Qt::transparent);
  const QPixmap picture(RecentCases::pictureOf(path));
  if (!picture.isNull()) {
    const QPixmap small =
        picture.scaled(kPicture, kPicture, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QPainter(&square).drawPixmap((kPicture - small.width()) / 2, (kPicture - small.height()) / 2,
                                 small);
  }
  return square;
}

QLabel* wrapped(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setWordWrap(true);
  return label;
}

}  // namespace

WelcomePage::WelcomePage(QWidget* parent)
    : QWidget(parent),
      buttons_(new QVBoxLayout),
      recentTitle_(new QLabel(tr("Open again"), this)),
      recent_(named(new QListWidget(this), "recentList")) {
  setObjectName("welcome");
  auto* content = new QWidget(this);
  content->setMaximumWidth(kLettersWide * fontMetrics().averageCharWidth());
  auto* column = new QVBoxLayout(content);
  column->setSpacing(12);
  auto* title = new QLabel(QStringLiteral("Angiomesh"), content);
  QFont large = title->font();
  large.setPointSizeF(kTitleTimes * large.pointSizeF());
  title->setFont(large);
  column->addWidget(title);
  column->addWidget(
      wrapped(tr("From an angiogram (MRA or CTA) to a vessel surface that a flow solver accepts."),
              content));
  auto* row = new QHBoxLayout;
  row->setSpacing(24);
  buttons_->setSpacing(8);
  auto* left = new QVBoxLayout;
  left->addLayout(buttons_);
  left->addSpacing(6);
  left->addWidget(
      wrapped(tr("Or drop a file, a folder or a case anywhere on this window."), content));
  left->addStretch(1);
  auto* right = new QVBoxLayout;
  right->addWidget(recentTitle_);
  right->addWidget(recent_);
  right->addStretch(1);
  row->addLayout(left, 2);
  row->addLayout(right, 3);
  column->addLayout(row);
  column->addWidget(wrapped(tr("Not a medical device: research use only."), content));
  recent_->setMaximumHeight(kLinesOfRecent * fontMetrics().lineSpacing() * 2);
  recent_->setIconSize({kPicture, kPicture});
  recent_->setTextElideMode(Qt::ElideMiddle);
  recent_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(recent_, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { Q_EMIT openRequested(item->toolTip()); });
  connect(recent_, &QListWidget::itemClicked, this,
          [this](const QListWidgetItem* item) { Q_EMIT openRequested(item->toolTip()); });
  auto* whole = new QVBoxLayout(this);
  whole->addStretch(1);
  auto* middle = new QHBoxLayout;
  middle->addStretch(1);
  middle->addWidget(content, 100);
  middle->addStretch(1);
  whole->addLayout(middle);
  whole->addStretch(2);
  setRecent({});
}

void WelcomePage::addButton(QAction* action, const QString& text) {
  auto* button = named(new QPushButton(text, this), action->objectName() + "Button");
  button->setMinimumHeight(2 * fontMetrics().height());
  connect(button, &QPushButton::clicked, action, &QAction::trigger);
  buttons_->addWidget(button);
}

void WelcomePage::setRecent(const QStringList& paths) {
  recent_->clear();
  for (const QString& path : paths) {
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), recent_);
    item->setToolTip(path);
    item->setIcon(pictureOf(path));
  }
  recentTitle_->setVisible(!paths.isEmpty());
  recent_->setVisible(!paths.isEmpty());
}

}  // namespace angiomesh
