// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace angiomesh {

/// What can be measured. Distance: between two points. Section: across the vessel at a place.
/// Profile: the diameter along the branch that a place lies in. Stenosis: the narrowest section
/// between two places of a vessel, compared with those at the places.
enum class MeasurementKind { Distance, Section, Profile, Stenosis };
constexpr int kMeasurementKinds = 4;

/// "distance", as files have it, and back.
const char* measurementWord(MeasurementKind kind);
std::optional<MeasurementKind> measurementKindOf(const std::string& word);

/// How many places the user picks for a measurement, and how many sections it has.
std::size_t placesOf(MeasurementKind kind);
std::size_t sectionsOf(MeasurementKind kind);

/// A vessel cut across. Lengths in mm, positions in LPS.
struct CrossSection {
  Eigen::Vector3d centreLps{0.0, 0.0, 0.0};  ///< of the area
  Eigen::Vector3d axisLps{0.0, 0.0, 1.0};    ///< the vessel's, unit
  double areaMm2 = 0.0;
  /// The narrowest and the widest that callipers measure, each by its ends: the least distance of
  /// two parallel lines that hold the outline between them, and the greatest distance of two of
  /// its points (Feret's diameters).
  std::array<Eigen::Vector3d, 2> narrowest{}, widest{};
  std::vector<Eigen::Vector3d> outline;  ///< the outermost, closed, coarse enough to be kept

  [[nodiscard]] double minDiameterMm() const { return (narrowest[1] - narrowest[0]).norm(); }
  [[nodiscard]] double maxDiameterMm() const { return (widest[1] - widest[0]).norm(); }
  [[nodiscard]] double equivalentDiameterMm() const;  ///< of the circle of the same area
  bool operator==(const CrossSection& other) const = default;
};

/// The vessel at one place of its centre line.
struct ProfilePoint {
  double alongMm = 0.0;                     ///< from the first place
  Eigen::Vector3d pointLps{0.0, 0.0, 0.0};  ///< mm
  double diameterMm = 0.0;                  ///< of the circle of the section's area
  double minDiameterMm = 0.0, maxDiameterMm = 0.0;
  bool operator==(const ProfilePoint& other) const = default;
};

/// What was measured, as it is kept with the case.
struct Measurement {
  MeasurementKind kind = MeasurementKind::Distance;
  std::string name;
  std::vector<Eigen::Vector3d> places;  ///< as picked, mm LPS
  /// Of the wall that was measured, the key of the step evolve; empty where there is none to it.
  std::string key;
  /// Of a section one; of a stenosis the narrowest, that at the first and that at the second place.
  std::vector<CrossSection> sections;
  std::vector<ProfilePoint> profile;  ///< of a profile and of a stenosis; two or more

  bool operator==(const Measurement& other) const = default;
};

}  // namespace angiomesh
