// SPDX-License-Identifier: BSD-3-Clause
#include "core/sizing/guidance_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "core/base/parallel.h"
#include "core/sizing/guidance_samples.h"

namespace angiomesh {
namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// A number for each node of the grid, kept in bricks of 8^3 nodes of which only those near the
/// zero set exist.
class NodeMap {
 public:
  explicit NodeMap(const Index3& size) {
    for (int a = 0; a < 3; ++a)
      bricks_[a] = static_cast<std::size_t>((std::max(size[a], 2) + 7) / 8);
    table_.assign(bricks_[0] * bricks_[1] * bricks_[2], none);
  }
  [[nodiscard]] std::uint32_t get(const Index3& node) const {
    const std::uint32_t brick = table_[brickOf(node)];
    return brick == none ? none : values_[512 * static_cast<std::size_t>(brick) + inBrick(node)];
  }
  std::uint32_t& ref(const Index3& node) {
    std::uint32_t& brick = table_[brickOf(node)];
    if (brick == none) {
      brick = static_cast<std::uint32_t>(values_.size() / 512);
      values_.resize(values_.size() + 512, none);
    }
    return values_[512 * static_cast<std::size_t>(brick) + inBrick(node)];
  }

 private:
  [[nodiscard]] std::size_t brickOf(const Index3& n) const {
    return static_cast<std::size_t>(n[0] >> 3) +
           bricks_[0] * (static_cast<std::size_t>(n[1] >> 3) +
                         bricks_[1] * static_cast<std::size_t>(n[2] >> 3));
  }
  static std::size_t inBrick(const Index3& n) {
    return static_cast<std::size_t>((n[0] & 7) | (n[1] & 7) << 3 | (n[2] & 7) << 6);
  }
  std::array<std::size_t, 3> bricks_{};
  std::vector<std::uint32_t> table_;
  std::vector<std::uint32_t> values_;
};

/// A node near the zero set, the lowest cone over it and the sample that the cone belongs to.
struct Node {
  Index3 at;
  Eigen::Vector3d place;  ///< LPS mm
  std::uint32_t sample = none;
  double value = std::numeric_limits<double>::infinity();
};

}  // namespace

struct GuidanceField::Data {
  Data(const SplineField& field, const SizingParams& params)
      : geometry(field.geometry()),
        toIndex(geometry.physicalToIndexMatrix()),
        ideal(field, params),
        slope(1.0 - params.etaInverse),
        nodeAt(geometry.size),
        cellAt(geometry.size) {
    for (int a = 0; a < 3; ++a) cells[a] = std::max(geometry.size[a] - 1, 1);
  }

  Geometry geometry;
  Eigen::Matrix3d toIndex;
  IdealLength ideal;
  double slope;
  Index3 cells{};
  SurfaceSamples surface;
  NodeMap nodeAt;  ///< node -> position in `nodes`; after spread(): the sample that it keeps
  NodeMap cellAt;  ///< lowest corner of a cell -> position in `surface.cells`
  std::vector<Node> nodes;
  double triangles = 0.0;
  double area = 0.0;

  /// The smaller of `value` and the cone of sample s at x.
  [[nodiscard]] double under(double value, std::uint32_t s, const Eigen::Vector3d& x) const {
    const Sample& sample = surface.samples[s];
    if (sample.lengthMm >= value) return value;
    const double off = (x - sample.point).norm() - sample.reachMm;
    return std::min(value, off > 0.0 ? sample.lengthMm + slope * off : sample.lengthMm);
  }
  [[nodiscard]] Eigen::Vector3d place(const Index3& n) const {
    return geometry.toPhysical({1.0 * n[0], 1.0 * n[1], 1.0 * n[2]});
  }
  void makeNodes();
  void spread(const Progress& progress);
  void estimate();
  [[nodiscard]] double at(const Eigen::Vector3d& x) const;
  /// The lowest cone of those that a cell and its corners keep; infinity when there is none.
  [[nodiscard]] double lowestAround(const Eigen::Vector3d& x, const Index3& cell) const;
  /// The lowest cone of those that the nodes from `first` to `last` keep; infinity when there is
  /// none.
  [[nodiscard]] double lowest(const Eigen::Vector3d& x, const Index3& first,
                              const Index3& last) const;
};

/// The corners of the cells that hold samples and of their neighbours.
void GuidanceField::Data::makeNodes() {
  for (std::size_t c = 0; c < surface.cells.size(); ++c) {
    const Index3& first = surface.cells[c].first;
    cellAt.ref(first) = static_cast<std::uint32_t>(c);
    Index3 n;
    for (n[2] = std::max(first[2] - 1, 0); n[2] <= std::min(first[2] + 2, cells[2]); ++n[2])
      for (n[1] = std::max(first[1] - 1, 0); n[1] <= std::min(first[1] + 2, cells[1]); ++n[1])
        for (n[0] = std::max(first[0] - 1, 0); n[0] <= std::min(first[0] + 2, cells[0]); ++n[0]) {
          std::uint32_t& node = nodeAt.ref(n);
          if (node != none) continue;
          node = static_cast<std::uint32_t>(nodes.size());
          nodes.push_back({n, place(n)});
        }
  }
}

/// Every node takes over from its six neighbours the sample whose cone over it is lowest, lowest
/// nodes first; a node that finds a lower one later is taken up again. The cones start at the
/// samples themselves here, or nodes within the reach of one would not look for a nearer one. One
/// after the other: the order, and so the result, is fixed.
void GuidanceField::Data::spread(const Progress& progress) {
  using Entry = std::pair<double, std::uint32_t>;
  const double gain = 1e-6 * geometry.voxelMm();
  const auto offer = [&](std::uint32_t n, std::uint32_t sample) {
    Node& node = nodes[n];
    if (node.sample == sample) return false;
    const Sample& from = surface.samples[sample];
    const double value = from.lengthMm + slope * (node.place - from.point).norm();
    if (!(value < node.value - gain)) return false;
    node.value = value;
    node.sample = sample;
    return true;
  };
  for (const SurfaceCell& cell : surface.cells)
    for (int c = 0; c < 8; ++c) {
      const std::uint32_t n = nodeAt.get(
          {cell.first[0] + (c & 1), cell.first[1] + (c >> 1 & 1), cell.first[2] + (c >> 2 & 1)});
      for (std::uint32_t s = 0; s < cell.sampleCount; ++s) offer(n, cell.firstSample + s);
    }
  std::vector<Entry> start;
  start.reserve(nodes.size());
  for (std::uint32_t n = 0; n < nodes.size(); ++n)
    if (nodes[n].sample != none) start.emplace_back(nodes[n].value, n);
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue({}, std::move(start));
  std::size_t steps = 0;
  while (!queue.empty()) {
    const auto [value, number] = queue.top();
    queue.pop();
    if (value > nodes[number].value) continue;
    if (++steps % 65536 == 0) progress.check();
    const Index3 at = nodes[number].at;
    const std::uint32_t sample = nodes[number].sample;
    for (int a = 0; a < 3; ++a)
      for (const int step : {-1, 1}) {
        Index3 n = at;
        n[a] += step;
        if (n[a] < 0 || n[a] > cells[a]) continue;
        const std::uint32_t next = nodeAt.get(n);
        if (next != none && offer(next, sample)) queue.emplace(nodes[next].value, next);
      }
  }
  for (const Node& node : nodes) nodeAt.ref(node.at) = node.sample;
  nodes = {};
}

double GuidanceField::Data::lowest(const Eigen::Vector3d& x, const Index3& first,
                                   const Index3& last) const {
  double value = std::numeric_limits<double>::infinity();
  std::array<std::uint32_t, 4> seen{none, none, none, none};
  std::size_t turn = 0;
  Index3 n;
  for (n[2] = std::max(first[2], 0); n[2] <= std::min(last[2], cells[2]); ++n[2])
    for (n[1] = std::max(first[1], 0); n[1] <= std::min(last[1], cells[1]); ++n[1])
      for (n[0] = std::max(first[0], 0); n[0] <= std::min(last[0], cells[0]); ++n[0]) {
        const std::uint32_t sample = nodeAt.get(n);
        if (sample == none || sample == seen[0] || sample == seen[1] || sample == seen[2] ||
            sample == seen[3])
          continue;
        seen[turn++ & 3] = sample;
        value = under(value, sample, x);
      }
  return value;
}

// The samples that matter lie far apart in memory: all of them are asked for before the first is
// looked at.
double GuidanceField::Data::lowestAround(const Eigen::Vector3d& x, const Index3& cell) const {
  const auto fetch = [this](std::uint32_t s) { __builtin_prefetch(&surface.samples[s].lengthMm); };
  std::array<std::uint32_t, 8> found{};
  std::size_t count = 0;
  for (int c = 0; c < 8; ++c) {
    const std::uint32_t s =
        nodeAt.get({cell[0] + (c & 1), cell[1] + (c >> 1 & 1), cell[2] + (c >> 2 & 1)});
    if (s == none || std::find(found.begin(), found.begin() + count, s) != found.begin() + count)
      continue;
    fetch(s);
    found[count++] = s;
  }
  const std::uint32_t own = cellAt.get(cell);
  double value = std::numeric_limits<double>::infinity();
  if (own != none) {
    const SurfaceCell& in = surface.cells[own];
    for (std::uint32_t s = 0; s < in.sampleCount; ++s) fetch(in.firstSample + s);
    for (std::size_t i = 0; i < count; ++i) value = under(value, found[i], x);
    for (std::uint32_t s = 0; s < in.sampleCount; ++s) value = under(value, in.firstSample + s, x);
    return value;
  }
  for (std::size_t i = 0; i < count; ++i) value = under(value, found[i], x);
  return value;
}

double GuidanceField::Data::at(const Eigen::Vector3d& x) const {
  if (surface.samples.empty() || !x.allFinite()) return ideal.limited(ideal.longest());
  const Eigen::Vector3d index = toIndex * (x - geometry.origin);
  Index3 cell;
  for (int a = 0; a < 3; ++a)
    cell[a] = static_cast<int>(std::clamp(index[a], 0.0, static_cast<double>(cells[a]) - 0.5));
  double value = lowestAround(x, cell);
  for (int r = 1; r <= 3 && std::isinf(value); ++r)
    value = lowest(x, {cell[0] - r, cell[1] - r, cell[2] - r},
                   {cell[0] + 1 + r, cell[1] + 1 + r, cell[2] + 1 + r});
  if (std::isinf(value))
    for (std::uint32_t s = 0; s < surface.samples.size(); ++s) value = under(value, s, x);
  return value;
}

void GuidanceField::Data::estimate() {
  const std::size_t grain = 1024;
  const std::size_t count = surface.samples.size();
  std::vector<std::array<double, 2>> parts((count + grain - 1) / grain);
  parallelFor(0, count, grain, [&](std::size_t first, std::size_t last) {
    std::array<double, 2>& part = parts[first / grain];
    for (std::size_t s = first; s < last; ++s) {
      const Sample& sample = surface.samples[s];
      part[0] += sample.areaMm2;
      part[1] += evenTriangles(sample.areaMm2, at(sample.point));
    }
  });
  for (const std::array<double, 2>& part : parts) {
    area += part[0];
    triangles += part[1];
  }
}

GuidanceField::GuidanceField(const SplineField& field, const SizingParams& params,
                             const Progress& progress, const CutAway* away)
    : data_(std::make_unique<Data>(field, params)) {
  data_->surface = sampleZeroSet(field, data_->ideal, away, progress);
  data_->makeNodes();
  data_->spread(progress);
  data_->estimate();
  progress.report(1.0);
}

GuidanceField::~GuidanceField() = default;

double GuidanceField::at(const Eigen::Vector3d& pointLps) const { return data_->at(pointLps); }

double GuidanceField::idealLength(double curvature) const {
  return data_->ideal.limited(data_->ideal.fromCurvature(curvature));
}

double GuidanceField::idealLength(const SplineField::SecondJet& jet) const {
  return idealLength(principalCurvatures(jet).maximal());
}

const std::vector<GuidanceField::Sample>& GuidanceField::samples() const {
  return data_->surface.samples;
}

double GuidanceField::estimatedTriangles() const { return data_->triangles; }
double GuidanceField::estimatedAreaMm2() const { return data_->area; }
double GuidanceField::slope() const { return data_->slope; }

}  // namespace angiomesh
