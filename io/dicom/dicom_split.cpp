// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/formatted.h"
#include "core/base/statistics.h"
#include "io/dicom/dicom_series.h"
#include "io/dicom/slice_orientation.h"

namespace angiomesh {
namespace {

// Direction cosines are written with about six digits.
constexpr double kSameDirection = 1e-3;
constexpr double kSameSpacing = 1e-3;
constexpr double kSamePlaceMm = 1e-3;

using Frames = std::vector<DicomFrame>;

std::string sizeOf(const DicomFile& file) {
  return std::to_string(file.columns) + " x " + std::to_string(file.rows);
}

bool sameSize(const DicomFile& a, const DicomFile& b) {
  return a.columns == b.columns && a.rows == b.rows && a.samples == b.samples;
}

bool sameDirection(const DicomFrame& a, const DicomFrame& b) {
  return (a.alongRow - b.alongRow).norm() <= kSameDirection &&
         (a.alongColumn - b.alongColumn).norm() <= kSameDirection;
}

bool sameSpacing(const DicomFrame& a, const DicomFrame& b) {
  return std::fabs(a.spacingX / b.spacingX - 1.0) <= kSameSpacing &&
         std::fabs(a.spacingY / b.spacingY - 1.0) <= kSameSpacing;
}

/// Whether two files of one instance UID are one image that is there twice: writers of research
/// data give all slices the same one.
bool isCopyOf(const DicomFrame& a, const DicomFrame& b) {
  if (a.placed != b.placed) return false;
  if (a.placed && ((a.position - b.position).norm() > kSamePlaceMm || !sameDirection(a, b)))
    return false;
  return a.instanceNumber == b.instanceNumber && a.split == b.split;
}

/// Files that are there twice, by their instance UID and their place, are used once.
void dropCopies(DicomSeries& series) {
  std::vector<const DicomFrame*> frameOf(series.files.size(), nullptr);
  for (const DicomFrame& frame : series.frames)
    if (frameOf[frame.file] == nullptr) frameOf[frame.file] = &frame;
  std::map<std::string, std::vector<std::size_t>> kept;
  std::vector<bool> isCopy(series.files.size(), false);
  Finding finding{FindingKind::RepeatedFile, false, {}, {}, {}};
  std::size_t copies = 0, sameUid = 0;
  for (std::size_t i = 0; i < series.files.size(); ++i) {
    const std::string& uid = series.files[i].instanceUid;
    if (uid.empty() || frameOf[i] == nullptr) continue;
    std::vector<std::size_t>& others = kept[uid];
    isCopy[i] = std::any_of(others.begin(), others.end(), [&](std::size_t other) {
      return isCopyOf(*frameOf[i], *frameOf[other]);
    });
    if (!isCopy[i]) {
      sameUid += others.empty() ? 0 : 1;
      others.push_back(i);
      continue;
    }
    if (++copies <= 3)
      finding.names += (copies > 1 ? ", " : "") + series.files[i].path.filename().string();
  }
  if (sameUid > 0)
    series.findings.push_back({FindingKind::RepeatedUid,
                               false,
                               std::to_string(sameUid) +
                                   " images have the instance UID of another one, which lies "
                                   "elsewhere: all are used, by their positions",
                               {},
                               {}});
  if (copies == 0) return;
  series.frames.erase(std::remove_if(series.frames.begin(), series.frames.end(),
                                     [&](const DicomFrame& frame) { return isCopy[frame.file]; }),
                      series.frames.end());
  finding.text =
      std::to_string(copies) + " images that are there twice (same instance UID) were used once";
  series.findings.push_back(std::move(finding));
}

/// Frames that may lie in one grid.
struct Group {
  Frames frames;
  std::string label;
};

struct Differences {
  bool size = false, direction = false, spacing = false, placed = false, reference = false;
};

/// Frames of reference that differ belong to volumes of their own where each has slices of its own.
/// Where a slice stands alone in its frame, as some archives leave it, or names none, the frames
/// say nothing: they are forgotten, with a note.
void forgetStrayReferences(DicomSeries& series) {
  std::map<std::string, std::size_t> counts;
  for (const DicomFrame& frame : series.frames) ++counts[frame.frameOfReference];
  const auto several = std::count_if(counts.begin(), counts.end(), [](const auto& one) {
    return !one.first.empty() && one.second > 1;
  });
  if (counts.size() < 2 || several > 1) return;
  for (DicomFrame& frame : series.frames) frame.frameOfReference.clear();
  const std::size_t named = counts.size() - counts.count("");
  const std::string what = counts.count("") == 0
                               ? std::to_string(named) + " frames of reference"
                               : std::to_string(counts[""]) + " images state no frame of reference";
  series.findings.push_back(
      {FindingKind::MixedReference,
       false,
       (counts.count("") == 0 ? "the images of the series state " + what : what) +
           ": they are taken as one volume, by their positions",
       {},
       {}});
}

std::vector<Group> groupAlike(const DicomSeries& series, Differences& differences) {
  std::vector<Group> groups;
  for (const DicomFrame& frame : series.frames) {
    const DicomFile& file = series.files[frame.file];
    const auto fits = [&](const Group& group) {
      const DicomFrame& other = group.frames.front();
      return sameSize(file, series.files[other.file]) && frame.placed == other.placed &&
             sameDirection(frame, other) && sameSpacing(frame, other) &&
             frame.frameOfReference == other.frameOfReference;
    };
    const auto found = std::find_if(groups.begin(), groups.end(), fits);
    if (found != groups.end()) {
      found->frames.push_back(frame);
      continue;
    }
    if (!groups.empty()) {
      const DicomFrame& other = groups.front().frames.front();
      differences.size |= !sameSize(file, series.files[other.file]);
      differences.placed |= frame.placed != other.placed;
      differences.direction |= frame.placed && other.placed && !sameDirection(frame, other);
      differences.spacing |= frame.placed && other.placed && !sameSpacing(frame, other);
      differences.reference |= frame.frameOfReference != other.frameOfReference;
    }
    groups.push_back({{frame}, {}});
  }
  return groups;
}

std::string spacingText(const DicomFrame& frame) {
  return formatted("pixels of %.4g x %.4g mm", frame.spacingX, frame.spacingY);
}

void labelGroups(std::vector<Group>& groups, const DicomSeries& series,
                 const Differences& differences) {
  for (Group& group : groups) {
    const DicomFrame& frame = group.frames.front();
    const auto add = [&](const std::string& text) {
      group.label += (group.label.empty() ? "" : ", ") + text;
    };
    if (differences.size) add(sizeOf(series.files[frame.file]));
    if (differences.placed && !frame.placed) add("without position");
    if (differences.direction && frame.placed)
      add(orientationText(frame.alongRow, frame.alongColumn));
    if (differences.spacing && frame.placed) add(spacingText(frame));
  }
}

Finding mixedFinding(const std::vector<Group>& groups, const Differences& differences) {
  Finding finding;
  finding.kind = differences.size                              ? FindingKind::MixedSize
                 : differences.direction || differences.placed ? FindingKind::MixedOrientation
                 : differences.spacing                         ? FindingKind::MixedSpacing
                                                               : FindingKind::SeveralVolumes;
  std::string what;
  for (const auto& [differ, name] : {std::pair{differences.size, "size"},
                                     {differences.direction, "orientation"},
                                     {differences.spacing, "pixel spacing"},
                                     {differences.placed, "having a position"},
                                     {differences.reference, "frame of reference"}})
    if (differ) what += (what.empty() ? "" : " and ") + std::string(name);
  finding.text = "the images of the series differ in " + what + " (";
  for (std::size_t i = 0; i < groups.size() && i < 6; ++i)
    finding.text += (i > 0 ? "; " : "") + std::to_string(groups[i].frames.size()) + " images" +
                    (groups[i].label.empty() ? "" : " of " + groups[i].label);
  finding.text += groups.size() > 6 ? "; ...)" : ")";
  finding.text += ": split into " + std::to_string(groups.size()) + " volumes";
  return finding;
}

void sortAlongNormal(Frames& frames) {
  const Eigen::Vector3d normal = sliceNormal(frames.front());
  std::stable_sort(frames.begin(), frames.end(), [&](const DicomFrame& a, const DicomFrame& b) {
    const double ha = a.position.dot(normal);
    const double hb = b.position.dot(normal);
    return ha != hb ? ha < hb : a.instanceNumber < b.instanceNumber;
  });
}

/// The number of the place of each of the sorted frames.
std::vector<int> placesOf(const Frames& frames) {
  const Eigen::Vector3d normal = sliceNormal(frames.front());
  std::vector<double> gaps;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double gap = (frames[i].position - frames[i - 1].position).dot(normal);
    if (gap > kSamePlaceMm) gaps.push_back(gap);
  }
  double tolerance = kSamePlaceMm;
  if (!gaps.empty()) tolerance = std::max(tolerance, 0.01 * upperMedian(gaps));
  std::vector<int> places(frames.size(), 0);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const double gap = (frames[i].position - frames[i - 1].position).dot(normal);
    places[i] = places[i - 1] + (gap > tolerance ? 1 : 0);
  }
  return places;
}

/// Frames by a key, in the order of the keys' first appearance by instance number; empty when the
/// key does not tell the frames of each place apart.
std::vector<Group> partition(const Frames& frames, const std::vector<int>& places,
                             const std::vector<std::string>& keys, std::size_t mostInOnePlace) {
  std::map<std::string, std::vector<std::size_t>> members;
  for (std::size_t i = 0; i < frames.size(); ++i) members[keys[i]].push_back(i);
  // A time or number that each slice has for itself is no mark of a volume.
  if (members.size() < 2 || members.size() > 2 * mostInOnePlace) return {};
  std::vector<std::pair<int, Group>> ordered;
  for (const auto& [key, list] : members) {
    if (list.size() < 2) return {};
    Group group;
    group.label = key;
    int earliest = frames[list.front()].instanceNumber;
    for (std::size_t m = 0; m < list.size(); ++m) {
      if (m > 0 && places[list[m]] == places[list[m - 1]]) return {};
      group.frames.push_back(frames[list[m]]);
      earliest = std::min(earliest, frames[list[m]].instanceNumber);
    }
    ordered.emplace_back(earliest, std::move(group));
  }
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Group> groups;
  for (auto& [number, group] : ordered) groups.push_back(std::move(group));
  return groups;
}

std::vector<std::string> keysOf(const Frames& frames, std::size_t a, std::size_t b) {
  std::vector<std::string> keys;
  for (const DicomFrame& frame : frames) {
    std::string key = std::string(kSplitNames[a]) + " " + frame.split[a];
    if (b != a) key += ", " + std::string(kSplitNames[b]) + " " + frame.split[b];
    keys.push_back(std::move(key));
  }
  return keys;
}

/// The rank of each frame among those in its place, where whole blocks of instance numbers have one
/// rank: a series that was written volume after volume.
std::vector<std::string> blocksOf(const Frames& frames, const std::vector<int>& places) {
  std::vector<int> rank(frames.size(), 0);
  for (std::size_t i = 1; i < frames.size(); ++i)
    rank[i] = places[i] == places[i - 1] ? rank[i - 1] + 1 : 0;
  std::map<int, std::pair<int, int>> range;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const int number = frames[i].instanceNumber;
    const auto [entry, isNew] = range.emplace(rank[i], std::pair{number, number});
    if (isNew) continue;
    entry->second.first = std::min(entry->second.first, number);
    entry->second.second = std::max(entry->second.second, number);
  }
  std::vector<std::string> keys;
  for (auto a = range.begin(); a != range.end(); ++a)
    for (auto b = std::next(a); b != range.end(); ++b)
      if (a->second.second >= b->second.first) return keys;
  for (const int r : rank) keys.push_back("block " + std::to_string(r + 1));
  return keys;
}

/// Splits frames of which several lie in each place; one group when nothing tells them apart.
std::vector<Group> splitPlaces(Group group, std::string& by) {
  const std::vector<int> places = placesOf(group.frames);
  std::size_t most = 1;
  for (std::size_t i = 0, run = 1; i + 1 < places.size(); ++i) {
    run = places[i + 1] == places[i] ? run + 1 : 1;
    most = std::max(most, run);
  }
  std::vector<Group> groups;
  if (most > 1) {
    for (std::size_t a = 0; a < kSplitNames.size() && groups.empty(); ++a) {
      by = kSplitNames[a];
      groups = partition(group.frames, places, keysOf(group.frames, a, a), most);
    }
    for (std::size_t a = 0; a < kSplitNames.size() && groups.empty(); ++a)
      for (std::size_t b = a + 1; b < kSplitNames.size() && groups.empty(); ++b) {
        by = std::string(kSplitNames[a]) + " and " + kSplitNames[b];
        groups = partition(group.frames, places, keysOf(group.frames, a, b), most);
      }
    if (const auto keys = blocksOf(group.frames, places); groups.empty() && !keys.empty()) {
      by = "instance numbers";
      groups = partition(group.frames, places, keys, most);
    }
  }
  if (groups.empty()) {
    by.clear();
    return {std::move(group)};
  }
  for (Group& one : groups)
    if (!group.label.empty()) one.label = group.label + ", " + one.label;
  return groups;
}

DicomStack stackOf(const DicomSeries& series, Group group) {
  DicomStack stack;
  stack.uid = series.uid;
  stack.description = series.description;
  stack.modality = series.modality;
  stack.number = series.number;
  stack.date = series.date;
  stack.label = std::move(group.label);
  stack.findings = series.findings;
  std::map<std::size_t, std::size_t> renumbered;
  for (DicomFrame& frame : group.frames) {
    const auto [entry, isNew] = renumbered.emplace(frame.file, stack.files.size());
    if (isNew) stack.files.push_back(series.files[frame.file]);
    frame.file = entry->second;
  }
  stack.frames = std::move(group.frames);
  return stack;
}

}  // namespace

std::vector<DicomStack> splitSeries(DicomSeries series) {
  if (!series.segments.empty()) {
    series.findings.push_back({FindingKind::Segmentation,
                               true,
                               "a DICOM segmentation (SEG) of " +
                                   std::to_string(series.segments.size()) +
                                   " segments: give the file itself",
                               {},
                               {}});
    return {stackOf(series, {series.frames, {}})};
  }
  dropCopies(series);
  if (series.frames.empty()) return {stackOf(series, {})};
  forgetStrayReferences(series);
  Differences differences;
  std::vector<Group> groups = groupAlike(series, differences);
  labelGroups(groups, series, differences);
  if (groups.size() > 1) series.findings.push_back(mixedFinding(groups, differences));

  std::vector<DicomStack> stacks;
  for (Group& group : groups) {
    std::vector<Group> parts;
    std::string by;
    if (group.frames.front().placed) {
      sortAlongNormal(group.frames);
      parts = splitPlaces(std::move(group), by);
    } else {
      parts.push_back(std::move(group));
    }
    for (Group& part : parts) {
      stacks.push_back(stackOf(series, std::move(part)));
      if (parts.size() > 1)
        stacks.back().findings.push_back(
            {FindingKind::SeveralVolumes,
             false,
             std::to_string(parts.size()) + " images lie in each place and differ in " + by +
                 ": split into " + std::to_string(parts.size()) + " volumes",
             {},
             {}});
    }
  }
  for (std::size_t i = 0; i < stacks.size() && stacks.size() > 1; ++i)
    stacks[i].part = static_cast<int>(i) + 1;
  return stacks;
}

std::string DicomStack::id() const { return part == 0 ? uid : uid + "/" + std::to_string(part); }

std::string frameName(const DicomStack& stack, const DicomFrame& frame) {
  const DicomFile& file = stack.fileOf(frame);
  std::string name = file.path.filename().string();
  if (file.frames > 1) name += " frame " + std::to_string(frame.index + 1);
  return name;
}

}  // namespace angiomesh
