// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/port_job.h"

#include <cstdio>
#include <exception>
#include <utility>

#include "core/base/error.h"
#include "core/quality/port_advice.h"
#include "core/quality/vessel_at.h"

namespace angiomesh {

std::string portWords(std::string message) {
  for (const char* place : {", surface cuts: ", ", ports.cuts: "}) {
    if (const std::size_t at = message.find(place); at != std::string::npos) {
      message.replace(at, std::string(place).size(), ": ");
    }
  }
  return message;
}

void PortJob::execute() noexcept {
  try {
    prepare(kind == Kind::Advise || kind == Kind::CutEnds);
    if (kind == Kind::CutHere) {
      cutHere();
      return;
    }
    const CutAway away = check();
    if (kind == Kind::Advise) {
      advise(away);
    } else if (kind == Kind::CutEnds) {
      EndPlan plan =
          planEndCuts(*ground.field, *ground.phi, *ground.skeleton, away, radiiFromTip, progress);
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
  if (!ground.field) {
    ground.field = std::make_shared<const SplineField>(*ground.phi, ground.spline);
  }
  progress.check();
  if (withSkeleton && !ground.skeleton) {
    ground.skeleton = std::make_shared<const Skeleton>(skeletonOf(*ground.phi, progress));
  }
}

CutAway PortJob::check() {
  findings.resize(cuts.size());
  std::vector<std::size_t> made;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    progress.check();
    CutFinding& finding = findings[i];
    try {
      const CutPlane plane = placeCut(*ground.field, *ground.phi, parseCut(cuts[i]), progress);
      finding.plane = plane;
      const Section section = sectionOf(*ground.field, plane);
      finding.plane->pointLps = section.centreLps;
      finding.radiusMm = section.radiusMm;
      finding.areaMm2 = section.areaMm2;
      made.push_back(i);
    } catch (const Error& failure) {
      finding.error = portWords(failure.what());
    }
  }
  return together(made);
}

/// The cuts that can be made together: one that cannot is left out, and says why.
CutAway PortJob::together(std::vector<std::size_t>& made) {
  const auto attempt = [&](const std::vector<std::size_t>& which) {
    std::vector<CutPlane> planes;
    std::vector<std::string> cutNames;
    for (const std::size_t i : which) {
      const GivenCut cut = parseCut(cuts[i]);
      planes.push_back(placeCut(*ground.field, *ground.phi, cut, progress));
      cutNames.push_back(cut.name);
    }
    return cutAway(*ground.field, *ground.phi, planes, cutNames, progress);
  };
  try {
    return attempt(made);
  } catch (const Error&) {
    // Which ones is found out one after the other.
  }
  std::vector<std::size_t> good;
  CutAway away;
  for (const std::size_t i : made) {
    good.push_back(i);
    try {
      away = attempt(good);
    } catch (const Error& failure) {
      findings[i].error = portWords(failure.what());
      good.pop_back();
    }
  }
  made = good;
  return away;
}

void PortJob::advise(const CutAway& away) {
  const std::vector<std::string> sentences = portAdvice(*ground.skeleton, away);
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    CutFinding& finding = findings[i];
    finding.advised = true;
    const std::string start = "the cut '" + parseCut(cuts[i]).name + "' ";
    for (const std::string& sentence : sentences) {
      if (sentence.starts_with(start)) {
        finding.advice.push_back(sentence.substr(start.size()));
      }
    }
    if (!finding.plane) {
      continue;
    }
    if (const auto place =
            placeOnSkeleton(*ground.skeleton, *ground.field, finding.plane->pointLps)) {
      for (const SkeletonPoint& point :
           ground.skeleton->branches[static_cast<std::size_t>(place->branch)].points) {
        finding.path.push_back(point.pointLps);
      }
    }
  }
}

void PortJob::cutHere() {
  const std::optional<LocalVessel> vessel = vesselAt(*ground.field, pointLps);
  if (!vessel) {
    char text[160];
    std::snprintf(text, sizeof text,
                  "there is no vessel at L %.1f P %.1f S %.1f mm: choose a place inside the "
                  "segmentation or on its wall",
                  pointLps.x(), pointLps.y(), pointLps.z());
    error = text;
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
