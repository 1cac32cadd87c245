// SPDX-License-Identifier: BSD-3-Clause
#include "core/lumen/local_levels.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <numeric>

#include "core/base/parallel.h"
#include "core/vesselness/gauss_kernel.h"

namespace angiomesh {
namespace {

constexpr int kBlock = 4;  // voxels
constexpr double kSigmaBlocks = 2.0;
constexpr float kPriorShare = 0.02F;   // of full weight
constexpr double kPriorWeight = 0.02;  // voxels per block, of the mean over all

using Pair = Eigen::Vector2d;  // sum of weight * value, sum of weight

void blur(Volume<Pair>& blocks) {
  const Geometry& g = blocks.geometry;
  const std::vector<float> kernel = discreteGaussian(kSigmaBlocks * kSigmaBlocks);
  const std::array<std::size_t, 3> stride{1, g.offset(0, 1, 0), g.offset(0, 0, 1)};
  for (std::size_t a = 0; a < 3; ++a) {
    Volume<Pair> out(g, Pair::Zero());
    parallelForEach(blocks.voxels.size(), 4096, [&](std::size_t at) {
      const int here = g.indexOf(at)[a];
      for (int m = 1 - static_cast<int>(kernel.size()); m < static_cast<int>(kernel.size()); ++m) {
        if (here + m < 0 || here + m >= g.size[a]) continue;
        const auto next =
            static_cast<std::ptrdiff_t>(at) + m * static_cast<std::ptrdiff_t>(stride[a]);
        out.voxels[at] += static_cast<double>(kernel[static_cast<std::size_t>(std::abs(m))]) *
                          blocks.voxels[static_cast<std::size_t>(next)];
      }
    });
    blocks = std::move(out);
  }
}

/// From the cells of a set outwards, layer by layer.
void spreadOut(const CellBand& band, std::vector<char> known, std::vector<float>& mean) {
  constexpr char reached = 2;
  std::vector<std::uint32_t> front, next;
  for (std::uint32_t c = 0; c < band.size(); ++c)
    if (known[c] != 0) front.push_back(c);
  while (!front.empty()) {
    next.clear();
    for (const std::uint32_t c : front)
      for (std::size_t k = 0; k < CellBand::kOffsets.size(); ++k) {
        const std::uint32_t n = band.neighbour(c, k);
        if (n == CellBand::none || known[n] != 0) continue;
        known[n] = reached;
        next.push_back(n);
      }
    std::sort(next.begin(), next.end());
    parallelForEach(next.size(), 4096, [&](std::size_t at) {
      float sum = 0.0F;
      float count = 0.0F;
      for (std::size_t k = 0; k < CellBand::kOffsets.size(); ++k) {
        const std::uint32_t n = band.neighbour(next[at], k);
        if (n == CellBand::none || known[n] != 1) continue;
        sum += mean[n];
        count += 1.0F;
      }
      mean[next[at]] = sum / count;
    });
    for (const std::uint32_t c : next) known[c] = 1;
    front.swap(next);
  }
}

Pair interpolated(const Volume<Pair>& blocks, const Index3& voxel) {
  const Geometry& g = blocks.geometry;
  Index3 low{};
  std::array<double, 3> t{};
  for (std::size_t a = 0; a < 3; ++a) {
    const double x = std::clamp((voxel[a] + 0.5) / kBlock - 0.5, 0.0, g.size[a] - 1.0);
    low[a] = std::min(static_cast<int>(x), std::max(g.size[a] - 2, 0));
    t[a] = x - low[a];
  }
  Pair sum = Pair::Zero();
  for (int c = 0; c < 8; ++c) {
    double w = 1.0;
    Index3 p{};
    for (std::size_t a = 0; a < 3; ++a) {
      const int high = c >> a & 1;
      w *= high != 0 ? t[a] : 1.0 - t[a];
      p[a] = std::min(low[a] + high, g.size[a] - 1);
    }
    sum += w * blocks.at(p[0], p[1], p[2]);
  }
  return sum;
}

}  // namespace

std::vector<float> localMean(const CellBand& band, const std::vector<float>& value,
                             const std::vector<float>& weight) {
  Geometry g;
  for (std::size_t a = 0; a < 3; ++a) g.size[a] = (band.geometry.size[a] + kBlock - 1) / kBlock;
  Volume<Pair> blocks(g, Pair::Zero());
  Pair all = Pair::Zero();
  for (std::size_t c = 0; c < band.size(); ++c) {
    if (weight[c] == 0.0F) continue;
    const Index3 p = band.geometry.indexOf(band.voxel[c]);
    const auto w = static_cast<double>(weight[c]);
    const Pair add(w * static_cast<double>(value[c]), w);
    blocks.at(p[0] / kBlock, p[1] / kBlock, p[2] / kBlock) += add;
    all += add;
  }
  std::vector<float> mean(band.size(), 0.0F);
  if (!(all[1] > 0.0)) return mean;
  blur(blocks);
  const Pair prior(kPriorWeight * all[0] / all[1], kPriorWeight);
  parallelForEach(band.size(), 8192, [&](std::size_t c) {
    const Pair sum = interpolated(blocks, band.geometry.indexOf(band.voxel[c])) + prior;
    mean[c] = static_cast<float>(sum[0] / sum[1]);
  });
  return mean;
}

std::vector<float> meanAlong(const CellBand& band, const std::vector<char>& set,
                             const std::vector<float>& value, const std::vector<float>& weight,
                             int steps, const std::vector<float>& prior) {
  if (steps == 0) return prior;
  // The set's cells by number. Those of a row around a cell have consecutive numbers here, too.
  std::vector<std::uint32_t> cells, number(band.size() + 1, 0);
  for (std::uint32_t c = 0; c < band.size(); ++c) {
    number[c] = static_cast<std::uint32_t>(cells.size());
    if (set[c] != 0) cells.push_back(c);
  }
  number.back() = static_cast<std::uint32_t>(cells.size());
  const auto runOf = [&](std::size_t n, std::size_t row) {
    const CellBand::Run run = band.run(cells[n], row);
    const std::uint32_t first = number[run.first];
    return CellBand::Run{first, number[run.first + run.count] - first};
  };
  std::vector<std::uint32_t> first(cells.size() + 1, 0);
  parallelForEach(cells.size(), 4096, [&](std::size_t n) {
    for (std::size_t row = 0; row < 9; ++row) first[n + 1] += runOf(n, row).count;
  });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<std::uint32_t> near(first.back());
  parallelForEach(cells.size(), 4096, [&](std::size_t n) {
    std::uint32_t at = first[n];
    for (std::size_t row = 0; row < 9; ++row) {
      const CellBand::Run run = runOf(n, row);
      for (std::uint32_t k = 0; k < run.count; ++k) near[at++] = run.first + k;
    }
  });
  using Sum = std::array<float, 2>;  // of weight * value, of weight
  std::vector<Sum> sum(cells.size()), next(cells.size());
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const std::uint32_t c = cells[n];
    sum[n] = {weight[c] * value[c], weight[c]};
  }
  for (int step = 0; step < steps; ++step) {
    parallelForEach(cells.size(), 4096, [&](std::size_t n) {
      Sum all{0.0F, 0.0F};
      for (std::uint32_t at = first[n]; at < first[n + 1]; ++at) {
        const Sum& s = sum[near[at]];
        all[0] += s[0];
        all[1] += s[1];
      }
      const float share = 1.0F / static_cast<float>(first[n + 1] - first[n]);
      next[n] = {all[0] * share, all[1] * share};
    });
    std::swap(sum, next);
  }
  std::vector<float> mean = prior;
  for (std::size_t n = 0; n < cells.size(); ++n)
    mean[cells[n]] = (sum[n][0] + kPriorShare * prior[cells[n]]) / (sum[n][1] + kPriorShare);
  spreadOut(band, set, mean);
  return mean;
}

}  // namespace angiomesh
