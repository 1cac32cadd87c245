// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/view_buttons.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>
#include <array>
#include <utility>

#include "gui/view/surface_view.h"

namespace angiomesh {

QPalette paletteOnPictures() {
  QPalette dark(QColor(58, 66, 82), QColor(40, 46, 58));
  for (const QPalette::ColorRole role :
       {QPalette::ButtonText, QPalette::Text, QPalette::WindowText})
    dark.setColor(role, QColor(236, 230, 184));
  return dark;
}

ViewButtons::ViewButtons(SurfaceView* view) : QWidget(view) {
  const std::array<std::pair<char, QString>, 6> sides{
      {{'A', tr("From the front (A)")},
       {'P', tr("From the back (P)")},
       {'L', tr("From the patient's left (L)")},
       {'R', tr("From the patient's right (Shift+R)")},
       {'S', tr("From the head (S)")},
       {'I', tr("From the feet (I)")}}};
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(1);
  for (const auto& [side, tip] : sides) {
    auto* button = new QToolButton(this);
    button->setObjectName(QStringLiteral("from") + QLatin1Char(side));
    button->setText(QString(QLatin1Char(side)));
    button->setToolTip(tip);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::NoFocus);
    connect(button, &QToolButton::clicked, view, [view, from = side] { view->viewFrom(from); });
    row->addWidget(button);
  }
  setPalette(paletteOnPictures());
  setAutoFillBackground(true);
  view->installEventFilter(this);
  place();
}

bool ViewButtons::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) place();
  return QWidget::eventFilter(watched, event);
}

void ViewButtons::place() {
  constexpr int margin = 8;
  adjustSize();
  const QSize room = parentWidget()->size();
  move(room.width() - width() - margin, room.height() - height() - margin);
  setVisible(room.width() > 2 * width());
}

}  // namespace angiomesh
