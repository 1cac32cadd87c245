// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QPalette>
#include <QWidget>

namespace angiomesh {

class SurfaceView;

/// Of widgets that lie on a dark picture, whatever the theme.
QPalette paletteOnPictures();

/// Buttons in the lower right corner of a 3D pane that look from each side of the patient.
class ViewButtons : public QWidget {
  Q_OBJECT

 public:
  explicit ViewButtons(SurfaceView* view);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void place();
};

}  // namespace angiomesh
