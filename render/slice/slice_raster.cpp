// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/statistics.h"

namespace angiomesh {

namespace {

std::size_t at(int axis) { return static_cast<std::size_t>(axis); }

/// Trilinear value; NaN outside the outermost voxel centres (with a rounding tolerance).
float sample(const Volume<float>& volume, const Eigen::Vector3d& index) {
  constexpr double tolerance = 1e-6;
  for (int axis = 0; axis < 3; ++axis)
    if (!(index[axis] >= -tolerance &&
          index[axis] <= volume.geometry.size[at(axis)] - 1 + tolerance))
      return std::numeric_limits<float>::quiet_NaN();
  return static_cast<float>(interpolateLinear(volume, index));
}

/// A lattice of samples of phi in the plane: corner and step in the plane's mm.
struct Lattice {
  Eigen::Vector2d corner{0.0, 0.0}, step{1.0, 1.0};
  int columns = 0, rows = 0;
  std::vector<float> values;
};

Lattice sampleLattice(const Volume<float>& phi, const SlicePlane& plane) {
  Lattice lattice;
  const Geometry& g = phi.geometry;
  Eigen::Vector2d low(1e300, 1e300);
  Eigen::Vector2d high(-1e300, -1e300);
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) ? g.size[0] - 1 : 0, (corner & 2) ? g.size[1] - 1 : 0,
                                (corner & 4) ? g.size[2] - 1 : 0);
    const Eigen::Vector2d xy = plane.fromLps(g.toPhysical(index)).head<2>();
    low = low.cwiseMin(xy);
    high = high.cwiseMax(xy);
  }
  // Pixel centres belong to the lattice, so that phi on the image's own grid is read as it is.
  const Eigen::Vector2d pixel(plane.pixelWidthMm(), plane.pixelHeightMm());
  const Eigen::Vector2d imageHigh(pixel[0] * (plane.width() - 1), pixel[1] * (plane.height() - 1));
  std::array<int, 2> count{};
  for (int a = 0; a < 2; ++a) {
    const double fine = std::clamp(std::ceil(pixel[a] / g.voxelMm() - 1e-3), 1.0, 4.0);
    lattice.step[a] = pixel[a] / fine;
    const double from = std::ceil(std::max(low[a], 0.0) / lattice.step[a] - 1e-6);
    const double to = std::floor(std::min(high[a], imageHigh[a]) / lattice.step[a] + 1e-6);
    lattice.corner[a] = from * lattice.step[a];
    count[at(a)] = std::max(0, static_cast<int>(to - from) + 1);
  }
  lattice.columns = count[0];
  lattice.rows = count[1];
  lattice.values.resize(static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]));

  const auto indexOf = [&](double x, double y) { return g.toIndex(plane.toLps({x, y})); };
  const Eigen::Vector3d origin = indexOf(lattice.corner[0], lattice.corner[1]);
  const Eigen::Vector3d right =
      indexOf(lattice.corner[0] + lattice.step[0], lattice.corner[1]) - origin;
  const Eigen::Vector3d up =
      indexOf(lattice.corner[0], lattice.corner[1] + lattice.step[1]) - origin;
  float* value = lattice.values.data();
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column)
      *value++ = sample(phi, origin + column * right + row * up);
  return lattice;
}

/// Marching squares in one cell: corners 0..3 counter-clockwise from the lower left.
void cellSegments(const std::array<float, 4>& v, const Eigen::Vector2d& corner,
                  const Eigen::Vector2d& step,
                  std::vector<std::array<Eigen::Vector2d, 2>>& segments) {
  constexpr std::array<std::array<double, 2>, 4> offset{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  std::array<Eigen::Vector2d, 4> crossing;
  std::array<int, 4> edges{};
  int count = 0;
  for (int edge = 0; edge < 4; ++edge) {
    const auto from = at(edge);
    const auto to = at((edge + 1) % 4);
    if ((v[from] < 0.0F) == (v[to] < 0.0F)) continue;
    const double t = static_cast<double>(v[from]) / (static_cast<double>(v[from]) - v[to]);
    const Eigen::Vector2d a(offset[from][0], offset[from][1]);
    const Eigen::Vector2d b(offset[to][0], offset[to][1]);
    crossing[at(count)] = corner + step.cwiseProduct(a + t * (b - a));
    edges[at(count++)] = edge;
  }
  if (count == 2) segments.push_back({crossing[0], crossing[1]});
  if (count == 4) {
    // Saddle: the value in the middle decides which corners belong together.
    const bool middleInside = v[0] + v[1] + v[2] + v[3] < 0.0F;
    const bool joinAroundCorner0 = (v[0] < 0.0F) != middleInside;
    if (joinAroundCorner0) {
      segments.push_back({crossing[0], crossing[3]});
      segments.push_back({crossing[1], crossing[2]});
    } else {
      segments.push_back({crossing[0], crossing[1]});
      segments.push_back({crossing[2], crossing[3]});
    }
  }
}

}  // namespace

SlicePlane::SlicePlane(const Geometry& geometry, const PaneAxes& axes, int slice)
    : geometry_(geometry),
      axes_(axes),
      slice_(slice),
      width_(geometry.size[at(axes.right)]),
      height_(geometry.size[at(axes.up)]),
      pixelWidth_(geometry.spacing[axes.right]),
      pixelHeight_(geometry.spacing[axes.up]) {}

Eigen::Vector3d SlicePlane::toLps(const Eigen::Vector2d& xy) const {
  Eigen::Vector3d index;
  const double right = xy[0] / pixelWidth_;
  const double up = xy[1] / pixelHeight_;
  index[axes_.right] = axes_.rightFlipped ? width_ - 1 - right : right;
  index[axes_.up] = axes_.upFlipped ? height_ - 1 - up : up;
  index[axes_.across] = slice_;
  return geometry_.toPhysical(index);
}

Eigen::Vector3d SlicePlane::fromLps(const Eigen::Vector3d& lps) const {
  const Eigen::Vector3d index = geometry_.toIndex(lps);
  const double right = axes_.rightFlipped ? width_ - 1 - index[axes_.right] : index[axes_.right];
  const double up = axes_.upFlipped ? height_ - 1 - index[axes_.up] : index[axes_.up];
  return {right * pixelWidth_, up * pixelHeight_, index[axes_.across] - slice_};
}

std::vector<std::array<Eigen::Vector2d, 2>> zeroContour(const Volume<float>& phi,
                                                        const SlicePlane& plane) {
  std::vector<std::array<Eigen::Vector2d, 2>> segments;
  if (phi.voxels.empty() || plane.width() == 0) return segments;
  const Lattice lattice = sampleLattice(phi, plane);
  const auto columns = static_cast<std::size_t>(lattice.columns);
  for (int row = 0; row + 1 < lattice.rows; ++row)
    for (int column = 0; column + 1 < lattice.columns; ++column) {
      const std::size_t p = at(row) * columns + at(column);
      const std::array<float, 4> v{lattice.values[p], lattice.values[p + 1],
                                   lattice.values[p + columns + 1], lattice.values[p + columns]};
      const int inside = (v[0] < 0.0F) + (v[1] < 0.0F) + (v[2] < 0.0F) + (v[3] < 0.0F);
      if (inside == 0 || inside == 4) continue;
      if (std::isnan(v[0] + v[1] + v[2] + v[3])) continue;
      cellSegments(v, lattice.corner + lattice.step.cwiseProduct(Eigen::Vector2d(column, row)),
                   lattice.step, segments);
    }
  return segments;
}

namespace {

/// The part of a slice in which depthOf(side, lps) is not negative for any of six sides, in order
/// around it.
template <class Depth>
std::vector<Eigen::Vector2d> sectionOf(const SlicePlane& plane, const Depth& depthOf) {
  const double far =
      10.0 * (plane.width() * plane.pixelWidthMm() + plane.height() * plane.pixelHeightMm() + 1.0);
  std::vector<Eigen::Vector2d> polygon{{-far, -far}, {far, -far}, {far, far}, {-far, far}};
  for (int side = 0; side < 6; ++side) {
    const auto depth = [&](const Eigen::Vector2d& xy) { return depthOf(side, plane.toLps(xy)); };
    std::vector<Eigen::Vector2d> clipped;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Eigen::Vector2d& a = polygon[k];
      const Eigen::Vector2d& b = polygon[(k + 1) % polygon.size()];
      const double da = depth(a);
      const double db = depth(b);
      if (da >= 0.0) clipped.push_back(a);
      if ((da >= 0.0) != (db >= 0.0)) clipped.emplace_back(a + da / (da - db) * (b - a));
    }
    polygon = std::move(clipped);
  }
  return polygon;
}

}  // namespace

std::vector<Eigen::Vector2d> boxSection(const RoiBox& box, const SlicePlane& plane) {
  return sectionOf(plane, [&](int side, const Eigen::Vector3d& lps) {
    return (side < 3 ? 1.0 : -1.0) * (lps[side % 3] - box[at(side)]);
  });
}

std::vector<Eigen::Vector2d> gridSection(const Geometry& grid, const SlicePlane& plane) {
  return sectionOf(plane, [&](int side, const Eigen::Vector3d& lps) {
    const double index = grid.toIndex(lps)[side % 3];
    return side < 3 ? index + 0.5 : grid.size[at(side % 3)] - 0.5 - index;
  });
}

std::optional<RoiBox> boxBetween(RoiBox box, const RoiBox& whole, int plane,
                                 const Eigen::Vector3d& corner, const Eigen::Vector3d& other) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == plane) continue;
    const std::size_t a = at(axis);
    box[a] = std::clamp(std::min(corner[axis], other[axis]), whole[a], whole[a + 3]);
    box[a + 3] = std::clamp(std::max(corner[axis], other[axis]), whole[a], whole[a + 3]);
    if (!(box[a + 3] > box[a])) return std::nullopt;
  }
  return box;
}

RoiBox volumeBox(const Geometry& geometry) {
  Eigen::Vector3d low(1e300, 1e300, 1e300);
  Eigen::Vector3d high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d index((corner & 1) ? geometry.size[0] - 0.5 : -0.5,
                                (corner & 2) ? geometry.size[1] - 0.5 : -0.5,
                                (corner & 4) ? geometry.size[2] - 0.5 : -0.5);
    const Eigen::Vector3d lps = geometry.toPhysical(index);
    low = low.cwiseMin(lps);
    high = high.cwiseMax(lps);
  }
  return {low[0], low[1], low[2], high[0], high[1], high[2]};
}

std::array<double, 2> displayRange(const Volume<float>& image, double low, double high) {
  constexpr std::size_t wanted = 100000;
  // An odd stride does not fall in step with the rows, whose lengths are mostly even.
  const std::size_t stride = std::max<std::size_t>(1, image.voxels.size() / wanted) | 1;
  std::vector<float> values;
  values.reserve(image.voxels.size() / stride + 1);
  for (std::size_t p = 0; p < image.voxels.size(); p += stride)
    if (std::isfinite(image.voxels[p])) values.push_back(image.voxels[p]);
  if (values.empty()) return {0.0, 1.0};
  const auto from = static_cast<double>(lowerPercentile(values, low));
  const auto to = static_cast<double>(lowerPercentile(values, high));
  return {from, to > from ? to : from + 1.0};
}

}  // namespace angiomesh
