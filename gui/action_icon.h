// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QIcon>

namespace angiomesh {

/// The drawing of an action, by the action's name, in the colour that the palette has for the text
/// of buttons whenever it is painted. Null for an action without a drawing.
QIcon actionIcon(const QString& action);

}  // namespace angiomesh
