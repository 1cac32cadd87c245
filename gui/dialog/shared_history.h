// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QVariant>
#include <array>

namespace angiomesh {

/// Qt's file dialogs note the folders that they showed in settings that all Qt programs of the user
/// share, and folders may tell a patient's name. When this goes, after the dialog, the notes are
/// what they were before.
class SharedHistory {
 public:
  SharedHistory();
  ~SharedHistory();
  SharedHistory(const SharedHistory&) = delete;
  SharedHistory& operator=(const SharedHistory&) = delete;

 private:
  std::array<QVariant, 2> before_;
};

}  // namespace angiomesh
