// SPDX-License-Identifier: BSD-3-Clause
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>

// Ends with 0 where a display opens and OpenGL works on it. Qt ends the program with an abort where
// no display opens, hence a program of its own.
int main(int argc, char** argv) {
  const QGuiApplication application(argc, argv);
  QOpenGLContext context;
  if (!context.create()) return 1;
  QOffscreenSurface surface;
  surface.create();
  return context.makeCurrent(&surface) ? 0 : 1;
}
