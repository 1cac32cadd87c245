// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/port_edits.h"

#include <cmath>

namespace angiomesh {

namespace {

Eigen::Vector3d rounded(const Eigen::Vector3d& vector, double steps) {
  return vector.unaryExpr([steps](double value) { return std::round(value * steps) / steps; });
}

void forget(PortParams& ports, const std::set<std::string>& names) {
  std::erase_if(ports.cuts,
                [&](const std::string& text) { return names.count(parseCut(text).name) != 0; });
  std::erase_if(ports.names, [&](const std::string& text) {
    return names.count(parsePortNaming(text).name) != 0;
  });
}

}  // namespace

GivenCut writtenCut(const CutPlane& plane, const std::string& name) {
  return {rounded(plane.pointLps, 1e3), rounded(plane.normalLps, 1e5), name};
}

std::set<std::string> namesIn(const PortParams& ports) {
  std::set<std::string> names = cutNames(ports.cuts);
  for (const std::string& text : ports.names) names.insert(parsePortNaming(text).name);
  return names;
}

std::string freePortName(const PortParams& ports) {
  const std::set<std::string> taken = namesIn(ports);
  if (taken.count("inlet") == 0) return "inlet";
  std::string name = "outlet";
  for (int n = 2; taken.count(name) != 0; ++n) name = "outlet-" + std::to_string(n);
  return name;
}

PortParams withOpeningNamed(PortParams ports, const std::string& name,
                            const Eigen::Vector3d& placeLps, const std::string& wanted) {
  forget(ports, {name});
  if (!wanted.empty()) ports.names.push_back(portNamingText({"", rounded(placeLps, 1e3), wanted}));
  return ports;
}

PortParams withPortsRead(PortParams ports, const PortParams& read) {
  forget(ports, namesIn(read));
  ports.cuts.insert(ports.cuts.end(), read.cuts.begin(), read.cuts.end());
  ports.names.insert(ports.names.end(), read.names.begin(), read.names.end());
  return ports;
}

}  // namespace angiomesh
