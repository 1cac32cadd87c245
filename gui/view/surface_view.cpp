// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/surface_view.h"

#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QResizeEvent>
#include <QScopeGuard>
#include <QTimer>
#include <QWheelEvent>
#include <utility>

#include "gui/view/view_buttons.h"
#include "render/surface/surface_scene.h"

namespace angiomesh {

namespace {

/// Whether a left click on the surface gives a place to a tool.
bool picksPlaces(Tool tool) {
  return tool == Tool::CutVessel || isBrush(tool) || correctedBy(tool) || measuredBy(tool);
}

/// VTK's own hot keys (q, e, w, s, p, 3 ...) would quit, pick or switch to wireframe.
class QuietTrackball : public vtkInteractorStyleTrackballCamera {
 public:
  static QuietTrackball* New();
  void OnChar() override {}
  void OnKeyPress() override {}
  void OnKeyDown() override {}
};

vtkStandardNewMacro(QuietTrackball);

constexpr int refineAfterMs = 350;
constexpr double turnStep = 6.0;       // degrees, as angiography stations turn
constexpr double clickDistance = 3.0;  // Qt pixels: a shorter way is a click, not a drag

}  // namespace

struct SurfaceView::State {
  SurfaceScene scene;
  vtkNew<QuietTrackball> style;
  QTimer refine;
  bool buttonDown = false;
  // What is set already: telling it again must not cost a frame of the projection.
  VolumeView volumeView = VolumeView::Mip;
  bool surfaceVisible = true, edgesVisible = false, dimmed = false;
  bool busy = false;
  QString caption;
  std::vector<Eigen::Vector3d> seeds;
  std::optional<RoiBox> roi;
  std::vector<std::array<double, 3>> patchColours;
  std::optional<PortDrag> drag;  // of the port grabbed
  QString grabbed;
  QPointF pressed;
  bool mayBeClick = false;
  std::optional<std::size_t> clicked;  // triangle
};

SurfaceView::SurfaceView(QWidget* parent) : VtkView(parent), state_(std::make_unique<State>()) {
  state_->scene.attach(renderWindow());
  state_->style->SetDefaultRenderer(state_->scene.renderer());
  state_->style->SetMotionFactor(8.0);
  interactor()->SetInteractorStyle(state_->style);
  state_->refine.setSingleShot(true);
  state_->refine.setInterval(refineAfterMs);
  new ViewButtons(this);
  connect(&state_->refine, &QTimer::timeout, this, [this] {
    if (state_->buttonDown || state_->busy) return;
    state_->scene.setInteractive(false);
    requestRender();
  });
}

SurfaceView::~SurfaceView() {
  releaseGl();
  interactor()->SetInteractorStyle(nullptr);
}

void SurfaceView::changed() {
  // A quick coarse frame now, the fine one when nothing has changed for a moment: however fast
  // surfaces arrive, frames stay short.
  state_->scene.setInteractive(true);
  state_->refine.start();
  requestRender();
}

void SurfaceView::resizeEvent(QResizeEvent* event) {
  // Before the pane draws itself at its new size.
  state_->scene.setInteractive(true);
  state_->refine.start();
  VtkView::resizeEvent(event);
}

void SurfaceView::setImage(std::shared_ptr<const Volume<float>> image) {
  setDrawnImage(drawnVolume(std::move(image)));
}

void SurfaceView::setDrawnImage(std::shared_ptr<const DrawnVolume> image) {
  state_->scene.setDrawnImage(std::move(image));
  changed();
}

void SurfaceView::setVolumeView(VolumeView view) {
  if (std::exchange(state_->volumeView, view) == view) return;
  state_->scene.setVolumeView(view);
  changed();
}

void SurfaceView::setSurface(std::shared_ptr<const TriMesh> mesh) {
  setDrawnSurface(drawnMesh(std::move(mesh), kCoarseTriangles));
}

void SurfaceView::setDrawnSurface(std::shared_ptr<const DrawnMesh> mesh) {
  state_->scene.setSurfaceCoarse(true);
  state_->scene.setDrawnSurface(std::move(mesh));
  state_->refine.start();
  requestRender();
}

void SurfaceView::setBusy(bool busy) {
  if (std::exchange(state_->busy, busy) == busy) return;
  if (!busy) state_->refine.start();
}

void SurfaceView::setSlices(const std::vector<const SliceView*>& views) {
  std::vector<const SliceScene*> scenes;
  for (const SliceView* view : views) scenes.push_back(&view->scene());
  if (state_->scene.setSlices(scenes)) requestRender();
}

std::optional<std::size_t> SurfaceView::clickedTriangle() const { return state_->clicked; }

void SurfaceView::setSurfaceVisible(bool visible) {
  if (std::exchange(state_->surfaceVisible, visible) == visible) return;
  state_->scene.setSurfaceVisible(visible);
  changed();
}

void SurfaceView::setEdgesVisible(bool visible) {
  if (std::exchange(state_->edgesVisible, visible) == visible) return;
  state_->scene.setEdgesVisible(visible);
  changed();
}

void SurfaceView::setCaption(const QString& lines, bool dimmed) {
  if (lines == state_->caption && dimmed == state_->dimmed) return;
  state_->caption = lines;
  state_->dimmed = dimmed;
  state_->scene.setCaption(lines.toStdString());
  state_->scene.setSurfaceDimmed(dimmed);
  requestRender();
}

void SurfaceView::setSurfaceColours(std::vector<float> perTriangle, const QString& title, double lo,
                                    double hi) {
  state_->scene.setSurfaceColours(std::move(perTriangle), title.toStdString(), lo, hi);
  requestRender();
}

void SurfaceView::clearSurfaceColours() {
  state_->scene.clearSurfaceColours();
  requestRender();
}

void SurfaceView::setMarked(const std::vector<std::uint32_t>& triangles) {
  state_->scene.setMarked(triangles);
  requestRender();
}

void SurfaceView::setPatchColours(std::vector<std::array<double, 3>> colours) {
  if (colours == state_->patchColours) return;
  state_->patchColours = colours;
  state_->scene.setPatchColours(std::move(colours));
  requestRender();
}

void SurfaceView::setPorts(std::vector<PortMark> marks) {
  // Without a change of the projection's quality: it would flicker with each step of a drag.
  state_->scene.setPorts(std::move(marks));
  requestRender();
}

void SurfaceView::setMeasures(const std::vector<MeasureMark>& marks) {
  state_->scene.setMeasures(marks);
  requestRender();
}

void SurfaceView::setSeeds(std::vector<Eigen::Vector3d> lps) {
  if (lps == state_->seeds) return;
  state_->seeds = lps;
  state_->scene.setSeeds(std::move(lps));
  changed();
}

void SurfaceView::setRoi(std::optional<RoiBox> roi) {
  if (roi == state_->roi) return;
  state_->roi = roi;
  state_->scene.setRoi(roi);
  changed();
}

void SurfaceView::viewFrom(char side) {
  state_->scene.viewFrom(side);
  changed();
  Q_EMIT cameraMoved();
}

void SurfaceView::turn(double right, double up) {
  state_->scene.turn(right, up);
  changed();
  Q_EMIT cameraMoved();
}

void SurfaceView::lookAt(const Eigen::Vector3d& lps, double radiusMm) {
  state_->scene.lookAt(lps, radiusMm);
  changed();
  Q_EMIT cameraMoved();
}

void SurfaceView::lookAtFrom(const Eigen::Vector3d& lps, const Eigen::Vector3d& normal,
                             double radiusMm) {
  state_->scene.lookAtFrom(lps, normal, radiusMm);
  changed();
  Q_EMIT cameraMoved();
}

void SurfaceView::resetView() {
  state_->scene.resetView();
  changed();
  Q_EMIT cameraMoved();
}

void SurfaceView::takeCameraOf(const SurfaceView& other) {
  state_->scene.takeCameraOf(other.state_->scene);
  changed();
}

void SurfaceView::keepCamera() { state_->scene.keepCamera(); }

void SurfaceView::paintGL() {
  const auto position = [this] {
    return Eigen::Vector3d(state_->scene.renderer()->GetActiveCamera()->GetPosition());
  };
  const Eigen::Vector3d before = position();
  VtkView::paintGL();
  if (position() != before) Q_EMIT cameraMoved();
}

QImage SurfaceView::pictureTurned(double degrees, int scale, const QSize& size) {
  const auto back = qScopeGuard([this, degrees] { state_->scene.turn(-degrees, 0.0); });
  state_->scene.turn(degrees, 0.0);
  return picture(scale, size);
}

void SurfaceView::pictureBegins() { state_->scene.setInteractive(false); }

void SurfaceView::pixelRatioChanged(double ratio) { state_->scene.setPixelRatio(ratio); }

QPointF SurfaceView::positionOf(const Eigen::Vector3d& lps) const {
  return fromDisplay(state_->scene.displayAt(lps));
}

QPointF SurfaceView::arrowTipOf(const QString& port) const {
  const std::vector<PortMark>& marks = state_->scene.ports();
  for (std::size_t i = 0; i < marks.size(); ++i)
    if (QString::fromStdString(marks[i].name) == port) return positionOf(state_->scene.arrowTip(i));
  return {};
}

bool SurfaceView::grabPort(const QPointF& position) {
  const Eigen::Vector2d at = toDisplay(position);
  const auto hit = state_->scene.portAt(at[0], at[1]);
  if (!hit) return false;
  state_->grabbed = QString::fromStdString(state_->scene.ports()[hit->mark].name);
  state_->drag = state_->scene.grabPort(*hit, at[0], at[1]);
  Q_EMIT portPressed(state_->grabbed);
  return true;
}

void SurfaceView::dragPort(const QPointF& position, bool free) {
  if (state_->mayBeClick) return;
  const Eigen::Vector2d at = toDisplay(position);
  Q_EMIT portDragged(state_->grabbed, state_->drag->moved(state_->scene.rayAt(at[0], at[1]), free));
}

void SurfaceView::showGrip(const QPointF& position) {
  const Eigen::Vector2d at = toDisplay(position);
  const auto hit = state_->scene.gripAt(at[0], at[1]);
  if (hit)
    setCursor(hit->grip == PortDrag::Grip::Arrow ? Qt::PointingHandCursor : Qt::SizeAllCursor);
  else if (picksPlaces(tool_))
    setCursor(Qt::CrossCursor);
  else
    unsetCursor();
}

void SurfaceView::mousePressEvent(QMouseEvent* event) {
  State& s = *state_;
  if (s.drag) return;  // a second button while one is down
  s.pressed = event->position();
  s.mayBeClick = true;
  s.buttonDown = true;
  s.scene.setInteractive(true);
  if (event->button() == Qt::LeftButton && grabPort(event->position())) return;
  VtkView::mousePressEvent(event);
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  State& s = *state_;
  if ((event->position() - s.pressed).manhattanLength() > clickDistance) s.mayBeClick = false;
  if (s.drag) {
    dragPort(event->position(), event->modifiers().testFlag(Qt::ShiftModifier));
    return;
  }
  VtkView::mouseMoveEvent(event);
  if (s.buttonDown)
    Q_EMIT cameraMoved();
  else
    showGrip(event->position());
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* event) {
  State& s = *state_;
  if (s.drag) {
    if (event->button() != Qt::LeftButton) return;
    s.drag.reset();
    if (!s.mayBeClick) Q_EMIT portDropped();
  } else {
    VtkView::mouseReleaseEvent(event);
  }
  s.buttonDown = event->buttons() != Qt::NoButton;
  if (!s.buttonDown) s.refine.start();
  if (s.mayBeClick) clicked(*event);
}

void SurfaceView::clicked(const QMouseEvent& event) {
  State& s = *state_;
  s.mayBeClick = false;
  const Eigen::Vector2d at = toDisplay(s.pressed);
  const bool picks = tool_ == Tool::Navigate || picksPlaces(tool_);
  if (event.button() != Qt::RightButton && !(event.button() == Qt::LeftButton && picks)) return;
  const auto port = s.scene.portAt(at[0], at[1]);
  const std::optional<SurfaceHit> hit = s.scene.hitAt(at[0], at[1]);
  const auto place = hit ? std::optional(hit->place) : std::nullopt;
  s.clicked = hit ? std::optional(hit->triangle) : std::nullopt;
  if (event.button() == Qt::RightButton) {
    Q_EMIT menuRequested(
        event.globalPosition().toPoint(), place,
        port ? QString::fromStdString(s.scene.ports()[port->mark].name) : QString());
  } else if (place && !port) {
    const Eigen::Vector3d& p = *place;
    if (tool_ == Tool::CutVessel)
      Q_EMIT cutPicked(p[0], p[1], p[2]);
    else if (isBrush(tool_) || correctedBy(tool_))
      Q_EMIT correctPicked(p[0], p[1], p[2]);
    else if (measuredBy(tool_))
      Q_EMIT measurePicked(p[0], p[1], p[2]);
    else
      Q_EMIT placePicked(p[0], p[1], p[2]);
  }
}

void SurfaceView::wheelEvent(QWheelEvent* event) {
  changed();
  VtkView::wheelEvent(event);
  Q_EMIT cameraMoved();
}

void SurfaceView::keyPressEvent(QKeyEvent* event) {
  const bool shift = event->modifiers() == Qt::ShiftModifier;
  if (event->modifiers() == Qt::NoModifier || shift) {
    switch (event->key()) {
      case Qt::Key_A:
      case Qt::Key_P:
      case Qt::Key_L:
      case Qt::Key_S:
      case Qt::Key_I:
        viewFrom(static_cast<char>('A' + event->key() - Qt::Key_A));
        return;
      case Qt::Key_Left:
        turn(-turnStep, 0.0);
        return;
      case Qt::Key_Right:
        turn(turnStep, 0.0);
        return;
      case Qt::Key_Up:
        turn(0.0, turnStep);
        return;
      case Qt::Key_Down:
        turn(0.0, -turnStep);
        return;
      case Qt::Key_R:
        if (shift)
          viewFrom('R');
        else
          resetView();
        return;
      default:
        break;
    }
  }
  VtkView::keyPressEvent(event);
}

}  // namespace angiomesh
