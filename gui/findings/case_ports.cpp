// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/case_ports.h"

#include <algorithm>
#include <set>
#include <utility>

#include "core/base/error.h"
#include "core/openings/port_colour.h"
#include "gui/findings/port_edits.h"
#include "io/vessel/ports_file.h"

namespace angiomesh {

namespace {

std::string nameOf(const std::string& text) { return parseCut(text).name; }

}  // namespace

CasePorts::CasePorts(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<PortJob>& job) { finish(*job); }) {
  connect(&models_.files, &CaseFiles::caseChanged, this, [this] {
    selected_.clear();
    notice_.clear();
    drag_.reset();
    refresh();
  });
  connect(&models_.document, &CaseDocument::parametersChanged, this, &CasePorts::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &CasePorts::refresh);
  connect(&models_.runs, &RunModel::statesChanged, this, &CasePorts::refresh);
  refresh();
}

CasePorts::~CasePorts() {
  queue_.clear();
  if (slot_) slot_.job()->progress.cancel();
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
  return QString::fromStdString(freePortName(models_.document.parameters().ports));
}

std::optional<std::size_t> CasePorts::indexOf(const QString& name) const {
  const std::vector<std::string> all = cuts();
  for (std::size_t i = 0; i < all.size(); ++i)
    if (QString::fromStdString(nameOf(all[i])) == name) return i;
  return std::nullopt;
}

const CutFinding* CasePorts::findingOf(const std::string& text) const {
  const auto found = findings_.find(text);
  return found == findings_.end() ? nullptr : &found->second;
}

bool CasePorts::replace(const QString& name, const GivenCut& cut, const QString& what) {
  std::vector<std::string> all = cuts();
  const auto index = indexOf(name);
  if (!index) return false;
  all[*index] = cutText(cut);
  notice_ = QString::fromStdString(portWords(models_.document.setCuts(all, what).toStdString()));
  if (!notice_.isEmpty()) Q_EMIT changed();
  return notice_.isEmpty();
}

void CasePorts::cutHere(const Eigen::Vector3d& lps) {
  auto job = std::make_shared<PortJob>();
  job->kind = PortJob::Kind::CutHere;
  job->pointLps = lps;
  requestCuts(std::move(job));
}

void CasePorts::cutEnds(double radii) {
  auto job = std::make_shared<PortJob>();
  job->kind = PortJob::Kind::CutEnds;
  job->cuts = cuts();
  job->radiiFromTip = radii;
  requestCuts(std::move(job));
}

void CasePorts::cutAllAcross() {
  auto job = std::make_shared<PortJob>();
  job->kind = PortJob::Kind::CutAllAcross;
  job->cuts = cuts();
  requestCuts(std::move(job));
}

void CasePorts::cutAcross(const QString& name) {
  const PortRow* row = find(name);
  if (!row || !row->across) return;
  const CutPlane plane = *row->across;
  const auto same = [&](const std::string& text) {
    return (parseCut(text).pointLps - plane.pointLps).norm() < 0.5 * row->radiusMm;
  };
  const std::vector<std::string> before = cuts();
  if (std::any_of(before.begin(), before.end(), same)) {
    tell(Severity::Warning, tr("The vessel is cut there already: run to make the cut."));
    return;
  }
  PortParams after = models_.document.parameters().ports;
  const std::string chosen = nameAcross(plane, after, freePortName(after));
  after.cuts.push_back(cutText(writtenCut(plane, chosen)));
  selected_ = QString::fromStdString(chosen);
  notice_.clear();
  const QString refusal = models_.document.setPorts(after, tr("cut across %1").arg(name));
  if (!refusal.isEmpty()) tell(Severity::Warning, refusal);
}

/// A cut across an opening takes over the name that the user has given it.
std::string CasePorts::nameAcross(const CutPlane& plane, PortParams& ports,
                                  const std::string& otherwise) const {
  const std::set<std::string> given = namesIn(ports);
  for (const PortRow& row : rows_) {
    const std::string name = row.name.toStdString();
    if (row.cut || !row.across || given.count(name) == 0 ||
        (row.across->pointLps - plane.pointLps).norm() > row.radiusMm)
      continue;
    ports = withOpeningNamed(ports, name, row.plane.pointLps, {});
    return name;
  }
  return otherwise;
}

QString CasePorts::importPorts(const QString& path) {
  try {
    PortParams read;
    addPorts(readPorts(path.toStdString()), read);
    if (read.cuts.empty() && read.names.empty()) {
      throw InputError("there is no cut in it, and no opening with a name of its own",
                       path.toStdString(), "give the ports.json of a surface with cuts");
    }
    notice_.clear();
    const QString refusal = models_.document.setPorts(
        withPortsRead(models_.document.parameters().ports, read), tr("import ports"));
    if (!refusal.isEmpty()) tell(Severity::Error, refusal);
    return refusal;
  } catch (const Error& failure) {
    tell(Severity::Error, QString::fromStdString(failure.what()));
    return notice_;
  }
}

void CasePorts::flip(const QString& name) {
  if (const auto index = indexOf(name)) {
    const std::string text = cuts()[*index];
    CutPlane plane = planeOf(text, findingOf(text));
    plane.normalLps = -plane.normalLps;
    replace(name, writtenCut(plane, name.toStdString()), tr("flip the cut %1").arg(name));
  }
}

void CasePorts::remove(const QString& name) {
  if (const auto index = indexOf(name)) {
    std::vector<std::string> all = cuts();
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(*index));
    notice_.clear();
    models_.document.setCuts(all, tr("delete the cut %1").arg(name));
  }
}

QString CasePorts::rename(const QString& name, const QString& wanted) {
  const PortRow* row = find(name);
  const QString trimmed = wanted.trimmed();
  if (!row || trimmed == name) return {};
  QString refusal;
  try {
    const PortParams after =
        row->cut ? withCutNamed(*indexOf(name), trimmed.toStdString())
                 : withOpeningNamed(models_.document.parameters().ports, name.toStdString(),
                                    row->plane.pointLps, trimmed.toStdString());
    if (const PortRow* other = find(trimmed); other && !(other->cut && row->cut)) {
      throw InputError(trimmed.toStdString() + " is another port's name", "ports.names",
                       "choose another name");
    }
    refusal = renamed(name, trimmed, after,
                      row->cut ? tr("rename the cut %1 to %2") : tr("name the opening %1 %2"));
  } catch (const Error& failure) {
    refusal = QString::fromStdString(portWords(failure.what()));
  }
  if (!refusal.isEmpty()) {
    notice_ = refusal;
    Q_EMIT changed();
  }
  return refusal;
}

PortParams CasePorts::withCutNamed(std::size_t index, const std::string& name) const {
  checkPortName(name);
  PortParams ports = models_.document.parameters().ports;
  GivenCut cut = parseCut(ports.cuts[index]);
  cut.name = name;
  ports.cuts[index] = cutText(cut);
  return ports;
}

/// Selection and colour go with the name, and are told once, with the rows.
QString CasePorts::renamed(const QString& name, const QString& wanted, const PortParams& after,
                           const QString& what) {
  const bool chosen = selected_ == name && !wanted.isEmpty();
  if (chosen) selected_ = wanted;
  if (!wanted.isEmpty()) colourNumbers_.rename(name, wanted);
  notice_.clear();
  const QString refusal = QString::fromStdString(
      portWords(models_.document.setPorts(after, what.arg(name, wanted)).toStdString()));
  if (!refusal.isEmpty() && !wanted.isEmpty()) {
    colourNumbers_.rename(wanted, name);
    selected_ = chosen ? name : selected_;
  }
  return refusal;
}

void CasePorts::drag(const QString& name, const CutPlane& plane) {
  const auto row = std::find_if(rows_.begin(), rows_.end(),
                                [&](const PortRow& each) { return each.name == name; });
  if (row == rows_.end() || !row->cut) return;
  const bool tilted = (plane.pointLps - row->plane.pointLps).norm() < 1e-9;
  if (!drag_ || drag_->name != name) drag_ = Drag{name, plane, tilted};
  drag_->plane = plane;
  drag_->tilted = drag_->tilted && tilted;
  row->plane = plane;
  Q_EMIT dragged();
}

void CasePorts::drop() {
  if (const std::optional<Drag> drag = std::exchange(drag_, std::nullopt)) {
    const QString what = drag->tilted ? tr("tilt the cut %1") : tr("move the cut %1");
    replace(drag->name, writtenCut(drag->plane, drag->name.toStdString()), what.arg(drag->name));
  }
}

void CasePorts::tell(Severity severity, const QString& text) {
  notice_ = text;
  Q_EMIT models_.log.message(severity, text);
  Q_EMIT changed();
}

void CasePorts::refreshGround() {
  const std::shared_ptr<const Volume<float>> phi = models_.results.uncutPhi();
  const SplineKind spline = models_.document.parameters().surface.spline;
  if (phi == ground_.phi && spline == ground_.spline) return;
  ground_ = {phi, spline, nullptr, nullptr};
  findings_.clear();
  checked_.clear();
  queue_.clear();
  if (slot_) slot_.job()->progress.cancel();
}

void CasePorts::refresh() {
  refreshGround();
  requestCheck();
  rebuild();
}

PortRow CasePorts::cutRow(const std::string& text) const {
  const CutFinding* finding = findingOf(text);
  PortRow row = angiomesh::cutRow(text, finding, models_);
  // A disc that was just moved keeps its size until it was looked at.
  if (const PortRow* before = find(row.name); before && before->cut && !finding) {
    row.radiusMm = before->radiusMm;
    row.path = before->path;
  }
  if (drag_ && drag_->name == row.name) row.plane = drag_->plane;
  return row;
}

void CasePorts::rebuild() {
  std::vector<PortRow> rows;
  for (const std::string& text : cuts()) rows.push_back(cutRow(text));
  for (PortRow& row : openingRows(models_)) rows.push_back(std::move(row));
  QStringList names;
  for (const PortRow& row : rows) names << row.name;
  colourNumbers_.use(names);
  for (PortRow& row : rows) row.colour = portColour(colourNumbers_.of(row.name));
  rows_ = std::move(rows);
  Q_EMIT changed();
}

void CasePorts::request(std::shared_ptr<PortJob> job) {
  queue_.push_back(std::move(job));
  startNext();
}

void CasePorts::requestCuts(std::shared_ptr<PortJob> job) {
  if (ready())
    request(std::move(job));
  else
    tell(Severity::Warning, tr("There are no vessels to cut yet: run to Evolve first."));
}

void CasePorts::requestCheck() {
  const std::vector<std::string> wanted = cuts();
  if (!ready() || wanted.empty() || wanted == checked_) return;
  checked_ = wanted;
  const auto looking = [](const std::shared_ptr<PortJob>& job) {
    return job->kind == PortJob::Kind::Check || job->kind == PortJob::Kind::Advise;
  };
  std::erase_if(queue_, looking);
  if (slot_ && looking(slot_.job())) slot_.job()->progress.cancel();
  auto job = std::make_shared<PortJob>();
  job->cuts = wanted;
  request(std::move(job));
}

void CasePorts::startNext() {
  if (slot_ || queue_.empty()) return;
  const std::shared_ptr<PortJob> job = queue_.front();
  queue_.pop_front();
  job->ground = ground_;
  if (slot_.startAndPoll(job)) Q_EMIT changed();
}

void CasePorts::finish(PortJob& job) {
  const bool present = job.ground.phi == ground_.phi && job.ground.spline == ground_.spline;
  if (present) ground_ = job.ground;
  if (present && !job.cancelled) {
    switch (job.kind) {
      case PortJob::Kind::Check:
      case PortJob::Kind::Advise:
        if (job.cuts == cuts()) {
          findings_.clear();
          for (std::size_t i = 0; i < job.findings.size(); ++i)
            findings_[job.cuts[i]] = std::move(job.findings[i]);
          if (job.kind == PortJob::Kind::Check) {
            auto next = std::make_shared<PortJob>();
            next->kind = PortJob::Kind::Advise;
            next->cuts = job.cuts;
            queue_.push_back(std::move(next));
          }
        } else if (job.cuts == checked_) {
          checked_.clear();  // they may come back
        }
        break;
      case PortJob::Kind::CutHere:
        finishCutHere(job);
        break;
      case PortJob::Kind::CutEnds:
      case PortJob::Kind::CutAllAcross:
        finishProposed(job);
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
  all.push_back(cutText(writtenCut(job.proposed.front(), name.toStdString())));
  notice_.clear();
  selected_ = name;
  models_.document.setCuts(all, tr("add the cut %1").arg(name));
}

void CasePorts::finishProposed(const PortJob& job) {
  if (!job.error.empty()) {
    tell(Severity::Warning, QString::fromStdString(job.error));
    return;
  }
  for (const std::string& remark : job.remarks)
    Q_EMIT models_.log.message(Severity::Warning, QString::fromStdString(remark));
  const bool ends = job.kind == PortJob::Kind::CutEnds;
  PortParams after = models_.document.parameters().ports;
  int added = 0;
  for (std::size_t i = 0; i < job.proposed.size(); ++i) {
    const std::string name = ends ? job.names[i] : nameAcross(job.proposed[i], after, job.names[i]);
    if (namesIn(after).count(name) == 0) {
      after.cuts.push_back(cutText(writtenCut(job.proposed[i], name)));
      ++added;
    }
  }
  if (added == 0) {
    tell(Severity::Warning,
         ends ? tr("No end was cut: no vessel ends in the volume without a cut already.")
              : tr("Nothing was cut: at the volume's border no vessel is sliced any more."));
    return;
  }
  notice_ = job.remarks.empty()
                ? QString()
                : tr("%1 places were not cut: the log says why.").arg(job.remarks.size());
  models_.document.setPorts(after, ends ? tr("cut all ends") : tr("cut all across"));
}

}  // namespace angiomesh
