// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QObject>
#include <QString>
#include <QUndoStack>
#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "gui/job/display_facts.h"
#include "gui/model/message_log.h"
#include "io/case/case_notes.h"

namespace angiomesh {

/// The case that is open: its source, its parameters, and what the user noted. Every edit is a
/// change of parameters or notes, and goes through the undo stack.
class CaseDocument : public QObject {
  Q_OBJECT

 public:
  explicit CaseDocument(MessageLog& log, QObject* parent = nullptr);

  // The source.
  /// Neither parametersChanged() nor notesChanged() follows.
  void begin(std::shared_ptr<Pipeline> pipeline, const FieldContext& facts,
             const DisplayFacts& display, const QString& name, const Parameters& params,
             const CaseNotes& notes = {});
  [[nodiscard]] bool hasCase() const { return pipeline_ != nullptr; }
  /// Knows the keys, and remembers results. Null without a case.
  [[nodiscard]] const std::shared_ptr<Pipeline>& pipeline() const { return pipeline_; }
  [[nodiscard]] const std::string& key(Step step) const;
  [[nodiscard]] std::shared_ptr<const Volume<float>> image() const;
  /// Of the image alone, not of results.
  [[nodiscard]] const FieldContext& facts() const { return facts_; }
  [[nodiscard]] const DisplayFacts& display() const { return display_; }
  [[nodiscard]] QString caseName() const { return name_; }
  void setCaseName(const QString& name) { name_ = name; }
  /// Source::hash; empty without a case.
  [[nodiscard]] std::string sourceHash() const;

  // Edits: each one is undoable, as far as the last kMostEdits.
  static constexpr int kMostEdits = 500;
  [[nodiscard]] const Parameters& parameters() const { return *content_.params; }
  [[nodiscard]] QUndoStack* undoStack() { return &undo_; }
  /// There are edits since the last save.
  [[nodiscard]] bool modified() const { return hasCase() && !undo_.isClean(); }
  /// @param mergeKey `continued` merges the change with the last one that has the same
  void change(const Parameters& after, const QString& text, const QString& mergeKey = {},
              bool continued = false);
  [[nodiscard]] const CaseNotes& notes() const { return *content_.notes; }
  /// Likewise, of what was noted: no step's key changes.
  void changeNotes(const CaseNotes& after, const QString& text, const QString& mergeKey = {},
                   bool continued = false);
  /// Both at once.
  void change(const Parameters& params, const CaseNotes& notes, const QString& text);
  /// @param continued merges with the last change of the same field, as while a slider is dragged
  void setField(const QString& key, const FieldValue& value, bool continued = false);
  [[nodiscard]] std::vector<Eigen::Vector3d> seeds() const;
  void addSeed(const Eigen::Vector3d& lps);
  void removeSeed(int index);
  /// To a place in the volume; elsewhere it stays, and parametersChanged() follows all the same.
  void moveSeed(int index, const Eigen::Vector3d& lps);
  /// In place of all other seeds by hand; parts without one are left out. One edit.
  void keepOnlyVesselAt(const Eigen::Vector3d& lps);
  void setRoi(const std::optional<std::array<double, 6>>& roi);
  /// `what` names the edit. @returns why not, in a line; empty: done
  QString setPorts(const PortParams& ports, const QString& what);
  QString setCuts(const std::vector<std::string>& cuts, const QString& what);

 Q_SIGNALS:
  void parametersChanged();  ///< or an edit was refused, and a form has to show what is
  void edited();             ///< after parametersChanged(), where there was an edit
  void notesChanged();

 private:
  /// What edits change.
  struct Content {
    // Never null; neighbours among the edits share them.
    std::shared_ptr<const Parameters> params;
    std::shared_ptr<const CaseNotes> notes;
  };
  class Change;
  void push(Content after, const QString& text, const QString& mergeKey, bool continued);
  void replace(const Content& content);

  MessageLog& log_;
  QUndoStack undo_;
  Content content_;
  /// Of the parameters, as far as they were asked for.
  mutable std::array<std::string, kStepCount> keys_;
  std::shared_ptr<Pipeline> pipeline_;
  FieldContext facts_;
  DisplayFacts display_;
  QString name_;
};

}  // namespace angiomesh
