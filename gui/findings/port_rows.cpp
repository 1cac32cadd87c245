// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/port_rows.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>
#include <utility>

#include "core/mesh/flat_area.h"

namespace angiomesh {

namespace {

/// Of a cut that no vessel is known of, in voxels.
constexpr double kUnknownRadius = 4.0;

struct Words {
  Q_DECLARE_TR_FUNCTIONS(CasePorts)
};

std::vector<Port> meshPorts(const CaseModels& models) {
  return models.results.ports(models.results.kindAtHand(MeshKind::Exported));
}

bool isMade(const CaseModels& models, const QString& name) {
  const std::vector<Port> ports = meshPorts(models);
  return std::any_of(ports.begin(), ports.end(),
                     [&](const Port& port) { return QString::fromStdString(port.name) == name; });
}

/// What there is to say of a cut that was looked at.
void tell(const CutFinding& finding, const CaseModels& models, PortRow& row) {
  QStringList words;
  // What the mesher alone finds is known once it has failed.
  const QString failure = models.runs.failure(Step::Surface);
  const bool failed = failure.contains(QStringLiteral("the cut '%1'").arg(row.name));
  if (!finding.error.empty() || failed) {
    row.state = PortRow::State::Impossible;
    words << QString::fromStdString(failed ? portWords(failure.toStdString()) : finding.error);
  } else {
    row.state = finding.advice.empty() ? PortRow::State::Good : PortRow::State::Advised;
    for (const std::string& sentence : finding.advice) words << QString::fromStdString(sentence);
  }
  if (models.results.meshFresh() && !isMade(models, row.name)) {
    row.state = PortRow::State::Advised;
    words << Words::tr("left out of the surface with the part that it ends");
  } else if (words.isEmpty()) {
    words << (models.results.meshFresh() ? Words::tr("made") : Words::tr("run to make it"));
  }
  row.note = words.join(QStringLiteral(". "));
}

PortRow openingRow(const Port& port) {
  PortRow row;
  row.name = QString::fromStdString(port.name);
  row.plane = {port.centreLps, port.normalLps};
  row.areaMm2 = port.areaMm2;
  row.radiusMm = 0.5 * port.equivalentDiameterMm();
  row.state = PortRow::State::Good;
  row.note = port.atBorder ? Words::tr("at the volume's border") : Words::tr("cut automatically");
  if (port.slant && port.slant->flagged()) {
    row.state = PortRow::State::Advised;
    row.across = CutPlane{port.slant->centreLps, port.slant->axisLps};
    row.note = Words::tr(
                   "slices its vessel: %1° off its axis, %2 times its section; Cut across "
                   "ends it just inside")
                   .arg(port.slant->angleDeg, 0, 'f', 0)
                   .arg(port.slant->areaRatio, 0, 'f', 2);
  }
  return row;
}

}  // namespace

double PortRow::diameterMm() const { return equivalentDiameterMm(areaMm2); }

CutPlane planeOf(const std::string& cut, const CutFinding* finding) {
  if (finding && finding->plane) return *finding->plane;
  const GivenCut given = parseCut(cut);
  return {given.pointLps,
          given.normalLps ? given.normalLps->normalized() : Eigen::Vector3d(0.0, 0.0, 1.0)};
}

PortRow cutRow(const std::string& cut, const CutFinding* finding, const CaseModels& models) {
  PortRow row;
  row.cut = true;
  row.name = QString::fromStdString(parseCut(cut).name);
  row.plane = planeOf(cut, finding);
  const auto image = models.document.image();
  row.radiusMm = kUnknownRadius * (image ? image->geometry.voxelMm() : 1.0);
  if (!finding) {
    row.note = models.results.uncutPhi() ? Words::tr("being looked at")
                                         : Words::tr("run to Evolve to see where it lies");
    return row;
  }
  row.path = finding->path;
  if (finding->areaMm2 > 0.0) {
    row.areaMm2 = finding->areaMm2;
    row.radiusMm = finding->radiusMm;
  }
  tell(*finding, models, row);
  return row;
}

std::vector<PortRow> openingRows(const CaseModels& models) {
  std::set<std::string> cuts = cutNames(models.document.parameters().ports.cuts);
  if (const Parameters* then = models.results.meshParameters())
    cuts.merge(cutNames(then->ports.cuts));
  std::vector<PortRow> rows;
  for (const Port& port : meshPorts(models)) {
    if (cuts.count(port.name) != 0) continue;
    rows.push_back(openingRow(port));
    if (!models.results.meshFresh()) rows.back().note += Words::tr(", in the last mesh");
  }
  return rows;
}

}  // namespace angiomesh
