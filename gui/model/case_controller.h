// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <QTimer>
#include <QUndoStack>
#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/parameters/field.h"
#include "gui/job/case_store.h"
#include "gui/job/file_jobs.h"
#include "gui/job/job_runner.h"
#include "gui/job/open_case_job.h"
#include "gui/job/run_job.h"

namespace angiomesh {

enum class StepState { Empty, NotNeeded, Fresh, Running, Stale, Failed };
enum class Layer { Source, Preprocessed, Vesselness, Speed };
constexpr int kLayerCount = 4;
enum class Severity { Info, Warning, Error };

/// A row of the components table.
struct ComponentRow {
  std::size_t voxels = 0;
  double volumeMm3 = 0.0;
  std::optional<ComponentMeasure> measure;  ///< of the largest alone
  bool ticked = true;
  bool byRule = false;  ///< left out by segmentation.keep or .minVolumeMm3: a tick has no say
};

/// Owns the case: source, parameters, undo stack, jobs and results. Every edit is a change of the
/// parameters, and goes through the undo stack; results are derived data, valid as long as their
/// key is. Work runs on workers and is polled at 30 Hz; nothing here blocks.
class CaseController : public QObject {
  Q_OBJECT

 public:
  /// @param recovery the folder for the edits of cases that were never saved; empty: they are not
  /// kept
  explicit CaseController(const JobRunnerFactory& makeRunner = makeThreadedJobRunner,
                          QObject* parent = nullptr, const std::filesystem::path& recovery = {});
  /// Cancels what runs and waits for it. Edits stay on the disk as after a crash: see leaveCase().
  ~CaseController() override;

  // The case.
  void open(const QString& path);
  /// Loads a volume that seriesFound() listed; `evenOut`: missing or uneven slices are resampled.
  void openSeries(const QString& path, const ImageSummary& entry, bool evenOut);
  /// Loads a label that labelsFound() listed; nothing: the file is a scan after all.
  void openLabel(const QString& path, const std::optional<Label>& label);
  void openSample();
  /// Takes a source that is at hand already.
  void take(Source source);
  [[nodiscard]] bool hasCase() const { return pipeline_ != nullptr; }
  [[nodiscard]] bool loading() const { return load_ != nullptr; }
  [[nodiscard]] double loadFraction() const { return load_ ? load_->progress().fraction() : 0.0; }
  [[nodiscard]] QString caseName() const;
  /// Source::hash; empty without a case.
  [[nodiscard]] std::string sourceHash() const;
  [[nodiscard]] std::shared_ptr<const Volume<float>> image() const;
  /// Window and level that suit a layer.
  [[nodiscard]] std::pair<double, double> windowLevel(Layer layer) const;

  // Cases on the disk.
  /// One of caseFound(), sourceMissing() and sourceDiffers() follows, or a message.
  void openCase(CaseRequest request);
  /// After sourceMissing() or sourceDiffers(): look at `path`; open its volume with the parameters
  /// of the case alone, without places; or let the case be.
  void giveSource(const QString& path);
  void takeParametersOnly();
  void giveUpCase() { pending_.reset(); }
  /// caseSaved() or caseNotSaved() follows. @param view what the window shows
  void saveCase(const QString& folder, const CaseView& view);
  /// Empty: the case was never saved.
  [[nodiscard]] QString caseFolder() const;
  /// There are edits since the last save.
  [[nodiscard]] bool modified() const { return hasCase() && !undo_.isClean(); }
  [[nodiscard]] bool saving() const { return store_.saving(); }
  /// After editsFound(): makes those edits again, each one undoable, or does away with them.
  void restoreEdits();
  void forgetEdits();
  /// A clean end: nothing is kept for a restore.
  void leaveCase();

  // Edits: each one is undoable.
  [[nodiscard]] const Parameters& parameters() const { return params_; }
  [[nodiscard]] QUndoStack* undoStack() { return &undo_; }
  /// @param continued merges with the last change of the same field, as while a slider is dragged
  void setField(const QString& key, const FieldValue& value, bool continued = false);
  /// Where a field that was empty begins when it gets a value.
  [[nodiscard]] FieldValue suggestedValue(const Field& field) const;
  /// The part of a field's range that is worth a slider in this image.
  [[nodiscard]] std::pair<double, double> sliderRange(const Field& field) const;
  void applyPreset(const QString& name);
  /// The preset that the parameters, edits aside, are equal to; empty: none.
  [[nodiscard]] QString presetName() const;
  [[nodiscard]] std::vector<Eigen::Vector3d> seeds() const;
  void addSeed(const Eigen::Vector3d& lps);
  void removeSeed(int index);
  void setRoi(const std::optional<std::array<double, 6>>& roi);
  /// `what` names the edit. @returns why not, in a line; empty: done
  QString setPorts(const PortParams& ports, const QString& what);
  QString setCuts(const std::vector<std::string>& cuts, const QString& what);
  [[nodiscard]] std::vector<ComponentRow> components() const;
  void setComponentTicked(int index, bool ticked);

  // Runs.
  void run(Step until = Step::Quality);
  void cancel();
  void setPaused(bool paused);
  void stepEvolution(int iterations = 1);
  void finishEvolution();
  [[nodiscard]] bool running() const { return run_ != nullptr; }
  [[nodiscard]] bool evolving() const;
  [[nodiscard]] bool paused() const;
  [[nodiscard]] bool busy() const {
    return run_ || load_ || export_ || speedRun_ || estimateRun_ || store_.busy();
  }

  [[nodiscard]] StepState state(Step step) const;
  /// Empty when nothing is computed.
  [[nodiscard]] std::optional<Step> stepInWork() const;
  /// Of the run, and of the step in work: 0..1.
  [[nodiscard]] double runFraction() const;
  [[nodiscard]] double stepFraction() const;
  /// Why a step failed; empty where it did not.
  [[nodiscard]] QString failure(Step step) const;
  /// Computing time of a fresh result, seconds; negative without one.
  [[nodiscard]] double seconds(Step step) const;
  [[nodiscard]] int iterations() const { return iterations_; }
  /// Last change of the evolution; negative without one.
  [[nodiscard]] double change() const;
  /// Iterations and change at the checks of the evolution shown.
  [[nodiscard]] const std::vector<std::pair<int, double>>& history() const { return history_; }

  // Results.
  /// Null while it is not there; the speed is made on demand, resultsChanged() tells when.
  [[nodiscard]] std::shared_ptr<const Volume<float>> layer(Layer layer);
  [[nodiscard]] std::shared_ptr<const VesselnessResult> vesselnessResult() const;
  [[nodiscard]] std::shared_ptr<const SeedsResult> seedsResult() const { return shown_.seeds; }
  /// phi to outline: the evolving one, else that of the kept components, else the evolution's.
  [[nodiscard]] std::shared_ptr<const Volume<float>> phi() const;
  /// What cuts are made in: phi of the kept components, else the evolution's; null before.
  [[nodiscard]] std::shared_ptr<const Volume<float>> uncutPhi() const;
  /// The openings of a mesh, in the order of its patches; none where it has no patches.
  [[nodiscard]] std::vector<Port> ports(MeshKind kind) const;
  /// The evolving surface; null when no evolution runs.
  [[nodiscard]] std::shared_ptr<const TriMesh> liveSurface() const { return liveSurface_; }
  [[nodiscard]] std::shared_ptr<const TriMesh> mesh(MeshKind kind) const;
  [[nodiscard]] const MeshQuality* quality(MeshKind kind) const;
  [[nodiscard]] std::shared_ptr<const MeshFacts> facts() const { return facts_; }
  /// Whether the mesh at hand belongs to the present parameters.
  [[nodiscard]] bool meshFresh() const;
  /// That the mesh at hand was made with; null without one.
  [[nodiscard]] const Parameters* meshParameters() const {
    return meshRun_ ? &meshRun_->params : nullptr;
  }
  /// How the mesh at hand came to be; null without one.
  [[nodiscard]] const SurfaceOrigin* surfaceOrigin() const;
  /// The number of triangles that the parameters ask for, before meshing; made on demand,
  /// resultsChanged() tells when. Empty for marching cubes and before the evolution.
  [[nodiscard]] std::optional<double> estimatedTriangles();
  /// What is to be said of the surface that the parameters ask for, before it is made.
  [[nodiscard]] QStringList expectationWarnings();
  [[nodiscard]] const RunResult& results() const { return shown_; }

  /// Writes a mesh, reads it back and says what the file holds. The pipeline's key and the names of
  /// the patches are filled in.
  void exportMesh(MeshKind kind, const QString& path, const MeshWriteOptions& options,
                  const ExportExtras& extras);
  /// A folder that OpenFOAM fills; `replace`: it holds a case already.
  void exportOpenFoam(MeshKind kind, const QString& folder, bool replace);
  /// The openings of the exported mesh alone.
  void exportPorts(const QString& path);

 Q_SIGNALS:
  void caseChanged();
  void parametersChanged();
  void resultsChanged();
  void statesChanged();    ///< of the steps, of running, loading and pausing
  void progressChanged();  ///< at most 30 times per second
  void snapshotArrived();  ///< phi() and liveSurface() moved on
  void message(angiomesh::Severity severity, const QString& text);
  void exported(const QString& path);
  /// The folder holds several volumes: openSeries() takes one.
  void seriesFound(const QString& path, const std::vector<ImageSummary>& entries);
  /// Slices are missing or uneven: openSeries() with `evenOut`, or leave it.
  void unevenFound(const QString& path, const ImageSummary& entry, const QString& reason);
  /// A segmentation with several labels: openLabel() takes one.
  void labelsFound(const QString& path, const std::vector<Label>& labels, double voxelMm3);
  void opened(const QString& path);                 ///< a file or folder was loaded
  void sourceSeen(const QString& path);             ///< where the volume of the open case lies
  void caseFound(const angiomesh::CaseView& view);  ///< a case was opened, and looked like this
  void sourceMissing(const QString& what);          ///< the case's volume, in words
  void sourceDiffers(const QString& reason);
  void editsFound(int count);  ///< since the last save of the case opened, after a crash
  void caseSaved(const QString& folder);
  void caseNotSaved();

 private:
  friend class ChangeParameters;
  struct SpeedJob;
  struct EstimateJob;
  struct Estimate {
    std::shared_ptr<const Volume<float>> phi;  ///< null: nothing to estimate
    std::string key;
  };

  void say(Severity severity, const QString& text);
  void startLoad(std::shared_ptr<LoadJob> job);
  void finishLoad();
  void takeLoaded(const LoadJob& job);
  void sayOpened(const InputInfo& info);
  void sayLabel(const Label& label);
  void finishCase(const std::shared_ptr<const OpenCaseJob>& job);
  void noteEdit();
  void cacheEvolve();
  void pollStore();
  void keepPolling();
  [[nodiscard]] CaseSource describeSource() const;
  void replaceParameters(const Parameters& params);
  void change(const Parameters& after, const QString& text, const QString& mergeKey = {},
              bool continued = false);
  void startRun(Step until);
  void fail(Step step, const Parameters& params, const std::string& reason);
  void interruptRun();
  void refreshFromCache();
  void finishRun();
  [[nodiscard]] ExportRequest exportRequest(MeshKind kind, const QString& path) const;
  /// Where it meets itself a surface is exported all the same: the user sees it, and may repair it
  /// elsewhere.
  void warnIfUnsound(MeshKind kind);
  void startExport(ExportRequest request);
  void finishExport();
  void sayExported(const ExportJob& job);
  void accept(const StepResult& result);
  void poll();
  void pollRun();
  void requestSpeed();
  void finishSpeed();
  [[nodiscard]] std::string speedKey() const;
  [[nodiscard]] Estimate estimateWanted() const;
  [[nodiscard]] std::optional<ExpectedSurface> expectedSurface();
  void requestEstimate(const Estimate& wanted);
  void finishEstimate();
  void cancelEstimate();
  void clearResults();
  [[nodiscard]] std::vector<std::size_t> dropsIn(const SegmentComponent& component,
                                                 const Parameters& params) const;

  QUndoStack undo_;
  QTimer timer_;
  std::unique_ptr<JobRunner> runRunner_, loadRunner_, exportRunner_, speedRunner_, estimateRunner_;

  Parameters params_;
  std::shared_ptr<Pipeline> pipeline_;
  QString name_;
  double window_ = 1.0, level_ = 0.5;

  CaseStore store_;
  InputInfo info_;  ///< of the source
  std::vector<JournalStep> foundSteps_;
  bool restoring_ = false;                      ///< edits come from the journal
  bool noteFailed_ = false;                     ///< and the user knows
  std::shared_ptr<const OpenCaseJob> pending_;  ///< without a source so far

  std::shared_ptr<LoadJob> load_;
  std::shared_ptr<LoadJob> nextLoad_;
  std::shared_ptr<ExportJob> export_;
  std::shared_ptr<RunJob> run_;
  bool quietRun_ = false;               ///< a look into the cache, not worth a line in the log
  std::optional<Step> polledStep_;      ///< of the run, when last looked at
  std::optional<Step> interruptAfter_;  ///< this step the run is of no more use
  std::optional<Step> runAgain_;        ///< once the present run has ended
  std::shared_ptr<SpeedJob> speedRun_;
  std::shared_ptr<EstimateJob> estimateRun_;

  RunResult shown_;
  std::array<std::string, kStepCount> keys_;  ///< of the results shown
  std::shared_ptr<const RunResult> meshRun_;  ///< the run that the meshes shown come from
  std::shared_ptr<const MeshFacts> facts_;
  std::shared_ptr<const Volume<float>> speed_;
  std::string speedKey_;
  std::vector<std::string> saidBefore_;  ///< warnings that came before the step's result
  std::optional<ExpectedSurface> estimate_;
  std::string estimateKey_;
  std::weak_ptr<const Volume<float>> estimatePhi_;
  std::shared_ptr<const Volume<float>> livePhi_;
  std::shared_ptr<const TriMesh> liveSurface_;
  std::string failedKey_;
  Step failedStep_ = Step::Load;
  QString failedText_;
  int iterations_ = 0;
  double change_ = -1.0;
  std::vector<std::pair<int, double>> history_;
};

}  // namespace angiomesh
