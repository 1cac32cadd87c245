// SPDX-License-Identifier: BSD-3-Clause
#include "bench/itk_fronts.h"

#include <itkLevelSetFunction.h>
#include <itkLinearInterpolateImageFunction.h>
#include <itkParallelSparseFieldLevelSetImageFilter.h>
#include <itkSparseFieldLevelSetImageFilter.h>

#include <cmath>
#include <vector>

#include "bench/itk_volume.h"

namespace angiomesh::bench {
namespace {

/// F of eq. 3.19: gamma p as ITK's propagation, (1 - gamma) |d kappa| as its curvature term,
/// upwinded as the expansion that it is.
class ThesisSpeed : public itk::LevelSetFunction<ItkImage> {
 public:
  using Self = ThesisSpeed;
  using Superclass = itk::LevelSetFunction<ItkImage>;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self) itkTypeMacro(ThesisSpeed, LevelSetFunction);

  void prepare(ItkImage* vesselness, const Thresholds& thresholds, const LevelSetParams& params) {
    RadiusType radius;
    radius.Fill(1);
    Initialize(radius);
    SetPropagationWeight(1.0);
    SetCurvatureWeight(1.0);
    interpolator_ = Interpolator::New();
    interpolator_->SetInputImage(vesselness);
    thresholds_ = thresholds;
    gamma_ = params.gamma;
    d_ = params.d;
    acrossCrests_ = params.acrossCrests;
  }

  PixelType ComputeUpdate(const NeighborhoodType& at, void* globals,
                          const FloatOffsetType& offset) override {
    const PixelType upwind = Superclass::ComputeUpdate(at, globals, offset);
    if (!acrossCrests_) return upwind;
    auto* data = static_cast<GlobalDataStruct*>(globals);
    double expanding = 0.0;
    double shrinking = 0.0;
    for (unsigned int a = 0; a < 3; ++a) {
      const auto backward = static_cast<double>(data->m_dx_backward[a]);
      const auto forward = static_cast<double>(data->m_dx_forward[a]);
      expanding += std::pow(std::max(backward, 0.0), 2) + std::pow(std::min(forward, 0.0), 2);
      shrinking += std::pow(std::min(backward, 0.0), 2) + std::pow(std::max(forward, 0.0), 2);
    }
    const double grow = std::sqrt(std::max(expanding, std::min(shrinking, 1.0)));
    const double shrink = std::sqrt(std::max(shrinking, std::min(expanding, 1.0)));
    const auto p = static_cast<double>(PropagationSpeed(at, offset, data));
    const double bend = (1.0 - gamma_) * std::fabs(d_) * kappa(at, offset, data);
    return static_cast<PixelType>(-(p * (p > 0.0 ? grow : shrink) + bend * grow));
  }

 protected:
  ScalarValueType PropagationSpeed(const NeighborhoodType& at, const FloatOffsetType& offset,
                                   GlobalDataStruct* /*data*/) const override {
    const auto index = at.GetIndex();
    Interpolator::ContinuousIndexType crossing;
    for (unsigned int a = 0; a < 3; ++a)
      crossing[a] = static_cast<double>(index[a]) - static_cast<double>(offset[a]);
    const double v = interpolator_->IsInsideBuffer(crossing)
                         ? interpolator_->EvaluateAtContinuousIndex(crossing)
                         : interpolator_->EvaluateAtIndex(index);
    return static_cast<ScalarValueType>(gamma_ * vesselSpeed(v, thresholds_));
  }

  ScalarValueType ComputeCurvatureTerm(const NeighborhoodType& at, const FloatOffsetType& offset,
                                       GlobalDataStruct* data) override {
    double square = 0.0;
    for (unsigned int a = 0; a < 3; ++a) {
      const double up = std::max(static_cast<double>(data->m_dx_backward[a]), 0.0);
      const double down = std::min(static_cast<double>(data->m_dx_forward[a]), 0.0);
      square += up * up + down * down;
    }
    return static_cast<ScalarValueType>(-(1.0 - gamma_) * std::fabs(d_) * kappa(at, offset, data) *
                                        std::sqrt(square));
  }

 private:
  /// |kappa|, at most 2. ITK's term is kappa |grad phi| by central differences.
  double kappa(const NeighborhoodType& at, const FloatOffsetType& offset, GlobalDataStruct* data) {
    const double slope = std::sqrt(static_cast<double>(data->m_GradMagSqr));
    const auto bend = static_cast<double>(ComputeMeanCurvature(at, offset, data));
    return std::min(std::fabs(bend) / slope, 2.0);
  }

  using Interpolator = itk::LinearInterpolateImageFunction<ItkImage, double>;
  Interpolator::Pointer interpolator_;
  Thresholds thresholds_;
  double gamma_ = 0.7, d_ = 0.2;
  bool acrossCrests_ = false;
};

/// The rule of LevelSetEvolution on phi as it stands.
class Convergence {
 public:
  void start(const LevelSetParams& params) { params_ = params; }

  bool stops(const ItkImage& phi, int iterations) {
    const std::size_t count = phi.GetPixelContainer()->Size();
    const float* now = phi.GetBufferPointer();
    if (checkpoint_.empty()) checkpoint_.assign(now, now + count);
    iterations_ = iterations;
    if (iterations > 0 && iterations % params_.checkEvery == 0) check(now, count);
    if (stop_ == StopReason::Running && iterations >= params_.maxIterations)
      stop_ = StopReason::Limit;
    return stop_ != StopReason::Running;
  }

  [[nodiscard]] int iterations() const { return iterations_; }
  [[nodiscard]] StopReason reason() const { return stop_; }

 private:
  void check(const float* now, std::size_t count) {
    double sum = 0.0;
    std::size_t inside = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += std::fabs(static_cast<double>(now[i]) - static_cast<double>(checkpoint_[i]));
      inside += now[i] < 0.0F ? 1 : 0;
    }
    const double previous = change_;
    change_ = sum / static_cast<double>(std::max<std::size_t>(inside, 1));
    checkpoint_.assign(now, now + count);
    if (previous < 0.0) return;
    const double delta = std::fabs(change_ - previous);
    steady_ = delta < params_.toleranceDelta ? steady_ + 1 : 0;
    if (change_ < params_.tolerance && delta < params_.toleranceDelta)
      stop_ = StopReason::Converged;
    else if (steady_ >= 3)
      stop_ = StopReason::Settled;
  }

  LevelSetParams params_;
  std::vector<float> checkpoint_;
  double change_ = -1.0;
  int steady_ = 0, iterations_ = 0;
  StopReason stop_ = StopReason::Running;
};

/// One of ITK's solvers, stopped by Convergence.
template <class Base>
class Solver : public Base {
 public:
  using Self = Solver;
  using Superclass = Base;
  using Pointer = itk::SmartPointer<Self>;
  itkNewMacro(Self) itkTypeMacro(Solver, ProcessObject);

  Convergence convergence;

 protected:
  bool Halt() override {
    return convergence.stops(*this->GetOutput(), static_cast<int>(this->GetElapsedIterations()));
  }
};

template <class Base>
ItkFront run(ThesisSpeed* speed, ItkImage* phi0, const Geometry& geometry,
             const LevelSetParams& params) {
  const auto solver = Solver<Base>::New();
  solver->convergence.start(params);
  solver->SetDifferenceFunction(speed);
  solver->SetInput(phi0);
  solver->SetNumberOfLayers(2);
  solver->SetIsoSurfaceValue(0.0F);
  solver->Update();
  return {fromItk(*solver->GetOutput(), geometry), solver->convergence.iterations(),
          solver->convergence.reason()};
}

}  // namespace

ItkFront evolveItk(const Volume<float>& vesselness, const Thresholds& thresholds,
                   const Volume<float>& phi0, const LevelSetParams& params, ItkSolver solver) {
  const ItkImage::Pointer v = asItk(vesselness);
  const ItkImage::Pointer start = asItk(phi0);
  const auto speed = ThesisSpeed::New();
  speed->prepare(v, thresholds, params);
  if (solver == ItkSolver::Serial)
    return run<itk::SparseFieldLevelSetImageFilter<ItkImage, ItkImage>>(speed, start, phi0.geometry,
                                                                        params);
  return run<itk::ParallelSparseFieldLevelSetImageFilter<ItkImage, ItkImage>>(
      speed, start, phi0.geometry, params);
}

}  // namespace angiomesh::bench
