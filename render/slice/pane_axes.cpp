// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/pane_axes.h"

#include <algorithm>
#include <cmath>

#include "core/image/projection.h"

namespace angiomesh {

namespace {

char axisLetter(int axis, double component) {
  constexpr std::array<char, 3> positive{'L', 'P', 'S'};
  constexpr std::array<char, 3> negative{'R', 'A', 'I'};
  const auto a = static_cast<std::size_t>(axis);
  return component >= 0.0 ? positive[a] : negative[a];
}

}  // namespace

PaneAxes paneAxes(const Geometry& geometry, int plane) {
  // Patient axes to the right and upwards, and their signs: sagittal +P +S, coronal +L +S,
  // axial +L -P.
  constexpr std::array<int, 3> rightAxis{1, 0, 0};
  constexpr std::array<int, 3> upAxis{2, 2, 1};
  constexpr std::array<double, 3> upSign{1.0, 1.0, -1.0};

  const std::array<int, 3> patientAxis = nearestPatientAxes(geometry);
  const auto gridAxisOf = [&](int patient) {
    return static_cast<int>(std::find(patientAxis.begin(), patientAxis.end(), patient) -
                            patientAxis.begin());
  };
  const auto p = static_cast<std::size_t>(plane);
  PaneAxes axes;
  axes.plane = plane;
  axes.across = gridAxisOf(plane);
  axes.right = gridAxisOf(rightAxis[p]);
  axes.up = gridAxisOf(upAxis[p]);
  axes.rightFlipped = geometry.direction(rightAxis[p], axes.right) < 0.0;
  axes.upFlipped = geometry.direction(upAxis[p], axes.up) * upSign[p] < 0.0;
  axes.acrossFlipped = geometry.direction(plane, axes.across) < 0.0;
  axes.rightLps = geometry.direction.col(axes.right) * (axes.rightFlipped ? -1.0 : 1.0);
  axes.upLps = geometry.direction.col(axes.up) * (axes.upFlipped ? -1.0 : 1.0);
  return axes;
}

std::string orientationLetters(const Eigen::Vector3d& directionLps) {
  const Eigen::Vector3d d = directionLps.normalized();
  int main = 0;
  d.cwiseAbs().maxCoeff(&main);
  std::string letters(1, axisLetter(main, d[main]));
  constexpr double cosineOf10Degrees = 0.98480775301220806;
  if (std::abs(d[main]) < cosineOf10Degrees) {
    int second = main == 0 ? 1 : 0;
    for (int axis = 0; axis < 3; ++axis)
      if (axis != main && std::abs(d[axis]) > std::abs(d[second])) second = axis;
    letters += axisLetter(second, d[second]);
  }
  return letters;
}

}  // namespace angiomesh
