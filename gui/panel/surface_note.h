// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QLabel>

#include "gui/model/case_models.h"

namespace angiomesh {

/// What the surface step will make, and what it made: triangles expected, triangles, share from the
/// front, components verified. The tooltip gives the reasons where something was not verified.
class SurfaceNote : public QLabel {
  Q_OBJECT

 public:
  explicit SurfaceNote(CaseModels& models, QWidget* parent = nullptr);

 private:
  void refresh();

  CaseModels& models_;
};

/// "2 of 3" and the sentences on what was not verified or left out; empty where nothing was
/// checked.
QString verifiedText(const SurfaceOrigin& origin);
QString verifiedReasons(const SurfaceOrigin& origin);

}  // namespace angiomesh
