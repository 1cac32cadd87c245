// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QStringList>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gui/job/job_slot.h"
#include "gui/job/result_jobs.h"
#include "gui/job/run_job.h"
#include "gui/model/case_document.h"
#include "gui/model/result_names.h"

namespace angiomesh {

enum class Layer { Source, Preprocessed, Vesselness, Speed };
constexpr int kLayerCount = 4;

/// A row of the components table.
struct ComponentRow {
  std::size_t voxels = 0;
  double volumeMm3 = 0.0;
  std::optional<ComponentMeasure> measure;  ///< of the largest only
  bool ticked = true;
  bool byRule = false;  ///< left out by a rule of segmentation.*: a tick has no say
};

/// The results that are shown: of each step the last one that came, whatever came of later steps.
/// They are derived data, and belong to the present parameters as long as their key does.
class ResultModel : public QObject {
  Q_OBJECT

 public:
  ResultModel(CaseDocument& document, MessageLog& log, JobTimer& timer,
              const JobRunnerFactory& makeRunner, QObject* parent = nullptr);
  ~ResultModel() override;

  void clear();
  void accept(const StepResult& result);
  /// The evolving level set; null pointers end it. @returns whether something was shown
  bool setLive(std::shared_ptr<const Volume<float>> phi, std::shared_ptr<const TriMesh> surface);

  /// Of the result shown; empty: there is none.
  [[nodiscard]] const std::string& key(Step step) const {
    return keys_[static_cast<std::size_t>(step)];
  }
  /// Whether the result shown is that of the present parameters.
  [[nodiscard]] bool fresh(Step step) const;
  /// Whether a layer is that of the present parameters.
  [[nodiscard]] bool layerFresh(Layer layer) const;
  /// "2": the second segmentation of the case; "2.1": its first correction; empty without one.
  [[nodiscard]] QString segmentationName() const;
  /// "2b": the second mesh of that segmentation; empty without one.
  [[nodiscard]] QString meshName() const { return meshRun_ ? meshName_ : QString(); }
  /// Whether the meshes are of the segmentation shown, and not of an earlier one.
  [[nodiscard]] bool meshFits() const { return meshRun_ && meshOf_ == segmentation_; }
  /// Computing time of a fresh result, seconds; negative without one.
  [[nodiscard]] double seconds(Step step) const;
  [[nodiscard]] const StageReport& report(Step step) const {
    return reports_[static_cast<std::size_t>(step)];
  }

  // The grid.
  /// Null while it is not there; the speed is made on demand, resultsChanged() tells when.
  [[nodiscard]] std::shared_ptr<const Volume<float>> layer(Layer layer);
  /// Window and level that suit a layer.
  [[nodiscard]] WindowLevel windowLevel(Layer layer) const;
  [[nodiscard]] std::shared_ptr<const VesselnessResult> vesselnessResult() const {
    return shown_.vesselness;
  }
  [[nodiscard]] std::shared_ptr<const SeedsResult> seedsResult() const { return shown_.seeds; }
  [[nodiscard]] std::shared_ptr<const EvolveResult> evolveResult() const { return shown_.evolve; }
  /// The segmentation shown: as corrected, or as evolved where that is yet to come.
  [[nodiscard]] const std::shared_ptr<const EvolveResult>& segmentation() const {
    return shown_.segmentation();
  }
  /// What the mask of the segmentation shown is made of, see segmentationMask(): parts and cuts are
  /// those of its mesh or, as long as it has none, those that are ticked. Null without one.
  [[nodiscard]] std::shared_ptr<const RunResult> segmentationRun() const;
  /// Whether that mask is that of the present parameters.
  [[nodiscard]] bool segmentationFresh() const {
    return fresh(meshFits() ? Step::Surface : Step::Correct);
  }
  /// Shows an earlier front of the evolution in place of the evolving one or of the result, from
  /// the moment it is made on; null: no longer.
  void showFront(std::shared_ptr<const KeptFront> front);
  /// The earlier front that is asked for; null: none.
  [[nodiscard]] const std::shared_ptr<const KeptFront>& wantedFront() const { return wanted_; }
  /// Iterations of the earlier front shown; empty: none is.
  [[nodiscard]] std::optional<int> frontShown() const {
    return front_.phi ? std::optional(front_.iterations) : std::nullopt;
  }
  /// Whether an evolution is shown as it goes on.
  [[nodiscard]] bool live() const { return livePhi_ != nullptr; }
  /// phi to outline: an earlier one, or the evolving one, else that of the kept components, else
  /// the segmentation's.
  [[nodiscard]] std::shared_ptr<const Volume<float>> phi() const;
  /// What cuts are made in: phi of the kept components, else the segmentation's; null before.
  [[nodiscard]] std::shared_ptr<const Volume<float>> uncutPhi() const;
  /// What a ReasonJob needs beside a place; null where the segmentation shown is not of the level
  /// set method, or what it was made of is not at hand.
  [[nodiscard]] std::shared_ptr<ReasonJob> groundsOfSegmentation() const;
  [[nodiscard]] std::vector<ComponentRow> components() const;
  void setComponentTicked(int index, bool ticked);
  /// Ticks all others off, and that one on.
  void keepOnlyComponent(int index);
  [[nodiscard]] std::vector<Eigen::Vector3d> innerPoints() const;  ///< of components()

  // The meshes.
  /// The surface of an earlier front or of the evolving one; null where neither is shown.
  [[nodiscard]] std::shared_ptr<const TriMesh> liveSurface() const {
    return front_.phi ? front_.surface : liveSurface_;
  }
  [[nodiscard]] std::shared_ptr<const TriMesh> mesh(MeshKind kind) const;
  /// The zero level set of the segmentation shown, by marching cubes, for as long as it has no
  /// mesh; made on demand, resultsChanged() tells when.
  [[nodiscard]] std::shared_ptr<const TriMesh> outline();
  /// Mesh of the kind, or the unsmoothed one where there is none that is smoothed yet.
  [[nodiscard]] MeshKind kindAtHand(MeshKind wanted) const;
  /// The openings of a mesh, in the order of its patches; none where it has no patches.
  [[nodiscard]] std::vector<Port> ports(MeshKind kind) const;
  [[nodiscard]] const MeshQuality* quality(MeshKind kind) const;
  /// A mesh to be compared with, which no step made; null: none. Its measures may come later.
  void setFileMesh(std::shared_ptr<const TriMesh> mesh, std::shared_ptr<const MeshQuality> quality);
  /// Whether the exported mesh belongs to the present parameters.
  [[nodiscard]] bool meshFresh() const { return fresh(Step::Smooth); }
  /// The run that the meshes come from; null without one.
  [[nodiscard]] std::shared_ptr<const RunResult> meshRun() const { return meshRun_; }
  /// That the mesh at hand was made with; null without one.
  [[nodiscard]] const Parameters* meshParameters() const {
    return meshRun_ ? &meshRun_->params : nullptr;
  }
  /// How the mesh at hand came to be; null without one.
  [[nodiscard]] const SurfaceOrigin* surfaceOrigin() const;

  // Before it is made.
  /// The number of triangles that the parameters ask for, before meshing; made on demand,
  /// resultsChanged() tells when. Empty for marching cubes and before the evolution.
  [[nodiscard]] std::optional<double> estimatedTriangles();
  /// What is to be said of the surface that the parameters ask for, before it is made.
  [[nodiscard]] QStringList expectationWarnings();
  void cancelEstimate();
  /// Whether a speed, an estimate or an outline is being made.
  [[nodiscard]] bool asking() const {
    return speedSlot_ || estimateSlot_ || outlineSlot_ || frontSlot_;
  }
  /// While a run is on nothing is estimated: its surface step will tell.
  void setRunning(bool running) { running_ = running; }
  /// What a form needs beside a field and the parameters.
  [[nodiscard]] FieldContext fieldContext() const;

 Q_SIGNALS:
  void resultsChanged();

 private:
  void finishSpeed(const SpeedJob& job);
  void finishEstimate(const EstimateJob& job);
  void finishOutline(const OutlineJob& job);
  void finishFront(const FrontJob& job);
  void makeFront();
  [[nodiscard]] std::optional<ExpectedSurface> expectedSurface();
  [[nodiscard]] static std::vector<std::size_t> dropsIn(const SegmentComponent& component,
                                                        const Parameters& params);

  CaseDocument& document_;
  MessageLog& log_;
  RunResult shown_;
  std::array<std::string, kStepCount> keys_;
  std::array<StageReport, kStepCount> reports_;
  std::shared_ptr<const RunResult> meshRun_;
  Parameters evolveParams_;  ///< that the segmentation shown was made with
  ResultNames names_;
  int segmentation_ = 0;  ///< number of the segmentation shown; 0: there is none
  int ofEvolution_ = 0;   ///< of the one that it is a correction of, or its own
  std::shared_ptr<const TriMesh> fileMesh_;
  std::shared_ptr<const MeshQuality> fileQuality_;
  int meshOf_ = 0;  ///< of the one that meshRun_ is of
  QString meshName_;
  std::shared_ptr<const Volume<float>> livePhi_;
  std::shared_ptr<const TriMesh> liveSurface_;
  std::shared_ptr<const Volume<float>> speed_;
  std::string speedKey_;
  std::optional<ExpectedSurface> estimate_;
  std::string estimateKey_;
  std::weak_ptr<const Volume<float>> estimatePhi_;
  bool running_ = false;
  bool quiet_ = false;  ///< somebody waits for the answer, and needs no signal
  JobSlot<SpeedJob> speedSlot_;
  JobSlot<EstimateJob> estimateSlot_;
  std::shared_ptr<const TriMesh> outline_;
  std::shared_ptr<const EvolveResult> outlined_;  ///< what outline_ is of
  JobSlot<OutlineJob> outlineSlot_;
  struct ShownFront {
    int iterations = 0;
    std::shared_ptr<const Volume<float>> phi;
    std::shared_ptr<const TriMesh> surface;
  };
  ShownFront front_;
  std::shared_ptr<const KeptFront> wanted_;
  JobSlot<FrontJob> frontSlot_;
};

}  // namespace angiomesh
