// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/port_job.h"

#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/centreline/vessel_at.h"
#include "core/cuts/border_cuts.h"
#include "core/cuts/clip_reference.h"
#include "core/cuts/port_advice.h"
#include "core/field/wall_field.h"

namespace angiomesh {

std::string portWords(std::string message) {
  for (const char* place : {", surface cuts: ", ", ports.cuts: "})
    if (const std::size_t at = message.find(place); at != std::string::npos)
      message.replace(at, std::string(place).size(), ": ");
  return message;
}

void PortJob::execute() noexcept {
  try {
    prepare(kind == Kind::Advise || kind == Kind::CutEnds);
    if (kind == Kind::CutHere) {
      cutHere();
      return;
    }
    Made made = check();
    if (kind == Kind::Advise) {
      advise(made);
    } else if (kind == Kind::CutAllAcross) {
      cutAllAcross(std::move(made.away));
    } else if (kind == Kind::CutEnds) {
      EndPlan plan = planEndCuts(*ground.field, *ground.phi, *ground.skeleton, made.away,
                                 radiiFromTip, progress);
      proposed = std::move(plan.planes);
      names = std::move(plan.names);
      remarks = std::move(plan.remarks);
    }
  } catch (const Cancelled&) {
    cancelled = true;
  } catch (const std::exception& failure) {
    error = portWords(failure.what());
  }
}

void PortJob::prepare(bool withSkeleton) {
  if (!ground.field)
    ground.field = std::make_shared<const SplineField>(wallField(*ground.phi, ground.spline));
  progress.check();
  if (withSkeleton && !ground.skeleton)
    ground.skeleton = std::make_shared<const Skeleton>(skeletonOf(*ground.phi, progress));
}

PortJob::Made PortJob::check() {
  findings.resize(cuts.size());
  std::vector<std::size_t> possible;
  std::vector<CutPlane> planes(cuts.size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    progress.check();
    CutFinding& finding = findings[i];
    try {
      planes[i] = placeCut(*ground.field, *ground.phi, parseCut(cuts[i]), progress);
      finding.plane = planes[i];
      const Section section = sectionOf(*ground.field, planes[i]);
      finding.plane->pointLps = section.centreLps;
      finding.radiusMm = section.radiusMm;
      finding.areaMm2 = section.areaMm2;
      possible.push_back(i);
    } catch (const Error& failure) {
      finding.error = portWords(failure.what());
    }
  }
  return together(possible, planes);
}

/// One that cannot be made with the others is left out, and says why.
PortJob::Made PortJob::together(const std::vector<std::size_t>& possible,
                                const std::vector<CutPlane>& planes) {
  const auto attempt = [&](const std::vector<std::size_t>& which) {
    std::vector<CutPlane> chosen;
    std::vector<std::string> cutNames;
    for (const std::size_t i : which) {
      chosen.push_back(planes[i]);
      cutNames.push_back(parseCut(cuts[i]).name);
    }
    return checkedCutAway(*ground.field, *ground.phi, chosen, cutNames, progress);
  };
  try {
    return {possible, attempt(possible)};
  } catch (const Error&) {
    // Which ones is found out one after the other.
  }
  Made made;
  for (const std::size_t i : possible) {
    made.cuts.push_back(i);
    try {
      made.away = attempt(made.cuts);
    } catch (const Error& failure) {
      findings[i].error = portWords(failure.what());
      made.cuts.pop_back();
    }
  }
  return made;
}

void PortJob::advise(const Made& made) {
  for (PortAdvice& advice : portAdvice(*ground.skeleton, made.away))
    findings[made.cuts[advice.cut]].advice.push_back(std::move(advice.words));
  for (CutFinding& finding : findings) {
    finding.advised = true;
    if (!finding.plane) continue;
    if (const auto place =
            placeOnSkeleton(*ground.skeleton, *ground.field, finding.plane->pointLps))
      for (const SkeletonPoint& point :
           ground.skeleton->branches[static_cast<std::size_t>(place->branch)].points)
        finding.path.push_back(point.pointLps);
  }
}

void PortJob::cutAllAcross(CutAway away) {
  const std::size_t before = away.sections.size();
  remarks = addBorderCuts(*ground.field, *ground.phi, away, {}, progress);
  const std::vector<CutPlane> planes = away.planes();
  proposed.assign(planes.begin() + static_cast<std::ptrdiff_t>(before), planes.end());
  names.assign(away.names.begin() + static_cast<std::ptrdiff_t>(before), away.names.end());
}

void PortJob::cutHere() {
  const std::optional<LocalVessel> vessel = vesselAt(*ground.field, pointLps);
  if (!vessel) {
    error = "there is no vessel at " + placeText(pointLps) +
            ": choose a place inside the segmentation or on its wall";
    return;
  }
  try {
    proposed.push_back(
        placeCut(*ground.field, *ground.phi, {vessel->centreLps, {}, "cut"}, progress));
  } catch (const InputError&) {
    // Neither side can go, as of a ring: the list says so, and the cut can be moved from here.
    proposed.push_back({vessel->centreLps, vessel->axisLps});
  }
}

}  // namespace angiomesh
