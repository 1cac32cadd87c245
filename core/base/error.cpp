// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/error.h"

namespace angiomesh {
namespace {

std::string oneLine(const std::string& what, const std::string& where, const std::string& advice) {
  std::string line = what;
  if (!where.empty()) line += ", " + where;
  if (!advice.empty()) line += ": " + advice;
  for (char& c : line)
    if (c == '\n' || c == '\r') c = ' ';
  return line;
}

}  // namespace

Error::Error(const std::string& what, const std::string& where, const std::string& advice)
    : std::runtime_error(oneLine(what, where, advice)), causeLength_(what.size()) {}

}  // namespace angiomesh
