// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "core/base/statistics.h"
#include "io/dicom/dicom.h"
#include "io/dicom/dicom_series.h"

namespace angiomesh {
namespace {

std::array<double, 2> rangeOf(const DicomFrame& frame, std::vector<float> values) {
  if (!frame.windows.empty()) return frame.windows.front().range();
  const auto low = static_cast<double>(lowerPercentile(values, 0.01));
  return {low, static_cast<double>(lowerPercentile(values, 0.998))};
}

/// Mean of the pixels that fall into each pixel of the picture.
Picture shrink(const std::vector<float>& values, const DicomFile& file, const DicomFrame& frame,
               int size, std::array<double, 2> range) {
  const double width = file.columns * frame.spacingX;
  const double height = file.rows * frame.spacingY;
  const double step = std::max(width, height) / size;
  Picture picture;
  picture.width = std::clamp(static_cast<int>(std::lround(width / step)), 1, size);
  picture.height = std::clamp(static_cast<int>(std::lround(height / step)), 1, size);
  const auto edge = [](int i, int count, int whole) {
    return static_cast<int>(static_cast<std::int64_t>(i) * whole / count);
  };
  const double scale = range[1] > range[0] ? 255.0 / (range[1] - range[0]) : 0.0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const int x0 = edge(x, picture.width, file.columns);
      const int x1 = std::max(x0 + 1, edge(x + 1, picture.width, file.columns));
      const int y0 = edge(y, picture.height, file.rows);
      const int y1 = std::max(y0 + 1, edge(y + 1, picture.height, file.rows));
      double sum = 0.0;
      for (int j = y0; j < y1; ++j)
        for (int i = x0; i < x1; ++i)
          sum += static_cast<double>(
              values[static_cast<std::size_t>(j) * static_cast<std::size_t>(file.columns) +
                     static_cast<std::size_t>(i)]);
      const double mean = sum / ((x1 - x0) * (y1 - y0));
      const double grey = std::clamp((mean - range[0]) * scale, 0.0, 255.0);
      const double shown = file.inverted ? 255.0 - grey : grey;
      picture.rgb.insert(picture.rgb.end(), 3, static_cast<std::uint8_t>(std::lround(shown)));
    }
  return picture;
}

}  // namespace

Picture thumbnail(const ImageSummary& entry, int size) {
  if (!entry.stack || entry.stack->frames.empty()) return {};
  const DicomStack& stack = *entry.stack;
  const DicomFrame& frame = stack.frames[stack.frames.size() / 2];
  const DicomFile& file = stack.fileOf(frame);
  if (file.samples != 1) return {};
  try {
    const std::vector<float> values = readFrame(stack, frame);
    return shrink(values, file, frame, size, rangeOf(frame, values));
  } catch (const Error&) {
    return {};
  }
}

}  // namespace angiomesh
