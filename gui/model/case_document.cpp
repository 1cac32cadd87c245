// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_document.h"

#include <QUndoCommand>
#include <algorithm>
#include <utility>

#include "core/base/error.h"

namespace angiomesh {

/// The one undoable edit: parameters and notes before and after.
class CaseDocument::Change final : public QUndoCommand {
 public:
  Change(CaseDocument& document, Content after, const QString& text, QString mergeKey,
         bool continued)
      : QUndoCommand(text),
        document_(document),
        before_(document.content_),
        after_(std::move(after)),
        mergeKey_(std::move(mergeKey)),
        continued_(continued) {}

  void undo() override { document_.replace(before_); }
  void redo() override { document_.replace(after_); }
  [[nodiscard]] int id() const override { return 1; }

  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = static_cast<const Change*>(other);
    if (!next->continued_ || next->mergeKey_ != mergeKey_) return false;
    after_ = next->after_;
    return true;
  }

 private:
  CaseDocument& document_;
  Content before_, after_;
  QString mergeKey_;
  bool continued_;
};

CaseDocument::CaseDocument(MessageLog& log, QObject* parent)
    : QObject(parent),
      log_(log),
      content_{std::make_shared<const Parameters>(preset("angiomesh")),
               std::make_shared<const CaseNotes>()} {
  undo_.setUndoLimit(kMostEdits);
}

void CaseDocument::begin(std::shared_ptr<Pipeline> pipeline, const FieldContext& facts,
                         const DisplayFacts& display, const QString& name, const Parameters& params,
                         const CaseNotes& notes) {
  pipeline_ = std::move(pipeline);
  facts_ = facts;
  display_ = display;
  name_ = name;
  undo_.clear();
  content_ = {std::make_shared<const Parameters>(params), std::make_shared<const CaseNotes>(notes)};
  keys_.fill({});
}

const std::string& CaseDocument::key(Step step) const {
  // Everything that is shown asks for keys, many times with each change.
  std::string& known = keys_[static_cast<std::size_t>(step)];
  if (known.empty()) known = pipeline_->key(step, parameters());
  return known;
}

std::shared_ptr<const Volume<float>> CaseDocument::image() const {
  return pipeline_ ? pipeline_->source().image : nullptr;
}

std::string CaseDocument::sourceHash() const {
  return pipeline_ ? pipeline_->source().hash : std::string();
}

void CaseDocument::change(const Parameters& after, const QString& text, const QString& mergeKey,
                          bool continued) {
  if (after == parameters()) {
    Q_EMIT parametersChanged();
    return;
  }
  push({std::make_shared<const Parameters>(after), content_.notes}, text, mergeKey, continued);
}

void CaseDocument::changeNotes(const CaseNotes& after, const QString& text, const QString& mergeKey,
                               bool continued) {
  if (after == notes()) return;
  push({content_.params, std::make_shared<const CaseNotes>(after)}, text, mergeKey, continued);
}

void CaseDocument::change(const Parameters& params, const CaseNotes& notes, const QString& text) {
  if (params == parameters() && notes == *content_.notes) return;
  push({std::make_shared<const Parameters>(params), std::make_shared<const CaseNotes>(notes)}, text,
       {}, false);
}

void CaseDocument::push(Content after, const QString& text, const QString& mergeKey,
                        bool continued) {
  undo_.push(new Change(*this, std::move(after), text, mergeKey, continued));
}

void CaseDocument::replace(const Content& content) {
  const Content before = std::exchange(content_, content);
  if (*content_.params != *before.params) {
    keys_.fill({});
    Q_EMIT parametersChanged();
    Q_EMIT edited();
  }
  if (notes() != *before.notes) Q_EMIT notesChanged();
}

void CaseDocument::setField(const QString& key, const FieldValue& value, bool continued) {
  Parameters after = parameters();
  try {
    const Field& field = findField(key.toStdString());
    angiomesh::setField(after, field.key, value);
    pushPartners(after, field);
    // That there are no seeds is told by the step that needs them.
    if (field.step != Step::Seeds) validate(after);
  } catch (const Error& failure) {
    log_.say(Severity::Error, std::string(failure.what()));
    Q_EMIT parametersChanged();
    return;
  }
  change(after, tr("change %1").arg(key), key, continued);
}

std::vector<Eigen::Vector3d> CaseDocument::seeds() const {
  std::vector<Eigen::Vector3d> points;
  const std::vector<double>& numbers = parameters().seeds.points;
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  return points;
}

void CaseDocument::addSeed(const Eigen::Vector3d& lps) {
  Parameters after = parameters();
  after.seeds.points.insert(after.seeds.points.end(), {lps[0], lps[1], lps[2]});
  change(after, tr("add a seed"));
}

void CaseDocument::removeSeed(int index) {
  Parameters after = parameters();
  std::vector<double>& points = after.seeds.points;
  const auto at = static_cast<std::ptrdiff_t>(index) * 3;
  if (index < 0 || at + 3 > static_cast<std::ptrdiff_t>(points.size())) return;
  points.erase(points.begin() + at, points.begin() + at + 3);
  change(after, tr("remove a seed"));
}

void CaseDocument::moveSeed(int index, const Eigen::Vector3d& lps) {
  Parameters after = parameters();
  std::vector<double>& points = after.seeds.points;
  const auto at = static_cast<std::ptrdiff_t>(index) * 3;
  if (index < 0 || at + 3 > static_cast<std::ptrdiff_t>(points.size())) return;
  if (!image() || image()->geometry.holds(lps)) std::copy_n(lps.data(), 3, points.begin() + at);
  change(after, tr("move a seed"));
}

void CaseDocument::keepOnlyVesselAt(const Eigen::Vector3d& lps) {
  Parameters after = parameters();
  after.seeds.points = {lps[0], lps[1], lps[2]};
  after.segmentation.keep = KeepComponents::Seeded;
  change(after, tr("this vessel only"));
}

void CaseDocument::setRoi(const std::optional<std::array<double, 6>>& roi) {
  if (roi && image()) {
    try {
      (void)voxelsInBox(image()->geometry, *roi);
    } catch (const Error& failure) {
      log_.say(Severity::Error, std::string(failure.what()));
      return;
    }
  }
  Parameters after = parameters();
  after.preprocess.roi = roi;
  change(after, roi ? tr("draw the region of interest") : tr("clear the region of interest"));
}

QString CaseDocument::setCuts(const std::vector<std::string>& cuts, const QString& what) {
  PortParams ports = parameters().ports;
  ports.cuts = cuts;
  return setPorts(ports, what);
}

QString CaseDocument::setPorts(const PortParams& ports, const QString& what) {
  Parameters after = parameters();
  after.ports = ports;
  try {
    checkPorts(after.ports);
  } catch (const Error& failure) {
    return QString::fromStdString(failure.what()).simplified();
  }
  change(after, what);
  return {};
}

}  // namespace angiomesh
