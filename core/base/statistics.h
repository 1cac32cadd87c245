// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace angiomesh {

// Of a sample: a vector of at least one number. What asks for ranks, 0 that of the least number,
// leaves it in another order.

/// Summed in the order of the sample.
inline double meanOf(const std::vector<double>& sample) {
  return std::accumulate(sample.begin(), sample.end(), 0.0) / static_cast<double>(sample.size());
}

template <class Sample>
auto valueOfRank(Sample& sample, std::size_t rank) {
  const auto at = sample.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(sample.begin(), at, sample.end());
  return *at;
}

/// Of an even count the greater of the two in the middle.
template <class Sample>
auto upperMedian(Sample& sample) {
  return valueOfRank(sample, sample.size() / 2);
}

/// What has the rank `fraction` (0..1) of the last one, or the rank below that.
template <class Sample>
auto lowerPercentile(Sample& sample, double fraction) {
  return valueOfRank(sample,
                     static_cast<std::size_t>(fraction * static_cast<double>(sample.size() - 1)));
}

/// The same, linear between the rank below and the rank above (definition 7 of Hyndman and Fan, The
/// American Statistician 50, 1996).
template <class Sample>
double percentile(Sample& sample, double fraction) {
  const double rank = fraction * static_cast<double>(sample.size() - 1);
  const auto low = static_cast<std::size_t>(rank);
  const auto below = static_cast<double>(valueOfRank(sample, low));
  const auto next = sample.begin() + static_cast<std::ptrdiff_t>(low) + 1;
  const double above =
      next == sample.end() ? below : static_cast<double>(*std::min_element(next, sample.end()));
  return below + (rank - static_cast<double>(low)) * (above - below);
}

}  // namespace angiomesh
