// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/field_editor.h"

#include "core/parameters/field.h"
#include "gui/view/named.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <cmath>

namespace angiomesh {

namespace {

constexpr int kSliderSteps = 1000;
/// Of a spin box beside its number, pixels.
constexpr int kSpinFrame = 32;
/// Width of a slider in the narrowest panel, pixels.
constexpr int kLeastSlider = 16;
/// Of a choice in the narrowest panel.
constexpr int kComboLetters = 12;
/// Of the button that goes back to the preset's value, pixels.
constexpr int kResetSide = 18;
/// Decades that a logarithmic slider spans when its field begins at 0.
constexpr double kDecades = 1e4;

/// A slider over more than this ratio moves in equal ratios.
constexpr double kLinearRatio = 1e3;

QString translated(const std::string& text) {
  return QCoreApplication::translate("Parameter", text.c_str());
}

/// Enough to tell the smallest step of the slider.
int decimalsFor(const Field& field, double factor) {
  if (field.kind == FieldKind::Integer) return 0;
  const double range = (field.maximum - field.minimum) * factor;
  return std::clamp(4 - static_cast<int>(std::floor(std::log10(range))), 2, 3);
}

/// All rows have one column of labels, as wide as those in sight at first need; longer ones wrap.
int labelWidth(const QFontMetrics& metrics) {
  int width = 0;
  for (const Field& field : parameterFields())
    if (field.main && field.kind != FieldKind::Boolean)
      width = std::max(width, metrics.horizontalAdvance(labelOf(field)));
  return width + 2;
}

double asNumber(const FieldValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&value);
  return real ? *real : 0.0;
}

}  // namespace

FieldEditor::FieldEditor(const Field& field, QWidget* parent) : QWidget(parent), field_(field) {
  setObjectName("field:" + QString::fromStdString(field.key));
  setIdle({});
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  if (field.kind == FieldKind::Boolean) {
    check_ = named(new QCheckBox(labelOf(field), this), "check");
    row->addWidget(check_, 1);
    connect(check_, &QCheckBox::clicked, this,
            [this](bool on) { Q_EMIT edited(QString::fromStdString(field_.key), on, false); });
    buildReset(*row);
    return;
  }
  auto* label = new QLabel(labelOf(field), this);
  label->setWordWrap(true);
  label->setFixedWidth(labelWidth(label->fontMetrics()));
  row->addWidget(label);
  switch (field.kind) {
    case FieldKind::Integer:
    case FieldKind::Real:
      buildNumber(*row);
      break;
    case FieldKind::Choice:
      buildChoice(*row);
      break;
    default:
      buildNumbers(*row);
      return;
  }
  buildReset(*row);
}

void FieldEditor::buildReset(QHBoxLayout& row) {
  reset_ = named(new QToolButton(this), "reset");
  reset_->setText(QStringLiteral("↺"));
  reset_->setAutoRaise(true);
  reset_->setFixedSize(kResetSide, kResetSide);
  QSizePolicy policy = reset_->sizePolicy();
  policy.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(policy);
  reset_->hide();
  row.addWidget(reset_);
  connect(reset_, &QToolButton::clicked, this,
          [this] { Q_EMIT edited(QString::fromStdString(field_.key), base_, false); });
}

void FieldEditor::setBase(const FieldValue& base, const QString& preset, bool changed) {
  if (!reset_) return;
  base_ = base;
  reset_->setVisible(changed);
  if (!changed) return;
  const bool number = spin_ && !std::holds_alternative<std::monostate>(base);
  const QString value =
      number
          ? spin_->locale().toString(asNumber(base) * field_.shownTimes, 'g', 6) + spin_->suffix()
      : field_.kind == FieldKind::Boolean ? (std::get<bool>(base) ? tr("on") : tr("off"))
                                          : QString::fromStdString(fieldText(base, field_));
  reset_->setToolTip(tr("Changed. Back to %1, as in the preset %2.").arg(value, preset));
}

void FieldEditor::keepFromWheel(QWidget* widget) {
  widget->setFocusPolicy(Qt::StrongFocus);
  widget->installEventFilter(this);
}

bool FieldEditor::eventFilter(QObject* watched, QEvent* event) {
  // Scrolling the panel must not change what happens to pass under the pointer.
  auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && widget && !widget->hasFocus()) {
    event->ignore();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void FieldEditor::buildNumber(QHBoxLayout& row) {
  lowest_ =
      field_.logarithmic && field_.minimum <= 0.0 ? field_.maximum / kDecades : field_.minimum;
  slider_ = named(new QSlider(Qt::Horizontal, this), "slider");
  slider_->setRange(0, kSliderSteps);
  slider_->setMinimumWidth(kLeastSlider);
  keepFromWheel(slider_);
  row.addWidget(slider_, 1);
  spin_ = named(new QDoubleSpinBox(this), "spin");
  spin_->setDecimals(decimalsFor(field_, field_.shownTimes));
  spin_->setRange(field_.minimum * field_.shownTimes, field_.maximum * field_.shownTimes);
  if (field_.kind == FieldKind::Integer)
    spin_->setSingleStep(1.0);
  else
    spin_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
  spin_->setKeyboardTracking(false);
  spin_->setFixedWidth(spin_->fontMetrics().horizontalAdvance("00.00 mm") + kSpinFrame);
  spin_->setAlignment(Qt::AlignRight);
  const QString unit = QString::fromStdString(field_.unit);
  if (!unit.isEmpty() && unit.size() <= 4) spin_->setSuffix(' ' + unit);
  keepFromWheel(spin_);
  row.addWidget(spin_);
  if (!field_.emptyWord.empty()) {
    empty_ = named(new QCheckBox(QString::fromStdString(field_.emptyWord), this), "empty");
    row.addWidget(empty_);
    connect(empty_, &QCheckBox::clicked, this, &FieldEditor::autoToggled);
  }
  connect(slider_, &QSlider::valueChanged, this, &FieldEditor::sliderMoved);
  connect(slider_, &QSlider::sliderReleased, this, [this] { dragging_ = false; });
  connect(spin_, &QDoubleSpinBox::valueChanged, this, &FieldEditor::spinChanged);
}

void FieldEditor::buildChoice(QHBoxLayout& row) {
  combo_ = named(new QComboBox(this), "combo");
  for (const std::string& choice : field_.choices) combo_->addItem(QString::fromStdString(choice));
  // The longest choice is rarely the one in use.
  combo_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  combo_->setMinimumContentsLength(kComboLetters);
  keepFromWheel(combo_);
  row.addWidget(combo_, 1);
  connect(combo_, &QComboBox::textActivated, this, [this](const QString& text) {
    Q_EMIT edited(QString::fromStdString(field_.key), text.toStdString(), false);
  });
}

void FieldEditor::buildNumbers(QHBoxLayout& row) {
  summary_ = named(new QLabel(this), "summary");
  row.addWidget(summary_, 1);
  clear_ = named(new QPushButton(tr("Clear"), this), "clear");
  row.addWidget(clear_);
  connect(clear_, &QPushButton::clicked, this, [this] {
    FieldValue none = std::vector<double>();
    if (!field_.emptyWord.empty()) none = std::monostate();
    Q_EMIT edited(QString::fromStdString(field_.key), none, false);
  });
}

void FieldEditor::setIdle(const QString& why) {
  setEnabled(why.isEmpty());
  QString text = translated(field_.help) + QStringLiteral("  [%1]").arg(field_.key.c_str());
  if (!field_.rise.empty()) text += '\n' + tr("Larger: %1.").arg(translated(field_.rise));
  if (!why.isEmpty()) text += '\n' + tr("Has no effect now: %1.").arg(why);
  setToolTip(text);
}

void FieldEditor::setSliderRange(const std::array<double, 2>& range) {
  highest_ = range[1];
  logarithmic_ =
      range[0] >= 0.0 && (field_.logarithmic || range[1] > kLinearRatio * std::max(range[0], 1.0));
  lowest_ = logarithmic_ && range[0] <= 0.0 ? highest_ / kDecades : range[0];
}

double FieldEditor::sliderToValue(int position) const {
  const double t = static_cast<double>(position) / kSliderSteps;
  if (position == 0 && logarithmic_ && field_.minimum <= 0.0) return 0.0;
  const double value =
      logarithmic_ ? lowest_ * std::pow(highest_ / lowest_, t) : lowest_ + t * (highest_ - lowest_);
  // A drag gives numbers that a person would write: three significant digits.
  const double scale =
      value == 0.0 ? 1.0 : std::pow(10.0, 2.0 - std::floor(std::log10(std::abs(value))));
  const double rounded =
      field_.kind == FieldKind::Integer ? std::round(value) : std::round(value * scale) / scale;
  return std::clamp(rounded, field_.minimum, field_.maximum);
}

int FieldEditor::valueToSlider(double value) const {
  const double t = logarithmic_
                       ? std::log(std::max(value, lowest_) / lowest_) / std::log(highest_ / lowest_)
                       : (value - lowest_) / (highest_ - lowest_);
  return static_cast<int>(std::lround(std::clamp(t, 0.0, 1.0) * kSliderSteps));
}

FieldValue FieldEditor::numberValue(double stored) const {
  if (field_.kind == FieldKind::Integer) return static_cast<std::int64_t>(std::llround(stored));
  return stored;
}

void FieldEditor::sliderMoved(int position) {
  const bool continued = dragging_;
  dragging_ = slider_->isSliderDown();
  const double stored = sliderToValue(position);
  Q_EMIT edited(QString::fromStdString(field_.key), numberValue(stored), continued);
}

void FieldEditor::spinChanged(double shown) {
  Q_EMIT edited(QString::fromStdString(field_.key), numberValue(shown / field_.shownTimes), false);
}

void FieldEditor::autoToggled(bool on) {
  Q_EMIT edited(QString::fromStdString(field_.key), on ? FieldValue() : suggested_, false);
}

void FieldEditor::showNumber(double stored) {
  const QSignalBlocker quietSlider(slider_);
  const QSignalBlocker quietSpin(spin_);
  if (!slider_->isSliderDown()) slider_->setValue(valueToSlider(stored));
  spin_->setValue(stored * field_.shownTimes);
}

void FieldEditor::display(const FieldValue& value, const FieldValue& suggested,
                          const std::array<double, 2>& range) {
  suggested_ = suggested;
  const bool empty = std::holds_alternative<std::monostate>(value);
  if (check_) {
    check_->setChecked(std::get<bool>(value));
  } else if (combo_) {
    combo_->setCurrentText(QString::fromStdString(std::get<std::string>(value)));
  } else if (spin_) {
    if (empty_) empty_->setChecked(empty);
    setSliderRange(range);
    slider_->setEnabled(!empty);
    spin_->setEnabled(!empty);
    showNumber(asNumber(empty ? suggested : value));
  } else {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    const auto* texts = std::get_if<std::vector<std::string>>(&value);
    const std::size_t count = numbers ? numbers->size() : texts ? texts->size() : 0;
    const std::size_t group = std::max<std::size_t>(field_.groupOf, 1);
    clear_->setEnabled(count > 0);
    summary_->setText(count == 0   ? tr("none")
                      : texts      ? tr("%1: %2").arg(labelOf(field_).toLower()).arg(count)
                      : group == 3 ? tr("points: %1").arg(count / group)
                                   : tr("set"));
  }
}

}  // namespace angiomesh
