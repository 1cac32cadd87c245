// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/image/volume.h"
#include "core/phantom/point_spread.h"

namespace angiomesh {

/// Tree: see vascular_tree.h. The others: `radius` = r, a = half the volume's shortest side, all
/// centred in the volume along `axis`. Tube, BentTube, Cone, Stenosis, Aneurysm, NeckAneurysm,
/// Bifurcation and Kissing leave the volume at their ends. Stenosis: its diameter falls by
/// `stenosisPercent` within 3 r on either side of the centre. Aneurysm: a ball of radius 2 r at
/// 2.5 r beside the axis, blended over r/2. NeckAneurysm: a ball of radius 2 r at 3.6 r beside the
/// axis on a neck of radius 0.8 r, blended over r/2. Bifurcation: daughters of equal radius by
/// Murray's law at 35 degrees, blended over r/2. Kissing: parallel along 4 r, then bent away by 35
/// degrees at radius 6 r. Torus: centre circle of radius a/2 around the axis. Helix: coil radius
/// a/2, pitch 5 r, ball ends inside the volume. CapsuleTree: ten tapering capsules, radii 1.5 r to
/// 0.375 r, blended over 2 voxels, one of them a bridge (genus 1), inside the volume. BentTube: a
/// quarter of a circle of radius 4 r between straight halves. Cone: the radius falls from 1.5 r to
/// r/2 along the axis' part in the volume. VesselTree: see vessel_tree.h.
enum class PhantomKind {
  Tree,
  Tube,
  Torus,
  Bifurcation,
  Kissing,
  Helix,
  Stenosis,
  Aneurysm,
  CapsuleTree,
  BentTube,
  Cone,
  NeckAneurysm,
  VesselTree
};

enum class NoiseModel { Gaussian, Rician };

/// What to make. Lengths in voxels of the smallest spacing unless they say otherwise.
struct PhantomParams {
  PhantomKind kind = PhantomKind::Tree;
  Index3 size{128, 128, 128};
  Eigen::Vector3d spacingMm{1.0, 1.0, 1.0};
  std::uint64_t randomSeed = 1;
  int terminals = 0;                        ///< tree: number of terminal vessels; 0: by the volume
  double radius = 4.0;                      ///< analytic kinds
  double radiusMin = 0.8, radiusMax = 8.0;  ///< tree
  double volumePercent = 0.77;              ///< tree: share of the volume that is vessel
  double gap = 1.0;                         ///< kissing: distance between the two walls
  double stenosisPercent = 50.0;            ///< stenosis: of the diameter
  PointSpread psf;                          ///< of vessels and clutter
  double noiseSigma = 0.0;                  ///< unclipped, in intensities of 0..255
  NoiseModel noiseModel = NoiseModel::Gaussian;
  double driftPercent = 0.0;   ///< +-, smooth factor on vessels, clutter and background
  double fadePercent = 100.0;  ///< brightness of the vessels at their distal ends
  bool clutter = false;        ///< what is bright and no vessel of the truth, see clutter.h
  Eigen::Vector3d axis{0.0, 0.0, 1.0};    ///< direction of the analytic kinds' axis, index axes
  Eigen::Vector3d offset{0.0, 0.0, 0.0};  ///< sub-voxel shift of the analytic kinds, voxels
};

/// One vessel segment: a straight piece of centre line with a radius at each end, LPS mm.
struct CentreLineSegment {
  Eigen::Vector3d from, to;
  double radiusFromMm = 0.0, radiusToMm = 0.0;
  int parent = -1;  ///< index of the segment that it continues, -1 at a root
};

/// A bright thing that the truth leaves out.
struct ClutterPiece {
  std::string kind;          ///< "shell", "plate", "blob", "bone", "vein" or "slab"
  std::uint8_t label = 0;    ///< in Phantom::clutter: 1 to 5 in that order; 0 of slabs
  double intensity = 0.0;    ///< before drift and noise; of slabs: what is added to all voxels
  Eigen::Vector3d from, to;  ///< LPS mm: the ends of a vein's axis, else opposite corners of a box
  int segment = -1;          ///< bone: touches this centre line; vein: runs beside it
};

struct Phantom {
  /// The vessels, 255 inside and 0 outside, times the fade, seen through the point spread, see
  /// PointSpread; clutter alike, added; then drift and noise.
  Volume<float> image;
  /// 1 where a voxel is inside by half of its volume and more: exactly, or with the point spread
  /// Subvoxels by its count.
  Volume<std::uint8_t> truth;
  Volume<std::uint8_t> clutter;  ///< labels of the pieces; without voxels unless asked for
  std::vector<CentreLineSegment> centreLines;
  std::vector<ClutterPiece> pieces;
};

/// @throws InputError for parameters that cannot be met
Phantom makePhantom(const PhantomParams& params, const Progress& progress = {});

/// Signed distance-like function of the noise-free shape, negative inside, in mm; its zero set is
/// exact for the analytic kinds. For tests and benchmarks.
Volume<float> phantomField(const PhantomParams& params);

/// The same at any point in LPS mm; may be called from several threads.
std::function<double(const Eigen::Vector3d&)> phantomDistance(const PhantomParams& params);

PhantomKind phantomKindFromName(
    const std::string& name);  ///< @throws InputError naming the nearest kind
const std::vector<std::string>& phantomKindNames();

}  // namespace angiomesh
