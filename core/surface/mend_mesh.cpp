// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/mend_mesh.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/surface/edge_map.h"
#include "core/surface/fill_loop.h"
#include "core/surface/half_edges.h"
#include "core/surface/mesh_edges.h"

namespace angiomesh {
namespace {

class Mender {
 public:
  Mender(const PatchMesh& mesh, const SplineField& field)
      : mesh_(mesh), field_(field), gone_(mesh.mesh.triangles.size(), 0) {
    startOf_.assign(mesh.mesh.points.size() + 1, 0);
    for (const auto& t : mesh.mesh.triangles)
      for (const std::uint32_t v : t) ++startOf_[v + 1];
    for (std::size_t v = 0; v < mesh.mesh.points.size(); ++v) startOf_[v + 1] += startOf_[v];
    around_.resize(3 * mesh.mesh.triangles.size());
    std::vector<std::uint32_t> place(startOf_.begin(), startOf_.end() - 1);
    for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t)
      for (const std::uint32_t v : mesh.mesh.triangles[t]) around_[place[v]++] = t;
  }

  void takeOut(const std::vector<std::uint32_t>& broken, int rings) {
    std::vector<std::uint32_t> edge = broken;
    for (const std::uint32_t t : broken) remove(t);
    for (int r = 0; r < rings; ++r) {
      std::vector<std::uint32_t> next;
      for (const std::uint32_t t : edge)
        for (const std::uint32_t v : mesh_.mesh.triangles[t])
          for (std::uint32_t i = startOf_[v]; i < startOf_[v + 1]; ++i)
            if (remove(around_[i])) next.push_back(around_[i]);
      edge = std::move(next);
    }
  }

  // Finds the loops around the holes. Vertices where two meet lose all their triangles.
  bool findLoops() {
    for (int round = 0; round < 50; ++round) {
      std::vector<std::pair<std::uint32_t, std::uint32_t>> rim = openSides();
      std::sort(rim.begin(), rim.end());
      bool clean = true;
      for (std::size_t i = 1; i < rim.size(); ++i) {
        if (rim[i].first != rim[i - 1].first) continue;
        clean = false;
        const std::uint32_t v = rim[i].first;
        bool any = false;
        for (std::uint32_t k = startOf_[v]; k < startOf_[v + 1]; ++k)
          any = remove(around_[k]) || any;
        if (!any) return false;
      }
      if (clean) return chain(rim);
    }
    return false;
  }

  bool fill(PatchMesh& out) {
    std::vector<FrontPoint> vertices(mesh_.mesh.points.size());
    EdgeMap used;
    for (std::uint32_t t = 0; t < gone_.size(); ++t) {
      if (gone_[t] != 0) continue;
      const auto& c = mesh_.mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) used.set(c[k], c[(k + 1) % 3], t);
    }
    const auto taken = [&used](std::uint32_t a, std::uint32_t b) {
      return used.has(a, b) || used.has(b, a);
    };
    out = mesh_;
    for (const std::vector<std::uint32_t>& loop : loops_) {
      for (const std::uint32_t v : loop) {
        vertices[v].point = mesh_.mesh.points[v];
        vertices[v].normal = field_.at(vertices[v].point).gradient;
        vertices[v].normal /= std::max(vertices[v].normal.norm(), 1e-12);
      }
      const auto filling = fillLoop(loop, vertices, taken);
      if (filling.empty()) return false;
      for (const auto& t : filling) {
        for (std::size_t k = 0; k < 3; ++k) used.set(t[k], t[(k + 1) % 3], 0);
        out.mesh.triangles.push_back(t);
        out.patch.push_back(0);
        out.origin.push_back(FaceOrigin::Closing);
      }
    }
    out = selectTriangles(out,
                          [this](std::uint32_t t) { return t >= gone_.size() || gone_[t] == 0; });
    return true;
  }

 private:
  // False where it is gone already, or touches a plane that the surface ends in.
  bool remove(std::uint32_t t) {
    if (gone_[t] != 0) return false;
    for (const std::uint32_t v : mesh_.mesh.triangles[t])
      if (mesh_.place[v].planes() > 0) return false;
    gone_[t] = 1;
    return true;
  }

  // The sides that lack a neighbour, as they run around the hole; but for rims in the planes that
  // the surface ends in.
  [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> openSides() const {
    TriMesh left;
    left.points.resize(mesh_.mesh.points.size());
    for (std::uint32_t t = 0; t < gone_.size(); ++t)
      if (gone_[t] == 0) left.triangles.push_back(mesh_.mesh.triangles[t]);
    const std::vector<EdgeSide> sides = sortedEdgeSides(left);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> rim;
    for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
      if (edgeRunEnd(sides, i) != i + 1) continue;
      const EdgeSide& s = sides[i];
      if (mesh_.place[s.low].shared(mesh_.place[s.high]).planes() > 0) continue;
      rim.emplace_back(s.forward ? s.high : s.low, s.forward ? s.low : s.high);
    }
    return rim;
  }

  // `rim` sorted, at most one side leaves each vertex.
  bool chain(std::vector<std::pair<std::uint32_t, std::uint32_t>>& rim) {
    loops_.clear();
    std::vector<char> done(rim.size(), 0);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      std::vector<std::uint32_t> loop;
      for (std::size_t at = i; done[at] == 0;) {
        done[at] = 1;
        loop.push_back(rim[at].first);
        const auto next = std::lower_bound(
            rim.begin(), rim.end(), std::pair<std::uint32_t, std::uint32_t>{rim[at].second, 0});
        if (next == rim.end() || next->first != rim[at].second) return false;
        at = static_cast<std::size_t>(next - rim.begin());
        if (done[at] != 0 && at != i) return false;
      }
      if (!loop.empty()) loops_.push_back(std::move(loop));
    }
    return true;
  }

  const PatchMesh& mesh_;
  const SplineField& field_;
  std::vector<char> gone_;
  std::vector<std::uint32_t> startOf_, around_;  // the triangles around each vertex
  std::vector<std::vector<std::uint32_t>> loops_;
};

}  // namespace

std::vector<std::uint32_t> brokenTriangles(const PatchMesh& mesh, bool open) {
  std::vector<std::uint32_t> broken;
  const std::vector<EdgeSide> sides = sortedEdgeSides(mesh.mesh);
  for (std::size_t i = 0; i < sides.size(); i = edgeRunEnd(sides, i)) {
    const std::size_t end = edgeRunEnd(sides, i);
    if (end - i == 2 && sides[i].forward != sides[i + 1].forward) continue;
    const bool rim = mesh.place[sides[i].low].shared(mesh.place[sides[i].high]).planes() > 0;
    if (end - i == 1 && open && rim) continue;
    for (std::size_t k = i; k < end; ++k) broken.push_back(sides[k].triangle);
  }
  const HalfEdges edges(mesh.mesh);
  for (std::uint32_t t = 0; t < mesh.mesh.triangles.size(); ++t)
    for (const std::uint32_t v : mesh.mesh.triangles[t])
      if (edges.irregular(v)) broken.push_back(t);
  std::sort(broken.begin(), broken.end());
  broken.erase(std::unique(broken.begin(), broken.end()), broken.end());
  return broken;
}

bool mendMesh(PatchMesh& mesh, const std::vector<std::uint32_t>& broken, int rings,
              const SplineField& field) {
  Mender mender(mesh, field);
  mender.takeOut(broken, rings);
  if (!mender.findLoops()) return false;
  PatchMesh mended;
  if (!mender.fill(mended)) return false;
  mesh = std::move(mended);
  return true;
}

}  // namespace angiomesh
