// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_corrections.h"

#include <QUndoStack>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace angiomesh {

namespace {

/// Of the radius, between places of a line that are kept.
constexpr double kSpacing = 0.3;
constexpr double kRadiusStep = 1.25;
/// Of a new case's brush, in voxels.
constexpr double kUsualRadiusVoxels = 3.0;

struct Title {
  CorrectionKind kind;
  const char* text;
};
constexpr std::array<Title, 9> kTitles{{
    {CorrectionKind::Add, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Add")},
    {CorrectionKind::AddToEdge, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Add to the edge")},
    {CorrectionKind::Erase, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Erase")},
    {CorrectionKind::EraseToEdge,
     QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Erase to the edge")},
    {CorrectionKind::Bridge, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Join two ends")},
    {CorrectionKind::Separate,
     QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Separate two vessels")},
    {CorrectionKind::CutOff, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Cut off")},
    {CorrectionKind::FillHole, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Fill hole")},
    {CorrectionKind::OpenLoop, QT_TRANSLATE_NOOP("angiomesh::CaseCorrections", "Open loop")},
}};

bool takesTwo(CorrectionKind kind) {
  return kind == CorrectionKind::Bridge || kind == CorrectionKind::Separate;
}

}  // namespace

QString correctionTitle(CorrectionKind kind) {
  return CaseCorrections::tr(kTitles[static_cast<std::size_t>(kind)].text);
}

CaseCorrections::CaseCorrections(CaseDocument& document, ResultModel& results, MessageLog& log,
                                 QObject* parent)
    : QObject(parent), document_(document), results_(results), log_(log) {
  connect(&document_, &CaseDocument::parametersChanged, this, &CaseCorrections::changed);
  connect(&results_, &ResultModel::resultsChanged, this, &CaseCorrections::look);
}

bool CaseCorrections::ready() const {
  return document_.hasCase() && results_.fresh(Step::Evolve) &&
         document_.pipeline()->has(Step::Evolve, document_.parameters());
}

const std::vector<std::string>& CaseCorrections::all() const {
  return document_.parameters().segmentation.corrections;
}

const CorrectionOutcome* CaseCorrections::outcome(std::size_t index) const {
  const auto& segmentation = results_.segmentation();
  if (!segmentation || index >= segmentation->corrections.size() || index >= all().size())
    return nullptr;
  const CorrectionOutcome& found = segmentation->corrections[index];
  return found.text == all()[index] ? &found : nullptr;
}

void CaseCorrections::setRadius(double mm) {
  radiusSet_ = true;
  const double to = std::clamp(mm, kLeastRadiusMm, kGreatestRadiusMm);
  if (std::exchange(radiusMm_, to) != to) Q_EMIT changed();
}

void CaseCorrections::stepRadius(int steps) { setRadius(radiusMm_ * std::pow(kRadiusStep, steps)); }

void CaseCorrections::setToEdge(bool on) {
  if (std::exchange(toEdge_, on) != on) Q_EMIT changed();
}

void CaseCorrections::paint(bool add, const std::vector<Eigen::Vector3d>& lineLps) {
  if (lineLps.empty()) return;
  const bool edge = toEdge_ && !isSegmented(document_.parameters());
  Correction correction;
  correction.kind = add ? (edge ? CorrectionKind::AddToEdge : CorrectionKind::Add)
                        : (edge ? CorrectionKind::EraseToEdge : CorrectionKind::Erase);
  correction.radiusMm = radiusMm_;
  for (const Eigen::Vector3d& place : lineLps) {
    const bool last = &place == &lineLps.back();
    const bool far = correction.placesLps.empty() ||
                     (place - correction.placesLps.back()).norm() >= kSpacing * radiusMm_;
    if (far || (last && place != correction.placesLps.back()))
      correction.placesLps.push_back(place);
  }
  make(correction);
}

void CaseCorrections::pick(CorrectionKind kind, const Eigen::Vector3d& placeLps) {
  if (!ready()) return;
  if (takesTwo(kind) && (!picked_ || picked_->kind != kind)) {
    picked_ = {kind, placeLps};
    Q_EMIT changed();
    return;
  }
  Correction correction;
  correction.kind = kind;
  if (takesTwo(kind)) correction.placesLps.push_back(std::exchange(picked_, {})->placeLps);
  correction.placesLps.push_back(placeLps);
  if (isBrush(kind)) correction.radiusMm = radiusMm_;
  make(correction);
}

void CaseCorrections::forgetPicked() {
  if (std::exchange(picked_, {})) Q_EMIT changed();
}

void CaseCorrections::make(const Correction& correction) {
  if (!ready()) return;
  std::vector<std::string> texts = all();
  texts.push_back(correctionText(correction));
  // Before the edit: the result may come with it.
  made_ = document_.undoStack()->index() + 1;
  set(std::move(texts), correctionTitle(correction.kind));
}

void CaseCorrections::remove(std::size_t index) {
  std::vector<std::string> texts = all();
  if (index >= texts.size()) return;
  texts.erase(texts.begin() + static_cast<std::ptrdiff_t>(index));
  set(std::move(texts), tr("remove a correction"));
}

void CaseCorrections::set(std::vector<std::string> texts, const QString& what) {
  Parameters after = document_.parameters();
  after.segmentation.corrections = std::move(texts);
  document_.change(after, what);
}

void CaseCorrections::look() {
  if (!radiusSet_ && document_.hasCase())
    radiusMm_ = std::clamp(kUsualRadiusVoxels * document_.image()->geometry.voxelMm(),
                           kLeastRadiusMm, kGreatestRadiusMm);
  const CorrectionOutcome* newest = all().empty() ? nullptr : outcome(all().size() - 1);
  if (made_ >= 0 && newest != nullptr && results_.fresh(Step::Correct)) {
    const int made = std::exchange(made_, -1);
    const QString title = correctionTitle(parseCorrection(newest->text).kind);
    const bool useless = newest->added == 0 && newest->removed == 0;
    if (!newest->why.empty())
      log_.say(Severity::Error, tr("%1: %2.").arg(title, QString::fromStdString(newest->why)));
    else if (useless)
      log_.say(Severity::Warning, tr("%1: nothing changed.").arg(title));
    // Not within the edit that it takes back.
    if (useless)
      QMetaObject::invokeMethod(
          this,
          [this, made] {
            if (document_.undoStack()->index() == made) document_.undoStack()->undo();
          },
          Qt::QueuedConnection);
  }
  Q_EMIT changed();
}

}  // namespace angiomesh
