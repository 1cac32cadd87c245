// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_files.h"

#include <QFileInfo>
#include <utility>

#include "gui/model/modality_habits.h"
#include "gui/model/step_text.h"
#include "io/volume/image_format.h"

namespace angiomesh {

namespace {

/// More would make the undo stack no better and the start slow.
constexpr std::size_t kMostRestored = 50;

/// The file's name without extensions. A folder's name often is a patient's, so it is not used.
QString nameOf(const QString& path) {
  const QFileInfo info(path);
  if (info.isDir()) return QStringLiteral("DICOM series");
  const ImageEnding* ending = imageEndingOf(path.toStdString());
  return ending ? info.fileName().chopped(QLatin1String(ending->text).size())
                : info.completeBaseName();
}

QString inWords(const CaseSource& source) {
  return CaseFiles::tr("%1, %2")
      .arg(gridText(source.grid))
      .arg(source.files > 1 ? CaseFiles::tr("%1 series of %2 files")
                                  .arg(QString::fromStdString(source.format))
                                  .arg(source.files)
                            : QString::fromStdString(source.format));
}

/// Parameters to begin with on another image.
Parameters withoutPlaces(const std::optional<Label>& label, Parameters params) {
  Parameters fresh;
  if (label) {
    fresh.segmentation.method = SegmentationMethod::Label;
    fresh.segmentation.label = static_cast<int>(label->value);
  }
  copyPlaces(fresh, params);
  return params;
}

std::string absolute(const QString& path) {
  return QFileInfo(path).absoluteFilePath().toStdString();
}

}  // namespace

CaseFiles::CaseFiles(CaseDocument& document, PresetShelf& presets, ResultModel& results,
                     RunModel& runs, MessageLog& log, JobTimer& timer,
                     const JobRunnerFactory& makeRunner, const std::filesystem::path& recovery,
                     QObject* parent)
    : QObject(parent),
      document_(document),
      presets_(presets),
      results_(results),
      runs_(runs),
      log_(log),
      timer_(timer),
      store_(makeRunner, recovery),
      slot_(timer, makeRunner, [this](const std::shared_ptr<LoadJob>& job) { finishLoad(job); }) {
  timer_.add(*this);
  connect(document_.undoStack(), &QUndoStack::indexChanged, this, &CaseFiles::noteEdit);
  connect(&presets_, &PresetShelf::chosen, this, [this](const QString& name) {
    if (document_.hasCase()) rememberPreset(info_.modality, name);
  });
  connect(&runs_, &RunModel::ended, this, [this] {
    if (!document_.modified()) cacheEvolve();
  });
}

CaseFiles::~CaseFiles() {
  document_.undoStack()->disconnect(this);
  timer_.remove(*this);
  cancelLoad();
}

void CaseFiles::cancelLoad() {
  if (slot_) slot_.job()->progress().cancel();
}

std::optional<DicomOrigin> CaseFiles::dicomOrigin() const {
  if (!document_.hasCase() || sourcePath_.empty() || info_.format != "DICOM") return std::nullopt;
  return DicomOrigin{sourcePath_, info_.seriesUid, DicomIdentity::None};
}

void CaseFiles::open(const QString& path) {
  startLoad(std::make_shared<LoadJob>(absolute(path), nameOf(path).toStdString()));
}

void CaseFiles::openSeries(const QString& path, const ImageSummary& entry, bool evenOut) {
  startLoad(std::make_shared<LoadJob>(absolute(path), nameOf(path).toStdString(), entry, evenOut));
}

void CaseFiles::openLabel(const QString& path, const std::optional<Label>& label) {
  startLoad(std::make_shared<LoadJob>(absolute(path), nameOf(path).toStdString(), label));
}

void CaseFiles::openSample() {
  startLoad(std::make_shared<LoadJob>(std::filesystem::path(), "sample"));
}

void CaseFiles::take(Source source) { startLoad(std::make_shared<LoadJob>(std::move(source))); }

void CaseFiles::openCase(CaseRequest request) {
  if (!request.folder.empty() && request.folder == store_.folder()) {
    log_.say(Severity::Info, tr("The case %1 is open already.").arg(document_.caseName()));
    return;
  }
  startLoad(std::make_shared<OpenCaseJob>(std::move(request)));
}

void CaseFiles::giveSource(const QString& path) {
  if (!pending_) return;
  CaseRequest request = pending_->request();
  request.place = pending_->place();
  request.source = absolute(path);
  pending_.reset();
  startLoad(std::make_shared<OpenCaseJob>(std::move(request)));
}

void CaseFiles::takeParametersOnly() {
  if (!pending_ || pending_->request().source.empty()) return;
  const auto job = std::make_shared<LoadJob>(pending_->request().source, "volume");
  job->startWith(pending_->document().params);
  pending_.reset();
  startLoad(job);
}

void CaseFiles::startLoad(std::shared_ptr<LoadJob> job) {
  if (slot_) {
    cancelLoad();
    next_ = std::move(job);
    return;
  }
  slot_.start(std::move(job));
  Q_EMIT loadingChanged();
  timer_.poll();
}

void CaseFiles::finishLoad(const std::shared_ptr<LoadJob>& job) {
  const bool usable = !job->cancelled() && job->error().empty();
  if (usable && job->pipeline() && runs_.leave()) {
    slot_.keep(job);  // the new case begins once the old one's run has let go
    return;
  }
  const QString path = QString::fromStdString(job->path().string());
  if (!usable) {
    if (!job->cancelled())
      log_.say(Severity::Error, tr("Cannot open: %1").arg(QString::fromStdString(job->error())));
  } else if (const auto opening = std::dynamic_pointer_cast<const OpenCaseJob>(job)) {
    takeCase(opening);
  } else if (!job->choices().empty()) {
    Q_EMIT seriesFound(path, job->choices());
  } else if (!job->labels().empty()) {
    Q_EMIT labelsFound(path, job->labels(), job->entry()->geometry.voxelVolumeMm3());
  } else if (!job->uneven().empty()) {
    Q_EMIT unevenFound(path, *job->entry(), QString::fromStdString(job->uneven()));
  } else {
    takeVolume(*job);
  }
  Q_EMIT loadingChanged();
  if (next_) startLoad(std::exchange(next_, nullptr));
}

void CaseFiles::begin(const LoadJob& job, const QString& name, const Parameters& params,
                      const CaseNotes& notes) {
  leaveCase();
  pending_.reset();
  results_.clear();
  runs_.clear();
  info_ = job.info();
  sourcePath_.clear();
  document_.begin(job.pipeline(), job.facts(), job.display(), name, params, notes);
}

void CaseFiles::announce() {
  Q_EMIT caseChanged();
  Q_EMIT document_.parametersChanged();
  Q_EMIT document_.notesChanged();
  Q_EMIT results_.resultsChanged();
}

Parameters CaseFiles::parametersToBegin(const LoadJob& job) {
  if (job.startParameters()) return *job.startParameters();
  if (!document_.hasCase() && document_.undoStack()->count() > 0) return document_.parameters();
  const Preset& preset = presets_.beginningFor(job.info().modality);
  if (&preset != &presets_.all().front())
    log_.say(Severity::Info,
             tr("Begins with the preset %1.").arg(QString::fromStdString(preset.name)));
  return preset.params;
}

void CaseFiles::takeVolume(const LoadJob& job) {
  begin(job, QString::fromStdString(job.pipeline()->source().name),
        withoutPlaces(job.label(), parametersToBegin(job)));
  store_.begin({describeSource(), document_.parameters(), {}, {}, 0}, nullptr);
  sayOpened(job.info());
  if (job.label()) sayLabel(*job.label());
  announce();
  if (!job.path().empty()) {
    const QString path = QString::fromStdString(job.path().string());
    sourcePath_ = job.path();
    Q_EMIT opened(path);
    Q_EMIT sourceSeen(path);
  }
}

void CaseFiles::takeCase(const std::shared_ptr<const OpenCaseJob>& job) {
  for (const std::string& warning : job->warnings()) log_.say(Severity::Warning, warning);
  if (!job->pipeline()) {
    pending_ = job;
    if (job->difference().empty())
      Q_EMIT sourceMissing(inWords(job->document().source));
    else
      Q_EMIT sourceDiffers(QString::fromStdString(job->difference()));
    return;
  }
  const bool recovery = job->request().place && job->request().place->recovery;
  begin(*job, recovery ? tr("restored") : QString::fromStdString(job->pipeline()->source().name),
        job->document().params, job->document().notes);
  sourcePath_ = job->sourcePath();
  store_.begin(job->document(), job->place());
  sayOpened(job->info());
  announce();
  if (!recovery) Q_EMIT opened(QString::fromStdString(job->path().string()));
  if (!job->sourcePath().empty())
    Q_EMIT sourceSeen(QString::fromStdString(job->sourcePath().string()));
  Q_EMIT caseFound(job->document().view);
  runs_.refreshFromCache();
  foundSteps_ = job->steps();
  if (foundSteps_.empty()) return;
  if (job->request().restore)
    restoreEdits();
  else
    Q_EMIT editsFound(static_cast<int>(foundSteps_.size()));
}

void CaseFiles::sayOpened(const InputInfo& info) {
  const QString modality =
      info.modality.empty() ? QString() : tr(", ") + QString::fromStdString(info.modality);
  log_.say(Severity::Info,
           tr("Opened %1: %2%3.")
               .arg(document_.caseName(), gridText(document_.image()->geometry), modality));
  for (const std::string& warning : screenWarnings(info)) log_.say(Severity::Warning, warning);
}

void CaseFiles::sayLabel(const Label& label) {
  const QString name =
      label.name.empty() ? QString() : tr(" (%1)").arg(QString::fromStdString(label.name));
  log_.say(Severity::Info,
           tr("Taken as a segmentation: its label %1%2, %3 voxels, is the vessel. For a scan "
              "choose another segmentation.method.")
               .arg(label.value)
               .arg(name)
               .arg(label.voxels));
}

void CaseFiles::restoreEdits() {
  const std::vector<JournalStep> steps = std::exchange(foundSteps_, {});
  if (steps.empty()) return;
  restoring_ = true;
  const std::size_t first = steps.size() > kMostRestored ? steps.size() - kMostRestored : 0;
  for (std::size_t i = first; i < steps.size(); ++i)
    document_.change(steps[i].params, steps[i].notes, QString::fromStdString(steps[i].text));
  restoring_ = false;
  const std::size_t count = steps.size() - first;
  log_.say(Severity::Info, count == 1
                               ? tr("Restored a change that had not been saved.")
                               : tr("Restored %1 changes that had not been saved.").arg(count));
}

void CaseFiles::forgetEdits() {
  foundSteps_.clear();
  store_.forgetEdits();
  timer_.wake();
}

CaseSource CaseFiles::describeSource() const {
  CaseSource source;
  source.hash = document_.sourceHash();
  source.format = info_.format;
  source.files = info_.files;
  source.grid = document_.image()->geometry;
  return source;
}

void CaseFiles::saveCase(const QString& folder, const CaseView& view) {
  if (!document_.hasCase()) return;
  store_.save(absolute(folder),
              {describeSource(), document_.parameters(), document_.notes(), view, 0});
  cacheEvolve();
  timer_.wake();
  timer_.poll();
}

void CaseFiles::cacheEvolve() {
  const std::shared_ptr<const EvolveResult> evolve = results_.evolveResult();
  const bool fresh =
      evolve && !endedByHand(*evolve, document_.parameters()) && results_.fresh(Step::Evolve);
  if (!fresh || (store_.folder().empty() && !store_.saving())) return;
  store_.cache({*evolve, results_.report(Step::Evolve)});
  timer_.wake();
}

QString CaseFiles::caseFolder() const { return QString::fromStdString(store_.folder().string()); }

void CaseFiles::leaveCase() {
  if (!store_.begun()) return;
  store_.leave();
  foundSteps_.clear();
  noteFailed_ = false;
  timer_.wake();
}

void CaseFiles::noteEdit() {
  if (restoring_ || !store_.begun()) return;
  QUndoStack& undo = *document_.undoStack();
  store_.note(
      {0, undo.index(), undo.undoText().toStdString(), document_.parameters(), document_.notes()});
  timer_.wake();
}

bool CaseFiles::poll() {
  for (const CaseStore::Outcome& outcome : store_.poll()) takeOutcome(outcome);
  return store_.busy();
}

void CaseFiles::takeOutcome(const CaseStore::Outcome& outcome) {
  using Kind = CaseStore::Outcome::Kind;
  const std::string name = outcome.folder.stem().string();
  const QString reason = QString::fromStdString(withoutPath(outcome.error, outcome.folder, name));
  switch (outcome.kind) {
    case Kind::Saved:
      log_.say(Severity::Info, tr("Saved the case %1.").arg(QString::fromStdString(name)));
      if (!outcome.present) return;
      document_.setCaseName(QString::fromStdString(name));
      if (outcome.document.params == document_.parameters() &&
          outcome.document.notes == document_.notes())
        document_.undoStack()->setClean();
      else
        document_.undoStack()->resetClean();
      Q_EMIT caseSaved(QString::fromStdString(outcome.folder.string()));
      return;
    case Kind::NotSaved:
      log_.say(Severity::Error, tr("Cannot save the case: %1").arg(reason));
      Q_EMIT caseNotSaved();
      return;
    case Kind::NotNoted:
      if (!std::exchange(noteFailed_, true)) {
        log_.say(Severity::Warning,
                 tr("Edits are not kept for a restore, save the case elsewhere: %1").arg(reason));
      }
      return;
  }
}

}  // namespace angiomesh
