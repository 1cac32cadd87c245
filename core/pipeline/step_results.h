// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/centreline/component_measure.h"
#include "core/corrections/replay.h"
#include "core/parameters/parameters.h"
#include "core/parameters/step.h"
#include "core/pipeline/source.h"
#include "core/pipeline/surface_step.h"
#include "core/quality/mesh_quality.h"

namespace angiomesh {

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
  std::vector<Eigen::Vector3d> droppedBy;  ///< the points of segmentation.drop in it, mm LPS
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
  std::vector<CorrectionOutcome> corrections;  ///< that have been made, or left out
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
  std::shared_ptr<const EvolveResult> corrected;  ///< `evolve` itself where nothing is corrected
  std::shared_ptr<const SurfaceResult> surface;
  std::shared_ptr<const TriMesh> smoothed;
  std::vector<Port> ports;  ///< of `smoothed`, or of the surface's mesh if that is the last
  std::shared_ptr<const QualityResult> quality;
  std::vector<StageReport> stages;
  double totalSeconds = 0.0, cpuSeconds = 0.0;
  std::string key;                    ///< of the last step run
  std::optional<RunFailure> failure;  ///< with RunOptions::keepOnFailure alone

  /// As corrected or, where the run went no further, as evolved.
  [[nodiscard]] const std::shared_ptr<const EvolveResult>& segmentation() const {
    return corrected ? corrected : evolve;
  }
};

/// Whether the evolution was ended by hand, which no key tells, and not by levelset.stopAfter.
inline bool endedByHand(const EvolveResult& evolve, const Parameters& params) {
  return evolve.stopReason == StopReason::Stopped && params.levelset.stopAfter != evolve.iterations;
}

}  // namespace angiomesh
