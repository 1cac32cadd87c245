// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "bench/peak_memory.h"
#include "bench/program.h"
#include "bench/stages.h"
#include "bench/svg_plot.h"
#include "core/base/formatted.h"
#include "core/base/parallel.h"

using namespace angiomesh;

namespace {

struct Options {
  std::vector<int> sizes{64, 96, 128, 192, 256};
  std::vector<int> threads{1, 2};
  int threadSize = 128, repeat = 3;
  double noise = 20.0;
  std::string only, output = "bench-results";
};

/// What was measured of one way; one entry for each repetition.
struct Measured {
  std::string stage, way;
  std::vector<double> milliseconds;
  double peakMb = -1.0;
  int iterations = 0;
};

struct Group {
  int size = 0, threads = 0;
  std::vector<std::vector<Measured>> stages;
};

/// Median over the repetitions of `way` to `ours`, each pair measured one after the other.
double ratio(const Measured& way, const Measured& ours) {
  std::vector<double> ratios;
  for (std::size_t n = 0; n < way.milliseconds.size(); ++n)
    ratios.push_back(way.milliseconds[n] / ours.milliseconds[n]);
  return bench::median(ratios);
}

/// Takes the times from Google Benchmark; the way is found again by its number, the benchmark's
/// name.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::vector<Measured>& into) : into_(into) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      Measured& m = into_.at(std::stoul(run.run_name.function_name));
      if (run.error_occurred) throw std::runtime_error(m.way + ": " + run.error_message);
      m.milliseconds.push_back(run.GetAdjustedRealTime());
      m.peakMb = std::max(m.peakMb, run.counters.at("peak_mb").value);
      m.iterations = static_cast<int>(run.counters.at("iterations").value);
      std::fprintf(stderr, "  %-32s %-44s %12.1f ms\n", m.stage.c_str(), m.way.c_str(),
                   m.milliseconds.back());
    }
  }

 private:
  std::vector<Measured>& into_;
};

void measureOnce(const bench::Stage& stage, bool reversed, std::vector<Measured>& into) {
  std::vector<std::size_t> order;
  for (std::size_t n = 0; n < stage.ways.size(); ++n) order.push_back(n);
  if (reversed) std::reverse(order.begin(), order.end());
  benchmark::ClearRegisteredBenchmarks();
  for (const std::size_t n : order) {
    const auto work = [&way = stage.ways[n]](benchmark::State& state) {
      int iterations = 0;
      const bench::PeakMemory memory;
      for ([[maybe_unused]] auto _ : state) iterations = way.run();
      state.counters["peak_mb"] = memory.addedMb();
      state.counters["iterations"] = iterations;
    };
    benchmark::RegisterBenchmark(std::to_string(n).c_str(), work)
        ->Iterations(1)
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  }
  Collector collector(into);
  benchmark::RunSpecifiedBenchmarks(&collector, "all");
}

Group measure(const Options& options, int size, int threads) {
  Group group{size, threads, {}};
  setThreads(threads);
  std::fprintf(stderr, "%d^3 voxels, %d threads\n", size, threads);
  for (const bench::Stage& stage : bench::segmentationStages(size, options.noise)) {
    if (stage.name.find(options.only) == std::string::npos) continue;
    std::vector<Measured> ways;
    for (const bench::Way& way : stage.ways) ways.push_back({stage.name, way.name, {}, -1.0, 0});
    // Every other time backwards: what disturbs the machine hits the first and the last alike.
    for (int n = 0; n < options.repeat; ++n) measureOnce(stage, n % 2 == 1, ways);
    group.stages.push_back(std::move(ways));
  }
  return group;
}

std::string stageTable(const Group& group) {
  const double volumeMb = 4.0 * group.size * group.size * group.size / (1 << 20);
  std::string out;
  out += formatted(
      "## Stages, %d^3 voxels, %d threads\n\n| stage | way | ms | times ours | iterations | ms "
      "per iteration | memory added, MB | volumes |\n|---|---|---|---|---|---|---|---|\n",
      group.size, group.threads);
  for (const auto& ways : group.stages)
    for (const Measured& m : ways) {
      out += formatted("| %s | %s | %.1f | %.2f |", m.stage.c_str(), m.way.c_str(),
                       bench::median(m.milliseconds), ratio(m, ways.front()));
      if (m.iterations > 0)
        out +=
            formatted(" %d | %.2f |", m.iterations, bench::median(m.milliseconds) / m.iterations);
      else
        out += " | |";
      if (m.peakMb >= 0.0)
        out += formatted(" %.0f | %.2f |\n", m.peakMb, m.peakMb / volumeMb);
      else
        out += " | |\n";
    }
  double sum = 0.0;
  int scales = 0;
  for (const auto& ways : group.stages)
    if (ways.front().stage.starts_with("vesselness")) {
      sum += ratio(ways[1], ways[0]);
      ++scales;
    }
  if (scales > 0)
    out +=
        formatted("\nVesselness, mean over the scales: ITK takes %.1f times ours.\n", sum / scales);
  return out + "\n";
}

/// Milliseconds of every way, one column for each group, and the same as panels of a plot.
std::string growthTable(const std::vector<Group>& groups, bool bySize,
                        std::vector<bench::PlotPanel>& panels) {
  std::string out = bySize ? "## Milliseconds against volume size\n\n| stage | way |"
                           : "## Milliseconds against threads\n\n| stage | way |";
  for (const Group& g : groups)
    out += formatted(bySize ? " %d^3 |" : " %d |", bySize ? g.size : g.threads);
  out += "\n|---|---|";
  for (std::size_t n = 0; n < groups.size(); ++n) out += "---|";
  out += "\n";
  for (std::size_t s = 0; s < groups.front().stages.size(); ++s) {
    bench::PlotPanel panel{groups.front().stages[s].front().stage,
                           bySize ? "voxels along each side" : "threads",
                           "ms",
                           {}};
    for (std::size_t w = 0; w < groups.front().stages[s].size(); ++w) {
      const Measured& first = groups.front().stages[s][w];
      out += formatted("| %s | %s |", first.stage.c_str(), first.way.c_str());
      bench::PlotSeries series{first.way, {}};
      for (const Group& g : groups) {
        const double ms = bench::median(g.stages[s][w].milliseconds);
        out += formatted(" %.1f |", ms);
        series.points.emplace_back(bySize ? g.size : g.threads, std::max(ms, 1e-3));
      }
      panel.series.push_back(std::move(series));
      out += "\n";
    }
    panels.push_back(std::move(panel));
  }
  return out + "\n";
}

void write(const std::filesystem::path& place, const std::string& text) {
  std::ofstream file(place);
  if (!(file << text && file.flush()))
    throw std::runtime_error("cannot write " + place.string() + ": check the permissions");
}

int run(Options options) {
  std::sort(options.sizes.begin(), options.sizes.end());
  std::sort(options.threads.begin(), options.threads.end());
  std::filesystem::create_directories(options.output);
  const std::filesystem::path folder = options.output;
  const int most = options.threads.back();
  std::vector<Group> bySize;
  for (const int size : options.sizes) bySize.push_back(measure(options, size, most));
  std::string tables = "# Segmentation beside ITK's filters\n\n";
  tables += formatted("Tree with noise %g, median of %d runs in one process.\n\n", options.noise,
                      options.repeat);
  tables += stageTable(bySize.back());
  std::vector<bench::PlotPanel> panels;
  if (bySize.size() > 1) {
    tables += growthTable(bySize, true, panels);
    write(folder / "size.svg", bench::svgOf(panels));
  }
  if (options.threads.size() > 1) {
    std::vector<Group> byThreads;
    for (const int n : options.threads)
      byThreads.push_back(measure(options, options.threadSize, n));
    panels.clear();
    tables += formatted("Against threads, the volume has %d^3 voxels.\n\n", options.threadSize);
    tables += growthTable(byThreads, false, panels);
    write(folder / "threads.svg", bench::svgOf(panels));
  }
  write(folder / "segmentation.md", tables);
  std::printf("%s", tables.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  CLI::App app("The stages of the segmentation beside ITK's filters, in one process");
  Options options;
  app.add_option("--size", options.sizes, "voxels along each side; the last is the main table's")
      ->delimiter(',')
      ->check(CLI::Range(32, 512))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "numbers of threads; the most is the tables'")
      ->delimiter(',')
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--thread-size", options.threadSize, "size of the volume against threads")
      ->check(CLI::Range(32, 512))
      ->capture_default_str();
  app.add_option("--repeat", options.repeat, "runs of each")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--noise", options.noise, "sigma of the noise, of 0..255")->capture_default_str();
  app.add_option("--only", options.only, "the stages whose name holds this text");
  app.add_option("-o,--output", options.output, "folder to write")->capture_default_str();
  return bench::runProgram(app, argc, argv, [&] { return run(options); });
}
