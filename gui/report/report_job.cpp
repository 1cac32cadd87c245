// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/report_job.h"

#include <QBuffer>
#include <exception>

#include "core/base/error.h"
#include "gui/job/file_jobs.h"
#include "io/file/files.h"

namespace angiomesh {

namespace {

QByteArray pngOf(const QImage& picture) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  if (!picture.save(&buffer, "PNG"))
    throw NumericError("a picture cannot be encoded", "report", "close other programs");
  return bytes;
}

}  // namespace

void ReportPage::addPicture(const QImage& picture, const QString& alt) {
  text_.back() += QStringLiteral("<img alt=\"%1\" width=\"%2\" height=\"%3\" src=\"")
                      .arg(alt.toHtmlEscaped())
                      .arg(picture.width())
                      .arg(picture.height());
  text_ << QStringLiteral("\"/>");
  pictures_.push_back(picture);
}

void ReportPage::append(const ReportPage& page) {
  text_.back() += page.text_.front();
  text_ += page.text_.mid(1);
  pictures_.insert(pictures_.end(), page.pictures_.begin(), page.pictures_.end());
}

std::string ReportPage::bytes() const {
  std::string all = text_.front().toStdString();
  for (std::size_t i = 0; i < pictures_.size(); ++i) {
    all += "data:image/png;base64,";
    all += pngOf(pictures_[i]).toBase64().toStdString();
    all += text_[static_cast<qsizetype>(i) + 1].toStdString();
  }
  return all;
}

void ReportMeasuresJob::execute() noexcept {
  for (const TriangleMeasure* measure : measures) {
    if (progress.cancelled()) return;
    InspectJob job;
    job.measure = measure;
    job.meshes = meshes;
    job.progress = progress;
    job.execute();
    if (job.measured) measured.push_back(job.measured);
  }
}

void ReportFileJob::execute() noexcept {
  try {
    writeText(path, page.bytes());
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), path, path.filename().string());
  }
}

}  // namespace angiomesh
