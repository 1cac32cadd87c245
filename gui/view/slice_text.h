// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QString>
#include <QStringList>

#include "render/slice/slice_overlay.h"
#include "render/slice/slice_scene.h"

namespace angiomesh {

/// In the language of the window.
SliceWords sliceWords();

/// How a pane names what it shows.
struct ValueNames {
  QString layer, unit, overlay;
};

/// What the pane says of a place: value and voxel, and where it is.
QStringList probeLines(const SliceScene::Probe& probe, const ValueNames& names,
                       const Eigen::Vector3d& lps);

}  // namespace angiomesh
