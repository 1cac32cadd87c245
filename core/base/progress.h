// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

namespace angiomesh {

/// Copyable handle on one running job: a fraction that only grows, the name of the phase, the state
/// of an evolution, and the wish to cancel. All calls are thread-safe and lock-free; the GUI polls.
class Progress {
 public:
  /// A handle of its own, at 0, not cancelled.
  Progress();

  /// The part [from, to] of this handle's range; shares phase, evolution state and cancel flag.
  [[nodiscard]] Progress sub(double from, double to) const;

  /// Moves to `fraction` (0..1) of this handle's range; smaller values are ignored.
  /// @throws Cancelled when cancel() was called
  void report(double fraction) const;

  /// @throws Cancelled when cancel() was called
  void check() const;

  /// Names the phase; `name` must have static storage.
  void phase(const char* name) const;

  /// State of a running evolution: iterations done and the last change (negative: none yet).
  void evolution(int iterations, double change) const;

  /// Asks the job to stop at its next report() or check().
  void cancel() const;

  [[nodiscard]] bool cancelled() const;
  [[nodiscard]] double fraction() const;  ///< of the whole job, 0..1
  [[nodiscard]] const char* phase() const;
  [[nodiscard]] int iterations() const;
  [[nodiscard]] double change() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
  double from_ = 0.0;
  double to_ = 1.0;
};

}  // namespace angiomesh
