// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

namespace angiomesh {

/// Short names of a case's results, so that panes and tables can say whose they are: "2" is the
/// second segmentation, "2b" the second mesh that was made of it. A result that comes again has the
/// name that it had.
class ResultNames {
 public:
  void clear();
  /// @param key of the step evolve; empty: a segmentation that no key tells, always a new one
  [[nodiscard]] int segmentation(const std::string& key);
  /// @param key of the step smooth
  [[nodiscard]] QString mesh(int segmentation, const std::string& key);

 private:
  int last_ = 0;
  std::map<std::string, int> segmentations_;
  std::map<int, std::vector<std::string>> meshes_;  ///< keys, in the order of their coming
};

}  // namespace angiomesh
