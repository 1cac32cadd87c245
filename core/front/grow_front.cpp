// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/grow_front.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/base/exact_math.h"
#include "core/base/parallel.h"
#include "core/front/advancing_front.h"
#include "core/front/border_curves.h"
#include "core/front/surface_cover.h"
#include "core/mesh/mesh_edges.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t none = SurfaceCover::none;

// Grows the wall, and knows which places of the zero set it has reached.
class Wall {
 public:
  Wall(const Landmarks& landmarks, const SplineField& field, const GuidanceField& size,
       const CutAway& away)
      : landmarks_(landmarks),
        size_(size),
        away_(away),
        surface_(field, size),
        front_(surface_),
        cover_(front_.vertices(), size.slope()) {
    front_.expect(size.estimatedTriangles());
  }

  void addRims(const BorderCurves& curves) {
    for (const FrontPoint& p : curves.points) front_.addVertex(p, surface_.lengthAt(p.point));
    for (const BorderCurves::Loop& rim : curves.rims) front_.startAlong(rim);
  }

  void run(const Progress& progress) {
    front_.run(progress);
    cover_.update();
    // A piece of the reference that no front has reached is a component of its own, unless it is a
    // detail smaller than the edges: a few vertices next to the rest.
    const std::vector<std::uint32_t> cluster = unreachedClusters();
    std::vector<std::uint32_t> inCluster(cluster.size(), 0), inComponent(cluster.size(), 0);
    for (std::uint32_t v = 0; v < cluster.size(); ++v) {
      if (cluster[v] != none) ++inCluster[cluster[v]];
      ++inComponent[landmarks_.component[v]];
    }
    std::vector<char> tried(cluster.size(), 0);
    for (std::uint32_t v = 0; v < cluster.size(); ++v) {
      const std::uint32_t c = cluster[v];
      if (c == none || tried[c] > 3) continue;
      if (inCluster[c] < std::min(inComponent[landmarks_.component[v]], 40U)) continue;
      const FrontPoint& seed = landmarks_.points[v];
      if (cover_.reach(seed) != none) continue;
      if (!startFrom(seed)) {
        ++tried[c];
        continue;
      }
      front_.run(progress);
      cover_.update();
    }
    startFromSamples(progress);
    front_.close();
  }

  [[nodiscard]] const AdvancingFront& front() const { return front_; }

 private:
  // Components that no voxel lies in are known from the samples of the guidance field alone.
  void startFromSamples(const Progress& progress) {
    const auto& samples = size_.samples();
    std::vector<char> open(samples.size(), 0);
    const auto placeOf = [this](const GuidanceField::Sample& sample, FrontPoint& place) {
      return surface_.settle(sample.point, place);
    };
    parallelFor(0, samples.size(), 2048, [&](std::size_t first, std::size_t last) {
      FrontPoint place;
      for (std::size_t i = first; i < last; ++i)
        open[i] = static_cast<char>(placeOf(samples[i], place) && cover_.reach(place) == none);
    });
    FrontPoint place;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (open[i] == 0 || !placeOf(samples[i], place) || cover_.reach(place) != none) continue;
      if (!startFrom(place)) continue;
      front_.run(progress);
      cover_.update();
    }
  }

  // Joins the landmarks that the mesh does not reach along the reference's edges; none elsewhere.
  [[nodiscard]] std::vector<std::uint32_t> unreachedClusters() const {
    const std::size_t n = landmarks_.points.size();
    std::vector<char> open(n, 0);
    parallelForEach(n, 2048, [&](std::size_t v) {
      open[v] =
          static_cast<char>(landmarks_.valid[v] != 0 && cover_.reach(landmarks_.points[v]) == none);
    });
    DisjointSets sets(n);
    for (const auto& t : landmarks_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        if (open[t[k]] != 0 && open[t[(k + 1) % 3]] != 0) sets.join(t[k], t[(k + 1) % 3]);
    std::vector<std::uint32_t> cluster(n, none);
    for (std::uint32_t v = 0; v < n; ++v)
      if (open[v] != 0) cluster[v] = sets.find(v);
    return cluster;
  }

  bool startFrom(const FrontPoint& seed) {
    const Vector3d n = seed.normal;
    const Vector3d side = n.unitOrthogonal();
    for (const double radians : {0.0, 0.7, 1.4, 2.1}) {
      const double turns = radians / (2.0 * std::numbers::pi);
      const Vector3d u = portableCosTurns(turns) * side + portableSinTurns(turns) * n.cross(side);
      FrontPoint second, third;
      // The wished corner of a base that has no other side yet: along the tangent.
      FrontPoint ahead = seed;
      ahead.point = seed.point + 1e-3 * seed.length * n.cross(u);
      const ApexWish forward{5e-4 * seed.length, seed.length};
      if (!surface_.turn(seed, ahead, forward, second)) continue;
      const double base = (second.point - seed.point).norm();
      if (!surface_.turn(seed, second, {0.5 * base, 0.866 * base}, third)) continue;
      if (cover_.reach(second) != none || cover_.reach(third) != none) continue;
      // A first triangle across a section would grow over what is cut away.
      if (takenAway(seed) || takenAway(second) || takenAway(third)) continue;
      const std::uint32_t a = front_.addVertex(seed), b = front_.addVertex(second);
      front_.startAt({a, b, front_.addVertex(third)});
      return true;
    }
    return false;
  }

  [[nodiscard]] bool takenAway(const FrontPoint& place) const {
    return !away_.empty() && away_.beyond(place.point);
  }

  const Landmarks& landmarks_;
  const GuidanceField& size_;
  const CutAway& away_;
  WallSurface surface_;
  AdvancingFront front_;
  SurfaceCover cover_;
};

// Per cut the loops of the rims that it left.
std::vector<std::vector<std::vector<std::uint32_t>>> rimsOfCuts(const PatchMesh& mesh,
                                                                std::size_t cuts) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> next(cuts);
  for (const RimEdge& edge : rimEdges(mesh.mesh)) {
    const std::uint16_t cut = mesh.place[edge.from].shared(mesh.place[edge.to]).cut;
    if (cut != 0) next[cut - 1U][edge.from] = edge.to;
  }
  std::vector<std::vector<std::vector<std::uint32_t>>> rims;
  for (auto& edges : next) rims.push_back(closedLoops(std::move(edges)));
  return rims;
}

}  // namespace

Landmarks landmarksOf(const TriMesh& wall, const SplineField& field, const GuidanceField& size) {
  Landmarks marks;
  const std::size_t n = wall.points.size();
  marks.points.resize(n);
  marks.valid.assign(n, 0);
  marks.triangles = wall.triangles;
  const WallSurface surface(field, size);
  std::vector<char> used(n, 0);
  for (const auto& t : wall.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  parallelForEach(n, 1024, [&](std::size_t v) {
    marks.valid[v] =
        static_cast<char>(used[v] != 0 && surface.settle(wall.points[v], marks.points[v]));
  });
  DisjointSets sets(n);
  for (const auto& t : wall.triangles) {
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  marks.component.resize(n);
  for (std::uint32_t v = 0; v < n; ++v) marks.component[v] = sets.find(v);
  return marks;
}

void fillCap(PatchMesh& out, const std::vector<std::vector<std::uint32_t>>& loops, int plane,
             const std::vector<FrontPoint>& loopPoints, const SplineField& field,
             const GuidanceField& size, const EndPlanes& ends, const Progress& progress) {
  const CapSurface surface(field, size);
  AdvancingFront front(surface);
  std::vector<std::uint32_t> toOut, toFront(loopPoints.size(), none);
  std::vector<std::vector<std::uint32_t>> starts;
  for (const std::vector<std::uint32_t>& loop : loops) {
    starts.emplace_back();
    for (const std::uint32_t v : loop) {
      if (toFront[v] == none) {
        FrontPoint p = loopPoints[v];
        p.normal = ends.normal(plane);
        toFront[v] = front.addVertex(p, size.at(p.point));
        toOut.push_back(v);
      }
      starts.back().push_back(toFront[v]);
    }
  }
  for (const std::vector<std::uint32_t>& loop : starts) front.startAlong(loop);
  front.run(progress);
  front.close();
  for (std::size_t v = toOut.size(); v < front.vertices().size(); ++v) {
    toOut.push_back(static_cast<std::uint32_t>(out.mesh.points.size()));
    out.mesh.points.push_back(front.vertices()[v].point);
    out.place.push_back(Place::inPlane(plane));
  }
  for (std::size_t t = 0; t < front.triangles().size(); ++t) {
    const auto& corners = front.triangles()[t];
    out.mesh.triangles.push_back({toOut[corners[0]], toOut[corners[1]], toOut[corners[2]]});
    out.patch.push_back(static_cast<std::uint16_t>(1 + plane));
    out.origin.push_back(front.origins()[t]);
  }
}

void capCuts(PatchMesh& mesh, std::size_t cuts, const SplineField& field, const GuidanceField& size,
             const EndPlanes& ends, const Progress& progress) {
  if (cuts == 0) return;
  const auto rims = rimsOfCuts(mesh, cuts);
  std::vector<FrontPoint> points(mesh.mesh.points.size());
  for (std::size_t n = 0; n < rims.size(); ++n) {
    for (const std::vector<std::uint32_t>& loop : rims[n])
      for (const std::uint32_t v : loop) {
        points[v].point = mesh.mesh.points[v];
        points[v].length = size.at(points[v].point);
      }
    fillCap(mesh, rims[n], static_cast<int>(6 + n), points, field, size, ends, progress);
  }
}

PatchMesh growFront(const Landmarks& landmarks, const SplineField& field, const GuidanceField& size,
                    const EndPlanes& ends, const CutAway& away, SurfaceBorder border,
                    const Progress& progress) {
  const bool caps = border == SurfaceBorder::Cap;
  const BorderCurves curves = borderCurves(field, size, ends, away, caps);
  Wall grown(landmarks, field, size, away);
  grown.addRims(curves);
  grown.run(progress);
  PatchMesh out;
  for (const FrontPoint& p : grown.front().vertices()) out.mesh.points.push_back(p.point);
  out.place = curves.place;
  out.place.resize(out.mesh.points.size(), Place::onWall());
  out.mesh.triangles = grown.front().triangles();
  out.origin = grown.front().origins();
  out.patch.assign(out.mesh.triangles.size(), 0);
  for (std::size_t plane = 0; plane < curves.caps.size(); ++plane)
    if (!curves.caps[plane].empty())
      fillCap(out, curves.caps[plane], static_cast<int>(plane), curves.points, field, size, ends,
              progress);
  return out;
}

}  // namespace angiomesh
