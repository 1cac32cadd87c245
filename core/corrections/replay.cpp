// SPDX-License-Identifier: BSD-3-Clause
#include "core/corrections/replay.h"

#include <algorithm>
#include <utility>

#include "core/base/error.h"
#include "core/base/parallel.h"

namespace angiomesh {

std::vector<CorrectionOutcome> replay(Volume<float>& phi, const std::vector<std::string>& texts,
                                      const CorrectionGround& ground, const Progress& progress) {
  std::vector<CorrectionOutcome> outcomes;
  for (const std::string& text : texts) {
    const Correction correction = parseCorrection(text);
    CorrectionOutcome outcome;
    outcome.text = text;
    try {
      Corrected made = applyCorrection(phi, correction, ground, progress);
      outcome.added = made.added;
      outcome.removed = made.removed;
      phi = std::move(made.phi);
    } catch (const InputError& error) {
      outcome.why = error.cause();
    }
    outcomes.push_back(std::move(outcome));
    progress.report(static_cast<double>(outcomes.size()) / static_cast<double>(texts.size()));
  }
  return outcomes;
}

std::vector<std::string> warningsOf(const std::vector<CorrectionOutcome>& outcomes) {
  std::vector<std::string> warnings;
  for (std::size_t n = 0; n < outcomes.size(); ++n) {
    const CorrectionOutcome& outcome = outcomes[n];
    const std::string which = "correction " + std::to_string(n + 1) + " (" +
                              outcome.text.substr(0, outcome.text.find(' ')) + ") ";
    if (!outcome.why.empty())
      warnings.push_back(which + "was left out: " + outcome.why);
    else if (outcome.added == 0 && outcome.removed == 0)
      warnings.push_back(which + "changed nothing");
  }
  return warnings;
}

void carryOver(const Volume<float>& before, const Volume<float>& after, Volume<float>& other) {
  parallelForEach(other.voxels.size(), 1 << 16, [&](std::size_t v) {
    const float was = before.voxels[v], is = after.voxels[v];
    if (is < was)
      other.voxels[v] = std::min(other.voxels[v], is);
    else if (is > was)
      other.voxels[v] = std::max(other.voxels[v], is);
  });
}

}  // namespace angiomesh
