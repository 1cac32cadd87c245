// SPDX-License-Identifier: BSD-3-Clause
#include "gui/panel/export_dialog.h"

#include <Eigen/Geometry>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <utility>

#include "gui/model/case_controller.h"
#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;

}  // namespace

PathChooser dialogPathChooser() {
  PathChooser chooser;
  chooser.openFile = [](QWidget* parent) {
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Open a volume"), {},
        QObject::tr("Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm);;All files (*)"),
        nullptr, QFileDialog::DontUseNativeDialog);
  };
  chooser.openFolder = [](QWidget* parent) {
    return QFileDialog::getExistingDirectory(
        parent, QObject::tr("Open a DICOM folder"), {},
        QFileDialog::ShowDirsOnly | QFileDialog::DontUseNativeDialog);
  };
  chooser.save = [](QWidget* parent, const QString& suggested, const QString& filter) {
    return QFileDialog::getSaveFileName(parent, QObject::tr("Export"), suggested, filter, nullptr,
                                        QFileDialog::DontUseNativeDialog);
  };
  return chooser;
}

ExportDialog::ExportDialog(CaseController& controller, PathChooser chooser, QWidget* parent)
    : QDialog(parent), controller_(controller), chooser_(std::move(chooser)) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export mesh"));
  auto* form = new QFormLayout(this);
  mesh_ = new QComboBox(this);
  mesh_->setObjectName("exportMesh");
  for (int i = 0; i < kMeshKindCount; ++i) {
    if (controller_.mesh(static_cast<MeshKind>(i))) {
      mesh_->addItem(meshTitle(static_cast<MeshKind>(i)), i);
    }
  }
  form->addRow(tr("Mesh"), mesh_);
  format_ = new QComboBox(this);
  format_->setObjectName("exportFormat");
  format_->addItem(tr("PLY, binary"), ".ply");
  format_->addItem(tr("STL, binary"), ".stl");
  form->addRow(tr("Format"), format_);
  unit_ = new QComboBox(this);
  unit_->setObjectName("exportUnit");
  unit_->addItems({tr("millimetres"), tr("metres")});
  form->addRow(tr("Unit"), unit_);
  frame_ = new QComboBox(this);
  frame_->setObjectName("exportFrame");
  frame_->addItems({tr("LPS (DICOM, ITK)"), tr("RAS (NIfTI, Slicer)")});
  form->addRow(tr("Frame"), frame_);
  size_ = new QLabel(this);
  size_->setObjectName("exportSize");
  form->addRow(tr("Size of the result"), size_);
  report_ = new QCheckBox(tr("Write NAME.report.json beside it"), this);
  report_->setObjectName("exportReport");
  report_->setChecked(true);
  form->addRow(report_);
  note_ = new QLabel(tr("The mesh belongs to earlier parameters: run again for the present ones."),
                     this);
  note_->setWordWrap(true);
  form->addRow(note_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName("exportGo");
  go->setDefault(true);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &ExportDialog::exportNow);
  for (QComboBox* combo : {mesh_, unit_, frame_}) {
    connect(combo, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  }
  connect(&controller_, &CaseController::resultsChanged, this, &ExportDialog::refresh);
  refresh();
}

MeshKind ExportDialog::kind() const { return static_cast<MeshKind>(mesh_->currentData().toInt()); }

void ExportDialog::refresh() {
  note_->setVisible(!controller_.meshFresh());
  const auto mesh = controller_.mesh(kind());
  if (!mesh || mesh->points.empty()) {
    size_->setText(tr("nothing"));
    return;
  }
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : mesh->points) {
    box.extend(point);
  }
  const bool metres = unit_->currentIndex() == 1;
  const Eigen::Vector3d size = box.sizes() / (metres ? kMillimetresPerMetre : 1.0);
  const int decimals = metres ? 5 : 2;
  size_->setText(QStringLiteral("%1 × %2 × %3 %4")
                     .arg(size[0], 0, 'f', decimals)
                     .arg(size[1], 0, 'f', decimals)
                     .arg(size[2], 0, 'f', decimals)
                     .arg(metres ? tr("m") : tr("mm")));
}

void ExportDialog::exportNow() {
  const QString extension = format_->currentData().toString();
  QString path = chooser_.save(this, "vessels" + extension,
                               tr("%1 (*%2)").arg(format_->currentText(), extension));
  if (path.isEmpty()) {
    return;
  }
  if (!path.endsWith(extension, Qt::CaseInsensitive)) {
    path += extension;
  }
  controller_.exportMesh(
      kind(), path, unit_->currentIndex() == 1 ? LengthUnit::Metre : LengthUnit::Millimetre,
      frame_->currentIndex() == 1 ? Frame::Ras : Frame::Lps, report_->isChecked());
  accept();
}

}  // namespace angiomesh
