// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <map>
#include <string>
#include <vector>

namespace angiomesh {

/// Short names of a case's results, so that panes and tables can say whose they are: "2" is the
/// second segmentation, "2.1" what its first correction made of it, "2b" the second mesh of it. A
/// result that comes again has the name that it had.
class ResultNames {
 public:
  void clear();
  /// @param key of the step evolve; empty: a segmentation that no key tells, always a new one
  [[nodiscard]] int segmentation(const std::string& key);
  /// The number of a segmentation with corrections. @param key likewise, of the step correct
  [[nodiscard]] int corrected(int segmentation, const std::string& key);
  [[nodiscard]] QString name(int segmentation) const;
  /// @param key of the step smooth
  [[nodiscard]] QString mesh(int segmentation, const std::string& key);

 private:
  int last_ = 0;  ///< number; the first is 1
  std::map<std::string, int> segmentations_;
  std::map<int, QString> names_;
  std::map<int, int> corrections_;                  ///< of each segmentation that is no correction
  int evolved_ = 0;                                 ///< of these the last one's name
  std::map<int, std::vector<std::string>> meshes_;  ///< keys, in the order of their coming
};

}  // namespace angiomesh
