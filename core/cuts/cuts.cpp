// SPDX-License-Identifier: BSD-3-Clause
#include "core/cuts/cuts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/cuts/border_cuts.h"
#include "core/cuts/border_slant.h"
#include "core/cuts/clip_reference.h"
#include "core/cuts/end_cuts.h"
#include "core/cuts/port_advice.h"
#include "core/openings/port.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

/// How far a named place may be from its port's centre, in radii of the port: its opening is about
/// the same one on a surface of other parameters.
constexpr double kNearRadii = 1.5;

/// How far along a vessel a place for a cut is looked for, in its radii.
constexpr double kMostRadii = 4.0;
/// A cut that was moved by more along its vessel is spoken of.
constexpr double kTellVoxels = 1.5;

std::optional<std::size_t> portCalled(const std::string& name, const std::vector<Port>& ports) {
  const auto found =
      std::find_if(ports.begin(), ports.end(), [&](const Port& port) { return port.name == name; });
  if (found == ports.end()) return std::nullopt;
  return static_cast<std::size_t>(found - ports.begin());
}

/// The port nearest to a place, but for those with the names of `cuts`.
std::optional<std::size_t> portAt(const Vector3d& place, const std::vector<Port>& ports,
                                  const std::set<std::string>& cuts) {
  std::optional<std::size_t> nearest;
  double least = std::numeric_limits<double>::max();
  for (std::size_t n = 0; n < ports.size(); ++n) {
    const double away = (ports[n].centreLps - place).norm();
    if (away >= least || away > kNearRadii * 0.5 * ports[n].equivalentDiameterMm() ||
        cuts.count(ports[n].name) != 0)
      continue;
    nearest = n;
    least = away;
  }
  return nearest;
}

std::size_t takenBy(const SplineField& field, const Volume<float>& phi, const CutPlane& plane,
                    const std::string& name, const Progress& progress) {
  return checkedCutAway(field, phi, {plane}, {name}, progress).taken[0];
}

/// Where the axis through a vessel's centre meets the plane.
Vector3d onAxis(const LocalVessel& vessel, const CutPlane& plane) {
  const double slope = vessel.axisLps.dot(plane.normalLps);
  if (std::fabs(slope) < 0.2) return vessel.centreLps;
  const double along = (plane.pointLps - vessel.centreLps).dot(plane.normalLps) / slope;
  return vessel.centreLps + along * vessel.axisLps;
}

/// Whether a plane across a vessel can be a cut, whatever it takes.
bool canCut(const SplineField& field, const CutPlane& plane) {
  try {
    const Section section = sectionOf(field, plane);
    checkSection(field, section, "the cut");
    return section.isAboutRound();
  } catch (const InputError&) {
    return false;
  }
}

/// On the way from a place along a vessel the first one where it can be cut across.
class Walk {
 public:
  Walk(const CutPlane& start, double stepMm)
      : place_(start.pointLps), ahead_(start.normalLps), step_(stepMm) {}

  std::optional<CutPlane> next(const SplineField& field) {
    place_ += step_ * ahead_;
    if (!field.geometry().holds(place_)) return std::nullopt;
    const std::optional<LocalVessel> vessel = vesselAt(field, place_);
    if (!vessel) return std::nullopt;
    const CutPlane plane{vessel->centreLps, vessel->axisAlong(ahead_)};
    ahead_ = vessel->wayOn(ahead_);
    if (!canCut(field, plane)) return std::nullopt;
    return plane;
  }

 private:
  Vector3d place_, ahead_;
  double step_;
};

/// Across the opening of the volume's border that is nearest to a point, just inside.
std::optional<CutPlane> acrossNearestOpening(const SplineField& field, const Volume<float>& phi,
                                             const Vector3d& point) {
  const std::vector<Port> openings = borderOpenings(phi);
  const auto nearest =
      std::min_element(openings.begin(), openings.end(), [&](const Port& a, const Port& b) {
        return (a.centreLps - point).norm() < (b.centreLps - point).norm();
      });
  if (nearest == openings.end() ||
      (nearest->centreLps - point).norm() > kMostRadii * nearest->equivalentDiameterMm())
    return std::nullopt;
  const std::optional<BorderSlant> slant = borderSlant(field, phi, *nearest);
  if (!slant) return std::nullopt;
  const CutPlane plane{slant->centreLps, slant->axisLps};
  return canCut(field, plane) ? std::optional(plane) : std::nullopt;
}

/// Across the vessel at a point where it can be cut, or else at the nearest place where it can:
/// along the vessel, or just inside the border of the volume.
std::optional<CutPlane> nearestAcross(const SplineField& field, const Volume<float>& phi,
                                      const Vector3d& point,
                                      const std::optional<LocalVessel>& vessel) {
  if (vessel) {
    const CutPlane here{vessel->centreLps, vessel->axisLps};
    if (canCut(field, here)) return here;
    const double step = std::max(0.25 * vessel->radiusMm, 0.5 * field.geometry().voxelMm());
    Walk forward(here, step), backward({here.pointLps, -here.normalLps}, step);
    for (double gone = 0.0; gone < kMostRadii * vessel->radiusMm; gone += step)
      for (Walk* walk : {&forward, &backward})
        if (const std::optional<CutPlane> plane = walk->next(field)) return plane;
  }
  return acrossNearestOpening(field, phi, point);
}

[[noreturn]] void refusePlace(const GivenCut& cut) {
  throw InputError(
      "there is no vessel where the cut '" + cut.name + "' at " + placeText(cut.pointLps) + " lies",
      "ports.cuts", "give a point inside the segmentation, in mm LPS");
}

/// What to say of a cut that does not lie where it was asked for.
std::optional<std::string> moveText(const GivenCut& cut, const CutPlane& plane, double voxelMm) {
  const double moved = std::fabs((plane.pointLps - cut.pointLps).dot(plane.normalLps));
  if (cut.normalLps || moved < kTellVoxels * voxelMm) return std::nullopt;
  return formatted(
      "was moved by %.1f mm along its vessel: there is the nearest place where it can be "
      "cut across",
      moved);
}

/// Whether two cuts come so near to each other that one of them has to go.
bool inTheWay(const Section& section, const ProposedCut& end) {
  return (section.centreLps - end.pointLps).norm() < section.radiusMm + 2.0 * end.radiusMm;
}

std::string endName(int number) { return "end_" + std::to_string(number); }

std::string uncutText(const Vector3d& tip, const std::string& why) {
  return "the end at " + placeText(tip) + " was not cut: " + why;
}

}  // namespace

std::vector<std::string> namePorts(const PortParams& params, std::vector<Port>& ports) {
  const std::set<std::string> cuts = cutNames(params.cuts);
  const std::string known = joined(ports, ", ", &Port::name);
  const std::vector<Port> before = ports;
  std::vector<std::string> warnings;
  for (const std::string& text : params.names) {
    const PortNaming naming = parsePortNaming(text);
    const std::optional<std::size_t> port =
        naming.placeLps ? portAt(*naming.placeLps, before, cuts) : portCalled(naming.port, before);
    const std::optional<std::size_t> called = portCalled(naming.name, ports);
    if (called && !ports[*called].atBorder && naming.placeLps) continue;  // a cut across it has it
    if (!port)
      warnings.push_back((naming.placeLps ? "there is no port at " + naming.port + " mm LPS"
                                          : "no port is called '" + naming.port + "'") +
                         ", so that none became '" + naming.name +
                         "': " + (known.empty() ? "there are none" : "there are " + known));
    else if (called)
      warnings.push_back("the port '" + ports[*port].name +
                         "' keeps its name: another one is called '" + naming.name + "'");
    else if (ports[*port].name != before[*port].name)
      warnings.push_back("the port '" + ports[*port].name + "' keeps its name: it was to become '" +
                         naming.name + "', too");
    else
      ports[*port].name = naming.name;
  }
  return warnings;
}

CutPlane placeCut(const SplineField& field, const Volume<float>& phi, const GivenCut& cut,
                  const Progress& progress) {
  const Vector3d& p = cut.pointLps;
  const bool inGrid = field.geometry().holds(p);
  const bool inside = inGrid && field.valueAt(p) < 0.0;
  if (cut.normalLps && inside) return {p, cut.normalLps->normalized()};
  const std::optional<LocalVessel> vessel = inGrid ? vesselAt(field, p) : std::nullopt;
  if (!vessel && (cut.normalLps || !inside)) refusePlace(cut);
  if (cut.normalLps) {
    CutPlane plane{p, cut.normalLps->normalized()};
    plane.pointLps = onAxis(*vessel, plane);
    return plane;
  }
  const std::optional<CutPlane> nearest = nearestAcross(field, phi, p, vessel);
  if (!nearest && !vessel) refusePlace(cut);
  const CutPlane forward = nearest ? *nearest : CutPlane{vessel->centreLps, vessel->axisLps};
  const CutPlane backward{forward.pointLps, -forward.normalLps};
  try {
    return takenBy(field, phi, forward, cut.name, progress) <=
                   takenBy(field, phi, backward, cut.name, progress)
               ? forward
               : backward;
  } catch (const InputError& error) {
    throw InputError(error.cause(), "ports.cuts",
                     "give the direction in which the vessel ends, or move the point");
  }
}

EndPlan planEndCuts(const SplineField& field, const Volume<float>& phi, const Skeleton& skeleton,
                    const CutAway& given, double radiiFromTip, const Progress& progress) {
  EndPlan plan;
  std::vector<CutPlane> planes = given.planes();
  std::vector<std::string> names = given.names;
  const std::set<std::string> taken(names.begin(), names.end());
  const EndCuts ends = proposeEndCuts(skeleton, field, radiiFromTip);
  int number = 1;
  for (const ProposedCut& end : ends.cuts) {
    while (taken.count(endName(number)) != 0) ++number;
    if (given.takenAt(end.pointLps) ||
        std::any_of(given.sections.begin(), given.sections.end(),
                    [&](const Section& s) { return inTheWay(s, end); }))
      continue;
    planes.push_back({end.pointLps, end.outwardNormalLps});
    names.push_back(endName(number));
    try {
      plan.away = checkedCutAway(field, phi, planes, names, progress);
      plan.planes.push_back(planes.back());
      plan.names.push_back(endName(number++));
    } catch (const InputError& error) {
      planes.pop_back();
      names.pop_back();
      plan.remarks.push_back(uncutText(end.pointLps, error.cause()));
    }
  }
  for (const UncutTip& tip : ends.uncut)
    if (!given.takenAt(tip.pointLps)) plan.remarks.push_back(uncutText(tip.pointLps, tip.reason));
  return plan;
}

CutAway makeCuts(const SplineField& field, const Volume<float>& phi, const PortParams& params,
                 std::vector<std::string>& remarks, const Progress& progress) {
  if (params.cuts.empty() && !(params.cutEndsRadii > 0.0) && !params.cutBorders) return {};
  std::vector<CutPlane> planes;
  std::vector<std::string> names;
  for (const std::string& text : params.cuts) {
    const GivenCut cut = parseCut(text);
    planes.push_back(placeCut(field, phi, cut, progress));
    if (const auto moved = moveText(cut, planes.back(), phi.geometry.voxelMm()))
      remarks.push_back("the cut '" + cut.name + "' " + *moved);
    names.push_back(cut.name);
  }
  const Skeleton skeleton = skeletonOf(phi, progress);
  CutAway away = checkedCutAway(field, phi, planes, names, progress);
  if (params.cutEndsRadii > 0.0) {
    EndPlan ends = planEndCuts(field, phi, skeleton, away, params.cutEndsRadii, progress);
    remarks.insert(remarks.end(), ends.remarks.begin(), ends.remarks.end());
    if (!ends.planes.empty()) away = std::move(ends.away);
  }
  if (params.cutBorders)
    for (std::string& remark : addBorderCuts(field, phi, away, params, progress))
      remarks.push_back(std::move(remark));
  for (const PortAdvice& advice : portAdvice(skeleton, away))
    remarks.push_back(away.nameOf(advice.cut) + " " + advice.words);
  return away;
}

}  // namespace angiomesh
