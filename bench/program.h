// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <vector>

#include "core/base/statistics.h"

namespace angiomesh::bench {

/// Of at least one value; of an even number of them, the mean of the middle two.
inline double median(std::vector<double> values) { return percentile(values, 0.5); }

/// The exit code of a program: what `run()` returns, or 1 with its fault on stderr.
template <class Run>
int runProgram(CLI::App& app, int argc, char** argv, const Run& run) {
  CLI11_PARSE(app, argc, argv);
  try {
    return run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

}  // namespace angiomesh::bench
