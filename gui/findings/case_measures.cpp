// SPDX-License-Identifier: BSD-3-Clause
#include "gui/findings/case_measures.h"

#include <algorithm>
#include <utility>

#include "gui/findings/measurement_text.h"

namespace angiomesh {

namespace {

/// Of a case: what is more cannot be overlooked, and slows each edit.
constexpr std::size_t kMost = 200;
/// How much is seen around a place without a vessel's radius, mm.
constexpr double kAroundMm = 3.0;

QString editText(MeasurementKind kind) {
  switch (kind) {
    case MeasurementKind::Distance:
      return QObject::tr("measure a distance");
    case MeasurementKind::Section:
      return QObject::tr("measure a section");
    case MeasurementKind::Profile:
      return QObject::tr("measure the diameter along a branch");
    case MeasurementKind::Stenosis:
      return QObject::tr("measure a stenosis");
  }
  return {};
}

QString runFirst() {
  return CaseMeasures::tr("Run to Evolve first: there is no wall to measure yet.");
}

}  // namespace

CaseMeasures::CaseMeasures(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<MeasureJob>& job) { finish(*job); }),
      fileSlot_(models.timer, makeRunner,
                [this](const std::shared_ptr<MeasurementsFileJob>& job) { finishFile(*job); }) {
  connect(&models_.files, &CaseFiles::caseChanged, this, [this] {
    queue_.clear();
    if (slot_) slot_.job()->progress.cancel();
    selected_.clear();
    notice_.clear();
    picked_.clear();
    refreshGround();
  });
  connect(&models_.document, &CaseDocument::notesChanged, this, &CaseMeasures::changed);
  connect(&models_.document, &CaseDocument::parametersChanged, this, &CaseMeasures::changed);
  connect(&models_.results, &ResultModel::resultsChanged, this, &CaseMeasures::refreshGround);
  refreshGround();
}

CaseMeasures::~CaseMeasures() {
  queue_.clear();
  if (slot_) slot_.job()->progress.cancel();
}

void CaseMeasures::refreshGround() {
  const auto evolve = models_.results.segmentation();
  const std::shared_ptr<const Volume<float>> phi = evolve ? evolve->phi : nullptr;
  if (phi != ground_.phi) ground_ = {phi, models_.results.key(Step::Correct), nullptr, nullptr};
  Q_EMIT changed();
}

const Measurement* CaseMeasures::find(const QString& name) const {
  const auto found = std::find_if(all().begin(), all().end(), [&](const Measurement& m) {
    return QString::fromStdString(m.name) == name;
  });
  return found == all().end() ? nullptr : &*found;
}

void CaseMeasures::select(const QString& name) {
  if (std::exchange(selected_, name) != name) Q_EMIT changed();
}

void CaseMeasures::visit(const QString& name) {
  select(name);
  const Measurement* m = selected();
  if (!m) return;
  Eigen::Vector3d place = m->places.front();
  double radiusMm = kAroundMm;
  if (m->kind == MeasurementKind::Distance) {
    place = 0.5 * (m->places[0] + m->places[1]);
    radiusMm = std::max(radiusMm, 0.25 * (m->places[1] - m->places[0]).norm());
  } else if (!m->sections.empty()) {
    place = m->sections.front().centreLps;
    radiusMm = 0.5 * m->sections.front().maxDiameterMm();
  }
  Q_EMIT goTo(place[0], place[1], place[2], radiusMm);
}

bool CaseMeasures::isEarlier(const Measurement& measurement) const {
  return !measurement.key.empty() && models_.document.hasCase() &&
         measurement.key != models_.document.key(Step::Correct);
}

void CaseMeasures::tell(const QString& text) {
  notice_ = text;
  Q_EMIT changed();
}

void CaseMeasures::prepare(MeasurementKind kind) {
  picked_.clear();
  pickedKind_ = kind;
  tell(measurementHint(kind, 0));
}

void CaseMeasures::forgetPicked() {
  picked_.clear();
  tell({});
}

void CaseMeasures::pick(MeasurementKind kind, const Eigen::Vector3d& lps) {
  if (!models_.document.hasCase()) return;
  if (kind != pickedKind_) picked_.clear();
  pickedKind_ = kind;
  if (kind != MeasurementKind::Distance && !ready()) {
    tell(runFirst());
    return;
  }
  picked_.push_back(lps);
  if (picked_.size() < placesOf(kind)) {
    tell(measurementHint(kind, picked_.size()));
    return;
  }
  Measurement measurement;
  measurement.kind = kind;
  measurement.places = std::exchange(picked_, {});
  if (all().size() + queue_.size() >= kMost) {
    tell(tr("The case holds %1 measurements, which is the most: delete some first.").arg(kMost));
    return;
  }
  request(std::move(measurement), editText(kind));
}

void CaseMeasures::request(Measurement measurement, const QString& edit) {
  auto job = std::make_shared<MeasureJob>();
  job->measurement = std::move(measurement);
  job->edit = edit.toStdString();
  tell(tr("Measuring…"));
  queue_.push_back(std::move(job));
  startNext();
}

void CaseMeasures::startNext() {
  if (slot_ || queue_.empty()) return;
  const std::shared_ptr<MeasureJob> job = queue_.front();
  queue_.pop_front();
  job->ground = ground_;
  slot_.startAndPoll(job);
}

void CaseMeasures::finish(MeasureJob& job) {
  if (job.ground.phi == ground_.phi) ground_ = job.ground;
  // Also where it had been measured by then: the case that it is of is gone.
  if (!job.progress.cancelled()) {
    if (job.error.empty())
      note(std::move(job.measurement), QString::fromStdString(job.edit));
    else
      tell(tr("Not measured: %1").arg(QString::fromStdString(job.error).simplified()));
  }
  startNext();
}

void CaseMeasures::note(Measurement measurement, const QString& what) {
  CaseNotes after = models_.document.notes();
  notice_ = measurementHint(measurement.kind, 0);
  if (measurement.name.empty()) {
    measurement.name = freeName(measurement.kind).toStdString();
    after.measurements.push_back(measurement);
  } else {
    for (Measurement& each : after.measurements)
      if (each.name == measurement.name) each = measurement;
  }
  selected_ = QString::fromStdString(measurement.name);
  if (after == models_.document.notes())
    Q_EMIT changed();
  else
    models_.document.changeNotes(after, what);
}

QString CaseMeasures::freeName(MeasurementKind kind) const {
  for (int number = 1;; ++number) {
    const QString name = QStringLiteral("%1 %2").arg(measurementTitle(kind)).arg(number);
    if (!find(name)) return name;
  }
}

void CaseMeasures::remove(const QString& name) {
  CaseNotes after = models_.document.notes();
  std::vector<Measurement>& kept = after.measurements;
  kept.erase(
      std::remove_if(kept.begin(), kept.end(),
                     [&](const Measurement& m) { return QString::fromStdString(m.name) == name; }),
      kept.end());
  models_.document.changeNotes(after, tr("delete %1").arg(name));
}

QString CaseMeasures::rename(const QString& name, const QString& wanted) {
  const QString text = wanted.simplified();
  if (text == name) return {};
  QString why;
  if (text.isEmpty()) why = tr("A measurement needs a name.");
  if (find(text)) why = tr("There is another measurement %1.").arg(text);
  if (!why.isEmpty()) {
    tell(why);
    return why;
  }
  CaseNotes after = models_.document.notes();
  for (Measurement& m : after.measurements)
    if (QString::fromStdString(m.name) == name) m.name = text.toStdString();
  if (selected_ == name) selected_ = text;
  models_.document.changeNotes(after, tr("rename %1").arg(name));
  return {};
}

void CaseMeasures::measureAgain(const QString& name) {
  const Measurement* m = find(name);
  if (m && ready()) request(*m, tr("measure again"));
}

void CaseMeasures::movePlace(const QString& name, std::size_t place, const Eigen::Vector3d& lps) {
  const Measurement* m = find(name);
  if (!m || place >= m->places.size()) return;
  if (m->kind != MeasurementKind::Distance && !ready()) {
    tell(runFirst());
    return;
  }
  Measurement moved = *m;
  moved.places[place] = lps;
  request(std::move(moved), tr("move %1").arg(name));
}

void CaseMeasures::exportTable(const QString& path) {
  if (fileSlot_ || all().empty()) return;
  auto job = std::make_shared<MeasurementsFileJob>();
  job->path = path.toStdString();
  job->measurements = all();
  job->key = models_.document.key(Step::Correct);
  fileSlot_.startAndPoll(std::move(job));
}

void CaseMeasures::finishFile(const MeasurementsFileJob& job) {
  const QString name = QString::fromStdString(job.path.filename().string());
  if (!job.error.empty()) {
    models_.log.say(Severity::Error,
                    tr("Cannot export: %1").arg(QString::fromStdString(job.error)));
    return;
  }
  models_.log.say(Severity::Info,
                  tr("Wrote %1: %2 measurements.").arg(name).arg(job.measurements.size()));
  Q_EMIT exported(QString::fromStdString(job.path.string()));
}

}  // namespace angiomesh
