// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/measure/review.h"

namespace angiomesh {

/// A review as cases and reports have it, each with its own key for places (mm LPS). `Json` is
/// nlohmann's, in order.
template <class Json>
Json reviewJson(const CaseReview& review, const char* placeKey) {
  const auto place = [](const Eigen::Vector3d& p) { return Json::array({p[0], p[1], p[2]}); };
  Json json = {{"verdict", verdictWord(review.verdict)}, {"score", review.score}};
  if (!review.key.empty()) json["key"] = review.key;
  for (const ReviewRemark& remark : review.remarks)
    json["remarks"].push_back(
        {{placeKey, place(remark.pointLps)}, {"score", remark.score}, {"text", remark.text}});
  for (const SeenPlace& seen : review.seen)
    json["seen"].push_back({{"kind", doubtWord(seen.kind)}, {placeKey, place(seen.pointLps)}});
  return json;
}

}  // namespace angiomesh
