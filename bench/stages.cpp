// SPDX-License-Identifier: BSD-3-Clause
#include "bench/stages.h"

#include <itkCurvatureFlowImageFilter.h>
#include <itkFastChamferDistanceImageFilter.h>
#include <itkReinitializeLevelSetImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <memory>

#include "bench/itk_fronts.h"
#include "bench/itk_hessian.h"
#include "bench/itk_volume.h"
#include "bench/printed_method.h"
#include "core/base/formatted.h"
#include "core/distance/redistance.h"
#include "core/levelset/flood.h"
#include "core/lumen/lumen.h"
#include "core/phantom/phantom.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/vesselness_step.h"
#include "core/preprocess/curvature_flow.h"

namespace angiomesh::bench {
namespace {

struct Bed {
  Parameters params, thesis;
  std::shared_ptr<const Volume<float>> image, vesselness;
  double c = 0.0;
  Thresholds thresholds;
  std::vector<Eigen::Vector3d> seedsLps;
  Volume<float> seedStart;  ///< signed distance to the spheres around the seeds
  Volume<float> rough;      ///< a sparse field's phi, to be redistanced
};

int flooded(const Bed& bed, Volume<float>* phi = nullptr) {
  const LevelSetParams& p = bed.params.levelset;
  const Volume<std::uint8_t> found =
      floodVessels(*bed.vesselness, bed.thresholds.b, bed.seedsLps, bed.params.seeds.radiusVoxels,
                   static_cast<std::size_t>(p.floodLeastVoxels));
  LevelSetEvolution evolution(bed.vesselness, bed.thresholds,
                              floodStart(*bed.vesselness, bed.thresholds.b, found), p);
  evolution.step(p.maxIterations);
  if (phi) *phi = evolution.phi();
  return evolution.iterations();
}

std::shared_ptr<const Bed> makeBed(int size, double noise) {
  PhantomParams phantom;
  phantom.psf.kind = PointSpread::Kind::Subvoxels;
  phantom.size = {size, size, size};
  phantom.noiseSigma = noise;
  const auto bed = std::make_shared<Bed>();
  bed->params = preset("angiomesh");
  bed->thesis = preset("thesis");
  Pipeline pipeline(makeSource(makePhantom(phantom).image, "tree"));
  RunOptions until;
  until.until = Step::Seeds;
  const RunResult run = pipeline.run(bed->params, until);
  bed->image = run.preprocessed;
  bed->vesselness = run.vesselness->multiScale;
  bed->c = run.vesselness->c;
  bed->thresholds = thresholdsFor(*run.vesselness, bed->params.thresholds);
  bed->seedsLps = run.seeds->pointsLps;
  bed->seedStart =
      fastMarchingStart(bed->image->geometry, run.seeds->pointsLps, bed->params.seeds.radiusVoxels);
  flooded(*bed, &bed->rough);
  return bed;
}

using BedPointer = std::shared_ptr<const Bed>;

PlainImage plain(const Volume<float>& image) {
  return {image.voxels.data(), image.geometry.size, {1.0, 1.0, 1.0}};
}

Stage vesselnessStage(const BedPointer& bed, double sigma) {
  return {formatted("vesselness, sigma %g", sigma),
          {{"ours",
            [bed, sigma] {
              vesselnessAtScale(*bed->image, sigma, bed->params.vesselness, bed->c);
              return 0;
            }},
           {"ITK MultiScaleHessianBasedMeasure", [bed, sigma] {
              itkObjectness(plain(*bed->image), sigma, bed->c);
              return 0;
            }}}};
}

/// From the seeds, the rule of convergence is the thesis's: that of the default preset is made for
/// a front that only has to settle.
Stage evolutionStage(const BedPointer& bed) {
  const auto itk = [bed](ItkSolver solver) {
    return evolveItk(*bed->vesselness, bed->thresholds, bed->seedStart, bed->thesis.levelset,
                     solver)
        .iterations;
  };
  return {"evolution",
          {{"ours, from the flood", [bed] { return flooded(*bed); }},
           {"ours, from the seeds",
            [bed] {
              LevelSetEvolution evolution(bed->vesselness, bed->thresholds, bed->seedStart,
                                          bed->thesis.levelset);
              evolution.step(bed->thesis.levelset.maxIterations);
              return evolution.iterations();
            }},
           {"ITK ParallelSparseField", [itk] { return itk(ItkSolver::Parallel); }},
           {"ITK SparseField", [itk] { return itk(ItkSolver::Serial); }}}};
}

Stage curvatureFlowStage(const BedPointer& bed) {
  constexpr int iterations = 5;
  constexpr double timeStep = 0.0625;
  return {"curvature flow, 5 iterations",
          {{"ours, which wraps ITK's filter",
            [bed] {
              curvatureFlow(*bed->image, iterations, timeStep);
              return 0;
            }},
           {"ITK CurvatureFlow", [bed] {
              const auto filter = itk::CurvatureFlowImageFilter<ItkImage, ItkImage>::New();
              filter->SetInput(asItk(*bed->image));
              filter->SetNumberOfIterations(iterations);
              filter->SetTimeStep(timeStep);
              filter->Update();
              return 0;
            }}}};
}

int maurer(const Volume<float>& phi) {
  using Mask = itk::Image<unsigned char, 3>;
  const auto mask = Mask::New();
  mask->SetRegions(asItk(phi)->GetBufferedRegion());
  mask->Allocate();
  unsigned char* out = mask->GetBufferPointer();
  for (std::size_t i = 0; i < phi.voxels.size(); ++i) out[i] = phi.voxels[i] < 0.0F ? 1 : 0;
  const auto filter = itk::SignedMaurerDistanceMapImageFilter<Mask, ItkImage>::New();
  filter->SetInput(mask);
  filter->SetSquaredDistance(false);
  filter->Update();
  return 0;
}

Stage redistanceStage(const BedPointer& bed) {
  constexpr double band = 5.0;
  return {"redistance",
          {{"ours",
            [bed] {
              redistance(bed->rough, band);
              return 0;
            }},
           {"ITK SignedMaurerDistanceMap (of the mask)", [bed] { return maurer(bed->rough); }},
           {"ITK FastChamferDistance",
            [bed] {
              const auto filter = itk::FastChamferDistanceImageFilter<ItkImage, ItkImage>::New();
              filter->SetInput(asItk(bed->rough));
              filter->SetMaximumDistance(band);
              filter->Update();
              return 0;
            }},
           {"ITK ReinitializeLevelSet", [bed] {
              const auto filter = itk::ReinitializeLevelSetImageFilter<ItkImage>::New();
              filter->SetInput(asItk(bed->rough));
              filter->Update();
              return 0;
            }}}};
}

Stage wholeStage(const BedPointer& bed) {
  return {"image to mask",
          {{"ours",
            [bed] {
              Pipeline pipeline(makeSource(*bed->image, "tree"));
              RunOptions until;
              until.until = Step::Evolve;
              insideMask(*pipeline.run(bed->params, until).evolve->phi);
              return 0;
            }},
           {"ITK, recursive Hessian to parallel sparse field", [bed] {
              insideMask(printedMethod(*bed->image, bed->thesis, ItkHessian::Recursive,
                                       ItkSolver::Parallel)
                             .front.phi);
              return 0;
            }}}};
}

}  // namespace

std::vector<Stage> segmentationStages(int size, double noise) {
  const BedPointer bed = makeBed(size, noise);
  std::vector<Stage> stages;
  for (const double sigma : {1.0, 2.0, 4.0, 6.0}) stages.push_back(vesselnessStage(bed, sigma));
  stages.push_back(evolutionStage(bed));
  stages.push_back(curvatureFlowStage(bed));
  stages.push_back(redistanceStage(bed));
  stages.push_back(wholeStage(bed));
  return stages;
}

}  // namespace angiomesh::bench
