// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/slice_grip.h"

namespace angiomesh {

std::optional<PortHit> SliceGrip::portAt(const Eigen::Vector2d& at) const {
  const bool grabs = tool_ == Tool::Navigate || tool_ == Tool::CutVessel;
  return grabs ? scene_.portAt(at[0], at[1]) : std::nullopt;
}

QString SliceGrip::nameOf(const std::optional<PortHit>& hit) const {
  return hit ? QString::fromStdString(scene_.ports()[hit->mark].name) : QString();
}

bool SliceGrip::takePort(const Eigen::Vector2d& at) {
  const std::optional<PortHit> hit = portAt(at);
  if (!hit) return false;
  drag_ = scene_.grabPort(*hit, at[0], at[1]);
  port_ = nameOf(hit);
  return true;
}

CutPlane SliceGrip::portMoved(const Eigen::Vector2d& at, bool free) {
  return drag_->moved(scene_.rayAt(at[0], at[1]), free);
}

Qt::CursorShape SliceGrip::cursorAt(const Eigen::Vector2d& at) const {
  if (const std::optional<PortHit> hit = portAt(at))
    return hit->grip == PortDrag::Grip::Turn ? Qt::PointingHandCursor : Qt::SizeAllCursor;
  if (markAt(at)) return Qt::SizeAllCursor;
  if (knobAt(at)) return Qt::PointingHandCursor;
  return tool_ == Tool::Navigate ? Qt::ArrowCursor : Qt::CrossCursor;
}

bool SliceGrip::knobAt(const Eigen::Vector2d& at) const {
  return tool_ == Tool::Navigate && scene_.knobAt(at[0], at[1]);
}

bool SliceGrip::takeKnob(const Eigen::Vector2d& at) {
  if (!knobAt(at)) return false;
  turnBefore_ = scene_.turn();
  angleBefore_ = scene_.angleAt(at[0], at[1]);
  return true;
}

PlaneTurn SliceGrip::knobMoved(const Eigen::Vector2d& at) const {
  return scene_.turnedBy(turnBefore_, scene_.angleAt(at[0], at[1]) - angleBefore_);
}

std::optional<MarkPoint> SliceGrip::markAt(const Eigen::Vector2d& at) const {
  const bool grabs = tool_ == Tool::Navigate || measuredBy(tool_);
  if (grabs)
    if (auto point = measures_.pointAt(at)) return point;
  if (tool_ != Tool::PickSeed) return std::nullopt;
  const auto seed = scene_.seedAt(at[0], at[1]);
  if (!seed) return std::nullopt;
  return MarkPoint{{}, *seed, scene_.seeds()[*seed]};
}

bool SliceGrip::takeMark(const Eigen::Vector2d& at) {
  mark_ = markAt(at);
  markTakenAt_ = scene_.lpsAt(at[0], at[1]);
  return mark_.has_value();
}

MarkPoint SliceGrip::markMoved(const Eigen::Vector2d& at) const {
  MarkPoint moved = *mark_;
  moved.lps += scene_.lpsAt(at[0], at[1]) - markTakenAt_;
  return moved;
}

void SliceGrip::takeRoi(const Eigen::Vector2d& at) {
  roiCorner_ = scene_.lpsAt(at[0], at[1]);
  roiBefore_ = scene_.roi();
}

std::optional<RoiBox> SliceGrip::roiMoved(const Eigen::Vector2d& at) const {
  const RoiBox whole = volumeBox(scene_.image()->geometry);
  return boxBetween(roiBefore_.value_or(whole), whole, scene_.axes().plane, roiCorner_,
                    scene_.lpsAt(at[0], at[1]));
}

}  // namespace angiomesh
