// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/remesh/remesh_mesh.h"

namespace angiomesh {
namespace {

// The lowest 21 bits of x, each followed by two zeros.
std::uint64_t spreadBits(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

// What `from` holds at `order`.
template <class T>
std::vector<T> picked(const std::vector<T>& from, const std::vector<std::uint32_t>& order) {
  std::vector<T> to;
  to.reserve(order.size());
  for (const std::uint32_t i : order) to.push_back(from[i]);
  return to;
}

std::vector<std::uint32_t> numbersOf(const std::vector<std::uint32_t>& order, std::size_t slots) {
  std::vector<std::uint32_t> number(slots, EditMesh::none);
  for (std::uint32_t i = 0; i < order.size(); ++i) number[order[i]] = i;
  return number;
}

// The numbers whose key is not none, by key (Morton 1966), ties by number.
std::vector<std::uint32_t> sortedBy(const std::vector<std::uint64_t>& keys, std::uint64_t skip) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> list;
  for (std::uint32_t i = 0; i < keys.size(); ++i)
    if (keys[i] != skip) list.emplace_back(keys[i], i);
  std::sort(list.begin(), list.end());
  std::vector<std::uint32_t> order;
  order.reserve(list.size());
  for (const auto& item : list) order.push_back(item.second);
  return order;
}

}  // namespace

void EditMesh::reorder() {
  constexpr std::uint64_t skip = ~std::uint64_t{0};
  Vector3d low = Vector3d::Constant(1e300), high = -low;
  for (std::uint32_t v = 0; v < vertexSlots(); ++v) {
    if (!livesVertex(v)) continue;
    low = low.cwiseMin(points_[v]);
    high = high.cwiseMax(points_[v]);
  }
  const double extent = (high - low).maxCoeff();
  if (!(extent > 0.0)) return;
  std::vector<std::uint64_t> keys(vertexSlots(), skip);
  for (std::uint32_t v = 0; v < vertexSlots(); ++v) {
    if (!livesVertex(v)) continue;
    const Vector3d p = (points_[v] - low) * (2097151.0 / extent);
    keys[v] = spreadBits(static_cast<std::uint64_t>(p[0])) |
              spreadBits(static_cast<std::uint64_t>(p[1])) << 1 |
              spreadBits(static_cast<std::uint64_t>(p[2])) << 2;
  }
  const std::vector<std::uint32_t> vertices = sortedBy(keys, skip);
  const std::vector<std::uint32_t> vertexNumber = numbersOf(vertices, vertexSlots());
  keys.assign(patches_.size(), skip);
  for (std::uint32_t t = 0; t < patches_.size(); ++t)
    if (lives(t))
      keys[t] = std::min({vertexNumber[corner_[3 * t]], vertexNumber[corner_[3 * t + 1]],
                          vertexNumber[corner_[3 * t + 2]]});
  const std::vector<std::uint32_t> triangles = sortedBy(keys, skip);
  const std::vector<std::uint32_t> triangleNumber = numbersOf(triangles, patches_.size());
  const auto side = [&](std::uint32_t h) {
    return h == none ? none : 3 * triangleNumber[h / 3] + h % 3;
  };
  std::vector<std::uint32_t> corner(3 * triangles.size()), twin(corner.size());
  for (std::uint32_t h = 0; h < corner.size(); ++h) {
    const std::uint32_t old = 3 * triangles[h / 3] + h % 3;
    corner[h] = vertexNumber[corner_[old]];
    twin[h] = side(twin_[old]);
  }
  corner_.swap(corner);
  twin_.swap(twin);
  leaving_ = picked(leaving_, vertices);
  for (std::uint32_t& h : leaving_) h = side(h);
  valence_ = picked(valence_, vertices);
  points_ = picked(points_, vertices);
  normals_ = picked(normals_, vertices);
  sizes_ = picked(sizes_, vertices);
  places_ = picked(places_, vertices);
  locked_ = picked(locked_, vertices);
  patches_ = picked(patches_, triangles);
  origins_ = picked(origins_, triangles);
  if (!groups_.empty()) groups_ = picked(groups_, triangles);
  freeTriangles_.clear();
  freeVertices_.clear();
}

}  // namespace angiomesh
