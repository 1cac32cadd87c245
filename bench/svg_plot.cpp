// SPDX-License-Identifier: BSD-3-Clause
#include "bench/svg_plot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/formatted.h"

namespace angiomesh::bench {
namespace {

constexpr double kWidth = 760.0, kHeight = 300.0;
constexpr double kLeft = 70.0, kRight = 290.0, kTop = 34.0, kBottom = 46.0;
constexpr std::array<const char*, 4> kColours{"#0b6e4f", "#1f77b4", "#c1440e", "#7a3b8f"};

/// Data to pixels along one axis.
struct Axis {
  double low = 1.0, high = 10.0, from = 0.0, to = 1.0;
  [[nodiscard]] double place(double value) const {
    return from + (to - from) * std::log(value / low) / std::log(high / low);
  }
};

std::string label(double x, double y, const char* anchor, const std::string& words) {
  return formatted("<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">%s</text>\n", x, y, anchor,
                   words.c_str());
}

std::string line(double x0, double y0, double x1, double y1) {
  return formatted("<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#ddd\"/>\n", x0,
                   y0, x1, y1);
}

std::string panel(const PlotPanel& p, double top) {
  std::set<double> ticks;
  double low = 1e300;
  double high = 0.0;
  for (const PlotSeries& s : p.series)
    for (const auto& [x, y] : s.points) {
      ticks.insert(x);
      low = std::min(low, y);
      high = std::max(high, y);
    }
  if (ticks.empty()) return {};
  const double bottom = top + kHeight - kBottom;
  const Axis across{*ticks.begin(), std::max(*ticks.rbegin(), *ticks.begin() * 1.01), kLeft,
                    kWidth - kRight};
  const Axis up{std::pow(10.0, std::floor(std::log10(low))),
                std::pow(10.0, std::floor(std::log10(high)) + 1.0), bottom, top + kTop};
  std::string out = label(kLeft, top + 20.0, "start", p.title);
  for (const double x : ticks) {
    out += line(across.place(x), bottom, across.place(x), up.to);
    out += label(across.place(x), bottom + 16.0, "middle", formatted("%g", x));
  }
  for (double y = up.low; y <= up.high * 1.01; y *= 10.0) {
    out += line(kLeft, up.place(y), across.to, up.place(y));
    out += label(kLeft - 6.0, up.place(y) + 4.0, "end", formatted("%g", y));
  }
  out += label(0.5 * (kLeft + across.to), bottom + 34.0, "middle", p.xName);
  out += formatted(
      "<text transform=\"translate(16 %.1f) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
      0.5 * (bottom + up.to), p.yName.c_str());
  double row = up.to + 8.0;
  for (std::size_t s = 0; s < p.series.size(); ++s) {
    const char* colour = kColours[s % kColours.size()];
    out += formatted("<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"2\" points=\"", colour);
    for (const auto& [x, y] : p.series[s].points)
      out += formatted("%.1f,%.1f ", across.place(x), up.place(y));
    out += "\"/>\n";
    for (const auto& [x, y] : p.series[s].points)
      out += formatted("<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3\" fill=\"%s\"/>\n", across.place(x),
                       up.place(y), colour);
    out += formatted("<rect x=\"%.1f\" y=\"%.1f\" width=\"14\" height=\"3\" fill=\"%s\"/>\n",
                     across.to + 16.0, row - 5.0, colour);
    out += label(across.to + 36.0, row, "start", p.series[s].name);
    row += 18.0;
  }
  return out;
}

}  // namespace

std::string svgOf(const std::vector<PlotPanel>& panels) {
  const double height = kHeight * static_cast<double>(panels.size());
  std::string out = formatted(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" height=\"%.0f\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%%\" height=\"100%%\" "
      "fill=\"white\"/>\n",
      kWidth, height);
  for (std::size_t n = 0; n < panels.size(); ++n)
    out += panel(panels[n], kHeight * static_cast<double>(n));
  return out + "</svg>\n";
}

}  // namespace angiomesh::bench
