// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/open_gl.h"

#include <QSurfaceFormat>

namespace angiomesh {

void prepareOpenGl() {
  QSurfaceFormat format;
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSamples(0);
  QSurfaceFormat::setDefaultFormat(format);
}

}  // namespace angiomesh
