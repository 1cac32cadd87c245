// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/case_thumbnail_job.h"

#include <QFile>
#include <QImage>
#include <QSaveFile>
#include <exception>

#include "core/image/projection.h"

namespace angiomesh {

void CaseThumbnailJob::execute() noexcept {
  try {
    const Picture picture = mipFromTheFront(*image, longestSide);
    const QImage pixels(picture.rgb.data(), picture.width, picture.height, 3 * picture.width,
                        QImage::Format_RGB888);
    QSaveFile file(QString::fromStdString(path.string()));
    if (!file.open(QIODevice::WriteOnly)) return;
    file.setPermissions(QFile::ReadOwner | QFile::WriteOwner);
    if (pixels.save(&file, "PNG")) file.commit();
  } catch (const std::exception&) {
    return;
  }
}

}  // namespace angiomesh
