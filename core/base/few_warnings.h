// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace angiomesh {

/// Of warnings of one kind, more of them would hide what else there is to say.
constexpr std::size_t kNamedWarnings = 3;

/// Adds the first `named` of one kind to a list and, of the others, how many there are: "17" +
/// `more`.
inline void addFew(std::vector<std::string>& list, const std::vector<std::string>& kind,
                   const std::string& more, std::size_t named = kNamedWarnings) {
  for (std::size_t n = 0; n < std::min(kind.size(), named); ++n) list.push_back(kind[n]);
  if (kind.size() > named) list.push_back(std::to_string(kind.size() - named) + more);
}

}  // namespace angiomesh
