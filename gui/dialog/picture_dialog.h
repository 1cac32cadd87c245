// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <functional>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace angiomesh {

class ViewGrid;
class VtkView;

/// Which picture is to be taken.
struct PictureWish {
  VtkView* pane = nullptr;  ///< null: all that can be seen
  int scale = 1;            ///< of the panes' pixels
  bool crosshair = false;
  int turns = 0;  ///< pictures of a turntable of the 3D pane; 0: a picture
};

/// Asks which picture is to be taken, and what becomes of it.
class PictureDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param pane to begin with; null: all
  PictureDialog(const ViewGrid& views, VtkView* pane, QWidget* parent = nullptr);

  /// The dialog is open until one of them was called.
  std::function<void(const PictureWish&)> save, copy;

 private:
  void addChoices(VtkView* pane);
  void refresh();
  void finish(const std::function<void(const PictureWish&)>& use);
  [[nodiscard]] PictureWish wish() const;

  const ViewGrid& views_;
  QFormLayout* form_;
  QComboBox* pane_;
  QComboBox* scale_;
  QComboBox* turns_;
  QCheckBox* crosshair_;
  QLabel* size_;
  QPushButton* copy_;
};

}  // namespace angiomesh
