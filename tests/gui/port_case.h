// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QPushButton>
#include <QTableWidget>

#include "core/cuts/cuts.h"
#include "gui/findings/case_ports.h"
#include "window_case.h"

namespace angiomesh::test {

/// A vessel with two ends inside the volume.
inline Source coil() {
  PhantomParams params;
  params.psf.kind = PointSpread::Kind::Subvoxels;
  params.kind = PhantomKind::Helix;
  params.size = {44, 44, 44};
  params.radius = 3.0;
  return makeSource(makePhantom(params).image, "coil");
}

inline void trigger(WindowCase& c, const char* name) {
  c.window->findChild<QAction*>(QLatin1String(name))->trigger();
}

/// The middle of a vessel, `share` of the way up the volume.
inline Eigen::Vector3d insideOf(CaseModels& models, double share) {
  const Volume<float>& phi = *models.results.uncutPhi();
  const Index3 size = phi.geometry.size;
  const auto k = static_cast<int>(share * (size[2] - 1));
  Index3 best{0, 0, k};
  for (int j = 0; j < size[1]; ++j)
    for (int i = 0; i < size[0]; ++i)
      if (phi.at(i, j, k) < phi.at(best[0], best[1], k)) best = {i, j, k};
  return phi.geometry.toPhysical({1.0 * best[0], 1.0 * best[1], 1.0 * k});
}

inline void cutAt(WindowCase& c, double share) {
  c.window->views().setCrosshair(insideOf(c.models(), share));
  trigger(c, "cutHere");
}

/// A window in which two tubes are meshed, of which the larger alone is kept.
struct PortCase : WindowCase {
  explicit PortCase(const std::filesystem::path& recovery = {}, Source source = twoTubes())
      : WindowCase(makeInlineJobRunner, recovery) {
    models().files.take(std::move(source));
    models().document.setField("segmentation.keep", std::string("largest"));
    click(find<QPushButton>("run"));
    state().setVolumeView(VolumeView::None);
    settle();
  }

  CasePorts& ports() { return window->ports(); }
  SurfaceView* view() { return window->views().surface(); }
  QTableWidget* table() { return find<QTableWidget>("ports"); }
  std::size_t cuts() { return models().document.parameters().ports.cuts.size(); }
  GivenCut cut(std::size_t i) { return parseCut(models().document.parameters().ports.cuts.at(i)); }
  void trigger(const char* name) { test::trigger(*this, name); }
  int undoCount() { return models().document.undoStack()->count(); }
  void undo() { trigger("undo"); }
  void redo() { trigger("redo"); }
  void settle() {
    QCoreApplication::processEvents();
    view()->grabFramebuffer();
  }

  Eigen::Vector3d inside(double share = 0.5) { return insideOf(models(), share); }
  void cutAt(double share) { test::cutAt(*this, share); }
  void rightClick(QWidget* widget, const QPoint& at) {
    QTest::mouseClick(widget, Qt::RightButton, Qt::NoModifier, at);
  }
};

}  // namespace angiomesh::test
