// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <QImage>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "io/file/staged_folder.h"

namespace angiomesh {

/// The pictures of a turntable, 001.png and so on, in a folder that appears with the last of them.
struct TurntableFolder {
  std::filesystem::path path;
  int count = 0;
  std::optional<StagedFolder> staged;  ///< from the first picture on
};

/// The PNG file of a picture, written off the window's thread.
struct PictureJob {
  QImage picture;
  std::filesystem::path path;                  ///< of a picture alone
  std::shared_ptr<TurntableFolder> turntable;  ///< null: a picture alone
  int number = 0;                              ///< in the turntable, from 1; 0: give it up

  void execute() noexcept;

  // After execute():
  std::string error;  ///< nothing of the turntable is left then

 private:
  void addToTurntable();
};

}  // namespace angiomesh
