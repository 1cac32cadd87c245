// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/self_intersection.h"

#include <algorithm>
#include <bit>

#include "core/base/parallel.h"
#include "core/mesh/box_tree.h"
#include "core/mesh/triangle_intersection.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {
namespace {

constexpr std::size_t blockSize = 1024;

// The corners of a triangle from `first` on, in its order.
Triangle3 cornersFrom(const TriMesh& mesh, std::uint32_t triangle, std::size_t first) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.points[t[first]], mesh.points[t[(first + 1) % 3]], mesh.points[t[(first + 2) % 3]]};
}

bool meetOutsideTheShared(const TriMesh& mesh, std::uint32_t first, std::uint32_t second) {
  const auto &a = mesh.triangles[first], &b = mesh.triangles[second];
  unsigned shared = 0, inA = 0, inB = 0;  // the common corners: their number, a bit for each
  for (unsigned i = 0; i < 3; ++i)
    for (unsigned j = 0; j < 3; ++j) {
      const unsigned same = a[i] == b[j] ? 1U : 0U;
      shared += same;
      inA |= same << i;
      inB |= same << j;
    }
  const auto only = [](unsigned bits) { return static_cast<std::size_t>(std::countr_zero(bits)); };
  switch (shared) {
    case 0:
      return trianglesMeet(cornersOf(mesh, first), cornersOf(mesh, second));
    case 1:
      return trianglesMeetBeyondCorner(cornersFrom(mesh, first, only(inA)),
                                       cornersFrom(mesh, second, only(inB)));
    case 2:
      return trianglesMeetBeyondEdge(cornersFrom(mesh, first, (only(~inA) + 1) % 3),
                                     mesh.points[b[only(~inB)]]);
    default:
      return true;
  }
}

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> selfIntersections(const TriMesh& mesh,
                                                                       const Progress& progress) {
  using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  const std::size_t count = mesh.triangles.size();
  const BoxTree tree(mesh, progress);
  std::vector<char> degenerate(count);
  parallelForEach(count, blockSize, [&](std::size_t i) {
    degenerate[i] = isDegenerate(cornersOf(mesh, static_cast<std::uint32_t>(i))) ? 1 : 0;
  });

  constexpr std::size_t leavesAtOnce = blockSize / 8;
  std::vector<Pairs> found((tree.leaves() + leavesAtOnce - 1) / leavesAtOnce);
  parallelFor(0, tree.leaves(), leavesAtOnce, [&](std::size_t begin, std::size_t end) {
    progress.check();
    Pairs& pairs = found[begin / leavesAtOnce];
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      tree.forEachPair(leaf, [&](std::uint32_t a, std::uint32_t b) {
        if (degenerate[a] != 0 || degenerate[b] != 0) return;
        const auto [lower, higher] = std::minmax(a, b);
        if (meetOutsideTheShared(mesh, lower, higher)) pairs.emplace_back(lower, higher);
      });
    progress.report(static_cast<double>(end) / static_cast<double>(tree.leaves()));
  });

  Pairs all;
  for (const Pairs& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace angiomesh
