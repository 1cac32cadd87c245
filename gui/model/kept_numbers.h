// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>
#include <QStringList>
#include <cstddef>
#include <map>

namespace angiomesh {

/// Small numbers of names: a name keeps its number for as long as it is among those in use, and a
/// new one takes the first number that is free.
class KeptNumbers {
 public:
  /// The names in use from now on.
  void use(const QStringList& names);
  /// Of a name in use.
  [[nodiscard]] std::size_t of(const QString& name) const { return numbers_.at(name); }
  /// `to` takes the number of `from`, unless it has one.
  void rename(const QString& from, const QString& to);

 private:
  std::map<QString, std::size_t> numbers_;
};

}  // namespace angiomesh
