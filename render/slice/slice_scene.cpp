// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_scene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "render/slice/crosshair_arms.h"
#include "render/slice/slice_cast.h"
#include "render/slice/slice_layer.h"
#include "render/slice/slice_marks.h"
#include "render/slice/slice_overlay.h"
#include "render/slice/slice_seeds.h"
#include "render/slice/slice_viewport.h"

namespace angiomesh {

namespace {

/// Depths of the flat scene's layers, towards the viewer.
constexpr double roiDepth = 1.0, contourDepth = 2.0, portDepth = 2.5, crosshairDepth = 3.0,
                 seedDepth = 4.0;
constexpr double gripPixels = 8.0;     // design pixels around a port's lines and an arm's knob
constexpr double letterPixels = 30.0;  // the crosshair ends before the letters on the edges

int sliceCountOf(const PaneGrid& pane) {
  return pane.grid.size[static_cast<std::size_t>(pane.axes.across)];
}

int nearestSlice(const PaneGrid& pane, const Eigen::Vector3d& lps) {
  const double index = pane.grid.toIndex(lps)[pane.axes.across];
  return static_cast<int>(
      std::clamp(std::round(index), 0.0, std::max(0.0, sliceCountOf(pane) - 1.0)));
}

}  // namespace

struct SliceScene::Parts {
  vtkNew<vtkRenderer> renderer;
  SlicePixels pixels{renderer};
  SliceViewport view{renderer};
  std::vector<std::unique_ptr<SliceLayer>> contourLayers;
  SliceLayer roiLine, previewLine;
  CrosshairArms crosshair{renderer};
  SliceMarks ports{renderer};
  SliceSeeds seeds{renderer};
  std::unique_ptr<SliceOverlay> overlay;
  vtkNew<vtkCallbackCommand> beforeFrame;

  std::shared_ptr<const Volume<float>> image;
  SliceOverlay::Texts texts;
  std::vector<ContourLayer> contours;
  std::optional<RoiBox> roi;
  std::optional<Geometry> preview;
  PlaneTurn turn;
  PaneGrid pane;
  SlicePlane plane;
  int planeNumber = 2, slice = 0;
  Slab slab;
  double pixelRatio = 1.0;
  bool windowLevelSet = false, crosshairVisible = true;
  Eigen::Vector3d cursor{0.0, 0.0, 0.0};

  Parts();
  ~Parts() { renderer->RemoveObserver(beforeFrame); }
  [[nodiscard]] Eigen::Vector2d toScene(double displayX, double displayY) {
    view.followSize(plane);
    return view.toScene(displayX, displayY);
  }
  [[nodiscard]] std::array<Eigen::Vector2d, 2> arms() const;
  [[nodiscard]] double gripMm() const { return gripPixels * pixelRatio * view.mmPerPixel(); }
  void layOut();
  [[nodiscard]] std::array<int, 2> slabRange() const;
  void prepareFrame();
  void showSlice();
  void showContours();
  void showCrosshair();
  void showPorts() { ports.show(plane, image != nullptr, portDepth, pixelRatio); }
  void showSeeds() {
    seeds.show(image ? &plane : nullptr, slice, slabRange(), seedDepth, pixelRatio);
  }
  void showBoxes();
  void showBox(SliceLayer& line, const std::vector<Eigen::Vector2d>& polygon) const;
  void showTexts();
};

SliceScene::Parts::Parts() {
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->ParallelProjectionOn();

  roiLine.colour(0.35, 0.80, 1.0);
  previewLine.colour(kPreviewColour[0], kPreviewColour[1], kPreviewColour[2]);
  for (SliceLayer* layer : {&roiLine, &previewLine}) {
    layer->actor->VisibilityOff();
    renderer->AddActor(layer->actor);
  }
  overlay = std::make_unique<SliceOverlay>(renderer);
  overlay->setVisible(false);

  beforeFrame->SetClientData(this);
  beforeFrame->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<Parts*>(self)->prepareFrame();
  });
  renderer->AddObserver(vtkCommand::StartEvent, beforeFrame);
}

std::array<int, 2> SliceScene::Parts::slabRange() const {
  if (slab.mode == SlabMode::None) return {slice, slice};
  return slabSlices(pane.grid, pane.axes, slice, slab.thicknessMm);
}

/// Finds the grid of the slices, and in it the slice of the crosshair.
void SliceScene::Parts::layOut() {
  pane = paneGrid(image->geometry, planeNumber, turn);
  slice = nearestSlice(pane, cursor);
}

void SliceScene::Parts::prepareFrame() {
  view.followSize(plane);
  view.apply();
  const Eigen::Vector2d size = view.size();
  overlay->setScale(view.mmPerPixel(), static_cast<int>(size[0]), static_cast<int>(size[1]),
                    pixelRatio);
  showCrosshair();
}

void SliceScene::Parts::showSlice() {
  if (!image) return;
  plane = SlicePlane(pane.grid, pane.axes, slice);
  const std::array<int, 2> range = slabRange();
  pixels.show(pane, plane, slab.mode, slice, range[0], range[1]);
  showContours();
  showPorts();
  showSeeds();
  showBoxes();
  showTexts();
}

void SliceScene::Parts::showContours() {
  while (contourLayers.size() > contours.size()) {
    renderer->RemoveActor(contourLayers.back()->actor);
    contourLayers.pop_back();
  }
  while (contourLayers.size() < contours.size()) {
    contourLayers.push_back(std::make_unique<SliceLayer>());
    renderer->AddActor(contourLayers.back()->actor);
  }
  for (std::size_t k = 0; k < contours.size(); ++k) {
    SliceLayer& layer = *contourLayers[k];
    const bool visible = image && contours[k].phi;
    layer.actor->SetVisibility(visible);
    if (!visible) continue;
    const auto& c = contours[k].colour;
    layer.colour(c[0], c[1], c[2]);
    layer.actor->GetProperty()->SetOpacity(contours[k].opacity);
    layer.actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixelRatio));
    layer.setSegments(zeroContour(*contours[k].phi, plane), contourDepth);
  }
}

/// Along which the two other planes cut this one.
std::array<Eigen::Vector2d, 2> SliceScene::Parts::arms() const {
  const std::array<Eigen::Vector3d, 3> normals = planeNormals(image->geometry, turn);
  const auto number = [](int n) { return static_cast<std::size_t>(n); };
  std::array<Eigen::Vector2d, 2> along;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector3d line =
        normals[number(planeNumber)].cross(normals[number((planeNumber + 1 + k) % 3)]);
    along[number(k)] =
        Eigen::Vector2d(line.dot(pane.axes.rightLps), line.dot(pane.axes.upLps)).normalized();
  }
  return along;
}

void SliceScene::Parts::showCrosshair() {
  if (!image || !crosshairVisible) {
    crosshair.hide();
    return;
  }
  const Eigen::Vector2d half =
      view.mmPerPixel() * (0.5 * view.size().array() - letterPixels * pixelRatio).max(0.0).matrix();
  crosshair.show(plane.fromLps(cursor).head<2>(), arms(),
                 {view.centre() - half, view.centre() + half, view.mmPerPixel(), pixelRatio},
                 crosshairDepth);
}

void SliceScene::Parts::showBoxes() {
  const std::vector<Eigen::Vector2d> nothing;
  showBox(roiLine, image && roi ? boxSection(*roi, plane) : nothing);
  showBox(previewLine, image && preview ? gridSection(*preview, plane) : nothing);
}

void SliceScene::Parts::showBox(SliceLayer& line,
                                const std::vector<Eigen::Vector2d>& polygon) const {
  line.actor->SetVisibility(!polygon.empty());
  line.actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixelRatio));
  std::vector<std::array<Eigen::Vector2d, 2>> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  line.setSegments(sides, roiDepth);
}

void SliceScene::Parts::showTexts() {
  overlay->setVisible(image != nullptr);
  if (!image) return;
  const PaneAxes& axes = pane.axes;
  overlay->setLetters(axes);
  const Eigen::Vector2d middle(0.5 * (plane.width() - 1) * plane.pixelWidthMm(),
                               0.5 * (plane.height() - 1) * plane.pixelHeightMm());
  texts.plane = axes.plane;
  texts.slice = slice;
  texts.count = sliceCountOf(pane);
  texts.patientAxes = turn.patientAxes;
  texts.turnedDeg = pane.turnedDeg;
  texts.alongMm = plane.toLps(middle)[axes.plane];
  texts.slab = slab;
  texts.window = pixels.window();
  texts.level = pixels.level();
  overlay->setTexts(texts);
}

SliceScene::SliceScene() : parts_(std::make_unique<Parts>()) {}
SliceScene::~SliceScene() = default;

vtkRenderer* SliceScene::renderer() const { return parts_->renderer; }

void SliceScene::setImage(std::shared_ptr<const Volume<float>> image) {
  Parts& p = *parts_;
  const bool sameGrid = image && p.image && image->geometry == p.image->geometry;
  p.image = std::move(image);
  p.pixels.setImage(p.image);
  if (!p.image) {
    p.showContours();
    p.showPorts();
    p.showSeeds();
    p.showBoxes();
    p.showTexts();
    return;
  }
  if (!p.windowLevelSet) {
    const std::array<double, 2> range = displayRange(*p.image, 0.01, 0.998);
    p.pixels.setWindowLevel(range[1] - range[0], 0.5 * (range[0] + range[1]));
  }
  if (!sameGrid) {
    const Index3& size = p.image->geometry.size;
    p.cursor = p.image->geometry.toPhysical(Eigen::Vector3d(size[0] / 2, size[1] / 2, size[2] / 2));
    setPlane(p.planeNumber);
  } else {
    p.showSlice();
  }
}

const std::shared_ptr<const Volume<float>>& SliceScene::image() const { return parts_->image; }

void SliceScene::setPlane(int plane) {
  Parts& p = *parts_;
  p.planeNumber = std::clamp(plane, 0, 2);
  if (!p.image) {
    p.pane.axes.plane = p.planeNumber;
    return;
  }
  p.layOut();
  p.showSlice();
  fit();
}

const PaneAxes& SliceScene::axes() const { return parts_->pane.axes; }
const Geometry& SliceScene::grid() const { return parts_->pane.grid; }
const SlicePlane& SliceScene::plane() const { return parts_->plane; }
const SlicePixels& SliceScene::pixels() const { return parts_->pixels; }

void SliceScene::setTurn(const PlaneTurn& turn) {
  Parts& p = *parts_;
  const PlaneTurn before = std::exchange(p.turn, turn);
  if (turn == before || !p.image) return;
  const bool stays = turn.patientAxes == before.patientAxes &&
                     turn.turns[static_cast<std::size_t>(p.planeNumber)] ==
                         before.turns[static_cast<std::size_t>(p.planeNumber)] &&
                     (p.pane.native || turn.pivotLps == before.pivotLps);
  if (stays) return;
  // The crosshair stays where it is seen.
  const Eigen::Vector2d from = p.plane.fromLps(p.cursor).head<2>();
  p.layOut();
  p.showSlice();
  if (p.view.fitted() && (turn.patientAxes != before.patientAxes || !turn.turned()))
    fit();
  else
    p.view.moveBy(p.plane.fromLps(p.cursor).head<2>() - from);
}

const PlaneTurn& SliceScene::turn() const { return parts_->turn; }

bool SliceScene::knobAt(double displayX, double displayY) const {
  Parts& p = *parts_;
  return p.image && p.crosshairVisible &&
         p.crosshair.knobAt(p.toScene(displayX, displayY), p.gripMm());
}

std::vector<Eigen::Vector2d> SliceScene::knobs() const {
  std::vector<Eigen::Vector2d> knobs;
  for (const Eigen::Vector2d& knob : parts_->crosshair.knobs())
    knobs.push_back((knob - parts_->toScene(0.0, 0.0)) / parts_->view.mmPerPixel());
  return knobs;
}

double SliceScene::angleAt(double displayX, double displayY) const {
  Parts& p = *parts_;
  const Eigen::Vector2d way = p.toScene(displayX, displayY) - p.plane.fromLps(p.cursor).head<2>();
  return std::atan2(way.y(), way.x());
}

PlaneTurn SliceScene::turnedBy(const PlaneTurn& from, double radians) const {
  const PaneAxes& axes = parts_->pane.axes;
  return from.turnedBy(parts_->planeNumber, radians, axes.rightLps.cross(axes.upLps).normalized(),
                       parts_->cursor);
}

void SliceScene::setColourLayer(const ColourLayer& layer) {
  parts_->pixels.setOverlay(layer);
  parts_->showSlice();
}

void SliceScene::setWindowLevel(double window, double level) {
  parts_->windowLevelSet = true;
  parts_->pixels.setWindowLevel(window, level);
  parts_->showTexts();
}

double SliceScene::window() const { return parts_->pixels.window(); }
double SliceScene::level() const { return parts_->pixels.level(); }

void SliceScene::setInterpolated(bool on) { parts_->pixels.setInterpolated(on); }

void SliceScene::setSlice(int slice) {
  const int clamped = std::clamp(slice, 0, std::max(0, sliceCount() - 1));
  if (clamped == parts_->slice) return;
  parts_->slice = clamped;
  parts_->showSlice();
}

int SliceScene::slice() const { return parts_->slice; }

int SliceScene::sliceCount() const { return parts_->image ? sliceCountOf(parts_->pane) : 0; }

void SliceScene::setSlab(const Slab& slab) {
  parts_->slab = slab;
  parts_->showSlice();
}

const Slab& SliceScene::slab() const { return parts_->slab; }

void SliceScene::setCursor(const Eigen::Vector3d& lps) { parts_->cursor = lps; }
Eigen::Vector3d SliceScene::cursor() const { return parts_->cursor; }
void SliceScene::setCrosshairVisible(bool visible) { parts_->crosshairVisible = visible; }

void SliceScene::setContours(std::vector<ContourLayer> contours) {
  parts_->contours = std::move(contours);
  parts_->showContours();
}

void SliceScene::setSeeds(std::vector<Eigen::Vector3d> byHand, std::vector<Eigen::Vector3d> found) {
  parts_->seeds.set(std::move(byHand), std::move(found));
  parts_->showSeeds();
}

const std::vector<Eigen::Vector3d>& SliceScene::seeds() const { return parts_->seeds.byHand(); }

std::optional<std::size_t> SliceScene::seedAt(double displayX, double displayY) const {
  return parts_->seeds.at(parts_->toScene(displayX, displayY), parts_->gripMm());
}

void SliceScene::setPorts(std::vector<PortMark> marks) {
  parts_->ports.set(std::move(marks));
  parts_->showPorts();
}

const std::vector<PortMark>& SliceScene::ports() const { return parts_->ports.marks(); }

std::optional<PortHit> SliceScene::portAt(double displayX, double displayY) const {
  Parts& p = *parts_;
  return p.ports.at(p.toScene(displayX, displayY), p.gripMm());
}

PortDrag SliceScene::grabPort(const PortHit& hit, double displayX, double displayY) const {
  const PortMark& mark = ports()[hit.mark];
  return {mark, hit.grip, mark.discRadiusMm(), rayAt(displayX, displayY)};
}

ViewRay SliceScene::rayAt(double displayX, double displayY) const {
  const SlicePlane& plane = parts_->plane;
  const Eigen::Vector3d corner = plane.toLps({0.0, 0.0});
  const Eigen::Vector3d across =
      (plane.toLps({0.0, 1.0}) - corner).cross(plane.toLps({1.0, 0.0}) - corner);
  return {lpsAt(displayX, displayY), across.normalized()};
}

void SliceScene::setWords(const SliceWords& words) {
  parts_->overlay->setWords(words);
  parts_->showTexts();
}

void SliceScene::setCaption(const std::string& lines) {
  parts_->texts.caption = lines;
  parts_->showTexts();
}

void SliceScene::setPointerText(const std::string& lines) {
  parts_->texts.pointer = lines;
  parts_->showTexts();
}

void SliceScene::setRoi(const std::optional<RoiBox>& roi) {
  parts_->roi = roi;
  parts_->showBoxes();
}

void SliceScene::setPreviewGrid(const std::optional<Geometry>& grid) {
  parts_->preview = grid;
  parts_->showBoxes();
}

const std::optional<RoiBox>& SliceScene::roi() const { return parts_->roi; }

void SliceScene::fit() {
  if (parts_->image) parts_->view.fit(parts_->plane);
}

void SliceScene::zoom(double factor, double displayX, double displayY) {
  parts_->view.followSize(parts_->plane);
  parts_->view.zoom(factor, displayX, displayY, parts_->plane);
}

void SliceScene::pan(double displayDx, double displayDy) {
  parts_->view.followSize(parts_->plane);
  parts_->view.pan(displayDx, displayDy);
}

void SliceScene::setPixelRatio(double ratio) {
  parts_->view.scaleBy(parts_->pixelRatio / ratio);
  parts_->pixelRatio = ratio;
  parts_->showSlice();
}

Eigen::Vector3d SliceScene::lpsAt(double displayX, double displayY) const {
  return parts_->plane.toLps(parts_->toScene(displayX, displayY));
}

Eigen::Vector2d SliceScene::displayAt(const Eigen::Vector3d& lps) const {
  Parts& p = *parts_;
  const Eigen::Vector2d origin = p.toScene(0.0, 0.0);
  return (p.plane.fromLps(lps).head<2>() - origin) / p.view.mmPerPixel();
}

int SliceScene::sliceAt(const Eigen::Vector3d& lps) const {
  return parts_->image ? nearestSlice(parts_->pane, lps) : 0;
}

std::optional<SliceScene::Probe> SliceScene::probe(const Eigen::Vector3d& lps) const {
  return parts_->pixels.probe(lps);
}

}  // namespace angiomesh
