// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_recipe.h"

#include "gui/model/case_models.h"
#include "io/recipe/methods_text.h"

namespace angiomesh {

Recipe caseRecipe(const CaseModels& models) {
  const CaseDocument& document = models.document;
  const bool fresh = models.results.key(Step::Correct) == document.key(Step::Correct);
  return recipeOf(document.parameters(), document.pipeline()->source(),
                  fresh ? models.results.segmentation().get() : nullptr);
}

std::string caseMethods(const CaseModels& models) {
  if (!models.results.meshRun()) return {};
  RunResult run = *models.results.meshRun();
  // Names of ports change without a run.
  if (models.results.meshFresh()) run.params = models.document.parameters();
  return methodsText(run);
}

}  // namespace angiomesh
