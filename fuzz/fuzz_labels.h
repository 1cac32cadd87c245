// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <charconv>

#include "fuzz/fuzz_readers.h"
#include "io/scan/label_choice.h"

namespace angiomesh::fuzz {

/// The file's labels are values of voxels, each once for a layer, in ascending order.
inline void checkLabels(const std::vector<Label>& labels) {
  for (std::size_t n = 0; n < labels.size(); ++n) {
    expect(labels[n].value > 0 && labels[n].voxels > 0, "a label without voxels");
    if (n == 0) continue;
    const Label &a = labels[n - 1], &b = labels[n];
    expect(a.layer < b.layer || (a.layer == b.layer && a.value < b.value), "labels out of order");
  }
}

/// Some part of the choice says each of the chosen labels, and the mask has their voxels.
inline void checkMask(const LabelMask& mask, const std::string& choice) {
  expect(!mask.labels.empty(), "a mask without a label");
  std::size_t most = 0, sum = 0;
  for (const Label& label : mask.labels) {
    const auto says = [&](const std::string& text) {
      return !text.empty() && choice.find(text) != std::string::npos;
    };
    expect(
        choice.empty() || says(std::to_string(label.value)) || says(label.name) || says(label.id),
        "'" + choice + "' does not say the label " + std::to_string(label.value));
    most = std::max(most, label.voxels);
    sum += label.voxels;
  }
  const auto& voxels = mask.mask.voxels;
  const auto ones = static_cast<std::size_t>(std::count(voxels.begin(), voxels.end(), 1));
  const auto zeros = static_cast<std::size_t>(std::count(voxels.begin(), voxels.end(), 0));
  expect(ones + zeros == voxels.size(), "a mask of other values than 0 and 1");
  expect(voxels.size() == mask.mask.geometry.voxelCount(), "a mask that does not fill its grid");
  expect(most <= ones && ones <= sum, "a mask of other voxels than those of its labels");
}

inline void readChoice(const std::filesystem::path& path, const MaskChoice& choice) {
  attempt([&] {
    const LabelMask mask = readLabel(path, choice);
    must([&] { checkMask(mask, choice.label); });
  });
}

/// Each label that its value alone tells can be chosen by it, and by its name and id unless those
/// of another are alike.
inline void chooseEach(const std::filesystem::path& path, const std::vector<Label>& labels) {
  for (const Label& label : labels) {
    const std::string text = "value:" + std::to_string(label.value);
    const auto alike = std::count_if(labels.begin(), labels.end(), [&](const Label& other) {
      return other.value == label.value || other.name == text;
    });
    if (alike == 1)
      must([&] {
        const std::vector<Label> chosen = chosenLabels(labels, text, path);
        expect(chosen.size() == 1 && chosen[0].value == label.value, text + " is another label");
      });
    attempt([&] { static_cast<void>(chosenLabels(labels, "name:" + label.name, path)); });
    attempt([&] { static_cast<void>(chosenLabels(labels, "id:" + label.id, path)); });
  }
  if (labels.empty()) return;
  const std::string first = std::to_string(labels.front().value);
  readChoice(path, {first, {}});
  readChoice(path, {first + "," + std::to_string(labels.back().value), {}});
  if (!labels.back().name.empty()) readChoice(path, {labels.back().name, {}});
}

/// A segmentation that is no DICOM file. The first line of the input is the choice of --label, or
/// "=0.5" as --threshold.
inline void readLabelsInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = textOf(data, size);
  const std::size_t line = std::min(text.find('\n'), size);
  const std::string_view choice = text.substr(0, line);
  const std::size_t start = std::min(line + 1, size);
  const InputFile file(data + start, size - start, "");
  attempt([&] {
    if (imageFormat(file.path()).isDicom()) return;
    if (choice.starts_with("=")) {
      double least = 0.0;
      std::from_chars(choice.data() + 1, choice.data() + choice.size(), least);
      readChoice(file.path(), {"", least});
    } else {
      readChoice(file.path(), {std::string(choice), {}});
    }
    const std::vector<Label> labels = readLabels(file.path());
    must([&] { checkLabels(labels); });
    chooseEach(file.path(), labels);
    const int layers = segmentationLayers(file.path());
    attempt([&] { static_cast<void>(readLayer(file.path(), layers - 1)); });
  });
}

}  // namespace angiomesh::fuzz
