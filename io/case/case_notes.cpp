// SPDX-License-Identifier: BSD-3-Clause
#include "io/case/case_notes.h"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "core/base/json_text.h"
#include "core/measure/review_json.h"

namespace angiomesh {
namespace {

using Eigen::Vector3d;
using Json = nlohmann::ordered_json;

double numberFrom(const Json& json) {
  const auto number = json.get<double>();
  if (!json.is_number() || !std::isfinite(number)) throw std::out_of_range("no number");
  return number;
}

/// Numbers one after the other, each read once.
class Numbers {
 public:
  explicit Numbers(const Json& json) : json_(json) {}
  double next() { return numberFrom(json_.at(at_++)); }
  Vector3d nextPoint() {
    const double x = next(), y = next(), z = next();
    return {x, y, z};
  }
  /// @throws std::out_of_range unless all are read
  void end() const {
    if (!json_.is_array() || at_ != json_.size()) throw std::out_of_range("too many numbers");
  }

 private:
  const Json& json_;
  std::size_t at_ = 0;
};

void add(Json& numbers, const Vector3d& point) {
  for (int axis = 0; axis < 3; ++axis) numbers.push_back(point[axis]);
}

/// Points one after the other: an array for each would take ten lines of case.json.
Json flat(const std::vector<Vector3d>& points) {
  Json numbers = Json::array();
  for (const Vector3d& point : points) add(numbers, point);
  return numbers;
}

std::vector<Vector3d> pointsFrom(const Json& json) {
  Numbers numbers(json);
  std::vector<Vector3d> points;
  for (std::size_t n = 0; n < json.size() / 3; ++n) points.push_back(numbers.nextPoint());
  numbers.end();
  return points;
}

std::array<Vector3d, 2> endsFrom(const Json& json) {
  const std::vector<Vector3d> points = pointsFrom(json);
  if (points.size() != 2) throw std::out_of_range("no two ends");
  return {points[0], points[1]};
}

Json toJson(const CrossSection& section) {
  return {{"centreMm", flat({section.centreLps})},
          {"axis", flat({section.axisLps})},
          {"areaMm2", section.areaMm2},
          {"narrowestMm", flat({section.narrowest[0], section.narrowest[1]})},
          {"widestMm", flat({section.widest[0], section.widest[1]})},
          {"outlineMm", flat(section.outline)}};
}

CrossSection sectionFrom(const Json& json) {
  CrossSection section;
  section.centreLps = pointsFrom(json.at("centreMm")).at(0);
  section.axisLps = pointsFrom(json.at("axis")).at(0);
  section.areaMm2 = numberFrom(json.at("areaMm2"));
  section.narrowest = endsFrom(json.at("narrowestMm"));
  section.widest = endsFrom(json.at("widestMm"));
  section.outline = pointsFrom(json.at("outlineMm"));
  if (!(section.areaMm2 > 0.0)) throw std::out_of_range("no area");
  return section;
}

Json toJson(const std::vector<ProfilePoint>& profile) {
  Json numbers = Json::array();
  for (const ProfilePoint& at : profile) {
    numbers.push_back(at.alongMm);
    add(numbers, at.pointLps);
    for (const double value : {at.diameterMm, at.minDiameterMm, at.maxDiameterMm})
      numbers.push_back(value);
  }
  return numbers;
}

std::vector<ProfilePoint> profileFrom(const Json& json) {
  constexpr std::size_t numbersEach = 7;
  Numbers numbers(json);
  std::vector<ProfilePoint> profile(json.size() / numbersEach);
  for (ProfilePoint& at : profile) {
    at.alongMm = numbers.next();
    at.pointLps = numbers.nextPoint();
    at.diameterMm = numbers.next();
    at.minDiameterMm = numbers.next();
    at.maxDiameterMm = numbers.next();
  }
  numbers.end();
  return profile;
}

Json toJson(const Measurement& measurement) {
  Json json = {{"kind", measurementWord(measurement.kind)},
               {"name", measurement.name},
               {"placesMm", flat(measurement.places)}};
  if (!measurement.key.empty()) json["key"] = measurement.key;
  for (const CrossSection& section : measurement.sections)
    json["sections"].push_back(toJson(section));
  if (!measurement.profile.empty()) json["profileMm"] = toJson(measurement.profile);
  return json;
}

/// @throws Json::exception, std::out_of_range
Measurement measurementFrom(const Json& json) {
  Measurement measurement;
  const auto kind = measurementKindOf(json.at("kind").get<std::string>());
  if (!kind) throw std::out_of_range("no such kind");
  measurement.kind = *kind;
  measurement.name = json.at("name").get<std::string>();
  measurement.places = pointsFrom(json.at("placesMm"));
  if (json.contains("key")) measurement.key = json["key"].get<std::string>();
  if (json.contains("sections"))
    for (const Json& section : json["sections"])
      measurement.sections.push_back(sectionFrom(section));
  if (json.contains("profileMm")) measurement.profile = profileFrom(json["profileMm"]);
  const bool along = *kind == MeasurementKind::Profile || *kind == MeasurementKind::Stenosis;
  if (measurement.places.size() != placesOf(*kind) ||
      measurement.sections.size() != sectionsOf(*kind) ||
      (along ? measurement.profile.size() < 2 : !measurement.profile.empty()))
    throw std::out_of_range("not of its kind");
  return measurement;
}

/// How many entries of a list could not be read.
template <class Entry>
std::size_t readList(const Json& list, std::vector<Entry>& to, Entry (*read)(const Json&)) {
  std::size_t lost = 0;
  for (const Json& each : list) {
    try {
      to.push_back(read(each));
    } catch (const Json::exception&) {
      ++lost;
    } catch (const std::out_of_range&) {
      ++lost;
    }
  }
  return lost;
}

int scoreFrom(const Json& json) {
  const auto score = json.get<std::int64_t>();
  if (!json.is_number_integer() || score < 0 || score > kBestScore)
    throw std::out_of_range("no score");
  return static_cast<int>(score);
}

ReviewRemark remarkFrom(const Json& json) {
  return {pointsFrom(json.at("placeMm")).at(0), scoreFrom(json.at("score")),
          json.at("text").get<std::string>()};
}

SeenPlace seenFrom(const Json& json) {
  const auto kind = doubtKindOf(json.at("kind").get<std::string>());
  if (!kind) throw std::out_of_range("no such kind");
  return {*kind, pointsFrom(json.at("placeMm")).at(0)};
}

/// @returns how many of its entries could not be read   @throws as measurementFrom()
std::size_t readReview(const Json& json, CaseReview& review) {
  std::size_t lost = 0;
  if (json.contains("remarks")) lost += readList(json["remarks"], review.remarks, remarkFrom);
  if (json.contains("seen")) lost += readList(json["seen"], review.seen, seenFrom);
  const auto verdict = verdictOf(json.at("verdict").get<std::string>());
  if (!verdict) throw std::out_of_range("no such verdict");
  const int score = scoreFrom(json.at("score"));
  if (json.contains("key")) review.key = json["key"].get<std::string>();
  review.verdict = *verdict;
  review.score = score;
  return lost;
}

}  // namespace

std::string notesToJson(const CaseNotes& notes) {
  Json json = Json::object();
  for (const Measurement& measurement : notes.measurements)
    json["measurements"].push_back(toJson(measurement));
  if (!notes.review.empty()) json["review"] = reviewJson<Json>(notes.review, "placeMm");
  return json.dump();
}

CaseNotes notesFromJson(const std::string& text, std::vector<std::string>& warnings) {
  CaseNotes notes;
  const Json json = parseJson<Json>(text);
  if (!json.is_object()) {
    warnings.emplace_back("what was noted in the case is damaged: it was left out");
    return notes;
  }
  const std::size_t lost = json.contains("measurements")
                               ? readList(json["measurements"], notes.measurements, measurementFrom)
                               : 0;
  if (lost > 0)
    warnings.push_back(std::to_string(lost) +
                       (lost == 1
                            ? " measurement of the case cannot be read: it was left out"
                            : " measurements of the case cannot be read: they were left out"));
  if (!json.contains("review")) return notes;
  bool whole = false;
  try {
    whole = readReview(json["review"], notes.review) == 0;
  } catch (const Json::exception&) {
    // Said below.
  } catch (const std::out_of_range&) {
    // Said below.
  }
  if (!whole) warnings.emplace_back("the review of the case is damaged: a part of it was left out");
  return notes;
}

}  // namespace angiomesh
