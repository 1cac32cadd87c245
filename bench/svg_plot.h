// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace angiomesh::bench {

struct PlotSeries {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< both above 0
};

/// Lines over two logarithmic axes.
struct PlotPanel {
  std::string title, xName, yName;
  std::vector<PlotSeries> series;
};

/// The panels below one another as an SVG file's text.
std::string svgOf(const std::vector<PlotPanel>& panels);

}  // namespace angiomesh::bench
