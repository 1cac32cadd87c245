// SPDX-License-Identifier: BSD-3-Clause
#include "core/pipeline/source.h"

#include <xxhash.h>

#include <array>
#include <cstdio>
#include <utility>
#include <vector>

namespace angiomesh {
namespace {

std::string hex(std::uint64_t hash) {
  std::array<char, 17> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
  return text.data();
}

}  // namespace

std::string textHash(const std::string& text) { return hex(XXH3_64bits(text.data(), text.size())); }

std::string contentHash(const Volume<float>& image) {
  const Geometry& g = image.geometry;
  std::vector<double> shape(g.size.begin(), g.size.end());
  for (int a = 0; a < 3; ++a) {
    shape.push_back(g.spacing[a]);
    shape.push_back(g.origin[a]);
    for (int b = 0; b < 3; ++b) shape.push_back(g.direction(a, b));
  }
  const std::uint64_t seed = XXH3_64bits(shape.data(), shape.size() * sizeof(double));
  return hex(XXH3_64bits_withSeed(image.voxels.data(), image.voxels.size() * sizeof(float), seed));
}

Source makeSource(Volume<float> image, const std::string& name) {
  Source source;
  source.hash = contentHash(image);
  source.image = std::make_shared<const Volume<float>>(std::move(image));
  source.name = name;
  return source;
}

}  // namespace angiomesh
