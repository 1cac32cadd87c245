// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "bench/dicom_folder.h"
#include "bench/peak_memory.h"
#include "bench/program.h"
#include "core/base/formatted.h"
#include "core/base/parallel.h"
#include "io/scan/image_io.h"

using namespace angiomesh;
namespace fs = std::filesystem;

namespace {

struct Options {
  std::vector<int> size{512, 512, 155};
  int slices = 120;    ///< of the DICOM series
  int headers = 2000;  ///< files of the folder that is looked through
  int threads = 0, repeat = 11;
  std::string output = "bench-results";
};

struct Case {
  std::string name;
  std::vector<fs::path> files;
  std::size_t bytesEach = 0;   ///< of a file that the plain run reads; 0: all of them
  double volumeMb = 0.0;       ///< as float32; 0 where no voxels are read
  std::function<void()> read;  ///< what is measured
  std::vector<double> plainMs, readMs;
  double peakMb = 0.0;
};

/// A raw MetaImage with the noise of a scan.
template <class T>
void writeScan(const fs::path& file, const std::string& metaType, const std::vector<int>& size) {
  std::ofstream out(file, std::ios::binary);
  out << "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nElementSpacing = 0.5 0.5 0.8\nDimSize = "
      << size[0] << " " << size[1] << " " << size[2] << "\nElementType = " << metaType
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
  if (!out) throw std::runtime_error("cannot write " + file.string());
}

/// What reading costs at least: the bytes of the files, in parallel, into memory that was not used
/// before.
void readPlainly(const Case& test) {
  std::vector<std::size_t> starts{0};
  for (const fs::path& file : test.files) {
    const std::size_t size = fs::file_size(file);
    starts.push_back(starts.back() + (test.bytesEach > 0 ? std::min(size, test.bytesEach) : size));
  }
  const std::unique_ptr<std::byte[]> buffer(new std::byte[starts.back()]);
  std::atomic<bool> whole{true};
  parallelFor(0, test.files.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const int descriptor = ::open(test.files[i].c_str(), O_RDONLY | O_CLOEXEC);
      std::size_t at = starts[i];
      while (at < starts[i + 1]) {
        const ssize_t n = ::read(descriptor, buffer.get() + at, starts[i + 1] - at);
        if (n <= 0) break;
        at += static_cast<std::size_t>(n);
      }
      ::close(descriptor);
      if (at != starts[i + 1]) whole = false;
    }
  });
  if (!whole) throw std::runtime_error("cannot read " + test.files.front().string());
  benchmark::DoNotOptimize(buffer.get());
}

void readVolume(const fs::path& path) {
  const LoadedImage loaded = readImage(path);
  benchmark::DoNotOptimize(loaded.image.voxels.data());
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
    benchmark::RegisterBenchmark(("plain " + test.name).c_str(),
                                 [&test](benchmark::State& state) {
                                   for ([[maybe_unused]] auto once : state) readPlainly(test);
                                 })
        ->Iterations(1)
        ->UseRealTime();
    benchmark::RegisterBenchmark(("read " + test.name).c_str(),
                                 [&test](benchmark::State& state) {
                                   for ([[maybe_unused]] auto once : state) test.read();
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
      test.plainMs.push_back(collector.milliseconds.at("plain " + test.name));
      test.readMs.push_back(collector.milliseconds.at("read " + test.name));
    }
  }
  for (Case& test : cases) {
    const bench::PeakMemory memory;
    test.read();
    test.peakMb = memory.addedMb();
  }
}

std::string rowOf(const Case& test) {
  std::vector<double> ratios;
  for (std::size_t n = 0; n < test.readMs.size(); ++n)
    ratios.push_back(test.readMs[n] / test.plainMs[n]);
  std::string row = formatted("| %s | %.1f | %.1f | %.2f | %.0f | ", test.name.c_str(),
                              bench::median(test.plainMs), bench::median(test.readMs),
                              bench::median(ratios), test.peakMb);
  if (test.volumeMb > 0.0) row += formatted("%.2f", test.peakMb / test.volumeMb);
  return row + " |\n";
}

std::string tableOf(const std::vector<Case>& cases, const Options& options) {
  std::string table = formatted(
      "# Reading volumes and headers\n\n%d threads, median of %d runs in one process. The "
      "bytes are those of the files, of headers the first 4 kB each, read by as many "
      "threads.\n\n",
      threads(), options.repeat);
  table +=
      "| what | its bytes, ms | Angiomesh, ms | times | memory added, MB | volumes (float32) |\n"
      "|---|---|---|---|---|---|\n";
  for (const Case& test : cases) table += rowOf(test);
  return table;
}

std::string sizeText(int x, int y, int z) {
  return std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z);
}

double megabytes(int x, int y, int z) { return 4.0 * x * y * z / (1 << 20); }

std::vector<Case> makeCases(const Options& options, const fs::path& folder) {
  const auto& size = options.size;
  const std::string text = sizeText(size[0], size[1], size[2]);
  const double volumeMb = megabytes(size[0], size[1], size[2]);
  const fs::path whole = folder / "int16.mha", real = folder / "float32.mha";
  writeScan<std::int16_t>(whole, "MET_SHORT", size);
  writeScan<float>(real, "MET_FLOAT", size);
  const fs::path series = folder / "series", many = folder / "many";
  std::vector<Case> cases;
  cases.push_back(
      {"MetaImage int16, " + text, {whole}, 0, volumeMb, [=] { readVolume(whole); }, {}, {}});
  cases.push_back(
      {"MetaImage float32, " + text, {real}, 0, volumeMb, [=] { readVolume(real); }, {}, {}});
  cases.push_back({"DICOM, " + sizeText(512, 512, options.slices),
                   bench::writeDicomFolder(series, 512, 512, options.slices),
                   0,
                   megabytes(512, 512, options.slices),
                   [=] { readVolume(series); },
                   {},
                   {}});
  cases.push_back({std::to_string(options.headers) + " DICOM headers",
                   bench::writeDicomFolder(many, 128, 128, options.headers),
                   4096,
                   0.0,
                   [=] { benchmark::DoNotOptimize(describeImages(many).size()); },
                   {},
                   {}});
  return cases;
}

int run(const Options& options) {
  setThreads(options.threads);
  const fs::path inputs = fs::path(options.output) / "inputs";
  fs::create_directories(inputs);
  std::vector<Case> cases = makeCases(options, inputs);
  measure(cases, options.repeat);
  fs::remove_all(inputs);
  const std::string table = tableOf(cases, options);
  const fs::path file = fs::path(options.output) / "io.md";
  std::ofstream out(file);
  if (!(out << table && out.flush())) throw std::runtime_error("cannot write " + file.string());
  std::printf("%s", table.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  CLI::App app("Reading volumes beside reading the same bytes, in one process");
  Options options;
  app.add_option("--size", options.size, "voxels along the sides of the MetaImage")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(2, 2048))
      ->capture_default_str();
  app.add_option("--slices", options.slices, "of the DICOM series, of 512 x 512 pixels")
      ->check(CLI::Range(3, 2000))
      ->capture_default_str();
  app.add_option("--headers", options.headers, "files of the DICOM folder that is looked through")
      ->check(CLI::Range(3, 10000))
      ->capture_default_str();
  app.add_option("--threads", options.threads, "0: all cores");
  app.add_option("--repeat", options.repeat, "runs of each")->check(CLI::PositiveNumber);
  app.add_option("-o,--output", options.output, "folder to write")->capture_default_str();
  return bench::runProgram(app, argc, argv, [&] { return run(options); });
}
