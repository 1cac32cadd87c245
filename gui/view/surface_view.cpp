// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/surface_view.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QTimer>
#include <QWheelEvent>
#include <utility>

#include "render/surface_scene.h"

namespace angiomesh {

namespace {

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

}  // namespace

struct SurfaceView::State {
  SurfaceScene scene;
  vtkNew<QuietTrackball> style;
  QTimer refine;
  bool buttonDown = false;
  // What is set already: telling it again must not cost a frame of the projection.
  bool mipVisible = true, surfaceVisible = true, comparisonVisible = true, edgesVisible = false;
  std::vector<Eigen::Vector3d> seeds;
  std::optional<RoiBox> roi;
};

SurfaceView::SurfaceView(QWidget* parent) : VtkView(parent), state_(std::make_unique<State>()) {
  state_->scene.attach(renderWindow());
  state_->style->SetDefaultRenderer(state_->scene.renderer());
  state_->style->SetMotionFactor(8.0);
  interactor()->SetInteractorStyle(state_->style);
  state_->refine.setSingleShot(true);
  state_->refine.setInterval(refineAfterMs);
  connect(&state_->refine, &QTimer::timeout, this, [this] {
    if (state_->buttonDown) return;
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

void SurfaceView::setImage(std::shared_ptr<const Volume<float>> image) {
  state_->scene.setImage(std::move(image));
  changed();
}

void SurfaceView::setMipVisible(bool visible) {
  if (std::exchange(state_->mipVisible, visible) == visible) return;
  state_->scene.setMipVisible(visible);
  changed();
}

void SurfaceView::setMipWindow(double from, double to) {
  state_->scene.setMipWindow(from, to);
  changed();
}

void SurfaceView::setSurface(std::shared_ptr<const TriMesh> mesh) {
  state_->scene.setSurface(std::move(mesh));
  changed();
}

void SurfaceView::setComparison(std::shared_ptr<const TriMesh> mesh) {
  state_->scene.setComparison(std::move(mesh));
  changed();
}

void SurfaceView::setSurfaceVisible(bool visible) {
  if (std::exchange(state_->surfaceVisible, visible) == visible) return;
  state_->scene.setSurfaceVisible(visible);
  changed();
}

void SurfaceView::setComparisonVisible(bool visible) {
  if (std::exchange(state_->comparisonVisible, visible) == visible) return;
  state_->scene.setComparisonVisible(visible);
  changed();
}

void SurfaceView::setEdgesVisible(bool visible) {
  if (std::exchange(state_->edgesVisible, visible) == visible) return;
  state_->scene.setEdgesVisible(visible);
  changed();
}

void SurfaceView::setSurfaceColours(std::vector<float> perTriangle, const QString& title, double lo,
                                    double hi) {
  state_->scene.setSurfaceColours(std::move(perTriangle), title.toStdString(), lo, hi);
  changed();
}

void SurfaceView::setComparisonColours(std::vector<float> perTriangle) {
  state_->scene.setComparisonColours(std::move(perTriangle));
  changed();
}

void SurfaceView::clearSurfaceColours() {
  state_->scene.clearSurfaceColours();
  changed();
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

void SurfaceView::lookAt(const Eigen::Vector3d& lps, double radiusMm) {
  state_->scene.lookAt(lps, radiusMm);
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

void SurfaceView::pixelRatioChanged(double ratio) { state_->scene.setPixelRatio(ratio); }

void SurfaceView::mousePressEvent(QMouseEvent* event) {
  state_->buttonDown = true;
  state_->scene.setInteractive(true);
  VtkView::mousePressEvent(event);
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event) {
  VtkView::mouseMoveEvent(event);
  if (state_->buttonDown) Q_EMIT cameraMoved();
}

void SurfaceView::mouseReleaseEvent(QMouseEvent* event) {
  VtkView::mouseReleaseEvent(event);
  state_->buttonDown = event->buttons() != Qt::NoButton;
  if (!state_->buttonDown) state_->refine.start();
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
