// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QWidget>
#include <array>

#include "core/parameters/field.h"
#include "gui/model/step_text.h"

class QAbstractSpinBox;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QSlider;
class QToolButton;

namespace angiomesh {

/// One row of a form, made from a field's description: numbers get a slider and a spin box (and a
/// box for "auto" or "none" where they may be empty), choices a combo box, switches a check box,
/// lists of numbers a summary and a button that empties them. Shows what it is told to.
class FieldEditor : public QWidget {
  Q_OBJECT

 public:
  explicit FieldEditor(const Field& field, QWidget* parent = nullptr);

  [[nodiscard]] const Field& field() const { return field_; }
  /// Emits nothing. @param suggested shown greyed while the value is empty   @param range of the
  /// slider, stored units; the spin box reaches all of the field's
  void display(const FieldValue& value, const FieldValue& suggested,
               const std::array<double, 2>& range);
  /// Disables the editor and says why in its tooltip; "" enables it.
  void setIdle(const QString& why);
  /// Whether the value is another one than a preset's, and which: a button goes back to it.
  void setBase(const FieldValue& base, const QString& preset, bool changed);

 Q_SIGNALS:
  /// By the user. `continued`: the same drag of the slider goes on.
  void edited(const QString& key, const angiomesh::FieldValue& value, bool continued);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setSliderRange(const std::array<double, 2>& range);
  void buildNumber(QHBoxLayout& row);
  void buildChoice(QHBoxLayout& row);
  void buildNumbers(QHBoxLayout& row);
  void buildReset(QHBoxLayout& row);
  void keepFromWheel(QWidget* widget);
  [[nodiscard]] double sliderToValue(int position) const;
  [[nodiscard]] int valueToSlider(double value) const;
  [[nodiscard]] FieldValue numberValue(double stored) const;
  void sliderMoved(int position);
  void spinChanged(double shown);
  void autoToggled(bool on);
  void showNumber(double stored);

  const Field& field_;
  double lowest_ = 0.0, highest_ = 1.0;  ///< of the slider, stored units
  bool logarithmic_ = false;
  bool dragging_ = false;
  FieldValue suggested_, base_;
  QSlider* slider_ = nullptr;
  QDoubleSpinBox* spin_ = nullptr;
  QCheckBox* empty_ = nullptr;
  QCheckBox* check_ = nullptr;
  QComboBox* combo_ = nullptr;
  QLabel* summary_ = nullptr;
  QPushButton* clear_ = nullptr;
  QToolButton* reset_ = nullptr;
};

}  // namespace angiomesh
