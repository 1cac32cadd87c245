// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/image/projection.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;

constexpr int kTilePixels = 480;    // of the longest side of all tiles
constexpr double kCutFacing = 0.8;  // of a vessel cut by the volume's border
constexpr int kGap = 8;             // pixels around and between the tiles
constexpr std::array<std::uint8_t, 3> kFrameColour{38, 40, 44};
constexpr std::array<double, 3> kVesselColour{255.0, 228.0, 204.0};
constexpr std::array<std::uint8_t, 3> kLetterColour{230, 190, 90};

/// How a tile lies in the grid. Signs are +1 where the grid axis runs right, down, or away from the
/// viewer, else -1.
struct View {
  int across = 0, down = 1, along = 2;  ///< grid axes
  double acrossSign = 1.0, downSign = 1.0, alongSign = 1.0;
  char left = 'R', right = 'L', top = 'A', bottom = 'P';
  int width = 0, height = 0;  ///< pixels
};

/// Coronal from the front, sagittal from the patient's left, axial from the feet.
std::array<View, 3> patientViews(const Geometry& g, int longestSide = kTilePixels) {
  struct Plane {
    int across, down, along;  // patient axes
    double acrossSign, downSign, alongSign;
    char left, right, top, bottom;
  };
  static constexpr Plane planes[3] = {{0, 2, 1, 1, -1, 1, 'R', 'L', 'S', 'I'},
                                      {1, 2, 0, 1, -1, -1, 'A', 'P', 'S', 'I'},
                                      {0, 1, 2, 1, 1, 1, 'R', 'L', 'A', 'P'}};
  const std::array<int, 3> patientAxes = nearestPatientAxes(g);
  const auto gridAxis = [&](int patient) {
    return static_cast<int>(std::find(patientAxes.begin(), patientAxes.end(), patient) -
                            patientAxes.begin());
  };
  const auto sign = [&](int patient) {
    return g.direction(patient, gridAxis(patient)) < 0.0 ? -1.0 : 1.0;
  };
  double longest = 0.0;
  for (int a = 0; a < 3; ++a) longest = std::max(longest, g.size[a] * g.spacing[a]);
  const auto pixels = [&](int axis) {
    return std::max(
        1, static_cast<int>(std::lround(longestSide * g.size[axis] * g.spacing[axis] / longest)));
  };
  std::array<View, 3> views;
  for (std::size_t i = 0; i < 3; ++i) {
    const Plane& p = planes[i];
    View& v = views[i];
    v.across = gridAxis(p.across);
    v.down = gridAxis(p.down);
    v.along = gridAxis(p.along);
    v.acrossSign = p.acrossSign * sign(p.across);
    v.downSign = p.downSign * sign(p.down);
    v.alongSign = p.alongSign * sign(p.along);
    v.left = p.left;
    v.right = p.right;
    v.top = p.top;
    v.bottom = p.bottom;
    v.width = pixels(v.across);
    v.height = pixels(v.down);
  }
  return views;
}

/// Continuous grid index at a picture position 0..pixels of a tile's side.
double gridIndex(double position, int pixels, double sign, int size) {
  const double t = position / pixels;
  return (sign > 0.0 ? t : 1.0 - t) * size - 0.5;
}

using Tile = std::vector<std::array<std::uint8_t, 3>>;

std::array<double, 2> greyWindow(const Projection& projection) {
  std::vector<float> sorted = projection.values;
  std::sort(sorted.begin(), sorted.end());
  const auto at = [&](double fraction) {
    return static_cast<double>(
        sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))]);
  };
  const double low = at(0.01);
  const double high = at(0.998);
  if (high > low) return {low, high};
  return {low, std::max(static_cast<double>(sorted.back()), low + 1e-6)};
}

double bilinear(const Projection& p, double u, double v) {
  u = std::clamp(u, 0.0, p.width - 1.0);
  v = std::clamp(v, 0.0, p.height - 1.0);
  const int u0 = static_cast<int>(u);
  const int v0 = static_cast<int>(v);
  const int u1 = std::min(u0 + 1, p.width - 1);
  const int v1 = std::min(v0 + 1, p.height - 1);
  const auto at = [&](int x, int y) {
    return static_cast<double>(
        p.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.width) +
                 static_cast<std::size_t>(x)]);
  };
  const double s = u - u0;
  const double t = v - v0;
  return (1.0 - t) * ((1.0 - s) * at(u0, v0) + s * at(u1, v0)) +
         t * ((1.0 - s) * at(u0, v1) + s * at(u1, v1));
}

Tile imageTile(const Volume<float>& image, const View& view) {
  const Projection projection = maximumProjection(image, view.along);
  const auto [low, high] = greyWindow(projection);
  const Index3& n = image.geometry.size;
  const bool transposed = view.across > view.down;  // projections list the lower axis first
  // Several samples per pixel where the picture is coarser than the grid.
  const int samples = std::clamp((n[view.across] + view.width - 1) / view.width, 1, 4);
  Tile tile(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x) {
      double sum = 0.0;
      for (int sy = 0; sy < samples; ++sy)
        for (int sx = 0; sx < samples; ++sx) {
          const double u =
              gridIndex(x + (sx + 0.5) / samples, view.width, view.acrossSign, n[view.across]);
          const double v =
              gridIndex(y + (sy + 0.5) / samples, view.height, view.downSign, n[view.down]);
          sum += transposed ? bilinear(projection, v, u) : bilinear(projection, u, v);
        }
      const double grey = (sum / (samples * samples) - low) / (high - low);
      const auto value = static_cast<std::uint8_t>(std::lround(std::clamp(grey, 0.0, 1.0) * 255.0));
      tile[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
           static_cast<std::size_t>(x)] = {value, value, value};
    }
  return tile;
}

struct Hit {
  double depthMm = std::numeric_limits<double>::max();  ///< from the volume's near face
  double facing = 0.0;  ///< cosine between the wall's normal and the direction to the viewer
};

/// Which bricks of 8 x 8 x 8 cells of the grid hold a sample of phi below 0.
class Occupancy {
 public:
  static constexpr int kEdge = 8;

  explicit Occupancy(const Volume<float>& phi) : size_(phi.geometry.size) {
    for (int a = 0; a < 3; ++a) bricks_[a] = (size_[a] + kEdge - 1) / kEdge;
    const auto layers = static_cast<std::size_t>(bricks_[2]);
    full_.assign(layers * layerSize(), 0);
    parallelForEach(layers, 1, [&](std::size_t layer) { fillLayer(phi, static_cast<int>(layer)); });
    for (std::size_t n = 0; n < full_.size(); ++n) {
      if (full_[n] == 0) continue;
      const std::size_t inLayer = n % layerSize();
      const auto columns = static_cast<std::size_t>(bricks_[0]);
      const std::array<std::size_t, 3> brick{inLayer % columns, inLayer / columns, n / layerSize()};
      for (std::size_t a = 0; a < 3; ++a) {
        const int first = static_cast<int>(brick[a]) * kEdge;
        const auto axis = static_cast<Eigen::Index>(a);
        low_[axis] = std::min(low_[axis], first == 0 ? -0.5 : first);
        high_[axis] = std::max(high_[axis], std::min<double>(first + kEdge, size_[a] - 0.5));
      }
    }
  }

  /// Corners, as continuous indices, of a box that holds every point below 0; low > high where
  /// there is none.
  [[nodiscard]] const Vector3d& low() const { return low_; }
  [[nodiscard]] const Vector3d& high() const { return high_; }

  /// The brick of a continuous index inside the volume.
  [[nodiscard]] Index3 brickOf(const Vector3d& index) const {
    Index3 brick{};
    for (int a = 0; a < 3; ++a)
      brick[a] = std::clamp(static_cast<int>(std::floor(index[a])), 0, size_[a] - 1) / kEdge;
    return brick;
  }

  [[nodiscard]] bool full(const Index3& brick) const { return full_[offset(brick)] != 0; }

 private:
  [[nodiscard]] std::size_t layerSize() const {
    return static_cast<std::size_t>(bricks_[0]) * static_cast<std::size_t>(bricks_[1]);
  }
  [[nodiscard]] std::size_t offset(const Index3& brick) const {
    return static_cast<std::size_t>(brick[2]) * layerSize() +
           static_cast<std::size_t>(brick[1]) * static_cast<std::size_t>(bricks_[0]) +
           static_cast<std::size_t>(brick[0]);
  }

  /// A cell's far corners belong to the next bricks' samples, so each brick looks one further.
  void fillLayer(const Volume<float>& phi, int layer) {
    const int last = std::min((layer + 1) * kEdge, size_[2] - 1);
    for (int k = layer * kEdge; k <= last; ++k)
      for (int j = 0; j < size_[1]; ++j)
        for (int i = 0; i < size_[0]; ++i) {
          if (!(phi.at(i, j, k) < 0.0F)) continue;
          const int lowI = i % kEdge == 0 && i > 0 ? 1 : 0;
          const int lowJ = j % kEdge == 0 && j > 0 ? 1 : 0;
          for (int dj = 0; dj <= lowJ; ++dj)
            for (int di = 0; di <= lowI; ++di)
              full_[offset({i / kEdge - di, j / kEdge - dj, layer})] = 1;
        }
  }

  Index3 size_;
  Index3 bricks_{};
  Vector3d low_ = Vector3d::Constant(std::numeric_limits<double>::max());
  Vector3d high_ = Vector3d::Constant(std::numeric_limits<double>::lowest());
  std::vector<std::uint8_t> full_;
};

/// Where a ray first meets phi < 0: marches through the bricks that hold some, then halves the last
/// step.
class VesselRays {
 public:
  VesselRays(const Volume<float>& phi, const Occupancy& occupancy, const Geometry& grid,
             const View& view)
      : phi_(phi),
        occupancy_(occupancy),
        grid_(grid),
        view_(view),
        toIndex_(phi.geometry.physicalToIndexMatrix()) {
    const Vector3d column = grid.direction.col(view.along);
    ray_ = view.alongSign * column / column.norm();
    step_ = toIndex_ * ray_;
    length_ = grid.size[view.along] * grid.spacing[view.along];
  }

  [[nodiscard]] Hit cast(double u, double v) const {
    if (occupancy_.low()[0] > occupancy_.high()[0]) return {};
    Vector3d index;
    index[view_.across] = u;
    index[view_.down] = v;
    index[view_.along] = view_.alongSign > 0.0 ? -0.5 : grid_.size[view_.along] - 0.5;
    const Vector3d start = toIndex_ * (grid_.toPhysical(index) - phi_.geometry.origin);
    double enter = 0.0;
    double leave = length_;
    for (int a = 0; a < 3; ++a) {
      const double low = occupancy_.low()[a] - start[a];
      const double high = occupancy_.high()[a] - start[a];
      if (std::fabs(step_[a]) < 1e-12) {
        if (low > 0.0 || high < 0.0) return {};
        continue;
      }
      enter = std::max(enter, std::min(low / step_[a], high / step_[a]));
      leave = std::min(leave, std::max(low / step_[a], high / step_[a]));
    }
    const double stride = 0.4 * phi_.geometry.voxelMm();
    double before = enter;
    for (double t = enter; t <= leave;) {
      const Vector3d at = start + t * step_;
      const Index3 brick = occupancy_.brickOf(at);
      if (occupancy_.full(brick)) {
        const double value = interpolateLinear(phi_, at);
        if (value < 0.0) {
          if (t == enter) return {t, kCutFacing};
          return refined(start, before, t);
        }
        before = t;  // 0.55 of phi is a safe step also where phi is a city-block distance
        t += std::clamp(0.55 * value, stride, 5.0 * stride);
      } else {
        before = t;
        t = std::max(endOfBrick(brick, start), t + 1e-3 * stride);
      }
    }
    return {};
  }

 private:
  /// Just behind the point where the ray leaves the brick, mm.
  [[nodiscard]] double endOfBrick(const Index3& brick, const Vector3d& start) const {
    double end = std::numeric_limits<double>::max();
    for (int a = 0; a < 3; ++a) {
      if (std::fabs(step_[a]) < 1e-12) continue;
      const bool last = (brick[a] + 1) * Occupancy::kEdge >= phi_.geometry.size[a];
      double face = brick[a] * Occupancy::kEdge;
      if (step_[a] > 0.0) face = last ? phi_.geometry.size[a] : face + Occupancy::kEdge;
      if (step_[a] < 0.0 && brick[a] == 0) face = -1.0;
      end = std::min(end, (face - start[a]) / step_[a]);
    }
    return end + 1e-6 * phi_.geometry.voxelMm();
  }

  [[nodiscard]] Hit refined(const Vector3d& start, double outside, double inside) const {
    for (int i = 0; i < 6; ++i) {
      const double middle = 0.5 * (outside + inside);
      (interpolateLinear(phi_, start + middle * step_) < 0.0 ? inside : outside) = middle;
    }
    const Vector3d at = start + inside * step_;
    Vector3d gradient;
    for (int a = 0; a < 3; ++a) {
      const Vector3d offset = Vector3d::Unit(a);
      gradient[a] = interpolateLinear(phi_, at + offset) - interpolateLinear(phi_, at - offset);
    }
    const Vector3d normal = toIndex_.transpose() * gradient;
    const double norm = normal.norm();
    return {inside, norm > 0.0 ? std::max(0.0, -normal.dot(ray_) / norm) : 1.0};
  }

  const Volume<float>& phi_;
  const Occupancy& occupancy_;
  const Geometry& grid_;
  const View& view_;
  Eigen::Matrix3d toIndex_;
  Vector3d ray_, step_;
  double length_ = 0.0;
};

Tile vesselTile(const Volume<float>& phi, const Occupancy& occupancy, const Geometry& grid,
                const View& view) {
  const auto width = static_cast<std::size_t>(view.width);
  const auto height = static_cast<std::size_t>(view.height);
  constexpr std::size_t samples = 2;  // across and down each pixel, for smooth outlines
  const std::size_t fineWidth = samples * width;
  const VesselRays rays(phi, occupancy, grid, view);
  std::vector<Hit> hits(samples * height * fineWidth);
  parallelForEach(samples * height, 16, [&](std::size_t y) {
    const double v = gridIndex((static_cast<double>(y) + 0.5) / samples, view.height, view.downSign,
                               grid.size[view.down]);
    for (std::size_t x = 0; x < fineWidth; ++x) {
      const double u = gridIndex((static_cast<double>(x) + 0.5) / samples, view.width,
                                 view.acrossSign, grid.size[view.across]);
      hits[y * fineWidth + x] = rays.cast(u, v);
    }
  });
  double nearest = std::numeric_limits<double>::max();
  double farthest = 0.0;
  const auto isHit = [](const Hit& h) { return h.depthMm < std::numeric_limits<double>::max(); };
  for (const Hit& hit : hits)
    if (isHit(hit)) {
      nearest = std::min(nearest, hit.depthMm);
      farthest = std::max(farthest, hit.depthMm);
    }
  Tile tile(width * height);
  for (std::size_t n = 0; n < tile.size(); ++n) {
    double light = 0.0;
    for (std::size_t sample = 0; sample < samples * samples; ++sample) {
      const std::size_t x = n % width * samples + sample % samples;
      const std::size_t y = n / width * samples + sample / samples;
      const Hit& hit = hits[y * fineWidth + x];
      if (!isHit(hit)) continue;
      const double depth = (hit.depthMm - nearest) / std::max(farthest - nearest, 1e-9);
      light += (0.3 + 0.7 * hit.facing) * (1.0 - 0.6 * depth);
    }
    light /= samples * samples;
    for (std::size_t c = 0; c < 3; ++c)
      tile[n][c] = static_cast<std::uint8_t>(std::lround(light * kVesselColour[c]));
  }
  return tile;
}

/// Five columns by seven rows, the leftmost column in bit 4.
std::array<std::uint8_t, 7> glyph(char letter) {
  switch (letter) {
    case 'R':
      return {0x1e, 0x11, 0x11, 0x1e, 0x14, 0x12, 0x11};
    case 'L':
      return {0x10, 0x10, 0x10, 0x10, 0x10, 0x10, 0x1f};
    case 'A':
      return {0x0e, 0x11, 0x11, 0x1f, 0x11, 0x11, 0x11};
    case 'P':
      return {0x1e, 0x11, 0x11, 0x1e, 0x10, 0x10, 0x10};
    case 'S':
      return {0x0f, 0x10, 0x10, 0x0e, 0x01, 0x01, 0x1e};
    default:  // I
      return {0x0e, 0x04, 0x04, 0x04, 0x04, 0x04, 0x0e};
  }
}

void setPixel(Picture& picture, int x, int y, const std::array<std::uint8_t, 3>& colour) {
  if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
           static_cast<std::size_t>(x));
  std::copy(colour.begin(), colour.end(), picture.rgb.begin() + static_cast<std::ptrdiff_t>(at));
}

void drawLetter(Picture& picture, char letter, int centreX, int centreY) {
  const auto rows = glyph(letter);
  const auto draw = [&](int shiftX, int shiftY, const std::array<std::uint8_t, 3>& colour) {
    for (int y = 0; y < 14; ++y)
      for (int x = 0; x < 10; ++x)
        if ((rows[static_cast<std::size_t>(y / 2)] >> (4 - x / 2) & 1) != 0)
          setPixel(picture, centreX - 5 + x + shiftX, centreY - 7 + y + shiftY, colour);
  };
  for (int shiftY = -1; shiftY <= 1; ++shiftY)
    for (int shiftX = -1; shiftX <= 1; ++shiftX) draw(shiftX, shiftY, {0, 0, 0});
  draw(0, 0, kLetterColour);
}

void drawTile(Picture& picture, const Tile& tile, const View& view, int left, int top) {
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      setPixel(picture, left + x, top + y,
               tile[static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
                    static_cast<std::size_t>(x)]);
  if (std::min(view.width, view.height) < 60) return;
  constexpr int margin = 11;
  drawLetter(picture, view.left, left + margin, top + view.height / 2);
  drawLetter(picture, view.right, left + view.width - 1 - margin, top + view.height / 2);
  drawLetter(picture, view.top, left + view.width / 2, top + margin);
  drawLetter(picture, view.bottom, left + view.width / 2, top + view.height - 1 - margin);
}

}  // namespace

std::array<int, 3> nearestPatientAxes(const Geometry& g) {
  std::array<int, 3> axes{0, 1, 2};
  std::array<int, 3> best = axes;
  double most = -1.0;
  do {
    double sum = 0.0;
    for (int a = 0; a < 3; ++a) sum += std::fabs(g.direction(axes[static_cast<std::size_t>(a)], a));
    if (sum > most + 1e-9) {
      most = sum;
      best = axes;
    }
  } while (std::next_permutation(axes.begin(), axes.end()));
  return best;
}

Picture mipFromTheFront(const Volume<float>& image, int longestSide) {
  if (image.voxels.empty())
    throw InputError("there is nothing to show", "picture of an image",
                     "give an image with voxels");
  const View view = patientViews(image.geometry, longestSide).front();
  const Tile tile = imageTile(image, view);
  Picture picture{view.width, view.height, {}};
  picture.rgb.reserve(3 * tile.size());
  for (const auto& colour : tile)
    picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
  return picture;
}

Picture previewPicture(const Volume<float>& image, const Volume<float>& phi) {
  if (image.voxels.empty() || phi.voxels.empty())
    throw InputError("there is nothing to show", "preview picture",
                     "give an image and a segmentation with voxels");
  const std::array<View, 3> views = patientViews(image.geometry);
  Picture picture;
  int rowHeight = 0;
  picture.width = kGap;
  for (const View& view : views) {
    picture.width += view.width + kGap;
    rowHeight = std::max(rowHeight, view.height);
  }
  picture.height = 2 * rowHeight + 3 * kGap;
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) *
                     static_cast<std::size_t>(picture.height));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) setPixel(picture, x, y, kFrameColour);
  const Occupancy occupancy(phi);
  int left = kGap;
  for (const View& view : views) {  // the two tiles of a view next to each other
    drawTile(picture, imageTile(image, view), view, left, kGap + rowHeight - view.height);
    drawTile(picture, vesselTile(phi, occupancy, image.geometry, view), view, left,
             rowHeight + 2 * kGap);
    left += view.width + kGap;
  }
  return picture;
}

}  // namespace angiomesh
