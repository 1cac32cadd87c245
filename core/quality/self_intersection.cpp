// SPDX-License-Identifier: BSD-3-Clause
#include "core/quality/self_intersection.h"

#include <algorithm>
#include <array>

#include "core/base/parallel.h"
#include "core/quality/triangle_intersection.h"
#include "core/surface/triangle_tree.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 1024;

bool meetOutsideTheShared(const TriMesh& mesh, std::uint32_t first, std::uint32_t second) {
  Triangle3 s = cornersOf(mesh, first), t = cornersOf(mesh, second);
  auto a = mesh.triangles[first], b = mesh.triangles[second];
  // Brings the shared corners to the front of both.
  std::size_t shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = shared; j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[i], a[shared]);
      std::swap(s[i], s[shared]);
      std::swap(b[j], b[shared]);
      std::swap(t[j], t[shared]);
      ++shared;
      break;
    }
  }
  switch (shared) {
    case 0:
      return trianglesMeet(s, t);
    case 1:
      return trianglesMeetBeyondCorner(s, t);
    case 2:
      return trianglesMeetBeyondEdge(s, t[2]);
    default:
      return true;
  }
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> selfIntersections(const TriMesh& mesh,
                                                                       const Progress& progress) {
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const std::size_t count = mesh.triangles.size();
  const TriangleTree tree(mesh, progress);
  std::vector<char> degenerate(count);
  parallelFor(0, count, blockSize, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      degenerate[i] = isDegenerate(cornersOf(mesh, static_cast<std::uint32_t>(i))) ? 1 : 0;
    }
  });

  std::vector<Pairs> found((count + blockSize - 1) / blockSize);
  parallelFor(0, count, blockSize, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Pairs& pairs = found[begin / blockSize];
    for (std::size_t i = begin; i < end; ++i) {
      if (degenerate[i] != 0) continue;
      const auto triangle = static_cast<std::uint32_t>(i);
      TriangleTree::Box box;
      for (const auto& corner : cornersOf(mesh, triangle)) box.extend(corner);
      tree.forEachMeeting(box, [&](std::uint32_t other) {
        if (other <= triangle || degenerate[other] != 0) return;
        if (meetOutsideTheShared(mesh, triangle, other)) pairs.emplace_back(triangle, other);
      });
    }
    std::sort(pairs.begin(), pairs.end());
    progress.report(static_cast<double>(end) / static_cast<double>(count));
  });

  Pairs all;
  for (const Pairs& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

}  // namespace angiomesh
