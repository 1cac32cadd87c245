// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QSplitter>
#include <array>
#include <memory>
#include <vector>

#include "gui/findings/case_ports.h"
#include "gui/findings/case_sensitivity.h"
#include "gui/findings/mesh_inspection.h"
#include "gui/model/result_text.h"
#include "gui/view/surface_view.h"

namespace angiomesh {

class SurfaceFeed;
class VolumeFeed;

/// The 3D pane: the surface that is chosen and, beside it, another mesh (ViewState::comparison())
/// or the projection of the result (ViewState::resultBeside()), seen by one camera.
class SurfacePane : public QSplitter {
  Q_OBJECT

 public:
  SurfacePane(CaseModels& models, ViewState& state, CasePorts& ports, MeshInspection& inspection,
              CaseSensitivity& sensitivity, const JobRunnerFactory& makeRunner,
              QWidget* parent = nullptr);

  [[nodiscard]] SurfaceView* surface() const { return surface_; }
  /// Shows the surface, with parts left out of it.
  [[nodiscard]] SurfaceFeed* feed() const { return feed_; }
  /// Hidden where nothing is beside the surface.
  [[nodiscard]] SurfaceView* beside() const { return beside_; }

  /// Shows what models and state have now.
  void refresh();
  /// Ports have other colours.
  void refreshPatches();
  /// What the surface is, and what is beside it.
  [[nodiscard]] const ShownText& text() const { return text_; }
  [[nodiscard]] ShownText textBeside() const;

 Q_SIGNALS:
  void textChanged();

 protected:
  /// Of the bar between two meshes.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// A view, what it shows, and whose colours.
  struct Shown {
    SurfaceView* view;
    SurfaceFeed* feed;
    std::shared_ptr<const TriMesh> mesh;
    std::shared_ptr<const void> colours;  ///< what they are of; null: plain
    int effect;                           ///< of CaseSensitivity, where they are its
  };

  void connectCameras();
  [[nodiscard]] std::shared_ptr<const TriMesh> wanted(bool& passing) const;
  void refreshBeside();
  [[nodiscard]] MeshKind kindBeside() const;
  /// Whether the two views are seen from one place.
  [[nodiscard]] bool oneCamera() const;
  void paintSurface();
  void paintBeside();
  void paint(Shown& shown, MeshKind kind, bool plain);
  void paintMarks();
  [[nodiscard]] std::vector<std::array<double, 3>> patchColours(
      const std::shared_ptr<const TriMesh>& mesh) const;

  CaseModels& models_;
  ViewState& state_;
  CasePorts& ports_;
  MeshInspection& inspection_;
  CaseSensitivity& sensitivity_;
  SurfaceView* surface_;
  SurfaceView* beside_;
  SurfaceFeed* feed_;
  SurfaceFeed* feedBeside_;
  VolumeFeed* resultFeed_;  ///< of the projection beside
  Shown shown_, shownBeside_;
  ShownText text_;
  bool linked_ = true;  ///< as last seen
};

}  // namespace angiomesh
