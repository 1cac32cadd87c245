// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/slice_view.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QStringList>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/formatted.h"

namespace angiomesh {

namespace {

enum class Drag { None, Contrast, Pan, Zoom, Crosshair, Roi, Port };

constexpr double dimmedOpacity = 0.45;
constexpr double pixelsForUsualWindow = 400.0;  // of a drag
constexpr double clickDistance = 3.0;           // Qt pixels: a shorter way is a click, not a drag

}  // namespace

struct SliceView::State {
  SliceScene scene;
  Tool tool = Tool::Navigate;
  MouseScheme scheme = MouseScheme::Radiology;
  Drag drag = Drag::None;
  bool mayBeClick = false;
  QPointF pressed, last;
  WindowLimits limits;
  bool interpolated = true;
  QString caption;
  Eigen::Vector3d roiCorner{0.0, 0.0, 0.0};
  std::optional<RoiBox> roiBefore;
  std::optional<PortDrag> portDrag;  // of the port grabbed
  QString grabbed;
  SlabMode lastSlabMode = SlabMode::Mip;
  std::optional<QPointF> pointer;  // over the pane
  QString valueLayer, valueUnit;
  QStringList hovered;  // lines on what is under the pointer
};

SliceView::SliceView(QWidget* parent) : VtkView(parent), state_(std::make_unique<State>()) {
  renderWindow()->AddRenderer(state_->scene.renderer());
}

SliceView::~SliceView() { releaseGl(); }

void SliceView::setImage(std::shared_ptr<const Volume<float>> image) {
  const int before = slice();
  state_->scene.setImage(std::move(image));
  requestRender();
  hover();
  if (slice() != before) Q_EMIT sliceChanged(slice());
}

void SliceView::setPlane(int plane) {
  const int before = slice();
  state_->scene.setPlane(plane);
  requestRender();
  if (slice() != before) Q_EMIT sliceChanged(slice());
}

void SliceView::setWindowLevel(double window, double level) {
  if (window == windowWidth() && level == windowLevel()) return;
  state_->scene.setWindowLevel(window, level);
  requestRender();
}

void SliceView::setWindowLimits(const WindowLimits& limits) { state_->limits = limits; }

double SliceView::windowWidth() const { return state_->scene.window(); }
double SliceView::windowLevel() const { return state_->scene.level(); }

void SliceView::setCursor(const Eigen::Vector3d& lps) {
  const int before = slice();
  state_->scene.setCursor(lps);
  state_->scene.setSlice(state_->scene.sliceAt(lps));
  requestRender();
  hover();
  if (slice() != before) Q_EMIT sliceChanged(slice());
}

Eigen::Vector3d SliceView::cursor() const { return state_->scene.cursor(); }

void SliceView::setCrosshairVisible(bool visible) {
  state_->scene.setCrosshairVisible(visible);
  requestRender();
}

void SliceView::setInterpolated(bool on) {
  if (std::exchange(state_->interpolated, on) == on) return;
  state_->scene.setInterpolated(on);
  requestRender();
}

void SliceView::setSlab(SlabMode mode, double thicknessMm) {
  if (mode == slabMode() && thicknessMm == slabThicknessMm()) return;
  if (mode != SlabMode::None) state_->lastSlabMode = mode;
  state_->scene.setSlab(mode, thicknessMm);
  requestRender();
  hover();
}

SlabMode SliceView::slabMode() const { return state_->scene.slabMode(); }
double SliceView::slabThicknessMm() const { return state_->scene.slabThicknessMm(); }

void SliceView::setContour(std::shared_ptr<const Volume<float>> phi, bool dimmed) {
  std::vector<ContourLayer> layers;
  if (phi) {
    layers.emplace_back();
    layers.back().phi = std::move(phi);
    if (dimmed) layers.back().opacity = dimmedOpacity;
  }
  state_->scene.setContours(std::move(layers));
  requestRender();
}

void SliceView::setCaption(const QString& lines) {
  if (lines == state_->caption) return;
  state_->caption = lines;
  state_->scene.setCaption(lines.toStdString());
  requestRender();
}

void SliceView::setValueNames(const QString& layer, const QString& unit) {
  state_->valueLayer = layer;
  state_->valueUnit = unit;
  hover();
}

void SliceView::setSeeds(std::vector<Eigen::Vector3d> lps) {
  state_->scene.setSeeds(std::move(lps));
  requestRender();
}

void SliceView::setRoi(std::optional<RoiBox> roi) {
  if (roi == state_->scene.roi()) return;
  state_->scene.setRoi(roi);
  requestRender();
}

void SliceView::setPorts(std::vector<PortMark> marks) {
  state_->scene.setPorts(std::move(marks));
  requestRender();
}

void SliceView::setTool(Tool tool) {
  if (tool == state_->tool) return;  // a drag under way goes on
  if (state_->drag == Drag::Roi) setRoi(state_->roiBefore);
  if (state_->drag != Drag::Port) state_->drag = Drag::None;
  state_->tool = tool;
  showPointer(state_->last);
}

void SliceView::setScheme(MouseScheme scheme) { state_->scheme = scheme; }

void SliceView::resetView() {
  state_->scene.fit();
  requestRender();
  hover();
}

int SliceView::slice() const { return state_->scene.slice(); }
int SliceView::sliceCount() const { return state_->scene.sliceCount(); }

void SliceView::setSlice(int slice) {
  SliceScene& scene = state_->scene;
  if (!scene.image()) return;
  const int before = scene.slice();
  scene.setSlice(slice);
  if (scene.slice() == before) return;
  const Geometry& geometry = scene.image()->geometry;
  Eigen::Vector3d index = geometry.toIndex(scene.cursor());
  index[scene.axes().across] = scene.slice();
  const Eigen::Vector3d lps = geometry.toPhysical(index);
  scene.setCursor(lps);
  requestRender();
  hover();
  Q_EMIT sliceChanged(scene.slice());
  Q_EMIT cursorMoved(lps[0], lps[1], lps[2]);
}

Eigen::Vector3d SliceView::lpsAt(const QPointF& position) const {
  const Eigen::Vector2d display = toDisplay(position);
  return state_->scene.lpsAt(display[0], display[1]);
}

QPointF SliceView::positionOf(const Eigen::Vector3d& lps) const {
  return fromDisplay(state_->scene.displayAt(lps));
}

void SliceView::pictureBegins() {
  state_->pointer.reset();
  hover();
}

void SliceView::pixelRatioChanged(double ratio) { state_->scene.setPixelRatio(ratio); }

void SliceView::moveCrosshair(const QPointF& position) {
  if (!state_->scene.image()) return;
  const Eigen::Vector3d lps = lpsAt(position);
  state_->scene.setCursor(lps);
  requestRender();
  Q_EMIT cursorMoved(lps[0], lps[1], lps[2]);
}

void SliceView::stepSlices(int towardsHead) {
  // "Up" goes towards the head in axial slices, forward in coronal ones, to the left in sagittal.
  const PaneAxes& axes = state_->scene.axes();
  const int rising = (axes.plane == 1) != axes.acrossFlipped ? -1 : 1;
  setSlice(slice() + towardsHead * rising);
}

void SliceView::stepSlab(int steps) {
  SliceScene& scene = state_->scene;
  if (!scene.image()) return;
  const double spacing = scene.image()->geometry.spacing[scene.axes().across];
  const double now = scene.slabMode() == SlabMode::None ? spacing : scene.slabThicknessMm();
  const double most = spacing * scene.sliceCount();
  const double thickness = std::min(now + steps * spacing, most);
  if (thickness > 1.5 * spacing)
    setSlab(state_->lastSlabMode, thickness);
  else
    setSlab(SlabMode::None, 0.0);
  Q_EMIT slabChanged(scene.slabThicknessMm());
}

void SliceView::dragContrast(const QPointF& moved, bool fine) {
  const double step = state_->limits.usual / (fine ? 10.0 : 1.0) / pixelsForUsualWindow;
  // Upwards is brighter.
  const auto [window, level] =
      state_->limits.bounded({windowWidth() + step * moved.x(), windowLevel() + step * moved.y()});
  state_->scene.setWindowLevel(window, level);
  requestRender();
  Q_EMIT windowLevelChanged(window, level);
}

std::optional<RoiBox> SliceView::roiTo(const QPointF& position) const {
  const SliceScene& scene = state_->scene;
  const RoiBox whole = volumeBox(scene.image()->geometry);
  RoiBox box = state_->roiBefore.value_or(whole);
  const Eigen::Vector3d other = lpsAt(position);
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == scene.axes().plane) continue;
    const auto a = static_cast<std::size_t>(axis);
    const double low = std::min(state_->roiCorner[axis], other[axis]);
    const double high = std::max(state_->roiCorner[axis], other[axis]);
    box[a] = std::clamp(low, whole[a], whole[a + 3]);
    box[a + 3] = std::clamp(high, whole[a], whole[a + 3]);
    if (!(box[a + 3] > box[a])) return std::nullopt;
  }
  return box;
}

void SliceView::mousePressEvent(QMouseEvent* event) {
  State& s = *state_;
  if (s.drag != Drag::None) return;  // a second button while one is down
  s.pressed = s.last = event->position();
  s.mayBeClick = true;
  if (!s.scene.image()) return;
  if (event->button() == Qt::MiddleButton) s.drag = Drag::Pan;
  if (event->button() == Qt::RightButton) s.drag = Drag::Zoom;
  if (event->button() != Qt::LeftButton) return;
  if (s.tool == Tool::DrawRoi) {
    s.drag = Drag::Roi;
    s.roiCorner = lpsAt(event->position());
    s.roiBefore = s.scene.roi();
  } else if (!event->modifiers().testFlag(Qt::ControlModifier) && grabPort(event->position())) {
    s.drag = Drag::Port;
  } else if (s.scheme == MouseScheme::Engineering && s.tool == Tool::Navigate) {
    s.drag = Drag::Crosshair;
    moveCrosshair(event->position());
  } else {
    s.drag = Drag::Contrast;
  }
}

void SliceView::mouseMoveEvent(QMouseEvent* event) {
  State& s = *state_;
  const QPointF position = event->position();
  const QPointF moved = position - s.last;
  if ((position - s.pressed).manhattanLength() > clickDistance) s.mayBeClick = false;
  s.last = position;
  switch (s.drag) {
    case Drag::None:
      if (event->buttons() == Qt::NoButton && event->modifiers().testFlag(Qt::ShiftModifier))
        moveCrosshair(position);
      if (event->buttons() == Qt::NoButton) showPointer(position);
      break;
    case Drag::Contrast:
      // A click may shake a little without changing the contrast.
      if (!s.mayBeClick) dragContrast(moved, event->modifiers().testFlag(Qt::ControlModifier));
      break;
    case Drag::Pan:
      s.scene.pan(moved.x() * devicePixelRatioF(), -moved.y() * devicePixelRatioF());
      requestRender();
      break;
    case Drag::Zoom: {
      const Eigen::Vector2d fixed = toDisplay(s.pressed);
      s.scene.zoom(std::exp(-0.01 * moved.y()), fixed[0], fixed[1]);
      requestRender();
      break;
    }
    case Drag::Crosshair:
      moveCrosshair(position);
      break;
    case Drag::Roi:
      if (!s.mayBeClick)
        if (const std::optional<RoiBox> box = roiTo(position)) setRoi(box);
      break;
    case Drag::Port:
      dragPort(position, event->modifiers().testFlag(Qt::ShiftModifier));
      break;
  }
  s.pointer = position;
  hover();
}

void SliceView::mouseReleaseEvent(QMouseEvent* event) {
  State& s = *state_;
  const Qt::MouseButton held = s.drag == Drag::None   ? Qt::NoButton
                               : s.drag == Drag::Pan  ? Qt::MiddleButton
                               : s.drag == Drag::Zoom ? Qt::RightButton
                                                      : Qt::LeftButton;
  if (event->button() != held) return;
  const Drag ended = s.drag;
  s.drag = Drag::None;
  if (ended == Drag::Roi && !s.mayBeClick) {
    if (const std::optional<RoiBox> box = roiTo(event->position()))
      Q_EMIT roiDrawn(*box);
    else
      setRoi(s.roiBefore);
  }
  if (ended == Drag::Port) {
    s.portDrag.reset();
    if (!s.mayBeClick) Q_EMIT portDropped();
  }
  if (!s.mayBeClick) return;
  const std::optional<Eigen::Vector3d> place = picked();
  if (!place) return;
  const Eigen::Vector3d& p = *place;
  if (ended == Drag::Contrast && s.tool == Tool::Navigate) moveCrosshair(s.pressed);
  if (ended == Drag::Contrast && s.tool == Tool::PickSeed) Q_EMIT seedPicked(p[0], p[1], p[2]);
  if (ended == Drag::Contrast && s.tool == Tool::CutVessel) Q_EMIT cutPicked(p[0], p[1], p[2]);
  if (ended == Drag::Zoom) {
    const std::optional<PortHit> hit = portAt(s.pressed);
    Q_EMIT menuRequested(event->globalPosition().toPoint(), p, hit ? nameOf(*hit) : QString());
  }
}

QString SliceView::nameOf(const PortHit& hit) const {
  return QString::fromStdString(state_->scene.ports()[hit.mark].name);
}

std::optional<PortHit> SliceView::portAt(const QPointF& position) const {
  const Eigen::Vector2d at = toDisplay(position);
  const bool grabs = state_->tool == Tool::Navigate || state_->tool == Tool::CutVessel;
  return grabs ? state_->scene.portAt(at[0], at[1]) : std::nullopt;
}

bool SliceView::grabPort(const QPointF& position) {
  State& s = *state_;
  const std::optional<PortHit> hit = portAt(position);
  if (!hit) return false;
  const Eigen::Vector2d at = toDisplay(position);
  s.portDrag = s.scene.grabPort(*hit, at[0], at[1]);
  s.grabbed = nameOf(*hit);
  Q_EMIT portPressed(s.grabbed);
  return true;
}

void SliceView::dragPort(const QPointF& position, bool free) {
  State& s = *state_;
  if (s.mayBeClick) return;
  const Eigen::Vector2d at = toDisplay(position);
  const CutPlane plane = s.portDrag->moved(s.scene.rayAt(at[0], at[1]), free);
  Q_EMIT portDragged(s.grabbed, plane);
  if (s.portDrag->grip() == PortDrag::Grip::Turn) return;
  // A vessel leaves the slice: all panes go where its disc went.
  const Eigen::Vector3d& p = plane.pointLps;
  setCursor(p);
  Q_EMIT cursorMoved(p[0], p[1], p[2]);
}

void SliceView::showPointer(const QPointF& position) {
  if (const std::optional<PortHit> hit = portAt(position))
    QWidget::setCursor(hit->grip == PortDrag::Grip::Turn ? Qt::PointingHandCursor
                                                         : Qt::SizeAllCursor);
  else if (state_->tool == Tool::Navigate)
    unsetCursor();
  else
    QWidget::setCursor(Qt::CrossCursor);
}

std::optional<Eigen::Vector3d> SliceView::picked() const {
  const SliceScene& scene = state_->scene;
  const Eigen::Vector3d lps = lpsAt(state_->pressed);
  const std::optional<SliceScene::Probe> probe = scene.probe(lps);
  if (!probe) return std::nullopt;
  // In a slab the place lies where the shown value comes from.
  const Geometry& geometry = scene.image()->geometry;
  const int across = scene.axes().across;
  Eigen::Vector3d index = geometry.toIndex(lps);
  index[across] = probe->voxel[static_cast<std::size_t>(across)];
  return geometry.toPhysical(index);
}

void SliceView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton && state_->tool == Tool::Navigate)
    Q_EMIT maximiseRequested();
  else
    mousePressEvent(event);
}

void SliceView::wheelEvent(QWheelEvent* event) {
  const int steps = wheelSteps(event);
  event->accept();
  if (steps == 0 || !state_->scene.image()) return;
  if (event->modifiers().testFlag(Qt::ControlModifier)) {
    const Eigen::Vector2d fixed = toDisplay(event->position());
    state_->scene.zoom(std::pow(1.15, steps), fixed[0], fixed[1]);
    requestRender();
  } else if (event->modifiers().testFlag(Qt::AltModifier)) {
    stepSlab(steps);
  } else {
    stepSlices(steps * (event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1));
  }
  state_->pointer = event->position();
  hover();
}

void SliceView::keyPressEvent(QKeyEvent* event) {
  const int steps = event->modifiers().testFlag(Qt::ShiftModifier) ? 10 : 1;
  switch (event->key()) {
    case Qt::Key_Up:
    case Qt::Key_Right:
      stepSlices(steps);
      return;
    case Qt::Key_Down:
    case Qt::Key_Left:
      stepSlices(-steps);
      return;
    case Qt::Key_R:
      if (event->modifiers() == Qt::NoModifier) {
        resetView();
        return;
      }
      break;
    default:
      break;
  }
  event->ignore();
}

void SliceView::leaveEvent(QEvent* event) {
  state_->pointer.reset();
  hover();
  VtkView::leaveEvent(event);
}

void SliceView::hover() {
  State& s = *state_;
  const std::optional<Eigen::Vector3d> lps =
      s.pointer ? std::optional(lpsAt(*s.pointer)) : std::nullopt;
  const std::optional<SliceScene::Probe> probe = lps ? s.scene.probe(*lps) : std::nullopt;
  QStringList lines;
  if (probe) {
    QStringList value{s.valueLayer, QString::number(static_cast<double>(probe->value), 'g', 5),
                      s.valueUnit};
    value.removeAll(QString());
    const Index3& v = probe->voxel;
    lines << tr("%1, voxel %2,%3,%4").arg(value.join(' ')).arg(v[0]).arg(v[1]).arg(v[2])
          << QString::fromStdString(placeText(*lps));
  }
  if (lines == s.hovered) return;
  s.hovered = lines;
  s.scene.setPointerText(lines.join('\n').toStdString());
  requestRender();
  Q_EMIT hovered(lines.join(QLatin1String(", ")));
}

}  // namespace angiomesh
