// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane/surface_pane.h"

#include <QEvent>
#include <utility>

#include "gui/model/step_text.h"
#include "gui/pane/surface_feed.h"
#include "gui/pane/volume_feed.h"
#include "gui/view/mesh_chooser.h"
#include "gui/view/named.h"

namespace angiomesh {

SurfacePane::SurfacePane(CaseModels& models, ViewState& state, CasePorts& ports,
                         MeshInspection& inspection, CaseSensitivity& sensitivity,
                         const JobRunnerFactory& makeRunner, QWidget* parent)
    : QSplitter(Qt::Horizontal, parent),
      models_(models),
      state_(state),
      ports_(ports),
      inspection_(inspection),
      sensitivity_(sensitivity),
      surface_(named(new SurfaceView(this), "surface3d")),
      beside_(named(new SurfaceView(this), "comparison3d")),
      feed_(new SurfaceFeed(*surface_, models.timer, makeRunner, this)),
      feedBeside_(new SurfaceFeed(*beside_, models.timer, makeRunner, this)),
      resultFeed_(new VolumeFeed(*beside_, models.timer, makeRunner, this)),
      shown_{surface_, feed_, nullptr, nullptr, CaseSensitivity::kAll},
      shownBeside_{beside_, feedBeside_, nullptr, nullptr, CaseSensitivity::kAll} {
  setChildrenCollapsible(false);
  beside_->setVolumeView(VolumeView::None);
  beside_->hide();
  handle(1)->installEventFilter(this);
  new MeshChooser(MeshPlace::Shown, models_, state_, surface_);
  new MeshChooser(MeshPlace::Beside, models_, state_, beside_);
  connectCameras();
  connect(feed_, &SurfaceFeed::arrived, this, [this] {
    paintSurface();
    Q_EMIT textChanged();
  });
  connect(feedBeside_, &SurfaceFeed::arrived, this, &SurfacePane::paintBeside);
  connect(&inspection_, &MeshInspection::changed, this, [this] {
    paintSurface();
    if (state_.comparison()) paintBeside();
  });
  connect(&inspection_, &MeshInspection::litChanged, this, &SurfacePane::paintMarks);
  // Who chooses a mesh or its colours wants to see that.
  const auto chosen = [this] { return std::pair(state_.meshKind(), state_.meshColour()); };
  connect(&state_, &ViewState::changed, this, [this, chosen, seen = chosen()]() mutable {
    const auto now = chosen();
    if (std::exchange(seen, now) != now) sensitivity_.setPainted(false);
  });
  connect(&sensitivity_, &CaseSensitivity::changed, this, [this] {
    refresh();
    Q_EMIT textChanged();
  });
}

void SurfacePane::connectCameras() {
  connect(surface_, &SurfaceView::cameraMoved, this, [this] {
    if (oneCamera()) beside_->takeCameraOf(*surface_);
  });
  connect(beside_, &SurfaceView::cameraMoved, this, [this] {
    if (oneCamera()) surface_->takeCameraOf(*beside_);
  });
}

bool SurfacePane::eventFilter(QObject* watched, QEvent* event) {
  // The bar between meshes moves over what they show, and changes nothing of it.
  if (event->type() == QEvent::MouseButtonPress)
    for (SurfaceView* view : {surface_, beside_}) view->keepCamera();
  return QSplitter::eventFilter(watched, event);
}

void SurfacePane::refresh() {
  bool passing = false;
  const std::shared_ptr<const TriMesh> mesh = wanted(passing);
  // An outline that is being made comes in a moment; until then the last surface stays.
  if (mesh || models_.results.meshFits() || !models_.results.segmentation()) {
    feed_->show(mesh, passing);
    paintSurface();
  }
  refreshBeside();
}

std::shared_ptr<const TriMesh> SurfacePane::wanted(bool& passing) const {
  ResultModel& results = models_.results;
  std::shared_ptr<const TriMesh> mesh = results.liveSurface();
  passing = mesh != nullptr;
  if (passing) return mesh;
  if (sensitivity_.painted()) return sensitivity_.found()->wall;
  const bool fromFile = results.kindAtHand(state_.meshKind()) == MeshKind::File;
  if (!fromFile && !results.meshFits() && results.segmentation()) return results.outline();
  for (const MeshKind kind : {state_.meshKind(), MeshKind::Exported, MeshKind::Unsmoothed})
    mesh = mesh ? mesh : results.mesh(kind);
  return mesh;
}

void SurfacePane::paintSurface() {
  const ResultModel& results = models_.results;
  const bool live = results.liveSurface() != nullptr;
  if (sensitivity_.painted() && !live)
    text_ = {sensitivity_.stale() ? tr("Moves of the wall, out of date") : tr("Moves of the wall"),
             sensitivity_.stale()};
  else if (live || feed_->settled())
    text_ = surfaceText(results, models_.runs, state_.meshKind());
  paint(shown_, results.kindAtHand(state_.meshKind()), live);
}

void SurfacePane::paintBeside() { paint(shownBeside_, kindBeside(), false); }

void SurfacePane::paint(Shown& shown, MeshKind kind, bool plain) {
  const std::shared_ptr<const TriMesh>& mesh = shown.feed->shown();
  std::shared_ptr<const void> colours;
  const bool moves = !plain && sensitivity_.found() && mesh == sensitivity_.found()->wall;
  if (moves)
    colours = sensitivity_.found();
  else if (!plain && state_.meshColour() && inspection_.of(mesh.get(), kind))
    colours = inspection_.measured();
  if (mesh == shown.mesh && colours == shown.colours &&
      (!moves || shown.effect == sensitivity_.chosen()))
    return;
  if (mesh != shown.mesh) shown.view->setPatchColours(patchColours(mesh));
  shown.mesh = mesh;
  shown.colours = colours;
  shown.effect = sensitivity_.chosen();
  if (moves) {
    const auto [red, blue] = sensitivity_.scale();
    shown.view->setSurfaceColours(sensitivity_.values(), sensitivity_.title(), red, blue);
  } else if (colours) {
    const MeasuredMeshes& measured = *inspection_.measured();
    shown.view->setSurfaceColours(measured.of(kind).values, measureTitle(*measured.measure),
                                  measured.scale.worst, measured.scale.best);
  } else {
    shown.view->clearSurfaceColours();
  }
  paintMarks();
}

void SurfacePane::paintMarks() {
  const auto mark = [this](SurfaceView* view, const TriMesh* mesh, MeshKind kind) {
    view->setMarked(inspection_.of(mesh, kind) ? inspection_.lit(kind)
                                               : std::vector<std::uint32_t>());
  };
  mark(surface_, feed_->shown().get(), models_.results.kindAtHand(state_.meshKind()));
  if (state_.comparison()) mark(beside_, feedBeside_->shown().get(), kindBeside());
}

void SurfacePane::refreshBeside() {
  const bool result = state_.resultBeside();
  const bool meshes = state_.comparison();
  const bool wanted = result || meshes;
  const bool appears = wanted && beside_->isHidden();
  const bool joins = appears || (oneCamera() && !linked_);
  linked_ = oneCamera();
  beside_->setVisible(wanted);
  if (appears) setSizes({width(), width()});
  beside_->setVolumeView(result ? VolumeView::Inside : VolumeView::None);
  resultFeed_->show(result ? models_.results.phi() : nullptr);
  feedBeside_->show(meshes ? models_.results.mesh(kindBeside()) : nullptr, false);
  if (meshes) {
    beside_->setEdgesVisible(state_.edges());
    paintBeside();
  }
  if (joins) beside_->takeCameraOf(*surface_);
}

ShownText SurfacePane::textBeside() const {
  return state_.resultBeside() ? contourText(models_.results, models_.runs)
                               : meshText(models_.results, state_.besideKind());
}

bool SurfacePane::oneCamera() const {
  return state_.resultBeside() || (state_.comparison() && state_.linked());
}

MeshKind SurfacePane::kindBeside() const { return models_.results.kindAtHand(state_.besideKind()); }

std::vector<std::array<double, 3>> SurfacePane::patchColours(
    const std::shared_ptr<const TriMesh>& mesh) const {
  for (const MeshKind kind : {MeshKind::Exported, MeshKind::Unsmoothed})
    if (mesh && mesh == models_.results.mesh(kind))
      return ports_.colours(models_.results.ports(kind));
  return {};
}

void SurfacePane::refreshPatches() { surface_->setPatchColours(patchColours(shown_.mesh)); }

}  // namespace angiomesh
