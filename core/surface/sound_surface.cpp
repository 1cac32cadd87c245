// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/sound_surface.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/formatted.h"
#include "core/front/mend_mesh.h"
#include "core/mesh/mesh_edges.h"
#include "core/mesh/mesh_faults.h"
#include "core/mesh/point_grid.h"
#include "core/mesh/self_intersection.h"
#include "core/mesh/triangle_tree.h"
#include "core/remesh/remesh.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t none = SurfaceCheck::none;

/// Remeshings of one group before the reference's own triangles are taken.
constexpr int kAttempts = 5;
/// Vertices of the reference keep this share of a grid edge from its ends.
constexpr double kClearOfCorners = 0.12;
/// Where more of the triangles meet than one in so many, filling anew does not help.
constexpr std::size_t kFewMeet = 50;
/// Where more meet than one in so many, remeshing does not.
constexpr std::size_t kManyMeet = 10;
/// Where the wanted edges are too long for the part, so many voxels.
constexpr double kFineVoxels = 0.35;
/// So many vertices of the reference may be a detail that is smaller than the edges.
constexpr std::size_t kDetail = 40;

void append(PatchMesh& to, const PatchMesh& from) {
  const auto offset = static_cast<std::uint32_t>(to.mesh.points.size());
  to.mesh.points.insert(to.mesh.points.end(), from.mesh.points.begin(), from.mesh.points.end());
  to.place.insert(to.place.end(), from.place.begin(), from.place.end());
  to.patch.insert(to.patch.end(), from.patch.begin(), from.patch.end());
  to.origin.insert(to.origin.end(), from.origin.begin(), from.origin.end());
  to.group.insert(to.group.end(), from.group.begin(), from.group.end());
  for (const auto& t : from.mesh.triangles)
    to.mesh.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
}

/// Lengths of the guidance field, shorter around given places.
class FineSize : public EdgeSize {
 public:
  FineSize(const GuidanceField& size, double shortestMm) : size_(size), shortest_(shortestMm) {}

  void add(const Vector3d& place) {
    grid_.insert(static_cast<std::uint32_t>(places_.size()), place, shortest_);
    places_.push_back(place);
  }
  [[nodiscard]] double at(const Vector3d& pointLps) const override {
    double length = size_.at(pointLps);
    if (length <= shortest_ || places_.empty()) return length;
    grid_.forEachNear(pointLps, (length - shortest_) / kSlope, shortest_, [&](std::uint32_t id) {
      length = std::min(length, shortest_ + kSlope * (places_[id] - pointLps).norm());
    });
    return length;
  }

 private:
  static constexpr double kSlope = 0.25;

  const GuidanceField& size_;
  double shortest_;
  std::vector<Vector3d> places_;
  PointGrid grid_;
};

/// Per group.
using Faults = std::map<std::uint32_t, MeshFaults>;

class SoundMaker {
 public:
  SoundMaker(const SurfaceGround& ground, const Progress& progress)
      : ground_(ground),
        progress_(progress),
        geometry_(ground.field.geometry()),
        parts_(meshComponents(ground.reference.mesh)),
        contour_(ground.reference),
        size_(ground.size, fineMm()) {
    contour_.origin.assign(contour_.patch.size(), FaceOrigin::Contour);
    keepOffCorners();
  }

  SoundSurface run(PatchMesh mesh, SurfaceMethod method, const SurfaceCheck& check) {
    made_.mesh = std::move(mesh);
    if (method == SurfaceMethod::Remesh)
      groupByReference();
    else
      groupByReach(check);
    replaceLacking();
    Faults faults = made_.changed ? findFaults() : findFaults(check);
    if (untangle(faults)) faults = findFaults();
    for (int round = 0; round < 3 * kAttempts && !faults.empty(); ++round) {
      if (!replace(faults)) break;
      faults = findFaults();
    }
    for (auto& [group, found] : faults) {
      locateFaults(made_.mesh.mesh, found);
      made_.groups[group].faults = found.text();
    }
    return std::move(made_);
  }

 private:
  // A triangle of marching cubes keeps its shape where its corners stay off those of its cell; any
  // place between the ends of the grid edge will do.
  void keepOffCorners() {
    for (std::size_t v = 0; v < contour_.mesh.points.size(); ++v) {
      if (!contour_.place[v].wall || contour_.place[v].cut != 0) continue;
      Vector3d index = geometry_.toIndex(contour_.mesh.points[v]);
      int along = -1, between = 0;
      for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(index[axis] - std::round(index[axis])) < 1e-5) continue;
        along = axis;
        ++between;
      }
      if (between != 1) continue;
      const double low = std::floor(index[along]);
      index[along] = low + std::clamp(index[along] - low, kClearOfCorners, 1.0 - kClearOfCorners);
      contour_.mesh.points[v] = geometry_.toPhysical(index);
    }
  }

  void setGroups(std::size_t count, SurfaceMethod method) {
    made_.groups.assign(count, {});
    for (SurfaceGroup& group : made_.groups) group.method = method;
    attempts_.assign(count, 0);
    contour_.group.resize(parts_.label.size());
    for (std::size_t t = 0; t < parts_.label.size(); ++t)
      contour_.group[t] = groupOfPart_[parts_.label[t]];
  }

  void groupByReference() {
    groupOfPart_.resize(parts_.count);
    for (std::uint32_t i = 0; i < parts_.count; ++i) groupOfPart_[i] = i;
    setGroups(parts_.count, SurfaceMethod::Remesh);
    lacking_.assign(parts_.count, 0);
  }

  // Joins the parts of the mesh and the components of the reference that belong together.
  void groupByReach(const SurfaceCheck& check) {
    PatchMesh& mesh = made_.mesh;
    const auto first = static_cast<std::uint32_t>(check.parts.count);
    std::vector<std::uint32_t> partOfPoint(contour_.mesh.points.size(), none);
    for (std::size_t t = 0; t < parts_.label.size(); ++t)
      for (const std::uint32_t v : contour_.mesh.triangles[t]) partOfPoint[v] = parts_.label[t];
    DisjointSets sets(first + parts_.count);
    std::vector<char> missed(parts_.count, 0), much(parts_.count, 0);
    for (const SurfaceCheck::Reached& r : check.reached) {
      const std::uint32_t component = partOfPoint[r.component];
      if (r.part == none) missed[component] = 1;
      if (r.missed > kDetail && 4 * r.missed > r.landmarks) much[component] = 1;
      for (const std::uint32_t part : r.parts) sets.join(part, first + component);
    }
    std::map<std::uint32_t, std::uint32_t> numbers;
    const auto numberOf = [&](std::uint32_t member) {
      return numbers.try_emplace(sets.find(member), static_cast<std::uint32_t>(numbers.size()))
          .first->second;
    };
    mesh.group.resize(mesh.mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.group.size(); ++t)
      mesh.group[t] = numberOf(check.parts.label[t]);
    const std::size_t reached = numbers.size();
    groupOfPart_.resize(parts_.count);
    for (std::uint32_t i = 0; i < parts_.count; ++i) groupOfPart_[i] = numberOf(first + i);
    setGroups(numbers.size(), SurfaceMethod::AdvancingFront);
    lacking_.assign(numbers.size(), 0);
    for (std::uint32_t i = 0; i < parts_.count; ++i)
      if (much[i] != 0 || (missed[i] != 0 && groupOfPart_[i] >= reached))
        lacking_[groupOfPart_[i]] = 1;
  }

  void replaceLacking() {
    std::vector<char> list(made_.groups.size(), 0);
    bool any = false;
    for (std::size_t g = 0; g < list.size(); ++g) {
      if (lacking_[g] == 0) continue;
      made_.groups[g].method = SurfaceMethod::Remesh;
      made_.groups[g].instead = "the front did not reach it, or not all of it";
      list[g] = 1;
      any = true;
    }
    if (any) remake(list);
  }

  // How far a group has come.
  [[nodiscard]] int rank(std::uint32_t group) const {
    return made_.groups[group].method == SurfaceMethod::MarchingCubes ? kAttempts + 1
                                                                      : attempts_[group];
  }

  // Where two groups meet the one that has not come so far is at fault.
  [[nodiscard]] Faults findFaults() const {
    return findFaults(checkManifold(made_.mesh, ground_.border));
  }

  [[nodiscard]] Faults findFaults(const SurfaceCheck& check) const {
    Faults faults;
    const PatchMesh& mesh = made_.mesh;
    for (std::uint32_t t = 0; t < mesh.group.size(); ++t)
      if (!check.components[check.parts.label[t]].why.empty())
        faults[mesh.group[t]].broken.push_back(t);
    for (const auto& pair : selfIntersections(mesh.mesh, progress_)) {
      const std::uint32_t g = mesh.group[pair.first], h = mesh.group[pair.second];
      if (rank(g) <= rank(h)) faults[g].meeting.push_back(pair);
      if (g != h && rank(h) <= rank(g)) faults[h].meeting.push_back(pair);
    }
    return faults;
  }

  // Fills anew where groups of the front meet themselves. True when something was changed.
  bool untangle(const Faults& faults) {
    bool changed = false;
    std::vector<std::uint32_t> list;
    for (const auto& [group, found] : faults)
      if (made_.groups[group].method == SurfaceMethod::AdvancingFront && found.broken.empty())
        list.push_back(group);
    for (const std::uint32_t group : list) changed = untangle(group) || changed;
    return changed;
  }

  bool untangle(std::uint32_t group) {
    PatchMesh& mesh = made_.mesh;
    PatchMesh piece =
        selectTriangles(mesh, [&](std::uint32_t t) { return mesh.group[t] == group; });
    piece.group.clear();
    constexpr int attempts = 6, improved = 3;
    std::vector<std::uint32_t> meeting = meetingIn(piece);
    if (meeting.empty() || kFewMeet * meeting.size() > piece.patch.size() + 20 * kFewMeet)
      return false;
    for (int n = 0; n < attempts && !meeting.empty(); ++n) {
      if (!mendMesh(piece, meeting, n, ground_.field)) continue;
      // What improving ties up again stays as it was filled.
      if (n < improved)
        improveTriangles(piece, ground_.field, ground_.size, ground_.ends, progress_);
      meeting = meetingIn(piece);
    }
    if (!meeting.empty()) return false;
    piece.group.assign(piece.patch.size(), group);
    mesh = selectTriangles(mesh, [&](std::uint32_t t) { return mesh.group[t] != group; });
    append(mesh, piece);
    made_.changed = true;
    return true;
  }

  [[nodiscard]] std::vector<std::uint32_t> meetingIn(const PatchMesh& mesh) const {
    std::vector<std::uint32_t> found;
    for (const auto& [a, b] : selfIntersections(mesh.mesh, progress_))
      found.insert(found.end(), {a, b});
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  // Makes each group that has faults by the next method; false where none has one left.
  bool replace(Faults& faults) {
    std::vector<char> list(made_.groups.size(), 0);
    std::vector<std::size_t> triangles(list.size(), 0);
    for (const std::uint32_t group : made_.mesh.group) ++triangles[group];
    bool any = false;
    for (auto& [group, found] : faults) {
      SurfaceGroup& g = made_.groups[group];
      if (g.method == SurfaceMethod::MarchingCubes) continue;
      if (g.instead.empty()) {
        locateFaults(made_.mesh.mesh, found);
        g.instead =
            (g.method == SurfaceMethod::Remesh ? "remeshed it " : "the front's ") + found.text();
      }
      const bool remeshed = g.method == SurfaceMethod::Remesh;
      g.method = SurfaceMethod::Remesh;
      if (remeshed && edgesAt(found) > 1.5 * fineMm()) {
        refine(found);
      } else if (remeshed) {
        // The front's faults say little of where a remeshed surface has some.
        hold(found, attempts_[group]);
        if (kManyMeet * found.meeting.size() > triangles[group]) attempts_[group] = kAttempts;
      }
      if (attempts_[group]++ >= kAttempts) g.method = SurfaceMethod::MarchingCubes;
      list[group] = any = true;
    }
    if (any) remake(list);
    return any;
  }

  /// Edges that follow any bend that the grid can hold.
  [[nodiscard]] double fineMm() const { return kFineVoxels * geometry_.voxelMm(); }

  // The mean of the longest edges of the triangles that meet, mm.
  [[nodiscard]] double edgesAt(const MeshFaults& faults) const {
    double sum = 0.0;
    for (const auto& pair : faults.meeting)
      for (const std::uint32_t t : {pair.first, pair.second}) {
        const auto c = cornersOf(made_.mesh.mesh, t);
        sum += std::max({(c[1] - c[0]).norm(), (c[2] - c[1]).norm(), (c[0] - c[2]).norm()});
      }
    return faults.meeting.empty() ? 0.0 : 0.5 * sum / static_cast<double>(faults.meeting.size());
  }

  // Asks for shorter edges where triangles meet.
  void refine(const MeshFaults& faults) {
    std::vector<std::uint32_t> meeting;
    for (const auto& [a, b] : faults.meeting) meeting.insert(meeting.end(), {a, b});
    std::sort(meeting.begin(), meeting.end());
    meeting.erase(std::unique(meeting.begin(), meeting.end()), meeting.end());
    for (const std::uint32_t t : meeting) {
      const auto c = cornersOf(made_.mesh.mesh, t);
      size_.add((c[0] + c[1] + c[2]) / 3.0);
    }
  }

  // Marks the cells around the faults.
  void hold(const MeshFaults& faults, int margin) {
    const Index3& size = geometry_.size;
    held_.resize(geometry_.voxelCount(), 0);
    const auto mark = [&](std::uint32_t t) {
      Vector3d low = Vector3d::Constant(1e300), high = -low;
      for (const std::uint32_t v : made_.mesh.mesh.triangles[t]) {
        const Vector3d index = geometry_.toIndex(made_.mesh.mesh.points[v]);
        low = low.cwiseMin(index);
        high = high.cwiseMax(index);
      }
      Index3 from{}, to{};
      for (std::size_t a = 0; a < 3; ++a) {
        const auto axis = static_cast<Eigen::Index>(a);
        from[a] = std::clamp(static_cast<int>(low[axis]) - margin, 0, size[a] - 1);
        to[a] = std::clamp(static_cast<int>(high[axis]) + margin, 0, size[a] - 1);
      }
      for (int k = from[2]; k <= to[2]; ++k)
        for (int j = from[1]; j <= to[1]; ++j)
          for (int i = from[0]; i <= to[0]; ++i) held_[geometry_.offset(i, j, k)] = 1;
    };
    for (const auto& [a, b] : faults.meeting) {
      mark(a);
      mark(b);
    }
  }

  [[nodiscard]] std::vector<char> heldOf(const PatchMesh& start) const {
    std::vector<char> held;
    if (held_.empty()) return held;
    held.resize(start.mesh.points.size(), 0);
    for (std::size_t v = 0; v < held.size(); ++v) {
      const Vector3d index = geometry_.toIndex(start.mesh.points[v]);
      Index3 cell{};
      for (std::size_t a = 0; a < 3; ++a)
        cell[a] = std::clamp(static_cast<int>(index[static_cast<Eigen::Index>(a)] + 1e-9), 0,
                             geometry_.size[a] - 1);
      held[v] = held_[geometry_.offset(cell[0], cell[1], cell[2])];
    }
    return held;
  }

  // The listed groups anew, by the methods that they have now.
  void remake(const std::vector<char>& list) {
    PatchMesh& mesh = made_.mesh;
    noteLost(list);
    made_.changed = true;
    mesh = selectTriangles(mesh, [&](std::uint32_t t) { return list[mesh.group[t]] == 0; });
    const auto pick = [&](SurfaceMethod method) {
      return selectTriangles(contour_, [&](std::uint32_t t) {
        const std::uint32_t g = contour_.group[t];
        return list[g] != 0 && made_.groups[g].method == method;
      });
    };
    const PatchMesh start = pick(SurfaceMethod::Remesh);
    if (!start.patch.empty())
      append(mesh, remesh(start, ground_.field, size_, ground_.ends, progress_, heldOf(start)));
    append(mesh, pick(SurfaceMethod::MarchingCubes));
  }

  // Groups that no component of the reference belongs to cannot be made anew.
  void noteLost(const std::vector<char>& list) {
    std::vector<char> known(list.size(), 0);
    for (const std::uint32_t group : groupOfPart_) known[group] = 1;
    for (std::size_t t = 0; t < made_.mesh.group.size(); ++t) {
      const std::uint32_t group = made_.mesh.group[t];
      if (list[group] == 0 || known[group] != 0) continue;
      known[group] = 1;
      const std::uint32_t corner = made_.mesh.mesh.triangles[t][0];
      made_.dropped.push_back("a speck of the zero set between the voxels that meets itself or " +
                              std::string("another part, near ") +
                              placeText(made_.mesh.mesh.points[corner]));
    }
  }

  const SurfaceGround& ground_;
  const Progress& progress_;
  const Geometry& geometry_;
  MeshComponents parts_;  ///< of the reference
  PatchMesh contour_;     ///< the reference, off the corners, with groups
  FineSize size_;
  std::vector<std::uint32_t> groupOfPart_;
  std::vector<char> lacking_;  ///< per group
  std::vector<int> attempts_;  ///< per group, by remeshing
  std::vector<char> held_;     ///< per voxel: the reference's triangles of the cell stay
  SoundSurface made_;
};

}  // namespace

SoundSurface makeSound(PatchMesh mesh, SurfaceMethod method, const SurfaceCheck& check,
                       const SurfaceGround& ground, const Progress& progress) {
  return SoundMaker(ground, progress).run(std::move(mesh), method, check);
}

}  // namespace angiomesh
