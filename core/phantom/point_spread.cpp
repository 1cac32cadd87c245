// SPDX-License-Identifier: BSD-3-Clause
#include "core/phantom/point_spread.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/base/error.h"
#include "core/base/exact_math.h"
#include "core/base/formatted.h"
#include "core/base/parallel.h"

namespace angiomesh {
namespace {

constexpr double kLargestSigma = 4.0, kLargestZeroFilling = 4.0;
constexpr double kNoBlur = 0.02;  // voxels: such a Gaussian changes no value by 0.1 %
constexpr double kBoxWidth = 0.28867513459481287;  // standard deviation of a box of length 1
constexpr double kLeastWide = 0.25;
constexpr double kTails = 4.0;     // standard deviations that a Gaussian reaches
constexpr int kMrReach = 8;        // acquired voxels; h is 0 there, and below 0.001 beyond
constexpr int kBoxIntervals = 96;  // of Simpson's rule over a voxel

double gaussian(double x, double sigma) {
  const double t = x / sigma;
  return portableExp(-0.5 * t * t) / (sigma * std::sqrt(2.0 * std::numbers::pi));
}

/// A voxel's box blurred by a Gaussian, at x voxels from its centre.
double blurredBox(double x, double sigma) {
  if (sigma < kNoBlur) return std::fabs(x) < 0.5 ? 1.0 : 0.0;
  double sum = 0.0;
  for (int i = 0; i <= kBoxIntervals; ++i) {
    const double weight = i == 0 || i == kBoxIntervals ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * gaussian(x - 0.5 + static_cast<double>(i) / kBoxIntervals, sigma);
  }
  return sum / (3.0 * kBoxIntervals);
}

double sinc(double x) {
  if (std::fabs(x) < 1e-9) return 1.0;
  return portableSinTurns(0.5 * x) / (std::numbers::pi * x);
}

double hammingResponse(double x) { return 0.54 * sinc(x) + 0.23 * (sinc(x - 1.0) + sinc(x + 1.0)); }

/// The number after the colon.
double numberOf(const std::string& text, std::size_t colon) {
  double value = 0.0;
  const char* first = text.data() + colon + 1;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc() || end != last || first == last)
    throw InputError("'" + text + "' has no usable number after the colon", "phantom point spread",
                     "write for example gaussian:0.5 or mr:2");
  return value;
}

}  // namespace

void checkPointSpread(const PointSpread& psf) {
  if (!(psf.sigma >= 0.0 && psf.sigma <= kLargestSigma))
    throw InputError("the point spread's standard deviation is not usable", "phantom point spread",
                     "give 0 to 4 voxels");
  if (!(psf.zeroFilling >= 1.0 && psf.zeroFilling <= kLargestZeroFilling))
    throw InputError("the zero filling is not usable", "phantom point spread",
                     "give 1 (none) to 4");
}

PointSpread pointSpreadFromText(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string word = text.substr(0, colon);
  PointSpread psf;
  if (word == "gaussian") {
    if (colon != std::string::npos) psf.sigma = numberOf(text, colon);
  } else if (word == "mr") {
    psf.kind = PointSpread::Kind::Mr;
    if (colon != std::string::npos) psf.zeroFilling = numberOf(text, colon);
  } else if (text == "subvoxels") {
    psf.kind = PointSpread::Kind::Subvoxels;
  } else {
    throw InputError("there is no point spread '" + text + "'", "phantom point spread",
                     "give gaussian, gaussian:SIGMA, mr, mr:ZEROFILLING or subvoxels");
  }
  checkPointSpread(psf);
  return psf;
}

std::string pointSpreadText(const PointSpread& psf) {
  switch (psf.kind) {
    case PointSpread::Kind::Gaussian:
      return "gaussian:" + shortestText(psf.sigma);
    case PointSpread::Kind::Mr:
      return psf.zeroFilling == 1.0 ? "mr" : "mr:" + shortestText(psf.zeroFilling);
    case PointSpread::Kind::Subvoxels:
      break;
  }
  return "subvoxels";
}

bool isWide(const PointSpread& psf, const Geometry& grid) {
  return psf.kind == PointSpread::Kind::Mr ||
         psf.sigma * grid.voxelMm() >= kLeastWide * grid.spacing.maxCoeff();
}

AxisKernel axisKernel(const PointSpread& psf, double sigmaVoxels, int cells, double cellWidth) {
  const bool mr = psf.kind == PointSpread::Kind::Mr;
  const double sigma = std::sqrt(std::max(sigmaVoxels * sigmaVoxels - cellWidth * cellWidth, 0.0));
  const double zero = psf.zeroFilling;
  AxisKernel kernel;
  kernel.cells = cells;
  kernel.reach = mr                      ? static_cast<int>(std::ceil(kMrReach * zero))
                 : sigmaVoxels < kNoBlur ? 0
                                         : static_cast<int>(std::ceil(kTails * sigmaVoxels + 0.5));
  double sum = 0.0;
  for (int cell = 0; cell < cells; ++cell)
    for (int shift = -kernel.reach; shift <= kernel.reach; ++shift) {
      const double x = shift - ((cell + 0.5) / cells - 0.5);
      double value = 0.0;
      if (!mr)
        value = blurredBox(x, sigma);
      else if (std::fabs(x) < kMrReach * zero)
        value = hammingResponse(x / zero);
      kernel.weights.push_back(value);
      sum += value;
    }
  for (double& weight : kernel.weights) weight /= sum;
  return kernel;
}

void blurVoxels(Volume<float>& image, const PointSpread& psf, const Progress& progress) {
  if (psf.kind == PointSpread::Kind::Subvoxels) return;
  const Geometry& g = image.geometry;
  const std::array<std::size_t, 3> strides{
      1, static_cast<std::size_t>(g.size[0]),
      static_cast<std::size_t>(g.size[0]) * static_cast<std::size_t>(g.size[1])};
  for (int axis = 0; axis < 3; ++axis) {
    const AxisKernel kernel =
        axisKernel(psf, psf.sigma * g.voxelMm() / g.spacing[axis], 1, kBoxWidth);
    const auto a = static_cast<std::size_t>(axis);
    const int length = g.size[a];
    const std::size_t stride = strides[a];
    const std::size_t rows = image.voxels.size() / static_cast<std::size_t>(length);
    parallelFor(0, rows, 256, [&](std::size_t first, std::size_t last) {
      progress.check();
      std::vector<double> row(static_cast<std::size_t>(length));
      for (std::size_t n = first; n < last; ++n) {
        float* start = image.voxels.data() + n % stride +
                       n / stride * stride * static_cast<std::size_t>(length);
        for (int i = 0; i < length; ++i)
          row[static_cast<std::size_t>(i)] = start[static_cast<std::size_t>(i) * stride];
        for (int i = 0; i < length; ++i) {
          double sum = 0.0;
          for (int shift = -kernel.reach; shift <= kernel.reach; ++shift)
            sum += kernel.weights[static_cast<std::size_t>(shift + kernel.reach)] *
                   row[static_cast<std::size_t>(std::clamp(i - shift, 0, length - 1))];
          start[static_cast<std::size_t>(i) * stride] = static_cast<float>(sum);
        }
      }
    });
  }
}

}  // namespace angiomesh
