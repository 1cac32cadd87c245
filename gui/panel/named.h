// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QString>

namespace angiomesh {

/// The object under a name that tests and the saved layout know it by.
template <class Object>
Object* named(Object* object, const QString& name) {
  object->setObjectName(name);
  return object;
}

}  // namespace angiomesh
