// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace angiomesh::bench {

/// One way to do the work of a stage. `run` gives the number of iterations of a front, else 0.
struct Way {
  std::string name;
  std::function<int()> run;
};

/// The same work done by Angiomesh (the first way) and by others.
struct Stage {
  std::string name;
  std::vector<Way> ways;
};

/// The stages on a vascular tree in `size`^3 with Gaussian noise, in the default preset; the ways
/// share their inputs, which are made here and live as long as a way does.
std::vector<Stage> segmentationStages(int size, double noise);

}  // namespace angiomesh::bench
