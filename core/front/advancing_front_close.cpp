// SPDX-License-Identifier: BSD-3-Clause
#include "core/front/advancing_front.h"
#include "core/front/fill_loop.h"

namespace angiomesh {

std::size_t AdvancingFront::close() {
  std::size_t failed = 0;
  for (std::uint32_t id = 0; id < edges_.size(); ++id) {
    if (!edges_[id].alive) continue;
    std::vector<std::uint32_t> loop, members;
    for (std::uint32_t h = id;;) {
      loop.push_back(edges_[h].from);
      members.push_back(h);
      h = edges_[h].next;
      if (h == id) break;
    }
    if (loop.size() > 2) {
      const auto filling = fillLoop(loop, vertices_, [this](std::uint32_t a, std::uint32_t b) {
        return used_.has(a, b) || used_.has(b, a);
      });
      if (filling.empty()) ++failed;
      for (const Triangle& t : filling) addTriangle(t, FaceOrigin::Closing);
    }
    for (const std::uint32_t h : members) dropEdge(h);
  }
  return failed;
}

}  // namespace angiomesh
