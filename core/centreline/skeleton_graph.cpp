// SPDX-License-Identifier: BSD-3-Clause
#include "core/centreline/skeleton_graph.h"

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
  void moveJoint(Voxels& points);
  void findJoints();
  [[nodiscard]] double distance(std::uint32_t a, std::uint32_t b) const {
    return (set_.position(a) - set_.position(b)).norm();
  }
  void split(const Voxels& points, NodeKind front, NodeKind back);
  int nodeAt(std::uint32_t voxel, NodeKind kind);
  void remove(std::size_t chain);
  [[nodiscard]] std::size_t shortestStub() const;
  bool joinAt(int node);
  [[nodiscard]] double lengthOf(const Voxels& voxels) const;

  const CentreLines& lines_;
  const VoxelSet& set_;
  std::vector<CentreLines::Path> paths_;
  struct Place {
    std::size_t path, point;
  };
  std::map<std::uint32_t, Place> placeOf_;          ///< of the voxels of paths
  std::map<std::uint32_t, std::uint32_t> movedTo_;  ///< points that went, to the path they were in
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

/// Cheapest paths run side by side in a vessel before they join. Takes from the back of a path what
/// lies in the balls along the path that it joins, and goes straight into the middle of that one.
void GraphBuilder::moveJoint(Voxels& points) {
  std::uint32_t joint = points.back();
  for (auto at = movedTo_.find(joint); at != movedTo_.end(); at = movedTo_.find(joint))
    joint = at->second;
  const auto place = placeOf_.find(joint);
  if (place == placeOf_.end()) return;
  const Voxels& other = paths_[place->second.path].points;
  std::size_t at = place->second.point;
  points.pop_back();
  while (!points.empty()) {
    const std::uint32_t here = points.back();
    for (bool isCloser = true; isCloser;) {
      isCloser = false;
      for (const std::size_t next :
           {at - std::min<std::size_t>(at, 2), at - std::min<std::size_t>(at, 1),
            std::min(at + 1, other.size() - 1), std::min(at + 2, other.size() - 1)}) {
        if (distance(here, other[next]) >= distance(here, other[at])) continue;
        at = next;
        isCloser = true;
      }
    }
    if (distance(here, other[at]) >= lines_.wallMm(other[at])) break;
    movedTo_.emplace(here, other[at]);
    points.pop_back();
  }
  if (!points.empty()) {
    const Eigen::Vector3d from = set_.position(points.back());
    const Eigen::Vector3d way = set_.position(other[at]) - from;
    const int steps = static_cast<int>(way.norm() / set_.geometry().voxelMm());
    for (int n = 1; n < steps; ++n) {
      const auto voxel = set_.numberAt(from + way * n / steps);
      if (voxel && *voxel != points.back() && placeOf_.count(*voxel) == 0) points.push_back(*voxel);
    }
  }
  points.push_back(other[at]);
}

void GraphBuilder::findJoints() {
  for (const CentreLines::Path& path : paths_) {
    if (path.back.joins) joints_.insert(path.points.back());
    if (path.front.joins) joints_.insert(path.points.front());
  }
  for (CentreLines::Path& path : paths_) {
    path.front.isAttached = path.back.isAttached = false;
    for (std::size_t n = 0; n < path.points.size(); ++n) {
      if (joints_.count(path.points[n]) == 0) continue;
      if (!path.front.isAttached) path.front.attached = n;
      path.back.attached = path.points.size() - 1 - n;
      path.front.isAttached = path.back.isAttached = true;
    }
  }
}

void GraphBuilder::add(const std::vector<CentreLines::Path>& paths) {
  for (CentreLines::Path path : paths) {
    Voxels& points = path.points;
    if (path.front.joins) {
      // Two ways around a ring meet at the wall: the line goes straight there, not out and back.
      std::size_t skip = 1;
      const double reach = lines_.wallMm(points[0]);
      while (skip + 1 < points.size() && distance(points[skip], points[0]) < reach) ++skip;
      points.erase(points.begin() + 1, points.begin() + static_cast<std::ptrdiff_t>(skip));
      std::reverse(points.begin(), points.end());
      moveJoint(points);
      std::reverse(points.begin(), points.end());
    }
    if (path.back.joins) moveJoint(points);
    for (std::size_t n = 0; n < points.size(); ++n)
      placeOf_.try_emplace(points[n], Place{paths_.size(), n});
    paths_.push_back(std::move(path));
  }
  findJoints();
  for (const CentreLines::Path& path : paths_) {
    Voxels points = path.points;
    NodeKind kinds[2] = {NodeKind::Junction, NodeKind::Junction};
    const CentreLines::PathEnd* ends[2] = {&path.front, &path.back};
    for (int e = 0; e < 2; ++e) {
      const LineEnd line = lines_.endOf(points, *ends[e]);
      kinds[e] = kindOf(line.kind);
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(line.at));
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

/// Of the chains from a junction to a tip that hardly stick out of its ball; the number of chains
/// where there is none.
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
    const double ball = lines_.wallMm(joint->voxel);
    const double sticksOut = length - ball;
    const double wanted =
        std::max(std::min(lines_.wallMm(tip->voxel), 0.5 * ball), 2.0 * set_.geometry().voxelMm());
    if (sticksOut >= wanted || length >= least) continue;
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
