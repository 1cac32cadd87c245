// SPDX-License-Identifier: BSD-3-Clause
#pragma once

class QWidget;

namespace angiomesh {

void showAbout(QWidget* window);

}  // namespace angiomesh
