// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/slice_text.h"

#include "core/base/formatted.h"
#include "gui/view/slice_view.h"

namespace angiomesh {

SliceWords sliceWords() {
  SliceWords words;
  words.planes = {SliceView::tr("Sagittal").toStdString(), SliceView::tr("Coronal").toStdString(),
                  SliceView::tr("Axial").toStdString()};
  words.slabs = {"", SliceView::tr("MIP").toStdString(), SliceView::tr("MinIP").toStdString(),
                 SliceView::tr("Mean").toStdString()};
  words.turned = SliceView::tr("turned by %1°").toStdString();
  words.patientAxes = SliceView::tr("Patient axes").toStdString();
  return words;
}

QStringList probeLines(const SliceScene::Probe& probe, const ValueNames& names,
                       const Eigen::Vector3d& lps) {
  QStringList value{names.layer, QString::number(static_cast<double>(probe.value), 'g', 5),
                    names.unit};
  value.removeAll(QString());
  if (probe.overlay)
    value << QStringLiteral("(%1 %2)").arg(
        names.overlay, QString::number(static_cast<double>(*probe.overlay), 'g', 3));
  const Index3& v = probe.voxel;
  return {SliceView::tr("%1, voxel %2,%3,%4").arg(value.join(' ')).arg(v[0]).arg(v[1]).arg(v[2]),
          QString::fromStdString(placeText(lps))};
}

}  // namespace angiomesh
