// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/skeleton_graph.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace angiomesh {
namespace {

using Voxels = std::vector<std::uint32_t>;
using LineEnd = CentreLines::LineEnd;

NodeKind kindOf(LineEnd::Kind kind) {
  if (kind == LineEnd::Kind::Tip) return NodeKind::Tip;
  return kind == LineEnd::Kind::Border ? NodeKind::Border : NodeKind::Junction;
}

/// Splits paths and joins chains.
class GraphBuilder {
 public:
  GraphBuilder(const CentreLines& lines, const VoxelSet& set) : lines_(lines), set_(set) {}

  void add(const std::vector<CentreLines::Path>& paths);
  void simplify();
  [[nodiscard]] ChainGraph take();

 private:
  void split(const Voxels& points, NodeKind front, NodeKind back);
  int nodeAt(std::uint32_t voxel, NodeKind kind);
  void remove(std::size_t chain);
  [[nodiscard]] std::size_t shortestStub() const;
  bool joinAt(int node);
  [[nodiscard]] double lengthOf(const Voxels& voxels) const;

  const CentreLines& lines_;
  const VoxelSet& set_;
  std::set<std::uint32_t> joints_;
  std::map<std::uint32_t, int> nodeOf_;
  ChainGraph graph_;
};

int GraphBuilder::nodeAt(std::uint32_t voxel, NodeKind kind) {
  const auto [at, isNew] = nodeOf_.try_emplace(voxel, static_cast<int>(graph_.nodes.size()));
  if (isNew) graph_.nodes.push_back({kind, voxel, 0});
  return at->second;
}

double GraphBuilder::lengthOf(const Voxels& voxels) const {
  double length = 0.0;
  for (std::size_t i = 1; i < voxels.size(); ++i)
    length += (set_.position(voxels[i]) - set_.position(voxels[i - 1])).norm();
  return length;
}

void GraphBuilder::split(const Voxels& points, NodeKind front, NodeKind back) {
  if (points.size() < 2) return;
  Chain chain;
  chain.from = nodeAt(points.front(), front);
  for (std::size_t i = 0; i < points.size(); ++i) {
    chain.voxels.push_back(points[i]);
    const bool isLast = i + 1 == points.size();
    if (i == 0 || (!isLast && joints_.count(points[i]) == 0)) continue;
    chain.to = nodeAt(points[i], isLast ? back : NodeKind::Junction);
    ++graph_.nodes[static_cast<std::size_t>(chain.from)].chains;
    ++graph_.nodes[static_cast<std::size_t>(chain.to)].chains;
    graph_.chains.push_back(chain);
    chain.from = chain.to;
    chain.voxels = {points[i]};
  }
}

void GraphBuilder::add(const std::vector<CentreLines::Path>& paths) {
  for (const CentreLines::Path& path : paths) {
    if (path.back.joins) joints_.insert(path.points.back());
    if (path.front.joins) joints_.insert(path.points.front());
  }
  for (const CentreLines::Path& path : paths) {
    Voxels points = path.points;
    if (path.front.joins) {
      // Two ways around a ring meet at the wall: the line goes straight there, not out and back.
      std::size_t skip = 1;
      const double reach = lines_.wallMm(points[0]);
      const Eigen::Vector3d start = set_.position(points[0]);
      while (skip + 1 < points.size() && (set_.position(points[skip]) - start).norm() < reach)
        ++skip;
      points.erase(points.begin() + 1, points.begin() + static_cast<std::ptrdiff_t>(skip));
    }
    NodeKind kinds[2] = {NodeKind::Junction, NodeKind::Junction};
    const CentreLines::PathEnd* ends[2] = {&path.front, &path.back};
    for (int e = 0; e < 2; ++e) {
      const LineEnd line = lines_.endOf(points, *ends[e]);
      const auto last = points.begin() + static_cast<std::ptrdiff_t>(line.at);
      const auto joint =
          std::find_if(points.begin(), last, [&](std::uint32_t n) { return joints_.count(n) > 0; });
      kinds[e] = joint == last ? kindOf(line.kind) : NodeKind::Junction;
      points.erase(points.begin(), joint);
      std::reverse(points.begin(), points.end());
    }
    split(points, kinds[0], kinds[1]);
  }
}

void GraphBuilder::remove(std::size_t chain) {
  --graph_.nodes[static_cast<std::size_t>(graph_.chains[chain].from)].chains;
  --graph_.nodes[static_cast<std::size_t>(graph_.chains[chain].to)].chains;
  graph_.chains.erase(graph_.chains.begin() + static_cast<std::ptrdiff_t>(chain));
}

/// Of the chains from a junction to a tip inside its ball; the number of chains where there is
/// none.
std::size_t GraphBuilder::shortestStub() const {
  std::size_t found = graph_.chains.size();
  double least = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < graph_.chains.size(); ++n) {
    const Chain& chain = graph_.chains[n];
    const ChainGraph::Node* joint = &graph_.nodes[static_cast<std::size_t>(chain.from)];
    const ChainGraph::Node* tip = &graph_.nodes[static_cast<std::size_t>(chain.to)];
    if (joint->kind == NodeKind::Tip) std::swap(joint, tip);
    if (tip->kind != NodeKind::Tip || joint->kind != NodeKind::Junction) continue;
    const double length = lengthOf(chain.voxels);
    if (length >= lines_.wallMm(joint->voxel) || length >= least) continue;
    least = length;
    found = n;
  }
  return found;
}

/// Makes one chain of the two that end at a node, if they are two. A ring keeps its node.
bool GraphBuilder::joinAt(int node) {
  ChainGraph::Node& here = graph_.nodes[static_cast<std::size_t>(node)];
  if (here.kind != NodeKind::Junction) return false;
  if (here.chains == 1) here.kind = NodeKind::Tip;
  if (here.chains != 2) return false;
  std::vector<std::size_t> met;
  for (std::size_t n = 0; n < graph_.chains.size(); ++n)
    if (graph_.chains[n].from == node || graph_.chains[n].to == node) met.push_back(n);
  if (met.size() == 1) {
    here.kind = NodeKind::Ring;
    return false;
  }
  Chain& first = graph_.chains[met[0]];
  Chain second = graph_.chains[met[1]];
  if (first.from == node) {
    std::swap(first.from, first.to);
    std::reverse(first.voxels.begin(), first.voxels.end());
  }
  if (second.to == node) {
    std::swap(second.from, second.to);
    std::reverse(second.voxels.begin(), second.voxels.end());
  }
  first.to = second.to;
  first.voxels.insert(first.voxels.end(), second.voxels.begin() + 1, second.voxels.end());
  graph_.chains.erase(graph_.chains.begin() + static_cast<std::ptrdiff_t>(met[1]));
  here.chains = 0;
  return true;
}

void GraphBuilder::simplify() {
  for (;;) {
    for (std::size_t n = 0; n < graph_.nodes.size(); ++n) joinAt(static_cast<int>(n));
    const std::size_t stub = shortestStub();
    if (stub == graph_.chains.size()) return;
    remove(stub);
  }
}

/// Without the nodes that no chain ends at.
ChainGraph GraphBuilder::take() {
  ChainGraph graph;
  std::vector<int> number(graph_.nodes.size(), -1);
  for (std::size_t n = 0; n < graph_.nodes.size(); ++n) {
    if (graph_.nodes[n].chains == 0) continue;
    number[n] = static_cast<int>(graph.nodes.size());
    graph.nodes.push_back(graph_.nodes[n]);
  }
  graph.chains = std::move(graph_.chains);
  for (Chain& chain : graph.chains) {
    chain.from = number[static_cast<std::size_t>(chain.from)];
    chain.to = number[static_cast<std::size_t>(chain.to)];
  }
  return graph;
}

}  // namespace

ChainGraph chainsOf(const CentreLines& lines, const VoxelSet& set,
                    const std::vector<CentreLines::Path>& paths) {
  GraphBuilder builder(lines, set);
  builder.add(paths);
  builder.simplify();
  return builder.take();
}

}  // namespace angiomesh
