// SPDX-License-Identifier: BSD-3-Clause
#include "io/vessel/measurements_file.h"

#include <array>
#include <cmath>
#include <optional>

#include "core/base/formatted.h"
#include "core/measure/vessel_profile.h"
#include "io/file/files.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Value = std::optional<double>;

/// A line of the table. Lengths in mm, shares in percent.
struct Line {
  const char* part = "whole";
  std::optional<Vector3d> place;
  Value along, length, area, equivalent, least, greatest, nascet, wasid, byArea;
};

const char* const kHeader =
    "name,kind,part,x_mm,y_mm,z_mm,along_mm,length_mm,area_mm2,equivalent_diameter_mm,"
    "min_diameter_mm,max_diameter_mm,nascet_percent,wasid_percent,area_stenosis_percent,"
    "parameters\n";

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + "\"";
}

/// To 1e-4, with a point in any locale.
std::string numberText(const Value& value) {
  return value ? shortestText(std::round(*value * 1e4) / 1e4) : "";
}

Line lineOf(const char* part, const CrossSection& section) {
  Line line;
  line.part = part;
  line.place = section.centreLps;
  line.area = section.areaMm2;
  line.equivalent = section.equivalentDiameterMm();
  line.least = section.minDiameterMm();
  line.greatest = section.maxDiameterMm();
  return line;
}

std::vector<Line> linesOf(const Measurement& m) {
  std::vector<Line> lines(1);
  if (m.kind == MeasurementKind::Distance) {
    lines[0].length = (m.places[1] - m.places[0]).norm();
    for (const std::size_t end : {0, 1}) {
      lines.emplace_back();
      lines.back().part = end == 0 ? "from" : "to";
      lines.back().place = m.places[end];
    }
  } else if (m.kind == MeasurementKind::Section) {
    lines[0] = lineOf("whole", m.sections[0]);
  } else {
    lines[0].length = m.profile.back().alongMm - m.profile.front().alongMm;
  }
  if (m.kind == MeasurementKind::Stenosis) {
    const StenosisDegree degree = stenosisDegree(m);
    lines[0].nascet = 100.0 * degree.nascet;
    lines[0].wasid = 100.0 * degree.wasid;
    lines[0].byArea = 100.0 * degree.area;
    const std::array<const char*, 3> parts{"narrowest", "proximal", "distal"};
    for (std::size_t i = 0; i < parts.size(); ++i) lines.push_back(lineOf(parts[i], m.sections[i]));
  }
  for (const ProfilePoint& point : m.profile) {
    lines.emplace_back();
    Line& line = lines.back();
    line.part = "along";
    line.place = point.pointLps;
    line.along = point.alongMm;
    line.equivalent = point.diameterMm;
    line.least = point.minDiameterMm;
    line.greatest = point.maxDiameterMm;
  }
  return lines;
}

}  // namespace

std::string measurementsTable(const std::vector<Measurement>& measurements,
                              const std::string& key) {
  std::string table = kHeader;
  for (const Measurement& m : measurements) {
    const std::string state = m.key.empty() ? "" : m.key == key ? "present" : "earlier";
    for (const Line& line : linesOf(m)) {
      table += quoted(m.name) + "," + measurementWord(m.kind) + "," + line.part;
      for (int axis = 0; axis < 3; ++axis)
        table += "," + numberText(line.place ? Value((*line.place)[axis]) : Value());
      for (const Value& value : {line.along, line.length, line.area, line.equivalent, line.least,
                                 line.greatest, line.nascet, line.wasid, line.byArea})
        table += "," + numberText(value);
      table += "," + state + "\n";
    }
  }
  return table;
}

void writeMeasurements(const std::filesystem::path& path,
                       const std::vector<Measurement>& measurements, const std::string& key) {
  writeText(path, measurementsTable(measurements, key));
}

}  // namespace angiomesh
