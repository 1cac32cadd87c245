// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "core/base/random.h"
#include "core/parameters/field.h"

namespace angiomesh::test {

/// A value that the field takes, a function of the seed.
inline FieldValue randomValue(const Field& field, std::uint64_t seed) {
  const double u = randomUniform(seed, 1);
  if (!field.emptyWord.empty() && randomUniform(seed, 0) < 0.3) return {};
  const double span = field.maximum - field.minimum;
  switch (field.kind) {
    case FieldKind::Boolean:
      return u < 0.5;
    case FieldKind::Integer:
      return static_cast<std::int64_t>(field.minimum + std::floor(u * span));
    case FieldKind::Real:
      return field.minimum + u * span;
    case FieldKind::Choice:
      return field.choices[static_cast<std::size_t>(u * static_cast<double>(field.choices.size()))];
    case FieldKind::Texts: {
      if (field.key == "ports.names")
        return std::vector<std::string>{"border_" + std::to_string(1 + seed % 3) + "=left",
                                        "border_9=right-" + std::to_string(seed % 7)};
      if (field.key == "segmentation.corrections") {
        std::vector<std::string> made;
        for (int n = 0; n < 3; ++n) {
          Correction correction;
          correction.kind = static_cast<CorrectionKind>((seed + static_cast<unsigned>(n)) % 9);
          if (isBrush(correction.kind)) correction.radiusMm = 0.5 + u;
          const bool two = correction.kind == CorrectionKind::Bridge ||
                           correction.kind == CorrectionKind::Separate;
          for (int p = 0; p < (two || isBrush(correction.kind) ? 2 : 1); ++p)
            correction.placesLps.emplace_back(100.0 * u, -30.0 * n, 5.0 * p);
          if (correction.kind == CorrectionKind::CutOff && u < 0.5)
            correction.normalLps = Eigen::Vector3d(0.3, -u, 1.0).normalized();
          made.push_back(correctionText(correction));
        }
        return made;
      }
      std::vector<std::string> cuts;
      for (int n = 0; n < 2; ++n) {
        GivenCut cut;
        for (int a = 0; a < 3; ++a) cut.pointLps[a] = randomNormal(seed, 10 * n + a) * 100.0;
        if (randomUniform(seed, 30 + n) < 0.5) cut.normalLps = Eigen::Vector3d(0.3, -u, 1.0);
        cut.name = n == 0 ? "inlet" : "outlet-" + std::to_string(seed % 7);
        cuts.push_back(cutText(cut));
      }
      return cuts;
    }
    case FieldKind::Numbers: {
      std::vector<double> numbers;
      for (std::size_t i = 0; i < field.groupOf; ++i)
        numbers.push_back(randomNormal(seed, i) * 100.0);
      return numbers;
    }
  }
  return {};
}

/// Parameters with a random value in each field, a function of the seed.
inline Parameters randomParameters(std::uint64_t seed) {
  Parameters params;
  std::uint64_t counter = 0;
  for (const Field& field : parameterFields())
    setField(params, field.key, randomValue(field, seed * 1000 + counter++));
  return params;
}

}  // namespace angiomesh::test
