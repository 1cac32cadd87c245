// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_scene.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkImageProperty.h>
#include <vtkImageSlice.h>
#include <vtkImageSliceMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "render/slice/slice_layer.h"
#include "render/slice/slice_marks.h"
#include "render/slice/slice_overlay.h"

namespace angiomesh {

namespace {

/// Depths of the flat scene's layers, towards the viewer.
constexpr double roiDepth = 1.0, contourDepth = 2.0, portDepth = 2.5, crosshairDepth = 3.0,
                 seedDepth = 4.0;
constexpr double gripPixels = 8.0;  // design pixels around a port's lines

}  // namespace

struct SliceScene::Parts {
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkImageData> pixels;
  vtkNew<vtkImageSlice> imageProp;
  std::vector<std::unique_ptr<SliceLayer>> contourLayers;
  SliceLayer crosshair, roiLine, seedDots;
  SliceMarks ports{renderer};
  std::unique_ptr<SliceOverlay> overlay;
  vtkNew<vtkCallbackCommand> beforeFrame;

  std::shared_ptr<const Volume<float>> image;
  SliceOverlay::Texts texts;
  std::vector<float> values;  // shown pixels, screen order
  std::vector<ContourLayer> contours;
  std::vector<Eigen::Vector3d> seeds;
  std::optional<RoiBox> roi;
  PaneAxes axes;
  SlicePlane plane;
  int planeNumber = 2, slice = 0;
  SlabMode slabMode = SlabMode::None;
  double slabThickness = 0.0, pixelRatio = 1.0;
  bool windowLevelSet = false, crosshairVisible = true;
  Eigen::Vector3d cursor{0.0, 0.0, 0.0};
  // Centre of the view and mm per display pixel; a fitted view follows the pane's size.
  Eigen::Vector2d centre{0.0, 0.0};
  double mmPerPixel = 1.0;
  bool fitted = true;
  std::array<int, 2> lastSize{0, 0};

  Parts();
  ~Parts() { renderer->RemoveObserver(beforeFrame); }
  [[nodiscard]] Eigen::Vector2d size() const;
  [[nodiscard]] Eigen::Vector2d toScene(double displayX, double displayY);
  [[nodiscard]] std::array<int, 2> slab() const;
  void followSize();
  void fit();
  void prepareFrame();
  void showSlice();
  void showContours();
  void showCrosshair();
  void showPorts() { ports.show(plane, image != nullptr, portDepth, pixelRatio); }
  void showSeeds();
  void showRoi();
  void showTexts();
};

SliceScene::Parts::Parts() {
  renderer->SetBackground(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->ParallelProjectionOn();

  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(pixels);
  mapper->BorderOn();
  mapper->SetOrientationToZ();
  imageProp->SetMapper(mapper);
  imageProp->GetProperty()->SetInterpolationTypeToLinear();
  imageProp->VisibilityOff();
  renderer->AddViewProp(imageProp);

  roiLine.colour(0.35, 0.80, 1.0);
  crosshair.colour(0.95, 0.85, 0.25);
  crosshair.actor->GetProperty()->SetOpacity(0.6);
  seedDots.actor->GetProperty()->RenderPointsAsSpheresOn();
  for (SliceLayer* layer : {&roiLine, &crosshair, &seedDots}) {
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

Eigen::Vector2d SliceScene::Parts::size() const {
  if (renderer->GetRenderWindow() == nullptr) return {1.0, 1.0};
  const int* s = renderer->GetSize();
  return {std::max(1, s[0]), std::max(1, s[1])};
}

Eigen::Vector2d SliceScene::Parts::toScene(double displayX, double displayY) {
  followSize();
  const int* origin = renderer->GetRenderWindow() != nullptr ? renderer->GetOrigin() : nullptr;
  const Eigen::Vector2d corner =
      origin != nullptr ? Eigen::Vector2d(origin[0], origin[1]) : Eigen::Vector2d(0.0, 0.0);
  return centre + mmPerPixel * (Eigen::Vector2d(displayX, displayY) - corner - 0.5 * size());
}

std::array<int, 2> SliceScene::Parts::slab() const {
  if (slabMode == SlabMode::None) return {slice, slice};
  return slabSlices(image->geometry, axes, slice, slabThickness);
}

void SliceScene::Parts::fit() {
  fitted = true;
  if (!image) return;
  const Eigen::Vector2d pane = size();
  lastSize = {static_cast<int>(pane[0]), static_cast<int>(pane[1])};
  const Eigen::Vector2d pixel(plane.pixelWidthMm(), plane.pixelHeightMm());
  const Eigen::Vector2d extent(pixel[0] * plane.width(), pixel[1] * plane.height());
  centre = 0.5 * (extent - pixel);
  mmPerPixel = extent.cwiseQuotient(pane).maxCoeff();
}

void SliceScene::Parts::followSize() {
  const Eigen::Vector2d pane = size();
  if (fitted &&
      (static_cast<int>(pane[0]) != lastSize[0] || static_cast<int>(pane[1]) != lastSize[1]))
    fit();
}

void SliceScene::Parts::prepareFrame() {
  followSize();
  const Eigen::Vector2d pane = size();
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(centre[0], centre[1], 0.0);
  camera->SetPosition(centre[0], centre[1], 100.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.5 * pane[1] * mmPerPixel);
  camera->SetClippingRange(50.0, 150.0);
  overlay->setScale(mmPerPixel, static_cast<int>(pane[0]), static_cast<int>(pane[1]), pixelRatio);
  showCrosshair();
}

void SliceScene::Parts::showSlice() {
  if (!image) return;
  plane = SlicePlane(image->geometry, axes, slice);
  const std::array<int, 2> range = slab();
  rasteriseSlab(*image, axes, slabMode, range[0], range[1], values);
  vtkNew<vtkFloatArray> array;
  array->SetArray(values.data(), static_cast<vtkIdType>(values.size()), 1);
  pixels->SetDimensions(plane.width(), plane.height(), 1);
  pixels->SetSpacing(plane.pixelWidthMm(), plane.pixelHeightMm(), 1.0);
  pixels->GetPointData()->SetScalars(array);
  pixels->Modified();
  showContours();
  showPorts();
  showSeeds();
  showRoi();
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

void SliceScene::Parts::showCrosshair() {
  const bool visible = image && crosshairVisible;
  crosshair.actor->SetVisibility(visible);
  if (!visible) return;
  const Eigen::Vector2d c = plane.fromLps(cursor).head<2>();
  // The lines end before the letters on the edges.
  const Eigen::Vector2d half =
      mmPerPixel * (0.5 * size().array() - 30.0 * pixelRatio).max(0.0).matrix();
  const Eigen::Vector2d low = centre - half;
  const Eigen::Vector2d high = centre + half;
  const double gap = 10.0 * pixelRatio * mmPerPixel;  // the spot itself stays visible
  crosshair.setSegments(
      {{Eigen::Vector2d(std::min(low[0], c[0] - gap), c[1]), {c[0] - gap, c[1]}},
       {Eigen::Vector2d(c[0] + gap, c[1]), {std::max(high[0], c[0] + gap), c[1]}},
       {Eigen::Vector2d(c[0], std::min(low[1], c[1] - gap)), {c[0], c[1] - gap}},
       {Eigen::Vector2d(c[0], c[1] + gap), {c[0], std::max(high[1], c[1] + gap)}}},
      crosshairDepth);
}

void SliceScene::Parts::showSeeds() {
  const bool visible = image && !seeds.empty();
  seedDots.actor->SetVisibility(visible);
  if (!visible) return;
  const std::array<int, 2> range = slab();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(4);
  for (const Eigen::Vector3d& seed : seeds) {
    const Eigen::Vector3d p = plane.fromLps(seed);
    const double position = slice + p[2];
    const double off = std::max({range[0] - 0.5 - position, position - range[1] - 0.5, 0.0});
    if (off > 3.0) continue;  // slices: seeds further away would only confuse
    dots->InsertNextCell({points->InsertNextPoint(p[0], p[1], seedDepth)});
    const double alpha = off > 0.0 ? 90.0 : 255.0;
    colours->InsertNextTuple4(60.0, 230.0, 120.0, alpha);
  }
  seedDots.data->SetPoints(points);
  seedDots.data->SetVerts(dots);
  seedDots.data->GetPointData()->SetScalars(colours);
  seedDots.actor->GetProperty()->SetPointSize(static_cast<float>(7.0 * pixelRatio));
}

void SliceScene::Parts::showRoi() {
  const std::vector<Eigen::Vector2d> polygon =
      image && roi ? boxSection(*roi, plane) : std::vector<Eigen::Vector2d>();
  roiLine.actor->SetVisibility(!polygon.empty());
  roiLine.actor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixelRatio));
  std::vector<std::array<Eigen::Vector2d, 2>> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    sides.push_back({polygon[k], polygon[(k + 1) % polygon.size()]});
  roiLine.setSegments(sides, roiDepth);
}

void SliceScene::Parts::showTexts() {
  overlay->setVisible(image != nullptr);
  if (!image) return;
  overlay->setLetters(axes);
  const Eigen::Vector2d middle(0.5 * (plane.width() - 1) * plane.pixelWidthMm(),
                               0.5 * (plane.height() - 1) * plane.pixelHeightMm());
  texts.plane = axes.plane;
  texts.slice = slice;
  texts.count = image->geometry.size[static_cast<std::size_t>(axes.across)];
  texts.alongMm = plane.toLps(middle)[axes.plane];
  texts.slabMode = slabMode;
  texts.slabThicknessMm = slabThickness;
  texts.window = imageProp->GetProperty()->GetColorWindow();
  texts.level = imageProp->GetProperty()->GetColorLevel();
  overlay->setTexts(texts);
}

SliceScene::SliceScene() : parts_(std::make_unique<Parts>()) {}
SliceScene::~SliceScene() = default;

vtkRenderer* SliceScene::renderer() const { return parts_->renderer; }

void SliceScene::setImage(std::shared_ptr<const Volume<float>> image) {
  Parts& p = *parts_;
  const bool sameGrid = image && p.image && image->geometry == p.image->geometry;
  p.image = std::move(image);
  p.imageProp->SetVisibility(p.image != nullptr);
  if (!p.image) {
    p.showContours();
    p.showPorts();
    p.showSeeds();
    p.showRoi();
    p.showTexts();
    return;
  }
  if (!p.windowLevelSet) {
    const std::array<double, 2> range = displayRange(*p.image, 0.01, 0.998);
    p.imageProp->GetProperty()->SetColorWindow(range[1] - range[0]);
    p.imageProp->GetProperty()->SetColorLevel(0.5 * (range[0] + range[1]));
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
    p.axes.plane = p.planeNumber;
    return;
  }
  p.axes = paneAxes(p.image->geometry, p.planeNumber);
  p.slice = sliceAt(p.cursor);
  p.showSlice();
  p.fit();
}

const PaneAxes& SliceScene::axes() const { return parts_->axes; }

void SliceScene::setWindowLevel(double window, double level) {
  parts_->windowLevelSet = true;
  parts_->imageProp->GetProperty()->SetColorWindow(window);
  parts_->imageProp->GetProperty()->SetColorLevel(level);
  parts_->showTexts();
}

double SliceScene::window() const { return parts_->imageProp->GetProperty()->GetColorWindow(); }
double SliceScene::level() const { return parts_->imageProp->GetProperty()->GetColorLevel(); }

void SliceScene::setInterpolated(bool on) {
  parts_->imageProp->GetProperty()->SetInterpolationType(on ? VTK_LINEAR_INTERPOLATION
                                                            : VTK_NEAREST_INTERPOLATION);
}

void SliceScene::setSlice(int slice) {
  const int clamped = std::clamp(slice, 0, std::max(0, sliceCount() - 1));
  if (clamped == parts_->slice) return;
  parts_->slice = clamped;
  parts_->showSlice();
}

int SliceScene::slice() const { return parts_->slice; }

int SliceScene::sliceCount() const {
  return parts_->image ? parts_->image->geometry.size[static_cast<std::size_t>(parts_->axes.across)]
                       : 0;
}

void SliceScene::setSlab(SlabMode mode, double thicknessMm) {
  parts_->slabMode = mode;
  parts_->slabThickness = std::max(0.0, thicknessMm);
  parts_->showSlice();
}

SlabMode SliceScene::slabMode() const { return parts_->slabMode; }
double SliceScene::slabThicknessMm() const { return parts_->slabThickness; }

void SliceScene::setCursor(const Eigen::Vector3d& lps) { parts_->cursor = lps; }
Eigen::Vector3d SliceScene::cursor() const { return parts_->cursor; }
void SliceScene::setCrosshairVisible(bool visible) { parts_->crosshairVisible = visible; }

void SliceScene::setContours(std::vector<ContourLayer> contours) {
  parts_->contours = std::move(contours);
  parts_->showContours();
}

void SliceScene::setSeeds(std::vector<Eigen::Vector3d> lps) {
  parts_->seeds = std::move(lps);
  parts_->showSeeds();
}

void SliceScene::setPorts(std::vector<PortMark> marks) {
  parts_->ports.set(std::move(marks));
  parts_->showPorts();
}

const std::vector<PortMark>& SliceScene::ports() const { return parts_->ports.marks(); }

std::optional<PortHit> SliceScene::portAt(double displayX, double displayY) const {
  Parts& p = *parts_;
  return p.ports.at(p.toScene(displayX, displayY), gripPixels * p.pixelRatio * p.mmPerPixel);
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
  parts_->showRoi();
}

const std::optional<RoiBox>& SliceScene::roi() const { return parts_->roi; }

void SliceScene::fit() { parts_->fit(); }

void SliceScene::zoom(double factor, double displayX, double displayY) {
  Parts& p = *parts_;
  const Eigen::Vector2d fixed = p.toScene(displayX, displayY);
  const double wanted = p.mmPerPixel / factor;
  // From a hundredth of a pixel's size to a thousand volumes: beyond, numbers lose their meaning.
  const double smallest = 0.001 * std::min(p.plane.pixelWidthMm(), p.plane.pixelHeightMm());
  const double changed = std::clamp(wanted, smallest, 1e5 * smallest);
  p.centre = fixed + (p.centre - fixed) * (changed / p.mmPerPixel);
  p.mmPerPixel = changed;
  p.fitted = false;
}

void SliceScene::pan(double displayDx, double displayDy) {
  parts_->followSize();
  parts_->centre -= parts_->mmPerPixel * Eigen::Vector2d(displayDx, displayDy);
  parts_->fitted = false;
}

void SliceScene::setPixelRatio(double ratio) {
  parts_->mmPerPixel *= parts_->pixelRatio / ratio;
  parts_->pixelRatio = ratio;
  parts_->crosshair.actor->GetProperty()->SetLineWidth(static_cast<float>(ratio));
  parts_->showSlice();
}

Eigen::Vector3d SliceScene::lpsAt(double displayX, double displayY) const {
  return parts_->plane.toLps(parts_->toScene(displayX, displayY));
}

Eigen::Vector2d SliceScene::displayAt(const Eigen::Vector3d& lps) const {
  Parts& p = *parts_;
  const Eigen::Vector2d origin = p.toScene(0.0, 0.0);
  return (p.plane.fromLps(lps).head<2>() - origin) / p.mmPerPixel;
}

int SliceScene::sliceAt(const Eigen::Vector3d& lps) const {
  if (!parts_->image) return 0;
  const double index = parts_->image->geometry.toIndex(lps)[parts_->axes.across];
  return static_cast<int>(std::clamp(std::round(index), 0.0, std::max(0.0, sliceCount() - 1.0)));
}

std::optional<SliceScene::Probe> SliceScene::probe(const Eigen::Vector3d& lps) const {
  const Parts& p = *parts_;
  if (!p.image) return std::nullopt;
  const Eigen::Vector3d xy = p.plane.fromLps(lps);
  const double column = std::round(xy[0] / p.plane.pixelWidthMm());
  const double row = std::round(xy[1] / p.plane.pixelHeightMm());
  if (!(column >= 0.0 && row >= 0.0 && column < p.plane.width() && row < p.plane.height()))
    return std::nullopt;
  const auto c = static_cast<int>(column);
  const auto r = static_cast<int>(row);
  Probe probe;
  probe.value = p.values[static_cast<std::size_t>(r) * static_cast<std::size_t>(p.plane.width()) +
                         static_cast<std::size_t>(c)];
  Index3& voxel = probe.voxel;
  voxel[static_cast<std::size_t>(p.axes.across)] = p.slice;
  voxel[static_cast<std::size_t>(p.axes.right)] = p.axes.rightFlipped ? p.plane.width() - 1 - c : c;
  voxel[static_cast<std::size_t>(p.axes.up)] = p.axes.upFlipped ? p.plane.height() - 1 - r : r;
  // A projection shows the voxel that holds the extreme value: that is the one to name (and pick).
  if (p.slabMode == SlabMode::Mip || p.slabMode == SlabMode::MinIp) {
    const std::array<int, 2> range = p.slab();
    int& along = voxel[static_cast<std::size_t>(p.axes.across)];
    for (along = range[0]; along < range[1]; ++along)
      if (p.image->at(voxel[0], voxel[1], voxel[2]) == probe.value) break;
  }
  return probe;
}

}  // namespace angiomesh
