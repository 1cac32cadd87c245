// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/recipe_job.h"

#include <exception>

#include "gui/job/file_jobs.h"
#include "io/file/files.h"

namespace angiomesh {

void RecipeFileJob::execute() noexcept {
  try {
    writeText(path, recipeText(recipe));
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), path, path.filename().string());
  }
}

void RecipeReadJob::execute() noexcept {
  try {
    recipe = readRecipe(path, Parameters());
    validate(recipe.params);
  } catch (const std::exception& failure) {
    error = withoutPath(failure.what(), path, path.filename().string());
  }
}

}  // namespace angiomesh
