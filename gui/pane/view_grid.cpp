// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pane/view_grid.h"

#include <QGridLayout>
#include <QPainter>
#include <QScopeGuard>
#include <algorithm>
#include <initializer_list>
#include <type_traits>
#include <utility>

#include "gui/findings/case_ports.h"
#include "gui/findings/mesh_inspection.h"
#include "gui/model/result_text.h"
#include "gui/model/step_text.h"
#include "gui/pane/surface_feed.h"
#include "gui/pane/surface_pane.h"
#include "gui/pane/volume_feed.h"
#include "gui/view/named.h"
#include "gui/view/pane_focus.h"
#include "gui/view/slice_view.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

namespace {

/// Of a port's vessel, to be seen around it.
constexpr double kRadiiAround = 8.0;
/// Width of a large pane in widths of the small ones beside it.
constexpr int kLargeShare = 2;

/// Empty where no volume is shown.
QString volumeText(VolumeView view, const QString& layer) {
  if (view == VolumeView::None) return {};
  return (view == VolumeView::Mip ? ViewGrid::tr("MIP: %1") : ViewGrid::tr("Volume: %1"))
      .arg(layer);
}

}  // namespace

ViewGrid::ViewGrid(CaseModels& models, ViewState& state, CasePorts& ports,
                   MeshInspection& inspection, CaseSensitivity& sensitivity,
                   const JobRunnerFactory& makeRunner, QWidget* parent)
    : QWidget(parent), models_(models), state_(state), ports_(ports), inspection_(inspection) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2);
  const std::array<const char*, 3> names{"sagittal", "coronal", "axial"};
  for (int plane = 0; plane < 3; ++plane) {
    auto* view = named(new SliceView(this), names[static_cast<std::size_t>(plane)]);
    view->setPlane(plane);
    slices_[static_cast<std::size_t>(plane)] = view;
    connectSlice(view);
  }
  pane3d_ =
      named(new SurfacePane(models_, state_, ports_, inspection_, sensitivity, makeRunner, this),
            "pane3d");
  surface_ = pane3d_->surface();
  comparison_ = pane3d_->beside();
  imageFeed_ = new VolumeFeed(*surface_, models_.timer, makeRunner, this);
  connect(pane3d_, &SurfacePane::textChanged, this, &ViewGrid::refreshCaptions);
  for (SurfaceView* view : {surface_, comparison_}) {
    connect(view, &VtkView::maximiseRequested, this, [this] { toggleMaximised(pane3d_); });
    connect(view, &SurfaceView::placePicked, this, [this](double x, double y, double z) {
      setCrosshair({x, y, z});
    });
  }
  setLargePane(slices_[2]);
  setMinimumSize(320, 320);
  new PaneFocus({slices_[0], slices_[1], slices_[2], surface_, comparison_}, this);
  connect(&models_.files, &CaseFiles::caseChanged, this, &ViewGrid::resetViews);
  connect(&models_.results, &ResultModel::resultsChanged, this, &ViewGrid::refreshAll);
  connect(&models_.runs, &RunModel::snapshotArrived, this, &ViewGrid::refreshSegmentation);
  connect(&models_.runs, &RunModel::statesChanged, this, [this] {
    const bool busy = models_.runs.running() && !models_.runs.paused();
    for (SurfaceView* view : {surface_, comparison_}) view->setBusy(busy);
    refreshSegmentation();
  });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &ViewGrid::refreshEdits);
  connect(&models_.document, &CaseDocument::edited, this, &ViewGrid::refreshSegmentation);
  connect(&models_.live, &LivePreview::changed, this, [this] {
    showPreview();
    refreshCaptions();
  });
  connect(&state_, &ViewState::changed, this, &ViewGrid::refreshAll);
  connectPorts();
  connectInspection();
  connect(&sensitivity, &CaseSensitivity::goTo, this, &ViewGrid::goTo);
  refreshAll();
}

void ViewGrid::goTo(double x, double y, double z, double radiusMm) {
  setCrosshair({x, y, z});
  if (radiusMm > 0.0) surface_->lookAt({x, y, z}, kRadiiAround * radiusMm);
}

void ViewGrid::connectInspection() {
  connect(&inspection_, &MeshInspection::goTo, this,
          [this](const Eigen::Vector3d& lps, const Eigen::Vector3d& normal, double radiusMm) {
            setCrosshair(lps);
            surface_->lookAtFrom(lps, normal, radiusMm);
          });
}

void ViewGrid::connectPorts() {
  connect(&ports_, &CasePorts::changed, this, &ViewGrid::refreshPorts);
  connect(&ports_, &CasePorts::dragged, this, &ViewGrid::showPorts);
  connect(&ports_, &CasePorts::goTo, this, &ViewGrid::goTo);
  const auto link = [this](auto* view) {
    using View = std::remove_pointer_t<decltype(view)>;
    connect(view, &View::portPressed, &ports_, &CasePorts::select);
    connect(view, &View::portDragged, &ports_, &CasePorts::drag);
    connect(view, &View::portDropped, &ports_, &CasePorts::drop);
    connect(view, &View::menuRequested, this,
            [this, view](const QPoint& global, const auto& place, const QString& port) {
              Q_EMIT menuRequested(global, place, port, planeOf(view));
            });
    connect(view, &View::cutPicked, this, [this](double x, double y, double z) {
      ports_.cutHere({x, y, z});
      state_.setTool(Tool::Navigate);
    });
  };
  link(surface_);
  for (SliceView* view : slices_) link(view);
  refreshPorts();
}

void ViewGrid::connectSlice(SliceView* view) {
  connect(view, &VtkView::maximiseRequested, this, [this, view] { toggleMaximised(view); });
  connect(view, &SliceView::cursorMoved, this, [this, view](double x, double y, double z) {
    for (SliceView* other : slices_) {
      if (other != view) other->setCursor({x, y, z});
    }
    Q_EMIT crosshairMoved();
  });
  connect(view, &VtkView::renderRequested, this, &ViewGrid::showSlices3d);
  connect(view, &SliceView::windowLevelChanged, &state_, &ViewState::setWindowLevel);
  connect(view, &SliceView::slabChanged, &state_,
          [this, view](const Slab& slab) { state_.setSlab(planeOf(view), slab); });
  connect(view, &SliceView::turnChanged, &state_, &ViewState::setTurn);
  connect(view, &SliceView::seedPicked, this, [this](double x, double y, double z) {
    models_.document.addSeed({x, y, z});
  });
  connect(view, &SliceView::markDragged, this, [this](const MarkPoint& point) {
    if (!point.mark.empty()) return;
    draggedSeed_ = point;
    refreshSeeds();
  });
  connect(view, &SliceView::markDropped, this, [this] {
    if (!draggedSeed_) return;
    const MarkPoint seed = *std::exchange(draggedSeed_, std::nullopt);
    models_.document.moveSeed(static_cast<int>(seed.point), seed.lps);
  });
  connect(view, &SliceView::roiDrawn, this, [this](const RoiBox& roi) {
    models_.document.setRoi(roi);
    state_.setTool(Tool::Navigate);
  });
  connect(view, &SliceView::hovered, this, &ViewGrid::hovered);
}

SurfaceFeed* ViewGrid::surfaceFeed() const { return pane3d_->feed(); }

int ViewGrid::planeOf(const VtkView* view) const {
  const auto found = std::find(slices_.begin(), slices_.end(), view);
  return found == slices_.end() ? kNoSlice : static_cast<int>(found - slices_.begin());
}

QWidget* ViewGrid::largePane() const { return large_ == pane3d_ ? surface_ : large_; }

void ViewGrid::setLargePane(QWidget* pane) {
  large_ = pane == surface_ || pane == comparison_ ? pane3d_ : pane;
  arrange();
}

void ViewGrid::setPaneLayout(PaneLayout layout) {
  layout_ = layout;
  if (layout != PaneLayout::Single) layoutOfAll_ = layout;
  arrange();
}

void ViewGrid::toggleMaximised(QWidget* pane) {
  if (pane == surface_ || pane == comparison_) pane = pane3d_;
  layout_ = maximised() && pane == large_ ? layoutOfAll_ : PaneLayout::Single;
  setLargePane(pane);
}

void ViewGrid::arrange() {
  auto* grid = static_cast<QGridLayout*>(layout());
  while (const QLayoutItem* item = grid->takeAt(0)) delete item;
  for (int i = 0; i < grid->rowCount(); ++i) grid->setRowStretch(i, 0);
  for (int i = 0; i < grid->columnCount(); ++i) grid->setColumnStretch(i, 0);
  std::vector<QWidget*> panes{slices_[2], slices_[0], slices_[1], pane3d_};
  for (QWidget* pane : panes) pane->setVisible(!maximised() || pane == large_);
  if (layout_ == PaneLayout::Four) {
    for (int i = 0; i < 4; ++i) {
      grid->addWidget(panes[static_cast<std::size_t>(i)], i / 2, i % 2);
      grid->setRowStretch(i / 2, 1);
      grid->setColumnStretch(i % 2, 1);
    }
  } else {
    grid->addWidget(large_, 0, 0, -1, 1);
    grid->setColumnStretch(0, kLargeShare);
  }
  if (layout_ == PaneLayout::OneAndThree) {
    panes.erase(std::find(panes.begin(), panes.end(), large_));
    grid->setColumnStretch(1, 1);
    for (int i = 0; i < 3; ++i) {
      grid->addWidget(panes[static_cast<std::size_t>(i)], i, 1);
      grid->setRowStretch(i, 1);
    }
  }
  Q_EMIT arranged();
}

void ViewGrid::resetViews() {
  for (SliceView* view : slices_) view->resetView();
  surface_->resetView();
}

std::vector<VtkView*> ViewGrid::shown() const {
  std::vector<VtkView*> views;
  for (VtkView* view :
       std::initializer_list<VtkView*>{slices_[2], slices_[0], slices_[1], surface_, comparison_})
    if (view->isVisible()) views.push_back(view);
  return views;
}

VtkView* ViewGrid::shown3d() const { return surface_->isVisible() ? surface_ : nullptr; }

QString ViewGrid::titleOf(const VtkView* pane) const {
  if (pane == surface_) return tr("3D");
  if (pane == comparison_) return state_.resultBeside() ? tr("3D, result") : tr("3D, beside");
  return pane == slices_[2] ? tr("axial") : pane == slices_[1] ? tr("coronal") : tr("sagittal");
}

bool ViewGrid::hasCrosshair(const VtkView* pane) const {
  return pane != surface_ && pane != comparison_;
}

QSize ViewGrid::pictureSize(const VtkView* pane, int scale) const {
  const QWidget* widget = pane ? static_cast<const QWidget*>(pane) : this;
  return (QSizeF(widget->size()) * widget->devicePixelRatioF() * scale).toSize();
}

QImage ViewGrid::picture(VtkView* pane, int scale, bool crosshair) const {
  if (pane) {
    auto* slice = qobject_cast<SliceView*>(pane);
    if (!slice || crosshair) return pane->picture(scale);
    slice->setCrosshairVisible(false);
    const auto restore = qScopeGuard([slice] { slice->setCrosshairVisible(true); });
    return slice->picture(scale);
  }
  QImage all(pictureSize(nullptr, scale), QImage::Format_RGB888);
  all.fill(palette().color(QPalette::Window));
  QPainter painter(&all);
  for (VtkView* view : shown()) {
    const QPointF corner = view->mapTo(this, QPoint(0, 0)) * devicePixelRatioF() * scale;
    painter.drawImage(corner.toPoint(), picture(view, scale, crosshair));
  }
  return all;
}

Eigen::Vector3d ViewGrid::crosshair() const { return slices_[2]->cursor(); }

void ViewGrid::setCrosshair(const Eigen::Vector3d& lps) {
  for (SliceView* view : slices_) view->setCursor(lps);
  Q_EMIT crosshairMoved();
}

void ViewGrid::refreshAll() {
  refreshImage();
  refreshSegmentation();
  refreshEdits();
}

void ViewGrid::refreshImage() {
  std::shared_ptr<const Volume<float>> image = models_.results.layer(state_.layer());
  layerShown_ = image != nullptr;
  if (!image) image = models_.document.image();
  if (image != shownImage_) {
    shownImage_ = image;
    for (SliceView* view : slices_) view->setImage(image);
    imageFeed_->show(image);
  }
  const ColourLayer overlay = overlayLayer();
  const Layer layer = layerShown_ ? state_.layer() : Layer::Source;
  const bool hounsfield = layer == Layer::Source && models_.document.display().modality == "CT";
  const auto [window, level] = state_.windowLevel();
  for (SliceView* view : slices_) {
    view->setWindowLevel(window, level);
    view->setWindowLimits(state_.windowLimits());
    view->setValueNames(layerTitle(layer), hounsfield ? tr("HU") : QString());
    view->setInterpolated(state_.interpolated());
    view->setColourLayer(overlay, state_.overlay() ? layerTitle(*state_.overlay()) : QString());
    view->setTurn(state_.turn());
    view->setSlab(state_.slab(planeOf(view)));
    view->setTool(state_.tool());
    view->setScheme(state_.scheme());
  }
  showSlices3d();
  surface_->setTool(state_.tool());
  surface_->setVolumeView(state_.volumeShown());
  surface_->setSurfaceVisible(state_.surface());
  surface_->setEdgesVisible(state_.edges());
}

void ViewGrid::showSlices3d() {
  const auto all = std::initializer_list<const SliceView*>{slices_[0], slices_[1], slices_[2]};
  surface_->setSlices(state_.slices3d() ? std::vector(all) : std::vector<const SliceView*>());
}

ColourLayer ViewGrid::overlayLayer() const {
  ColourLayer layer;
  if (!state_.overlay()) return layer;
  layer.values = models_.results.layer(*state_.overlay());
  const std::array<double, 2> range = state_.overlayRange();
  layer.from = range[0];
  layer.to = range[1];
  layer.opacity = state_.overlayOpacity();
  return layer;
}

void ViewGrid::refreshSegmentation() {
  const std::shared_ptr<const Volume<float>> phi =
      state_.contours() ? models_.results.phi() : nullptr;
  const bool stale = contourText(models_.results, models_.runs).stale;
  if (phi != shownPhi_ || stale != phiDimmed_) {
    shownPhi_ = phi;
    phiDimmed_ = stale;
    for (SliceView* view : slices_) view->setContour(phi, stale);
  }
  showPreview();
  pane3d_->refresh();
  refreshCaptions();
}

void ViewGrid::showPreview() {
  for (SliceView* view : slices_)
    view->setPreview(state_.contours() ? models_.live.phi() : nullptr);
}

void ViewGrid::refreshCaptions() {
  const ResultModel& results = models_.results;
  const bool any = models_.document.hasCase();
  const QString layer = layerText(results, state_.layer(), layerShown_).text;
  const auto lines = [any](QStringList list) {
    list.removeAll(QString());
    return any ? list.join('\n') : QString();
  };
  const QString overlay =
      state_.overlay() ? overlayText(models_.results, *state_.overlay()).text : QString();
  const QString contour = shownPhi_ ? contourText(results, models_.runs).text : QString();
  const QString preview =
      state_.contours() && models_.live.phi() ? tr("Preview in the box") : QString();
  for (SliceView* view : slices_) view->setCaption(lines({layer, overlay, contour, preview}));
  const QString projection = volumeText(state_.volumeShown(), layer);
  const QString slices = state_.slices3d() ? tr("Slices: %1").arg(layer) : QString();
  const QString hidden = pane3d_->feed()->hidesParts() ? tr("Some parts hidden") : QString();
  surface_->setCaption(lines({projection, slices, state_.slices3d() ? overlay : QString(), hidden,
                              state_.surface() ? pane3d_->text().text : QString()}),
                       pane3d_->text().stale);
  const ShownText beside = pane3d_->textBeside();
  comparison_->setCaption(
      lines({state_.resultBeside() ? tr("MIP: result") : QString(), beside.text}), beside.stale);
}

void ViewGrid::refreshPorts() {
  pane3d_->refreshPatches();
  showPorts();
}

void ViewGrid::showPorts() {
  std::vector<PortMark> marks;
  const PortRow* selected = ports_.selected();
  for (const PortRow& row : ports_.rows()) {
    // Openings that nobody cut are seen as they are.
    if (row.cut || &row == selected) {
      marks.push_back({row.name.toStdString(), row.plane, row.radiusMm, row.colour,
                       &row == selected, row.cut, row.path});
    }
  }
  if (marks == shownPorts_) return;
  shownPorts_ = marks;
  for (SliceView* view : slices_) view->setPorts(marks);
  surface_->setPorts(std::move(marks));
}

void ViewGrid::refreshSeeds() {
  if (state_.tool() != Tool::PickSeed) draggedSeed_.reset();
  std::vector<Eigen::Vector3d> seeds = models_.document.seeds();
  if (draggedSeed_ && draggedSeed_->point < seeds.size())
    seeds[draggedSeed_->point] = draggedSeed_->lps;
  // Those that were found are many: they are seen by who works with seeds.
  const auto found = state_.tool() == Tool::PickSeed ? models_.results.seedsResult() : nullptr;
  for (SliceView* view : slices_)
    view->setSeeds(seeds, found ? found->pointsLps : std::vector<Eigen::Vector3d>());
  surface_->setSeeds(seeds);
}

void ViewGrid::refreshEdits() {
  const auto& roi = models_.document.parameters().preprocess.roi;
  for (SliceView* view : slices_) view->setRoi(roi);
  surface_->setRoi(roi);
  refreshSeeds();
  if (state_.layer() == Layer::Speed || state_.overlay() == Layer::Speed) refreshImage();
}

}  // namespace angiomesh
