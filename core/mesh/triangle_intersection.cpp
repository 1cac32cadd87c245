// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/triangle_intersection.h"

#include "core/mesh/predicates.h"

namespace angiomesh {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Triangle2 = std::array<Vector2d, 3>;

Vector2d without(const Vector3d& p, int axis) { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

Triangle2 without(const Triangle3& t, int axis) {
  return {without(t[0], axis), without(t[1], axis), without(t[2], axis)};
}

// An axis along which the triangle does not project to a line; 3 when it is degenerate.
int projectionAxis(const Triangle3& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const Triangle2 p = without(t, axis);
    if (orient2d(p[0], p[1], p[2]) != 0) return axis;
  }
  return 3;
}

bool sameStrictSide(int a, int b, int c) { return a == b && b == c && a != 0; }

bool mixed(int a, int b, int c) { return (a > 0 || b > 0 || c > 0) && (a < 0 || b < 0 || c < 0); }

bool contains(const Triangle2& t, const Vector2d& p) {
  return !mixed(orient2d(t[0], t[1], p), orient2d(t[1], t[2], p), orient2d(t[2], t[0], p));
}

// For p collinear with (a, b).
bool between(const Vector2d& a, const Vector2d& b, const Vector2d& p) {
  const auto within = [](double low, double high, double x) {
    return low <= high ? low <= x && x <= high : high <= x && x <= low;
  };
  return within(a.x(), b.x(), p.x()) && within(a.y(), b.y(), p.y());
}

bool segmentsMeet(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const int cSide = orient2d(a, b, c), dSide = orient2d(a, b, d);
  const int aSide = orient2d(c, d, a), bSide = orient2d(c, d, b);
  if (cSide * dSide < 0 && aSide * bSide < 0) return true;
  return (cSide == 0 && between(a, b, c)) || (dSide == 0 && between(a, b, d)) ||
         (aSide == 0 && between(c, d, a)) || (bSide == 0 && between(c, d, b));
}

bool segmentMeetsTriangle(const Vector2d& a, const Vector2d& b, const Triangle2& t) {
  return contains(t, a) || contains(t, b) || segmentsMeet(a, b, t[0], t[1]) ||
         segmentsMeet(a, b, t[1], t[2]) || segmentsMeet(a, b, t[2], t[0]);
}

bool segmentMeetsTriangle(const Vector3d& a, const Vector3d& b, const Triangle3& t) {
  const int aSide = orient3d(t[0], t[1], t[2], a), bSide = orient3d(t[0], t[1], t[2], b);
  if (aSide * bSide > 0) return false;
  if (aSide == 0 && bSide == 0) {
    const int axis = projectionAxis(t);
    return segmentMeetsTriangle(without(a, axis), without(b, axis), without(t, axis));
  }
  return !mixed(orient3d(a, b, t[0], t[1]), orient3d(a, b, t[1], t[2]), orient3d(a, b, t[2], t[0]));
}

bool coplanarTrianglesMeet(const Triangle3& s, const Triangle3& t) {
  const int axis = projectionAxis(t);
  const Triangle2 p = without(s, axis), q = without(t, axis);
  return contains(p, q[0]) || segmentMeetsTriangle(p[0], p[1], q) ||
         segmentMeetsTriangle(p[1], p[2], q) || segmentMeetsTriangle(p[2], p[0], q);
}

}  // namespace

bool isDegenerate(const Triangle3& t) { return projectionAxis(t) == 3; }

bool trianglesMeet(const Triangle3& s, const Triangle3& t) {
  const int t0 = orient3d(s[0], s[1], s[2], t[0]), t1 = orient3d(s[0], s[1], s[2], t[1]),
            t2 = orient3d(s[0], s[1], s[2], t[2]);
  if (sameStrictSide(t0, t1, t2)) return false;
  if (t0 == 0 && t1 == 0 && t2 == 0) return coplanarTrianglesMeet(s, t);
  for (std::size_t k = 0; k < 3; ++k) {
    if (segmentMeetsTriangle(s[k], s[(k + 1) % 3], t)) return true;
    if (segmentMeetsTriangle(t[k], t[(k + 1) % 3], s)) return true;
  }
  return false;
}

bool trianglesMeetBeyondCorner(const Triangle3& s, const Triangle3& t) {
  const int t1 = orient3d(s[0], s[1], s[2], t[1]), t2 = orient3d(s[0], s[1], s[2], t[2]);
  if (t1 * t2 > 0) return false;
  // What the triangles have in common is convex: if it is more than the corner, then it reaches
  // the far edge of one of them.
  return segmentMeetsTriangle(s[1], s[2], t) || segmentMeetsTriangle(t[1], t[2], s);
}

bool trianglesMeetBeyondEdge(const Triangle3& s, const Vector3d& apex) {
  if (orient3d(s[0], s[1], s[2], apex) != 0) return false;
  const int axis = projectionAxis(s);
  const Triangle2 p = without(s, axis);
  return orient2d(p[0], p[1], p[2]) == orient2d(p[0], p[1], without(apex, axis));
}

}  // namespace angiomesh
