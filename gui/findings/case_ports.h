// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gui/findings/port_rows.h"
#include "gui/job/port_job.h"
#include "gui/model/case_models.h"
#include "gui/model/kept_numbers.h"

namespace angiomesh {

/// The inlets and outlets of the case: the cuts among its parameters with what is known of them,
/// and the other openings of the last mesh. Edits go through the case's undo stack; looking
/// for vessels runs on a worker.
class CasePorts : public QObject {
  Q_OBJECT

 public:
  explicit CasePorts(CaseModels& models, const JobRunnerFactory& makeRunner = makeThreadedJobRunner,
                     QObject* parent = nullptr);
  /// Cancels what runs and waits for it.
  ~CasePorts() override;

  [[nodiscard]] const std::vector<PortRow>& rows() const { return rows_; }
  [[nodiscard]] const PortRow* find(const QString& name) const;
  [[nodiscard]] const PortRow* selected() const { return find(selected_); }
  void select(const QString& name);
  /// selects, and has the panes go there: goTo() follows.
  void visit(const QString& name);
  /// Whether there are vessels to cut.
  [[nodiscard]] bool ready() const { return ground_.phi != nullptr; }
  [[nodiscard]] bool busy() const { return slot_ || !queue_.empty(); }
  /// What the last edit came to, where it came to nothing; a line.
  [[nodiscard]] QString notice() const { return notice_; }
  /// Of the patches 1.. of a mesh with these ports.
  [[nodiscard]] std::vector<std::array<double, 3>> colours(const std::vector<Port>& ports) const;
  /// "inlet", "outlet", "outlet-2", ...: the first that is free.
  [[nodiscard]] QString freeName() const;

  // Edits: each one is undoable.
  /// Across the vessel at a place, mm LPS, that is inside it or by its wall.
  void cutHere(const Eigen::Vector3d& lps);
  /// Cuts of all ends so many radii before their tips, as far as no cut lies in the way.
  void cutEnds(double radii);
  /// Across the vessel just inside an opening that slices it; takes over a name given to that.
  void cutAcross(const QString& name);
  /// The same at all openings, of the surface that the next run would make.
  void cutAllAcross();
  /// What a ports.json has, in place of ports of the same name. @returns why not; empty: done
  QString importPorts(const QString& path);
  void flip(const QString& name);
  void remove(const QString& name);
  /// Of a cut, or of an opening, which keeps the name by its place; empty gives an opening the name
  /// back that it has of itself. @returns why not; empty: done
  QString rename(const QString& name, const QString& wanted);
  /// A drag of a cut: shown, but no edit until drop().
  void drag(const QString& name, const CutPlane& plane);
  [[nodiscard]] bool dragging() const { return drag_.has_value(); }
  void drop();

 Q_SIGNALS:
  void changed();  ///< rows, selection or notice
  void dragged();  ///< the plane of one row alone
  void goTo(double x, double y, double z, double radiusMm);

 private:
  struct Drag {
    QString name;
    CutPlane plane;
    bool tilted = false;
  };

  [[nodiscard]] std::vector<std::string> cuts() const {
    return models_.document.parameters().ports.cuts;
  }
  [[nodiscard]] std::optional<std::size_t> indexOf(const QString& name) const;
  bool replace(const QString& name, const GivenCut& cut, const QString& what);
  void refresh();
  void refreshGround();
  void rebuild();
  [[nodiscard]] PortRow cutRow(const std::string& text) const;
  [[nodiscard]] const CutFinding* findingOf(const std::string& text) const;
  void tell(Severity severity, const QString& text);
  void request(std::shared_ptr<PortJob> job);
  /// Of cuts to add, where there is something to cut.
  void requestCuts(std::shared_ptr<PortJob> job);
  void requestCheck();
  void startNext();
  void finish(PortJob& job);
  void finishCutHere(const PortJob& job);
  void finishProposed(const PortJob& job);
  [[nodiscard]] PortParams withCutNamed(std::size_t index, const std::string& name) const;
  QString renamed(const QString& name, const QString& wanted, const PortParams& after,
                  const QString& what);
  std::string nameAcross(const CutPlane& plane, PortParams& ports,
                         const std::string& otherwise) const;

  CaseModels& models_;
  PortGround ground_;
  std::map<std::string, CutFinding> findings_;  ///< by the text of the cut
  std::vector<std::string> checked_;            ///< the cuts that the findings are of
  std::deque<std::shared_ptr<PortJob>> queue_;
  std::vector<PortRow> rows_;
  KeptNumbers colourNumbers_;
  std::optional<Drag> drag_;
  QString selected_, notice_;
  JobSlot<PortJob> slot_;
};

}  // namespace angiomesh
