// SPDX-License-Identifier: BSD-3-Clause
#include "gui/action_icon.h"

#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>
#include <utility>

namespace angiomesh {

namespace {

class PaletteIconEngine : public QIconEngine {
 public:
  explicit PaletteIconEngine(QByteArray svg) : svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State /*on*/) override {
    const QPalette palette = QGuiApplication::palette();
    const QColor colour = mode == QIcon::Disabled
                              ? palette.color(QPalette::Disabled, QPalette::ButtonText)
                              : palette.color(QPalette::Active, QPalette::ButtonText);
    QByteArray coloured = svg_;
    coloured.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer(coloured).render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap picture(size);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    paint(&painter, QRect({}, size), mode, state);
    return picture;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new PaletteIconEngine(*this); }

 private:
  QByteArray svg_;
};

}  // namespace

QIcon actionIcon(const QString& action) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(action));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new PaletteIconEngine(file.readAll()));
}

}  // namespace angiomesh
