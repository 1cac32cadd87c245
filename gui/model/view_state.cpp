// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/view_state.h"

#include <Eigen/LU>
#include <QSettings>
#include <algorithm>
#include <cstddef>
#include <string>

#include "gui/model/modality_habits.h"

namespace angiomesh {

namespace {

/// The words of a case file; new ones may join, none may change.
constexpr std::array<const char*, kLayerCount> kLayers{"source", "preprocessed", "vesselness",
                                                       "speed"};
constexpr std::array<const char*, 3> kPlanes{"sagittal", "coronal", "axial"};
constexpr std::array<const char*, kSlabModeCount> kSlabs{"none", "mip", "minip", "mean"};
constexpr std::array<const char*, kRunMeshCount> kMeshes{"exported", "unsmoothed",
                                                         "marching-cubes"};
/// At most one of them is true in a case file.
constexpr std::array<std::pair<VolumeView, const char*>, 3> kVolumeViews{
    {{VolumeView::Mip, "mip"},
     {VolumeView::MrAngio, "volume-mr"},
     {VolumeView::CtAngio, "volume-ct"}}};
/// Without colours; else the key of the measure.
constexpr const char* kPlain = "plain";

constexpr const char* kInterpolated = "view/interpolated";  // of the settings

using Rows = Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;
using ConstRows = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>;

/// `value` stays where the word is unknown.
template <class T, std::size_t N>
void fromWord(T& value, const std::string& word, const std::array<const char*, N>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found != words.end()) value = static_cast<T>(found - words.begin());
}

template <class T, std::size_t N>
std::string wordOf(T value, const std::array<const char*, N>& words) {
  return words[static_cast<std::size_t>(value)];
}

CasePlanes planesOf(const PlaneTurn& turn) {
  CasePlanes planes;
  planes.patientAxes = turn.patientAxes;
  for (std::size_t i = 0; i < kPlanes.size(); ++i) {
    if (!turn.turned(static_cast<int>(i))) continue;
    Rows(planes.turns[kPlanes[i]].data()) = turn.turns[i];
  }
  Eigen::Map<Eigen::Vector3d>(planes.pivotMm.data()) = turn.pivotLps;
  return planes;
}

/// What is no rotation turns nothing.
PlaneTurn turnFrom(const CasePlanes& planes) {
  PlaneTurn turn;
  turn.patientAxes = planes.patientAxes;
  for (std::size_t i = 0; i < kPlanes.size(); ++i) {
    const auto found = planes.turns.find(kPlanes[i]);
    if (found == planes.turns.end()) continue;
    const Eigen::Matrix3d rotation = ConstRows(found->second.data());
    if (rotation.isUnitary(1e-6) && rotation.determinant() > 0.0) turn.turns[i] = rotation;
  }
  turn.pivotLps = Eigen::Map<const Eigen::Vector3d>(planes.pivotMm.data());
  return turn;
}

}  // namespace

ViewState::ViewState(CaseModels& models, QObject* parent) : QObject(parent), models_(models) {
  const auto reset = [this] {
    layer_ = Layer::Source;
    awaitedLayer_.reset();
    tool_ = Tool::Navigate;
    turn_ = {};
    for (int i = 0; i < kLayerCount; ++i)
      windowLevels_[static_cast<std::size_t>(i)] =
          models_.results.windowLevel(static_cast<Layer>(i));
    if (models_.document.hasCase())
      if (const auto habit = windowFor(models_.document.display())) windowLevels_.front() = *habit;
    Q_EMIT changed();
  };
  reset();
  interpolated_ = QSettings().value(kInterpolated, true).toBool();
  connect(&models_.files, &CaseFiles::caseChanged, this, reset);
  connect(&models_.results, &ResultModel::resultsChanged, this, &ViewState::showAwaitedLayer);
}

void ViewState::setLayer(Layer layer) {
  awaitedLayer_.reset();
  set(layer_, layer);
}

void ViewState::showAwaitedLayer() {
  if (!awaitedLayer_) return;
  const Layer madeFrom = *awaitedLayer_ == Layer::Speed ? Layer::Vesselness : *awaitedLayer_;
  if (models_.results.layer(madeFrom)) setLayer(*awaitedLayer_);
}

CaseView ViewState::caseView() const {
  CaseView view;
  view.layer = wordOf(awaitedLayer_.value_or(layer_), kLayers);
  for (std::size_t i = 0; i < kLayers.size(); ++i)
    view.windowLevels[kLayers[i]] = {windowLevels_[i].first, windowLevels_[i].second};
  for (std::size_t i = 0; i < kPlanes.size(); ++i)
    view.slabs[kPlanes[i]] = {wordOf(slabs_[i].mode, kSlabs), slabs_[i].thicknessMm};
  if (overlay_) view.overlay = wordOf(*overlay_, kLayers);
  view.overlayOpacity = overlayOpacity_;
  if (turn_ != PlaneTurn()) view.planes = planesOf(turn_);
  view.shown = {{"contours", contours_},
                {"surface", surface_},
                {"edges", edges_},
                {"comparison", comparison_},
                {"interpolated", interpolated_},
                {"result-beside", resultBeside_},
                {"linked", linked_},
                {"slices3d", slices3d_}};
  for (const auto& [shown, word] : kVolumeViews) view.shown[word] = volumeView_ == shown;
  view.mesh = wordOf(meshKind_ == MeshKind::File ? MeshKind::Exported : meshKind_, kMeshes);
  view.colour = meshColour_ ? meshColour_->key : kPlain;
  return view;
}

void ViewState::take(const CaseView& view) {
  Layer layer = Layer::Source;
  fromWord(layer, view.layer, kLayers);
  awaitedLayer_ = layer;
  for (std::size_t i = 0; i < kLayers.size(); ++i) {
    const auto found = view.windowLevels.find(kLayers[i]);
    if (found != view.windowLevels.end() && found->second[0] > 0.0)
      windowLevels_[i] =
          limitsOf(static_cast<Layer>(i)).bounded({found->second[0], found->second[1]});
  }
  for (std::size_t i = 0; i < kPlanes.size(); ++i) {
    const auto found = view.slabs.find(kPlanes[i]);
    if (found == view.slabs.end()) continue;
    fromWord(slabs_[i].mode, found->second.mode, kSlabs);
    if (found->second.thicknessMm > 0.0) slabs_[i].thicknessMm = found->second.thicknessMm;
  }
  Layer over = Layer::Source;
  fromWord(over, view.overlay, kLayers);
  if (over == Layer::Vesselness || over == Layer::Speed) overlay_ = over;
  overlayOpacity_ = std::clamp(view.overlayOpacity, 0.0, 1.0);
  if (view.planes) turn_ = turnFrom(*view.planes);
  const auto takeShown = [&view](bool& member, const char* name) {
    const auto found = view.shown.find(name);
    member = found != view.shown.end() ? found->second : member;
  };
  takeShown(contours_, "contours");
  for (const auto& [shown, word] : kVolumeViews) {
    bool on = volumeView_ == shown;
    takeShown(on, word);
    if (on)
      volumeView_ = shown;
    else if (volumeView_ == shown)
      volumeView_ = VolumeView::None;
  }
  takeShown(surface_, "surface");
  takeShown(edges_, "edges");
  takeShown(interpolated_, "interpolated");
  takeShown(comparison_, "comparison");
  takeShown(resultBeside_, "result-beside");
  if (comparison_) resultBeside_ = false;
  takeShown(linked_, "linked");
  takeShown(slices3d_, "slices3d");
  fromWord(meshKind_, view.mesh, kMeshes);
  if (view.colour == kPlain) meshColour_ = nullptr;
  for (const TriangleMeasure& measure : triangleMeasures())
    if (view.colour == measure.key) meshColour_ = &measure;
  Q_EMIT changed();
  showAwaitedLayer();
}

WindowLevel ViewState::windowLevel() const {
  return windowLevels_[static_cast<std::size_t>(layer_)];
}

WindowLimits ViewState::limitsOf(Layer layer) const {
  if (layer == Layer::Vesselness) return {0.0, 1.0, 1.0};
  if (layer == Layer::Speed) return {-1.0, 1.0, 2.0};
  return imageLimits(models_.document.display());
}

void ViewState::showWindow(const WindowLevel& window) {
  set(windowLevels_[static_cast<std::size_t>(layer_)], windowLimits().bounded(window));
}

void ViewState::setWindowLevel(double window, double level) {
  showWindow({window, level});
  if (layer_ == Layer::Source) rememberWindow(models_.document.display().modality, windowLevel());
}

void ViewState::resetWindowLevel() {
  showWindow(models_.results.windowLevel(layer_));
  if (layer_ == Layer::Source) forgetWindow(models_.document.display().modality);
}

std::optional<WindowLevel> ViewState::presetWindow(WindowPreset preset) const {
  // The preprocessed layer has the source's values, the others have none of a scan.
  if (!models_.document.hasCase() || (layer_ != Layer::Source && layer_ != Layer::Preprocessed))
    return std::nullopt;
  return angiomesh::presetWindow(preset, models_.document.display());
}

std::vector<std::pair<WindowLevel, std::string>> ViewState::otherFileWindows() const {
  if (!models_.document.hasCase() || (layer_ != Layer::Source && layer_ != Layer::Preprocessed))
    return {};
  return models_.document.display().otherFileWindows;
}

void ViewState::setPresetWindow(WindowPreset preset) {
  const std::optional<WindowLevel> window = presetWindow(preset);
  if (!window) return;
  setWindowLevel(window->first, window->second);
  if (layer_ == Layer::Source) rememberWindow(models_.document.display().modality, preset);
}

bool ViewState::suitsCt() const {
  return models_.document.hasCase() &&
         angiomesh::presetWindow(WindowPreset::Cta, models_.document.display()).has_value();
}

VolumeView ViewState::volumeShown() const {
  const bool scan = layer_ == Layer::Source || layer_ == Layer::Preprocessed;
  if (volumeView_ == VolumeView::CtAngio && !(scan && suitsCt())) return VolumeView::MrAngio;
  return volumeView_;
}

void ViewState::setResultBeside(bool on) {
  if (on == resultBeside_) return;
  resultBeside_ = on;
  if (on) {
    comparison_ = false;
    volumeView_ = VolumeView::Mip;
  }
  surface_ = !on;
  Q_EMIT changed();
}

void ViewState::setComparison(bool on) {
  if (on == comparison_) return;
  comparison_ = on;
  if (on && resultBeside_) {
    resultBeside_ = false;
    surface_ = true;
  }
  Q_EMIT changed();
}

void ViewState::setPatientAxes(bool on) {
  PlaneTurn turn;
  turn.patientAxes = on;
  setTurn(turn);
}

std::array<double, 2> ViewState::overlayRange() const {
  if (!overlay_) return {0.0, 1.0};
  const auto [window, level] = windowLevels_[static_cast<std::size_t>(*overlay_)];
  return {level - 0.5 * window, level + 0.5 * window};
}

void ViewState::setInterpolated(bool on) {
  QSettings().setValue(kInterpolated, on);
  set(interpolated_, on);
}

}  // namespace angiomesh
