// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/component_measure.h"
#include "core/parameters/parameters.h"
#include "core/pipeline/surface_step.h"
#include "core/quality/mesh_quality.h"

namespace angiomesh {

enum class Step { Load, Preprocess, Vesselness, Seeds, Evolve, Surface, Smooth, Quality };
constexpr int kStepCount = 8;

/// "load", "preprocess", ... as in report.json and --until.
const char* stepId(Step step);
std::optional<Step> stepFromId(std::string_view id);

/// The image that a pipeline starts from. Loaders make it; `hash` is contentHash(image).
struct Source {
  std::shared_ptr<const Volume<float>> image;
  std::string hash;
  std::string name;  ///< shown to the user and used for folder names; never a patient's
};
std::string contentHash(const Volume<float>& image);
Source makeSource(Volume<float> image, const std::string& name);

struct VesselnessResult {
  std::shared_ptr<const Volume<float>> multiScale;  ///< v, largest magnitude over the scales
  std::vector<double> scalesMm;
  double c = 0.0;
};

struct SeedsResult {
  std::vector<Eigen::Vector3d> pointsLps;
};

/// A connected part of the segmentation (26-connected voxels with phi < 0), largest first.
struct SegmentComponent {
  std::size_t voxels = 0;
  double volumeMm3 = 0.0;
  Eigen::Vector3d innerPointLps;  ///< the centre of one of its voxels, for segmentation.drop
  /// See measureComponents(); of the largest kMeasuredComponents alone.
  std::optional<ComponentMeasure> measure;
  bool seeded = false;  ///< holds a seed given by hand, or lies beside one
  bool kept = true;
};
constexpr std::size_t kMeasuredComponents = 200;

/// What came of a label, see MaskDistance.
struct LabelFacts {
  std::size_t voxels = 0;
  double largestShiftVoxels = 0.0, maskVolumeMm3 = 0.0;
  MaskContacts contacts = {};
};

/// What came of making the wall smooth, see SmoothWall.
struct WallFacts {
  double spreadVoxels = 0.0;
  std::size_t heldVoxels = 0;
  std::size_t filledHoles = 0, cutHandles = 0;  ///< that the wall's uncertainty explains
};

struct EvolveResult {
  std::shared_ptr<const Volume<float>> phi;  ///< redistanced, mm, clamped at +-5 working voxels
  /// The same before the wall was made smooth, where its sign is the segmentation voxel by voxel
  /// (see placeWall()); else empty.
  std::shared_ptr<const Volume<float>> voxelwise;
  Thresholds thresholds;               ///< of the level set method alone
  std::optional<double> lower, upper;  ///< intensities, of the methods that go by them
  std::optional<LabelFacts> label;     ///< of the method label alone
  std::optional<WallFacts> wall;       ///< where the wall was made smooth
  int iterations = 0;
  bool converged = false;
  StopReason stopReason = StopReason::Running;
};

struct SurfaceResult {
  std::shared_ptr<const Volume<float>> phi;  ///< of the kept components only, ended by the cuts
  /// The same without cuts, which the mesher follows and meshes are measured against: phi ends at a
  /// cut in an edge, which no interpolant can follow.
  std::shared_ptr<const Volume<float>> uncutPhi;
  std::vector<SegmentComponent> components;
  std::size_t insideVoxels = 0;                  ///< of phi: cuts may have taken some
  std::shared_ptr<const TriMesh> mesh;           ///< unsmoothed
  SurfaceOrigin origin;                          ///< of `mesh`
  std::vector<Port> ports;                       ///< of `mesh`: its patches
  std::vector<double> sectionAreasMm2;           ///< of phi, of the first ports: the cuts
  std::shared_ptr<const TriMesh> marchingCubes;  ///< VTK's on the same phi, for comparison
};

struct QualityResult {
  MeshQuality mesh, unsmoothed, marchingCubes;
};

struct StageReport {
  Step step = Step::Load;
  std::string key;
  double seconds = 0.0, cpuSeconds = 0.0;  ///< of the computation, also when reused
  bool reused = false;
  std::vector<std::string> warnings;
};

/// Why a run ended early.
struct RunFailure {
  Step step = Step::Load;
  std::string why;  ///< as Error::what()
};

/// What a run produced; pointers are empty for steps after `until` (see also
/// RunOptions::keepResults), and those of vesselness and seeds where the image is a segmentation.
/// Everything is immutable and shared.
struct RunResult {
  Parameters params;
  Source source;
  std::shared_ptr<const Volume<float>> preprocessed;
  std::shared_ptr<const VesselnessResult> vesselness;
  std::shared_ptr<const SeedsResult> seeds;
  std::shared_ptr<const EvolveResult> evolve;
  std::shared_ptr<const SurfaceResult> surface;
  std::shared_ptr<const TriMesh> smoothed;
  std::vector<Port> ports;  ///< of `smoothed`, or of the surface's mesh if that is the last
  std::shared_ptr<const QualityResult> quality;
  std::vector<StageReport> stages;
  double totalSeconds = 0.0, cpuSeconds = 0.0;
  std::string key;                    ///< of the last step run
  std::optional<RunFailure> failure;  ///< with RunOptions::keepOnFailure alone
};

/// The zero level set while it evolves.
struct EvolutionSnapshot {
  int iterations = 0;
  double change = -1.0;
  std::shared_ptr<const Volume<float>> phi;  ///< sparse-field phi, working voxels
  std::shared_ptr<const TriMesh> surface;    ///< its zero set
};

/// A one-place mailbox: a newer value replaces one that was not taken.
template <class T>
class Mailbox {
 public:
  void post(std::shared_ptr<const T> value) {
    const std::lock_guard lock(mutex_);
    value_ = std::move(value);
  }
  std::shared_ptr<const T> take() {
    const std::lock_guard lock(mutex_);
    return std::move(value_);
  }

 private:
  std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

/// Lets a watcher of the evolution pause, single-step and end it. All members may be set from any
/// thread.
struct EvolutionControl {
  std::atomic<bool> paused{false};
  std::atomic<int> stepsWanted{0};     ///< while paused: run so many iterations, then pause again
  std::atomic<bool> finishNow{false};  ///< take the surface as it stands (stop_reason "stopped")
};

struct RunOptions {
  Step until = Step::Quality;
  std::shared_ptr<Mailbox<EvolutionSnapshot>> snapshots;  ///< empty: none are made
  double snapshotSeconds = 0.2;                           ///< least time between two
  std::shared_ptr<EvolutionControl> control;
  /// Else the pipeline remembers no step's result, and that of the vesselness, which nothing after
  /// the evolution needs, is empty if the run goes so far.
  bool keepResults = true;
  /// A failure of the step surface or a later one is not thrown: it is in the result, with all that
  /// was computed before.
  bool keepOnFailure = false;
  /// Called from within run() with each warning that tells beforehand what a step will cost.
  std::function<void(Step step, const std::string& warning)> warned;
};

/// Runs the steps on one source and keeps their results by key: a step whose key is known is not
/// computed again. One run at a time; key() and run() may be called from different threads.
class Pipeline {
 public:
  explicit Pipeline(Source source);
  ~Pipeline();

  /// @throws InputError, NumericError, Cancelled; see RunOptions::keepOnFailure
  RunResult run(const Parameters& params, const RunOptions& options = {},
                const Progress& progress = {});

  /// The key that `step` has with these parameters: a hash of its id, version, parameters and
  /// inputs.
  [[nodiscard]] std::string key(Step step, const Parameters& params) const;

  /// Whether the step's result with these parameters is at hand.
  [[nodiscard]] bool has(Step step, const Parameters& params) const;

  /// Takes a result that an earlier pipeline computed from the same source and parameters. What
  /// the evolution alone needs, vesselness and seeds, is then not computed for a run beyond it, and
  /// empty in its result. False, and nothing is taken, unless `report.key` is the step's key.
  bool restore(std::shared_ptr<const EvolveResult> evolve, const StageReport& report,
               const Parameters& params);

  [[nodiscard]] const Source& source() const;

 private:
  /// The steps after the evolution, as far as they are wanted.
  void makeSurfaces(RunResult& run, const RunOptions& options,
                    const std::function<bool(Step)>& wanted, const Progress& progress);

  struct State;
  std::unique_ptr<State> state_;
};

/// a and b as the evolve step takes them.
Thresholds thresholdsFor(const VesselnessResult& vessels, const LevelSetParams& params);

/// p of eq. 3.21 at each voxel of the vesselness.
Volume<float> speedVolume(const Volume<float>& vesselness, const Thresholds& thresholds);

}  // namespace angiomesh
