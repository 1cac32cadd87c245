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
  if (const auto known = segmentations_.find(key); !key.empty() && known != segmentations_.end())
    return known->second;
  names_[++last_] = QString::number(++evolved_);
  if (!key.empty()) segmentations_[key] = last_;
  return last_;
}

int ResultNames::corrected(int segmentation, const std::string& key) {
  if (const auto known = segmentations_.find(key); !key.empty() && known != segmentations_.end())
    return known->second;
  names_[++last_] =
      QStringLiteral("%1.%2").arg(name(segmentation)).arg(++corrections_[segmentation]);
  if (!key.empty()) segmentations_[key] = last_;
  return last_;
}

QString ResultNames::name(int segmentation) const { return names_.at(segmentation); }

QString ResultNames::mesh(int segmentation, const std::string& key) {
  std::vector<std::string>& keys = meshes_[segmentation];
  auto at = std::find(keys.begin(), keys.end(), key);
  if (at == keys.end()) at = keys.insert(at, key);
  return name(segmentation) + letters(static_cast<int>(at - keys.begin()));
}

}  // namespace angiomesh
