// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/measure/review.h"
#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "gui/job/display_facts.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/scan/label_image.h"
#include "io/scan/mask_file.h"

namespace angiomesh {

/// Loads a case off the window's thread: execute() on the worker, the results after it.
class LoadJob {
 public:
  /// @param path file or folder; empty: the built-in sample   @param name shown to the user
  LoadJob(std::filesystem::path path, std::string name);
  /// For a volume that an earlier job listed; `evenOut`: its missing slices are to be resampled.
  LoadJob(std::filesystem::path path, std::string name, ImageSummary entry, bool evenOut);
  /// For a label that an earlier job listed; nothing: the image is a scan.
  LoadJob(std::filesystem::path path, std::string name, std::optional<Label> label);
  /// For a source that is at hand already.
  explicit LoadJob(Source source);
  virtual ~LoadJob() = default;
  LoadJob(const LoadJob&) = delete;
  LoadJob& operator=(const LoadJob&) = delete;

  /// Parameters for the case to begin with, in place of the present ones.
  void startWith(const Parameters& params) { startParameters_ = params; }
  [[nodiscard]] const std::optional<Parameters>& startParameters() const {
    return startParameters_;
  }

  void execute() noexcept;

  [[nodiscard]] const Progress& progress() const { return progress_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::string& name() const { return name_; }

  // After execute():
  [[nodiscard]] bool cancelled() const { return cancelled_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const InputInfo& info() const { return info_; }
  /// The volumes of the folder when one has to be chosen; nothing is loaded then.
  [[nodiscard]] const std::vector<ImageSummary>& choices() const { return choices_; }
  /// Why the slices of entry() are no volume unless they are resampled; empty: nothing of the kind.
  [[nodiscard]] const std::string& uneven() const { return uneven_; }
  [[nodiscard]] const std::optional<ImageSummary>& entry() const { return entry_; }
  /// The labels of a segmentation when one has to be chosen; nothing is loaded then.
  [[nodiscard]] const std::vector<Label>& labels() const { return labels_; }
  /// The one that was taken; nothing: a scan.
  [[nodiscard]] const std::optional<Label>& label() const { return label_; }
  /// Null when there was no source to find.
  [[nodiscard]] std::shared_ptr<Pipeline> pipeline() const { return pipeline_; }
  /// What forms need of the image; the window is DisplayFacts::window().
  [[nodiscard]] const FieldContext& facts() const { return facts_; }
  [[nodiscard]] const DisplayFacts& display() const { return display_; }

 protected:
  /// The source, without an image where it cannot be found; the rest goes to setInfo().
  virtual Source obtain();
  /// May fill the new pipeline with results.
  virtual void prepare(Pipeline& /*pipeline*/) {}

  void setInfo(InputInfo info) { info_ = std::move(info); }

 private:
  void load();
  /// Whether a label is to be chosen; takes the only one.
  bool findLabels(const Volume<float>& image);

  std::filesystem::path path_;
  std::string name_;
  std::optional<ImageSummary> entry_;
  bool evenOut_ = false;
  bool asScan_ = false;
  std::optional<Label> label_;
  std::vector<Label> labels_;
  std::vector<ImageSummary> choices_;
  std::string uneven_;
  Source source_;
  std::optional<Parameters> startParameters_;
  Progress progress_;
  bool cancelled_ = false;
  std::string error_;
  InputInfo info_;
  std::shared_ptr<Pipeline> pipeline_;
  FieldContext facts_;
  DisplayFacts display_;
};

enum class ExportKind { Mesh, OpenFoam, Ports, Mask };

/// Files beside an exported mesh.
struct ExportExtras {
  bool report = false;     ///< NAME.report.json
  bool ports = false;      ///< NAME.ports.json
  bool patches = false;    ///< a file of each patch, see writePatchFiles()
  CaseReview review = {};  ///< goes into the report
};

/// What an export writes.
struct ExportRequest {
  ExportKind kind = ExportKind::Mesh;
  std::shared_ptr<const TriMesh> mesh;
  std::vector<Port> ports;  ///< of the mesh
  /// By extension; of OpenFOAM a folder.
  std::filesystem::path path;
  MeshWriteOptions options;
  ExportExtras extras;
  std::shared_ptr<const RunResult> report;        ///< for ExportExtras::report
  bool replace = false;                           ///< a case in the folder for OpenFOAM
  std::shared_ptr<const RunResult> segmentation;  ///< of a mask, which needs no mesh
  std::optional<DicomOrigin> origin;              ///< the mask becomes a DICOM segmentation
};

/// Writes a mesh or a mask, and reads it back to see that the file holds it.
class ExportJob {
 public:
  explicit ExportJob(ExportRequest request) : request_(std::move(request)) {}

  void execute() noexcept;

  [[nodiscard]] const ExportRequest& request() const { return request_; }
  [[nodiscard]] const std::string& error() const { return error_; }
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  /// What was read back.
  [[nodiscard]] const MeshFileFacts& facts() const { return facts_; }
  [[nodiscard]] std::size_t patchFiles() const { return patchFiles_; }
  /// Inside the mask.
  [[nodiscard]] std::size_t maskVoxels() const { return maskVoxels_; }
  /// The file's name without its folder.
  [[nodiscard]] std::string fileName() const { return request_.path.filename().string(); }

 private:
  void write();
  void writeMeshFiles();
  void writeMaskFile();

  ExportRequest request_;
  std::string error_;
  std::vector<std::string> warnings_;
  MeshFileFacts facts_;
  std::size_t patchFiles_ = 0;
  std::size_t maskVoxels_ = 0;
};

/// `message` with the name in place of the path and of its folder: a path may hold a patient's
/// name.
std::string withoutPath(std::string message, const std::filesystem::path& path,
                        const std::string& name);

/// The volume of the built-in sample: a noisy vascular tree.
constexpr int kSampleSize = 128;
Source makeSampleSource(int size, const Progress& progress = {});

}  // namespace angiomesh
