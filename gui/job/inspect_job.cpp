// SPDX-License-Identifier: BSD-3-Clause
#include "gui/job/inspect_job.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <exception>

#include "core/mesh/triangle_shape.h"
#include "core/mesh/triangle_tree.h"

namespace angiomesh {

namespace {

constexpr int kBars = 60;
constexpr std::size_t kWorst = 20;

void setBars(MeasuredMeshes& all) {
  all.from = std::min(all.scale.worst, all.scale.best);
  all.to = std::max(all.scale.worst, all.scale.best);
  all.bars = kBars;
  if (all.measure->digits > 0) return;
  // Whole numbers have a bar each.
  all.from -= 0.5;
  all.to += 0.5;
  all.bars = static_cast<int>(std::lround(all.to - all.from));
}

void count(const MeasuredMeshes& all, MeasuredMeshes::Of& mesh) {
  mesh.bands = bandShares(*all.measure, mesh.values);
  mesh.shares.assign(static_cast<std::size_t>(all.bars), 0.0);
  double known = 0.0;
  for (const float value : mesh.values) {
    const int bar = all.barOf(value);
    if (bar < 0) continue;
    mesh.shares[static_cast<std::size_t>(bar)] += 1.0;
    known += 1.0;
  }
  for (double& share : mesh.shares) share *= known > 0.0 ? 100.0 / known : 0.0;
}

WorstPlace placeOf(const TriMesh& mesh, std::uint32_t triangle, float value) {
  const auto [a, b, c] = cornersOf(mesh, triangle);
  const double edge = ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3.0;
  return {triangle, value, (a + b + c) / 3.0, unitNormal(a, b, c), edge};
}

}  // namespace

int MeasuredMeshes::barOf(float value) const {
  if (std::isnan(value)) return -1;
  const double bar = std::floor((value - from) / (to - from) * bars);
  return static_cast<int>(std::clamp(bar, 0.0, bars - 1.0));
}

void InspectJob::execute() noexcept {
  try {
    auto all = std::make_shared<MeasuredMeshes>();
    all->measure = measure;
    std::vector<const std::vector<float>*> values;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
      MeasuredMeshes::Of& mesh = all->meshes[i];
      mesh.mesh = meshes[i];
      if (!mesh.mesh) continue;
      progress.check();
      mesh.values = measure->values(*mesh.mesh, progress.sub(0.0, 0.0));
      values.push_back(&mesh.values);
    }
    all->scale = scaleOf(*measure, values);
    setBars(*all);
    for (MeasuredMeshes::Of& mesh : all->meshes) {
      if (!mesh.mesh) continue;
      count(*all, mesh);
      for (const std::uint32_t t : worstTriangles(*measure, *mesh.mesh, mesh.values, kWorst))
        mesh.worst.push_back(placeOf(*mesh.mesh, t, mesh.values[t]));
    }
    measured = std::move(all);
  } catch (const std::exception&) {
    measured.reset();
  }
}

}  // namespace angiomesh
