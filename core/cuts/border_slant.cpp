// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/border_slant.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <numbers>
#include <unordered_set>

#include "core/base/error.h"
#include "core/base/few_warnings.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/cuts/clip_reference.h"
#include "core/image/voxels.h"
#include "core/mesh/triangle_shape.h"
#include "core/openings/cut_away.h"
#include "core/openings/section.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr double kMostRadii = 12.0;
/// How far from the port's centre the section may lie, in radii of the port: farther away it tells
/// of another place.
constexpr double kNearRadii = 4.0;
/// Of the way in radii: a section just inside is wanted.
constexpr double kStepRadii = 0.25;
/// An axis so far across the port's normal may lead inwards either way.
constexpr double kEitherWay = 0.5;
constexpr int kMostTries = 12;
constexpr int kMostSections = 60;
/// Of the largest port: smaller ones of which nothing is known are no inlets.
constexpr double kLeastShare = 0.05;
constexpr double kLeastVoxels = 0.5;

std::optional<Section> wholeSection(const SplineField& field, const Vector3d& centre,
                                    const Vector3d& outward) {
  try {
    return sectionOf(field, {centre, outward});
  } catch (const InputError&) {
    return std::nullopt;  // it reaches the border
  }
}

BorderSlant slantOf(const Port& port, const Section& section) {
  BorderSlant slant;
  slant.axisLps = section.plane.normalLps;
  slant.centreLps = section.centreLps;
  slant.sectionAreaMm2 = section.areaMm2;
  slant.areaRatio = port.areaMm2 / section.areaMm2;
  slant.angleDeg =
      angleDegrees(slant.axisLps.cross(port.normalLps).norm(), slant.axisLps.dot(port.normalLps));
  return slant;
}

/// Looks for the section across a port's vessel.
class Finder {
 public:
  Finder(const SplineField& field, const Volume<float>& phi, const Port& port)
      : field_(field), phi_(phi), port_(port), voxel_(field.geometry().voxelMm()) {}

  /// On the ways that lead inwards: along the vessel's axis as it seems at the port, either way
  /// where it runs along the border, else straight in.
  std::optional<BorderSlant> find() {
    for (const double depth : {1.0, 2.0, 3.0, 0.0}) {
      const auto start = knownVessel(port_.centreLps - depth * voxel_ * port_.normalLps);
      if (!start) continue;
      const Vector3d axis = start->axisAlong(-port_.normalLps);
      walk(start->centreLps, axis, start->radiusMm);
      if (!found_ || -axis.dot(port_.normalLps) < kEitherWay)
        walk(start->centreLps, -axis, start->radiusMm);
      if (found_) break;
    }
    if (!found_)
      walk(port_.centreLps - 0.5 * voxel_ * port_.normalLps, -port_.normalLps,
           0.5 * port_.equivalentDiameterMm());
    if (!found_) searchInside();
    return found_;
  }

 private:
  /// Where the border leaves next to nothing of a section, that tells no axis.
  [[nodiscard]] std::optional<LocalVessel> knownVessel(const Vector3d& place) const {
    std::optional<LocalVessel> vessel = vesselAt(field_, place);
    if (vessel && vessel->radiusMm < kLeastVoxels * voxel_) vessel.reset();
    return vessel;
  }

  void walk(const Vector3d& start, const Vector3d& inward, double radiusMm) {
    const double step = std::max(kStepRadii * radiusMm, 0.5 * voxel_);
    const double most = kMostRadii * std::max(radiusMm, voxel_);
    Vector3d place = start, ahead = inward;
    for (double way = 0.0; way < std::min(most, way_) && field_.geometry().holds(place);
         way += step) {
      // Where the border cuts the vessel off, its centre is not known: the way goes straight on.
      if (const std::optional<LocalVessel> vessel = knownVessel(place)) {
        const auto section = wholeSection(field_, vessel->centreLps, -vessel->axisAlong(ahead));
        if (section && takes(*section)) {
          way_ = way;
          return;
        }
        ahead = vessel->wayOn(ahead);
      }
      place += step * ahead;
    }
  }

  // A wide opening tells nothing of its vessel near the border: the nearest place deep inside the
  // vessel, seen from the opening, whose section does.
  void searchInside() {
    tries_ = 0;
    std::vector<std::size_t> found = startVoxel();
    std::unordered_set<std::size_t> seen(found.begin(), found.end());
    int looked = 0;
    for (std::size_t n = 0; n < found.size() && !found_ && looked < kMostSections; ++n) {
      bool ridge = true;
      forFaceNeighbours(phi_.geometry, found[n], [&](std::size_t next) {
        ridge = ridge && phi_.voxels[next] >= phi_.voxels[found[n]];
        if (phi_.voxels[next] < 0.0F && reaches(next) && seen.insert(next).second)
          found.push_back(next);
      });
      if (!ridge) continue;
      ++looked;
      takeAcross(found[n]);
    }
  }

  [[nodiscard]] Vector3d placeOf(std::size_t voxel) const {
    return voxelCentre(phi_.geometry, voxel);
  }
  [[nodiscard]] double reachMm() const {
    return kNearRadii * 0.5 * port_.equivalentDiameterMm() + 2.0 * voxel_;
  }
  [[nodiscard]] bool reaches(std::size_t voxel) const {
    return (placeOf(voxel) - port_.centreLps).norm() <= reachMm();
  }

  // The voxel of the vessel nearest to the port's centre, in its plane; at most one.
  [[nodiscard]] std::vector<std::size_t> startVoxel() const {
    const Geometry& g = phi_.geometry;
    const Vector3d centre = g.toIndex(port_.centreLps);
    const Vector3d half = reachMm() * g.spacing.cwiseInverse();
    Index3 low{}, high{};
    for (std::size_t a = 0; a < 3; ++a) {
      const auto e = static_cast<Eigen::Index>(a);
      low[a] = std::max(0, static_cast<int>(centre[e] - half[e]));
      high[a] = std::min(g.size[a] - 1, static_cast<int>(centre[e] + half[e]) + 1);
    }
    std::vector<std::size_t> nearest;
    double least = reachMm();
    for (int k = low[2]; k <= high[2]; ++k)
      for (int j = low[1]; j <= high[1]; ++j)
        for (int i = low[0]; i <= high[0]; ++i) {
          const std::size_t n = g.offset(i, j, k);
          if (!(phi_.voxels[n] < 0.0F) || (placeOf(n) - port_.centreLps).norm() >= least) continue;
          least = (placeOf(n) - port_.centreLps).norm();
          nearest = {n};
        }
    return nearest;
  }

  // Either side of the section may be the one to go.
  void takeAcross(std::size_t voxel) {
    const std::optional<LocalVessel> vessel = knownVessel(placeOf(voxel));
    if (!vessel) return;
    const Vector3d outward = vessel->axisAlong(port_.normalLps);
    for (const Vector3d& side : {outward, Vector3d(-outward)}) {
      const auto section = wholeSection(field_, vessel->centreLps, side);
      if (section && takes(*section)) return;
    }
  }

  // Takes a section that is across the vessel of the port. Of one that would not be said anything
  // about that is believed; else a cut there has to end what the port opens.
  bool takes(const Section& section) {
    if (!(section.areaMm2 > 0.0) || (section.centreLps - port_.centreLps).norm() > reachMm() ||
        !section.isAboutRound())
      return false;
    const BorderSlant slant = slantOf(port_, section);
    if (slant.flagged()) {
      if (++tries_ > kMostTries) return false;
      try {
        const CutAway away = checkedCutAway(field_, phi_, {section.plane});
        if (!away.takenAt(port_.centreLps)) return false;
      } catch (const InputError&) {
        return false;
      }
    }
    found_ = slant;
    return true;
  }

  const SplineField& field_;
  const Volume<float>& phi_;
  const Port& port_;
  double voxel_;
  std::optional<BorderSlant> found_;
  double way_ = std::numeric_limits<double>::infinity();
  int tries_ = 0;
};

std::string slantText(const Port& port) {
  if (!port.slant)
    return formatted(
        "the port '%s' of %.3g mm2 may slice its vessel: there is no section across it "
        "near by; look at it before it becomes an inlet or outlet",
        port.name.c_str(), port.areaMm2);
  const BorderSlant& slant = *port.slant;
  return formatted(
      "the port '%s' slices its vessel: its normal is %.0f degrees off the vessel's axis "
      "and its area of %.3g mm2 is %.2f times that of the section across just inside; "
      "end the vessel there with --cut %.2f,%.2f,%.2f,%.4f,%.4f,%.4f,NAME",
      port.name.c_str(), slant.angleDeg, port.areaMm2, slant.areaRatio, slant.centreLps.x(),
      slant.centreLps.y(), slant.centreLps.z(), slant.axisLps.x(), slant.axisLps.y(),
      slant.axisLps.z());
}

}  // namespace

std::optional<BorderSlant> borderSlant(const SplineField& field, const Volume<float>& phi,
                                       const Port& port) {
  return Finder(field, phi, port).find();
}

void measureSlants(const SplineField& field, const Volume<float>& phi, std::vector<Port>& ports) {
  for (Port& port : ports)
    if (port.atBorder && port.areaMm2 > 0.0) port.slant = borderSlant(field, phi, port);
}

std::vector<std::string> slantWarnings(const std::vector<Port>& ports) {
  double largest = 0.0;
  for (const Port& port : ports) largest = std::max(largest, port.areaMm2);
  std::vector<const Port*> flagged;
  for (const Port& port : ports) {
    const bool unknown = port.atBorder && !port.slant && port.areaMm2 > kLeastShare * largest;
    if (unknown || (port.slant && port.slant->flagged())) flagged.push_back(&port);
  }
  std::stable_sort(flagged.begin(), flagged.end(),
                   [](const Port* a, const Port* b) { return a->areaMm2 > b->areaMm2; });
  std::vector<std::string> texts, sentences;
  for (const Port* port : flagged) texts.push_back(slantText(*port));
  // More than elsewhere: the largest are most likely the inlet and the outlets.
  constexpr std::size_t named = 6;
  addFew(sentences, texts,
         " smaller ports slice their vessels, too: --cut-borders ends all of them across", named);
  return sentences;
}

}  // namespace angiomesh
