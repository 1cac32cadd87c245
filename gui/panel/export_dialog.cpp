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
#include <algorithm>
#include <array>
#include <utility>

#include "gui/model/case_controller.h"
#include "gui/model/step_text.h"
#include "gui/panel/shared_history.h"

namespace angiomesh {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;

struct Format {
  const char* title;
  const char* extension;
  MeshEncoding encoding;
  bool holdsExtras;  ///< normals and quality
  const char* hint;
};

constexpr const char* kNoTopology = QT_TRANSLATE_NOOP(
    "angiomesh::ExportDialog",
    "STL keeps no topology: each triangle stands alone, and its points have to be "
    "merged again on import.");

constexpr std::array<Format, 6> kFormats{
    {{QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "PLY, binary"), ".ply", MeshEncoding::Binary,
      true, ""},
     {QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "PLY, ASCII"), ".ply", MeshEncoding::Ascii, true,
      ""},
     {QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "STL, binary"), ".stl", MeshEncoding::Binary,
      false, kNoTopology},
     {QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "STL, ASCII"), ".stl", MeshEncoding::Ascii,
      false, kNoTopology},
     {QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "OBJ"), ".obj", MeshEncoding::Ascii, false, ""},
     {QT_TRANSLATE_NOOP("angiomesh::ExportDialog", "VTP (VTK)"), ".vtp", MeshEncoding::Binary, true,
      ""}}};

const Format& chosenFormat(const QComboBox& combo) {
  return kFormats[static_cast<std::size_t>(std::max(combo.currentIndex(), 0))];
}

}  // namespace

PathChooser dialogPathChooser() {
  PathChooser chooser;
  chooser.openFile = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Open a volume"), {},
        QObject::tr(
            "Volumes (*.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz *.dcm);;Cases (case.json);;All "
            "files (*)"),
        nullptr, QFileDialog::DontUseNativeDialog);
  };
  chooser.openFolder = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getExistingDirectory(
        parent, QObject::tr("Open a DICOM folder"), {},
        QFileDialog::ShowDirsOnly | QFileDialog::DontUseNativeDialog);
  };
  chooser.save = [](QWidget* parent, const QString& suggested, const QString& filter) {
    const SharedHistory history;
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
  addChoices(form);
  addNotes(form);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  QPushButton* go = buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole);
  go->setObjectName("exportGo");
  go->setDefault(true);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &ExportDialog::exportNow);
  for (QComboBox* combo : {mesh_, format_, unit_, frame_}) {
    connect(combo, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  }
  connect(&controller_, &CaseController::resultsChanged, this, &ExportDialog::refresh);
  refresh();
}

void ExportDialog::addChoices(QFormLayout* form) {
  const auto combo = [&](const char* name, const QString& label, const QStringList& items) {
    auto* made = new QComboBox(this);
    made->setObjectName(name);
    made->addItems(items);
    form->addRow(label, made);
    return made;
  };
  mesh_ = combo("exportMesh", tr("Mesh"), {});
  for (int i = 0; i < kMeshKindCount; ++i) {
    if (controller_.mesh(static_cast<MeshKind>(i))) {
      mesh_->addItem(meshTitle(static_cast<MeshKind>(i)), i);
    }
  }
  format_ = combo("exportFormat", tr("Format"), {});
  for (const Format& format : kFormats) {
    format_->addItem(tr(format.title));
  }
  unit_ = combo("exportUnit", tr("Unit"), {tr("millimetres"), tr("metres")});
  frame_ = combo("exportFrame", tr("Frame"), {tr("LPS (DICOM, ITK)"), tr("RAS (NIfTI, Slicer)")});
}

void ExportDialog::addNotes(QFormLayout* form) {
  const auto check = [&](const char* name, const QString& text, bool on) {
    auto* made = new QCheckBox(text, this);
    made->setObjectName(name);
    made->setChecked(on);
    form->addRow(made);
    return made;
  };
  size_ = new QLabel(this);
  size_->setObjectName("exportSize");
  form->addRow(tr("Size of the result"), size_);
  normals_ = check("exportNormals", tr("Normals of the vertices"), false);
  quality_ = check("exportQuality", tr("Quality of the triangles (radius ratio)"), false);
  report_ = check("exportReport", tr("Write NAME.report.json beside it"), true);
  hint_ = new QLabel(this);
  hint_->setObjectName("exportHint");
  note_ = new QLabel(tr("The mesh belongs to earlier parameters: run again for the present ones."),
                     this);
  for (QLabel* label : {hint_, note_}) {
    label->setWordWrap(true);
    form->addRow(label);
  }
}

MeshKind ExportDialog::kind() const { return static_cast<MeshKind>(mesh_->currentData().toInt()); }

void ExportDialog::refresh() {
  const Format& format = chosenFormat(*format_);
  normals_->setEnabled(format.holdsExtras);
  quality_->setEnabled(format.holdsExtras);
  hint_->setText(tr(format.hint));
  hint_->setVisible(!hint_->text().isEmpty());
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
  const LengthUnit unit = options().unit;
  const double millimetres = unit == LengthUnit::Metre ? kMillimetresPerMetre : 1.0;
  size_->setText(boxSizeText(box.sizes() / millimetres, unit));
}

MeshWriteOptions ExportDialog::options() const {
  const Format& format = chosenFormat(*format_);
  MeshWriteOptions options;
  options.unit = unit_->currentIndex() == 1 ? LengthUnit::Metre : LengthUnit::Millimetre;
  options.frame = frame_->currentIndex() == 1 ? Frame::Ras : Frame::Lps;
  options.encoding = format.encoding;
  options.normals = format.holdsExtras && normals_->isChecked();
  options.quality = format.holdsExtras && quality_->isChecked();
  return options;
}

void ExportDialog::exportNow() {
  const QString extension = QLatin1String(chosenFormat(*format_).extension);
  QString path = chooser_.save(this, "vessels" + extension,
                               tr("%1 (*%2)").arg(format_->currentText(), extension));
  if (path.isEmpty()) {
    return;
  }
  if (!path.endsWith(extension, Qt::CaseInsensitive)) {
    path += extension;
  }
  controller_.exportMesh(kind(), path, options(), report_->isChecked());
  accept();
}

}  // namespace angiomesh
