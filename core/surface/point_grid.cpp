// SPDX-License-Identifier: BSD-3-Clause
#include "core/surface/point_grid.h"

namespace angiomesh {

void PointGrid::link(std::uint32_t id) {
  Entry& entry = entries_[id];
  std::uint32_t& head = heads_[bucket(entry.key)];
  entry.next = head;
  entry.previous = none;
  if (head != none) entries_[head].previous = id;
  head = id;
}

void PointGrid::insert(std::uint32_t id, const Eigen::Vector3d& point, double length) {
  if (id >= entries_.size()) entries_.resize(std::max<std::size_t>(id + 1, 2 * entries_.size()));
  const int level = levelOf(length);
  const Eigen::Vector3d cell = point / cellSize(level);
  const auto whole = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
  entries_[id].key = keyOf(level, whole(cell.x()), whole(cell.y()), whole(cell.z()));
  entries_[id].point = point;
  ++onLevel_[static_cast<std::size_t>(level)];
  lowest_ = std::min(lowest_, level);
  highest_ = std::max(highest_, level);
  if (++count_ > heads_.size())
    grow();
  else
    link(id);
}

void PointGrid::remove(std::uint32_t id) {
  Entry& entry = entries_[id];
  if (entry.previous != none)
    entries_[entry.previous].next = entry.next;
  else
    heads_[bucket(entry.key)] = entry.next;
  if (entry.next != none) entries_[entry.next].previous = entry.previous;
  --onLevel_[static_cast<std::size_t>(entry.key >> 57U)];
  entry.key = absent;
  --count_;
}

void PointGrid::grow() {
  heads_.assign(2 * heads_.size(), none);
  for (std::uint32_t id = 0; id < entries_.size(); ++id)
    if (entries_[id].key != absent) link(id);
}

}  // namespace angiomesh
