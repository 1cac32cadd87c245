// SPDX-License-Identifier: BSD-3-Clause
#include "gui/dialog/export_dialog.h"

#include <Eigen/Geometry>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "core/base/formatted.h"
#include "gui/dialog/shared_history.h"
#include "gui/model/case_models.h"
#include "gui/model/step_text.h"
#include "gui/panel/named.h"
#include "io/mesh/mesh_format.h"
#include "io/volume/image_format.h"

namespace angiomesh {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;

/// What the list of formats has: a format of files in one encoding, or a folder for OpenFOAM.
struct Format {
  QString title;
  const MeshFormat* file;  ///< null: the folder
  MeshEncoding encoding;

  [[nodiscard]] bool holdsExtras() const { return file && file->properties; }
  [[nodiscard]] bool holdsNames() const { return !file || file->holdsNames(encoding); }
  [[nodiscard]] QString hint() const {
    return !file ? ExportDialog::tr(
                       "A folder with the surface in metres, a patch for each port, "
                       "and what OpenFOAM needs to fill it.")
                 : QCoreApplication::translate("MeshFormat", file->hint);
  }
};

std::vector<Format> exportFormats() {
  std::vector<Format> all;
  for (const MeshFormat& format : meshFormats()) {
    const QString name = QLatin1String(format.name);
    if (format.binary) {
      all.push_back({format.text ? ExportDialog::tr("%1, binary").arg(name) : name, &format,
                     MeshEncoding::Binary});
    }
    if (format.text) {
      all.push_back({format.binary ? ExportDialog::tr("%1, ASCII").arg(name) : name, &format,
                     MeshEncoding::Ascii});
    }
  }
  all.push_back({ExportDialog::tr("OpenFOAM case"), nullptr, MeshEncoding::Ascii});
  return all;
}

/// Not a file but a folder.
bool isFolder(const Format& format) { return format.file == nullptr; }

Format chosenFormat(const QComboBox& combo) {
  return exportFormats()[static_cast<std::size_t>(std::max(combo.currentIndex(), 0))];
}

}  // namespace

PathChooser dialogPathChooser() {
  PathChooser chooser;
  chooser.openFile = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Open a volume"), {},
        QObject::tr("Volumes (*%1);;Cases (case.json);;All files (*)")
            .arg(QString::fromStdString(joined(imageEndings(false), " *"))),
        nullptr, QFileDialog::DontUseNativeDialog);
  };
  chooser.openFolder = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getExistingDirectory(
        parent, QObject::tr("Open a DICOM folder"), {},
        QFileDialog::ShowDirsOnly | QFileDialog::DontUseNativeDialog);
  };
  chooser.openPorts = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getOpenFileName(parent, QObject::tr("Import ports"), {},
                                        QObject::tr("Ports (*.json);;All files (*)"), nullptr,
                                        QFileDialog::DontUseNativeDialog);
  };
  chooser.save = [](QWidget* parent, const QString& suggested, const QString& filter) {
    const SharedHistory history;
    return QFileDialog::getSaveFileName(parent, QObject::tr("Export"), suggested, filter, nullptr,
                                        QFileDialog::DontUseNativeDialog);
  };
  return chooser;
}

ExportDialog::ExportDialog(CaseModels& models, PathChooser chooser, QWidget* parent)
    : QDialog(parent), models_(models), chooser_(std::move(chooser)) {
  setObjectName("exportDialog");
  setWindowTitle(tr("Export mesh"));
  auto* column = new QVBoxLayout(this);
  auto* form = new QFormLayout;
  column->addLayout(form);
  addChoices(form);
  addNotes(form, column);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* go = named(buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole), "exportGo");
  go->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &ExportDialog::exportNow);
  for (QComboBox* combo : {mesh_, format_, unit_, frame_})
    connect(combo, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &ExportDialog::refresh);
  refresh();
}

void ExportDialog::addChoices(QFormLayout* form) {
  const auto combo = [&](const char* name, const QString& label, const QStringList& items) {
    auto* made = named(new QComboBox(this), name);
    made->addItems(items);
    form->addRow(label, made);
    return made;
  };
  mesh_ = combo("exportMesh", tr("Mesh"), {});
  for (int i = 0; i < kMeshKindCount; ++i)
    if (models_.results.mesh(static_cast<MeshKind>(i)))
      mesh_->addItem(meshTitle(static_cast<MeshKind>(i)), i);
  format_ = combo("exportFormat", tr("Format"), {});
  for (const Format& format : exportFormats()) format_->addItem(format.title);
  unit_ = combo("exportUnit", tr("Unit"), {tr("millimetres"), tr("metres")});
  frame_ = combo("exportFrame", tr("Frame"), {tr("LPS (DICOM, ITK)"), tr("RAS (NIfTI, Slicer)")});
}

void ExportDialog::addNotes(QFormLayout* form, QVBoxLayout* below) {
  const auto check = [&](const char* name, const QString& text, bool on) {
    auto* made = named(new QCheckBox(text, this), name);
    made->setChecked(on);
    form->addRow(made);
    return made;
  };
  size_ = named(new QLabel(this), "exportSize");
  form->addRow(tr("Size of the result"), size_);
  normals_ = check("exportNormals", tr("Normals of the vertices"), false);
  quality_ = check("exportQuality", tr("Quality of the triangles (radius ratio)"), false);
  report_ = check("exportReport", tr("Write NAME.report.json beside it"), true);
  ports_ = check("exportPortsFile", tr("Write NAME.ports.json beside it: where the ports lie"),
                 !models_.document.parameters().ports.cuts.empty());
  patches_ = check("exportPatches", tr("Write each patch to a file of its own, too"), false);
  hint_ = named(new QLabel(this), "exportHint");
  note_ = new QLabel(tr("The mesh belongs to earlier parameters: run again for the present ones."),
                     this);
  for (QLabel* label : {hint_, note_}) {
    label->setWordWrap(true);
    below->addWidget(label);
  }
}

MeshKind ExportDialog::kind() const { return static_cast<MeshKind>(mesh_->currentData().toInt()); }

void ExportDialog::refresh() {
  const Format format = chosenFormat(*format_);
  const bool patches = !models_.results.ports(kind()).empty();
  normals_->setEnabled(format.holdsExtras());
  quality_->setEnabled(format.holdsExtras());
  for (QWidget* widget : std::initializer_list<QWidget*>{unit_, frame_, report_})
    widget->setEnabled(!isFolder(format));
  ports_->setEnabled(patches && !isFolder(format));
  patches_->setEnabled(patches && !isFolder(format));
  refreshHint();
  note_->setVisible(!models_.results.meshFresh());
  const auto mesh = models_.results.mesh(kind());
  if (!mesh || mesh->points.empty()) {
    size_->setText(tr("nothing"));
    return;
  }
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : mesh->points) box.extend(point);
  const LengthUnit unit = options().unit;
  const double millimetres = unit == LengthUnit::Metre ? kMillimetresPerMetre : 1.0;
  size_->setText(boxSizeText(box.sizes() / millimetres, unit));
}

void ExportDialog::refreshHint() {
  const Format format = chosenFormat(*format_);
  QStringList hints;
  if (!format.hint().isEmpty()) hints << format.hint();
  const std::vector<Port> ports = models_.results.ports(kind());
  if (!ports.empty() && !format.holdsNames())
    hints << tr("⚠ It loses the names of the %1 ports: STL, ASCII has them.").arg(ports.size());
  const MeshQuality* quality = models_.results.quality(kind());
  const bool sound = !quality || (quality->selfIntersections == 0 && quality->oriented &&
                                  quality->nonManifoldEdges + quality->nonManifoldVertices == 0);
  if (!sound) {
    hints << tr(
        "⚠ This mesh cuts itself or is no manifold: a flow solver will refuse it. Marching "
        "cubes of the same level set may do.");
  }
  if (isFolder(format)) {
    if (ports.empty()) hints << tr("⚠ This mesh has no ports: nothing could flow in or out.");
    if (quality && !quality->closed)
      hints << tr("⚠ The mesh is not closed: choose surface.border = cap.");
    if (quality && quality->components > 1) {
      hints << tr("⚠ The surface has %1 parts that are not connected, and OpenFOAM fills one: "
                  "tick the others off, or set segmentation.keep.")
                   .arg(quality->components);
    }
  }
  hint_->setText(hints.join('\n'));
  hint_->setVisible(!hints.isEmpty());
  // Once the layout knows of the text: the dialog does not grow with it by itself.
  QMetaObject::invokeMethod(
      this, [this] { adjustSize(); }, Qt::QueuedConnection);
}

MeshWriteOptions ExportDialog::options() const {
  const Format format = chosenFormat(*format_);
  MeshWriteOptions options;
  const bool metres = unit_->currentIndex() == 1 || isFolder(format);
  options.unit = metres ? LengthUnit::Metre : LengthUnit::Millimetre;
  options.frame = frame_->currentIndex() == 1 ? Frame::Ras : Frame::Lps;
  options.encoding = format.encoding;
  options.normals = format.holdsExtras() && normals_->isChecked();
  options.quality = format.holdsExtras() && quality_->isChecked();
  return options;
}

void ExportDialog::exportOpenFoam() {
  const QString folder = chooser_.save(this, QStringLiteral("case"), tr("Folders (*)"));
  if (folder.isEmpty()) return;
  // A case that was exported before is replaced, as the chooser has asked; no other folder is
  // filled.
  const bool before = QFileInfo::exists(folder + QStringLiteral("/system/snappyHexMeshDict"));
  models_.exports.exportOpenFoam(kind(), folder, before);
  accept();
}

void ExportDialog::exportNow() {
  if (isFolder(chosenFormat(*format_))) {
    exportOpenFoam();
    return;
  }
  const QString extension = QLatin1String(chosenFormat(*format_).file->extension);
  QString path = chooser_.save(this, "vessels" + extension,
                               tr("%1 (*%2)").arg(format_->currentText(), extension));
  if (path.isEmpty()) return;
  if (!path.endsWith(extension, Qt::CaseInsensitive)) path += extension;
  ExportExtras extras;
  extras.report = report_->isChecked();
  extras.ports = ports_->isEnabled() && ports_->isChecked();
  extras.patches = patches_->isEnabled() && patches_->isChecked();
  models_.exports.exportMesh(kind(), path, options(), extras);
  accept();
}

}  // namespace angiomesh
