// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/measurement.h"

#include "core/mesh/flat_area.h"

namespace angiomesh {
namespace {

struct KindFacts {
  const char* word;
  std::size_t places, sections;
};

/// In the order of MeasurementKind.
constexpr std::array<KindFacts, kMeasurementKinds> kKinds{
    {{"distance", 2, 0}, {"section", 1, 1}, {"profile", 1, 0}, {"stenosis", 2, 3}}};

const KindFacts& factsOf(MeasurementKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

}  // namespace

const char* measurementWord(MeasurementKind kind) { return factsOf(kind).word; }

std::optional<MeasurementKind> measurementKindOf(const std::string& word) {
  for (std::size_t i = 0; i < kKinds.size(); ++i)
    if (word == kKinds[i].word) return static_cast<MeasurementKind>(i);
  return std::nullopt;
}

std::size_t placesOf(MeasurementKind kind) { return factsOf(kind).places; }
std::size_t sectionsOf(MeasurementKind kind) { return factsOf(kind).sections; }

double CrossSection::equivalentDiameterMm() const {
  return angiomesh::equivalentDiameterMm(areaMm2);
}

}  // namespace angiomesh
