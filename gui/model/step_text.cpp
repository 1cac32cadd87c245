// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/step_text.h"

#include "core/parameters/field.h"

#include <map>

namespace angiomesh {

namespace {

/// "curvatureFlow.timeStep" -> "Curvature flow time step".
QString spokenName(const std::string& key) {
  QString text;
  bool start = true;
  for (const char c : key.substr(key.find('.') + 1)) {
    if (c == '.') {
      text += u' ';
      continue;
    }
    const QChar letter = QLatin1Char(c);
    if (letter.isUpper() && !text.isEmpty()) {
      text += u' ';
    }
    text += start ? letter.toUpper() : letter.toLower();
    start = false;
  }
  for (const char* unit : {" mm3", " mm", " voxels"}) {
    if (text.endsWith(QLatin1String(unit))) {
      text.chop(static_cast<int>(qstrlen(unit)));
    }
  }
  return text;
}

const std::map<std::string, QString>& labels() {
  static const std::map<std::string, QString> table{
      {"preprocess.isotropic", QStringLiteral("Cubic voxels")},
      {"preprocess.roi", QStringLiteral("Region of interest")},
      {"preprocess.clamp.lower", QStringLiteral("Least intensity")},
      {"preprocess.clamp.upper", QStringLiteral("Bone above")},
      {"preprocess.clamp.rimVoxels", QStringLiteral("Rim of bone")},
      {"preprocess.sigmoid.enabled", QStringLiteral("Sigmoid mapping")},
      {"vesselness.sigmaMinMm", QStringLiteral("Thinnest vessel")},
      {"vesselness.scalesFromImage", QStringLiteral("Scales from the image")},
      {"vesselness.sigmaMaxMm", QStringLiteral("Thickest vessel")},
      {"vesselness.k", QStringLiteral("k")},
      {"preprocess.sigmoid.window", QStringLiteral("Sigmoid window")},
      {"preprocess.sigmoid.level", QStringLiteral("Sigmoid level")},
      {"preprocess.curvatureFlow.enabled", QStringLiteral("Curvature flow")},
      {"preprocess.curvatureFlow.iterations", QStringLiteral("Flow iterations")},
      {"preprocess.curvatureFlow.timeStep", QStringLiteral("Flow time step")},
      {"seeds.topPercent", QStringLiteral("Top share")},
      {"seeds.least", QStringLiteral("Least of a seed")},
      {"seeds.points", QStringLiteral("Seeds by hand")},
      {"levelset.gamma", QStringLiteral("Image weight γ")},
      {"levelset.d", QStringLiteral("Curvature d")},
      {"levelset.xi", QStringLiteral("Threshold ξ")},
      {"levelset.acrossCrests", QStringLiteral("Move on crests")},
      {"levelset.stepVoxels", QStringLiteral("Step of the front")},
      {"levelset.b", QStringLiteral("Threshold b")},
      {"levelset.bRule", QStringLiteral("Rule for b")},
      {"levelset.bMin", QStringLiteral("Least b")},
      {"levelset.bMax", QStringLiteral("Largest b")},
      {"levelset.start", QStringLiteral("Start")},
      {"levelset.floodLeastVoxels", QStringLiteral("Least part without a seed")},
      {"levelset.refine", QStringLiteral("Place the wall anew")},
      {"levelset.refineLevel", QStringLiteral("Lumen level")},
      {"levelset.refineAlong", QStringLiteral("Smoothing along")},
      {"levelset.refineAcross", QStringLiteral("Smoothing across")},
      {"levelset.refineMeanSteps", QStringLiteral("Lumen mean, steps")},
      {"levelset.refineReachVoxels", QStringLiteral("Reach of the wall")},
      {"levelset.toleranceDelta", QStringLiteral("Tolerance, delta")},
      {"wall.smooth", QStringLiteral("Smooth wall")},
      {"wall.reach", QStringLiteral("Smoothness")},
      {"wall.spreadVoxels", QStringLiteral("Point spread")},
      {"segmentation.method", QStringLiteral("Method")},
      {"comparison.gac.sigmaVoxels", QStringLiteral("Contour: scale")},
      {"comparison.gac.alpha", QStringLiteral("Contour: α")},
      {"comparison.gac.beta", QStringLiteral("Contour: β")},
      {"comparison.gac.propagation", QStringLiteral("Contour: propagation")},
      {"comparison.gac.curvature", QStringLiteral("Contour: curvature")},
      {"comparison.gac.advection", QStringLiteral("Contour: advection")},
      {"comparison.gac.iterations", QStringLiteral("Contour: iterations")},
      {"comparison.gac.rms", QStringLiteral("Contour: RMS change")},
      {"comparison.confidence.multiplier", QStringLiteral("Region: multiplier")},
      {"comparison.confidence.iterations", QStringLiteral("Region: iterations")},
      {"comparison.confidence.radiusVoxels", QStringLiteral("Region: radius")},
      {"comparison.threshold.lower", QStringLiteral("Threshold: lower")},
      {"comparison.threshold.upper", QStringLiteral("Threshold: upper")},
      {"comparison.threshold.sigmaVoxels", QStringLiteral("Threshold: Gaussian")},
      {"comparison.threshold.fromSeeds", QStringLiteral("Threshold: from the seeds")},
      {"segmentation.drop", QStringLiteral("Parts ticked off")},
      {"segmentation.keep", QStringLiteral("Parts kept")},
      {"segmentation.connectivity", QStringLiteral("Voxels joined by")},
      {"ports.cuts", QStringLiteral("Cuts")},
      {"ports.cutBorders", QStringLiteral("Cut across at the border")},
      {"ports.names", QStringLiteral("Names of ports")},
      {"ports.cutEndsRadii", QStringLiteral("Ends cut at")},
      {"surface.cellVoxels", QStringLiteral("Cell size")},
      {"surface.border", QStringLiteral("At the border")},
      {"surface.spline", QStringLiteral("Interpolant")},
      {"smooth.method", QStringLiteral("Smoothing")},
      {"surface.minComponentMm3", QStringLiteral("Least component")},
      {"surface.rho", QStringLiteral("Accuracy ρ")},
      {"surface.etaInverse", QStringLiteral("Size ratio 1/η")},
      {"surface.etaCompensated", QStringLiteral("1/η for gradation alone")},
      {"surface.curvatureRelax", QStringLiteral("Curvature relax")},
      {"surface.edgeMinVoxels", QStringLiteral("Finest edge")},
      {"surface.edgeMinMm", QStringLiteral("Shortest edge")},
      {"surface.edgeMaxMm", QStringLiteral("Longest edge")},
      {"smooth.lambda", QStringLiteral("λ")},
      {"smooth.mu", QStringLiteral("μ")},
      {"smooth.wallBoundVoxels", QStringLiteral("Wall bound")}};
  return table;
}

}  // namespace

QString stepTitle(Step step) {
  switch (step) {
    case Step::Load:
      return QStringLiteral("Load");
    case Step::Preprocess:
      return QStringLiteral("Preprocess");
    case Step::Vesselness:
      return QStringLiteral("Vesselness");
    case Step::Seeds:
      return QStringLiteral("Seeds");
    case Step::Evolve:
      return QStringLiteral("Evolve");
    case Step::Surface:
      return QStringLiteral("Surface");
    case Step::Smooth:
      return QStringLiteral("Smooth");
    case Step::Quality:
      return QStringLiteral("Quality");
  }
  return {};
}

QString layerTitle(Layer layer) {
  switch (layer) {
    case Layer::Source:
      return QStringLiteral("Source");
    case Layer::Preprocessed:
      return QStringLiteral("Preprocessed");
    case Layer::Vesselness:
      return QStringLiteral("Vesselness");
    case Layer::Speed:
      return QStringLiteral("Speed p");
  }
  return {};
}

QString meshTitle(MeshKind kind) {
  switch (kind) {
    case MeshKind::Exported:
      return QStringLiteral("exported (smoothed)");
    case MeshKind::Unsmoothed:
      return QStringLiteral("unsmoothed");
    case MeshKind::MarchingCubes:
      return QStringLiteral("marching cubes");
  }
  return {};
}

QString gridText(const Geometry& grid) {
  return QObject::tr("%1 × %2 × %3 voxels of %4 × %5 × %6 mm")
      .arg(grid.size[0])
      .arg(grid.size[1])
      .arg(grid.size[2])
      .arg(grid.spacing[0], 0, 'g', 4)
      .arg(grid.spacing[1], 0, 'g', 4)
      .arg(grid.spacing[2], 0, 'g', 4);
}

QString boxSizeText(const Eigen::Vector3d& size, LengthUnit unit) {
  const bool metres = unit == LengthUnit::Metre;
  const int decimals = metres ? 5 : 2;
  return QStringLiteral("%1 × %2 × %3 %4")
      .arg(size[0], 0, 'f', decimals)
      .arg(size[1], 0, 'f', decimals)
      .arg(size[2], 0, 'f', decimals)
      .arg(metres ? QStringLiteral("m") : QStringLiteral("mm"));
}

Step stepOfField(const Field& field) {
  const std::string group = field.key.substr(0, field.key.find('.'));
  if (group == "levelset" || group == "comparison" || field.key == "segmentation.method" ||
      field.key == "segmentation.label") {
    return Step::Evolve;
  }
  if (group == "segmentation" || group == "ports") {
    return Step::Surface;
  }
  return stepFromId(group).value_or(Step::Preprocess);
}

FieldPresentation presentationOf(const Field& field) {
  FieldPresentation shown;
  const auto label = labels().find(field.key);
  shown.label = label != labels().end() ? label->second : spokenName(field.key);
  shown.unit = QString::fromStdString(field.unit);
  if (field.key == "vesselness.sigmaMinMm" || field.key == "vesselness.sigmaMaxMm") {
    // A vessel answers most at sigma = radius, and users think in diameters.
    shown.factor = 2.0;
  }
  return shown;
}

}  // namespace angiomesh
