// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/study_segmentation.h"

#include <array>
#include <map>
#include <memory>
#include <utility>

#include "app/study/figure_pictures.h"
#include "core/base/error.h"
#include "core/base/formatted.h"
#include "core/parameters/field.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/segmentation_mask.h"
#include "core/quality/overlap.h"

namespace angiomesh::cli {
namespace {

constexpr int kRuns = 10;  // one with the original measure, two other methods, seven parameters

struct Found {
  std::shared_ptr<const Volume<float>> phi;
  SegmentationPanel panel;
};

/// Segmentations of one image; those that several figures show are made once.
class Segmenter {
 public:
  Segmenter(const Volume<float>& image, const Volume<std::uint8_t>* truth, const Progress& progress)
      : pipeline_(makeSource(image, "image")), truth_(truth), progress_(progress) {}

  const Found& make(const Parameters& params) {
    const std::string key = pipeline_.key(Step::Evolve, params);
    const auto known = made_.find(key);
    if (known != made_.end()) return known->second;
    const double done = static_cast<double>(made_.size());
    const Progress part = progress_.sub(done / kRuns, (done + 1.0) / kRuns);
    RunOptions until;
    until.until = Step::Seeds;
    preprocessed_ = pipeline_.run(params, until, part.sub(0.0, 0.5)).preprocessed;
    until.until = Step::Evolve;
    Found found;
    Volume<std::uint8_t> mask;
    try {
      const RunResult run = pipeline_.run(params, until, part.sub(0.5, 1.0));
      found.phi = run.evolve->phi;
      found.panel.iterations = run.evolve->iterations;
      if (truth_) mask = segmentationMask(run, truth_->geometry);
    } catch (const NumericError&) {
      // The front shrank to nothing: a panel like any other.
      found.phi = std::make_shared<const Volume<float>>(preprocessed_->geometry, 1.0F);
    }
    const auto sizes = connectedComponents(insideMask(*found.phi)).sizes;
    found.panel.components = sizes.size();
    for (const std::size_t size : sizes) found.panel.insideVoxels += size;
    if (truth_) {
      if (mask.voxels.empty()) mask = Volume<std::uint8_t>(truth_->geometry);
      found.panel.overlap = voxelRatios(mask, *truth_).overlap;
    }
    return made_.emplace(key, std::move(found)).first->second;
  }

  [[nodiscard]] const Volume<float>& preprocessed() const { return *preprocessed_; }

 private:
  Pipeline pipeline_;
  const Volume<std::uint8_t>* truth_;
  Progress progress_;
  std::map<std::string, Found> made_;
  std::shared_ptr<const Volume<float>> preprocessed_;
};

SegmentationFigure measures(Segmenter& segmenter, const Parameters& params) {
  Parameters frangi = params;
  frangi.vesselness.measure = VesselMeasure::Frangi;
  Parameters modified = params;
  modified.vesselness.measure = VesselMeasure::Modified;
  const Found& original = segmenter.make(frangi);
  const Found& ours = segmenter.make(modified);
  SegmentationFigure figure{"3.3",
                            "Segmentation by Frangi's vesselness measure (top) and by the modified "
                            "one (middle), and the coronal slice where they differ most (bottom)",
                            {original.panel, ours.panel},
                            {}};
  figure.panels[0].title = "Frangi's measure";
  figure.panels[1].title = "modified measure";
  const Volume<float>& image = segmenter.preprocessed();
  const int slice = mostDifferentSlice(*original.phi, *ours.phi);
  figure.picture =
      stacked({coronalSlice(image, original.phi.get(), slice),
               coronalSlice(image, ours.phi.get(), slice), coronalSlice(image, nullptr, slice)});
  return figure;
}

/// The thesis has one form for Figures 5.2 and 5.3, on different scans.
SegmentationFigure methods(Segmenter& segmenter, const Parameters& params) {
  constexpr std::array<std::pair<SegmentationMethod, const char*>, 3> shown{
      {{SegmentationMethod::GeodesicActiveContour, "geodesic active contour"},
       {SegmentationMethod::ConfidenceConnected, "confidence connected"},
       {SegmentationMethod::LevelSet, "level set"}}};
  SegmentationFigure figure{"5.2",
                            "Maximum intensity projections, and below them segmentation from the "
                            "same seeds by geodesic active contour, confidence connected region "
                            "growing and the level set (Figures 5.2 and 5.3)",
                            {},
                            {}};
  std::vector<const Volume<float>*> phis;
  for (const auto& [method, title] : shown) {
    Parameters other = params;
    other.segmentation.method = method;
    const Found& found = segmenter.make(other);
    phis.push_back(found.phi.get());
    figure.panels.push_back(found.panel);
    figure.panels.back().title = title;
  }
  figure.picture = projectionRows(segmenter.preprocessed(), phis);
  return figure;
}

SegmentationFigure parameterRow(Segmenter& segmenter, const Parameters& params,
                                const std::string& number, const std::string& name, const char* key,
                                const std::array<double, 3>& values) {
  SegmentationFigure figure{
      number, "Maximum intensity projections, and below them varying " + name, {}, {}};
  std::vector<const Volume<float>*> phis;
  for (const double value : values) {
    Parameters varied = params;
    setField(varied, key, value);
    const Found& found = segmenter.make(varied);
    phis.push_back(found.phi.get());
    figure.panels.push_back(found.panel);
    figure.panels.back().title = formatted("%s = %g", name.c_str(), value);
  }
  figure.picture = projectionRows(segmenter.preprocessed(), phis);
  return figure;
}

}  // namespace

const std::vector<std::string>& segmentationFigureNumbers() {
  static const std::vector<std::string> numbers{"3.3", "5.2", "A.1", "A.2", "A.3"};
  return numbers;
}

std::vector<SegmentationFigure> segmentationFigures(const Volume<float>& image,
                                                    const Volume<std::uint8_t>* truth,
                                                    const Parameters& params,
                                                    const Progress& progress) {
  Segmenter segmenter(image, truth, progress);
  std::vector<SegmentationFigure> figures;
  figures.push_back(measures(segmenter, params));
  figures.push_back(methods(segmenter, params));
  figures.push_back(
      parameterRow(segmenter, params, "A.1", "gamma", "levelset.gamma", {0.6, 0.7, 0.8}));
  figures.push_back(parameterRow(segmenter, params, "A.2", "d", "levelset.d", {0.0, 0.2, 0.4}));
  figures.push_back(
      parameterRow(segmenter, params, "A.3", "xi", "levelset.xi", {10.0, 20.0, 40.0}));
  return figures;
}

}  // namespace angiomesh::cli
