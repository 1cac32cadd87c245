// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/result_text.h"

#include <QObject>

#include "gui/model/step_text.h"

namespace angiomesh {

namespace {

ShownText shown(const QString& text, bool stale) {
  return {stale ? QObject::tr("%1, out of date").arg(text) : text, stale};
}

ShownText evolving(const ResultModel& results, const RunModel& runs) {
  if (const auto iterations = results.frontShown())
    return {results.live() ? QObject::tr("Evolving, back at iteration %1").arg(*iterations)
                           : QObject::tr("Result %1, the front after iteration %2")
                                 .arg(results.segmentationName())
                                 .arg(*iterations)};
  return {QObject::tr("Evolving, iteration %1").arg(runs.iterations())};
}

QString resultText(const QString& name) { return QObject::tr("Result %1").arg(name); }

}  // namespace

ShownText layerText(const ResultModel& results, Layer layer, bool isShown) {
  const QString title = layerTitle(layer);
  if (!isShown) return {QObject::tr("Source (no %1 yet)").arg(title.toLower())};
  return shown(title, !results.layerFresh(layer));
}

ShownText overlayText(ResultModel& results, Layer overlay) {
  const QString title = layerTitle(overlay);
  if (!results.layer(overlay))
    return {QObject::tr("No %1 yet to lay over it").arg(title.toLower())};
  return shown(QObject::tr("%1 over it").arg(title), !results.layerFresh(overlay));
}

ShownText contourText(const ResultModel& results, const RunModel& runs) {
  if (results.live() || results.frontShown()) return evolving(results, runs);
  if (!results.segmentation()) return {};
  return shown(resultText(results.segmentationName()), !results.fresh(Step::Correct));
}

ShownText surfaceText(const ResultModel& results, const RunModel& runs, MeshKind kind) {
  if (results.liveSurface()) return evolving(results, runs);
  if (results.kindAtHand(kind) == MeshKind::File) return meshText(results, kind);
  if (!results.meshFits() && results.segmentation()) {
    const ShownText segmentation = contourText(results, runs);
    return {QObject::tr("%1, no mesh yet").arg(segmentation.text), segmentation.stale};
  }
  return meshText(results, kind);
}

ShownText meshText(const ResultModel& results, MeshKind kind) {
  const MeshKind atHand = results.kindAtHand(kind);
  if (atHand == MeshKind::File) return {QObject::tr("Mesh from a file")};
  const ShownText mesh = meshText(results);
  if (mesh.text.isEmpty()) return {};
  return {mesh.text + '\n' + meshTitle(atHand), mesh.stale};
}

ShownText meshText(const ResultModel& results) {
  if (results.meshName().isEmpty()) return {};
  return shown(resultText(results.meshName()), !results.meshFresh());
}

}  // namespace angiomesh
