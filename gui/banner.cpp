// SPDX-License-Identifier: BSD-3-Clause
#include "gui/banner.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/view/named.h"

namespace angiomesh {

namespace {

constexpr int kMargin = 16;
/// Of the text, in widths of an average letter.
constexpr int kLettersWide = 80;

}  // namespace

Banner::Banner(QWidget* parent)
    : QFrame(parent), text_(named(new QLabel(this), "bannerText")), buttons_(new QHBoxLayout) {
  setObjectName("banner");
  setFrameShape(QFrame::StyledPanel);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::ToolTipBase);
  text_->setWordWrap(true);
  text_->setForegroundRole(QPalette::ToolTipText);
  text_->setTextFormat(Qt::PlainText);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
  column->setSpacing(kMargin);
  column->addWidget(text_);
  column->addLayout(buttons_);
  buttons_->addStretch(1);
  auto* close = named(new QPushButton(tr("Close"), this), "closeBanner");
  buttons_->addWidget(close);
  connect(close, &QPushButton::clicked, this, &QWidget::hide);
  parent->installEventFilter(this);
  hide();
}

QPushButton* Banner::addButton(QAction* action) {
  auto* button = named(new QPushButton(action->iconText(), this), action->objectName() + "Next");
  buttons_->insertWidget(buttons_->count() - 1, button);
  connect(button, &QPushButton::clicked, action, &QAction::trigger);
  connect(button, &QPushButton::clicked, this, &QWidget::hide);
  return button;
}

void Banner::tell(const QString& text) {
  text_->setText(text);
  show();
  raise();
  place();
}

bool Banner::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && isVisible()) place();
  return QFrame::eventFilter(watched, event);
}

void Banner::place() {
  const QRect room = parentWidget()->rect();
  const int wanted = kLettersWide * fontMetrics().averageCharWidth() + 2 * kMargin;
  const int width =
      std::max(std::min(wanted, room.width() - 2 * kMargin), minimumSizeHint().width());
  const int height = heightForWidth(width);
  setGeometry((room.width() - width) / 2, (room.height() - height) / 2, width, height);
}

}  // namespace angiomesh
