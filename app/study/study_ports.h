// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/centreline/skeleton.h"
#include "core/pipeline/pipeline.h"

namespace angiomesh::cli {

/// One cut at a random place of a vessel, and what became of it.
struct PortCase {
  std::string cut;  ///< as ports.cuts takes it
  int refused = 0;  ///< places tried before it that could not be cut
  std::size_t triangles = 0;
  double offPlaneMm = 0.0;        ///< of the cap's vertices, at most
  double areaErrorPercent = 0.0;  ///< of the cap, from the section of phi
  double spreadPercent = 0.0;     ///< of the cap's area over the values of rho
  double minAngle = 0.0;          ///< degrees, triangles at corners of rims apart
  std::size_t intersections = 0;
  std::size_t unverified = 0;  ///< components more than without the cut
  std::size_t leaks = 0;       ///< vertices where something was taken, and ports lost elsewhere
  std::size_t nameFaults = 0;  ///< over the values of rho and all formats
};

/// A segmentation that cuts are tried on.
class PortStudy {
 public:
  /// @throws as Pipeline::run()
  PortStudy(Source source, const Parameters& params, const Progress& progress);

  /// Case `number` of those of `seed`: a function of both. The surface goes to `surface` (.stl,
  /// text). @throws NumericError when no place can be cut, Cancelled
  PortCase run(std::uint64_t seed, int number, const std::filesystem::path& surface,
               const Progress& progress);

  [[nodiscard]] double uncutMinAngle() const;
  /// Places refused, by the reason.
  [[nodiscard]] const std::map<std::string, int>& refusals() const { return refusals_; }

 private:
  [[nodiscard]] std::string randomCut(std::uint64_t seed, std::uint64_t& counter) const;
  void measure(const RunResult& result, PortCase& made) const;

  Pipeline pipeline_;
  Parameters params_;
  RunResult uncut_;
  std::unique_ptr<SplineField> field_;
  Skeleton skeleton_;
  std::map<std::string, int> refusals_;
};

}  // namespace angiomesh::cli
