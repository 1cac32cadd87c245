// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_ports.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/surface/flat_area.h"

namespace angiomesh {

namespace {

constexpr int kPollMilliseconds = 33;
/// Of a cut that no vessel is known of, in voxels.
constexpr double kUnknownRadius = 4.0;

/// As a cut is written by hand: micrometres, and directions to as little.
GivenCut written(const CutPlane& plane, const std::string& name) {
  GivenCut cut;
  cut.name = name;
  cut.normalLps = plane.normalLps;
  for (int a = 0; a < 3; ++a) {
    cut.pointLps[a] = std::round(plane.pointLps[a] * 1e3) / 1e3;
    (*cut.normalLps)[a] = std::round(plane.normalLps[a] * 1e5) / 1e5;
  }
  return cut;
}

std::string nameOf(const std::string& text) { return parseCut(text).name; }

}  // namespace

double PortRow::diameterMm() const { return equivalentDiameterMm(areaMm2); }

CasePorts::CasePorts(CaseController& controller, const JobRunnerFactory& makeRunner,
                     QObject* parent)
    : QObject(parent), controller_(controller), runner_(makeRunner()) {
  timer_.setInterval(kPollMilliseconds);
  connect(&timer_, &QTimer::timeout, this, &CasePorts::poll);
  connect(&controller_, &CaseController::caseChanged, this, [this] {
    selected_.clear();
    notice_.clear();
    drag_.reset();
    refresh();
  });
  connect(&controller_, &CaseController::parametersChanged, this, &CasePorts::refresh);
  connect(&controller_, &CaseController::resultsChanged, this, &CasePorts::refresh);
  connect(&controller_, &CaseController::statesChanged, this, &CasePorts::refresh);
  refresh();
}

CasePorts::~CasePorts() {
  queue_.clear();
  if (job_) {
    job_->progress.cancel();
  }
  runner_->wait();
}

const PortRow* CasePorts::find(const QString& name) const {
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const PortRow& row) { return row.name == name; });
  return found == rows_.end() ? nullptr : &*found;
}

void CasePorts::select(const QString& name) {
  if (selected_ != name) {
    selected_ = name;
    Q_EMIT changed();
  }
}

void CasePorts::visit(const QString& name) {
  select(name);
  if (const PortRow* row = selected()) {
    const Eigen::Vector3d& p = row->plane.pointLps;
    Q_EMIT goTo(p[0], p[1], p[2], row->radiusMm);
  }
}

std::vector<std::array<double, 3>> CasePorts::colours(const std::vector<Port>& ports) const {
  std::vector<std::array<double, 3>> all;
  for (const Port& port : ports) {
    const PortRow* row = find(QString::fromStdString(port.name));
    all.push_back(row ? row->colour : std::array<double, 3>{0.6, 0.6, 0.6});
  }
  return all;
}

QString CasePorts::freeName() const {
  std::set<std::string> taken;
  for (const std::string& text : cuts()) {
    taken.insert(nameOf(text));
  }
  if (taken.count("inlet") == 0) {
    return QStringLiteral("inlet");
  }
  QString name = QStringLiteral("outlet");
  for (int n = 2; taken.count(name.toStdString()) != 0; ++n) {
    name = QStringLiteral("outlet-%1").arg(n);
  }
  return name;
}

std::optional<std::size_t> CasePorts::indexOf(const QString& name) const {
  const std::vector<std::string> all = cuts();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (QString::fromStdString(nameOf(all[i])) == name) {
      return i;
    }
  }
  return std::nullopt;
}

CutPlane CasePorts::planeOf(const std::string& text) const {
  const auto found = findings_.find(text);
  if (found != findings_.end() && found->second.plane) {
    return *found->second.plane;
  }
  const GivenCut cut = parseCut(text);
  return {cut.pointLps,
          cut.normalLps ? cut.normalLps->normalized() : Eigen::Vector3d(0.0, 0.0, 1.0)};
}

bool CasePorts::replace(const QString& name, const GivenCut& cut, const QString& what) {
  std::vector<std::string> all = cuts();
  const auto index = indexOf(name);
  if (!index) {
    return false;
  }
  all[*index] = cutText(cut);
  notice_ = QString::fromStdString(portWords(controller_.setCuts(all, what).toStdString()));
  if (!notice_.isEmpty()) {
    Q_EMIT changed();
  }
  return notice_.isEmpty();
}

void CasePorts::cutHere(const Eigen::Vector3d& lps) {
  if (!ready()) {
    tell(Severity::Warning, tr("There are no vessels to cut yet: run to Evolve first."));
    return;
  }
  auto job = std::make_shared<PortJob>();
  job->kind = PortJob::Kind::CutHere;
  job->pointLps = lps;
  request(std::move(job));
}

void CasePorts::cutEnds(double radii) {
  if (!ready()) {
    tell(Severity::Warning, tr("There are no vessels to cut yet: run to Evolve first."));
    return;
  }
  auto job = std::make_shared<PortJob>();
  job->kind = PortJob::Kind::CutEnds;
  job->cuts = cuts();
  job->radiiFromTip = radii;
  request(std::move(job));
}

void CasePorts::flip(const QString& name) {
  if (const auto index = indexOf(name)) {
    CutPlane plane = planeOf(cuts()[*index]);
    plane.normalLps = -plane.normalLps;
    replace(name, written(plane, name.toStdString()), tr("flip the cut %1").arg(name));
  }
}

void CasePorts::remove(const QString& name) {
  if (const auto index = indexOf(name)) {
    std::vector<std::string> all = cuts();
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(*index));
    notice_.clear();
    controller_.setCuts(all, tr("delete the cut %1").arg(name));
  }
}

QString CasePorts::rename(const QString& name, const QString& wanted) {
  const auto index = indexOf(name);
  const QString trimmed = wanted.trimmed();
  if (!index || trimmed == name) {
    return {};
  }
  QString refusal;
  try {
    checkPortName(trimmed.toStdString());
    GivenCut cut = parseCut(cuts()[*index]);
    cut.name = trimmed.toStdString();
    const bool chosen = selected_ == name;
    if (chosen) {
      selected_ = trimmed;  // told once, with the rows
    }
    colourNumbers_.rename(name, trimmed);
    if (!replace(name, cut, tr("rename the cut %1 to %2").arg(name, trimmed))) {
      refusal = notice_;
      colourNumbers_.rename(trimmed, name);
      selected_ = chosen ? name : selected_;
    }
  } catch (const Error& failure) {
    refusal = QString::fromStdString(portWords(failure.what()));
  }
  if (!refusal.isEmpty()) {
    notice_ = refusal;
    Q_EMIT changed();
  }
  return refusal;
}

void CasePorts::drag(const QString& name, const CutPlane& plane) {
  const auto row = std::find_if(rows_.begin(), rows_.end(),
                                [&](const PortRow& each) { return each.name == name; });
  if (row == rows_.end() || !row->cut) {
    return;
  }
  const bool tilted = (plane.pointLps - row->plane.pointLps).norm() < 1e-9;
  if (!drag_ || drag_->name != name) {
    drag_ = Drag{name, plane, tilted};
  }
  drag_->plane = plane;
  drag_->tilted = drag_->tilted && tilted;
  row->plane = plane;
  Q_EMIT dragged();
}

void CasePorts::drop() {
  if (const std::optional<Drag> drag = std::exchange(drag_, std::nullopt)) {
    const QString what = drag->tilted ? tr("tilt the cut %1") : tr("move the cut %1");
    replace(drag->name, written(drag->plane, drag->name.toStdString()), what.arg(drag->name));
  }
}

void CasePorts::tell(Severity severity, const QString& text) {
  notice_ = text;
  Q_EMIT controller_.message(severity, text);
  Q_EMIT changed();
}

void CasePorts::refreshGround() {
  const std::shared_ptr<const Volume<float>> phi = controller_.uncutPhi();
  const SplineKind spline = controller_.parameters().surface.spline;
  if (phi == ground_.phi && spline == ground_.spline) {
    return;
  }
  ground_ = {phi, spline, nullptr, nullptr};
  findings_.clear();
  checked_.clear();
  queue_.clear();
  if (job_) {
    job_->progress.cancel();
  }
}

void CasePorts::refresh() {
  refreshGround();
  requestCheck();
  rebuild();
}

PortRow CasePorts::cutRow(const std::string& text) const {
  PortRow row;
  row.cut = true;
  row.name = QString::fromStdString(nameOf(text));
  row.plane = planeOf(text);
  const auto image = controller_.image();
  row.radiusMm = kUnknownRadius * (image ? image->geometry.voxelMm() : 1.0);
  const auto found = findings_.find(text);
  if (found == findings_.end()) {
    // A disc that was just moved keeps its size until it was looked at.
    if (const PortRow* before = find(row.name); before && before->cut) {
      row.radiusMm = before->radiusMm;
      row.path = before->path;
    }
    row.note = ready() ? tr("being looked at") : tr("run to Evolve to see where it lies");
  } else {
    const CutFinding& finding = found->second;
    row.path = finding.path;
    if (finding.areaMm2 > 0.0) {
      row.areaMm2 = finding.areaMm2;
      row.radiusMm = finding.radiusMm;
    }
    QStringList words;
    // What the mesher alone finds is known once it has failed.
    const QString failure = controller_.failure(Step::Surface);
    const bool failed = failure.contains(QStringLiteral("the cut '%1'").arg(row.name));
    if (!finding.error.empty() || failed) {
      row.state = PortRow::State::Impossible;
      words << QString::fromStdString(failed ? portWords(failure.toStdString()) : finding.error);
    } else {
      row.state = finding.advice.empty() ? PortRow::State::Good : PortRow::State::Advised;
      for (const std::string& sentence : finding.advice) {
        words << QString::fromStdString(sentence);
      }
    }
    if (controller_.meshFresh() && !hasPort(nameOf(text))) {
      row.state = PortRow::State::Advised;
      words << tr("left out of the surface with the part that it ends");
    } else if (words.isEmpty()) {
      words << (controller_.meshFresh() ? tr("made") : tr("run to make it"));
    }
    row.note = words.join(QStringLiteral(". "));
  }
  if (drag_ && drag_->name == row.name) {
    row.plane = drag_->plane;
  }
  return row;
}

std::vector<Port> CasePorts::meshPorts() const {
  return controller_.ports(controller_.mesh(MeshKind::Exported) ? MeshKind::Exported
                                                                : MeshKind::Unsmoothed);
}

bool CasePorts::hasPort(const std::string& name) const {
  const std::vector<Port> ports = meshPorts();
  return std::any_of(ports.begin(), ports.end(),
                     [&](const Port& port) { return port.name == name; });
}

/// Of the last mesh those that are no cuts, neither then nor now.
void CasePorts::addOpenings(std::vector<PortRow>& rows) const {
  const Parameters* then = controller_.meshParameters();
  std::set<std::string> known;
  for (const auto& list : {then ? then->ports.cuts : std::vector<std::string>(), cuts()}) {
    for (const std::string& text : list) {
      known.insert(nameOf(text));
    }
  }
  for (const Port& port : meshPorts()) {
    if (known.count(port.name) != 0) {
      continue;
    }
    PortRow row;
    row.name = QString::fromStdString(port.name);
    row.plane = {port.centreLps, port.normalLps};
    row.areaMm2 = port.areaMm2;
    row.radiusMm = 0.5 * port.equivalentDiameterMm();
    row.state = PortRow::State::Good;
    row.note = row.name.startsWith(QLatin1String("border_")) ? tr("at the volume's border")
                                                             : tr("end cut automatically");
    if (!controller_.meshFresh()) {
      row.note += tr(", in the last mesh");
    }
    rows.push_back(std::move(row));
  }
}

void CasePorts::rebuild() {
  std::vector<PortRow> rows;
  for (const std::string& text : cuts()) {
    rows.push_back(cutRow(text));
  }
  addOpenings(rows);
  QStringList names;
  for (const PortRow& row : rows) {
    names << row.name;
  }
  colourNumbers_.use(names);
  for (PortRow& row : rows) {
    row.colour = portColour(colourNumbers_.of(row.name));
  }
  rows_ = std::move(rows);
  Q_EMIT changed();
}

void CasePorts::request(std::shared_ptr<PortJob> job) {
  queue_.push_back(std::move(job));
  startNext();
}

void CasePorts::requestCheck() {
  const std::vector<std::string> wanted = cuts();
  if (!ready() || wanted.empty() || wanted == checked_) {
    return;
  }
  checked_ = wanted;
  const auto looking = [](const std::shared_ptr<PortJob>& job) {
    return job->kind == PortJob::Kind::Check || job->kind == PortJob::Kind::Advise;
  };
  std::erase_if(queue_, looking);
  if (job_ && looking(job_)) {
    job_->progress.cancel();
  }
  auto job = std::make_shared<PortJob>();
  job->cuts = wanted;
  request(std::move(job));
}

void CasePorts::startNext() {
  if (job_ || queue_.empty()) {
    return;
  }
  job_ = queue_.front();
  queue_.pop_front();
  job_->ground = ground_;
  runner_->start([job = job_] { job->execute(); });
  if (runner_->running()) {
    timer_.start();
    Q_EMIT changed();
  } else {
    finish();
  }
}

void CasePorts::poll() {
  if (job_ && !runner_->running()) {
    finish();
  }
  if (!job_) {
    timer_.stop();
  }
}

void CasePorts::finish() {
  const std::shared_ptr<PortJob> job = std::exchange(job_, nullptr);
  const bool present = job->ground.phi == ground_.phi && job->ground.spline == ground_.spline;
  if (present) {
    ground_ = job->ground;
  }
  if (present && !job->cancelled) {
    switch (job->kind) {
      case PortJob::Kind::Check:
      case PortJob::Kind::Advise:
        if (job->cuts == cuts()) {
          findings_.clear();
          for (std::size_t i = 0; i < job->findings.size(); ++i) {
            findings_[job->cuts[i]] = std::move(job->findings[i]);
          }
          if (job->kind == PortJob::Kind::Check) {
            auto next = std::make_shared<PortJob>();
            next->kind = PortJob::Kind::Advise;
            next->cuts = job->cuts;
            queue_.push_back(std::move(next));
          }
        } else if (job->cuts == checked_) {
          checked_.clear();  // they may come back
        }
        break;
      case PortJob::Kind::CutHere:
        finishCutHere(*job);
        break;
      case PortJob::Kind::CutEnds:
        finishCutEnds(*job);
        break;
    }
  }
  rebuild();
  startNext();
}

void CasePorts::finishCutHere(const PortJob& job) {
  if (!job.error.empty() || job.proposed.empty()) {
    tell(Severity::Warning, QString::fromStdString(job.error));
    return;
  }
  const QString name = freeName();
  std::vector<std::string> all = cuts();
  all.push_back(cutText(written(job.proposed.front(), name.toStdString())));
  notice_.clear();
  selected_ = name;
  controller_.setCuts(all, tr("add the cut %1").arg(name));
}

void CasePorts::finishCutEnds(const PortJob& job) {
  if (!job.error.empty()) {
    tell(Severity::Warning, QString::fromStdString(job.error));
    return;
  }
  for (const std::string& remark : job.remarks) {
    Q_EMIT controller_.message(Severity::Warning, QString::fromStdString(remark));
  }
  std::vector<std::string> all = cuts();
  std::set<std::string> taken;
  for (const std::string& text : all) {
    taken.insert(nameOf(text));
  }
  int added = 0;
  for (std::size_t i = 0; i < job.proposed.size(); ++i) {
    if (taken.insert(job.names[i]).second) {
      all.push_back(cutText(written(job.proposed[i], job.names[i])));
      ++added;
    }
  }
  if (added == 0) {
    tell(Severity::Warning,
         tr("No end was cut: no vessel ends in the volume without a cut already."));
    return;
  }
  notice_ = job.remarks.empty()
                ? QString()
                : tr("%1 ends were not cut: the log says why.").arg(job.remarks.size());
  controller_.setCuts(all, tr("cut all ends"));
}

}  // namespace angiomesh
