// SPDX-License-Identifier: BSD-3-Clause
#include "core/remesh/remesh.h"

#include "core/remesh/remesh_ground.h"
#include "core/remesh/remesh_worker.h"

namespace angiomesh {
namespace {

class GuidanceSize : public EdgeSize {
 public:
  explicit GuidanceSize(const GuidanceField& field) : field_(field) {}
  [[nodiscard]] double at(const Eigen::Vector3d& pointLps) const override {
    return field_.at(pointLps);
  }

 private:
  const GuidanceField& field_;
};

PatchMesh improved(RemeshWorker& worker, const Progress& progress) {
  worker.even();
  progress.report(0.8);
  worker.repair();
  worker.finish();
  progress.report(1.0);
  return worker.result();
}

}  // namespace

PatchMesh remesh(const PatchMesh& start, const SplineField& field, const EdgeSize& size,
                 const EndPlanes& ends, const Progress& progress, const std::vector<char>& held) {
  const ZeroSetGround ground(field, size, ends);
  RemeshWorker worker(start, ground, progress, held);
  worker.resize();
  PatchMesh result = improved(worker, progress);
  for (FaceOrigin& origin : result.origin) origin = FaceOrigin::Remesh;
  return result;
}

void improveTriangles(PatchMesh& mesh, const SplineField& field, const EdgeSize& size,
                      const EndPlanes& ends, const Progress& progress) {
  const ZeroSetGround ground(field, size, ends);
  RemeshWorker worker(mesh, ground, progress);
  mesh = improved(worker, progress);
}

PatchMesh remesh(const PatchMesh& start, const SplineField& field, const GuidanceField& size,
                 const EndPlanes& ends, const Progress& progress, const std::vector<char>& held) {
  return remesh(start, field, GuidanceSize(size), ends, progress, held);
}

void improveTriangles(PatchMesh& mesh, const SplineField& field, const GuidanceField& size,
                      const EndPlanes& ends, const Progress& progress) {
  improveTriangles(mesh, field, GuidanceSize(size), ends, progress);
}

}  // namespace angiomesh
