// SPDX-License-Identifier: BSD-3-Clause
#include "app/study/figure_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace angiomesh::cli {
namespace {

constexpr int kLongestSide = 640;  // pixels
constexpr double kTint = 0.55;

/// Grid axes of a coronal picture, and whether the grid runs against the picture's right and down.
struct CoronalAxes {
  int across = 0, down = 2, along = 1;
  bool acrossBack = false, downBack = true;
};

CoronalAxes coronalAxes(const Geometry& g) {
  const auto nearest = [&](int patient, int taken) {
    int best = taken == 0 ? 1 : 0;
    for (int a = 0; a < 3; ++a)
      if (a != taken && std::fabs(g.direction(patient, a)) > std::fabs(g.direction(patient, best)))
        best = a;
    return best;
  };
  CoronalAxes axes;
  axes.along = nearest(1, -1);
  axes.down = nearest(2, axes.along);
  axes.across = 3 - axes.along - axes.down;
  axes.acrossBack = g.direction(0, axes.across) < 0.0;
  axes.downBack = g.direction(2, axes.down) > 0.0;
  return axes;
}

std::size_t at(const Geometry& g, const CoronalAxes& axes, int u, int v, int slice) {
  Index3 p{};
  p[static_cast<std::size_t>(axes.across)] = u;
  p[static_cast<std::size_t>(axes.down)] = v;
  p[static_cast<std::size_t>(axes.along)] = slice;
  return g.offset(p[0], p[1], p[2]);
}

/// The lower half of previewPicture(): the vessels' row, or the upper one, the image's.
Picture previewHalf(const Picture& preview, bool lower) {
  Picture half;
  half.width = preview.width;
  half.height = preview.height / 2;
  const auto row = static_cast<std::size_t>(preview.width) * 3;
  const std::size_t first =
      lower ? static_cast<std::size_t>(preview.height - half.height) * row : 0;
  const auto from = preview.rgb.begin() + static_cast<std::ptrdiff_t>(first);
  half.rgb.assign(from, from + static_cast<std::ptrdiff_t>(row) * half.height);
  return half;
}

}  // namespace

int mostDifferentSlice(const Volume<float>& phi, const Volume<float>& other) {
  const Geometry& g = phi.geometry;
  const auto along = static_cast<std::size_t>(coronalAxes(g).along);
  std::vector<std::size_t> different(static_cast<std::size_t>(g.size[along]), 0);
  for (std::size_t i = 0; i < phi.voxels.size(); ++i)
    if ((phi.voxels[i] < 0.0F) != (other.voxels[i] < 0.0F))
      ++different[static_cast<std::size_t>(g.indexOf(i)[along])];
  const auto most = std::max_element(different.begin(), different.end());
  return *most == 0 ? g.size[along] / 2 : static_cast<int>(most - different.begin());
}

Picture coronalSlice(const Volume<float>& image, const Volume<float>* phi, int slice) {
  const Geometry& g = image.geometry;
  const CoronalAxes axes = coronalAxes(g);
  const int nu = g.size[static_cast<std::size_t>(axes.across)];
  const int nv = g.size[static_cast<std::size_t>(axes.down)];
  const double wide = nu * g.spacing[axes.across];
  const double high = nv * g.spacing[axes.down];
  const double pixelMm = std::max(wide, high) / kLongestSide;
  Picture picture;
  picture.width = std::max(1, static_cast<int>(std::lround(wide / pixelMm)));
  picture.height = std::max(1, static_cast<int>(std::lround(high / pixelMm)));
  const std::vector<double> window = percentiles(image, {0.01, 0.998});
  const double range = std::max(window[1] - window[0], 1e-6);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      int u = static_cast<int>((x + 0.5) / picture.width * nu);
      int v = static_cast<int>((y + 0.5) / picture.height * nv);
      if (axes.acrossBack) u = nu - 1 - u;
      if (axes.downBack) v = nv - 1 - v;
      const std::size_t voxel = at(g, axes, u, v, slice);
      const double grey = std::clamp(
          255.0 * (static_cast<double>(image.voxels[voxel]) - window[0]) / range, 0.0, 255.0);
      const bool inside = phi != nullptr && phi->voxels[voxel] < 0.0F;
      const double faded = inside ? (1.0 - kTint) * grey : grey;
      picture.rgb.push_back(static_cast<std::uint8_t>(faded + (inside ? kTint * 255.0 : 0.0)));
      picture.rgb.push_back(static_cast<std::uint8_t>(faded));
      picture.rgb.push_back(static_cast<std::uint8_t>(faded));
    }
  return picture;
}

Picture projectionRows(const Volume<float>& image, const std::vector<const Volume<float>*>& phis) {
  std::vector<Picture> rows;
  for (const Volume<float>* phi : phis) {
    const Picture preview = previewPicture(image, *phi);
    if (rows.empty()) rows.push_back(previewHalf(preview, false));
    rows.push_back(previewHalf(preview, true));
  }
  return stacked(rows);
}

Picture stacked(const std::vector<Picture>& pictures) {
  Picture all;
  for (const Picture& picture : pictures) {
    all.width = picture.width;
    all.height += picture.height;
    all.rgb.insert(all.rgb.end(), picture.rgb.begin(), picture.rgb.end());
  }
  return all;
}

}  // namespace angiomesh::cli
