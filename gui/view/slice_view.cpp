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

#include "gui/view/slice_grip.h"
#include "gui/view/slice_text.h"
#include "render/slice/slice_measures.h"

namespace angiomesh {

namespace {

enum class Drag { None, Contrast, Pan, Zoom, Crosshair, Roi, Port, Mark, Turn, Brush };

constexpr double dimmedOpacity = 0.45;
constexpr double pixelsForUsualWindow = 400.0;  // of a drag
constexpr double clickDistance = 3.0;           // Qt pixels: a shorter way is a click, not a drag

}  // namespace

struct SliceView::State {
  SliceScene scene;
  SliceMeasures measures{scene}, sketch{scene};
  SliceGrip grip{scene, measures};
  Tool tool = Tool::Navigate;
  MouseScheme scheme = MouseScheme::Radiology;
  Drag drag = Drag::None;
  bool mayBeClick = false;
  QPointF pressed, last;
  std::vector<Eigen::Vector3d> stroke;  // mm LPS
  WindowLimits limits;
  ColourLayer colourLayer;
  ContourLayer contour, preview;
  bool interpolated = true;
  QString caption;
  SlabMode lastSlabMode = SlabMode::Mip;
  std::optional<QPointF> pointer;  // over the pane
  ValueNames names;
  QStringList hovered;  // lines on what is under the pointer
};

SliceView::SliceView(QWidget* parent) : VtkView(parent), state_(std::make_unique<State>()) {
  renderWindow()->AddRenderer(state_->scene.renderer());
  state_->scene.setWords(sliceWords());
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

void SliceView::setSlab(const Slab& slab) {
  if (slab == this->slab()) return;
  if (slab.mode != SlabMode::None) state_->lastSlabMode = slab.mode;
  state_->scene.setSlab(slab);
  requestRender();
  hover();
}

const Slab& SliceView::slab() const { return state_->scene.slab(); }

void SliceView::chooseSlab(const Slab& slab) {
  if (!state_->scene.image()) return;
  setSlab(slab);
  Q_EMIT slabChanged(slab);
}

void SliceView::setContour(std::shared_ptr<const Volume<float>> phi, bool dimmed) {
  state_->contour.phi = std::move(phi);
  state_->contour.opacity = dimmed ? dimmedOpacity : 1.0;
  showContours();
}

void SliceView::setPreview(std::shared_ptr<const Volume<float>> phi) {
  if (phi == state_->preview.phi) return;
  state_->scene.setPreviewGrid(phi ? std::optional(phi->geometry) : std::nullopt);
  state_->preview = {std::move(phi), kPreviewColour, 1.0};
  showContours();
}

void SliceView::showContours() {
  std::vector<ContourLayer> layers;
  for (const ContourLayer& layer : {state_->contour, state_->preview})
    if (layer.phi) layers.push_back(layer);
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
  state_->names.layer = layer;
  state_->names.unit = unit;
  hover();
}

void SliceView::setColourLayer(const ColourLayer& layer, const QString& name) {
  state_->names.overlay = name;
  if (layer == state_->colourLayer) return;
  state_->colourLayer = layer;
  state_->scene.setColourLayer(layer);
  requestRender();
  hover();
}

void SliceView::setTurn(const PlaneTurn& turn) {
  if (turn == state_->scene.turn()) return;
  const int before = slice();
  state_->scene.setTurn(turn);
  requestRender();
  hover();
  if (slice() != before) Q_EMIT sliceChanged(slice());
}

std::vector<QPointF> SliceView::knobs() const {
  std::vector<QPointF> positions;
  for (const Eigen::Vector2d& knob : state_->scene.knobs()) positions.push_back(fromDisplay(knob));
  return positions;
}

const SliceScene& SliceView::scene() const { return state_->scene; }

void SliceView::setSeeds(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found) {
  state_->scene.setSeeds(std::move(byHand), std::move(found));
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

void SliceView::setMeasures(std::vector<MeasureMark> marks) {
  state_->measures.set(std::move(marks));
  requestRender();
}

void SliceView::setSketch(std::vector<MeasureMark> marks) {
  state_->sketch.set(std::move(marks));
  requestRender();
}

void SliceView::setTool(Tool tool) {
  if (tool == state_->tool) return;  // a drag under way goes on
  if (state_->drag == Drag::Roi) setRoi(state_->grip.roiBefore());
  if (state_->drag != Drag::Port && state_->drag != Drag::Mark) state_->drag = Drag::None;
  state_->tool = tool;
  state_->grip.setTool(tool);
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
  Eigen::Vector3d index = scene.grid().toIndex(scene.cursor());
  index[scene.axes().across] = scene.slice();
  const Eigen::Vector3d lps = scene.grid().toPhysical(index);
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

void SliceView::pixelRatioChanged(double ratio) {
  state_->scene.setPixelRatio(ratio);
  state_->measures.setPixelRatio(ratio);
  state_->sketch.setPixelRatio(ratio);
}

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
  const double spacing = scene.grid().spacing[scene.axes().across];
  const double now = slab().mode == SlabMode::None ? spacing : slab().thicknessMm;
  const double most = spacing * scene.sliceCount();
  const double thickness = std::min(now + steps * spacing, most);
  if (thickness > 1.5 * spacing)
    chooseSlab({state_->lastSlabMode, thickness});
  else
    chooseSlab({SlabMode::None, slab().thicknessMm});
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
    s.grip.takeRoi(toDisplay(event->position()));
  } else if (isBrush(s.tool)) {
    s.drag = Drag::Brush;
    s.stroke.assign(1, lpsAt(event->position()));
    Q_EMIT strokeMoved(s.stroke);
  } else if (!event->modifiers().testFlag(Qt::ControlModifier) &&
             s.grip.takePort(toDisplay(event->position()))) {
    s.drag = Drag::Port;
    Q_EMIT portPressed(s.grip.port());
  } else if (s.grip.takeMark(toDisplay(event->position()))) {
    s.drag = Drag::Mark;
    Q_EMIT markPressed(QString::fromStdString(s.grip.markMoved(toDisplay(s.pressed)).mark));
  } else if (s.grip.takeKnob(toDisplay(event->position()))) {
    s.drag = Drag::Turn;
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
        if (const auto box = s.grip.roiMoved(toDisplay(position))) setRoi(box);
      break;
    case Drag::Turn:
      if (!s.mayBeClick) Q_EMIT turnChanged(s.grip.knobMoved(toDisplay(position)));
      break;
    case Drag::Mark:
      if (!s.mayBeClick) Q_EMIT markDragged(s.grip.markMoved(toDisplay(position)));
      break;
    case Drag::Brush:
      s.stroke.push_back(lpsAt(position));
      Q_EMIT strokeMoved(s.stroke);
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
    if (const auto box = s.grip.roiMoved(toDisplay(event->position())))
      Q_EMIT roiDrawn(*box);
    else
      setRoi(s.grip.roiBefore());
  }
  if (ended == Drag::Brush) Q_EMIT strokeDrawn(std::exchange(s.stroke, {}));
  if (ended == Drag::Port && !s.mayBeClick) Q_EMIT portDropped();
  if (ended == Drag::Mark && !s.mayBeClick) Q_EMIT markDropped();
  if (!s.mayBeClick) return;
  const std::optional<Eigen::Vector3d> place = picked();
  if (!place) return;
  const Eigen::Vector3d& p = *place;
  const bool clicked = ended == Drag::Contrast || ended == Drag::Mark;
  if (clicked && s.tool == Tool::Navigate) moveCrosshair(s.pressed);
  const bool onSeed = ended == Drag::Mark && s.tool == Tool::PickSeed;
  if (clicked && s.tool == Tool::PickSeed && !onSeed) Q_EMIT seedPicked(p[0], p[1], p[2]);
  if (clicked && s.tool == Tool::CutVessel) Q_EMIT cutPicked(p[0], p[1], p[2]);
  if (clicked && correctedBy(s.tool)) Q_EMIT correctPicked(p[0], p[1], p[2]);
  if (clicked && measuredBy(s.tool)) Q_EMIT measurePicked(p[0], p[1], p[2]);
  if (ended == Drag::Zoom)
    Q_EMIT menuRequested(event->globalPosition().toPoint(), p,
                         s.grip.nameOf(s.grip.portAt(toDisplay(s.pressed))));
}

void SliceView::dragPort(const QPointF& position, bool free) {
  State& s = *state_;
  if (s.mayBeClick) return;
  const CutPlane plane = s.grip.portMoved(toDisplay(position), free);
  Q_EMIT portDragged(s.grip.port(), plane);
  if (s.grip.turnsPort()) return;
  // A vessel leaves the slice: all panes go where its disc went.
  const Eigen::Vector3d& p = plane.pointLps;
  setCursor(p);
  Q_EMIT cursorMoved(p[0], p[1], p[2]);
}

void SliceView::showPointer(const QPointF& position) {
  QWidget::setCursor(state_->grip.cursorAt(toDisplay(position)));
  const Eigen::Vector3d lps = lpsAt(position);
  Q_EMIT pointedAt(lps[0], lps[1], lps[2]);
}

std::optional<Eigen::Vector3d> SliceView::picked() const {
  const std::optional<SliceScene::Probe> probe = state_->scene.probe(lpsAt(state_->pressed));
  return probe ? std::optional(probe->placeLps) : std::nullopt;
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
    case Qt::Key_M:
      if (event->modifiers() != Qt::NoModifier) break;
      chooseSlab({static_cast<SlabMode>((static_cast<int>(slab().mode) + 1) % kSlabModeCount),
                  slab().thicknessMm});
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
  const QStringList lines = probe ? probeLines(*probe, s.names, *lps) : QStringList();
  if (lines == s.hovered) return;
  s.hovered = lines;
  s.scene.setPointerText(lines.join('\n').toStdString());
  requestRender();
  Q_EMIT hovered(lines.join(QLatin1String(", ")));
}

}  // namespace angiomesh
