// SPDX-License-Identifier: BSD-3-Clause
#include "core/sizing/guidance_samples.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/openings/cut_away.h"

namespace angiomesh {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int brickCells = 8;

/// Eq. 4.1 for a curvature of 1: the chord of a part of a circle.
double chordOf(double turns) { return 2.0 * portableSinTurns(0.5 * turns); }

/// Of 0.8 radian: longer edges would cut sharp bends off, however small these are.
const double kSharpestTurn = chordOf(0.8 / turn);

/// The lattice of bricks of 8^3 cells.
struct Bricks {
  Index3 cells;  ///< of the whole grid
  Index3 count;
  explicit Bricks(const Geometry& g) {
    for (int a = 0; a < 3; ++a) {
      cells[a] = std::max(g.size[a] - 1, 1);
      count[a] = (cells[a] + brickCells - 1) / brickCells;
    }
  }
  [[nodiscard]] std::size_t total() const {
    return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]) *
           static_cast<std::size_t>(count[2]);
  }
  /// First and one past the last cell of brick b.
  void range(std::size_t b, Index3& first, Index3& last) const {
    const auto nx = static_cast<std::size_t>(count[0]);
    const auto ny = static_cast<std::size_t>(count[1]);
    const Index3 at{static_cast<int>(b % nx), static_cast<int>(b / nx % ny),
                    static_cast<int>(b / nx / ny)};
    for (int a = 0; a < 3; ++a) {
      first[a] = at[a] * brickCells;
      last[a] = std::min(first[a] + brickCells, cells[a]);
    }
  }
};

bool holdsZero(const std::array<double, 2>& bounds) { return bounds[0] <= 0.0 && bounds[1] >= 0.0; }

/// Area of the cut through one tetrahedron.
double cutArea(const std::array<Eigen::Vector3d, 4>& p, const std::array<double, 4>& f) {
  std::array<int, 4> order{};
  int inside = 0;
  int outside = 3;
  for (int i = 0; i < 4; ++i)
    order[static_cast<std::size_t>(f[i] < 0.0 ? inside++ : outside--)] = i;
  const auto cut = [&](int a, int b) -> Eigen::Vector3d {
    const auto i = static_cast<std::size_t>(order[static_cast<std::size_t>(a)]);
    const auto j = static_cast<std::size_t>(order[static_cast<std::size_t>(b)]);
    return p[i] + f[i] / (f[i] - f[j]) * (p[j] - p[i]);
  };
  if (inside == 0 || inside == 4) return 0.0;
  if (inside == 2) {
    const Eigen::Vector3d a = cut(0, 2);
    return 0.5 * (cut(1, 3) - a).cross(cut(1, 2) - cut(0, 3)).norm();
  }
  const int single = inside == 1 ? 0 : 3;
  const int other = inside == 1 ? 1 : 0;
  const Eigen::Vector3d a = cut(single, other);
  return 0.5 * (cut(single, other + 1) - a).cross(cut(single, other + 2) - a).norm();
}

/// A cell that the zero set passes through, or may.
struct Candidate {
  Index3 first;
  double areaMm2;  ///< of the zero set in it; negative where its corners do not differ in sign
};

/// A box of a cell: its lowest corner and its sides, in index space.
struct Box {
  Eigen::Vector3d low, side;
};

/// Takes the samples of a cell.
class Sampler {
 public:
  Sampler(const SplineField& field, const IdealLength& ideal, int finest)
      : field_(field),
        ideal_(ideal),
        geometry_(field.geometry()),
        toIndex_(geometry_.physicalToIndexMatrix()),
        toPhysical_(geometry_.direction * geometry_.spacing.asDiagonal()),
        voxel_(geometry_.voxelMm()),
        finest_(finest) {
    // The wall bends in a thick slice as much as in so many thin ones.
    constexpr double most = 8.0;
    for (int a = 0; a < 3; ++a)
      parts_[a] =
          static_cast<int>(std::clamp(std::round(geometry_.spacing[a] / voxel_), 1.0, most));
    const Eigen::Vector3d parts(parts_[0], parts_[1], parts_[2]);
    patch_ = 0.4 * geometry_.spacing.cwiseQuotient(parts).norm();
  }

  /// Appends the samples of a cell: one for each of its parts, which are about as high as wide, or
  /// where edges want to be short against the part, those of its own parts.
  void sample(const Candidate& cell, std::vector<GuidanceField::Sample>& samples) const {
    const Eigen::Vector3d low(cell.first[0], cell.first[1], cell.first[2]);
    const Eigen::Vector3d side(1.0 / parts_[0], 1.0 / parts_[1], 1.0 / parts_[2]);
    const bool crossed = cell.areaMm2 >= 0.0;
    const std::size_t before = samples.size();
    if (parts_ == Index3{1, 1, 1}) {
      sampleBox({low, side}, crossed, std::max(cell.areaMm2, 0.0), samples);
    } else {
      for (int k = 0; k < parts_[2]; ++k)
        for (int j = 0; j < parts_[1]; ++j)
          for (int i = 0; i < parts_[0]; ++i) {
            const Box box{low + side.cwiseProduct(Eigen::Vector3d(i, j, k)), side};
            const double area = areaIn(box);
            sampleBox(box, area > 0.0, area, samples);
          }
    }
    if (samples.size() > before || !crossed) return;
    if (const auto foot = onAnEdge(cell.first)) {
      samples.push_back(at(*foot));
      samples.back().areaMm2 = cell.areaMm2;
    }
  }

 private:
  /// `area` is that of the zero set of the linear interpolant in it.
  void sampleBox(const Box& box, bool crossed, double area,
                 std::vector<GuidanceField::Sample>& samples) const {
    const std::optional<Eigen::Vector3d> foot = footNear(box, crossed ? 0.5 : 0.0);
    if (!foot) return;
    const GuidanceField::Sample whole = at(*foot);
    const double length = whole.lengthMm / voxel_;
    const int n = std::min(length >= 1.0 ? 1 : length >= 0.25 ? 2 : 4, finest_);
    const std::size_t before = samples.size();
    if (n > 1) samplePartsOf(box, n, samples);
    if (samples.size() > before) return;
    samples.push_back(whole);
    samples.back().areaMm2 = area;
  }

  /// The samples of the n^3 parts of a box.
  void samplePartsOf(const Box& box, int n, std::vector<GuidanceField::Sample>& samples) const {
    const Eigen::Vector3d side = box.side / n;
    std::array<double, 125> value{};
    const int stride = n + 1;
    for (int c = 0; c < stride * stride * stride; ++c)
      value[static_cast<std::size_t>(c)] =
          field_
              .atIndex(box.low + side.cwiseProduct(Eigen::Vector3d(c % stride, c / stride % stride,
                                                                   c / stride / stride)))
              .value;
    const Eigen::Matrix3d toPhysical = toPhysical_ * side.asDiagonal();
    const std::size_t before = samples.size();
    double rest = 0.0;
    for (int s = 0; s < n * n * n; ++s) {
      const Index3 p{s % n, s / n % n, s / n / n};
      std::array<double, 8> corner{};
      for (int c = 0; c < 8; ++c)
        corner[static_cast<std::size_t>(c)] = value[static_cast<std::size_t>(
            p[0] + (c & 1) + stride * (p[1] + (c >> 1 & 1) + stride * (p[2] + (c >> 2 & 1))))];
      const double area = zeroSetArea(corner, toPhysical);
      const Box part{box.low + side.cwiseProduct(Eigen::Vector3d(p[0], p[1], p[2])), side};
      if (const auto foot = footNear(part, 0.5)) {
        samples.push_back(at(*foot));
        samples.back().reachMm = patch_ / n;
        samples.back().areaMm2 = area;
      } else {
        rest += area;
      }
    }
    for (std::size_t i = before; i < samples.size(); ++i)
      samples[i].areaMm2 += rest / static_cast<double>(samples.size() - before);
  }

  /// As zeroSetArea() of the values at the corners of a box; 0 without a change of sign.
  [[nodiscard]] double areaIn(const Box& box) const {
    std::array<double, 8> corner{};
    for (int c = 0; c < 8; ++c)
      corner[static_cast<std::size_t>(c)] =
          field_
              .atIndex(box.low +
                       box.side.cwiseProduct(Eigen::Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1)))
              .value;
    return zeroSetArea(corner, toPhysical_ * box.side.asDiagonal());
  }

  /// The zero found by Newton's method from the centre of a box, if it lies in the box grown by
  /// `margin` of its sides.
  [[nodiscard]] std::optional<Eigen::Vector3d> footNear(const Box& box, double margin) const {
    const Eigen::Vector3d centre = box.low + 0.5 * box.side;
    const Eigen::Vector3d reach = (0.5 + margin) * box.side;
    const double reachMm = reach.cwiseProduct(geometry_.spacing).maxCoeff();
    Eigen::Vector3d x = geometry_.toPhysical(centre);
    for (int n = 0; n < 8; ++n) {
      const SplineField::Jet jet = field_.at(x);
      const double squared = jet.gradient.squaredNorm();
      if (!(squared > 1e-24)) return std::nullopt;
      const double distance = jet.value / std::sqrt(squared);
      // The zero set is further than the box reaches, unless the field is bent a great deal.
      if (n == 0 && std::fabs(distance) > 2.5 * reachMm) return std::nullopt;
      const double step = std::clamp(distance, -0.7 * voxel_, 0.7 * voxel_);
      x -= step / std::sqrt(squared) * jet.gradient;
      const Eigen::Vector3d off = (toIndex_ * (x - geometry_.origin) - centre).cwiseAbs() - reach;
      if (std::fabs(distance) < 0.02 * voxel_)
        return off.maxCoeff() <= 0.0 ? std::optional<Eigen::Vector3d>(x) : std::nullopt;
      if (off.cwiseProduct(geometry_.spacing).maxCoeff() > voxel_) return std::nullopt;
    }
    return std::nullopt;
  }

  /// A zero on an edge of a cell whose corners differ in sign, by bisection.
  [[nodiscard]] std::optional<Eigen::Vector3d> onAnEdge(const Index3& cell) const {
    const auto value = [&](int i, int j, int k) { return field_.atVoxel(i, j, k); };
    for (int c = 0; c < 8; ++c)
      for (int a = 0; a < 3; ++a) {
        if (c >> a & 1) continue;
        Index3 p{cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2 & 1)};
        Eigen::Vector3d from(p[0], p[1], p[2]);
        const bool inside = value(p[0], p[1], p[2]) < 0.0;
        ++p[a];
        if (!geometry_.contains(p[0], p[1], p[2])) continue;
        if (inside == (value(p[0], p[1], p[2]) < 0.0)) continue;
        Eigen::Vector3d to(p[0], p[1], p[2]);
        for (int n = 0; n < 16; ++n) {
          const Eigen::Vector3d middle = 0.5 * (from + to);
          ((field_.atIndex(middle).value < 0.0) == inside ? from : to) = middle;
        }
        return geometry_.toPhysical(to);
      }
    return std::nullopt;
  }

  [[nodiscard]] GuidanceField::Sample at(const Eigen::Vector3d& x) const {
    const SplineField::SecondJet jet = field_.secondAt(x);
    const double length = ideal_.at(principalCurvatures(jet).maximal(), [&](double enough) {
      return thickness(x, jet.gradient, enough);
    });
    return {x, length, patch_, 0.0};
  }

  /// The distance from a point of the zero set along the inward normal to the opposite sheet;
  /// `enough` where it is not reached before.
  [[nodiscard]] double thickness(const Eigen::Vector3d& x, const Eigen::Vector3d& gradient,
                                 double enough) const {
    const double slope = gradient.norm();
    if (!(slope > 1e-12)) return enough;
    const Eigen::Vector3d inward = -gradient / slope;
    const double end = std::min(enough, 40.0 * voxel_);
    double before = 0.0;
    double t = 0.1 * voxel_;
    double valueBefore = 0.0;
    while (t < end) {
      const Eigen::Vector3d p = x + t * inward;
      if (!inGrid(p)) return enough;
      const double value = field_.valueAt(p);
      if (!(value < 0.0)) {
        const double share = value > valueBefore ? valueBefore / (valueBefore - value) : 1.0;
        return before + share * (t - before);
      }
      before = t;
      valueBefore = value;
      t += std::clamp(0.7 * -value / slope, 0.1 * voxel_, 2.0 * voxel_);
    }
    return enough;
  }

  [[nodiscard]] bool inGrid(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d index = toIndex_ * (p - geometry_.origin);
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= 0.0 && index[a] <= geometry_.size[a] - 1.0)) return false;
    return true;
  }

  const SplineField& field_;
  const IdealLength& ideal_;
  const Geometry& geometry_;
  Eigen::Matrix3d toIndex_, toPhysical_;
  double voxel_;
  int finest_;
  Index3 parts_{};  ///< of a cell, along each axis
  /// Within this distance of a sample at 1 per part lies its piece of the zero set.
  double patch_;
};

void findCells(const SplineField& field, const Bricks& bricks, std::size_t b,
               std::vector<Candidate>& cells) {
  Index3 first;
  Index3 last;
  bricks.range(b, first, last);
  if (!holdsZero(field.bounds(first, last))) return;
  const Geometry& g = field.geometry();
  const Eigen::Matrix3d toPhysical = g.direction * g.spacing.asDiagonal();
  constexpr int side = brickCells + 1;
  std::array<double, side * side * side> node{};
  const auto at = [&](int i, int j, int k) -> double& {
    return node[static_cast<std::size_t>(i - first[0] +
                                         side * (j - first[1] + side * (k - first[2])))];
  };
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i)
        at(i, j, k) = field.atVoxel(std::min(i, g.size[0] - 1), std::min(j, g.size[1] - 1),
                                    std::min(k, g.size[2] - 1));
  for (int k = first[2]; k < last[2]; ++k)
    for (int j = first[1]; j < last[1]; ++j)
      for (int i = first[0]; i < last[0]; ++i) {
        std::array<double, 8> corner{};
        int inside = 0;
        for (int c = 0; c < 8; ++c) {
          const double value = at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2 & 1));
          corner[static_cast<std::size_t>(c)] = value;
          inside += value < 0.0 ? 1 : 0;
        }
        if (inside > 0 && inside < 8)
          cells.push_back({{i, j, k}, zeroSetArea(corner, toPhysical)});
        else if (holdsZero(field.bounds({i, j, k}, {i + 1, j + 1, k + 1})))
          cells.push_back({{i, j, k}, -1.0});
      }
}

/// Puts samples that lie in the same cell next to each other: the feet of one cell may lie in its
/// neighbours.
SurfaceSamples byCell(const Geometry& g, const std::vector<GuidanceField::Sample>& samples) {
  const Eigen::Matrix3d toIndex = g.physicalToIndexMatrix();
  std::vector<std::pair<std::size_t, std::uint32_t>> order(samples.size());
  parallelForEach(samples.size(), 4096, [&](std::size_t i) {
    const Eigen::Vector3d index = toIndex * (samples[i].point - g.origin);
    Index3 cell;
    for (int a = 0; a < 3; ++a)
      cell[a] = static_cast<int>(std::clamp(index[a], 0.0, std::max(g.size[a] - 1.5, 0.0)));
    order[i] = {g.offset(cell[0], cell[1], cell[2]), static_cast<std::uint32_t>(i)};
  });
  std::sort(order.begin(), order.end());
  SurfaceSamples all;
  all.samples.reserve(samples.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || order[i].first != order[i - 1].first)
      all.cells.push_back({g.indexOf(order[i].first), static_cast<std::uint32_t>(i), 0});
    ++all.cells.back().sampleCount;
    all.samples.push_back(samples[order[i].second]);
  }
  return all;
}

}  // namespace

double zeroSetArea(const std::array<double, 8>& corner, const Eigen::Matrix3d& indexToPhysical) {
  // Each tetrahedron goes from corner 0 to corner 7 along the axes in one of six orders.
  static constexpr int paths[6][2] = {{1, 3}, {1, 5}, {2, 3}, {2, 6}, {4, 5}, {4, 6}};
  std::array<Eigen::Vector3d, 8> p;
  for (int c = 0; c < 8; ++c)
    p[static_cast<std::size_t>(c)] =
        indexToPhysical * Eigen::Vector3d(c & 1, c >> 1 & 1, c >> 2 & 1);
  double area = 0.0;
  for (const auto& path : paths) {
    const auto a = static_cast<std::size_t>(path[0]);
    const auto b = static_cast<std::size_t>(path[1]);
    area += cutArea({p[0], p[a], p[b], p[7]}, {corner[0], corner[a], corner[b], corner[7]});
  }
  return area;
}

IdealLength::IdealLength(const SplineField& field, const SizingParams& params) {
  const Geometry& g = field.geometry();
  chord_ = params.startFactor() * chordOf(params.rho / turn) * std::max(params.curvatureRelax, 0.0);
  if (params.edgesAround > 1) around_ = 0.5 * chordOf(1.0 / params.edgesAround);
  shortest_ = 0.02 * g.voxelMm();
  const Eigen::Vector3d size(g.size[0], g.size[1], g.size[2]);
  longest_ = std::max(g.spacing.cwiseProduct(size).norm(), shortest_);
  resolved_ = params.edgeMinVoxels.value_or(0.0) * portableCubeRoot(g.voxelVolumeMm3());
  edgeMin_ = std::max(params.edgeMinMm.value_or(shortest_), shortest_);
  edgeMax_ = std::min(params.edgeMaxMm.value_or(longest_), longest_);
}

double IdealLength::fromCurvature(double kappaMax) const {
  const auto spanning = [&](double chord) {
    return chord < longest_ * kappaMax ? chord / kappaMax : longest_;
  };
  const double length = spanning(chord_);
  return std::max(length, std::min(resolved_, spanning(kSharpestTurn)));
}

double IdealLength::limited(double lengthMm) const {
  return std::max(std::min(std::max(lengthMm, edgeMin_), edgeMax_), shortest_);
}

SurfaceSamples sampleZeroSet(const SplineField& field, const IdealLength& ideal,
                             const CutAway* away, const Progress& progress) {
  const Bricks bricks(field.geometry());
  const std::size_t grain = 16;
  const std::size_t blocks = (bricks.total() + grain - 1) / grain;
  struct Part {
    std::vector<Candidate> cells;
    std::vector<GuidanceField::Sample> samples;
  };
  std::vector<Part> parts(blocks);
  parallelForEach(bricks.total(), grain, progress,
                  [&](std::size_t b) { findCells(field, bricks, b, parts[b / grain].cells); });
  progress.report(0.2);
  // A field of noise has a piece of the zero set in every cell: what one cell may cost depends on
  // how many there are, so that the whole stays bounded.
  std::size_t total = 0;
  for (const Part& part : parts) total += part.cells.size();
  const int finest = total < 400000 ? 4 : total < 4000000 ? 2 : 1;
  const Sampler sampler(field, ideal, finest);
  parallelFor(0, blocks, 1, [&](std::size_t first, std::size_t) {
    std::size_t done = 0;
    for (const Candidate& cell : parts[first].cells) {
      if (done++ % 256 == 0) progress.check();
      sampler.sample(cell, parts[first].samples);
    }
  });
  progress.report(0.7);
  std::vector<GuidanceField::Sample> samples;
  for (Part& part : parts) {
    samples.insert(samples.end(), part.samples.begin(), part.samples.end());
    part = {};
  }
  if (away != nullptr && !away->empty())
    std::erase_if(samples,
                  [away](const GuidanceField::Sample& s) { return away->beyond(s.point); });
  return byCell(field.geometry(), samples);
}

}  // namespace angiomesh
