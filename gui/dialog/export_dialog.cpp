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
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <utility>

#include "core/base/formatted.h"
#include "gui/dialog/shared_history.h"
#include "gui/model/case_models.h"
#include "gui/model/step_text.h"
#include "gui/view/named.h"
#include "io/mesh/mesh_format.h"
#include "io/volume/image_format.h"

namespace angiomesh {

namespace {

constexpr double kMillimetresPerMetre = 1000.0;

/// The item for the mask comes after those for the kinds of meshes.
constexpr int kMask = kRunMeshCount;

/// What the list of formats has: a format of meshes in one encoding, a folder for OpenFOAM, or a
/// format of masks.
struct Format {
  QString title;
  const MeshFormat* file = nullptr;  ///< null: the folder or a mask
  MeshEncoding encoding = MeshEncoding::Binary;
  QString maskEnding = {};  ///< empty: of meshes

  bool dicom = false;  ///< a DICOM segmentation

  [[nodiscard]] bool ofMasks() const { return !maskEnding.isEmpty(); }
  /// Not a file but a folder.
  [[nodiscard]] bool isFolder() const { return !file && !ofMasks(); }
  [[nodiscard]] QString extension() const {
    return file ? QString(QLatin1String(file->extension)) : maskEnding;
  }

  [[nodiscard]] bool holdsExtras() const { return file && file->properties; }
  [[nodiscard]] bool holdsNames() const { return !file || file->holdsNames(encoding); }
  [[nodiscard]] QString hint() const {
    if (dicom) {
      return ExportDialog::tr(
          "A DICOM segmentation (SEG): viewers lay it on the scan. It has the UIDs of the scan's "
          "images and of their frame of reference.");
    }
    if (ofMasks()) {
      return ExportDialog::tr(
          "1 in the voxels of the scan whose centre lies in the vessels, 0 in all others: it lies "
          "on the scan in any program.");
    }
    return !file ? ExportDialog::tr(
                       "A folder with the surface in metres, a patch for each port, "
                       "and what OpenFOAM needs to fill it.")
                 : QCoreApplication::translate("MeshFormat", file->hint);
  }
};

/// The last one is for scans from DICOM alone.
std::vector<Format> maskFormats() {
  std::vector<Format> all;
  for (const ImageFormat& format : imageFormats()) {
    const ImageEnding& ending = format.endings.front();
    if (ending.write == nullptr) continue;
    const QString text = QLatin1String(ending.text);
    all.push_back({QStringLiteral("%1 (%2)").arg(QLatin1String(format.name), text), nullptr,
                   MeshEncoding::Binary, text});
  }
  all.push_back({ExportDialog::tr("DICOM segmentation (.dcm)"), nullptr, MeshEncoding::Binary,
                 QStringLiteral(".dcm"), true});
  return all;
}

std::vector<Format> meshExports() {
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

std::vector<Format> exportFormats(bool masks) { return masks ? maskFormats() : meshExports(); }

Format chosenFormat(const QComboBox& combo, bool masks) {
  return exportFormats(masks)[static_cast<std::size_t>(std::max(combo.currentIndex(), 0))];
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
  chooser.openMesh = [](QWidget* parent) {
    const SharedHistory history;
    QStringList patterns;
    for (const MeshFormat& format : meshFormats())
      patterns << '*' + QString(QLatin1String(format.extension));
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Compare with a mesh"), {},
        QObject::tr("Meshes (%1);;All files (*)").arg(patterns.join(' ')), nullptr,
        QFileDialog::DontUseNativeDialog);
  };
  chooser.openPreset = [](QWidget* parent) {
    const SharedHistory history;
    return QFileDialog::getOpenFileName(
        parent, QObject::tr("Import a preset"), {},
        QObject::tr("Presets, recipes and parameters (*.json);;All files (*)"), nullptr,
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
  setWindowTitle(tr("Export"));
  auto* column = new QVBoxLayout(this);
  form_ = new QFormLayout;
  column->addLayout(form_);
  addChoices();
  addNotes(column);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  auto* go = named(buttons->addButton(tr("Export…"), QDialogButtonBox::AcceptRole), "exportGo");
  go->setDefault(true);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &ExportDialog::exportNow);
  connect(mesh_, &QComboBox::currentIndexChanged, this, &ExportDialog::listFormats);
  for (QComboBox* combo : {format_, unit_, frame_})
    connect(combo, &QComboBox::currentIndexChanged, this, &ExportDialog::refresh);
  connect(&models_.results, &ResultModel::resultsChanged, this, &ExportDialog::refresh);
  listFormats();
}

void ExportDialog::addChoices() {
  const auto combo = [&](const char* name, const QString& label, const QStringList& items) {
    auto* made = named(new QComboBox(this), name);
    made->addItems(items);
    form_->addRow(label, made);
    return made;
  };
  mesh_ = combo("exportMesh", tr("What"), {});
  for (int i = 0; i < kRunMeshCount; ++i)
    if (models_.results.mesh(static_cast<MeshKind>(i)))
      mesh_->addItem(tr("Mesh, %1").arg(meshTitle(static_cast<MeshKind>(i))), i);
  if (models_.results.segmentation()) mesh_->addItem(tr("Mask of the vessels"), kMask);
  format_ = combo("exportFormat", tr("Format"), {});
  unit_ = combo("exportUnit", tr("Unit"), {tr("millimetres"), tr("metres")});
  frame_ = combo("exportFrame", tr("Frame"), {tr("LPS (DICOM, ITK)"), tr("RAS (NIfTI, Slicer)")});
}

void ExportDialog::addNotes(QVBoxLayout* below) {
  const auto check = [&](const char* name, const QString& text, bool on) {
    auto* made = named(new QCheckBox(text, this), name);
    made->setChecked(on);
    form_->addRow(made);
    return made;
  };
  size_ = named(new QLabel(this), "exportSize");
  form_->addRow(tr("Size of the result"), size_);
  normals_ = check("exportNormals", tr("Normals of the vertices"), false);
  quality_ = check("exportQuality", tr("Quality of the triangles (radius ratio)"), false);
  report_ = check("exportReport", tr("Write NAME.report.json beside it"), true);
  ports_ = check("exportPortsFile", tr("Write NAME.ports.json beside it: where the ports lie"),
                 !models_.document.parameters().ports.cuts.empty());
  patches_ = check("exportPatches", tr("Write each patch to a file of its own, too"), false);
  identity_ = check("exportIdentity", tr("With the patient's identity"), false);
  connect(identity_, &QCheckBox::toggled, this, &ExportDialog::refresh);
  hint_ = named(new QLabel(this), "exportHint");
  note_ = named(new QLabel(this), "exportNote");
  for (QLabel* label : {hint_, note_}) {
    label->setWordWrap(true);
    below->addWidget(label);
  }
}

bool ExportDialog::ofMask() const { return mesh_->currentData().toInt() == kMask; }

MeshKind ExportDialog::kind() const { return static_cast<MeshKind>(mesh_->currentData().toInt()); }

void ExportDialog::listFormats() {
  const std::vector<Format> formats = exportFormats(ofMask());
  if (format_->count() == 0 || formats.front().title != format_->itemText(0)) {
    const QSignalBlocker quiet(format_);
    format_->clear();
    for (const Format& format : formats)
      if (!format.dicom || models_.files.dicomOrigin()) format_->addItem(format.title);
  }
  for (QWidget* widget : std::initializer_list<QWidget*>{unit_, frame_, normals_, quality_, report_,
                                                         ports_, patches_})
    form_->setRowVisible(widget, !ofMask());
  refresh();
}

void ExportDialog::refresh() {
  if (ofMask())
    refreshMask();
  else
    refreshMesh();
  // Once the layout knows of the text: the dialog does not grow with it by itself.
  QMetaObject::invokeMethod(
      this, [this] { adjustSize(); }, Qt::QueuedConnection);
}

void ExportDialog::refreshMask() {
  const std::shared_ptr<const Volume<float>> scan = models_.document.image();
  size_->setText(scan ? gridText(scan->geometry) : tr("nothing"));
  const Format format = chosenFormat(*format_, true);
  form_->setRowVisible(identity_, format.dicom);
  QStringList hints{format.hint()};
  if (format.dicom) {
    hints << (identity_->isChecked()
                  ? tr("⚠ The file will name the patient and the study, as the images of the scan "
                       "do: a PACS files it with them.")
                  : tr("Patient and study are left empty: tick the identity for a PACS to file it "
                       "with the scan."));
  }
  if (models_.results.live())
    hints << tr("The segmentation in work is not done: the one before is exported.");
  hint_->setText(hints.join('\n'));
  hint_->setVisible(true);
  note_->setText(
      tr("The segmentation belongs to earlier parameters: run again for the present ones."));
  note_->setVisible(!models_.results.segmentationFresh());
}

void ExportDialog::refreshMesh() {
  form_->setRowVisible(identity_, false);
  const Format format = chosenFormat(*format_, ofMask());
  const bool patches = !models_.results.ports(kind()).empty();
  normals_->setEnabled(format.holdsExtras());
  quality_->setEnabled(format.holdsExtras());
  for (QWidget* widget : std::initializer_list<QWidget*>{unit_, frame_, report_})
    widget->setEnabled(!format.isFolder());
  ports_->setEnabled(patches && !format.isFolder());
  patches_->setEnabled(patches && !format.isFolder());
  refreshHint();
  note_->setText(tr("The mesh belongs to earlier parameters: run again for the present ones."));
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
  const Format format = chosenFormat(*format_, ofMask());
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
  if (format.isFolder()) {
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
}

MeshWriteOptions ExportDialog::options() const {
  const Format format = chosenFormat(*format_, ofMask());
  MeshWriteOptions options;
  const bool metres = unit_->currentIndex() == 1 || format.isFolder();
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
  const Format format = chosenFormat(*format_, ofMask());
  if (format.isFolder()) {
    exportOpenFoam();
    return;
  }
  const QString extension = format.extension();
  QString path = chooser_.save(this, "vessels" + extension,
                               tr("%1 (*%2)").arg(format_->currentText(), extension));
  if (path.isEmpty()) return;
  if (!path.endsWith(extension, Qt::CaseInsensitive)) path += extension;
  if (ofMask())
    models_.exports.exportMask(path, format.dicom ? origin() : std::nullopt);
  else
    models_.exports.exportMesh(kind(), path, options(), extras());
  accept();
}

std::optional<DicomOrigin> ExportDialog::origin() const {
  std::optional<DicomOrigin> origin = models_.files.dicomOrigin();
  if (origin && identity_->isChecked()) origin->identity = DicomIdentity::OfSource;
  return origin;
}

ExportExtras ExportDialog::extras() const {
  ExportExtras extras;
  extras.report = report_->isChecked();
  extras.review = models_.document.notes().review;
  extras.ports = ports_->isEnabled() && ports_->isChecked();
  extras.patches = patches_->isEnabled() && patches_->isChecked();
  return extras;
}

}  // namespace angiomesh
