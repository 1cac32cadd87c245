// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/cuts/cuts.h"

namespace angiomesh {

/// What cuts are made in. The parts after phi are made by the first job that needs them.
struct PortGround {
  std::shared_ptr<const Volume<float>> phi;  ///< without cuts, mm; null: nothing is there yet
  SplineKind spline = SplineKind::InterpolatingBspline;
  std::shared_ptr<const SplineField> field;
  std::shared_ptr<const Skeleton> skeleton;
};

/// What is known of a cut.
struct CutFinding {
  std::optional<CutPlane> plane;      ///< at the centre of the section, where there is one
  double radiusMm = 0.0;              ///< from there to the farthest of the wall
  double areaMm2 = 0.0;               ///< 0: no section
  std::string error;                  ///< why it cannot be made; empty: it can
  std::vector<std::string> advice;    ///< sentences whose subject is the cut
  bool advised = false;               ///< advice and path are there
  std::vector<Eigen::Vector3d> path;  ///< the centre line through it
};

/// One look at the vessels for cuts: execute() on the worker, the results after it.
struct PortJob {
  /// Check: findings without advice. Advise: with it, which takes the skeleton.
  enum class Kind { Check, Advise, CutHere, CutEnds, CutAllAcross };

  Kind kind = Kind::Check;
  PortGround ground;
  std::vector<std::string> cuts;            ///< as parseCut() takes them
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< of CutHere, mm
  double radiiFromTip = 0.0;                ///< of CutEnds
  Progress progress;

  void execute() noexcept;

  // After execute():
  bool cancelled = false;
  std::string error;                 ///< of all but Check and Advise
  std::vector<CutFinding> findings;  ///< of the cuts, in their order
  std::vector<CutPlane> proposed;    ///< of CutHere one
  std::vector<std::string> names;    ///< of CutEnds and CutAllAcross
  std::vector<std::string> remarks;  ///< of these: what is not cut, and why

 private:
  void prepare(bool withSkeleton);
  /// The cuts that can be made, by their numbers, and what they take.
  struct Made {
    std::vector<std::size_t> cuts;
    CutAway away;
  };
  Made check();
  Made together(const std::vector<std::size_t>& possible, const std::vector<CutPlane>& planes);
  void advise(const Made& made);
  void cutHere();
  void cutAllAcross(CutAway away);
};

/// An error's text for a list of ports: without the names of parameters.
std::string portWords(std::string message);

}  // namespace angiomesh
