// SPDX-License-Identifier: BSD-3-Clause
#include "render/surface/surface_scene.h"

#include <vtkActor.h>
#include <vtkBoundingBox.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp3D.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "render/marks/measure_marks.h"
#include "render/stage/colour_bar.h"
#include "render/stage/direction_cube.h"
#include "render/stage/stage.h"
#include "render/surface/slice_quads.h"
#include "render/surface/surface_actor.h"
#include "render/surface/triangle_marks.h"
#include "render/surface/volume_prop.h"

namespace angiomesh {

namespace {

/// How the time of a projection falls with its coarseness: by its square across the picture, and a
/// little along the rays.
constexpr double costExponent = 2.3;

}  // namespace

struct SurfaceScene::Parts {
  // A projection has no depth of its own, so it lies behind the surfaces in a layer of its own,
  // with the same camera. A lit volume is among them.
  vtkNew<vtkRenderer> renderer, backRenderer;
  vtkNew<vtkCallbackCommand> beforeFrame, afterFrame;
  DirectionCube cube;
  VolumeProp projection;
  SurfaceActor surface{{0.84, 0.27, 0.21}};
  PortMarks ports{renderer};
  TriangleMarks marked;
  MeasureMarks measures{renderer};
  std::shared_ptr<const DrawnMesh> drawn;
  SliceQuads slices{renderer};
  bool meshVisible = true;
  ColourBar colourBar{renderer};
  vtkNew<vtkTextActor> caption;
  vtkNew<vtkPolyData> seedData;
  vtkNew<vtkActor> seedActor;
  vtkNew<vtkOutlineSource> roiSource;
  vtkNew<vtkActor> roiActor;
  vtkRenderWindow* window = nullptr;

  std::shared_ptr<const DrawnVolume> image;
  VolumeView volumeView = VolumeView::Mip;
  bool volumeInFront = false;
  bool interactive = false, software = false, softwareKnown = false;
  bool fittedOnce = false;
  // Camera position and pane size of the last fit: a camera still there follows the pane's size.
  Eigen::Vector3d fittedAt{0.0, 0.0, 0.0};
  std::array<int, 2> fittedSize{0, 0};
  std::array<double, 6> fittedBounds{};
  double pixelRatio = 1.0;
  double projectionCost = 0.5;  // seconds of the processor's projection at full quality, estimated

  Parts();
  ~Parts() {
    backRenderer->RemoveObserver(beforeFrame);
    renderer->RemoveObserver(afterFrame);
  }
  void noteCost();
  void prepareFrame();
  void chooseQuality();
  void showVolume();
  void showColourBar();
  void fitOnce();
  bool visibleBounds(std::array<double, 6>& bounds) const;
  /// Those of the image when it is there and nothing is visible.
  bool contentBounds(std::array<double, 6>& bounds) const;
  void resetView();
  void lookFrom(const Viewpoint& view);
  void fit();
  void fitTo(const std::array<double, 6>& bounds);
  void followSize();
};

SurfaceScene::Parts::Parts() {
  setStage(backRenderer);
  backRenderer->InteractiveOff();
  setStage(renderer);
  renderer->SetLayer(1);
  backRenderer->SetActiveCamera(renderer->GetActiveCamera());
  renderer->AddActor(surface.actor());
  renderer->AddActor(marked.actor());
  backRenderer->AddViewProp(projection.prop());

  vtkNew<vtkPolyDataMapper> seedMapper;
  seedMapper->SetInputData(seedData);
  seedActor->SetMapper(seedMapper);
  seedActor->GetProperty()->SetColor(0.24, 0.90, 0.47);
  seedActor->GetProperty()->RenderPointsAsSpheresOn();
  seedActor->GetProperty()->SetPointSize(9.0F);
  seedActor->VisibilityOff();
  renderer->AddActor(seedActor);

  vtkNew<vtkPolyDataMapper> roiMapper;
  roiMapper->SetInputConnection(roiSource->GetOutputPort());
  roiActor->SetMapper(roiMapper);
  roiActor->GetProperty()->SetColor(0.35, 0.80, 1.0);
  roiActor->GetProperty()->LightingOff();
  roiActor->VisibilityOff();
  renderer->AddActor(roiActor);

  styleText(caption, textSize);
  caption->GetTextProperty()->SetJustificationToRight();
  caption->GetTextProperty()->SetVerticalJustificationToTop();
  renderer->AddViewProp(caption);

  beforeFrame->SetClientData(this);
  beforeFrame->SetCallback([](vtkObject*, unsigned long, void* self, void*) {
    static_cast<Parts*>(self)->prepareFrame();
  });
  backRenderer->AddObserver(vtkCommand::StartEvent, beforeFrame);
  afterFrame->SetClientData(this);
  afterFrame->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<Parts*>(self)->noteCost(); });
  renderer->AddObserver(vtkCommand::EndEvent, afterFrame);
}

void SurfaceScene::Parts::noteCost() {
  if (!software || projection.prop()->GetVisibility() == 0) return;
  const double cost =
      projection.secondsOfLastFrame() * std::pow(projection.coarseness(), costExponent);
  projectionCost += 0.5 * (cost - projectionCost);
}

void SurfaceScene::Parts::prepareFrame() {
  if (!softwareKnown) {
    softwareKnown = true;
    software = drawnBySoftware(renderer);
    projection.setSoftware(software);
    chooseQuality();
  }
  followSize();
  std::array<double, 6> bounds{};
  if (visibleBounds(bounds)) renderer->ResetCameraClippingRange(bounds.data());
  const int* size = window != nullptr ? window->GetSize() : renderer->GetSize();
  const double margin = textMargin * pixelRatio;
  caption->SetPosition(size[0] - margin, size[1] - margin);
  ports.follow(pixelRatio);
  cube.follow(renderer->GetActiveCamera(), size[0], size[1], pixelRatio);
}

void SurfaceScene::Parts::chooseQuality() {
  if (!software) {
    projection.setCoarseness(interactive ? 1.5 : 1.0);
    return;
  }
  // As fine as the last frames say that fits the time: nobody waits long for a turn or a surface.
  const double seconds = interactive ? 0.015 : 0.4;
  const double fitting = std::pow(projectionCost / seconds, 1.0 / costExponent);
  projection.setCoarseness(std::clamp(fitting, interactive ? 1.5 : 1.0, 6.0));
}

void SurfaceScene::Parts::showVolume() {
  const bool visible = volumeView != VolumeView::None && image != nullptr;
  projection.prop()->SetVisibility(visible);
  if (!visible) return;
  const VolumeLook look = lookOf(volumeView, *image);
  const bool front = look.kind == RayKind::Lit;
  if (front != volumeInFront) {
    (front ? backRenderer : renderer)->RemoveViewProp(projection.prop());
    (front ? renderer : backRenderer)->AddViewProp(projection.prop());
    volumeInFront = front;
  }
  projection.setEndsAtSurfaces(front);
  projection.setLook(look);
}

void SurfaceScene::Parts::showColourBar() { colourBar.setVisible(surface.coloured()); }

bool SurfaceScene::Parts::visibleBounds(std::array<double, 6>& bounds) const {
  vtkBoundingBox box;
  for (vtkRenderer* layer : {backRenderer.Get(), renderer.Get()}) {
    layer->ComputeVisiblePropBounds(bounds.data());
    if (bounds[0] <= bounds[1]) box.AddBounds(bounds.data());
  }
  if (!box.IsValid()) return false;
  box.GetBounds(bounds.data());
  return true;
}

bool SurfaceScene::Parts::contentBounds(std::array<double, 6>& bounds) const {
  if (visibleBounds(bounds)) return true;
  if (!image) return false;
  const RoiBox box = volumeBox(image->image->geometry);
  bounds = {box[0], box[3], box[1], box[4], box[2], box[5]};
  return true;
}

void SurfaceScene::Parts::fit() {
  std::array<double, 6> bounds{};
  if (contentBounds(bounds)) fitTo(bounds);
}

void SurfaceScene::Parts::fitTo(const std::array<double, 6>& bounds) {
  fitCamera(renderer, bounds);
  fittedBounds = bounds;
  fittedAt = Eigen::Vector3d(renderer->GetActiveCamera()->GetPosition());
  const int* size = renderer->GetRenderWindow() != nullptr ? renderer->GetSize() : nullptr;
  if (size != nullptr) fittedSize = {size[0], size[1]};
}

void SurfaceScene::Parts::followSize() {
  const int* size = renderer->GetSize();
  const Eigen::Vector3d position(renderer->GetActiveCamera()->GetPosition());
  const bool resized = size[0] != fittedSize[0] || size[1] != fittedSize[1];
  // To what it was fitted to before: what came or went since then does not move what is seen.
  if (fittedOnce && resized && position == fittedAt) fitTo(fittedBounds);
}

void SurfaceScene::Parts::fitOnce() {
  if (fittedOnce || (!image && surface.empty())) return;
  fittedOnce = true;
  resetView();
}

void SurfaceScene::Parts::resetView() {
  std::array<double, 6> bounds{};
  if (!contentBounds(bounds)) return;
  lookFrom(firstViewpoint(bounds));
}

void SurfaceScene::Parts::lookFrom(const Viewpoint& view) {
  vtkCamera* camera = renderer->GetActiveCamera();
  const Eigen::Vector3d position =
      Eigen::Vector3d(camera->GetFocalPoint()) + camera->GetDistance() * view.from;
  camera->SetPosition(position.data());
  camera->SetViewUp(view.up.data());
  fit();
}

SurfaceScene::SurfaceScene() : parts_(std::make_unique<Parts>()) {}

SurfaceScene::~SurfaceScene() { detach(); }

void SurfaceScene::attach(vtkRenderWindow* window) {
  detach();
  parts_->window = window;
  window->SetNumberOfLayers(3);
  window->AddRenderer(parts_->backRenderer);
  window->AddRenderer(parts_->renderer);
  window->AddRenderer(parts_->cube.renderer());
}

void SurfaceScene::detach() {
  if (parts_->window == nullptr) return;
  parts_->window->RemoveRenderer(parts_->backRenderer);
  parts_->window->RemoveRenderer(parts_->renderer);
  parts_->window->RemoveRenderer(parts_->cube.renderer());
  parts_->window = nullptr;
}

vtkRenderer* SurfaceScene::renderer() const { return parts_->renderer; }

void SurfaceScene::setImage(std::shared_ptr<const Volume<float>> image) {
  setDrawnImage(drawnVolume(std::move(image)));
}

void SurfaceScene::setDrawnImage(std::shared_ptr<const DrawnVolume> image) {
  Parts& p = *parts_;
  const bool sameGrid = image && p.image && image->image->geometry == p.image->image->geometry;
  p.image = std::move(image);
  p.projection.setVolume(p.image);
  p.showVolume();
  if (!sameGrid) p.fittedOnce = false;
  p.fitOnce();
}

void SurfaceScene::setVolumeView(VolumeView view) {
  parts_->volumeView = view;
  parts_->showVolume();
}

void SurfaceScene::setMipWindow(double from, double to) {
  parts_->projection.setLook(projectionLook(from, to));
}

void SurfaceScene::setInteractive(bool interactive) {
  parts_->interactive = interactive;
  parts_->chooseQuality();
  setSurfaceCoarse(interactive);
}

void SurfaceScene::setSurfaceCoarse(bool coarse) {
  // A graphics card draws millions of triangles in time.
  parts_->surface.setCoarse(coarse && parts_->software);
}

void SurfaceScene::setSurface(std::shared_ptr<const TriMesh> mesh) {
  setDrawnSurface(drawnMesh(std::move(mesh)));
}

void SurfaceScene::setDrawnSurface(std::shared_ptr<const DrawnMesh> mesh) {
  const bool other = !parts_->drawn || meshOf(*mesh) != meshOf(*parts_->drawn);
  if (other) parts_->marked.clear();
  parts_->drawn = mesh;
  parts_->surface.setMesh(std::move(mesh));
  parts_->showColourBar();
  parts_->fitOnce();
}

void SurfaceScene::setSurfaceVisible(bool visible) {
  parts_->meshVisible = visible;
  parts_->surface.setVisible(visible);
  parts_->marked.setVisible(visible);
  parts_->showColourBar();
}

void SurfaceScene::setEdgesVisible(bool visible) { parts_->surface.setEdgesVisible(visible); }

void SurfaceScene::setSurfaceDimmed(bool dimmed) { parts_->surface.setDimmed(dimmed); }

void SurfaceScene::setCaption(const std::string& lines) {
  parts_->caption->SetInput(lines.c_str());
}

void SurfaceScene::setSurfaceColours(std::vector<float> perTriangle, const std::string& title,
                                     double lo, double hi) {
  parts_->colourBar.setRange(title, lo, hi);
  parts_->surface.setTriangleValues(std::move(perTriangle), parts_->colourBar.table());
  parts_->showColourBar();
}

void SurfaceScene::clearSurfaceColours() {
  parts_->surface.setTriangleValues({}, nullptr);
  parts_->showColourBar();
}

void SurfaceScene::setMarked(const std::vector<std::uint32_t>& triangles) {
  if (parts_->drawn && meshOf(*parts_->drawn))
    parts_->marked.set(*meshOf(*parts_->drawn), triangles);
  else
    parts_->marked.clear();
}

void SurfaceScene::setPatchColours(std::vector<std::array<double, 3>> colours) {
  parts_->surface.setPatchColours(std::move(colours));
}

void SurfaceScene::setPorts(std::vector<PortMark> marks) { parts_->ports.set(std::move(marks)); }

void SurfaceScene::setMeasures(const std::vector<MeasureMark>& marks) {
  parts_->measures.show(drawnInSpace(marks));
}

const std::vector<PortMark>& SurfaceScene::ports() const { return parts_->ports.marks(); }

ViewRay SurfaceScene::rayAt(double displayX, double displayY) const {
  return viewRay(parts_->renderer, displayX, displayY);
}

std::optional<Eigen::Vector3d> SurfaceScene::surfaceAt(double displayX, double displayY) const {
  const std::optional<SurfaceHit> hit = hitAt(displayX, displayY);
  return hit ? std::optional(hit->place) : std::nullopt;
}

std::optional<SurfaceHit> SurfaceScene::hitAt(double displayX, double displayY) const {
  const Parts& p = *parts_;
  if (!p.drawn || !visibleMesh(*p.drawn) || !p.meshVisible) return std::nullopt;
  std::optional<SurfaceHit> hit = firstHit(*visibleMesh(*p.drawn), rayAt(displayX, displayY));
  if (hit) hit->triangle = originalTriangle(*p.drawn, hit->triangle);
  return hit;
}

bool SurfaceScene::setSlices(const std::vector<const SliceScene*>& scenes) {
  return parts_->slices.show(scenes);
}

std::optional<PortHit> SurfaceScene::portAt(double displayX, double displayY) const {
  const auto hit = gripAt(displayX, displayY);
  if (!hit) return std::nullopt;
  const auto surface = surfaceAt(displayX, displayY);
  if (!surface) return hit;
  const PortMark& mark = ports()[hit->mark];
  const ViewRay ray = rayAt(displayX, displayY);
  const double behind = (mark.plane.pointLps - *surface).dot(ray.direction);
  // The vessel itself lies around its disc.
  if (behind > 2.0 * mark.discRadiusMm()) return std::nullopt;
  return hit;
}

std::optional<PortHit> SurfaceScene::gripAt(double displayX, double displayY) const {
  return parts_->ports.at(displayX, displayY);
}

PortDrag SurfaceScene::grabPort(const PortHit& hit, double displayX, double displayY) const {
  return {ports()[hit.mark], hit.grip, parts_->ports.arrowMm(hit.mark), rayAt(displayX, displayY)};
}

Eigen::Vector2d SurfaceScene::displayAt(const Eigen::Vector3d& lps) const {
  return displayOf(parts_->renderer, lps);
}

Eigen::Vector3d SurfaceScene::arrowTip(std::size_t port) const {
  const CutPlane& plane = ports()[port].plane;
  return plane.pointLps + parts_->ports.arrowMm(port) * plane.normalLps;
}

void SurfaceScene::setSeeds(std::vector<Eigen::Vector3d> lps) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> dots;
  for (const Eigen::Vector3d& seed : lps)
    dots->InsertNextCell({points->InsertNextPoint(seed[0], seed[1], seed[2])});
  parts_->seedData->SetPoints(points);
  parts_->seedData->SetVerts(dots);
  parts_->seedActor->SetVisibility(!lps.empty());
}

void SurfaceScene::setRoi(const std::optional<RoiBox>& roi) {
  parts_->roiActor->SetVisibility(roi.has_value());
  if (roi) {
    const RoiBox& b = *roi;
    parts_->roiSource->SetBounds(b[0], b[3], b[1], b[4], b[2], b[5]);
  }
}

void SurfaceScene::viewFrom(char side) {
  if (const auto view = viewpointFrom(side)) parts_->lookFrom(*view);
}

void SurfaceScene::resetView() { parts_->resetView(); }

void SurfaceScene::fit() { parts_->fit(); }

void SurfaceScene::turn(double right, double up) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  camera->Azimuth(-right);
  camera->Elevation(-up);
  camera->OrthogonalizeViewUp();
}

void SurfaceScene::lookAt(const Eigen::Vector3d& lps, double radiusMm) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  double direction[3];
  camera->GetDirectionOfProjection(direction);
  const double halfAngle = 0.5 * viewAngleDegrees * std::numbers::pi / 180.0;
  const double distance = std::max(radiusMm, 1e-3) / std::sin(halfAngle);
  camera->SetFocalPoint(lps.data());
  camera->SetPosition(lps[0] - distance * direction[0], lps[1] - distance * direction[1],
                      lps[2] - distance * direction[2]);
}

void SurfaceScene::lookAtFrom(const Eigen::Vector3d& lps, const Eigen::Vector3d& normal,
                              double radiusMm) {
  vtkCamera* camera = parts_->renderer->GetActiveCamera();
  if (!normal.isZero()) {
    const Eigen::Vector3d position = Eigen::Vector3d(camera->GetFocalPoint()) + normal;
    camera->SetPosition(position.data());
    // Upwards as far as that goes.
    const Eigen::Vector3d up = std::abs(normal[2]) < 0.95 ? Eigen::Vector3d(0.0, 0.0, 1.0)
                                                          : Eigen::Vector3d(0.0, -1.0, 0.0);
    camera->SetViewUp(up.data());
    camera->OrthogonalizeViewUp();
  }
  lookAt(lps, radiusMm);
}

void SurfaceScene::takeCameraOf(const SurfaceScene& other) {
  vtkCamera* from = other.parts_->renderer->GetActiveCamera();
  vtkCamera* to = parts_->renderer->GetActiveCamera();
  to->SetFocalPoint(from->GetFocalPoint());
  to->SetPosition(from->GetPosition());
  to->SetViewUp(from->GetViewUp());
  to->SetViewAngle(from->GetViewAngle());
  parts_->fittedOnce = parts_->fittedOnce || other.parts_->fittedOnce;
}

void SurfaceScene::keepCamera() {
  parts_->fittedAt.setConstant(std::numeric_limits<double>::quiet_NaN());
}

void SurfaceScene::setPixelRatio(double ratio) {
  parts_->pixelRatio = ratio;
  parts_->measures.setPixelRatio(ratio);
  parts_->seedActor->GetProperty()->SetPointSize(static_cast<float>(9.0 * ratio));
  parts_->marked.setPixelRatio(ratio);
  parts_->roiActor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * ratio));
}

}  // namespace angiomesh
