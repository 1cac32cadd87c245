// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/point_grid.h"

namespace angiomesh {

std::uint64_t PointGrid::keyAt(const Eigen::Vector3d& point, double length) {
  const int level = levelOf(length);
  const Eigen::Vector3d cell = point / cellSize(level);
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  return keyOf(level, whole(cell.x()), whole(cell.y()), whole(cell.z()));
}

void PointGrid::insert(std::uint32_t id, const Eigen::Vector3d& point, double length) {
  const std::uint64_t key = keyAt(point, length);
  const int level = levelOfKey(key);
  ++onLevel_[static_cast<std::size_t>(level)];
  lowest_ = std::min(lowest_, level);
  highest_ = std::max(highest_, level);
  std::uint32_t c = heads_[bucket(key)];
  while (c != none && (chunks_[c].key != key || chunks_[c].count == kChunk)) c = chunks_[c].next;
  if (c == none) c = newChunk(key);
  Chunk& chunk = chunks_[c];
  chunk.ids[chunk.count] = id;
  chunk.points[chunk.count++] = point;
}

void PointGrid::remove(std::uint32_t id, const Eigen::Vector3d& point, double length) {
  const std::uint64_t key = keyAt(point, length);
  for (std::uint32_t* link = &heads_[bucket(key)]; *link != none; link = &chunks_[*link].next) {
    Chunk& chunk = chunks_[*link];
    if (chunk.key != key) continue;
    const auto end = chunk.ids.begin() + chunk.count;
    const auto found = std::find(chunk.ids.begin(), end, id);
    if (found == end) continue;
    --onLevel_[static_cast<std::size_t>(levelOfKey(key))];
    --chunk.count;
    *found = chunk.ids[chunk.count];
    chunk.points[static_cast<std::size_t>(found - chunk.ids.begin())] = chunk.points[chunk.count];
    if (chunk.count > 0) return;
    const std::uint32_t c = *link;
    *link = chunk.next;
    chunk.next = free_;
    free_ = c;
    return;
  }
}

std::uint32_t PointGrid::newChunk(std::uint64_t key) {
  std::uint32_t c = free_;
  if (c != none) {
    free_ = chunks_[c].next;
  } else {
    if (kBuckets * (chunks_.size() + 1) > heads_.size()) grow();
    c = static_cast<std::uint32_t>(chunks_.size());
    chunks_.emplace_back();
  }
  chunks_[c].key = key;
  link(c);
  return c;
}

void PointGrid::link(std::uint32_t c) {
  std::uint32_t& head = heads_[bucket(chunks_[c].key)];
  chunks_[c].next = head;
  head = c;
}

// All chunks are in use.
void PointGrid::grow() {
  heads_.assign(2 * heads_.size(), none);
  for (std::uint32_t c = 0; c < chunks_.size(); ++c) link(c);
}

}  // namespace angiomesh
