// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/peak_memory.h"
#include "core/base/parallel.h"
#include "io/image_io.h"

using namespace angiomesh;
namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<int> size{512, 512, 155};
  int threads = 0, repeat = 11;
  std::string output = "bench-results";
};

struct Case {
  std::string type;  ///< "int16"
  std::string metaType;
  fs::path file;
  std::vector<double> plainMs, readMs;
  double peakMb = -1.0;
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// A raw MetaImage with the noise of a scan.
template <class T>
void writeScan(const Case& test, const std::vector<int>& size) {
  std::ofstream out(test.file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nElementSpacing = 0.5 0.5 0.8\nDimSize = "
      << size[0] << " " << size[1] << " " << size[2] << "\nElementType = " << test.metaType
      << "\nElementDataFile = LOCAL\n";
  std::vector<T> slice(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  std::uint32_t noise = 1;
  for (int k = 0; k < size[2]; ++k) {
    for (T& voxel : slice) {
      noise = noise * 1664525U + 1013904223U;
      voxel = static_cast<T>(noise >> 22U);
    }
    out.write(reinterpret_cast<const char*>(slice.data()),
              static_cast<std::streamsize>(slice.size() * sizeof(T)));
  }
  out.close();
  if (!out) throw std::runtime_error("cannot write " + test.file.string());
}

/// What reading costs at least: the bytes of the file into memory that was not used before.
void readPlainly(const fs::path& file) {
  const std::size_t bytes = fs::file_size(file);
  const std::unique_ptr<std::byte[]> buffer(new std::byte[bytes]);
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  std::size_t got = 0;
  while (got < bytes) {
    const ssize_t n = ::read(descriptor, buffer.get() + got, bytes - got);
    if (n <= 0) break;
    got += static_cast<std::size_t>(n);
  }
  ::close(descriptor);
  if (got != bytes) throw std::runtime_error("cannot read " + file.string());
  benchmark::DoNotOptimize(buffer.get());
}

/// Takes the times from Google Benchmark by the benchmarks' names.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        milliseconds[run.benchmark_name().substr(0, run.benchmark_name().find('/'))] =
            1e3 * run.real_accumulated_time / static_cast<double>(run.iterations);
  }
  std::map<std::string, double> milliseconds;
};

void measure(std::vector<Case>& cases, int repeat) {
  for (const Case& test : cases) {
    benchmark::RegisterBenchmark(("plain " + test.type).c_str(),
                                 [&test](benchmark::State& state) {
                                   for ([[maybe_unused]] auto once : state) readPlainly(test.file);
                                 })
        ->Iterations(1)
        ->UseRealTime();
    benchmark::RegisterBenchmark(("read " + test.type).c_str(),
                                 [&test](benchmark::State& state) {
                                   for ([[maybe_unused]] auto once : state) {
                                     const LoadedImage loaded = readImage(test.file);
                                     benchmark::DoNotOptimize(loaded.image.voxels.data());
                                   }
                                 })
        ->Iterations(1)
        ->UseRealTime();
  }
  // All of them in each round: whatever disturbs the machine hits all. The first round warms up.
  for (int n = 0; n <= repeat; ++n) {
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    if (n == 0) continue;
    for (Case& test : cases) {
      test.plainMs.push_back(collector.milliseconds.at("plain " + test.type));
      test.readMs.push_back(collector.milliseconds.at("read " + test.type));
    }
  }
  for (Case& test : cases) {
    const bench::PeakMemory memory;
    const LoadedImage loaded = readImage(test.file);
    test.peakMb = memory.addedMb();
  }
}

std::string tableOf(const std::vector<Case>& cases, const Options& options) {
  char line[200];
  const double volumeMb = 4.0 * options.size[0] * options.size[1] * options.size[2] / (1 << 20);
  std::snprintf(
      line, sizeof line,
      "# Reading a raw MetaImage\n\n%d x %d x %d voxels, %d threads, median of %d runs in "
      "one process.\n\n",
      options.size[0], options.size[1], options.size[2], threads(), options.repeat);
  std::string table = line;
  table +=
      "| type | its bytes, ms | readImage, ms | times | memory added, MB | volumes (float32) |\n"
      "|---|---|---|---|---|---|\n";
  for (const Case& test : cases) {
    std::vector<double> ratios;
    for (std::size_t n = 0; n < test.readMs.size(); ++n)
      ratios.push_back(test.readMs[n] / test.plainMs[n]);
    std::snprintf(line, sizeof line, "| %s | %.1f | %.1f | %.2f | %.0f | %.2f |\n",
                  test.type.c_str(), median(test.plainMs), median(test.readMs), median(ratios),
                  test.peakMb, test.peakMb / volumeMb);
    table += line;
  }
  return table;
}

int run(const Options& options) {
  setThreads(options.threads);
  fs::create_directories(options.output);
  const fs::path folder = options.output;
  std::vector<Case> cases(2);
  cases[0] = {"int16", "MET_SHORT", folder / "int16.mha", {}, {}, -1.0};
  cases[1] = {"float32", "MET_FLOAT", folder / "float32.mha", {}, {}, -1.0};
  writeScan<std::int16_t>(cases[0], options.size);
  writeScan<float>(cases[1], options.size);
  measure(cases, options.repeat);
  for (const Case& test : cases) fs::remove(test.file);
  const std::string table = tableOf(cases, options);
  std::ofstream out(folder / "io.md");
  if (!(out << table && out.flush()))
    throw std::runtime_error("cannot write " + (folder / "io.md").string());
  std::printf("%s", table.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  CLI::App app("Reading volumes beside reading the same bytes, in one process");
  Options options;
  app.add_option("--size", options.size, "voxels along the sides")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(2, 2048))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "0: all cores");
  app.add_option("--repeat", options.repeat, "runs of each")->check(CLI::PositiveNumber);
  app.add_option("-o,--output", options.output, "folder to write")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
