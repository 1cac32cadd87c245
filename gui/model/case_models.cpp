// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/case_models.h"

namespace angiomesh {

CaseModels::CaseModels(const JobRunnerFactory& makeRunner, const std::filesystem::path& recovery)
    : document(log),
      presets(document),
      results(document, log, timer, makeRunner),
      runs(document, results, log, timer, makeRunner),
      live(document, results, runs, timer, makeRunner),
      files(document, presets, results, runs, log, timer, makeRunner, recovery),
      exports(results, log, timer, makeRunner),
      corrections(document, results, log) {
  QObject::connect(&files, &CaseFiles::loadingChanged, &runs, &RunModel::statesChanged);
}

bool CaseModels::busy() const {
  return runs.running() || results.asking() || files.loading() || files.storing() ||
         exports.writing();
}

void CaseModels::cancel() {
  files.cancelLoad();
  runs.cancel();
}

}  // namespace angiomesh
