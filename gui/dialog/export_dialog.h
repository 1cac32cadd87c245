// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <functional>

#include "gui/job/run_job.h"
#include "io/mesh/mesh_io.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QVBoxLayout;

namespace angiomesh {

struct CaseModels;

/// Asks which file is to be opened or written. The window uses file dialogs; tests answer at once.
/// An empty answer means that the user thought better of it.
struct PathChooser {
  std::function<QString(QWidget*)> openFile;
  std::function<QString(QWidget*)> openFolder;
  std::function<QString(QWidget*)> openPorts;
  std::function<QString(QWidget*, const QString& suggested, const QString& filter)> save;
};
PathChooser dialogPathChooser();

/// What to export and how: mesh, format with what it can hold, unit and frame, with the size that
/// the result will have, and what goes beside it.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(CaseModels& models, PathChooser chooser, QWidget* parent = nullptr);

 private:
  void addChoices(QFormLayout* form);
  void addNotes(QFormLayout* form, QVBoxLayout* below);
  void refresh();
  void refreshHint();
  void exportNow();
  void exportOpenFoam();
  [[nodiscard]] MeshKind kind() const;
  [[nodiscard]] MeshWriteOptions options() const;

  CaseModels& models_;
  PathChooser chooser_;
  QComboBox* mesh_;
  QComboBox* format_;
  QComboBox* unit_;
  QComboBox* frame_;
  QCheckBox* normals_;
  QCheckBox* quality_;
  QCheckBox* report_;
  QCheckBox* ports_;
  QCheckBox* patches_;
  QLabel* size_;
  QLabel* hint_;
  QLabel* note_;
};

}  // namespace angiomesh
