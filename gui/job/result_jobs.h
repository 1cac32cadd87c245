// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/parameters/parameters.h"
#include "core/pipeline/doubtful_places.h"
#include "core/pipeline/run_options.h"
#include "core/pipeline/step_results.h"
#include "core/pipeline/voxel_reason.h"

namespace angiomesh {

/// The speed p as a layer.
struct SpeedJob {
  std::shared_ptr<const VesselnessResult> vesselness;
  ThresholdParams params;
  std::string key;

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const Volume<float>> speed;
  std::string error;
};

/// What the surface will be. Without an estimate nothing is lost: meshing says what is wrong.
struct EstimateJob {
  std::shared_ptr<const Volume<float>> phi;
  SurfaceParams surface;
  PortParams ports;
  std::string key;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::optional<ExpectedSurface> expected;
};

/// The zero level set of a segmentation, quickly.
struct OutlineJob {
  std::shared_ptr<const EvolveResult> evolve;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const TriMesh> surface;  ///< null where it failed
};

/// An earlier front of an evolution, to be shown.
struct FrontJob {
  std::shared_ptr<const KeptFront> front;
  Progress progress;

  void execute() noexcept;

  // After execute(); null where it failed:
  std::shared_ptr<const Volume<float>> phi;
  std::shared_ptr<const TriMesh> surface;
};

/// Where a segmentation may be wrong.
struct DoubtJob {
  std::shared_ptr<const Volume<float>> phi;
  std::shared_ptr<const VesselnessResult> vesselness;  ///< may be null
  Thresholds thresholds;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::vector<DoubtfulPlace> places;
  std::string error;
};

/// Why a place is vessel or not.
struct ReasonJob {
  // What the segmentation was made of, and with.
  std::shared_ptr<const Volume<float>> image;
  std::shared_ptr<const VesselnessResult> vessels;
  std::shared_ptr<const EvolveResult> evolve;
  std::shared_ptr<const Volume<float>> keptPhi;  ///< of the parts that were kept; may be null
  Parameters params;
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};

  void execute() noexcept;

  // After execute():
  std::optional<VoxelReason> reason;
  std::string error;  ///< empty: there is a reason
};

}  // namespace angiomesh
