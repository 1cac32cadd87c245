// SPDX-License-Identifier: BSD-3-Clause
#include "io/volume/mask_values.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <type_traits>

namespace angiomesh {
namespace {

constexpr double kOffWhole = 0.05;
/// Interpolation with negative lobes overshoots a step by up to 35 % of it, in three directions.
constexpr double kOvershoot = 0.35;
constexpr double kHalf = 0.5;

struct Facts {
  double least = std::numeric_limits<double>::infinity(), greatest = -least, offWhole = 0.0;
  std::size_t notNumbers = 0;

  [[nodiscard]] bool whole() const { return offWhole <= kOffWhole && greatest > kHalf; }
  [[nodiscard]] bool share() const {
    return least >= -kOvershoot && greatest <= 1.0 + kOvershoot && greatest >= kHalf;
  }
};

template <class T>
Facts factsOf(const Volume<T>& volume) {
  Facts facts;
  for (const T stored : volume.voxels) {
    const auto value = static_cast<double>(stored);
    if (std::isnan(value)) {
      ++facts.notNumbers;
      continue;
    }
    facts.least = std::min(facts.least, value);
    facts.greatest = std::max(facts.greatest, value);
    facts.offWhole = std::max(facts.offWhole, std::fabs(value - std::round(value)));
  }
  return facts;
}

std::string numberText(double number) {
  std::ostringstream text;
  text.precision(3);
  text << number;
  return text.str();
}

template <class T, class Change>
void changeEach(Volume<T>& volume, const Change& change) {
  for (T& value : volume.voxels) value = static_cast<T>(change(static_cast<double>(value)));
}

template <class T>
std::vector<std::string> makeLabelsOf(Volume<T>& volume) {
  std::vector<std::string> warnings;
  const Facts facts = factsOf(volume);
  if (facts.notNumbers > 0) {
    warnings.push_back(std::to_string(facts.notNumbers) +
                       (facts.notNumbers == 1 ? " voxel is" : " voxels are") +
                       " not a number: outside of the mask");
    changeEach(volume, [](double value) { return std::isnan(value) ? 0.0 : value; });
  }
  if (facts.offWhole == 0.0) return warnings;
  if (facts.whole()) {
    // Adding 0 makes 0 of -0.
    changeEach(volume, [](double value) { return std::round(value) + 0.0; });
    warnings.push_back("the labels are no whole numbers, by up to " + numberText(facts.offWhole) +
                       ": they were rounded");
  } else if (facts.share()) {
    changeEach(volume, [](double value) { return value >= kHalf ? 1.0 : 0.0; });
    warnings.push_back("the values of the mask lie between " + numberText(facts.least) + " and " +
                       numberText(facts.greatest) +
                       ", as of probabilities or after resampling: voxels of 0.5 and more are "
                       "taken as inside; --threshold takes another value");
  }
  return warnings;
}

}  // namespace

std::vector<std::string> makeLabels(AnyVolume& volume, std::optional<double> threshold) {
  return std::visit(
      [&](auto& v) -> std::vector<std::string> {
        using T = typename std::decay_t<decltype(v.voxels)>::value_type;
        if (threshold) {
          Volume<std::uint8_t> mask(v.geometry);
          std::transform(v.voxels.begin(), v.voxels.end(), mask.voxels.begin(),
                         [&](T value) { return static_cast<double>(value) >= *threshold ? 1 : 0; });
          volume = std::move(mask);
          return {};
        }
        if constexpr (std::is_floating_point_v<T>) return makeLabelsOf(v);
        return {};
      },
      volume);
}

std::vector<std::string> makeLabels(Volume<float>& volume) { return makeLabelsOf(volume); }

bool areNearlyWhole(const Volume<float>& volume) {
  return std::all_of(volume.voxels.begin(), volume.voxels.end(), [](float value) {
    return std::fabs(value - std::round(value)) <= static_cast<float>(kOffWhole);
  });
}

bool looksLikeResampledMask(const Volume<float>& volume) {
  const Facts facts = factsOf(volume);
  if (!facts.share() || facts.least >= 0.0) return false;
  const auto near = std::count_if(volume.voxels.begin(), volume.voxels.end(), [&](float value) {
    return std::fabs(static_cast<double>(value)) <= 0.1 * facts.greatest;
  });
  return 2 * static_cast<std::size_t>(near) > volume.voxels.size();
}

}  // namespace angiomesh
