// SPDX-License-Identifier: BSD-3-Clause
#include "gui/model/part_edits.h"

namespace angiomesh {

PartEdits::PartEdits(CaseModels& models, const JobRunnerFactory& makeRunner, QObject* parent)
    : QObject(parent),
      models_(models),
      slot_(models.timer, makeRunner,
            [this](const std::shared_ptr<PartJob>& job) { finish(*job); }) {}

bool PartEdits::ready() const {
  return !slot_ && models_.results.meshFits() && !models_.results.components().empty();
}

void PartEdits::start(const Eigen::Vector3d& placeLps, bool keep) {
  if (!ready()) return;
  auto job = std::make_shared<PartJob>();
  job->phi = models_.results.segmentation()->phi;
  const SegmentationParams& params = models_.results.meshParameters()->segmentation;
  job->fullyConnected =
      params.method != SegmentationMethod::Label || params.connectivity != MaskConnectivity::Faces;
  job->innerPointsLps = models_.results.innerPoints();
  job->placeLps = placeLps;
  keep_ = keep;
  slot_.startAndPoll(std::move(job));
}

void PartEdits::finish(const PartJob& job) {
  // Another result may have come meanwhile.
  if (!job.part || job.innerPointsLps != models_.results.innerPoints()) return;
  const auto part = static_cast<int>(*job.part);
  if (keep_)
    models_.results.keepOnlyComponent(part);
  else
    models_.results.setComponentTicked(part, false);
}

}  // namespace angiomesh
