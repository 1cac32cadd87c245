// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/pipeline/pipeline.h"

namespace angiomesh {

/// A mask that more of the volume's border belongs to is inside out, see shareOfBorder().
constexpr double kInsideOut = 0.5;

/// For each of the parts of phi < 0 the centre of the voxel deepest inside, mm LPS.
std::vector<Eigen::Vector3d> innerPoints(const Volume<float>& phi, const Components& parts);

/// The components of phi < 0 and which of them go into the surface. `seedsByHand` (LPS) serve keep
/// = seeded.
/// @throws NumericError when none is kept
struct Segments {
  std::vector<SegmentComponent> components;
  Volume<std::int32_t> labels;   ///< 1 + index into components; 0 outside
  std::size_t insideVoxels = 0;  ///< of the kept components
};
Segments selectSegments(const Volume<float>& phi, const SegmentationParams& params,
                        const std::vector<double>& seedsByHand, const Progress& progress);

/// Whether no component is ever left out.
bool keepsAll(const SegmentationParams& params);

/// phi without the components that were not kept, a distance again. Returns phi itself when all
/// were kept.
std::shared_ptr<const Volume<float>> withoutDropped(std::shared_ptr<const Volume<float>> phi,
                                                    const Segments& segments,
                                                    const Progress& progress);

/// phi of what a run keeps of its segmentation: that of its surface, or where it went no further
/// than the evolution, that of the evolution's components to keep. Null before the evolution.
/// @throws as selectSegments()
std::shared_ptr<const Volume<float>> keptPhi(const RunResult& result,
                                             const Progress& progress = {});

/// The field sampled on a grid over the same extent whose spacing is about `cellMm`.
Volume<float> resampleField(const SplineField& field, double cellMm, const Progress& progress);

}  // namespace angiomesh
