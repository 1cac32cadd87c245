// SPDX-License-Identifier: BSD-3-Clause
#include "core/levelset/packed_front.h"

#include <algorithm>
#include <cmath>

namespace angiomesh {

namespace {

constexpr float kSteps = 50.0F;  // in a working voxel
constexpr float kFar = 2.5F;
constexpr std::size_t kDigit = 128;

std::int8_t packed(float value) {
  const auto step = static_cast<int>(std::lround(std::clamp(value, -kFar, kFar) * kSteps));
  return static_cast<std::int8_t>(value < 0.0F ? std::min(step, -1) : step);
}

}  // namespace

PackedFront::PackedFront(const Volume<float>& phi) : geometry_(phi.geometry) {
  const std::size_t count = phi.voxels.size();
  for (std::size_t i = 0; i < count;) {
    const std::int8_t value = packed(phi.voxels[i]);
    std::size_t length = 1;
    while (i + length < count && packed(phi.voxels[i + length]) == value) ++length;
    i += length;
    runs_.push_back(static_cast<std::uint8_t>(value));
    for (--length; length >= kDigit; length /= kDigit)
      runs_.push_back(static_cast<std::uint8_t>(length % kDigit + kDigit));
    runs_.push_back(static_cast<std::uint8_t>(length));
  }
  runs_.shrink_to_fit();
}

Volume<float> PackedFront::unpacked() const {
  Volume<float> phi(geometry_);
  std::size_t voxel = 0;
  for (std::size_t i = 0; i < runs_.size();) {
    const float value = static_cast<float>(static_cast<std::int8_t>(runs_[i++])) / kSteps;
    std::size_t length = 0;
    std::size_t unit = 1;
    for (bool more = true; more; unit *= kDigit) {
      more = runs_[i] >= kDigit;
      length += unit * (runs_[i++] % kDigit);
    }
    std::fill_n(phi.voxels.begin() + static_cast<std::ptrdiff_t>(voxel), length + 1, value);
    voxel += length + 1;
  }
  return phi;
}

}  // namespace angiomesh
