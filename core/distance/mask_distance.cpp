// SPDX-License-Identifier: BSD-3-Clause
#include "core/distance/mask_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/distance/cell_band.h"
#include "core/distance/redistance.h"
#include "core/field/spline_field.h"

namespace angiomesh {
namespace {

constexpr int kLayers = 3;                    // of the band around the voxels at the surface
constexpr std::size_t kGrain = 4096;          // cells
constexpr float kLeast = 0.02F;               // voxels that every centre keeps from the surface
constexpr float kReach = 2.5F;                // voxels beyond which phi is not needed
constexpr int kRounds = 2, kSmoothings = 30;  // smoothings before each correction of the volume
constexpr int kCorrections = 3;               // at the end, without smoothing
constexpr double kClamp = 5.0;                // working voxels, of the result
constexpr int kWindow = 10;                   // passes of [1 2 1]/4: a standard deviation of 2.2
constexpr float kLeastArea = 1e-4F;           // of a window that holds some surface
constexpr float kMostShift = 0.3F;            // voxels, in one correction

using Cells = std::vector<float>;

/// Calls body(cell) for all cells, in parallel.
template <class Body>
void forCells(const CellBand& band, const Progress& progress, const Body& body) {
  parallelForEach(band.size(), kGrain, progress, [&](std::size_t cell) { body(cell); });
}

/// A band with the mean [1 2 1]/4 along each axis.
class Lattice {
 public:
  Lattice(const Volume<std::uint8_t>& mask, const Progress& progress);

  [[nodiscard]] const CellBand& band() const { return band_; }
  [[nodiscard]] bool inside(std::size_t cell) const { return inside_[cell] != 0; }

  /// f less its mean; 0 where a neighbour is missing.
  [[nodiscard]] float bend(const Cells& f, std::size_t cell) const {
    return whole_[cell] != 0 ? f[cell] - mean(f, cell) : 0.0F;
  }
  /// f less its mean, where what is missing counts as 0: the transpose of bend().
  [[nodiscard]] float unbend(const Cells& f, std::size_t cell) const {
    return f[cell] - (whole_[cell] != 0 ? mean(f, cell) : partial(f, cell, false));
  }
  /// The mean that keeps the sum over all cells: what would leave the band stays.
  [[nodiscard]] float spread(const Cells& f, std::size_t cell) const {
    return whole_[cell] != 0 ? mean(f, cell) : partial(f, cell, true);
  }
  /// A cell in the outermost layer of the volume, with the two behind it in the band.
  struct Outermost {
    std::uint32_t cell, next, second;
  };
  [[nodiscard]] const std::vector<Outermost>& outermost() const { return outermost_; }

 private:
  /// Of the nine rows along x around a cell: [1 2 1] x [1 2 1] / 64.
  static constexpr std::array<float, 9> kRow{1 / 64.0F, 2 / 64.0F, 1 / 64.0F, 2 / 64.0F, 4 / 64.0F,
                                             2 / 64.0F, 1 / 64.0F, 2 / 64.0F, 1 / 64.0F};

  /// Around a cell with all its neighbours.
  [[nodiscard]] float mean(const Cells& f, std::size_t cell) const {
    float sum = 0.0F;
    for (std::size_t row = 0; row < 9; ++row) {
      const float* v = f.data() + band_.run(cell, row).first;
      sum += kRow[row] * (v[0] + 2.0F * v[1] + v[2]);
    }
    return sum;
  }
  [[nodiscard]] float partial(const Cells& f, std::size_t cell, bool itself) const;
  void findOutermost();

  CellBand band_;
  std::vector<std::uint8_t> inside_, whole_;
  std::vector<Outermost> outermost_;
};

/// The mean where missing cells count as the cell itself or as 0.
float Lattice::partial(const Cells& f, std::size_t cell, bool itself) const {
  float sum = f[cell] / 8.0F;
  for (std::size_t k = 0; k < 26; ++k) {
    // Faces, edges, corners.
    const float weight = k < 6 ? 1 / 16.0F : k < 18 ? 1 / 32.0F : 1 / 64.0F;
    const std::uint32_t next = band_.neighbour(cell, k);
    if (next != CellBand::none)
      sum += weight * f[next];
    else if (itself)
      sum += weight * f[cell];
  }
  return sum;
}

/// Voxels with a face neighbour of the other kind.
Volume<std::uint8_t> surfaceVoxels(const Volume<std::uint8_t>& mask) {
  const Geometry& g = mask.geometry;
  Volume<std::uint8_t> surface(g);
  const std::array<std::size_t, 3> stride{1, g.offset(0, 1, 0), g.offset(0, 0, 1)};
  parallelFor(0, static_cast<std::size_t>(g.size[2]), 1, [&](std::size_t slice, std::size_t) {
    const int k = static_cast<int>(slice);
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Index3 p{i, j, k};
        const std::size_t at = g.offset(i, j, k);
        const bool in = mask.voxels[at] != 0;
        bool found = false;
        for (std::size_t a = 0; a < 3 && !found; ++a)
          found = (p[a] > 0 && (mask.voxels[at - stride[a]] != 0) != in) ||
                  (p[a] + 1 < g.size[a] && (mask.voxels[at + stride[a]] != 0) != in);
        surface.voxels[at] = found ? 1 : 0;
      }
  });
  return surface;
}

Lattice::Lattice(const Volume<std::uint8_t>& mask, const Progress& progress)
    : band_(bandAround(surfaceVoxels(mask), kLayers, progress)),
      inside_(band_.size()),
      whole_(band_.size()) {
  forCells(band_, progress, [&](std::size_t cell) {
    inside_[cell] = mask.voxels[band_.voxel[cell]] != 0 ? 1 : 0;
    bool all = true;
    for (std::size_t row = 0; row < 9; ++row) all = all && band_.run(cell, row).count == 3;
    whole_[cell] = all ? 1 : 0;
  });
  findOutermost();
}

void Lattice::findOutermost() {
  const Index3& size = band_.geometry.size;
  for (std::size_t cell = 0; cell < band_.size(); ++cell) {
    const Index3 p = band_.geometry.indexOf(band_.voxel[cell]);
    Index3 inwards{0, 0, 0};
    for (std::size_t a = 0; a < 3; ++a) inwards[a] = p[a] == 0 ? 1 : p[a] + 1 == size[a] ? -1 : 0;
    for (std::size_t k = 0; k < 26; ++k) {
      if (CellBand::kOffsets[k] != inwards) continue;
      const std::uint32_t next = band_.neighbour(cell, k);
      const std::uint32_t second =
          next == CellBand::none ? CellBand::none : band_.neighbour(next, k);
      if (second != CellBand::none)
        outermost_.push_back({static_cast<std::uint32_t>(cell), next, second});
    }
  }
}

/// The distance in voxels from each cell's centre to the nearest one of the other kind, found from
/// neighbour to neighbour: exact near the surface, where it matters.
Cells distancesToOthers(const Lattice& lattice, const Progress& progress) {
  const CellBand& band = lattice.band();
  struct Way {
    std::array<std::int8_t, 3> to{};
    bool known = false;
    [[nodiscard]] int square() const { return to[0] * to[0] + to[1] * to[1] + to[2] * to[2]; }
  };
  std::vector<Way> ways(band.size());
  std::vector<Way> next(band.size());
  for (int pass = 0; pass < kLayers + 3; ++pass) {
    forCells(band, progress, [&](std::size_t cell) {
      Way best = ways[cell];
      for (std::size_t k = 0; k < 26; ++k) {
        const std::uint32_t n = band.neighbour(cell, k);
        if (n == CellBand::none) continue;
        const Index3& d = CellBand::kOffsets[k];
        Way way;
        if (lattice.inside(n) == lattice.inside(cell)) {
          way = ways[n];
          if (!way.known) continue;
        }
        for (std::size_t a = 0; a < 3; ++a) way.to[a] = static_cast<std::int8_t>(way.to[a] + d[a]);
        way.known = true;
        if (!best.known || way.square() < best.square()) best = way;
      }
      next[cell] = best;
    });
    ways.swap(next);
  }
  Cells distance(band.size(), kReach + 1.0F);
  forCells(band, progress, [&](std::size_t cell) {
    if (ways[cell].known) distance[cell] = std::sqrt(static_cast<float>(ways[cell].square()));
  });
  return distance;
}

/// The part of a voxel, centred where a linear function takes `value`, that lies below 0; `slope`
/// are the magnitudes of its gradient.
double partBelow(double value, std::array<double, 3> slope) {
  const double sum = slope[0] + slope[1] + slope[2];
  if (!(sum > 1e-6)) return value < 0.0 ? 1.0 : 0.0;
  for (double& s : slope) s = std::max(s, 1e-3 * sum);
  const auto cube = [](double x) { return x > 0.0 ? x * x * x : 0.0; };
  const auto [a, b, c] = slope;
  // From the corner that is lowest: a tetrahedron less what sticks out of the voxel.
  const double d = 0.5 * (a + b + c) - value;
  const double volume = cube(d) - cube(d - a) - cube(d - b) - cube(d - c) + cube(d - a - b) +
                        cube(d - a - c) + cube(d - b - c) - cube(d - a - b - c);
  return std::clamp(volume / (6.0 * a * b * c), 0.0, 1.0);
}

/// How much of a voxel is inside, and how fast that changes when the field does.
struct Filling {
  double part = 0.0, rate = 0.0;
};

Filling fillingOf(double mean, const std::array<double, 3>& slope) {
  constexpr double kStep = 0.05;
  return {partBelow(mean, slope),
          (partBelow(mean - kStep, slope) - partBelow(mean + kStep, slope)) / (2.0 * kStep)};
}

/// phi in voxels between its bounds.
class BoundedField {
 public:
  BoundedField(const Volume<std::uint8_t>& mask, const Progress& progress)
      : lattice_(mask, progress), distance_(distancesToOthers(lattice_, progress)) {
    phi_.resize(distance_.size());
    forCells(lattice_.band(), progress, [&](std::size_t cell) {
      const float away = std::min(distance_[cell] - 0.5F, kReach);
      phi_[cell] = lattice_.inside(cell) ? -away : away;
    });
  }

  void smooth(int iterations, const Progress& progress);
  void roughlyCorrectVolume(const Progress& progress) {
    shiftBy([&](std::size_t cell) { return roughly(cell); }, progress);
  }
  /// `field` interpolates phi.
  void correctVolume(const SplineField& field, const Progress& progress) {
    shiftBy([&](std::size_t cell) { return closely(cell, field); }, progress);
  }
  [[nodiscard]] Volume<float> volume(const Volume<std::uint8_t>& mask) const;
  /// Goes on with a distance in working voxels; writes it back.
  void take(const Volume<float>& distance);
  void giveTo(Volume<float>& distance) const;

 private:
  [[nodiscard]] float bounded(std::size_t cell, float value) const {
    if (measured_)
      return lattice_.inside(cell) ? std::min(value, -kLeast) : std::max(value, kLeast);
    const float most = std::min(distance_[cell], kReach);
    // A plane passes one voxel and its diagonal neighbour at distances that differ by one at most.
    const float least = std::min(std::max(distance_[cell] - 1.0F, kLeast), most);
    return lattice_.inside(cell) ? -std::clamp(-value, least, most)
                                 : std::clamp(value, least, most);
  }
  void spread(Cells& f, const Progress& progress) const;
  template <class FillingOf>
  void shiftBy(const FillingOf& fillingAt, const Progress& progress);
  [[nodiscard]] Filling roughly(std::size_t cell) const;
  [[nodiscard]] Filling closely(std::size_t cell, const SplineField& field) const;
  [[nodiscard]] double laplacian(std::size_t cell) const;
  /// Continues the field straight on to the volume's border, where nothing else makes it smooth.
  void extrapolate(Cells& f) const {
    for (const Lattice::Outermost& o : lattice_.outermost())
      f[o.cell] = bounded(o.cell, 2.0F * f[o.next] - f[o.second]);
  }

  Lattice lattice_;
  Cells distance_;  ///< to the nearest centre of the other kind
  Cells phi_;
  bool measured_ = false;  ///< phi_ is a distance by now
};

/// Descends on |phi - mean(phi)|^2 over the whole cells, with Nesterov's momentum: the operator's
/// eigenvalues are at most 1, and so is the step.
void BoundedField::smooth(int iterations, const Progress& progress) {
  const CellBand& band = lattice_.band();
  Cells ahead = phi_, bend(band.size()), before = phi_;
  for (int n = 0; n < iterations; ++n) {
    extrapolate(ahead);
    forCells(band, progress, [&](std::size_t cell) { bend[cell] = lattice_.bend(ahead, cell); });
    const float momentum = static_cast<float>(n) / static_cast<float>(n + 3);
    before.swap(phi_);
    forCells(band, progress, [&](std::size_t cell) {
      phi_[cell] = bounded(cell, ahead[cell] - lattice_.unbend(bend, cell));
    });
    forCells(band, progress, [&](std::size_t cell) {
      ahead[cell] = phi_[cell] + momentum * (phi_[cell] - before[cell]);
    });
  }
  extrapolate(phi_);
}

/// Sum-keeping passes of [1 2 1]/4.
void BoundedField::spread(Cells& f, const Progress& progress) const {
  Cells next(f.size());
  for (int pass = 0; pass < kWindow; ++pass) {
    forCells(lattice_.band(), progress,
             [&](std::size_t cell) { next[cell] = lattice_.spread(f, cell); });
    f.swap(next);
  }
}

/// From differences between voxels.
Filling BoundedField::roughly(std::size_t cell) const {
  const CellBand& band = lattice_.band();
  std::array<double, 3> slope{};
  const auto value = static_cast<double>(phi_[cell]);
  for (std::size_t a = 0; a < 3; ++a) {
    const std::uint32_t low = band.neighbour(cell, 2 * a), high = band.neighbour(cell, 2 * a + 1);
    const double below = low == CellBand::none ? value : static_cast<double>(phi_[low]);
    const double above = high == CellBand::none ? value : static_cast<double>(phi_[high]);
    slope[a] =
        std::fabs(above - below) / (low != CellBand::none && high != CellBand::none ? 2.0 : 1.0);
  }
  return fillingOf(value + laplacian(cell) / 24.0, slope);
}

/// From the eighths of the voxel, of the spline that is meshed in the end.
Filling BoundedField::closely(std::size_t cell, const SplineField& field) const {
  const Index3 p = lattice_.band().geometry.indexOf(lattice_.band().voxel[cell]);
  // The mean over a cube of side h differs from the value in its middle by h^2 / 24 Laplacians.
  const double curved = laplacian(cell) / 96.0;
  Filling sum;
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d at(p[0] + 0.5 * (n & 1) - 0.25, p[1] + 0.5 * (n >> 1 & 1) - 0.25,
                             p[2] + 0.5 * (n >> 2) - 0.25);
    const SplineField::Jet jet = field.atIndex(at);
    const Filling part = fillingOf(
        jet.value + curved, {0.5 * std::fabs(jet.gradient[0]), 0.5 * std::fabs(jet.gradient[1]),
                             0.5 * std::fabs(jet.gradient[2])});
    sum.part += part.part / 8.0;
    sum.rate += part.rate / 8.0;
  }
  return sum;
}

double BoundedField::laplacian(std::size_t cell) const {
  const CellBand& band = lattice_.band();
  double sum = 0.0;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::uint32_t low = band.neighbour(cell, 2 * a), high = band.neighbour(cell, 2 * a + 1);
    if (low != CellBand::none && high != CellBand::none)
      sum += static_cast<double>(phi_[low] - 2.0F * phi_[cell] + phi_[high]);
  }
  return sum;
}

/// Moves the surface by the volume that is missing around each place over the area there.
template <class FillingOf>
void BoundedField::shiftBy(const FillingOf& fillingAt, const Progress& progress) {
  const CellBand& band = lattice_.band();
  Cells missing(band.size()), area(band.size());
  forCells(band, progress, [&](std::size_t cell) {
    if (std::fabs(phi_[cell]) > 2.0F) return;
    const Filling filling = fillingAt(cell);
    missing[cell] = static_cast<float>((lattice_.inside(cell) ? 1.0 : 0.0) - filling.part);
    area[cell] = static_cast<float>(filling.rate);
  });
  // Weights that make the shifts, summed over the area, give back all that is missing: windows
  // reach less of the surface from within a vessel than from outside it.
  Cells weight = area;
  spread(area, progress);
  forCells(band, progress, [&](std::size_t cell) {
    weight[cell] = area[cell] > kLeastArea ? weight[cell] / area[cell] : 0.0F;
  });
  spread(weight, progress);
  forCells(band, progress,
           [&](std::size_t cell) { missing[cell] /= std::max(weight[cell], kLeastArea); });
  spread(missing, progress);
  forCells(band, progress, [&](std::size_t cell) {
    if (!(area[cell] > kLeastArea)) return;
    const float shift = std::clamp(missing[cell] / area[cell], -kMostShift, kMostShift);
    // Beyond the surface's surroundings the field is left as it is, without a step at its edge.
    const float share = std::clamp(kReach - std::fabs(phi_[cell]), 0.0F, 1.0F);
    phi_[cell] = bounded(cell, phi_[cell] - share * shift);
  });
  if (!measured_) extrapolate(phi_);
}

Volume<float> BoundedField::volume(const Volume<std::uint8_t>& mask) const {
  Volume<float> phi(mask.geometry);
  std::transform(mask.voxels.begin(), mask.voxels.end(), phi.voxels.begin(),
                 [](std::uint8_t in) { return in != 0 ? -kReach : kReach; });
  for (std::size_t cell = 0; cell < phi_.size(); ++cell)
    phi.voxels[lattice_.band().voxel[cell]] = phi_[cell];
  return phi;
}

void BoundedField::take(const Volume<float>& distance) {
  measured_ = true;
  for (std::size_t cell = 0; cell < phi_.size(); ++cell)
    phi_[cell] = distance.voxels[lattice_.band().voxel[cell]];
}

void BoundedField::giveTo(Volume<float>& distance) const {
  for (std::size_t cell = 0; cell < phi_.size(); ++cell)
    distance.voxels[lattice_.band().voxel[cell]] = phi_[cell];
}

/// How far from the middle phi crosses the grid edges between voxels of different sign, at most.
double largestShift(const Volume<float>& phi) {
  const Geometry& g = phi.geometry;
  double most = 0.0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        for (std::size_t a = 0; a < 3; ++a) {
          const Index3 q{i + (a == 0 ? 1 : 0), j + (a == 1 ? 1 : 0), k + (a == 2 ? 1 : 0)};
          if (!g.contains(q[0], q[1], q[2])) continue;
          const double u = static_cast<double>(phi.at(i, j, k));
          const double v = static_cast<double>(phi.at(q[0], q[1], q[2]));
          if ((u < 0.0) != (v < 0.0)) most = std::max(most, std::fabs(u / (u - v) - 0.5));
        }
  return most;
}

}  // namespace

double volumeBetweenCentres(const Volume<std::uint8_t>& mask) {
  const Geometry& g = mask.geometry;
  const auto share = [](int at, int size) { return at == 0 || at + 1 == size ? 0.5 : 1.0; };
  double sum = 0.0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i)
        if (mask.at(i, j, k) != 0)
          sum += share(i, g.size[0]) * share(j, g.size[1]) * share(k, g.size[2]);
  return sum * g.voxelVolumeMm3();
}

MaskDistance distanceOfMask(const Volume<std::uint8_t>& mask, const Progress& progress) {
  const auto isSet = [](std::uint8_t in) { return in != 0; };
  const bool any = std::any_of(mask.voxels.begin(), mask.voxels.end(), isSet);
  if (!any || std::all_of(mask.voxels.begin(), mask.voxels.end(), isSet))
    throw InputError(any ? "the mask fills the whole volume" : "the mask is empty", "",
                     "give a mask that is 0 outside and not 0 inside");
  progress.phase("smoothing the mask");
  MaskDistance result;
  Volume<float>& phi = result.phi;
  BoundedField field(mask, progress);
  progress.report(0.1);
  for (int round = 0; round < kRounds; ++round) {
    field.smooth(kSmoothings, progress);
    field.roughlyCorrectVolume(progress);
    progress.report(0.1 + 0.4 * (round + 1.0) / kRounds);
  }
  phi = redistance(field.volume(mask), kClamp, progress.sub(0.5, 0.75));
  const auto voxel = static_cast<float>(mask.geometry.voxelMm());
  for (float& value : phi.voxels) value /= voxel;
  // Last, as a distance has another spline than what it was made of: that of thin vessels is wider.
  field.take(phi);
  for (int n = 0; n < kCorrections; ++n) {
    field.correctVolume(SplineField(phi, SplineKind::InterpolatingBspline), progress);
    field.giveTo(phi);
    progress.report(0.75 + 0.25 * (n + 1.0) / kCorrections);
  }
  result.largestShiftVoxels = largestShift(phi);
  result.maskVolumeMm3 = volumeBetweenCentres(mask);
  for (float& value : phi.voxels) value *= voxel;
  return result;
}

}  // namespace angiomesh
