// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/cuts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/base/error.h"
#include "core/pipeline/border_cuts.h"
#include "core/quality/end_cuts.h"
#include "core/quality/port_advice.h"
#include "core/quality/vessel_at.h"
#include "core/surface/port.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

std::size_t takenBy(const SplineField& field, const Volume<float>& phi, const CutPlane& plane,
                    const std::string& name, const Progress& progress) {
  return cutAway(field, phi, {plane}, {name}, progress).taken[0];
}

/// Where the axis through a vessel's centre meets the plane.
Vector3d onAxis(const LocalVessel& vessel, const CutPlane& plane) {
  const double slope = vessel.axisLps.dot(plane.normalLps);
  if (std::fabs(slope) < 0.2) return vessel.centreLps;
  const double along = (plane.pointLps - vessel.centreLps).dot(plane.normalLps) / slope;
  return vessel.centreLps + along * vessel.axisLps;
}

/// Whether two cuts come so near to each other that one of them has to go.
bool inTheWay(const Section& section, const ProposedCut& end) {
  return (section.centreLps - end.pointLps).norm() < section.radiusMm + 2.0 * end.radiusMm;
}

std::string endName(int number) { return "end_" + std::to_string(number); }

std::string uncutText(const Vector3d& tip, const std::string& why) {
  char place[80];
  std::snprintf(place, sizeof place, "the end at L %.1f P %.1f S %.1f mm was not cut: ", tip.x(),
                tip.y(), tip.z());
  return place + why;
}

}  // namespace

std::vector<std::string> namePorts(const PortParams& params, std::vector<Port>& ports) {
  std::vector<std::string> warnings;
  std::string known;
  for (const Port& port : ports) known += (known.empty() ? "" : ", ") + port.name;
  const auto portOf = [&](const std::string& name) {
    return std::find_if(ports.begin(), ports.end(),
                        [&](const Port& port) { return port.name == name; });
  };
  for (const std::string& text : params.names) {
    const auto [from, to] = parsePortName(text);
    const auto port = portOf(from);
    if (port == ports.end())
      warnings.push_back("no port is called '" + from + "', so that none became '" + to +
                         "': " + (known.empty() ? "there are none" : "there are " + known));
    else if (portOf(to) != ports.end())
      warnings.push_back("the port '" + from + "' keeps its name: another one is called '" + to +
                         "'");
    else
      port->name = to;
  }
  return warnings;
}

CutPlane placeCut(const SplineField& field, const Volume<float>& phi, const GivenCut& cut,
                  const Progress& progress) {
  const Vector3d& p = cut.pointLps;
  const bool inGrid = field.geometry().holds(p);
  if (cut.normalLps && inGrid && field.valueAt(p) < 0.0) return {p, cut.normalLps->normalized()};
  const std::optional<LocalVessel> vessel = inGrid ? vesselAt(field, p) : std::nullopt;
  if (!vessel) {
    char place[100];
    std::snprintf(place, sizeof place, "'%s' at L %.1f P %.1f S %.1f mm", cut.name.c_str(), p.x(),
                  p.y(), p.z());
    throw InputError("there is no vessel where the cut " + std::string(place) + " lies",
                     "ports.cuts", "give a point inside the segmentation, in mm LPS");
  }
  if (cut.normalLps) {
    CutPlane plane{p, cut.normalLps->normalized()};
    plane.pointLps = onAxis(*vessel, plane);
    return plane;
  }
  const CutPlane forward{vessel->centreLps, vessel->axisLps};
  const CutPlane backward{vessel->centreLps, -vessel->axisLps};
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
      plan.away = cutAway(field, phi, planes, names, progress);
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
    names.push_back(cut.name);
  }
  const Skeleton skeleton = skeletonOf(phi, progress);
  CutAway away = cutAway(field, phi, planes, names, progress);
  if (params.cutEndsRadii > 0.0) {
    EndPlan ends = planEndCuts(field, phi, skeleton, away, params.cutEndsRadii, progress);
    remarks.insert(remarks.end(), ends.remarks.begin(), ends.remarks.end());
    if (!ends.planes.empty()) away = std::move(ends.away);
  }
  if (params.cutBorders)
    for (std::string& remark : addBorderCuts(field, phi, away, progress))
      remarks.push_back(std::move(remark));
  for (const PortAdvice& advice : portAdvice(skeleton, away))
    remarks.push_back(away.nameOf(advice.cut) + " " + advice.words);
  return away;
}

}  // namespace angiomesh
