// SPDX-License-Identifier: BSD-3-Clause
#include "gui/theme.h"

#include <QApplication>
#include <QPalette>
#include <QSettings>
#include <QStyle>
#include <algorithm>

namespace angiomesh {

namespace {

const QString kThemeKey = QStringLiteral("theme");
constexpr const char* kStyle = "fusion";

struct Colours {
  QRgb window, base, button, text, faint, highlight, link, note;
};

constexpr Colours kLight{0xffefefef, 0xffffffff, 0xfff4f4f4, 0xff1b1b1b,
                         0xff8c8c8c, 0xff2d7fc1, 0xff0057ae, 0xffffffdc};
constexpr Colours kDark{0xff2b2d30, 0xff1e1f22, 0xff3a3d41, 0xffe3e3e3,
                        0xff858585, 0xff3a86c8, 0xff6cb2f0, 0xff4a4630};

QPalette paletteOf(const Colours& colours) {
  // Roles that are not set are the platform's; the shades of frames follow from these two.
  const QPalette shades{QColor(colours.button), QColor(colours.window)};
  QPalette palette = shades;
  for (const auto role : {QPalette::Window, QPalette::Button, QPalette::Light, QPalette::Midlight,
                          QPalette::Mid, QPalette::Dark, QPalette::Shadow})
    palette.setColor(role, shades.color(role));
  const QColor text(colours.text), faint(colours.faint), base(colours.base);
  for (const auto role :
       {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
    palette.setColor(role, text);
    palette.setColor(QPalette::Disabled, role, faint);
  }
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, QColor(colours.window));
  palette.setColor(QPalette::PlaceholderText, faint);
  palette.setColor(QPalette::ToolTipBase, QColor(colours.note));
  palette.setColor(QPalette::Highlight, QColor(colours.highlight));
  palette.setColor(QPalette::Disabled, QPalette::Highlight, faint);
  palette.setColor(QPalette::HighlightedText, Qt::white);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::Link, QColor(colours.link));
  palette.setColor(QPalette::LinkVisited, QColor(colours.link));
  return palette;
}

}  // namespace

void applyTheme(Theme theme) {
  // One style, so that both palettes reach everything it draws.
  if (QApplication::style()->name() != QLatin1String(kStyle)) QApplication::setStyle(kStyle);
  QApplication::setPalette(theme == Theme::Light  ? paletteOf(kLight)
                           : theme == Theme::Dark ? paletteOf(kDark)
                                                  : QPalette());
}

Theme rememberedTheme() {
  const int kept = QSettings().value(kThemeKey).toInt();
  return static_cast<Theme>(std::clamp(kept, 0, static_cast<int>(Theme::Dark)));
}

void rememberTheme(Theme theme) { QSettings().setValue(kThemeKey, static_cast<int>(theme)); }

}  // namespace angiomesh
