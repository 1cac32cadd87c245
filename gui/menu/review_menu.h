// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gui/findings/case_review.h"

class QMainWindow;

namespace angiomesh {

/// The menu that opens the review, goes through the doubtful places, and adds remarks.
void addReviewMenu(QMainWindow* window, CaseReviewModel& review);

}  // namespace angiomesh
