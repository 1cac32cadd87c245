// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QObject>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "gui/job/inspect_job.h"
#include "gui/job/job_slot.h"
#include "gui/model/view_state.h"

namespace angiomesh {

/// What the inspector and the 3D pane show of the meshes' triangles: one measure on all meshes at
/// hand, made off the window's thread, and which triangles are lit.
class MeshInspection : public QObject {
  Q_OBJECT

 public:
  MeshInspection(CaseModels& models, ViewState& state, const JobRunnerFactory& makeRunner,
                 QObject* parent = nullptr);
  ~MeshInspection() override;

  /// That of the colours chosen; without colours the first of all.
  [[nodiscard]] const TriangleMeasure& measure() const;
  /// Null while there is nothing, or it is being measured for the first time.
  [[nodiscard]] const std::shared_ptr<const MeasuredMeshes>& measured() const { return measured_; }
  /// The same where it is of this mesh and of measure(); else null.
  [[nodiscard]] const MeasuredMeshes::Of* of(const TriMesh* mesh, MeshKind kind) const;

  /// Lights the triangles of some neighbouring bars of the histogram; nothing: none.
  void lightBars(std::optional<std::pair<int, int>> bars);
  [[nodiscard]] const std::optional<std::pair<int, int>>& litBars() const { return bars_; }
  /// Lights one of the worst triangles of the mesh shown, and goes there.
  void goToWorst(std::size_t index);
  /// Of the mesh of a kind.
  [[nodiscard]] std::vector<std::uint32_t> lit(MeshKind kind) const;

 Q_SIGNALS:
  void changed();
  void litChanged();
  /// To a place on the wall, to be seen from outside.
  void goTo(const Eigen::Vector3d& lps, const Eigen::Vector3d& normal, double radiusMm);

 private:
  void refresh();
  void finish(const InspectJob& job);
  void unlight();

  CaseModels& models_;
  ViewState& state_;
  std::shared_ptr<const MeasuredMeshes> measured_;
  std::optional<std::pair<int, int>> bars_;
  std::optional<std::pair<MeshKind, std::uint32_t>> triangle_;  ///< lit alone
  JobSlot<InspectJob> slot_;
};

}  // namespace angiomesh
