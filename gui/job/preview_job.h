// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>

#include "core/base/progress.h"
#include "core/parameters/parameters.h"
#include "core/preview/box_preview.h"

namespace angiomesh {

/// Tries parameters in a part of the volume, see previewInBox().
struct PreviewJob {
  PreviewGround ground;
  VoxelBox box;
  Parameters params;
  Progress progress;
  /// The front while it evolves, on the box and the margin around it.
  std::shared_ptr<Mailbox<EvolutionSnapshot>> snapshots =
      std::make_shared<Mailbox<EvolutionSnapshot>>();

  void execute() noexcept;

  // After execute():
  std::shared_ptr<const Volume<float>> phi;  ///< null where it failed or was cancelled
  std::string error;                         ///< empty: it did not fail
  double seconds = 0.0;
};

}  // namespace angiomesh
