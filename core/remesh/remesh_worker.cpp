// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh_worker.h"

#include <algorithm>
#include <queue>

#include "core/base/parallel.h"
#include "core/remesh/remesh_shape.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 512;
constexpr double good = 0.97;          ///< nothing to be gained below this badness
constexpr double leastGain = 0.98;     ///< of the summed badness, what a change may leave
constexpr double worthMoving = 0.6;    ///< badness around a vertex that a search may better
constexpr double smallestGain = 1e-4;  ///< of a search's step, so that it ends
// The steps of a search, of the wanted length: from well within a triangle down to what no angle
// notices.
constexpr double firstStep = 0.16, lastStep = 0.004;
constexpr double leastEdge = 0.6, greatestEdge = 1.6;  ///< that a change may leave, wanted lengths
// What repair() may look at, in triangles for each of the mesh: enough for all that can be mended,
// and some more in a small mesh. Less where a twentieth and more is bad, as on a wall of noise.
constexpr std::size_t effortEach = 100, hopelessEffortEach = 20;
constexpr std::size_t moreEach = 3000, mostMore = 3000000;
constexpr std::size_t partlyShare = 8, foldShare = 8;  ///< of that with held parts, and for folds
constexpr double freeLanding = 0.05;                   ///< wanted lengths that no triangle notices
constexpr double landedBadness = 1.1;

}  // namespace

bool RemeshWorker::Merit::betterThan(const Merit& other) const {
  constexpr double thirtyDegrees = 1.14;  // badness
  if (worst > other.worst + 1e-9) return false;
  // No fold is worth a bad angle.
  if (worstShape > thirtyDegrees && worstShape > other.worstShape + 1e-9) return false;
  if (shortest < leastEdge && shortest < other.shortest - 1e-9) return false;
  if (longest > greatestEdge && longest > other.longest + 1e-9) return false;
  return sum < leastGain * other.sum;
}

// The corners of t and the vertices across its sides; at higher levels rings around them.
std::vector<std::uint32_t> RemeshWorker::around(std::uint32_t t, int level) const {
  std::vector<std::uint32_t> found;
  const auto add = [&](std::uint32_t v) {
    if (std::find(found.begin(), found.end(), v) == found.end()) found.push_back(v);
  };
  for (std::uint32_t k = 0; k < 3; ++k) add(mesh_.origin(3 * t + k));
  for (std::uint32_t k = 0; k < 3; ++k) {
    const std::uint32_t o = mesh_.twin(3 * t + k);
    if (o != EditMesh::none) add(mesh_.apex(o));
  }
  for (int ring = 0; ring < level; ++ring) {
    const std::size_t size = ring == 0 ? 3 : found.size();
    for (std::size_t i = 0; i < size; ++i) {
      const Ring r = mesh_.ring(found[i]);
      for (std::uint32_t k = 0; k < r.count; ++k) add(r.vertex[k]);
    }
  }
  return found;
}

void RemeshWorker::facesOf(const std::vector<std::uint32_t>& vertices,
                           std::vector<std::uint32_t>& faces) {
  marks_.resize(mesh_.halfEdgeSlots() / 3, 0);
  ++mark_;
  faces.clear();
  for (const std::uint32_t v : vertices) {
    if (!mesh_.livesVertex(v)) continue;
    const std::uint32_t start = mesh_.leaving(v);
    std::uint32_t h = start;
    do {
      if (marks_[h / 3] != mark_) {
        marks_[h / 3] = mark_;
        faces.push_back(h / 3);
      }
      h = mesh_.twin(EditMesh::previous(h));
    } while (h != EditMesh::none && h != start);
  }
}

RemeshWorker::Merit RemeshWorker::merit(const std::vector<std::uint32_t>& vertices) {
  facesOf(vertices, faces_);
  Merit m;
  for (const std::uint32_t t : faces_) {
    const double bad = faceBadness(t);
    m.worst = std::max(m.worst, bad);
    if (bad > m.worstShape) m.worstShape = std::max(m.worstShape, shapeBadness(t));
    if (bad > good) m.sum += (bad - good) * (bad - good);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double s = stretch(3 * t + k);
      m.shortest = std::min(m.shortest, s);
      m.longest = std::max(m.longest, s);
    }
  }
  return m;
}

double RemeshWorker::ringBadness(const Ring& ring, const Vector3d& point) {
  effort_ += ring.triangles();
  double worst = 0.0;
  for (std::uint32_t i = 0; i < ring.triangles(); ++i)
    worst = std::max(worst, remeshing::badness(point, mesh_.point(ring.vertex[i]),
                                               mesh_.point(ring.vertex[ring.after(i)])));
  return worst;
}

// Moves v, which is free to, to where the worst triangle around it is best: a pattern search along
// the surface.
bool RemeshWorker::relocate(std::uint32_t v) {
  const int free = freedom(v);
  const Ring ring = mesh_.ring(v);
  const Vector3d start = mesh_.point(v), n = mesh_.normal(v);
  const double g = mesh_.size(v);
  Vector3d best = start;
  double worst = ringBadness(ring, start);
  if (worst < worthMoving) return false;
  const double before = worst;
  Vector3d t1 = n.unitOrthogonal();
  if (free == 1) {
    t1 = ground_.along(mesh_.place(v), n, mesh_.point(ring.vertex[0]) - start);
    if (!(t1.norm() > 1e-9)) return false;
    t1.normalize();
  }
  const Vector3d t2 = n.cross(t1);
  constexpr double c = 0.5, s = 0.8660254037844386;
  const std::array<Vector3d, 6> ways{
      t1, c * t1 + s * t2, -c * t1 + s * t2, Vector3d(-t1), -c * t1 - s * t2, c * t1 - s * t2};
  for (double length = firstStep * g; length > lastStep * g;) {
    bool moved = false;
    for (std::size_t i = 0; i < 6; i += free == 1 ? 3 : 1) {
      const Vector3d point = best + length * ways[i];
      const double value = ringBadness(ring, point);
      if (value < worst - smallestGain) {
        worst = value;
        best = point;
        moved = true;
        break;
      }
    }
    if (!moved) length *= 0.5;
  }
  if (best == start) return false;
  Vector3d normal = n;
  if (!ground_.land(mesh_.place(v), best, normal, 2) || !ground_.allows(v, normal)) return false;
  if (ringBadness(ring, best) > before - smallestGain) return false;
  if (!ringAgrees(v, ring, best, kChosenAgreement) && ringAgrees(v, ring, start, kChosenAgreement))
    return false;
  mesh_.set(v, best, normal, ground_.sizeAt(v, best));
  return true;
}

// Flips and relocations among `vertices`.
void RemeshWorker::settle(const std::vector<std::uint32_t>& vertices, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    facesOf(vertices, faces_);
    for (const std::uint32_t t : faces_)
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const std::uint32_t o = mesh_.twin(h);
        if (o == EditMesh::none || marks_[o / 3] != mark_ || !worthFlipping(h, FlipBy::Shape))
          continue;
        mesh_.flip(h);
        changed = true;
      }
    for (const std::uint32_t v : vertices) {
      if (!mesh_.livesVertex(v) || freedom(v) == 0) continue;
      if (round == 0) relaxVertex(v);
      changed = relocate(v) || changed;
    }
    if (!changed) break;
  }
}

bool RemeshWorker::apply(const Move& move, std::vector<std::uint32_t>& vertices) {
  switch (move.kind) {
    case Kind::Relocate:
      return true;
    case Kind::Flip:
      if (!mesh_.canFlip(move.side)) return false;
      mesh_.flip(move.side);
      return true;
    case Kind::Collapse:
      return collapseEdge(move.side, greatestEdge);
    case Kind::Split: {
      const std::uint32_t m = splitEdge(move.side);
      if (m == EditMesh::none) return false;
      vertices.push_back(m);
      return true;
    }
  }
  return false;
}

std::vector<RemeshWorker::Move> RemeshWorker::movesFor(std::uint32_t t, int level) const {
  std::array<std::uint32_t, 3> sides{3 * t, 3 * t + 1, 3 * t + 2};
  std::stable_sort(sides.begin(), sides.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return stretch(a) < stretch(b); });
  std::vector<Move> moves{{Kind::Relocate, 0}};
  const auto add = [&](Kind kind, std::uint32_t side) {
    if (kind == Kind::Flip || edits_ == Edits::All) moves.push_back({kind, side});
  };
  add(Kind::Flip, sides[2]);
  add(Kind::Flip, sides[1]);
  add(Kind::Collapse, sides[0]);
  add(Kind::Split, sides[2]);
  if (level == 0) return moves;
  add(Kind::Flip, sides[0]);
  add(Kind::Collapse, sides[1]);
  add(Kind::Split, sides[1]);
  add(Kind::Collapse, sides[2]);
  add(Kind::Split, sides[0]);
  // The sides of the triangles around.
  std::vector<std::uint32_t> more;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const Ring ring = mesh_.ring(mesh_.origin(3 * t + k));
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      if (ring.side[i] != EditMesh::none && ring.side[i] / 3 != t) more.push_back(ring.side[i]);
      const std::uint32_t h = mesh_.edgeBetween(mesh_.origin(3 * t + k), ring.vertex[i]);
      if (h / 3 != t && (mesh_.twin(h) == EditMesh::none || mesh_.twin(h) / 3 != t))
        more.push_back(h);
    }
  }
  for (const std::uint32_t h : more) {
    const double s = stretch(h);
    add(Kind::Flip, h);
    if (s < 1.0) add(Kind::Collapse, h);
    if (s > 1.0) add(Kind::Split, h);
  }
  return moves;
}

// Tries one change after the other around t, each followed by flips and relocation, and keeps the
// first that leaves nothing bad, else the best. True when something was kept.
bool RemeshWorker::work(std::uint32_t t, int level, std::size_t quota) {
  const std::size_t limit = effort_ + quota;
  const std::vector<std::uint32_t> region = around(t, level);
  const Merit before = merit(region);
  const int rounds = level + 2;
  Merit best = before;
  Move bestMove{Kind::Relocate, EditMesh::none};
  bool any = false;
  const auto attempt = [&](const Move& move) {
    touched_ = region;
    mesh_.beginTrial();
    if (!apply(move, touched_)) return false;
    settle(touched_, rounds);
    return true;
  };
  for (const Move& move : movesFor(t, level)) {
    if (effort_ > limit) break;
    const bool done = attempt(move);
    if (!done) {
      mesh_.takeBack();
      continue;
    }
    const Merit after = merit(touched_);
    if (after.betterThan(before) && !(after.sum > 0.0)) {
      mesh_.keep();
      return true;
    }
    if (after.betterThan(best)) {
      best = after;
      bestMove = move;
      any = true;
    }
    mesh_.takeBack();
  }
  if (!any) return false;
  attempt(bestMove);
  mesh_.keep();
  return true;
}

std::vector<RemeshWorker::Job> RemeshWorker::badFaces() const {
  constexpr std::size_t blockSize = 2048;
  const std::size_t count = mesh_.halfEdgeSlots() / 3;
  std::vector<std::vector<Job>> found((count + blockSize - 1) / blockSize);
  parallelForEach(count, blockSize, [&](std::size_t i) {
    const auto t = static_cast<std::uint32_t>(i);
    if (!mesh_.lives(t)) return;
    if (mesh_.locked(mesh_.origin(3 * t)) && mesh_.locked(mesh_.origin(3 * t + 1)) &&
        mesh_.locked(mesh_.origin(3 * t + 2)))
      return;
    const double bad = faceBadness(t);
    if (bad > 1.0) found[i / blockSize].push_back({bad, t});
  });
  std::vector<Job> all;
  for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
  return all;
}

// Worst first; what did not give way is tried again with more of its surroundings.
void RemeshWorker::repair() {
  for (int level = 0; level < 3; ++level) {
    const std::vector<Job> start = badFaces();
    if (start.empty()) return;
    std::priority_queue<Job> queue(std::less<Job>(), start);
    // What cannot be made good, as on a wall of noise, must not take for ever; least of all folds,
    // which mostly lie where the wall has a crease that no triangle can follow. Counted in
    // triangles looked at.
    const std::size_t faces = mesh_.halfEdgeSlots() / 3;
    const bool hopeless = 20 * start.size() > faces + 1000;
    if (hopeless && level > 0) return;
    // Held triangles are none that could be made good; those beside them mostly neither.
    std::size_t quota = ((hopeless ? hopelessEffortEach : effortEach) * faces +
                         std::min(moreEach * faces, mostMore)) /
                        (partly_ ? partlyShare : 1);
    std::size_t foldQuota = quota / foldShare;
    while (!queue.empty()) {
      progress_.check();
      const Job job = queue.top();
      queue.pop();
      if (!mesh_.lives(job.triangle)) continue;
      const double bad = faceBadness(job.triangle);
      if (bad <= 1.0) continue;
      if (bad < job.badness - 1e-9) {
        queue.push({bad, job.triangle});
        continue;
      }
      std::size_t& left = shapeBadness(job.triangle) > 1.0 ? quota : foldQuota;
      if (left == 0) continue;
      const std::size_t before = effort_;
      const bool better = work(job.triangle, level, left);
      left -= std::min(left, effort_ - before);
      if (!better) continue;
      facesOf(touched_, faces_);
      for (const std::uint32_t t : faces_) {
        const double now = faceBadness(t);
        if (now > 1.0) queue.push({now, t});
      }
    }
  }
}

void RemeshWorker::finish() {
  std::vector<char> far(mesh_.vertexSlots(), 0);
  parallelForEach(mesh_.vertexSlots(), blockSize, progress_, [&](std::size_t i) {
    const auto v = static_cast<std::uint32_t>(i);
    if (!mesh_.livesVertex(v) || freedom(v) == 0) return;
    Vector3d point = mesh_.point(v), normal = mesh_.normal(v);
    const bool landed = ground_.land(mesh_.place(v), point, normal, 20);
    const double moved = (point - mesh_.point(v)).norm();
    if (landed && moved < freeLanding * mesh_.size(v)) {
      mesh_.set(v, point, normal, mesh_.size(v));
    } else {
      far[v] = 1;
    }
  });
  // The rest only where no triangle turns over or loses its shape; one by one, as they depend on
  // each other.
  for (std::uint32_t v = 0; v < mesh_.vertexSlots(); ++v) {
    if (far[v] == 0) continue;
    Vector3d point = mesh_.point(v), normal = mesh_.normal(v);
    const Ring ring = mesh_.ring(v);
    if (ground_.land(mesh_.place(v), point, normal, 50) &&
        ringAgrees(v, ring, point, kLeastAgreement) &&
        ringBadness(ring, point) < std::max(landedBadness, ringBadness(ring, mesh_.point(v))))
      mesh_.set(v, point, normal, ground_.sizeAt(v, point));
  }
}

}  // namespace angiomesh
