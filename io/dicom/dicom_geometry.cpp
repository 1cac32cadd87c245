// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/formatted.h"
#include "core/base/statistics.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/slice_orientation.h"

namespace angiomesh {
namespace {

// Distances are written with a few digits only: the grid may miss a slice by this much of the
// spacing without a word, and by kLargestUneven with a warning.
constexpr double kEven = 0.01;
constexpr double kLargestUneven = 0.1;
// The same for a shift within the slice's plane, in pixels.
constexpr double kStraight = 0.1;
constexpr double kLargestShift = 0.5;
// Gaps that are whole multiples of the usual one to this part of it come from missing slices.
constexpr double kWholeMultiple = 0.1;
constexpr double kSquare = 1e-3;
constexpr double kSamePlaceMm = 1e-3;
// Resampling makes at most so many slices of each that is there.
constexpr double kMostNewSlices = 8.0;

std::string mm(double value) { return formatted("%.4g mm", value); }

/// Looks through one stack and gathers what it finds.
class Doctor {
 public:
  Doctor(const DicomStack& stack, bool evenOut) : stack_(stack), evenOut_(evenOut) {
    grid_.findings = stack.findings;
  }

  StackGrid examine() {
    if (!stack_.frames.empty() && looksLikeSlices()) {
      placeGrid();
      if (stack_.frames.size() < 2) {
        refuse(FindingKind::SingleSlice, "a single slice (" + sizeText() + ")", {1},
               frameName(stack_, stack_.frames[0]));
      } else {
        examineDistances();
        examineShift();
      }
      examineValues();
    }
    return std::move(grid_);
  }

 private:
  void add(FindingKind kind, const std::string& text) {
    grid_.findings.push_back({kind, false, text, {}, {}});
  }
  void refuse(FindingKind kind, const std::string& text, std::vector<int> slices,
              const std::string& names) {
    grid_.findings.push_back({kind, true, text, std::move(slices), names});
  }
  [[nodiscard]] std::string pairNames(std::size_t a, std::size_t b) const {
    return frameName(stack_, stack_.frames[a]) + " and " + frameName(stack_, stack_.frames[b]);
  }
  static std::string pairText(std::size_t a, std::size_t b) {
    return "slices " + std::to_string(a + 1) + " and " + std::to_string(b + 1);
  }
  static std::vector<int> pairOf(std::size_t a, std::size_t b) {
    return {static_cast<int>(a) + 1, static_cast<int>(b) + 1};
  }
  [[nodiscard]] std::string sizeText() const {
    const DicomFile& file = stack_.fileOf(stack_.frames.front());
    return std::to_string(file.columns) + " x " + std::to_string(file.rows);
  }

  /// False when no grid can be laid through the images at all.
  bool looksLikeSlices() {
    const DicomFrame& first = stack_.frames.front();
    const DicomFile& file = stack_.fileOf(first);
    const std::string name = frameName(stack_, first);
    grid_.geometry.size = {file.columns, file.rows, static_cast<int>(stack_.frames.size())};
    if (file.samples != 1) {
      refuse(FindingKind::ColourImage, "colour images (" + sizeText() + ")", {}, name);
      return false;
    }
    if (file.mosaic) {
      refuse(FindingKind::MosaicImage, "mosaics, pictures that hold slices as tiles", {}, name);
      return false;
    }
    if (!first.placed) {
      refuse(FindingKind::NoPosition,
             file.frames > 1
                 ? "a multi-frame image that does not state the position of each frame"
                 : "the position, orientation or pixel spacing of the slices is not stated",
             {}, name);
      return false;
    }
    const double skew =
        std::fabs(first.alongRow.stableNormalized().dot(first.alongColumn.stableNormalized()));
    if (!(first.alongRow.norm() > 0.5) || !(first.alongColumn.norm() > 0.5) || skew > kSquare) {
      refuse(FindingKind::NoPosition, "the stated rows and columns are not at right angles", {},
             name);
      return false;
    }
    return true;
  }

  void placeGrid() {
    const DicomFrame& first = stack_.frames.front();
    Geometry& g = grid_.geometry;
    normal_ = sliceNormal(first);
    const Eigen::Vector3d x = first.alongRow.stableNormalized();
    g.spacing = {first.spacingX, first.spacingY, 1.0};
    g.origin = first.position;
    g.direction.col(0) = x;
    g.direction.col(1) = normal_.cross(x);
    g.direction.col(2) = normal_;
    g.direction.array() += 0.0;  // -0 becomes 0
    for (std::size_t i = 0; i < stack_.frames.size(); ++i) {
      heights_.push_back((stack_.frames[i].position - first.position).dot(normal_));
      grid_.slices.push_back({i, 0.0});
    }
  }

  void examineDistances() {
    std::vector<double> gaps;
    for (std::size_t i = 1; i < heights_.size(); ++i) gaps.push_back(heights_[i] - heights_[i - 1]);
    std::vector<double> sample = gaps;
    const double usual = upperMedian(sample);
    const double spacing = heights_.back() / static_cast<double>(gaps.size());
    if (spacing > 0.0) grid_.geometry.spacing[2] = spacing;
    std::size_t doubled = 0;
    for (std::size_t i = 0; i < gaps.size(); ++i)
      if (gaps[i] < 0.01 * usual || gaps[i] < kSamePlaceMm)
        if (++doubled == 1)
          refuse(FindingKind::DuplicatePosition,
                 "two slices lie in one place, " + pairText(i, i + 1) + " are " + mm(gaps[i]) +
                     " apart, and nothing tells which belongs to the volume",
                 pairOf(i, i + 1), pairNames(i, i + 1));
    if (doubled > 0) return;
    double uneven = 0.0;
    for (std::size_t i = 0; i < heights_.size(); ++i)
      uneven = std::max(uneven, std::fabs(heights_[i] - static_cast<double>(i) * spacing));
    if (uneven <= kEven * spacing) return;
    if (uneven <= kLargestUneven * spacing && !evenOut_) {
      add(FindingKind::UnevenSpacing, "the distance between slices varies: slices lie up to " +
                                          mm(uneven) + " beside an even grid of " + mm(spacing));
      return;
    }
    unevenGaps(gaps, usual);
  }

  /// The gaps that are not the usual one, largest first.
  static std::vector<std::size_t> oddGaps(const std::vector<double>& gaps, double usual) {
    std::vector<std::size_t> odd;
    for (std::size_t i = 0; i < gaps.size(); ++i)
      if (std::fabs(gaps[i] - usual) > kEven * usual) odd.push_back(i);
    std::stable_sort(odd.begin(), odd.end(), [&](std::size_t a, std::size_t b) {
      return std::fabs(gaps[a] - usual) > std::fabs(gaps[b] - usual);
    });
    return odd;
  }

  void unevenGaps(const std::vector<double>& gaps, double usual) {
    double missing = 0.0;
    bool whole = true;
    for (const double gap : gaps) {
      const double steps = std::round(gap / usual);
      whole = whole && steps >= 1.0 && std::fabs(gap / usual - steps) <= kWholeMultiple;
      missing += steps - 1.0;
    }
    whole = whole && missing >= 1.0;
    Finding finding;
    finding.kind = whole ? FindingKind::MissingSlices : FindingKind::UnevenSpacing;
    finding.text = whole ? std::to_string(static_cast<long long>(missing)) +
                               (missing > 1.0 ? " slices are missing: " : " slice is missing: ")
                         : std::string("the slices are uneven: ");
    const std::vector<std::size_t> odd = oddGaps(gaps, usual);
    for (std::size_t n = 0; n < odd.size(); ++n) {
      const std::size_t i = odd[n];
      finding.slices.push_back(static_cast<int>(i) + 1);
      if (n >= 3) continue;
      finding.text += (n > 0 ? ", " : "") + mm(gaps[i]) + " between " + pairText(i, i + 1);
      finding.names += (n > 0 ? "; " : "") + pairNames(i, i + 1);
    }
    if (odd.size() > 3)
      finding.text += " and in " + std::to_string(odd.size() - 3) + " more places";
    finding.text += ", but " + mm(usual) + " between most";
    finding.refuses = !evenOut_;
    if (evenOut_) resample(whole, missing, gaps, finding);
    grid_.findings.push_back(std::move(finding));
  }

  void resample(bool whole, double missing, const std::vector<double>& gaps, Finding& finding) {
    const double extent = heights_.back();
    const auto there = static_cast<double>(gaps.size());
    double steps = there + missing;
    if (!whole) steps = std::ceil(extent / *std::min_element(gaps.begin(), gaps.end()) - kEven);
    if (!(steps <= kMostNewSlices * there)) {
      finding.refuses = true;
      finding.text += ", too far apart to be resampled";
      return;
    }
    const double spacing = extent / steps;
    grid_.geometry.spacing[2] = spacing;
    grid_.slices.clear();
    std::size_t below = 0;
    int blended = 0;
    for (int k = 0; k <= static_cast<int>(steps); ++k) {
      const double height = std::min(k * spacing, extent);
      while (below + 2 < heights_.size() && heights_[below + 1] <= height) ++below;
      double weight = (height - heights_[below]) / (heights_[below + 1] - heights_[below]);
      SliceBlend blend{below, std::clamp(weight, 0.0, 1.0)};
      if (blend.weight > 1.0 - kEven) blend = {below + 1, 0.0};
      if (blend.weight < kEven) blend.weight = 0.0;
      blended += blend.weight > 0.0 ? 1 : 0;
      grid_.slices.push_back(blend);
    }
    grid_.geometry.size[2] = static_cast<int>(grid_.slices.size());
    finding.text += ": resampled to " + std::to_string(grid_.slices.size()) + " slices, " +
                    mm(spacing) + " apart, " + std::to_string(blended) +
                    " of them interpolated from their neighbours";
  }

  void examineShift() {
    const std::vector<DicomFrame>& frames = stack_.frames;
    const DicomFrame& first = frames.front();
    const double pixel = std::min(first.spacingX, first.spacingY);
    double largest = 0.0;
    std::size_t at = 0;
    for (std::size_t i = 1; i < frames.size(); ++i) {
      const double shift = (frames[i].position - first.position - heights_[i] * normal_).norm();
      if (shift > largest) {
        largest = shift;
        at = i;
      }
    }
    if (largest <= kStraight * pixel) return;
    if (largest <= kLargestShift * pixel) {
      add(FindingKind::ShiftedSlices,
          "the slices are shifted in their plane by up to " + mm(largest));
      return;
    }
    const double angle = std::atan2(largest, heights_[at]) * 180.0 / std::numbers::pi;
    refuse(FindingKind::GantryTilt,
           "the stack of slices leans (gantry tilt) by " + formatted("%.1f", angle) +
               " degrees: " + pairText(0, at) + " are " + mm(largest) + " beside each other and " +
               mm(heights_[at]) + " apart",
           pairOf(0, at), pairNames(0, at));
  }

  void examineValues() {
    const std::vector<DicomFrame>& frames = stack_.frames;
    const DicomFrame& first = frames.front();
    const auto scaledAsFirst = [&](const DicomFrame& frame) {
      return frame.slope == first.slope && frame.intercept == first.intercept;
    };
    if (!std::all_of(frames.begin(), frames.end(), scaledAsFirst))
      add(FindingKind::VaryingRescale,
          "the rescale slope or intercept varies from slice to slice (applied)");
    const auto any = [&](bool DicomFile::*flag) {
      return std::any_of(frames.begin(), frames.end(),
                         [&](const DicomFrame& frame) { return stack_.fileOf(frame).*flag; });
    };
    if (any(&DicomFile::inverted))
      add(FindingKind::InvertedValues,
          "small values are meant to be bright (MONOCHROME1): values are kept, so vessels that "
          "look bright on a viewing station need vesselness.polarity = dark");
    if (any(&DicomFile::table))
      add(FindingKind::ValueTable, "the file's table of values (Modality LUT) is not applied");
  }

  const DicomStack& stack_;
  bool evenOut_;
  StackGrid grid_;
  Eigen::Vector3d normal_ = Eigen::Vector3d::UnitZ();
  std::vector<double> heights_;
};

}  // namespace

StackGrid gridOfStack(const DicomStack& stack, bool evenOut) {
  return Doctor(stack, evenOut).examine();
}

const Finding* StackGrid::refusal() const {
  // What cannot be helped comes before what resampling helps.
  for (const bool helpable : {false, true})
    for (const Finding& finding : findings)
      if (finding.refuses && canBeEvenedOut(finding.kind) == helpable) return &finding;
  return nullptr;
}

}  // namespace angiomesh
