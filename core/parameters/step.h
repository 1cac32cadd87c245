// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace angiomesh {

enum class Step { Load, Preprocess, Vesselness, Seeds, Evolve, Correct, Surface, Smooth, Quality };
constexpr int kStepCount = 9;

/// What is known of a step without its function, which the pipeline has.
struct StepFacts {
  const char* id;     ///< as in report.json and --until
  const char* title;  ///< to be translated
  int version;        ///< raised whenever the step computes something else from the same inputs
  double begins;      ///< about which share of a run's time has passed
  bool ofScans;       ///< nothing is to be done where the image is a segmentation
  /// The evolution alone needs its result: with that at hand it is not computed.
  bool feedsEvolution;
};

constexpr std::array<StepFacts, kStepCount> kSteps{{
    {"load", "Load", 1, 0.0, false, false},
    {"preprocess", "Preprocess", 2, 0.0, false, false},
    {"vesselness", "Vesselness", 2, 0.02, true, true},
    {"seeds", "Seeds", 2, 0.09, true, true},
    {"evolve", "Evolve", 9, 0.1, false, false},
    {"correct", "Correct", 1, 0.49, false, false},
    {"surface", "Surface", 6, 0.5, false, false},
    {"smooth", "Smooth", 5, 0.86, false, false},
    {"quality", "Quality", 4, 0.9, false, false},
}};

constexpr const StepFacts& factsOf(Step step) { return kSteps[static_cast<std::size_t>(step)]; }
constexpr const char* stepId(Step step) { return factsOf(step).id; }
constexpr Step stepAfter(Step step) { return static_cast<Step>(static_cast<int>(step) + 1); }

/// From where to where a step takes a run's progress, of 0..1.
constexpr std::array<double, 2> shareOf(Step step) {
  const auto next = static_cast<std::size_t>(step) + 1;
  return {factsOf(step).begins, next < kSteps.size() ? kSteps[next].begins : 1.0};
}

constexpr std::optional<Step> stepFromId(std::string_view id) {
  for (std::size_t s = 0; s < kSteps.size(); ++s)
    if (id == kSteps[s].id) return static_cast<Step>(s);
  return std::nullopt;
}

}  // namespace angiomesh
