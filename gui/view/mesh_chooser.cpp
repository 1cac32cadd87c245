// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/mesh_chooser.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>

#include "gui/model/step_text.h"
#include "gui/view/surface_view.h"
#include "gui/view/view_buttons.h"

namespace angiomesh {

namespace {

constexpr int kFile = static_cast<int>(MeshKind::File);
constexpr int kMargin = 6;
/// Beside it, for the first line of what the pane shows.
constexpr int kRoomBeside = 70;
constexpr int kFewLetters = 7;

}  // namespace

MeshCombo::MeshCombo(MeshPlace place, CaseModels& models, ViewState& state, QWidget* parent)
    : QComboBox(parent), place_(place), models_(models), state_(state) {
  for (int kind = 0; kind < kMeshKindCount; ++kind) addItem(meshTitle(static_cast<MeshKind>(kind)));
  // Short enough for a narrow panel; the list shows all of a name.
  setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  setMinimumContentsLength(kFewLetters);
  connect(this, &QComboBox::activated, this, [this](int index) {
    const auto kind = static_cast<MeshKind>(index);
    if (place_ == MeshPlace::Shown)
      state_.setMeshKind(kind);
    else
      state_.setBesideKind(kind);
  });
  connect(&models_.results, &ResultModel::resultsChanged, this, &MeshCombo::refresh);
  connect(&state_, &ViewState::changed, this, &MeshCombo::refresh);
  refresh();
}

void MeshCombo::refresh() {
  const QSignalBlocker quiet(this);
  qobject_cast<QStandardItemModel*>(model())->item(kFile)->setEnabled(
      models_.results.mesh(MeshKind::File) != nullptr);
  setCurrentIndex(
      static_cast<int>(place_ == MeshPlace::Shown ? state_.meshKind() : state_.besideKind()));
}

MeshChooser::MeshChooser(MeshPlace place, CaseModels& models, ViewState& state, SurfaceView* view)
    : QWidget(view),
      place_(place),
      models_(models),
      state_(state),
      mesh_(new MeshCombo(place, models, state, this)),
      button_(new QToolButton(this)) {
  const bool shown = place == MeshPlace::Shown;
  setObjectName(shown ? "meshChooser" : "besideChooser");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2);
  mesh_->setObjectName(shown ? "paneMesh" : "paneBeside");
  mesh_->setToolTip(tr("The mesh in this view"));
  mesh_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  mesh_->setMinimumContentsLength(kFewLetters);
  row->addWidget(mesh_);
  button_->setObjectName(shown ? "paneSplit" : "paneLinked");
  button_->setText(shown ? tr("Split") : tr("Linked"));
  button_->setToolTip(shown ? tr("Shows another mesh beside this one; drag the bar between them")
                            : tr("Both views turn, move and zoom as one"));
  button_->setCheckable(true);
  row->addWidget(button_);
  for (QWidget* widget : {static_cast<QWidget*>(mesh_), static_cast<QWidget*>(button_)})
    widget->setFocusPolicy(Qt::NoFocus);
  connect(button_, &QToolButton::clicked, &state_,
          shown ? &ViewState::setComparison : &ViewState::setLinked);
  connect(&models_.results, &ResultModel::resultsChanged, this, &MeshChooser::refresh);
  connect(&state_, &ViewState::changed, this, &MeshChooser::refresh);
  setPalette(paletteOnPictures());
  view->installEventFilter(this);
  refresh();
}

bool MeshChooser::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize || event->type() == QEvent::Show) this->place();
  return QWidget::eventFilter(watched, event);
}

void MeshChooser::refresh() {
  const QSignalBlocker quiet(button_);
  button_->setChecked(place_ == MeshPlace::Shown ? state_.comparison() : state_.linked());
  place();
}

void MeshChooser::place() {
  adjustSize();
  move(kMargin, kMargin);
  const ResultModel& results = models_.results;
  const bool any = results.mesh(results.kindAtHand(MeshKind::Exported)) != nullptr ||
                   results.mesh(MeshKind::File) != nullptr;
  setVisible(any && parentWidget()->width() > width() + kRoomBeside);
}

}  // namespace angiomesh
