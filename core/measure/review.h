// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace angiomesh {

enum class Verdict { None, Accepted, Rejected };

/// Why a place of a segmentation deserves a look. Hole: a handle smaller than voxels tell. Neck:
/// the vessel is much thinner than on either side. Missed: high vesselness outside. Island: a small
/// part that hangs on nothing.
enum class DoubtKind { Hole, Neck, Missed, Island };
constexpr int kDoubtKinds = 4;

/// "accepted", "neck", ..., as files have them, and back. The verdict None is "none".
const char* verdictWord(Verdict verdict);
std::optional<Verdict> verdictOf(const std::string& word);
const char* doubtWord(DoubtKind kind);
std::optional<DoubtKind> doubtKindOf(const std::string& word);

/// From 1, worst, to 5, best, as the thesis's radiologist gave them; 0: none was given.
constexpr int kBestScore = 5;

/// What is to be said of the vessel at a place.
struct ReviewRemark {
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< mm
  int score = 0;                            ///< of the branch there
  std::string text;

  bool operator==(const ReviewRemark&) const = default;
};

/// A doubtful place that somebody has looked at.
struct SeenPlace {
  DoubtKind kind = DoubtKind::Hole;
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< mm

  bool operator==(const SeenPlace&) const = default;
};

/// What a reader made of a segmentation.
struct CaseReview {
  Verdict verdict = Verdict::None;
  int score = 0;    ///< of the whole
  std::string key;  ///< of the step evolve whose result verdict and score are of; empty: neither
  std::vector<ReviewRemark> remarks;
  std::vector<SeenPlace> seen;

  [[nodiscard]] bool empty() const { return *this == CaseReview(); }
  bool operator==(const CaseReview&) const = default;
};

}  // namespace angiomesh
