// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gui/job/inspect_job.h"

namespace angiomesh {

/// HTML with pictures in it, which are encoded when the page is written.
class ReportPage {
 public:
  void add(const QString& html) { text_.back() += html; }
  /// @param alt what it shows
  void addPicture(const QImage& picture, const QString& alt);
  void append(const ReportPage& page);
  /// UTF-8, with the pictures as data: URIs.
  [[nodiscard]] std::string bytes() const;

 private:
  QStringList text_{QString()};  ///< one more than pictures: before, between and after them
  std::vector<QImage> pictures_;
};

/// Measures the meshes of a report by several measures, off the window's thread.
struct ReportMeasuresJob {
  std::vector<const TriangleMeasure*> measures;
  std::array<std::shared_ptr<const TriMesh>, kMeshKindCount> meshes;
  Progress progress;

  void execute() noexcept;

  // After execute():
  std::vector<std::shared_ptr<const MeasuredMeshes>> measured;  ///< those that could be made
};

/// Writes a report, off the window's thread.
struct ReportFileJob {
  ReportPage page;
  std::filesystem::path path;

  void execute() noexcept;

  // After execute():
  std::string error;
};

}  // namespace angiomesh
