// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <QApplication>
#include <QImage>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>
#include <QWidget>
#include <memory>

#include "core/image/volume.h"
#include "gui/view/open_gl.h"

namespace angiomesh::test {

/// A bright ball in an oblique volume.
inline std::shared_ptr<Volume<float>> makeImage() {
  Geometry g;
  g.size = {40, 44, 36};
  g.spacing = {0.9, 1.0, 1.2};
  g.direction = Eigen::AngleAxisd(0.3, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  g.origin = {-20.0, 15.0, 130.0};
  auto image = std::make_shared<Volume<float>>(g);
  for (std::size_t p = 0; p < image->voxels.size(); ++p) {
    const Index3 v = g.indexOf(p);
    const double r = (Eigen::Vector3d(v[0], v[1], v[2]) - Eigen::Vector3d(20, 22, 18)).norm();
    image->voxels[p] = static_cast<float>(r < 10.0 ? 1000.0 : 5.0 * (p % 7));
  }
  return image;
}

inline void sendMouse(QWidget& widget, QEvent::Type type, const QPoint& at, Qt::MouseButton button,
                      Qt::MouseButtons buttons, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QMouseEvent event(type, at, widget.mapToGlobal(QPointF(at)), button, buttons, modifiers);
  QApplication::sendEvent(&widget, &event);
}

inline void drag(QWidget& widget, Qt::MouseButton button, const QPoint& from, const QPoint& to,
                 Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  sendMouse(widget, QEvent::MouseButtonPress, from, button, button, modifiers);
  for (int step = 1; step <= 5; ++step)
    sendMouse(widget, QEvent::MouseMove, from + (to - from) * step / 5, Qt::NoButton, button,
              modifiers);
  sendMouse(widget, QEvent::MouseButtonRelease, to, button, Qt::NoButton, modifiers);
}

inline void wheel(QWidget& widget, const QPoint& at, const QPoint& delta,
                  Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
  QWheelEvent event(at, widget.mapToGlobal(QPointF(at)), QPoint(), delta, Qt::NoButton, modifiers,
                    Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

/// Share of the pixels that are not nearly black.
inline double litShare(const QImage& picture) {
  int lit = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      if (qGray(picture.pixel(x, y)) > 60) ++lit;
  return static_cast<double>(lit) / (picture.width() * picture.height());
}

/// main() of a test program with windows: settings go to a folder that vanishes.
template <class T, class Application = QApplication>
int runWindowTests(int argc, char** argv) {
  prepareOpenGl();
  Application application(argc, argv);
  QCoreApplication::setOrganizationName("AngiomeshTest");
  QCoreApplication::setApplicationName("AngiomeshTest");
  const QTemporaryDir settings;
  QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, settings.path());
  T test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace angiomesh::test
