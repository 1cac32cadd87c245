// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QDialog>
#include <functional>
#include <optional>

#include "gui/job/file_jobs.h"
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
  std::function<QString(QWidget*)> openMesh;
  std::function<QString(QWidget*)> openPreset;
  std::function<QString(QWidget*, const QString& suggested, const QString& filter)> save;
};
PathChooser dialogPathChooser();

/// What to export and how: a mesh or the mask; format with what it can hold, unit and frame, with
/// the size that the result will have, and what goes beside it.
class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  ExportDialog(CaseModels& models, PathChooser chooser, QWidget* parent = nullptr);

 private:
  void addChoices();
  void addNotes(QVBoxLayout* below);
  void listFormats();
  void refresh();
  void refreshMask();
  void refreshMesh();
  void refreshHint();
  void exportNow();
  void exportOpenFoam();
  [[nodiscard]] bool ofMask() const;
  [[nodiscard]] MeshKind kind() const;
  [[nodiscard]] MeshWriteOptions options() const;
  [[nodiscard]] ExportExtras extras() const;
  [[nodiscard]] std::optional<DicomOrigin> origin() const;

  CaseModels& models_;
  PathChooser chooser_;
  QFormLayout* form_;
  QComboBox* mesh_;
  QComboBox* format_;
  QComboBox* unit_;
  QComboBox* frame_;
  QCheckBox* normals_;
  QCheckBox* quality_;
  QCheckBox* report_;
  QCheckBox* ports_;
  QCheckBox* patches_;
  QCheckBox* identity_;
  QLabel* size_;
  QLabel* hint_;
  QLabel* note_;
};

}  // namespace angiomesh
