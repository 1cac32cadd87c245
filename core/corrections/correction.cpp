// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/correction.h"

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/base/error.h"
#include "core/base/formatted.h"

namespace angiomesh {
namespace {

constexpr double kFarthestMm = 1e5;
constexpr double kLargestRadiusMm = 100.0;
constexpr std::size_t kMostPlaces = 100000;

struct KindFacts {
  CorrectionKind kind;
  const char* word;
  bool brush;
  std::size_t places;  ///< of a brush at least
};

constexpr std::array<KindFacts, 9> kKinds{{
    {CorrectionKind::Add, "add", true, 1},
    {CorrectionKind::AddToEdge, "add-to-edge", true, 1},
    {CorrectionKind::Erase, "erase", true, 1},
    {CorrectionKind::EraseToEdge, "erase-to-edge", true, 1},
    {CorrectionKind::Bridge, "bridge", false, 2},
    {CorrectionKind::Separate, "separate", false, 2},
    {CorrectionKind::CutOff, "cut-off", false, 1},
    {CorrectionKind::FillHole, "fill-hole", false, 1},
    {CorrectionKind::OpenLoop, "open-loop", false, 1},
}};

const KindFacts& factsOf(CorrectionKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  constexpr std::size_t kShown = 60;
  const std::string shown = text.size() > kShown ? text.substr(0, kShown) + "..." : text;
  throw InputError("'" + shown + "' is no correction: " + why, "segmentation.corrections",
                   std::string("write ") + kCorrectionForm + ", in mm LPS");
}

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::optional<Eigen::Vector3d> place(std::string_view text) {
  Eigen::Vector3d x;
  for (int a = 0; a < 3; ++a) {
    const std::size_t comma = a < 2 ? text.find(',') : text.size();
    if (comma == std::string_view::npos) return std::nullopt;
    const std::optional<double> value = number(text.substr(0, comma));
    if (!value || std::fabs(*value) > kFarthestMm) return std::nullopt;
    x[a] = *value;
    text.remove_prefix(a < 2 ? comma + 1 : comma);
  }
  return x;
}

/// To 1 um, without what rounding leaves of zeros.
std::string rounded(double value) { return shortestText(std::round(value * 1e3) / 1e3 + 0.0); }

std::string pointText(const Eigen::Vector3d& x) {
  return rounded(x[0]) + "," + rounded(x[1]) + "," + rounded(x[2]);
}

}  // namespace

const char* const kCorrectionForm =
    "add, add-to-edge, erase or erase-to-edge with RADIUS x,y,z [x,y,z ...]; bridge or separate "
    "with x,y,z x,y,z; cut-off x,y,z [nx,ny,nz]; fill-hole or open-loop with x,y,z";

bool isBrush(CorrectionKind kind) { return factsOf(kind).brush; }

const char* correctionWord(CorrectionKind kind) { return factsOf(kind).word; }

Correction parseCorrection(const std::string& text) {
  std::istringstream words(text);
  std::string word;
  words >> word;
  const KindFacts* facts = nullptr;
  for (const KindFacts& each : kKinds)
    if (word == each.word) facts = &each;
  if (facts == nullptr) refuse(text, "its first word is none of those that are known");
  Correction correction;
  correction.kind = facts->kind;
  if (facts->brush) {
    words >> word;
    const std::optional<double> radius = number(word);
    if (!words || !radius || !(*radius > 0.0) || *radius > kLargestRadiusMm)
      refuse(text, "its radius has to be above 0 mm and at most 100 mm");
    correction.radiusMm = *radius;
  }
  while (words >> word) {
    const std::optional<Eigen::Vector3d> x = place(word);
    if (!x) refuse(text, "'" + word + "' is no place");
    correction.placesLps.push_back(*x);
    if (correction.placesLps.size() > kMostPlaces) refuse(text, "it has too many places");
  }
  if (facts->kind == CorrectionKind::CutOff && correction.placesLps.size() == 2) {
    correction.normalLps = correction.placesLps.back();
    correction.placesLps.pop_back();
    if (correction.normalLps.norm() < 1e-6) refuse(text, "its normal has no direction");
    correction.normalLps.normalize();
  }
  const std::size_t given = correction.placesLps.size();
  if (facts->brush ? given < facts->places : given != facts->places)
    refuse(text, "it has " + std::to_string(given) + (given == 1 ? " place" : " places"));
  return correction;
}

std::string correctionText(const Correction& correction) {
  std::string text = correctionWord(correction.kind);
  if (isBrush(correction.kind)) text += " " + rounded(correction.radiusMm);
  for (const Eigen::Vector3d& x : correction.placesLps) text += " " + pointText(x);
  if (correction.normalLps != Eigen::Vector3d::Zero())
    text += formatted(" %.5f,%.5f,%.5f", correction.normalLps[0] + 0.0,
                      correction.normalLps[1] + 0.0, correction.normalLps[2] + 0.0);
  return text;
}

}  // namespace angiomesh
