// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/result_names.h"

#include <algorithm>

namespace angiomesh {

namespace {

constexpr int kLetters = 26;

/// "", "b" ... "z", "ba" ...: the first needs none.
QString letters(int n) {
  QString text;
  for (; n > 0; n /= kLetters) text.prepend(QChar('a' + n % kLetters));
  return text;
}

}  // namespace

void ResultNames::clear() { *this = {}; }

int ResultNames::segmentation(const std::string& key) {
  if (key.empty()) return ++last_;
  const auto [known, isNew] = segmentations_.emplace(key, last_ + 1);
  if (isNew) ++last_;
  return known->second;
}

QString ResultNames::mesh(int segmentation, const std::string& key) {
  std::vector<std::string>& keys = meshes_[segmentation];
  auto at = std::find(keys.begin(), keys.end(), key);
  if (at == keys.end()) at = keys.insert(at, key);
  return QString::number(segmentation) + letters(static_cast<int>(at - keys.begin()));
}

}  // namespace angiomesh
