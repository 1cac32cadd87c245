// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/open_case_job.h"

#include <utility>

#include "core/base/error.h"
#include "io/case/case_cache.h"
#include "io/case/find_source.h"

namespace angiomesh {

OpenCaseJob::OpenCaseJob(CaseRequest request)
    : LoadJob(request.folder, request.folder.stem().string()), request_(std::move(request)) {}

void OpenCaseJob::readFolder() {
  CaseReading reading = readCase(request_.folder);
  document_ = std::move(reading.document);
  for (const std::string& warning : reading.warnings)
    warnings_.push_back(withoutPath(warning, request_.folder, name()));
  place_ = request_.place ? request_.place : std::make_shared<CasePlace>();
  place_->folder = request_.folder;
  const LockEnd end = lockPlace(*place_);
  if (end == LockEnd::InUse) {
    warnings_.push_back(
        "the case is open in another window or on another computer: save it under another name");
    place_.reset();
    return;  // and the journal is that window's
  }
  if (end == LockEnd::Impossible) {
    warnings_.push_back("the case's folder cannot be written to: save it under another name");
    place_.reset();
  }
  steps_ = readJournal(request_.folder, document_.saves);
}

Source OpenCaseJob::obtainSample() {
  InputInfo info;
  info.format = document_.source.format;
  setInfo(info);
  Source sample = makeSampleSource(kSampleSize, progress().sub(0.0, 0.8));
  sample.name = name();
  return sample.hash == document_.source.hash ? sample : Source();
}

Source OpenCaseJob::obtain() {
  readFolder();
  if (request_.source.empty() && document_.source.format == "phantom") {
    if (Source sample = obtainSample(); sample.image) return sample;
  }
  std::optional<FoundSource> found;
  if (!request_.source.empty()) {
    try {
      found = sourceAt(request_.source, document_.source, progress().sub(0.0, 0.8));
      if (!found) difference_ = "this is not the volume that the case was made of";
    } catch (const Error& failure) {
      difference_ = withoutPath(failure.what(), request_.source, "the volume");
    }
  } else {
    std::vector<std::filesystem::path> places = placesOf(document_.source.hash, request_.known);
    if (!place_ || !place_->recovery)
      for (std::filesystem::path& near : placesNear(request_.folder))
        places.push_back(std::move(near));
    found = findSource(places, document_.source, progress().sub(0.0, 0.8));
  }
  if (!found) return {};
  sourcePath_ = found->path;
  setInfo(std::move(found->loaded.info));
  Source source;
  source.image = std::make_shared<const Volume<float>>(std::move(found->loaded.image));
  source.hash = found->hash;
  source.name = name();
  return source;
}

void OpenCaseJob::prepare(Pipeline& pipeline) {
  const Parameters& params = document_.params;
  const auto cached = readCache(request_.folder, pipeline.key(Step::Evolve, params));
  if (!cached) return;
  try {
    RunOptions options;
    options.until = Step::Preprocess;
    (void)pipeline.run(params, options, progress().sub(0.9, 1.0));
    pipeline.restore(std::make_shared<const EvolveResult>(cached->result), cached->report, params);
  } catch (const Error&) {
    // The next run says what is wrong with the parameters.
  }
}

}  // namespace angiomesh
