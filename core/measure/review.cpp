// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/review.h"

#include <algorithm>

namespace angiomesh {

namespace {

constexpr std::array<const char*, 3> kVerdicts{"none", "accepted", "rejected"};
constexpr std::array<const char*, kDoubtKinds> kDoubts{"hole", "neck", "missed", "island"};

template <class Kind, std::size_t n>
std::optional<Kind> kindOf(const std::array<const char*, n>& words, const std::string& word) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Kind>(found - words.begin());
}

}  // namespace

const char* verdictWord(Verdict verdict) { return kVerdicts[static_cast<std::size_t>(verdict)]; }
std::optional<Verdict> verdictOf(const std::string& word) {
  return kindOf<Verdict>(kVerdicts, word);
}

const char* doubtWord(DoubtKind kind) { return kDoubts[static_cast<std::size_t>(kind)]; }
std::optional<DoubtKind> doubtKindOf(const std::string& word) {
  return kindOf<DoubtKind>(kDoubts, word);
}

}  // namespace angiomesh
