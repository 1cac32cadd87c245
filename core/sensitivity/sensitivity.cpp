// SPDX-License-Identifier: BSD-3-Clause
#include "core/sensitivity/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/error.h"
#include "core/base/exact_math.h"

namespace angiomesh {
namespace {

constexpr double kShareOfSlider = 0.1, kRatio = 1.25;

bool isNumber(const Field& field) {
  return (field.kind == FieldKind::Real || field.kind == FieldKind::Integer) &&
         field.ofScan.has_value() && *field.ofScan <= Step::Evolve;
}

bool counts(const Field& field, const Parameters& params) {
  return field.main && isNumber(field) && !(field.idle && !field.idle(params).empty());
}

double numberOf(const FieldValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  return std::get<double>(value);
}

FieldValue valueOf(const Field& field, double number) {
  if (field.kind == FieldKind::Integer) return static_cast<std::int64_t>(std::llround(number));
  return number;
}

std::optional<ParameterStep> stepOf(const Field& field, const Parameters& params,
                                    const FieldContext& context, double size) {
  FieldValue value = field.get(params);
  if (std::holds_alternative<std::monostate>(value)) value = suggestedValue(field, params, context);
  ParameterStep step;
  step.key = field.key;
  step.up = size > 0.0;
  step.from = numberOf(value);
  if (field.logarithmic && step.from > 0.0) {
    step.to = step.from * portableExp(size * portableLog(kRatio));
  } else {
    const auto [low, high] = sliderRange(field, context);
    step.to = step.from + size * kShareOfSlider * (high - low);
  }
  if (field.kind == FieldKind::Integer && std::llround(step.to) == std::llround(step.from))
    step.to = step.from + (step.up ? 1.0 : -1.0);
  if (step.to < field.minimum || step.to > field.maximum) return std::nullopt;
  step.params = params;
  try {
    setField(step.params, field.key, valueOf(field, step.to));
    pushPartners(step.params, field);
    validate(step.params);
  } catch (const InputError&) {
    return std::nullopt;
  }
  step.to = numberOf(field.get(step.params));
  return step;
}

}  // namespace

FieldContext contextOf(const RunResult& run) {
  FieldContext context;
  const Volume<float>& image = *run.source.image;
  const Geometry& g = run.preprocessed->geometry;
  context.voxelMm = g.voxelMm();
  context.volumeMm3 = g.voxelVolumeMm3() * static_cast<double>(g.voxelCount());
  const std::vector<double> ends = percentiles(image, {0.01, 0.998});
  context.window = std::max(ends[1] - ends[0], 1e-6);
  context.level = 0.5 * (ends[0] + ends[1]);
  context.largestValue = valueRange(image)[1];
  if (run.vesselness) {
    context.scalesMm = run.vesselness->scalesMm;
    context.c = run.vesselness->c;
  }
  if (run.evolve && run.evolve->thresholds.b > 0.0) context.b = run.evolve->thresholds.b;
  return context;
}

std::vector<ParameterStep> parameterSteps(const Parameters& params, const FieldContext& context,
                                          const std::vector<std::string>& keys, double size) {
  std::vector<const Field*> fields;
  for (const std::string& key : keys) {
    const Field& field = findField(key);
    if (!isNumber(field))
      throw InputError("this is no number that the segmentation of a scan depends on", key,
                       "name a numeric parameter of a step as far as evolve");
    fields.push_back(&field);
  }
  if (keys.empty())
    for (const Field& field : parameterFields())
      if (counts(field, params)) fields.push_back(&field);
  std::stable_sort(fields.begin(), fields.end(),
                   [](const Field* a, const Field* b) { return *a->ofScan > *b->ofScan; });
  std::vector<ParameterStep> steps;
  for (const Field* field : fields)
    for (const double way : {-size, size})
      if (auto step = stepOf(*field, params, context, way)) steps.push_back(std::move(*step));
  return steps;
}

Sensitivity sensitivityOf(Pipeline& pipeline, const Parameters& params,
                          const std::vector<ParameterStep>& steps, const Progress& progress,
                          const std::function<void(std::size_t)>& made) {
  RunOptions options;
  options.until = Step::Correct;
  const double share = 1.0 / (2.0 + static_cast<double>(steps.size()));
  Sensitivity result;
  result.segmentation = pipeline.run(params, options, progress.sub(0.0, share)).segmentation();
  const Volume<float>& phi = *result.segmentation->phi;
  result.places = wallPlaces(phi, progress.sub(share, 2.0 * share));
  result.spreadMm.assign(result.places.wall.points.size(), 0.0F);
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const double from = share * (2.0 + static_cast<double>(n));
    StepEffect effect{steps[n], {}, {}};
    try {
      const RunResult run =
          pipeline.run(steps[n].params, options, progress.sub(from, from + share));
      const Volume<float>& other = *run.segmentation()->phi;
      if (!(other.geometry == phi.geometry))
        throw InputError("the grid is another one", steps[n].key, "");
      effect.moves = wallMoves(result.places, phi, other);
      for (std::size_t v = 0; v < result.spreadMm.size(); ++v)
        result.spreadMm[v] = std::max(result.spreadMm[v], std::fabs(effect.moves.movedMm[v]));
    } catch (const Error& error) {
      effect.why = error.cause();
    }
    result.effects.push_back(std::move(effect));
    if (made) made(n);
  }
  return result;
}

}  // namespace angiomesh
