// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace angiomesh::bench {

/// What a piece of work adds to the resident memory of this process at its worst. Linux alone.
class PeakMemory {
 public:
  PeakMemory();  ///< gives back what is free and starts to measure
  /// MB (2^20 bytes) since the start, negative where the system does not tell.
  [[nodiscard]] double addedMb() const;

 private:
  double before_ = -1.0;
};

}  // namespace angiomesh::bench
