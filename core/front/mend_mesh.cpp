// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/mend_mesh.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/front/fill_loop.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_faults.h"

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
    const std::vector<EdgeSide> sides = sortedEdgeSides(mesh.mesh);
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
      end = edgeRunEnd(sides, i);
      if (end == i + 1) single_.push_back({sides[i].low, sides[i].high});
    }
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
      const std::vector<Side> rim = openSides();
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
    std::set<Side> filled;
    out = mesh_;
    for (const std::vector<std::uint32_t>& loop : loops_) {
      std::vector<FrontPoint> vertices(loop.size());
      std::vector<std::uint32_t> numbers(loop.size());
      for (std::uint32_t i = 0; i < loop.size(); ++i) {
        numbers[i] = i;
        vertices[i].point = mesh_.mesh.points[loop[i]];
        vertices[i].normal = field_.at(vertices[i].point).gradient;
        vertices[i].normal /= std::max(vertices[i].normal.norm(), 1e-12);
      }
      const auto filling = fillLoop(numbers, vertices, [&](std::uint32_t i, std::uint32_t k) {
        const std::uint32_t a = loop[i], b = loop[k];
        return filled.count({a, b}) > 0 || filled.count({b, a}) > 0 || joined(a, b);
      });
      if (filling.empty()) return false;
      for (const auto& t : filling) {
        for (std::size_t k = 0; k < 3; ++k) filled.insert({loop[t[k]], loop[t[(k + 1) % 3]]});
        out.mesh.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
        out.patch.push_back(0);
        out.origin.push_back(FaceOrigin::Closing);
      }
    }
    out = selectTriangles(out,
                          [this](std::uint32_t t) { return t >= gone_.size() || gone_[t] == 0; });
    return true;
  }

 private:
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  // False where it is gone already, or touches a plane that the surface ends in.
  bool remove(std::uint32_t t) {
    if (gone_[t] != 0) return false;
    for (const std::uint32_t v : mesh_.mesh.triangles[t])
      if (mesh_.place[v].planes() > 0) return false;
    gone_[t] = 1;
    list_.push_back(t);
    return true;
  }

  // Whether a triangle that is left has both vertices.
  [[nodiscard]] bool joined(std::uint32_t a, std::uint32_t b) const {
    for (std::uint32_t i = startOf_[a]; i < startOf_[a + 1]; ++i) {
      if (gone_[around_[i]] != 0) continue;
      for (const std::uint32_t v : mesh_.mesh.triangles[around_[i]])
        if (v == b) return true;
    }
    return false;
  }

  // The sides that lack a neighbour, sorted, as they run around the hole; but for rims in the
  // planes that the surface ends in. Only where triangles are gone can there be more of them than
  // at first.
  [[nodiscard]] std::vector<Side> openSides() const {
    std::vector<Side> rim;
    for (const auto& [low, high] : single_) addIfOpen(low, high, rim);
    for (const std::uint32_t t : list_) {
      const auto& c = mesh_.mesh.triangles[t];
      for (std::size_t k = 0; k < 3; ++k) addIfOpen(c[k], c[(k + 1) % 3], rim);
    }
    std::sort(rim.begin(), rim.end());
    rim.erase(std::unique(rim.begin(), rim.end()), rim.end());
    return rim;
  }

  void addIfOpen(std::uint32_t a, std::uint32_t b, std::vector<Side>& rim) const {
    if (a == b || mesh_.place[a].shared(mesh_.place[b]).planes() > 0) return;
    std::size_t count = 0;
    Side around;
    for (std::uint32_t i = startOf_[a]; i < startOf_[a + 1]; ++i) {
      const auto& c = mesh_.mesh.triangles[around_[i]];
      if (gone_[around_[i]] != 0 || c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t from = c[k], to = c[(k + 1) % 3];
        if (!(from == a && to == b) && !(from == b && to == a)) continue;
        ++count;
        around = {to, from};
      }
    }
    if (count == 1) rim.push_back(around);
  }

  // `rim` sorted, at most one side leaves each vertex.
  bool chain(const std::vector<Side>& rim) {
    loops_.clear();
    std::vector<char> done(rim.size(), 0);
    for (std::size_t i = 0; i < rim.size(); ++i) {
      std::vector<std::uint32_t> loop;
      for (std::size_t at = i; done[at] == 0;) {
        done[at] = 1;
        loop.push_back(rim[at].first);
        const auto next = std::lower_bound(rim.begin(), rim.end(), Side{rim[at].second, 0});
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
  std::vector<std::uint32_t> list_;              // of those gone
  std::vector<Side> single_;                     // the edges that had one triangle to begin with
  std::vector<std::uint32_t> startOf_, around_;  // the triangles around each vertex
  std::vector<std::vector<std::uint32_t>> loops_;
};

}  // namespace

std::vector<std::uint32_t> brokenTriangles(const PatchMesh& mesh, bool open) {
  return brokenTriangles(mesh.mesh, [&](const EdgeSide& side) {
    return open && mesh.place[side.low].shared(mesh.place[side.high]).planes() > 0;
  });
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
