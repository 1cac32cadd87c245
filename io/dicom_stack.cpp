// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "core/base/error.h"
#include "io/dicom_series.h"

namespace angiomesh {
namespace {

// Direction cosines are written with about six digits.
constexpr double kSameDirection = 1e-3;
// Distances are written with a few digits only: the grid may miss a slice by this much of the
// spacing without a word, and by kLargestUneven with a warning.
constexpr double kEven = 0.01;
constexpr double kLargestUneven = 0.1;
// The same for a shift within the slice's plane, in pixels.
constexpr double kStraight = 0.1;
constexpr double kLargestShift = 0.5;

std::string nameOf(const DicomFrame& frame) {
  std::string name = frame.file.filename().string();
  if (frame.framesInFile > 1) name += " (frame " + std::to_string(frame.index + 1) + ")";
  return name;
}

std::string pairOf(const DicomFrame& a, const DicomFrame& b) {
  return nameOf(a) + " and " + nameOf(b);
}

std::string mm(double value) {
  char text[32];
  std::snprintf(text, sizeof(text), "%.4g mm", value);
  return text;
}

void dropCopies(DicomSeries& series, std::vector<std::string>& warnings) {
  std::set<std::pair<std::string, int>> seen;
  const std::size_t before = series.frames.size();
  const auto copy = [&](const DicomFrame& frame) {
    return !frame.instanceUid.empty() && !seen.insert({frame.instanceUid, frame.index}).second;
  };
  series.frames.erase(std::remove_if(series.frames.begin(), series.frames.end(), copy),
                      series.frames.end());
  if (const std::size_t dropped = before - series.frames.size(); dropped > 0)
    warnings.push_back(std::to_string(dropped) +
                       " images that are there twice (same instance UID) were used once");
}

void checkAlike(const DicomSeries& series, const std::string& where) {
  const DicomFrame& first = series.frames.front();
  for (const DicomFrame& frame : series.frames) {
    if (frame.samples != 1)
      throw InputError("a colour image, " + nameOf(frame), where,
                       "give a series with one value per pixel");
    if (!frame.placed)
      throw InputError(
          "the position, orientation or pixel spacing is not stated in " + nameOf(frame), where,
          "give a series of slices (MR or CT) as the scanner wrote it");
    if (frame.columns != first.columns || frame.rows != first.rows)
      throw InputError("the slices differ in size: " + std::to_string(first.columns) + " x " +
                           std::to_string(first.rows) + " and " + std::to_string(frame.columns) +
                           " x " + std::to_string(frame.rows) + " in " + pairOf(first, frame),
                       where, "take the files that do not belong to the volume out of the folder");
    if ((frame.alongRow - first.alongRow).norm() > kSameDirection ||
        (frame.alongColumn - first.alongColumn).norm() > kSameDirection)
      throw InputError("the slices differ in orientation, " + pairOf(first, frame), where,
                       "take the files that do not belong to the volume out of the folder");
    if (std::fabs(frame.spacingX / first.spacingX - 1.0) > 1e-3 ||
        std::fabs(frame.spacingY / first.spacingY - 1.0) > 1e-3)
      throw InputError("the slices differ in pixel spacing: " + mm(first.spacingX) + " and " +
                           mm(frame.spacingX) + " in " + pairOf(first, frame),
                       where, "take the files that do not belong to the volume out of the folder");
  }
  const double skew = std::fabs(first.alongRow.normalized().dot(first.alongColumn.normalized()));
  if (!(first.alongRow.norm() > 0.5) || !(first.alongColumn.norm() > 0.5) || skew > kSameDirection)
    throw InputError("rows and columns are not at right angles in " + nameOf(first), where,
                     "give a series as the scanner wrote it");
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns the distance between slices.
double checkSpacing(const std::vector<DicomFrame>& frames, const std::vector<double>& heights,
                    const std::string& where, std::vector<std::string>& warnings) {
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights.size(); ++i) gaps.push_back(heights[i] - heights[i - 1]);
  const double usual = median(gaps);
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (gaps[i] < 0.01 * usual || gaps[i] < 1e-4)
      throw InputError(
          "two slices lie in one place, " + pairOf(frames[i], frames[i + 1]), where,
          "the series holds several time points or echoes, or a slice twice: split it");
  const double spacing = (heights.back() - heights.front()) / static_cast<double>(gaps.size());
  double uneven = 0.0;
  for (std::size_t i = 0; i < heights.size(); ++i)
    uneven = std::max(uneven,
                      std::fabs(heights[i] - heights.front() - static_cast<double>(i) * spacing));
  if (uneven <= kEven * spacing) return spacing;
  if (uneven <= kLargestUneven * spacing) {
    warnings.push_back("the distance between slices varies: slices lie up to " + mm(uneven) +
                       " beside an even grid of " + mm(spacing));
    return spacing;
  }
  std::size_t worst = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (std::fabs(gaps[i] - usual) > std::fabs(gaps[worst] - usual)) worst = i;
  throw InputError("slices are missing or uneven: " + mm(gaps[worst]) + " between " +
                       pairOf(frames[worst], frames[worst + 1]) + ", but " + mm(usual) +
                       " between most",
                   where, "add the missing slices, or resample the series to even distances");
}

void checkStraight(const std::vector<DicomFrame>& frames, const std::vector<double>& heights,
                   const Eigen::Vector3d& normal, const std::string& where,
                   std::vector<std::string>& warnings) {
  const DicomFrame& first = frames.front();
  const double pixel = std::min(first.spacingX, first.spacingY);
  double largest = 0.0;
  std::size_t at = 0;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double height = heights[i] - heights.front();
    const double shift = (frames[i].position - first.position - height * normal).norm();
    if (shift > largest) {
      largest = shift;
      at = i;
    }
  }
  if (largest <= kStraight * pixel) return;
  if (largest <= kLargestShift * pixel) {
    warnings.push_back("the slices are shifted in their plane by up to " + mm(largest));
    return;
  }
  const double angle =
      std::atan2(largest, heights[at] - heights.front()) * 180.0 / 3.14159265358979323846;
  char degrees[32];
  std::snprintf(degrees, sizeof(degrees), "%.1f", angle);
  throw InputError("the stack of slices leans (gantry tilt) by " + std::string(degrees) +
                       " degrees: " + pairOf(first, frames[at]) + " are " + mm(largest) +
                       " beside each other and " + mm(heights[at] - heights.front()) + " apart",
                   where, "resample the series to an upright stack with another program");
}

}  // namespace

Geometry stackFrames(DicomSeries& series, const std::string& where,
                     std::vector<std::string>& warnings) {
  dropCopies(series, warnings);
  checkAlike(series, where);
  std::vector<DicomFrame>& frames = series.frames;
  if (frames.size() < 2)
    throw InputError("a single slice (" + std::to_string(frames[0].columns) + " x " +
                         std::to_string(frames[0].rows) + ")",
                     where, "give the folder that holds the whole series");
  Geometry geometry;
  const Eigen::Vector3d x = frames[0].alongRow.normalized();
  const Eigen::Vector3d normal = x.cross(frames[0].alongColumn).normalized();
  std::stable_sort(frames.begin(), frames.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    return a.position.dot(normal) < b.position.dot(normal);
  });
  std::vector<double> heights;
  heights.reserve(frames.size());
  for (const DicomFrame& frame : frames) heights.push_back(frame.position.dot(normal));
  const DicomFrame& first = frames.front();
  geometry.spacing = {first.spacingX, first.spacingY,
                      checkSpacing(frames, heights, where, warnings)};
  checkStraight(frames, heights, normal, where, warnings);
  geometry.size = {first.columns, first.rows, static_cast<int>(frames.size())};
  geometry.origin = first.position;
  geometry.direction.col(0) = x;
  geometry.direction.col(1) = normal.cross(x);
  geometry.direction.col(2) = normal;
  geometry.direction.array() += 0.0;  // -0 becomes 0

  const auto scaledAsFirst = [&](const DicomFrame& frame) {
    return frame.slope == first.slope && frame.intercept == first.intercept;
  };
  if (!std::all_of(frames.begin(), frames.end(), scaledAsFirst))
    warnings.emplace_back("the rescale slope or intercept varies from slice to slice (applied)");
  if (series.inverted)
    warnings.emplace_back("small values are meant to be bright (MONOCHROME1): values are kept");
  return geometry;
}

}  // namespace angiomesh
