// SPDX-License-Identifier: BSD-3-Clause
#include "gui/menu/window_menu.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QMainWindow>
#include <QMenu>
#include <QSignalBlocker>
#include <algorithm>
#include <array>
#include <cmath>

#include "gui/menu/window_actions.h"
#include "gui/view/named.h"

namespace angiomesh {

namespace {

/// In the order of WindowPreset.
constexpr std::array<const char*, kWindowPresetCount> kActions{"windowFile",  "windowPercentiles",
                                                               "windowCta",   "windowSoftTissue",
                                                               "windowBrain", "windowBone"};

/// To tell a thousandth of a window that suits the layer.
int decimalsFor(const WindowLimits& limits) {
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(limits.usual))), 0, 6);
}

void show(QDoubleSpinBox* spin, const WindowLimits& limits, double least, double greatest,
          double value) {
  const QSignalBlocker quiet(spin);
  spin->setDecimals(decimalsFor(limits));
  spin->setSingleStep(std::pow(10.0, std::floor(std::log10(limits.usual / 20.0))));
  spin->setRange(least, greatest);
  spin->setValue(value);
}

}  // namespace

WindowMenu::WindowMenu(QMainWindow* window, QMenu* parent, CaseModels& models, ViewState& state)
    : QObject(window), window_(window), models_(models), state_(state) {
  QMenu* menu = parent->addMenu(tr("Window"));
  menu->menuAction()->setObjectName("windowMenu");
  for (int i = 0; i < kWindowPresetCount; ++i) {
    const auto preset = static_cast<WindowPreset>(i);
    const QString title = windowPresetTitle(preset);
    QAction* action = addMenuToggle(window, menu, kActions[static_cast<std::size_t>(i)], title,
                                    QKeySequence(Qt::Key_1 + i), [this, preset](bool) {
                                      state_.setPresetWindow(preset);
                                      refresh();
                                    });
    action->setIconText(tr("Window: %1").arg(title));
  }
  others_ = named(menu->addMenu(tr("Other windows of the file")), "otherWindows");
  menu->addSeparator();
  addMenuAction(window, menu, "setWindow", tr("Set window and level…"), QKeySequence(Qt::Key_W),
                [this] { showDialog(); });
  addMenuAction(window, menu, "resetWindow", tr("Reset window and level"),
                QKeySequence(tr("Ctrl+W")), [this] { state_.resetWindowLevel(); });
  connect(&state_, &ViewState::changed, this, &WindowMenu::refresh);
  refresh();
}

void WindowMenu::refresh() {
  for (int i = 0; i < kWindowPresetCount; ++i) {
    QAction* action = actionOf(window_, kActions[static_cast<std::size_t>(i)]);
    const auto window = state_.presetWindow(static_cast<WindowPreset>(i));
    action->setEnabled(window.has_value());
    action->setChecked(window == state_.windowLevel());
  }
  refreshOthers();
  enableActions(window_, {"setWindow", "resetWindow"}, models_.document.hasCase());
}

void WindowMenu::refreshOthers() {
  const auto windows = state_.otherFileWindows();
  if (windows != listed_) {
    listed_ = windows;
    others_->clear();
    for (const auto& [window, name] : windows) {
      const QString numbers = tr("%1 / %2").arg(window.first).arg(window.second);
      const QString text =
          name.empty() ? numbers : tr("%1 (%2)").arg(QString::fromStdString(name), numbers);
      QAction* action = others_->addAction(QString(text).replace('&', QLatin1String("&&")));
      action->setCheckable(true);
      connect(action, &QAction::triggered, this, [this, window = window] {
        state_.setWindowLevel(window.first, window.second);
        refresh();
      });
    }
  }
  for (std::size_t i = 0; i < listed_.size(); ++i)
    others_->actions()[static_cast<qsizetype>(i)]->setChecked(listed_[i].first ==
                                                              state_.windowLevel());
  others_->menuAction()->setEnabled(!listed_.empty());
}

void WindowMenu::showDialog() {
  if (auto* shown = window_->findChild<QDialog*>("windowDialog")) {
    shown->activateWindow();
    return;
  }
  auto* dialog = named(new QDialog(window_), "windowDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Window and level"));
  auto* form = new QFormLayout(dialog);
  const auto add = [&](const char* name, const QString& title) {
    auto* spin = named(new QDoubleSpinBox(dialog), QLatin1String(name));
    spin->setKeyboardTracking(false);
    form->addRow(title, spin);
    return spin;
  };
  QDoubleSpinBox* window = add("windowWidth", tr("Window"));
  QDoubleSpinBox* level = add("windowLevel", tr("Level"));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  connect(window, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { state_.setWindowLevel(value, state_.windowLevel().second); });
  connect(level, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { state_.setWindowLevel(state_.windowLevel().first, value); });
  const auto showNumbers = [this, window, level] {
    const WindowLimits limits = state_.windowLimits();
    show(window, limits, limits.smallestWindow(), limits.largestWindow(),
         state_.windowLevel().first);
    show(level, limits, limits.lowestLevel(), limits.highestLevel(), state_.windowLevel().second);
  };
  connect(&state_, &ViewState::changed, dialog, showNumbers);
  showNumbers();
  window->setFocus();
  window->selectAll();
  dialog->show();
}

}  // namespace angiomesh
