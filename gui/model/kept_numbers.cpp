// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/kept_numbers.h"

#include <set>
#include <utility>

namespace angiomesh {

void KeptNumbers::use(const QStringList& names) {
  std::map<QString, std::size_t> numbers;
  std::set<std::size_t> taken;
  for (const QString& name : names) {
    if (const auto had = numbers_.find(name); had != numbers_.end()) {
      numbers.insert(*had);
      taken.insert(had->second);
    }
  }
  std::size_t next = 0;
  for (const QString& name : names) {
    if (numbers.count(name) != 0) continue;
    while (!taken.insert(next).second) ++next;
    numbers.emplace(name, next);
  }
  numbers_ = std::move(numbers);
}

void KeptNumbers::rename(const QString& from, const QString& to) {
  if (numbers_.count(to) != 0) return;
  if (auto entry = numbers_.extract(from)) {
    entry.key() = to;
    numbers_.insert(std::move(entry));
  }
}

}  // namespace angiomesh
