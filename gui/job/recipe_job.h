// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "io/recipe/recipe_file.h"

namespace angiomesh {

/// Writes a recipe, off the window's thread.
struct RecipeFileJob {
  Recipe recipe;
  std::filesystem::path path;

  void execute() noexcept;

  // After execute():
  std::string error;
};

/// Reads a recipe or a file of parameters, likewise.
struct RecipeReadJob {
  std::filesystem::path path;

  void execute() noexcept;

  // After execute():
  Recipe recipe;
  std::string error;
};

}  // namespace angiomesh
